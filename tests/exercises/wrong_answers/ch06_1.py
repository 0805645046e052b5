"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 6.1."""

_PRESSURE = 'floating_point_range=[FloatingPointRange(from_value=0.0, to_value=6.0)]'
_GAIN = 'floating_point_range=[FloatingPointRange(from_value=0.0, to_value=16.0)]'
_SHARED = ("        self.declare_parameter('rope_m'", "        meters = self.meters()\n"
           "        self.declare_parameter('rope_m'")

WRONG = {
    '6.1a': [
        ([('step=25', 'step=20')], 1, 'opening_percent = 25 (off the step)'),
        ([("'pressure_bar', 2.5", "'pressure_bar', 2")], 1, 'type integer, value `2`'),
        ([('step=25', 'step=5')], 1, '/valve accepted opening_percent = 5'),
        ([('from_value=0, to_value=100', 'from_value=1, to_value=100')], 0, 'its constructor did not finish'),
        ([("'pressure_bar', 2.5", "'pressure_bar', 0.0")], 1, 'value `0.0`'),
        ([('to_value=6.0)', 'to_value=6.0, step=0.5)')], 1, 'pressure_bar = 0.001 (off the step)'),
        ([('from_value=0.0, to_value=6.0', 'from_value=0, to_value=6')], 1, "must be of type 'float'"),
        ([(_PRESSURE, 'integer_range=[IntegerRange(from_value=0, to_value=6)]')], 1, 'accepted pressure_bar = -0.001'),
        # A range of integers with the ends of doubles: the node could never describe it.
        ([(_PRESSURE, 'integer_range=[IntegerRange(from_value=0.0, to_value=6.0)]')], 0, "must be of type 'int'"),
        ([('to_value=6.0', 'to_value=60.0')], 1, 'accepted pressure_bar = 6.001'),
        ([('step=25', 'step=...')], 0, 'a `...` is still there'),
    ],
    '6.1b': [
        ([("'rope_m', 10.0", "'rope_m', 10")], 1, 'type integer, value `10`'),
        ([_SHARED, ("'rope_m', 10.0, self.meters()", "'rope_m', 10.0, meters"), ('0.0, self.meters()', '0.0, meters')],
         1, 'a later declaration has overwritten it'),
        # The same, with the other one declared last.
        ([_SHARED, ("'rope_m', 10.0, self.meters()", "'hook_m', 0.0, meters"),
          ("'hook_m', 0.0, self.meters()", "'rope_m', 10.0, meters")], 1, 'it names `rope_m`'),
        ([('0.0, self.meters()', '0.0')], 1, 'Does it have a range of doubles'),
        ([('FloatingPointRange(from_value=0.0, to_value=30.0)', 'FloatingPointRange(from_value=0, to_value=30)')], 1,
         "must be of type 'float'"),
        ([('to_value=30.0', 'to_value=31.0')], 1, 'Does it have a range of doubles'),
        ([('to_value=30.0', 'to_value=30.0, step=0.5')], 1, '(off the step)'),
        ([("'hook_m', 0.0", "'hook_m', 10.0")], 1, 'value `10.0`'),
        ([('ParameterDescriptor(floating', 'ParameterDescriptor(dynamic_typing=True, floating')], 1,
         'accepted rope_m = 20'),
        ([("'hook_m', 0.0", "'hook', 0.0")], 1, 'none of that name'),
    ],
    '6.1c': [
        ([(', step=100', '')], 3, 'The step is the third field'),
        ([("'gain', 1.0", "'gain', 1")], 3, 'type integer, value `1`'),
        ([(', step=0.5', '')], 3, 'accepted tilt_deg = 0.25'),
        ([("            description='How much the signal is amplified.',\n", '')], 3, '`gain` has none'),
        ([('step=100', 'step=200')], 3, 'exposure_us = 200 (off the step)'),
        ([('step=100', 'step=300')], 0, 'is not a valid step'),
        ([('from_value=100', 'from_value=0')], 3, 'exposure_us = 0. The limits of an integer'),
        ([("'exposure_us', 500", "'exposure_us', 500.0")], 3, 'type double, value `500.0`'),
        ([("'exposure_us', 500", "'exposure_us', 100")], 3, 'value `100`'),
        ([('FloatingPointRange(from_value=0.0, to_value=16.0)', 'FloatingPointRange(from_value=0, to_value=16)')], 3,
         "must be of type 'float'"),
        ([(_GAIN, "additional_constraints='0 to 16'")], 3, 'The limits of a double'),
        ([('to_value=16.0', 'to_value=16.0, step=0.1')], 3, '(off the step)'),
        ([('to_value=16.0', 'to_value=16.5')], 3, 'accepted gain = 16.001'),
        ([("'gain', 1.0", "'gain', Parameter.Type.DOUBLE"),
          ('class', 'from rclpy.parameter import Parameter\n\nclass')], 3, 'type double, no value'),
        ([('from_value=-90.0', 'from_value=0.0')], 3, 'tilt_deg = -90.0'),
    ],
}

RIGHT = {
    '6.1a': [
        [('from_value=0, to_value=100', 'from_value=100, to_value=0')],
        [('to_value=6.0', 'to_value=6.0, step=0.0')],
        [("'pressure_bar', 2.5, ParameterDescriptor(", "'pressure_bar', 5 / 2, descriptor=ParameterDescriptor("),
         ('to_value=6.0', 'to_value=float(6)')],
    ],
    '6.1b': [
        [_SHARED, ("'rope_m', 10.0, self.meters()", "'rope_m', 10.0, copy.deepcopy(meters)"),
         ('0.0, self.meters()', '0.0, meters'), ('class Winch', 'import copy\n\n\nclass Winch')],
        # One range, two descriptors.
        [_SHARED, ("'rope_m', 10.0, self.meters()",
                   "'rope_m', 10.0, ParameterDescriptor(floating_point_range=meters.floating_point_range)"),
         ('0.0, self.meters()', '0.0, ParameterDescriptor(floating_point_range=meters.floating_point_range)')],
        [("        self.declare_parameter('rope_m', 10.0, self.meters())\n"
          "        self.declare_parameter('hook_m', 0.0, self.meters())\n",
          "        self.declare_parameters('', [(name, start, self.meters()) for name, start in (('rope_m', 10.0), "
          "('hook_m', 0.0))])\n")],
        [('from_value=0.0, to_value=30.0', 'from_value=30.0, to_value=0.0')],
    ],
    '6.1c': [
        [('from_value=100, to_value=10000', 'from_value=10000, to_value=100')],
        [('to_value=16.0', 'to_value=16.0, step=0.0'), ("'gain', 1.0, Pa", "'gain', 1.0, descriptor=Pa")],
        [("'gain', 1.0, ParameterDescriptor(", "'gain', 1.0, ParameterDescriptor(\n"
          "            additional_constraints='Below 8 in daylight.',")],
        [("        self.declare_parameter('gain', 1.0", "        self.declare_parameter('gain', 2.0)\n"
          "        self.undeclare_parameter('gain')\n        self.declare_parameter('gain', 1.0")],
    ],
}
