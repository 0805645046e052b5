"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 9.2."""

WRONG = {
    '9.2a': [
        ([('add_pre_set', 'add_on_set')], 0, 'out of range'),
        ([("parameter.name == 'speed_rpm'", "parameter.name != 'speed'")], 2, 'it is `300`'),
        ([(' and parameter.type_ == Parameter.Type.INTEGER', ''),
          ('max(parameter.value', 'max(int(float(parameter.value))')], 2, 'ValueError'),
        ([('parameter.value, 20), 300', 'parameter.value, 20), 30')], 0, 'it is `30`'),
        ([("'mixer'", "'blender'")], 3, 'it is called `blender`'),
        ([('add_callback = self.add_pre_set_parameters_callback', 'add_callback = ...')], 0, 'a `...` is still there'),
        ([('        clamped = []\n', ''), ('clamped', 'self.clamped'),
          ("'minutes', 5)\n", "'minutes', 5)\n        self.clamped = []\n")], 2, 'come back with the next one?'),
        ([(', ParameterDescriptor(\n            integer_range=[IntegerRange(from_value=20, to_value=300)])', '')],
         0, 'no panel can know'),
    ],
    '9.2b': [
        ([("1': 0.5", "1': 1")], 5, 'ROS 1 would have stored it'),
        ([("2.0': None", "2.0': 2.0")], 5, 'a slash is not a dot'),
        ([("900': 100", "900': 300")], 5, 'would have clamped it'),
        ([(': 3000000000', ': 0')], 5, 'ends at 32 bits'),
        ([("'green'\": None", "'green'\": 'green'")], 5, 'a stranger cannot'),
        ([("restarted': 100", "restarted': 200")], 5, 'no server'),
        ([("1': 0.5", "1': 1.0")], 5, 'does not say `1.0`'),
        ([("'green'\": None", "'green'\": 'None'")], 5, "does not say `'None'`"),
    ],
    '9.2c': [
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
    '9.2a': [
        [('self.add_pre_set_parameters_callback', 'super().add_pre_set_parameters_callback')],
        [("parameter.name == 'speed_rpm'", "parameter.name.startswith('speed')")],
        [('min(max(parameter.value, 20), 300)', 'sorted((20, parameter.value, 300))[1]')],
    ],
    '9.2b': [
        [("900': 100", "900': 100 + 0")],
        [("restarted': 100", "restarted': int('100')")],
        [(': 3000000000', ': 3 * 10**9')],
    ],
    '9.2c': [
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
