"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 1."""

WRONG = {
    '1a': [
        ([('client = ParameterClient(robot)\n', ''),
          ('robot.drive()\n', 'robot.drive()\nclient = ParameterClient(robot)\n')],
         0, "NameError: name 'client' is not defined, in the line"),
        ([('robot.drive()\n', ''),
          ('client = ParameterClient(robot)\n', 'client = ParameterClient(robot)\nrobot.drive()\n')],
         1, 'it is `100`, and becomes `50` only later'),
        ([("client.set_parameter('enable_safety_mode', True)\n", ''),
          ('robot.drive()\n', "robot.drive()\nclient.set_parameter('enable_safety_mode', True)\n")],
         2, 'it is `False`, and becomes `True` only later'),
        ([("client.set_parameter('enable_safety_mode', True)\n", '')], 2, 'it is `False`'),
        ([('50', '500')], 2, 'it is `100`'),
        ([('50', '0')], 2, 'it is waiting: max_speed_rpm is 0'),
        ([('robot.drive()\n', 'robot.drive()\nrobot.drive()\n')], 2, 'it drives off 2 times'),
        ([('robot.drive()\n', '')], 0, 'nothing has made it drive'),
        ([('robot.drive()\n', "robot.drive()\nclient.set_parameter('enable_safety_mode', False)\n")],
         2, 'it has run into the wall'),
        ([('robot.drive()\n', "robot.drive()\nclient.set_parameter('max_speed_rpm', 100)\n")],
         2, 'it becomes `100` during the drive'),
        ([('robot.drive()', 'robot.drive(')], 0, "SyntaxError: '(' was never closed (<your lines>, line 5)"),
    ],
    '1b': [
        ([("'max_speed_rpm': 95", "'max_speed_rpm': 95.0")], 0, 'wrong type'),
        ([("'min_operating_temperature_c': -10,", '')], 1, '-10 °C is below min_operating_temperature_c = -5'),
        ([("'max_speed_rpm': 95,", '')], 4, 'it gets up to 1.05 m/s'),
        ([("'sensor_offset_meters': -0.15", "'sensor_offset_meters': 0.3")], 4, 'it stops 0.05 m from the wall'),
        ([("'max_acceleration_mps2': 1.0,", '')], 4, 'it takes 5.51 s'),
        ([("'sensor_offset_meters': -0.15", "'sensor_offset_meters': 0.45")], 3, 'it has run into the wall'),
        ([("'min_operating_temperature_c': -10", "'simulation.ambient_temperature_c': 15")], 0,
         'a setting of the world around it'),
        ([("'max_speed_rpm'", "'max_speed'")], 0, 'undeclared'),
        ([("'max_speed_rpm': 95", "'max_speed_rpm': 0")], 1, 'it is waiting: max_speed_rpm is 0'),
        ([("'max_speed_rpm': 95", "'max_speed_rpm': 95, 5: 1")], 0, '`5` is not a string'),
        ([("'max_speed_rpm': 95", "'max_speed_rpm': 95, 'robot_name': {}")], 0, 'cannot be a parameter'),
    ],
    '1c': [
        ([("_min', 2.5)", "_min', 2)")], 0, 'type integer, value `2`'),
        ([("self.get_parameter('liters_per_min').value", '2.5')], 1, '`liters` is `25.0`'),
        ([("self.declare_parameter('liters_per_min', 2.5)", "self.rate = self.declare_parameter('liters_per_min', "
           '2.5).value'), ("self.get_parameter('liters_per_min').value", 'self.rate')], 2,
         '`liters` is `50.0`; before, it was 25'),
        ([("declare_parameter('liters_per_min'", "declare_parameter('liters_per_minute'")], 0, 'none of that name'),
        ([("('liters_per_min').value", "('liters_per_min')")], 0, 'TypeError'),
        ([("_min', 2.5)", "_min', 2.5, ignore_override=True)")], 2, 'it starts at `2.5`'),
        ([('value * minutes', 'value * minutes\n        self.declare_parameter("liters_per_min", 2.5)')], 0,
         'ParameterAlreadyDeclaredException'),
        ([('self.liters = 0.0', 'pass')], 0, "no attribute 'liters'"),
        ([("_min', 2.5)",
           "_min', 2.5, __import__('rcl_interfaces.msg').msg.ParameterDescriptor(dynamic_typing=True))")], 2,
         'it takes values of any type'),
        ([("self.declare_parameter('liters_per_min', 2.5)\n", "self.rate = self.declare_parameter('liters_per_min', "
           '2.5).value\n        self.add_on_set_parameters_callback(self.judge)\n'),
          ("self.get_parameter('liters_per_min').value * minutes", 'self.rate * minutes\n\n'
           '    def judge(self, parameters):\n        self.rate = parameters[0].value\n'
           "        return __import__('rcl_interfaces.msg').msg.SetParametersResult(successful=True)")], 2,
         'that value was rejected in the end'),
        ([('self.liters +=', '__import__("time").sleep(1000 * minutes)\n        self.liters +=')], 0,
         'it was still running after'),
    ],
}

