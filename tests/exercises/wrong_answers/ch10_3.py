"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 10.3."""

WRONG = {
    '10.3b': [
        ([("group = 'gains.wheel_joint'\n", ''),
          ("gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
           "gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n"
           "group = 'gains.wheel_joint'\n")],
         0, "NameError: name 'group' is not defined, in the line `gains"),
        ([('{group}.d', '{group}.i')], 2, 'it is `0.0`'),
        ([('set_parameters_atomically', 'set_all')], 0, "'ParameterClient' object has no attribute 'set_all'"),
        ([('_atomically', '')], 2, 'there were 2'),
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
        ([('client.set_parameters_atomically(gains)\n', '')], 0, 'there is none'),
        ([('0.3', '0.4')], 2, 'it is `0.4`'),
        ([('/wheel_controller', '/wheel')], 0, 'there is no node /wheel. No node is running'),
        ([("gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
           "gains = {f'{group}.p': 0.3, 'x'{group}.d': 0.02}\n")],
         0, 'SyntaxError: unterminated string literal (detected at line'),
    ],
    '10.3a': [
        # P alone, as loud as it goes.
        ([(".i': 0.3", ".i': 0.0")], 2, 'Without an integral, some error always remains'),
        ([(".d': 0.03", ".d': 0.0")], 1, 'overshoot 2'),
        ([(".p': 0.62", ".p': 0.2"), (".d': 0.03", ".d': 0.01")], 2, 'settling time 0.'),
        ([(".p': 0.62", ".p': ...")], 0, 'a `...` is still there, for `gains.wheel_joint.p`'),
        ([(".p': 0.62", ".p': 1")], 0, 'Wrong parameter type'),
        ([(".p': 0.62", ".p': '0.62'")], 0, 'Wrong parameter type'),
        ([(".p': 0.62", ".p': None")], 0, 'Static parameter cannot be undeclared'),
        ([(".p': 0.62", ".p': float('nan')")], 0, 'out of range'),
        ([(".p': 0.62", ".p': 62.0")], 0, 'out of range'),
        ([(".p': 0.62", ".p': 0.1"), (".i': 0.3", ".i': 1.2"), (".d': 0.03", ".d': 0.0")], 0, 'no steady speed'),
        ([('wheel_joint.p', 'wheel_joint.kp')], 0, 'there is none'),
        ([("    'gains.wheel_joint.p'", "    'simulation.lag_sec': 0.0,\n    'gains.wheel_joint.p'")], 0,
         'there is also `simulation.lag_sec`'),
    ],
    '10.3c': [
        ([('update_rate: 50', 'update_rate: 50.0')], 4, 'it is `50.0`'),
        ([('type: pid_controller/PidController', 'type: PidController')], 4, "it is `'PidController'`"),
        ([('{p: 0.2,', '{p: 1,')], 4, "'gains.left_joint.p' to '1' of type 'INTEGER', expecting type 'DOUBLE'"),
        ([('{p: 0.25,', "{p: '0.25',")], 4, "'gains.right_joint.p' to '0.25' of type 'STRING'"),
        # A name without a slash is for the root namespace alone.
        ([('/**/left_controller:', 'left_controller:'), ('/**/right_controller:', 'right_controller:')], 4,
         'the file does not reach it'),
        ([('update_rate: 50', 'update_rte: 50')], 4, 'the file does not set it'),
        ([('{p: 0.2,', '{kp: 0.2,')], 4, 'It sets `gains.left_joint.kp`, which the node does not declare'),
        ([('left_joint:\n', 'left_jiont:\n')], 4, 'It sets `gains.left_jiont'),
        ([('[right_joint]', 'right_joint')], 4, "expecting type 'STRING_ARRAY'"),
        ([('[left_joint]', '[left_joint, right_joint]')], 4, "it is `['left_joint', 'right_joint']`"),
        ([('  ros__parameters:\n    update_rate', '  update_rate')], 0, 'before ros__parameters'),
        ([('    right_controller:\n      type: pid_controller/PidController\n', '')], 4, 'there is none'),
        # What the real controller does not load without.
        ([('    command_interface: effort\n', '')], 3, 'without it the controller does not load'),
        ([('reference_and_state_interfaces: [velocity]', 'reference_and_state_interfaces: velocity')], 3,
         "expecting type 'STRING_ARRAY'"),
        ([('command_interface: effort', 'command_interface: velocity')], 3, "it is `'velocity'`"),
        ([(',\n         antiwindup_strategy: conditional_integration', '')], 3, 'the file does not set it'),
        ([('p: 0.25', 'p: 0.2')], 4, 'it is `0.2`'),
        ([('\n    ', '\n\t')], 0, 'this is not YAML'),
    ],
}

