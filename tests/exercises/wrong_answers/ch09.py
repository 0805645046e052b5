"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 9."""

_REGISTER = '        self.act([])\n        self.add_post_set_parameters_callback(self.act)\n'
_READ = ("        self.force_n = self.get_parameter('force_n').value\n"
         "        self.frame = self.get_parameter('base_frame').value\n")

WRONG = {
    '9a': [
        ([("'force_n', 10.0", "'force_n', 10")], 0, 'type integer'),
        ([("self.declare_parameters('gains', [('kp', 1.0), ('kd', 0.2)])",
           "self.declare_parameters('', [('gains/kp', 1.0), ('gains/kd', 0.2)])")], 0, 'as ROS 1 writes it'),
        ([("'base_frame', 'base'", "'/base_frame', 'base'"), ("get_parameter('base_frame')",
           "get_parameter('/base_frame')")], 0, 'as ROS 1 writes it'),
        ([("super().__init__('gripper')", "super().__init__('Gripper')")], 3, 'it is called `Gripper`'),
        ([(_REGISTER, '        self.add_post_set_parameters_callback(self.act)\n')], 1, 'it is `None`'),
        ([(_REGISTER, '        self.act([])\n')], 2, 'it is `10.0`'),
        ([(_REGISTER, '        self.act([])\n        self.add_on_set_parameters_callback(self.judge)\n'),
          ('    def act(self, parameters):\n' + _READ, '    def judge(self, parameters):\n'
           '        from rcl_interfaces.msg import SetParametersResult\n'
           '        self.act(parameters)\n        return SetParametersResult(successful=True)\n\n'
           '    def act(self, parameters):\n' + _READ
           + '        for each in parameters:\n'
           "            name = {'force_n': 'force_n', 'base_frame': 'frame'}[each.name]\n"
           '            setattr(self, name, each.value)\n')], 2, 'a side effect of an on-set callback'),
        ([(_READ, _READ.replace("        self.frame = self.get_parameter('base_frame').value\n",
                                "        self.frame = 'base'\n"))], 1, "it is `'base'`"),
        ([(_READ, _READ.replace("'base_frame').value", "'base_frame')"))], 1, 'a `Parameter` and not its value'),
    ],
    '9b': [
        ([('kp: 2.0', 'kp: 2')], 0, "'gains.kp' to '2' of type 'INTEGER'"),
        ([('/**/gripper:', '/gripper:')], 2, 'it is `10.0`'),
        ([('/**/gripper:', 'gripper:')], 2, 'it is `10.0`'),
        ([('  ros__parameters:\n    base_frame', '    base_frame')], 0, 'Cannot have a value before ros__parameters'),
        ([('    base_frame: base_link\n    force_n', '    force_n')], 1, "it is `'base'`"),
        ([('gains: {kp: 2.0, kd: 0.1}', 'gains/kp: 2.0\n    gains/kd: 0.1')], 1, 'it is `1.0`'),
        ([(", 'config/gripper.yaml'", '')], 2, 'no entry of `data_files` has `config/gripper.yaml`'),
        ([(", 'config/gripper.yaml'", ''), ('\nsetup(', "\n# 'config/gripper.yaml'\nsetup(")], 2,
         'no entry of `data_files`'),
        ([("'gripper_node = my_robot.gripper_node:main'", "'gripper_node = my_robot.gripper_node.main'")], 2,
         'there is no such line'),
    ],
    '9c': [
        ([("'speed', 0.5", "'speed', 1")], 0, 'type integer'),
        ([('from_value=0.0, to_value=1.0', 'from_value=0, to_value=1')], 3,
         'it is `0`. A float has a dot'),
        ([('        self.react([])\n', '')], 2, 'it is `None`'),
        ([('        self.add_post_set_parameters_callback(self.react)\n', '')], 3, 'it is `1500.0`'),
        ([("'boost', False", "'boost', 'False'")], 1, 'type string'),
        ([('floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]', '')], 3, 'it was accepted'),
        ([("description='A fraction of full speed, 3000 rpm.',", '')], 3, 'it has no description'),
        ([('Doubles the speed for a moment.', 'boost')], 3, 'its description is `boost`'),
        ([('        self.react([])\n', '        self.motor_rpm = 1500.0\n')], 2, 'it is `1500.0`'),
        ([('        self.add_post_set', "        self.declare_parameter('motor_rpm', 0.0)\n        self.add_post_set")],
         1, 'there is also `motor_rpm`'),
    ],
}

RIGHT = {
    '9a': [
        [("self.declare_parameters('gains', [('kp', 1.0), ('kd', 0.2)])",
          "self.declare_parameters('', [('gains.kp', 1.0), ('gains.kd', 0.2)])")],
        [(_REGISTER, ''), ('    def act(self, parameters):\n' + _READ,
          "    force_n = property(lambda self: self.get_parameter('force_n').value)\n"
          "    frame = property(lambda self: self.get_parameter('base_frame').value)\n")],
    ],
    '9b': [
        [('/**/gripper:', '/**:')],
        [('gains: {kp: 2.0, kd: 0.1}', 'gains.kp: 2.0\n    gains.kd: 0.1')],
    ],
    '9c': [
        [('        self.add_post_set_parameters_callback(self.react)\n        self.react([])\n', ''),
         ('    def react(self, parameters):\n', '    @property\n    def motor_rpm(self):\n'),
         ('self.motor_rpm = 3000', 'return 3000')],
        [('        self.add_post_set_parameters_callback(self.react)\n', ''),
         ("super().__init__('fan')\n", "super().__init__('fan')\n"
          '        self.add_post_set_parameters_callback(self.react)\n'),
         ("        factor = 2 if self.get_parameter('boost').value else 1\n",
          "        if not self.has_parameter('boost'):\n            return\n"
          "        factor = 1 + self.get_parameter('boost').value\n"),
         ("self.get_parameter('speed').value", "self.get_parameter('speed').get_parameter_value().double_value")],
        [('moment.', 'moment')],
        [("3000 * self.get_parameter('speed').value * factor", "self.get_parameter('speed').value * 3e3 * factor")],
    ],
}
