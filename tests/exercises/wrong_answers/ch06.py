"""Wrong answers that people give to the exercises of chapter 6."""

WRONG = {
    '6a': [
        ([(', step=100', '')], 4, 'Steps count from the smaller end'),
        ([('integer_range=[IntegerRange(from_value=100, to_value=10000, step=100)]',
           "additional_constraints='100 to 10000'")], 4, 'A range belongs into `integer_range`'),
        ([("'gain', 1.0", "'gain', 1")], 4, 'type integer, value `1`'),
        ([('read_only=True', "description='Never changes.'")], 4, '`read_only`'),
        ([('dynamic_typing=True', '')], 4, "expected 'Type.STRING' got 'Type.INTEGER'"),
        ([('Parameter.Type.INTEGER_ARRAY', '[]')], 4, 'type byte array, value `[]`'),
        ([('Parameter.Type.INTEGER_ARRAY', 'None, ParameterDescriptor(dynamic_typing=True)')], 4, 'type not set'),
    ],
    '6b': [
        ([("260': 'accepted'", "260': 'off the step'")], 7, 'something special about it'),
        ([("'off the step'", "'accepted'")], 7, 'count from 50'),
        ([("275': 'out of range'", "275': 'off the step'")], 7, 'the ends are looked at'),
        ([("'rejected by the node'", "'accepted'")], 7, 'one more is asked after it'),
        ([("225.0': 'wrong type'", "225.0': 'accepted'")], 7, 'ROS converts nothing'),
        ([("7': 'read only'", "7': 'accepted'")], 7, 'does not look whether the value is another one'),
        ([("12': 'read only'", "12': 'out of range'")], 7, 'that check comes later'),
        ([("50': 'accepted'", "50': 'out of range'")], 7, 'written without a dot'),
    ],
    '6c': [
        ([("'rope_m', 10.0", "'rope_m', 10")], 2, 'it starts at `10`'),
        ([("'rope_m', 10.0, self.metres()", "'rope_m', 10.0, metres"), ('0.0, self.metres()', '0.0, metres'),
          ("        self.declare_parameter('rope_m'", "        metres = self.metres()\n"
           "        self.declare_parameter('rope_m'")], 2, 'a later declaration has overwritten it'),
        ([('0.0, self.metres()', '0.0')], 2, 'Does it have a range?'),
        ([('Parameter.Type.DOUBLE_ARRAY', '[]')], 2, 'Wrong parameter type'),
        ([('Parameter.Type.DOUBLE_ARRAY', '[], ParameterDescriptor(dynamic_typing=True)')], 2,
         'With a free type everything goes in'),
    ],
}
