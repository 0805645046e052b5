"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 8."""

WRONG = {
    '8c': [
        ([("'fan.speed', 0.5", "'speed', 0.5")], 0, 'its constructor did not get to its end.'),
        ([("'fan.speed', 0.5", "'fan.speed', 1")], 1, 'type integer, value `1`'),
        ([('0.5, Param', '0.25, Param')], 2, 'type double, value `0.25`'),
        ([('to_value=1.0', 'to_value=2.0')], 2, 'it was accepted'),
        ([('to_value=1.0', 'to_value=1')], 2, 'it has (0.0, 5e-324). Do both ends have a dot?'),
        ([("'Speed, as a part of the full speed.'", "''")], 2, 'there is none'),
        ([('from_value=0.0', 'from_value=0.25')],
         2, 'it was rejected: Parameter fan.speed out of range Min: 0.25,'),
        ([("'Speed, as a part of the full speed.'", '...')], 0, 'it is `Ellipsis`'),
        ([('            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]',
           '            ')], 2, 'it was accepted'),
        ([("'fan.speed', 0.5", "'fan/speed', 0.5")], 0, 'its constructor did not get to its end.'),
    ],
    '8a': [
        ([("'belt.speed_mps', 0.0, ParameterDescriptor(", "'belt.speed_mps', 0, ParameterDescriptor(")], 2,
         'it is of type integer: the default decides'),
        ([("'belt.", "'")], 1, 'the group holds `{}`'),
        ([('from_value=0.0, to_value=2.0)', 'from_value=0.0, to_value=20.0)')], 5, 'it was accepted'),
        ([('            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]))', '            ))'),
          ('if speed_mps > 1.0 and gap_m < 0.3:', 'if speed_mps > 1.0 and gap_m < 0.3 or not 0.0 <= gap_m <= 1.0:')],
         5, 'a callback rejects, but no panel can know'),
        ([(', read_only=True', '')], 5, 'anybody can change it'),
        ([("description='Speed of the belt in m/s.',", '')], 5, 'there is none for `belt.speed_mps`'),
        ([("new.get('belt.gap_m', self.get_parameter('belt.gap_m').value)", "self.get_parameter('belt.gap_m').value")],
         5, 'it was accepted'),
        ([("reason=f'{gap_m} m is too small a gap for {speed_mps} m/s'", "reason=''")], 5, 'the reason is empty'),
        ([('        if speed_mps > 1.0', '        self.motor_mps = speed_mps\n        if speed_mps > 1.0')], 5,
         'a side effect of an on-set callback'),
        ([("        self.motor_mps = self.get_parameter('belt.speed_mps').value\n        self.add_on",
           '        self.add_on')], 5, 'it is `None`'),
        ([('gap_m < 0.3', 'gap_m <= 0.3')], 5, '0.3 m is too small'),
    ],
    '8b': [
        ([("start.': 1", "start.': 6")], 4, 'is not initialized'),
        ([("took it.': 2", "took it.': 3")], 4, 'it accepted 50.0 m/s'),
        ([("all the same.': 3", "all the same.': 2")], 4, 'the motor runs at 1.5 m/s, and the parameter says 0.5'),
        ([("got none.': 4", "got none.': 5")], 4, 'begin with `controller.` is empty'),
        ([("weighs nothing.': 7", "weighs nothing.': 2")], 4, 'it accepted a gravity of 0'),
        ([("weighs nothing.': 7", "weighs nothing.': '7'")], 4, "there is `'7'`"),
        ([("weighs nothing.': 7", "weighs nothing.': True")], 4, 'there is `True`'),
    ],
}

RIGHT = {
    '8c': [
        [('0.0, to_value=1.0', '-0.0, to_value=float(1)')],
        [("'Speed, as a part of the full speed.'", "'0: off, 1: full'")],
        [("'fan.speed', 0.5", "'.'.join(['fan', 'speed']), 1 / 2")],
    ],
}
