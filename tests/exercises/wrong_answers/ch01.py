"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 1."""

WRONG = {
    '1c': [
        ([('robot.drive()\n', ''),
          ('client = ParameterClient(robot)\n', 'client = ParameterClient(robot)\nrobot.drive()\n')],
         1, 'it is `100`, and becomes what you want only later'),
        ([('client = ParameterClient(robot)\n', ''),
          ('robot.drive()\n', 'robot.drive()\nclient = ParameterClient(robot)\n')],
         0, "NameError: name 'client' is not defined, in the line"),
        ([("client.set_parameter('max_speed_rpm', 50)\n", ''),
          ('robot.drive()\n', "robot.drive()\nclient.set_parameter('max_speed_rpm', 50)\n")],
         2, 'it is `100`, and becomes what you want only later'),
        ([("client.set_parameter('enable_safety_mode', True)\n", ''),
          ('robot.drive()\n', "robot.drive()\nclient.set_parameter('enable_safety_mode', True)\n")],
         2, 'it is `False`, and becomes what you want only later'),
        ([("client.set_parameter('enable_safety_mode', True)\n", '')], 2, 'it is `False`'),
        ([('50', '500')], 2, 'it is `100`'),
        ([('robot.drive()\n', 'robot.drive()\nrobot.drive()\n')], 2, 'it drives off 2 times'),
        ([('robot.drive()\n', '')], 0, 'nothing has made it drive'),
        ([("'max_speed_rpm'", "'max_speed'")], 2, 'it is `100`'),
        ([('robot.drive()', 'robot.drive(')], 0, "SyntaxError: '(' was never closed (<your lines>, line 5)"),
    ],
    '1a': [
        ([("'max_speed_rpm': 95", "'max_speed_rpm': 95.0")], 3, 'wrong type'),
        ([("'max_speed_rpm': 95,", '')], 4, 'it gets up to 1.05 m/s'),
        ([("'max_acceleration_mps2': 1.0,", '')], 4, 'it takes 5.51 s'),
        ([("'sensor_offset_meters': -0.15", "'sensor_offset_meters': 0.3")], 4, 'it stops 0.05 m from the wall'),
        ([("'sensor_offset_meters': -0.15", "'sensor_offset_meters': 0.45")], 3, 'it has run into the wall'),
        ([("'min_operating_temperature_c': -10,", '')], 1, '-10 °C is below min_operating_temperature_c = -5'),
        ([("'min_operating_temperature_c': -10", "'simulation.ambient_temperature_c': 15")], 0,
         'a setting of the world around it'),
        ([("'max_speed_rpm'", "'max_speed'")], 3, 'undeclared'),
    ],
    '1b': [
        ([("_min', 2.5)", "_min', 2)")], 0, 'type integer, value `2`'),
        ([("self.declare_parameter('litres_per_min', 2.5)", "self.rate = self.declare_parameter('litres_per_min', "
           '2.5).value'), ("self.get_parameter('litres_per_min').value", 'self.rate')], 2, 'it has asked too early'),
        ([("self.get_parameter('litres_per_min').value", '2.5')], 1, 'the parameter says otherwise'),
        ([('+=', '=')], 2, '`litres` is `10.0`'),
        ([("declare_parameter('litres_per_min'", "declare_parameter('litres_per_minute'")], 0, 'none of that name'),
        ([("('litres_per_min').value", "('litres_per_min')")], 1, 'TypeError'),
    ],
}

RIGHT = {
    '1c': [
        [("client.set_parameter('max_speed_rpm', 50)\n", ''),
         ("client.set_parameter('enable_safety_mode', True)\n",
          "client.set_parameter('enable_safety_mode', True)\n"
          "client.set_parameter('max_speed_rpm', 50)\n")],
        [("client.set_parameter('max_speed_rpm', 50)\n"
          "client.set_parameter('enable_safety_mode', True)\n",
          "client.set_parameters({'max_speed_rpm': 50, 'enable_safety_mode': True})\n")],
        [('client = ParameterClient(robot)\n', "client = ParameterClient('/clawbot_node')\n")],
        [('client = ParameterClient(robot)\n'
          "client.set_parameter('max_speed_rpm', 50)\n"
          "client.set_parameter('enable_safety_mode', True)\n",
          "robot.set_parameters([Parameter('max_speed_rpm', value=50), "
          "Parameter('enable_safety_mode', value=True)])\n")],
    ],
}
