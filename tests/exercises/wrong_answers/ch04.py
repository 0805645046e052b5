"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 4."""

WRONG = {
    '4c': [
        ([('speed.value, volts.value', 'speed, volts')], 0, 'it is a parameter object, and not its value'),
        ([('speed.value', '100')], 2, 'it is `100`'),
        ([("Parameter('battery_volts', value=12.0)", '12.0')],
         1, "AttributeError: 'float' object has no attribute 'value'"),
        ([("Parameter('battery_volts', value=12.0)", "Parameter('battery_volts', value=12)")], 2, 'it is `12`'),
        ([('volts.value', '12.0')], 2, 'it is `12.0`'),
        ([('return speed.value, volts.value', 'return speed.value')], 0, 'it returns `100`'),
        ([('return speed.value, volts.value', 'return volts.value, speed.value')], 0, 'it is `12.0`'),
        ([("'max_speed_rpm'", "'max_speed'")], 0, 'ParameterNotDeclaredException: Invalid access to undeclared'),
        ([('    volts = ', "    robot.declare_parameter('battery_volts', 12.0)\n    volts = ")],
         0, 'ParameterAlreadyDeclaredException: Parameter(s) already'),
        ([("get_parameter_or('battery_volts', Parameter('battery_volts', value=12.0)",
           "get_parameter('battery_volts'")],
         1, 'ParameterNotDeclaredException: Invalid access to undeclared'),
    ],
    '4a': [
        ([("self.declare_parameter('max_speed_rpm', 100)", "self.declare_parameter('max_speed_rpm', 100)\n"
           "        self.copy = self.get_parameter('max_speed_rpm').value"),
          ("self.get_parameter('max_speed_rpm').value)", 'self.copy)')], 2, 'a copy that it made in its constructor'),
        ([("self.get_parameter('max_speed_rpm').value)", "self.get_parameter('max_speed_rpm'))")], 0,
         "'<' not supported between instances of 'Parameter' and 'int'"),
        ([("self.get_parameter('max_speed_rpm').value)", '100)')], 1, 'the default in the source'),
        ([('min(', 'max(')], 0, '`500` and `100`'),
    ],
    '4b': [
        ([("'photo.value': 100", "'photo.value': 150")], 4, 'the photograph is older'),
        ([('.value": 150', '.value": 100')], 4, 'A new photograph'),
        ([('12.0', 'None')], 4, 'so the fallback is used'),
        ([('False', 'True')], 4, 'declares nothing'),
        ([('120', '150')], 4, 'a parameter lives in one node'),
    ],
}

RIGHT = {
    '4c': [
        [('return speed.value, volts.value', 'return [speed.value, volts.value]')],
        [("Parameter('battery_volts', value", "Parameter('x', value")],
        [("    volts = robot.get_parameter_or('battery_volts', Parameter('battery_volts', "
          'value=12.0))\n'
          '    return speed.value, volts.value',
          "    volts = robot.get_parameter('battery_volts').value if "
          "robot.has_parameter('battery_volts') else 12.0\n"
          '    return speed.value, volts')],
    ],
}
