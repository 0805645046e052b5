"""Wrong answers that people give to the exercises of chapter 10.3."""

WRONG = {
    '10.3a': [
        # P alone, as loud as it goes.
        ([(".i': 0.3", ".i': 0.0")], 0, 'P alone always leaves one'),
        ([(".d': 0.03", ".d': 0.0")], 1, 'overshoot 2'),
        ([(".p': 0.62", ".p': 0.2"), (".d': 0.03", ".d': 0.01")], 2, 'settling time 0.'),
        ([(".p': 0.62", ".p': 1")], 0, 'Wrong parameter type'),
        ([(".p': 0.62", ".p': 62.0")], 0, 'out of range'),
        ([(".p': 0.62", ".p': 0.1"), (".i': 0.3", ".i': 1.2"), (".d': 0.03", ".d': 0.0")], 0, 'no steady speed'),
        ([('wheel_joint.p', 'wheel_joint.kp')], 0, 'there is also `gains.wheel_joint.kp`'),
        ([("    'gains.wheel_joint.p'", "    'simulation.lag_sec': 0.0,\n    'gains.wheel_joint.p'")], 0,
         'there is also `simulation.lag_sec`'),
    ],
    '10.3b': [
        # A name without a slash is for the root namespace alone.
        ([('/**/left_controller:', 'left_controller:'), ('/**/right_controller:', 'right_controller:')], 2,
         'holds nothing for /robot/left_controller'),
        ([('update_rate: 50', 'update_rate: 50.0')], 3, 'it is `50.0`'),
        ([('{p: 0.2,', '{p: 1,')], 2, 'InvalidParameterTypeException'),
        ([('{p: 0.2,', '{kp: 0.2,')], 3, 'it has no parameter `gains.left_joint.kp`'),
        ([('left_joint: {', 'left_jiont: {')], 3, 'it has no parameter `gains.left_jiont'),
        ([('[right_joint]', 'right_joint')], 3, 'InvalidParameterTypeException'),
        ([('  ros__parameters:\n    update_rate', '  update_rate')], 0, 'before ros__parameters'),
        ([('type: pid_controller/PidController', 'type: PidController')], 3, "it is `'PidController'`"),
    ],
}
