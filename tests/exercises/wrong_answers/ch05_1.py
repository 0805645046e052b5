"""Wrong answers that people give to the exercises of chapter 5.1."""

WRONG = {
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
