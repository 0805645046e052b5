"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 6.1."""

# Lines of the step, which the answers replace.
_BRAKING = "new.get('braking_mps2', self.get_parameter('braking_mps2').value)"
_RANGE = 'FloatingPointRange(from_value=0.1, to_value=3.0, step=0.1)'
_DESCRIPTION = "description='What the brakes can do at least, in m/s².', "
_OWN = (f'ParameterDescriptor(\n            {_DESCRIPTION}additional_constraints=RULE,\n'
        f'            floating_point_range=[{_RANGE}])')
_START = "['max_speed_mps', 'stop_distance_m', 'braking_mps2']"
_FIRST = "        self.declare_parameter('max_speed_mps'"
_SPEED = "description='Speed at which the robot drives, in m/s.', additional_constraints=RULE"
_SHARED = ("        self.declare_parameter('rope_m'", "        meters = self.meters()\n"
           "        self.declare_parameter('rope_m'")

WRONG = {
    '6.1a': [
        ([("'braking_mps2', 1.0", "'braking_mps2', 1")], 2, 'type integer, value `1`'),
        ([(', step=0.1', '')], 3, 'its `step` is 0.0'),
        ([('to_value=3.0', 'to_value=3')], 3, "must be of type 'float'"),
        ([(_DESCRIPTION, '')], 3, '`braking_mps2` has none'),
        # Still the constant, or the stored value in place of the proposed one.
        ([(_BRAKING, '1.0')], 3, 'it was rejected: 1.2 m/s takes 0.72 m'),
        ([(_BRAKING, "self.get_parameter('braking_mps2').value")], 3, 'What counts for the brakes is the request'),
        ([(_BRAKING, "new.get('braking_mps2', 1.0)")], 3, 'what is stored at that moment'),
        # The proposed brakes alone make a request worth judging.
        ([('        new = {', "        if 'max_speed_mps' not in {each.name for each in parameters}:\n"
           '            return SetParametersResult(successful=True)\n        new = {')], 3, 'it was accepted'),
        ([(_BRAKING, "new['braking_mps2']")], 2, "a callback raised KeyError: 'braking_mps2'"),
        ([('additional_constraints=RULE', "additional_constraints='See the manual.'")], 3, 'it is `See the manual.`'),
        ([(_SPEED, _SPEED.replace('additional_constraints=RULE', 'read_only=False'))], 3, 'it is empty'),
        # One descriptor for two.
        ([(_FIRST, f'        shared = {_OWN}\n{_FIRST}'),
          (f"'braking_mps2', 1.0, {_OWN}", "'braking_mps2', 1.0, shared"),
          ("'stop_distance_m', 0.5, ", "'stop_distance_m', 0.5, shared or ")], 2,
         'a later declaration has overwritten it'),
        ([('        start = self.judge', '        start = SetParametersResult(successful=True) or self.judge')], 3,
         'it started, with too little room'),
        ([('self.add_post_set_parameters_callback(self.act)', 'pass')], 3, 'it logs no such line'),
    ],
    '6.1b': [
        ([(', step=100', '')], 2, 'The step is the third field'),
        ([(', step=0.5', '')], 2, 'accepted tilt_deg = 0.25'),
        ([("            description='Angle above the horizon, in degrees.',\n", '')], 2, '`tilt_deg` has none'),
        ([('step=100', 'step=200')], 2, 'exposure_us = 200 (off the step)'),
        ([('step=100', 'step=300')], 0, 'is not a valid step'),
        ([('from_value=100', 'from_value=0')], 2, 'exposure_us = 0. The limits of an integer'),
        ([("'exposure_us', 500", "'exposure_us', 500.0")], 2, 'type double, value `500.0`'),
        ([("'exposure_us', 500", "'exposure_us', 100")], 2, 'value `100`'),
        ([("'tilt_deg', 0.0", "'tilt_deg', 0")], 2, 'type integer, value `0`'),
        ([('FloatingPointRange(from_value=-90.0, to_value=90.0', 'FloatingPointRange(from_value=-90, to_value=90')], 2,
         "must be of type 'float'"),
        ([('floating_point_range=[FloatingPointRange(from_value=-90.0, to_value=90.0, step=0.5)]',
           "additional_constraints='-90 to 90'")], 2, 'The limits of a double'),
        ([('to_value=90.0', 'to_value=90.5')], 2, 'its `to_value` is 90.5'),
        ([("'tilt_deg', 0.0", "'tilt_deg', Parameter.Type.DOUBLE"),
          ('class', 'from rclpy.parameter import Parameter\n\nclass')], 2, 'type double, no value'),
        ([('from_value=-90.0', 'from_value=0.0')], 2, 'tilt_deg = -90.0'),
    ],
    '6.1c': [
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
}

RIGHT = {
    '6.1a': [
        # With a reserve for the time in which it notices.
        [('/ 2 / braking_mps2\n', '/ 2 / braking_mps2 + 0.2 * speed_mps\n')],
        [(_START, "['max_speed_mps', 'stop_distance_m']")],
        [("RULE = 'max_speed_mps ** 2 / 2 / braking_mps2 <= stop_distance_m'",
          "RULE = 'From max_speed_mps, braking_mps2 stops the robot within stop_distance_m.'")],
        [('from_value=0.1, to_value=3.0', 'from_value=3.0, to_value=0.1')],
    ],
    '6.1b': [
        [('from_value=100, to_value=10000', 'from_value=10000, to_value=100')],
        [("'tilt_deg', 0.0, Pa", "'tilt_deg', 0.0, descriptor=Pa")],
        [("'tilt_deg', 0.0, ParameterDescriptor(", "'tilt_deg', 0.0, ParameterDescriptor(\n"
          "            additional_constraints='Below 8 in daylight.',")],
        [("        self.declare_parameter('tilt_deg', 0.0", "        self.declare_parameter('tilt_deg', 2.0)\n"
          "        self.undeclare_parameter('tilt_deg')\n        self.declare_parameter('tilt_deg', 0.0")],
    ],
    '6.1c': [
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
}
