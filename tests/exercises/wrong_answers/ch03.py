"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 3."""

WRONG = {
    '3c': [
        ([('90', '90.0')], 2, 'type double, value `90.0`'),
        ([('30.0', '30')], 2, 'type integer, value `30`'),
        ([("'7'", '7')], 2, 'type integer, value `7`'),
        ([('90', '...')], 0, 'its constructor did not get to its end. TypeError: The'),
        ([('90', "'90'")], 2, "type string, value `'90'`"),
        ([('30.0', '30.5')], 2, 'type double, value `30.5`'),
        ([("'label'", "'lable'")], 2, 'the node has none of that name'),
        ([("'7'", "'7.0'")], 2, "type string, value `'7.0'`"),
        ([("'door'", "'doors'")], 3, 'it is called `doors`'),
    ],
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

RIGHT = {
    '3c': [
        [('30.0', '3e1')],
        [('90', 'int(90.0)')],
        [("'7'", 'str(7)'),
         ('30.0', "float('30')")],
        [("        self.declare_parameter('max_angle_deg', 90)\n"
          "        self.declare_parameter('speed_dps', 30.0)\n",
          "        self.declare_parameters('', [('max_angle_deg', 90), ('speed_dps', 30.0)])\n")],
    ],
}
