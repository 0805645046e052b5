"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 9.1."""

WRONG = {
    '9.1a': [
        ([("'max_speed_mps'", "'~max_speed_mps'")], 2, 'there is `~max_speed_mps`, as ROS 1 writes it'),
        ([("'gains.kp', 2.0", "'gains/kp', 2.0")], 1, 'there is `gains/kp`, as ROS 1 writes it'),
        ([("self.get_parameter('gains.kp').value", '2.0')], 2, 'it is `1.0`'),
        ([("'gains.kp', 2.0", "'gains.kp', 2")], 1, 'type integer, value `2`'),
        ([("self.get_parameter('gains.kp').value", "self.get_parameter('gains.kp')")],
         2, "TypeError: unsupported operand type(s) for *: 'Parameter'"),
        ([("'max_speed_mps', 0.5", "'max_speed', 0.5")], 2, 'the node has none of that name'),
        ([("'drive'", "'driver'")], 3, 'it is called `driver`'),
        ([("'gains.kp', 2.0", "'gains.kp', '2.0'")], 1, 'type string'),
        ([('return ', 'print('), (' * error', ' * error)')], 2, 'it is `None`'),
        ([("'gains.kp', 2.0", "'~gains/kp', 2.0")], 1, 'there is `~gains/kp`, as ROS 1 writes it'),
        ([("'gains.kp', 2.0", "'gains.kp', ...")], 0, 'a `...` is still there'),
    ],
    '9.1b': [
        ([("'limit_c', 60.0", "'limit_c', 60")], 1, 'type integer, value `60`'),
        ([("'targets_c.right', 21.0", "'targets_c.right', 21")], 1, 'type integer, value `21`'),
        ([("        self.unit = self.get_parameter('unit').value\n", "        self.unit = 'C'\n")], 2, "it is `'C'`"),
        ([('        self.add_post_set_parameters_callback(self.react)\n', '')], 3, 'it is `60.0`'),
        ([("'targets_c.", "'targets_c/")], 2, 'the node has none of that name'),
        # By an event, which comes later.
        ([('        self.add_post_set_parameters_callback(self.react)\n',
           '        from rclpy.parameter_event_handler import ParameterEventHandler\n'
           '        self.handler = ParameterEventHandler(self)\n'
           "        self.kept = self.handler.add_parameter_callback('limit_c', self.get_fully_qualified_name(), "
           'self.react)\n')], 3, 'in the call that stores it, and follows later'),
        ([("        self.declare_parameter('unit', 'C')\n", ''),
          ("self.get_parameter('unit').value", "self.get_parameter_or('unit', Parameter('unit', value='C')).value"),
          ('class Heater', 'from rclpy.parameter import Parameter\n\n\nclass Heater')],
         1, 'the node has none of that name'),
        ([('name: parameter.value for', 'name: parameter for')], 2, '`Parameter` objects and not their values'),
        ([("self.limit_c = self.get_parameter('limit_c').value", "self.limit_c = self.get_parameter('limit_c')")],
         1, 'a `Parameter` and not its value'),
        ([('        self.add_post_set_parameters_callback(self.react)\n',
           '        self.add_on_set_parameters_callback(self.judge)\n'),
          ('    def targets', '    def judge(self, parameters):\n'
           '        for parameter in parameters:\n'
           '            setattr(self, parameter.name, parameter.value)\n'
           '        from rcl_interfaces.msg import SetParametersResult\n'
           '        return SetParametersResult(successful=True)\n\n    def targets')],
         3, 'a side effect of an on-set callback'),
        ([("        self.unit = self.get_parameter('unit').value\n",
           "        self.unit = getattr(self, 'unit', self.get_parameter('unit').value)\n")], 3, "it is `'C'`"),
        ([('return {name: parameter.value for name, parameter in '
           "self.get_parameters_by_prefix('targets_c').items()}", "return {'left': 20.5, 'right': 21.0}")],
         2, "it returns `{'left': 20.5, 'right': 21.0}`"),
        ([('        self.react([])\n', '')], 1, 'it is `None`'),
        ([("'heater'", "'Heater'")], 2, 'it is called `Heater`'),
        ([('{name: parameter', "{f'targets_c.{name}': parameter")], 2, "it returns `{'targets_c.left': 20.5"),
    ],
    '9.1c': [
        ([('max_speed_mps: 1.0', 'max_speed_mps: 1')], 2, 'a double with its dot'),
        ([('gains: {kd: 0.1, kp: 2.0}', 'gains/kd: 0.1\n    gains/kp: 2.0')], 4, 'it is `1.0`'),
        ([("'1e5'", '1e5')], 2, 'a string that looks like a number in quotes'),
        ([('/**:', '/drive:')], 4, 'the key `/**` gives it to each node'),
        ([('kp: 2.0', 'kp: 2')], 2, "'gains.kp' to '2' of type 'INTEGER'"),
        ([('[10.0, 12.5]', '[10, 12.5]')], 0, 'must all be of one type'),
        ([('  ros__parameters:\n', '')], 0, 'there is a value before ros__parameters'),
        ([('/camera:', '/kamera:')], 3, "it is `'none'`"),
        ([('/drive:', '/robot/drive:')], 3, 'it is `0.5`'),
    ],
}

