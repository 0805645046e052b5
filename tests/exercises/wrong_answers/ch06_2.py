"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 6.2."""

_SET_IF_UNSET = ("        stops = self.declare_parameter('stops_m', Parameter.Type.DOUBLE_ARRAY)\n"
                 "        if stops.value is None:\n"
                 "            self.set_parameters([Parameter('stops_m', Parameter.Type.DOUBLE_ARRAY, [])])")
_SET = "        self.set_parameters([Parameter('stops_m', Parameter.Type.DOUBLE_ARRAY, [])])"
_LOCK = ("'H-01', ParameterDescriptor(read_only=True)", "'H-01'")

WRONG = {
    '6.2a': [
        ([("260': 'accepted'", "260': 'off the step'")], 7, 'something special about it'),
        ([("'off the step'", "'accepted'")], 7, 'count from 50'),
        ([("275': 'out of range'", "275': 'off the step'")], 7, 'looks at the ends'),
        ([("'rejected by the node'", "'accepted'")], 7, 'asked after the descriptor'),
        ([("225.0': 'wrong type'", "225.0': 'accepted'")], 7, 'ROS converts nothing'),
        ([("7': 'read only'", "7': 'accepted'")], 7, 'does not compare the new value'),
        ([("12': 'read only'", "12': 'out of range'")], 7, 'that check comes later'),
        ([("50': 'accepted'", "50': 'out of range'")], 7, 'written without a dot'),
        ([("7': 'read only'", "7': 'locked'")], 7, 'none of these words'),
        ([("50': 'accepted'", "50': ...")], 7, 'there is no prediction yet'),
    ],
    '6.2b': [
        ([('read_only=True', "description='Never changes.'")], 2, 'A description enforces nothing'),
        ([("'label', 'north'", "'label', 'north', ParameterDescriptor(dynamic_typing=True)")], 2,
         'Its type may change'),
        ([("'stops_m', Parameter.Type.DOUBLE_ARRAY)\n", "'stops_m', [])\n")], 2, 'type byte array, value `[]`'),
        # Locked, and deaf to the start.
        ([('(read_only=True)', '(read_only=True), ignore_override=True')], 2, "it is `'H-01'`"),
        # Judged by a callback that comes too late for the lock's place in the order.
        ([_LOCK, ('class', 'from rcl_interfaces.msg import SetParametersResult\n\nclass'), ('        stops = ',
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
        ([('read_only=True', "description='Never changes.'")], 2, '`read_only`'),
        ([('dynamic_typing=True', '')], 2, "expected 'Type.STRING' got 'Type.INTEGER'"),
        ([('Parameter.Type.INTEGER_ARRAY', '[]')], 2, 'type byte array, value `[]`'),
        ([('(read_only=True)', '(read_only=True), ignore_override=True')], 2, "it is `'IMX219'`"),
        ([("'IMX219'", "'IMX477'")], 2, "value `'IMX477'`"),
        ([("'tag', 'day'", "'tag', None")], 2, 'no value'),
        ([("'tag', 'day'", "'tag', 'night'")], 2, "value `'night'`"),
        ([('dynamic_typing=True', 'dynamic_typing=True, read_only=True')], 2, '(read only)'),
        ([('Parameter.Type.INTEGER_ARRAY', '[0]')], 2, 'value `[0]`'),
        ([('Parameter.Type.INTEGER_ARRAY', 'Parameter.Type.DOUBLE_ARRAY')], 2, 'type double array'),
        ([('Parameter.Type.INTEGER_ARRAY', 'Parameter.Type.INTEGER')], 2, 'type integer, no value'),
        ([('Parameter.Type.INTEGER_ARRAY', 'None, ParameterDescriptor(dynamic_typing=True)')], 2, 'type not set'),
        ([('(read_only=True)', '(read_only=True, dynamic_typing=True)')], 2, 'the type may change'),
    ],
}

RIGHT = {
    '6.2a': [
        [('kinds = {\n', "kinds = {\n    'gain = 1': 'accepted',\n")],
        [("'gain = 50': 'accepted'", "'gain = 50': str('accepted')")],
        [("7': 'read only'", "7': 'Read-only'"), ("12': 'read only'", "12': 'read_only'"),
         ("'off the step'", "' off the step.'")],
        [('kinds = {', 'kinds = dict({'), ("'gain = 50': 'accepted',\n}", "'gain = 50': 'accepted',\n})")],
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
        [("'IMX219', Pa", "'IMX219', descriptor=Pa")],
        [("        self.declare_parameter('sensor', 'IMX219', ParameterDescriptor(read_only=True))\n"
          "        self.declare_parameter('tag', 'day', ParameterDescriptor(dynamic_typing=True))\n",
          "        self.declare_parameters('', [('sensor', 'IMX219', ParameterDescriptor(read_only=True)), "
          "('tag', 'day', ParameterDescriptor(dynamic_typing=True))])\n")],
        [("        self.declare_parameter('sensor', 'IMX219', ParameterDescriptor(read_only=True))\n",
          "        self.declare_parameter('sensor', 'IMX219')\n"
          "        self.set_descriptor('sensor', ParameterDescriptor(read_only=True, "
          'type=Parameter.Type.STRING.value))\n')],
        [('Parameter.Type.INTEGER_ARRAY', "Parameter.Type(7), ParameterDescriptor(description='x, y, w, h')")],
    ],
}
