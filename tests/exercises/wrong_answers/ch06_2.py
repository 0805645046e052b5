"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 6.2."""

_RATE = "        self.create_timer(1 / self.get_parameter('rate_hz').value, self.drive)\n"
_DECLARE_RATE = ("        self.declare_parameter('rate_hz', 10, ParameterDescriptor(\n"
                 "            description='How often the driver sends a command, in Hz.', read_only=True,\n"
                 '            integer_range=[IntegerRange(from_value=5, to_value=50)]))\n')
_SET_IF_UNSET = ("        stops = self.declare_parameter('stops_m', Parameter.Type.DOUBLE_ARRAY)\n"
                 "        if stops.value is None:\n"
                 "            self.set_parameters([Parameter('stops_m', Parameter.Type.DOUBLE_ARRAY, [])])")
_SET = "        self.set_parameters([Parameter('stops_m', Parameter.Type.DOUBLE_ARRAY, [])])"
_READ_ONLY = ("'H-01', ParameterDescriptor(read_only=True)", "'H-01'")

WRONG = {
    '6.2a': [
        ([(' read_only=True,', '')], 3, '`read_only` is not set'),
        # The timer has the rate of before, or the rate is taken for its period.
        ([(_RATE, '        self.create_timer(0.1, self.drive)\n')], 2, 'its timer has one of 100 ms'),
        ([('1 / self.get_parameter', 'self.get_parameter')], 2, 'its timer has one of 10000 ms'),
        ([(_RATE, '')], 2, 'it has no timer'),
        ([("'rate_hz', 10,", "'rate_hz', 10.0,")], 0, 'type double'),
        ([("'rate_hz', 10,", "'rate_hz', 20,")], 3, 'type integer, value `20`'),
        ([('from_value=5, to', 'from_value=1, to')], 3, 'its `from_value` is 1'),
        ([('            integer_range=[IntegerRange(from_value=5, to_value=50)]))', '            ))')], 3,
         'it has none for its type'),
        ([("description='How often the driver sends a command, in Hz.', ", '')], 3, 'it is empty'),
        ([('to_value=50)]))', 'to_value=50)]), ignore_override=True)')], 1, 'it is `10`'),
        ([(_DECLARE_RATE, ''), (_RATE, _RATE + _DECLARE_RATE)], 0, 'ParameterNotDeclaredException'),
        # Something else has gone on the way.
        ([('        self.add_on_set_parameters_callback(self.judge)\n', '')], 3, 'it was accepted'),
        ([('            raise ValueError(start.reason)', '            pass')], 3, 'the node started'),
        ([('self.distance_m > stop_distance_m', 'self.distance_m > 0.1')], 3, 'it is 0.75'),
    ],
    '6.2b': [
        ([('read_only=True', "description='Never changes.'")], 2, 'A description enforces nothing'),
        ([("'label', 'north'", "'label', 'north', ParameterDescriptor(dynamic_typing=True)")], 2,
         'Its type may change'),
        ([("'stops_m', Parameter.Type.DOUBLE_ARRAY)\n", "'stops_m', [])\n")], 2, 'type byte array, value `[]`'),
        # Read-only, and deaf to the start.
        ([('(read_only=True)', '(read_only=True), ignore_override=True')], 2, "it is `'H-01'`"),
        # Judged by a callback that comes too late to be in read-only's place in the order.
        ([_READ_ONLY, ('class', 'from rcl_interfaces.msg import SetParametersResult\n\nclass'), ('        stops = ',
          "        self.add_on_set_parameters_callback(lambda parameters: "
          "SetParametersResult(successful=all(each.name != 'serial' for each in parameters)))\n        stops = ")],
         2, 'rejected by the node'),
        ([("'H-01'", "'H-1'")], 2, "value `'H-1'`"),
        ([("'label', 'north'", "'label', 'north', ParameterDescriptor(read_only=True)")], 2, '(read only)'),
        ([("'label', 'north'", "'label', 'south'")], 2, "value `'south'`"),
        ([("'label', 'north'", "'label', Parameter.Type.STRING")], 2, 'no value'),
        ([(_SET_IF_UNSET, "        self.declare_parameter('stops_m', Parameter.Type.DOUBLE_ARRAY)")], 2, 'no value'),
        ([(_SET_IF_UNSET, "        self.declare_parameter('stops_m', [0.0])")], 2, 'value `[0.0]`'),
        # Set, whatever the start has said.
        ([(_SET_IF_UNSET, f"        self.declare_parameter('stops_m', Parameter.Type.DOUBLE_ARRAY)\n{_SET}")], 2,
         'it is `[]`'),
        ([('DOUBLE_ARRAY', 'INTEGER_ARRAY')], 2, 'type integer array'),
        ([('(read_only=True)', '(read_only=True, dynamic_typing=True)')], 2, 'the type may change'),
    ],
    '6.2c': [
        ([("260': 'accepted'", "260': 'off the step'")], 7, 'something special about it'),
        ([("'off the step'", "'accepted'")], 7, 'count from 50'),
        ([("275': 'out of range'", "275': 'off the step'")], 7, 'looks at the ends'),
        ([("'rejected by the node'", "'accepted'")], 7, 'asked after the descriptor'),
        ([("225.0': 'wrong type'", "225.0': 'accepted'")], 7, 'ROS converts nothing'),
        ([("7': 'read only'", "7': 'accepted'")], 7, 'does not compare the new value'),
        ([("12': 'read only'", "12': 'out of range'")], 7, 'that check comes later'),
        ([("50': 'accepted'", "50': 'out of range'")], 7, 'written without a dot'),
        ([("7': 'read only'", "7': 'fixed'")], 7, 'none of these words'),
        ([("50': 'accepted'", "50': ...")], 7, 'there is no prediction yet'),
    ],
}

RIGHT = {
    '6.2a': [
        [("self.declare_parameter('rate_hz'", "rate_hz = self.declare_parameter('rate_hz'"),
         ('to_value=50)]))', 'to_value=50)])).value'),
         ("self.get_parameter('rate_hz').value, self.drive", 'rate_hz, self.drive')],
        [('to_value=50)', 'to_value=50, step=1)'), ('1 / self', '1.0 / self')],
        # A timer beside it.
        [(_RATE, f'{_RATE}        self.create_timer(1.0, lambda: None)\n')],
    ],
    '6.2b': [
        [(_SET_IF_UNSET, "        self.declare_parameter('stops_m', Parameter.Type.DOUBLE_ARRAY)\n"
          "        self.set_parameters([self.get_parameter_or('stops_m', Parameter('stops_m', "
          'Parameter.Type.DOUBLE_ARRAY, []))])')],
        [("'label', 'north'", "'label', 'north', ParameterDescriptor(description='Painted on it.')"),
         (_SET.strip(), _SET.strip().replace('set_parameters', 'set_parameters_atomically').replace('([', '([')),
         ('(read_only=True)', "(read_only=True, description='Stamped.')")],
    ],
    '6.2c': [
        [('kinds = {\n', "kinds = {\n    'gain = 1': 'accepted',\n")],
        [("'gain = 50': 'accepted'", "'gain = 50': str('accepted')")],
        [("7': 'read only'", "7': 'Read-only'"), ("12': 'read only'", "12': 'read_only'"),
         ("'off the step'", "' off the step.'")],
        [('kinds = {', 'kinds = dict({'), ("'gain = 50': 'accepted',\n}", "'gain = 50': 'accepted',\n})")],
    ],
}