RIGHT = {
    '10.3b': [
        [("client = ParameterClient('/wheel_controller')\n", ''),
         ("group = 'gains.wheel_joint'\n",
          "client = ParameterClient('/wheel_controller')\n"
          "group = 'gains.wheel_joint'\n")],
        [("f'{group}.p': 0.3, f'{group}.d': 0.02", "f'{group}.d': 0.02, f'{group}.p': 0.3")],
        [("'/wheel_controller'", "'wheel_controller'")],
        [("ParameterClient('/wheel_controller')", "ParameterClient('/wheel_controller', timeout_sec=2.0)")],
        [("group = 'gains.wheel_joint'\n"
          "gains = {f'{group}.p': 0.3, f'{group}.d': 0.02}\n",
          "gains = {'gains.wheel_joint.p': 0.3, 'gains.wheel_joint.d': 0.02}\n")],
    ],
    '10.3a': [
        [("    'gains.wheel_joint.p': 0.62,\n", ''),
         ("'gains.wheel_joint.d': 0.03,", "'gains.wheel_joint.d': 0.03,\n    'gains.wheel_joint.p': 0.62,")],
        [('gains = {', 'gains = {} | {')],
        [('0.62', '0.6'), ('0.3', '0.31')],
        [('gains = {', "gains = {f'gains.wheel_joint.{k}': v for k, v in dict(p=0.62, i=0.3, d=0.03).items()} or {")],
    ],
    '10.3c': [
        # The type in the controllers' own blocks, and more that the real files hold.
        [('    left_controller:\n      type: pid_controller/PidController\n'
          '    right_controller:\n      type: pid_controller/PidController\n', ''),
         ('    dof_names:', '    type: pid_controller/PidController\n    is_async: true\n    dof_names:')],
        [('    update_rate: 50', '    update_rate: 50\n    use_sim_time: false\n'
          '    hardware_components_initial_state: {inactive: [robot]}'),
         ('{p:', '{feedforward_gain: 0.5, save_i_term: false, angle_wraparound: true, d: 0.01, p:'),
         ('    dof_names:', '    async_parameters: {thread_priority: 60}\n    update_rate: 25\n'
          '    use_external_measured_states: true\n    dof_names:')],
        # What both share, once for all; a joint's gains reach the other controller too, which does not declare them.
        [('    command_interface: effort\n    reference_and_state_interfaces: [velocity]\n', ''),
         ('controllers = """\n', 'controllers = """\n/**:\n  ros__parameters:\n    command_interface: effort\n'
          '    reference_and_state_interfaces: [velocity]\n    gains:\n      left_joint: {i: 0.4}\n'
          '      right_joint: {i: 0.4}\n'), (' i: 0.4, u', ' u')],
        # Names with dots, nested namespaces, quotes.
        [('    left_controller:\n      type: pid_controller/PidController\n',
          '    left_controller.type: "pid_controller/PidController"\n'),
         ('[left_joint]', '["left_joint"]'), ('effort', "'effort'")],
        [('/**/controller_manager:\n  ros__parameters:\n    update_rate: 50\n',
          '/**:\n  controller_manager:\n    ros__parameters:\n      update_rate: 50\n'),
         ('    left_controller:\n      type: pid_controller/PidController\n'
          '    right_controller:\n      type: pid_controller/PidController\n',
          '      left_controller: {type: pid_controller/PidController}\n'
          '      right_controller: {type: pid_controller/PidController}\n')],
    ],
}
