"""Wrong answers that people give to the exercises of chapter 3."""

WRONG = {
    '3a': [
        ([("'max_speed_mps', 1.0", "'max_speed_mps', 1")], 2, "expected 'Type.INTEGER' got 'Type.DOUBLE'"),
        ([("'max_speed_mps', 1.0, ParameterDescriptor(\n            floating_point_range=[FloatingPointRange("
           'from_value=0.0, to_value=2.0)]))', "'max_speed_mps', 1.0, ParameterDescriptor(description='0 to 2'))")],
         3, 'A description is read by people only'),
        ([("'wheels', 6, ParameterDescriptor(read_only=True)", "'wheels', 6")], 3, '`read_only`'),
        ([("'wheels', 6", "'wheels', '6'")], 3, "type string, value `'6'`"),
        ([("'wheels'", "'weels'")], 2, 'none of that name'),
    ],
    '3b': [
        ([('50.0', '50')], 2, 'Wrong parameter type'),
        ([('FloatingPointRange(from_value=0.0', 'FloatingPointRange(from_value=-1000.0'), ('100.0)', '1000.0)')], 3,
         'is enforced by nobody'),
        ([("'warm_white', True", "'warm_white', 1")], 3, 'type integer, value `1`'),
        ([('Parameter.Type.DOUBLE', 'None')], 0, 'its constructor did not get to its end'),
        ([('Parameter.Type.DOUBLE', '0.0')], 3, 'type double, value `0.0`'),
    ],
}
