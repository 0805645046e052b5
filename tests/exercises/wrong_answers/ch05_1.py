"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.1."""

WRONG = {
    '5.1c': [
        ([('set /gripper retries 5', 'set retries /gripper 5')],
         2, 'it is `3`; the terminal says: Node not found'),
        ([('retries 5', 'retries 5.0')], 2, 'it is `3`; the terminal says: Setting parameter failed:'),
        ([('retries 5', '5 retries')], 2, 'it is `3`; the terminal says: Setting parameter failed:'),
        ([('get /gripper', '/gripper get')], 2, 'it is not; the terminal says: ros2 param: error: argument'),
        ([('param describe', 'describe param')], 2, 'it is not; the terminal says: after `ros2`, `describe` is'),
        ([('ros2 param get', 'param ros2 get')], 2, 'it is not; the terminal says: param: command not found'),
        ([('describe /gripper speed_mps', 'get /gripper speed_mps')], 2, 'it is not'),
        ([('/gripper mode', '/griper mode')], 2, 'it is not; the terminal says: Node not found'),
        ([('retries 5', 'retries "5')], 0, '`ros2 param set /gripper retries "5`: No closing quotation'),
        ([('ros2 param get /gripper mode\n', '')], 2, 'it is not'),
    ],
    '5.1a': [
        ([("'1.0'", "'1'")], 5, 'A double wants its dot'),
        ([('1.0e-3', '1e-3')], 5, 'takes a number with an exponent for a text'),
        ([("'10'", "'010'")], 5, 'octal'),
        ([("\"\\\"'42'\\\"\"", '"\'42\'"')], 5, 'one for the shell and one for YAML'),
        ([("\"\\\"'off'\\\"\"", "'off'")], 5, 'this word means false'),
        ([('[1.0, 2.5]', '[1, 2.5]')], 5, 'All elements need one type'),
        ([('\'"[1.0, 2.5]"\'', "'[1.0, 2.5]'")], 5, 'the list needs quotes'),
        ([("'1.0'", '1.0')], 5, 'there is `1.0`'),
        ([("'10'", "'\"10'")], 5, 'No closing quotation'),
    ],
    '5.1b': [
        ([('750', '100')], 4, 'counts in sixties'),
        ([(': False', ": 'off'")], 4, 'A boolean never holds a text'),
        ([("1': 0.5", "1': 1.0")], 4, 'ROS converts nothing'),
        ([(': 2.0', ': 0.5')], 4, 'The ends of a range belong to it'),
        ([("'Clawbot'", "'007'")], 4, 'the old value stays'),
    ],
}

RIGHT = {
    '5.1c': [
        [('/gripper', 'gripper')],
        [('ros2 param get', '%ros2 param get')],
        [('retries 5', 'retries "5"  # five')],
        [('get /gripper', 'get --hide-type /gripper')],
        [('ros2 param set /gripper retries 5\nros2 param get /gripper mode\n',
          'ros2 param get /gripper mode\nros2 param set /gripper retries 5\n')],
    ],
}
