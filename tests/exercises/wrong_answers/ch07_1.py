"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.1."""

WRONG = {
    '7.1c': [
        ([('      red: 0.5\n', ''),
          ('    color:\n', '      red: 0.5\n    color:\n')],
         0, 'it cannot: Error parsing a event near line 4'),
        ([('  ros__parameters:\n', ''),
          ('/lamp:\n', '  ros__parameters:\n/lamp:\n')],
         0, 'it cannot: There are no node names before ros__parameters'),
        ([('    brightness_percent: 60\n', ''),
          ('/lamp:\n', '    brightness_percent: 60\n/lamp:\n')],
         0, 'it cannot: Cannot have a value before ros__parameters at'),
        ([('    brightness_percent: 60\n    color:\n', '    color:\n    brightness_percent: 60\n')],
         0, 'it cannot: No value at line 4'),
        ([('/lamp:', '/lamps:')], 0, 'it is `100`, the default: the file has no value for it'),
        ([('0.5', '1')], 0, 'its constructor did not get to its end.'),
        ([('60', '60.0')], 0, 'its constructor did not get to its end.'),
        ([('    color:\n      red', '    red')], 1, 'it is `1.0`, the default: the file has no value for it'),
        ([('  ros__parameters:\n', '')], 0, 'it cannot: Cannot have a value before ros__parameters at'),
    ],
    '7.1a': [
        ([("'1.10'", '1.10')], 5, "to '1.1' of type 'DOUBLE', expecting type 'STRING'"),
        ([("'on'", 'on')], 5, 'To rcl this word is a boolean'),
        ([('20.0', '20')], 5, 'A double wants its dot'),
        ([("['1', '2']", '[1, 2]')], 5, 'needs quotes of its own'),
        ([("'0042'", '0042')], 5, "to '34' of type 'INTEGER'"),
        ([('    gains:\n      kp: 1.5', '    kp: 1.5')], 5, 'the default: the file does not reach it'),
        ([('/lab/recorder', '/recorder')], 0, 'the default: the file does not reach it'),
        ([('ros__parameters', 'ros_parameters')], 0, 'Cannot have a value before ros__parameters'),
    ],
    '7.1b': [
        ([('False,', "'n',")], 7, 'more words for false'),
        ([(": 'n'", ': False')], 7, 'it is a text, twice'),
        ([("': 'no'", "': False")], 7, 'rcl respects them'),
        ([("'old'", "'no'")], 7, 'Quotes do not survive'),
        ([('2000.0', "'2e3'")], 7, 'rcl sees one'),
        ([(": '2e3'", ': 2000.0')], 7, 'YAML 1.1 wants a dot'),
        ([('None', "['dock']")], 7, 'The default has been taken away'),
        ([("['dock']", '[]')], 7, 'a boolean array to this reader'),
    ],
}

RIGHT = {
    '7.1c': [
        [('    brightness_percent: 60\n    color:\n      red: 0.5\n',
          '    color:\n      red: 0.5\n    brightness_percent: 60\n')],
        [('    color:\n      red', '    color.red')],
        [('/lamp', 'lamp')],
        [('/lamp', '/**')],
    ],
}
