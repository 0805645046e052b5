"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 1."""

WRONG = {
    '1a': [
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 2")], 0, 'wrong type'),
        ([("'max_speed_mps': 2.0,", '')], 2, 'it gets up to 0.50 m/s'),
        ([("'stop_distance_m': 2.5,", '')], 2, 'it hits the wall at'),
        ([('2.5', '4.5')], 3, 'it stops 2.30 m from the wall'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 0.0")], 1, 'it stays at the start'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 3.0")], 0, 'out of range'),
        ([("'max_speed_mps'", "'max_speed'")], 0, 'undeclared'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 2.0, 'command_rate_hz': 50.0")], 0, 'read only'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': 2.0, 5: 1")], 0, '`5` is not a string'),
        ([("'max_speed_mps': 2.0", "'max_speed_mps': {}")], 0, 'cannot be a parameter'),
    ],
    '1b': [
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
    ],    '1c': [
        ([("'max_speed_mps', 0.8", "'max_speed_mps', 0.5")], 0, 'type double, value `0.5`'),
        ([("'max_speed_mps', 0.8", "'max_speed_mps', '0.8'")], 0, 'type string'),
        ([("'max_speed_mps', 0.8", "'max_speed', 0.8")], 0, 'none of that name'),
        ([("'max_speed_mps', 0.8)", "'max_speed_mps', 0.8, ignore_override=True)")], 1, 'it is 0.8'),
        ([("self.get_parameter('max_speed_mps').value", '0.8')], 1, 'it is 0.8'),
        ([("('max_speed_mps', 0.8)", "('max_speed_mps', 0.8")], 0, 'SyntaxError'),
        ([("'stop_distance_m', 0.5", "'stop_distance_m', 0.1")], 1, 'it is 1.5'),
    ],
}

RIGHT = {
    '1a': [
        [('2.5', '2.3')],
        [('2.5', '3.1')],
        [("'max_speed_mps': 2.0,\n    'stop_distance_m': 2.5,", "'stop_distance_m': 2.5, 'max_speed_mps': 4 / 2")],
    ],
    '1b': [
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
    '1c': [
        [("'max_speed_mps', 0.8", "'max_speed_mps', .8")],
        [("'stop_distance_m', 0.5", "'stop_distance_m', 1.0")],
        [("self.declare_parameter('max_speed_mps', 0.8)", "self.declare_parameters('', [('max_speed_mps', 0.8)])")],
    ],
}
