"""Wrong answers that people give to the exercises of chapter 9."""

WRONG = {
    '9a': [
        ([('max_speed_mps: 1.0', 'max_speed_mps: 1')], 2, 'a double with its dot'),
        ([('kp: 2.0', 'kp: 2')], 2, "'gains.kp' to '2' of type 'INTEGER'"),
        ([("'1e5'", '1e5')], 2, 'a text that looks like a number in quotes'),
        ([('[10.0, 12.5]', '[10, 12.5]')], 0, 'must all be of one type'),
        ([('/**:', '/drive:')], 4, 'the key `/**` gives it to each node'),
        ([('  ros__parameters:\n', '')], 0, 'there is a value before ros__parameters'),
        ([('/camera:', '/kamera:')], 3, "it is `'none'`"),
    ],
    '9b': [
        ([("1': 0.5", "1': 1")], 5, 'ROS 1 would have stored it'),
        ([("2.0': None", "2.0': 2.0")], 5, 'a slash is not a dot'),
        ([("900': 100", "900': 300")], 5, 'would have bent it'),
        ([(': 3000000000', ': 0')], 5, 'ended at 32 bits'),
        ([("'green'\": None", "'green'\": 'green'")], 5, 'a stranger cannot'),
        ([("restarted': 100", "restarted': 200")], 5, 'no server'),
    ],
}