RIGHT = {
    '9.1a': [
        [("self.get_parameter('gains.kp').value * error", "error * self.get_parameter('gains.kp').value")],
        [("        self.declare_parameter('max_speed_mps', 0.5)\n"
          "        self.declare_parameter('gains.kp', 2.0)\n",
          "        self.declare_parameters('', [('gains.kp', 2.0), ('max_speed_mps', 0.5)])\n")],
        [("self.get_parameter('gains.kp').value", "self.get_parameters_by_prefix('gains')['kp'].value")],
        [("self.get_parameter('gains.kp').value", "self.get_parameter('gains.kp').get_parameter_value().double_value")],
    ],
    '9.1b': [
        [("        self.declare_parameter('targets_c.left', 20.5)\n"
          "        self.declare_parameter('targets_c.right', 21.0)\n",
          "        self.declare_parameters('targets_c', [('right', 21.0), ('left', 20.5)])\n")],
        [('        self.add_post_set_parameters_callback(self.react)\n        self.react([])\n\n'
          '    def react(self, parameters):\n', '\n    limit_c = property(lambda self: self.get_parameter'
          "('limit_c').value)\n    unit = property(lambda self: self.get_parameter('unit').value)\n\n"
          '    def unused(self):\n'),
         ("        self.limit_c = self.get_parameter('limit_c').value\n"
          "        self.unit = self.get_parameter('unit').value\n", '        pass\n')],
        [("        self.limit_c = self.get_parameter('limit_c').value\n"
          "        self.unit = self.get_parameter('unit').value\n",
          "        for name in ('unit', 'limit_c'):\n"
          '            setattr(self, name, self.get_parameter(name).value)\n')],
        [("{name: parameter.value for name, parameter in self.get_parameters_by_prefix('targets_c').items()}",
          "{side: self.get_parameter(f'targets_c.{side}').value for side in ('right', 'left')}")],
        [('        self.add_post_set_parameters_callback(self.react)\n        self.react([])\n\n'
          '    def react(self, parameters):\n'
          "        self.limit_c = self.get_parameter('limit_c').value\n"
          "        self.unit = self.get_parameter('unit').value\n",
          "\n    def __getattr__(self, name):\n        if name not in ('limit_c', 'unit'):\n"
          '            raise AttributeError(name)\n        return self.get_parameter(name).value\n')],
    ],
    '9.1c': [
        [('/**:\n  ros__parameters:\n    base_frame: base_link\n', ''),
         ("    label: '1e5'", "    base_frame: base_link\n    label: '1e5'"),
         ('    max_speed_mps: 1.0', '    base_frame: base_link\n    max_speed_mps: 1.0')],
        [('gains: {kd: 0.1, kp: 2.0}', 'gains.kd: 0.1\n    gains.kp: 2.0')],
        [("'1e5'", '"1e5"'), ('/camera:', 'camera:'), ('1.0\n', '1.\n')],
        [('/drive:\n  ros__parameters:',
          '/drive: {ros__parameters: {max_speed_mps: 1.0e+0, gains: {kp: 2.0, kd: 0.1}}}'),
         ('    gains: {kd: 0.1, kp: 2.0}\n    max_speed_mps: 1.0\n', '')],
        [("label: '1e5'", 'label: !!str 1e5')],
        [('/**:', '/*:')],
    ],
}