RIGHT = {
    '1a': [
        [("client.set_parameter('max_speed_rpm', 50)\n", ''),
         ("client.set_parameter('enable_safety_mode', True)\n",
          "client.set_parameter('enable_safety_mode', True)\n"
          "client.set_parameter('max_speed_rpm', 50)\n")],
        [("client.set_parameter('max_speed_rpm', 50)\n"
          "client.set_parameter('enable_safety_mode', True)\n",
          "client.set_parameters({'max_speed_rpm': 50, 'enable_safety_mode': True})\n")],
        [('client = ParameterClient(robot)\n', "client = ParameterClient('/clawbot_node')\n")],
        [('ParameterClient(robot)', 'ParameterClient(robot.get_fully_qualified_name())')],
        [('client = ParameterClient(robot)\n'
          "client.set_parameter('max_speed_rpm', 50)\n"
          "client.set_parameter('enable_safety_mode', True)\n",
          "robot.set_parameters([Parameter('max_speed_rpm', value=50), "
          "Parameter('enable_safety_mode', value=True)])\n")],
        [('50', '40')],
        [('robot.drive()\n', 'robot.drive()\nrobot.step(60)\n')],
        [('client', '    client'), ('robot.drive()', '    robot.drive()')],
    ],
    '1b': [
        [("'max_acceleration_mps2': 1.0", "'max_acceleration_mps2': 2.0"), ("'max_speed_rpm': 95",
                                                                            "'max_speed_rpm': 80")],
        [("'min_operating_temperature_c': -10", "'min_operating_temperature_c': -20")],
        [("'sensor_offset_meters': -0.15", "'sensor_offset_meters': -0.145")],
        [("'max_speed_rpm': 95", "'max_speed_rpm': 95, 'robot_name': 'Parker', 'enable_safety_mode': True")],
    ],
    '1c': [
        [("        self.declare_parameter('liters_per_min', 2.5)\n        self.liters = 0.0\n",
          "        self.liters = 0\n        self.declare_parameters('', [('liters_per_min', 5 / 2)])\n")],
        [("self.get_parameter('liters_per_min').value", "self.get_parameters(['liters_per_min'])[0].value")],
        [("self.get_parameter('liters_per_min').value",
          "self.get_parameter('liters_per_min').get_parameter_value().double_value")],
        [("super().__init__('pump')", "Node.__init__(self, 'pump')")],
        [('self.liters = 0.0', 'self.runs = []'),
         ('self.liters += ', 'self.runs.append('), ('value * minutes', 'value * minutes)\n\n'
          '    liters = property(lambda self: sum(self.runs))')],
        [("self.declare_parameter('liters_per_min', 2.5)\n",
          "self.rate = self.declare_parameter('liters_per_min', 2.5).value\n"
          '        self.add_post_set_parameters_callback(self.changed)\n'),
         ("self.get_parameter('liters_per_min').value * minutes",
          'self.rate * minutes\n\n    def changed(self, parameters):\n        self.rate = parameters[-1].value')],
    ],
}
