"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 9."""

WRONG = {
    '9c': [
        ([("'max_speed_mps'", "'~max_speed_mps'")], 2, 'there is `~max_speed_mps`, as ROS 1 writes it'),
        ([("'gains.kp', 2.0", "'gains/kp', 2.0")], 1, 'there is `gains/kp`, as ROS 1 writes it'),
        ([("'gains.kp', 2.0", "'gains.kp', 2")], 1, 'type integer, value `2`'),
        ([("self.get_parameter('gains.kp').value", '2.0')], 2, 'it is `0.2`'),
        ([("self.get_parameter('gains.kp').value", "self.get_parameter('gains.kp')")],
         2, "TypeError: unsupported operand type(s) for *: 'Parameter'"),
        ([("'max_speed_mps', 0.5", "'max_speed', 0.5")], 2, 'the node has none of that name'),
        ([("'drive'", "'driver'")], 3, 'it is called `driver`'),
        ([("        self.declare_parameter('gains.kp', 2.0)\n",
           "        self.declare_parameter('gains.kp', 2.0)\n"
           "        self.kp = self.get_parameter('gains.kp').value\n"),
          ("self.get_parameter('gains.kp').value *", 'self.kp *')], 2, 'it is `0.2`'),
        ([("self.get_parameter('gains.kp').value", "self.get_parameter('max_speed_mps').value")],
         2, 'it is `0.05`'),
    ],
    '9a': [
        ([('max_speed_mps: 1.0', 'max_speed_mps: 1')], 2, 'a double with its dot'),
        ([('kp: 2.0', 'kp: 2')], 2, "'gains.kp' to '2' of type 'INTEGER'"),
        ([("'1e5'", '1e5')], 2, 'a text that looks like a number in quotes'),
        ([('[10.0, 12.5]', '[10, 12.5]')], 0, 'must all be of one type'),
        ([('/**:', '/drive:')], 4, 'the key `/**` gives it to each node'),
        ([('  ros__parameters:\n', '')], 0, 'there is a value before ros__parameters'),
        ([('/camera:', '/kamera:')], 3, "it is `'none'`"),
    ],
    '9b': [
        ([("1': 0.5", "1': 1")], 5, 'ROS 1 would have stored it'),
        ([("2.0': None", "2.0': 2.0")], 5, 'a slash is not a dot'),
        ([("900': 100", "900': 300")], 5, 'would have bent it'),
        ([(': 3000000000', ': 0')], 5, 'ended at 32 bits'),
        ([("'green'\": None", "'green'\": 'green'")], 5, 'a stranger cannot'),
        ([("restarted': 100", "restarted': 200")], 5, 'no server'),
    ],
}

RIGHT = {
    '9c': [
        [("self.get_parameter('gains.kp').value * error", "error * self.get_parameter('gains.kp').value")],
        [("        self.declare_parameter('max_speed_mps', 0.5)\n"
          "        self.declare_parameter('gains.kp', 2.0)\n",
          "        self.declare_parameters('', [('gains.kp', 2.0), ('max_speed_mps', 0.5)])\n")],
        [("self.get_parameter('gains.kp').value", "self.get_parameters_by_prefix('gains')['kp'].value")],
    ],
}
