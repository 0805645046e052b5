"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.3."""

WRONG = {
    '10.3c': [
        ([("group = 'gains.wheel_joint'\n", ''),
          ("gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
           "gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n"
           "group = 'gains.wheel_joint'\n")],
         0, "NameError: name 'group' is not defined, in the line `gains"),
        ([("gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n", ''),
          ('client.set_parameters_atomically(gains)\n',
           'client.set_parameters_atomically(gains)\n'
           "gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n")],
         0, "NameError: name 'gains' is not defined, in the line"),
        ([("client = ParameterClient('/wheel_controller')\n", ''),
          ('client.set_parameters_atomically(gains)\n',
           'client.set_parameters_atomically(gains)\n'
           "client = ParameterClient('/wheel_controller')\n")],
         0, "NameError: name 'client' is not defined, in the line"),
        ([('client.set_parameters_atomically(gains)\n', '')], 0, 'it is `0.1`'),
        ([('_atomically', '')], 2, 'there is no such request'),
        ([('0.3', '0.4')], 2, 'it is `0.4`'),
        ([('{group}.d', '{group}.i')], 1, 'it is `0.0`'),
        ([('/wheel_controller', '/wheel')], 0, 'there is no node /wheel. No node is running'),
        ([('0.02', '-0.02')], 0, 'it is `0.1`'),
        ([("gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
           "gains = {f'{group}.p': 0.3, 'x'{group}.d': 0.02}\n")],
         0, 'SyntaxError: unterminated string literal (detected at line'),
    ],
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

RIGHT = {
    '10.3c': [
        [("client = ParameterClient('/wheel_controller')\n", ''),
         ("group = 'gains.wheel_joint'\n",
          "client = ParameterClient('/wheel_controller')\n"
          "group = 'gains.wheel_joint'\n")],
        [("f'{group}.p': 0.3, f'{group}.d': 0.02", "f'{group}.d': 0.02, f'{group}.p': 0.3")],
        [("'/wheel_controller'", "'wheel_controller'")],
        [("group = 'gains.wheel_joint'\n"
          "gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
          "gains = {'gains.wheel_joint.p': 0.3, 'gains.wheel_joint.d': 0.02}\n")],
    ],
}
