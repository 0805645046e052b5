"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 4."""

# What stands in the solution of 4b, for the answers that replace it.
_DECLARED = "self.declare_parameter('max_speed_rpm', 100)\n"
_RETURN = "return min(wanted_rpm, self.get_parameter('max_speed_rpm').value)"
_COPIED = (_RETURN, 'return min(wanted_rpm, self.rpm)')

WRONG = {
    '4a': [
        ([('speed.value, volts.value', 'speed, volts')], 0, 'it is a parameter object, and not its value'),
        ([("Parameter('battery_volts', value=12.0)", "Parameter('battery_volts', value=12)")], 3, 'it is `12`'),
        ([('volts.value', '12.0')], 3, 'it is `12.0`'),
        ([('    volts = ', "    if not robot.has_parameter('battery_volts'):\n"
           "        robot.declare_parameter('battery_volts', 12.0)\n    volts = ")],
         3, 'your function has declared `battery_volts`'),
        ([('speed.value', '100')], 3, 'it is `100`'),
        ([("Parameter('battery_volts', value=12.0)", '12.0')],
         0, "AttributeError: 'float' object has no attribute 'value'"),
        ([('return speed.value, volts.value', 'return speed.value')], 0, 'it returns `100`'),
        ([("'max_speed_rpm'", "'max_speed'")], 0, 'ParameterNotDeclaredException: Invalid access to undeclared'),
        ([('    volts = ', "    robot.declare_parameter('battery_volts', 12.0)\n    volts = ")],
         0, 'ParameterAlreadyDeclaredException: Parameter(s) already'),
        ([('    volts = ', "    robot.set_parameters([Parameter('max_speed_rpm', value=70)])\n    volts = ")],
         2, 'your function has changed `max_speed_rpm`'),
        ([("get_parameter_or('battery_volts', Parameter('battery_volts', value=12.0)",
           "get_parameter('battery_volts'")],
         0, 'ParameterNotDeclaredException: Invalid access to undeclared'),
        ([('speed.value', 'str(speed.value)')], 3, "it is the string `'100'`"),
        ([('return speed.value, volts.value', 'print(speed.value, volts.value)')], 0, 'it returns `None`'),
        ([('return speed.value, volts.value', "return {'speed': speed.value, 'volts': volts.value}")],
         0, 'it returns `{'),
    ],
    '4b': [
        ([("'max_speed_rpm', 100)", "'max_speed_rpm', 100.0)")], 0, 'type double, value `100.0`'),
        ([(_DECLARED, f"{_DECLARED}        self.rpm = self.get_parameter('max_speed_rpm').value\n"), _COPIED], 3,
         'a copy that it made earlier'),
        ([(_DECLARED, f"{_DECLARED}        self.rpm = self.get_parameter('max_speed_rpm').value\n"  # acts too early
                      '        self.add_on_set_parameters_callback(self.keep)\n\n'
                      '    def keep(self, parameters):\n'
                      '        from rcl_interfaces.msg import SetParametersResult\n'
                      '        self.rpm = parameters[0].value\n'
                      '        return SetParametersResult(successful=True)\n'), _COPIED], 3,
         'rejected in the end'),
        ([("self.get_parameter('max_speed_rpm').value)", '100)')], 2, 'the default in the source'),
        ([(_DECLARED, 'self.max_speed_rpm = 100\n'),
          (_RETURN, 'return min(wanted_rpm, self.max_speed_rpm)')], 0, 'the node has none of that name'),
        ([(_DECLARED, f'{_DECLARED}        Wheel.rpm = 100\n'  # shared by all wheels
                      '        self.add_post_set_parameters_callback(self.keep)\n\n'
                      '    def keep(self, parameters):\n'
                      '        Wheel.rpm = parameters[0].value\n'), _COPIED], 2, 'the parameter of another wheel'),
        ([("self.get_parameter('max_speed_rpm').value)", "self.get_parameter('max_speed_rpm'))")], 0,
         "'<' not supported between instances of 'Parameter' and 'int'"),
        ([('min(', 'max(')], 0, 'it is `500`'),
        ([(_RETURN, "return str(min(wanted_rpm, self.get_parameter('max_speed_rpm').value))")], 0,
         "it is the string `'100'`"),
        ([(_RETURN, "return min(wanted_rpm, self.get_parameter('max_speed_rpm').value or 100)")], 3, 'it is `100`'),
    ],
    '4c': [
        ([("'photo.value': 100", "'photo.value': 150")], 4, 'the photograph is older'),
        ([('.value": 150', '.value": 100')], 4, 'a new photograph'),
        ([('12.0', 'None')], 4, 'so the fallback is used'),
        ([('False', 'True')], 4, 'declares nothing'),
        ([('120', '150')], 4, 'each node has its own parameters'),
        ([('12.0', '12')], 4, 'The fallback holds a double'),
        ([('120', '100')], 4, 'started with an override'),
    ],
}

RIGHT = {
    '4a': [
        [('return speed.value, volts.value', 'return [speed.value, volts.value]')],
        [("Parameter('battery_volts', value", "Parameter('x', value")],
        [("    volts = robot.get_parameter_or('battery_volts', Parameter('battery_volts', "
          'value=12.0))\n'
          '    return speed.value, volts.value',
          "    volts = robot.get_parameter('battery_volts').value if "
          "robot.has_parameter('battery_volts') else 12.0\n"
          '    return speed.value, volts')],
        [('value=12.0)', 'Parameter.Type.DOUBLE, 12.0)')],
        [('return speed.value, volts.value',
          'return tuple(each.get_parameter_value().integer_value or each.value for each in (speed, volts))')],
    ],
    '4b': [
        [("super().__init__('wheel')", "Node.__init__(self, 'wheel')")],
        [(_RETURN, "limit = self.get_parameter('max_speed_rpm').get_parameter_value().integer_value\n"
                   '        return limit if wanted_rpm > limit else wanted_rpm')],
        [(_RETURN, "limit, = self.get_parameters(['max_speed_rpm'])\n"
                   '        return sorted([wanted_rpm, limit.value])[0]')],
        [(_DECLARED, f"{_DECLARED}        self.rpm = self.get_parameter('max_speed_rpm').value\n"
                     '        self.add_post_set_parameters_callback(self.keep)\n\n'
                     '    def keep(self, parameters):\n'
                     "        self.rpm = self.get_parameter('max_speed_rpm').value\n"), _COPIED],
        [(_DECLARED, f"{_DECLARED}\n    @property\n    def rpm(self):\n"
                     "        return self.get_parameter('max_speed_rpm').value\n"), _COPIED],
    ],
}
