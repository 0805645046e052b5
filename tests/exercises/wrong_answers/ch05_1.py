"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 5.1."""

WRONG = {
    '5.1a': [
        ([('wall_m 20.0', 'wall_m 20')], 2, 'it is `10.0`. Has a line set it'),
        ([('/driver max_speed_mps', '/base max_speed_mps')], 2, 'it is `0.5`. Has a line set it'),
        ([('stop_distance_m 2.0', 'stop_distance_m 2,0')], 2, 'it is `0.5`. Has a line set it'),
        ([('max_speed_mps 1.2', 'max_speed_mps 12.0')], 2, 'it is `0.5`'),
        ([('max_speed_mps 1.2', 'max_speed_mps = 1.2')], 2, 'it is `0.5`'),
        ([('%ros2 param set /base wall_m 20.0\n', '')], 2, 'it is `10.0`'),
        ([('wall_m 20.0', 'wall_m 18.0')], 2, 'it is `18.0`'),
    ],
    '5.1b': [
        ([('retries 10', 'retries 10.0')], 4, 'it is `3`. An integer is written with digits only'),
        ([('1.0e-3', '1e-3')], 4, 'it is `0.5`. A double needs a dot, and with an exponent also a sign'),
        ([('label "\'42\'"', "label '42'")], 4, "it is `'none'`. A string that looks like a number"),
        ([('mode "\'off\'"', 'mode off')], 4, "it is `'auto'`. To YAML 1.1 this word means false"),
        ([('"[1.0, 2.5]"', '"[1, 2.5]"')], 4, 'all its elements need the same type'),
        ([('retries 10', 'retries 010')], 4, 'it is `8`. An integer is written with digits only, and without a zero'),
        ([('label "\'42\'"', 'label "\\"\'42\'\\""')], 4, 'it is `"\'42\'"`'),
        ([('"[1.0, 2.5]"', '[1.0, 2.5]')], 4, 'quotes keep it together'),
        ([('[1.0, 2.5]', '[2.5, 1.0]')], 4, 'it is `[2.5, 1.0]`'),
        ([('retries 10', 'retries "10')], 4, 'it is `3`'),
    ],
    '5.1c': [
        ([('/driver max_speed_mps', '/driver max_sped_mps')], 3, 'Is its name spelled as the driver spells it?'),
        ([('stop_distance_m 1.5', 'stop_distance_m 1,5')], 3, 'Which type, or which limit, did the rejection name?'),
        ([('wall_m 50.0', 'wall_m 50')], 3, 'A rejection names both ends of the range, or both types'),
        ([('/base command', '/bass command')], 3, 'Is the node spelled as `node list` spells it'),
        ([('wall_m 50.0', 'wall_m 49.9')], 3, 'it is `49.9`'),
    ],
    '5.1d': [
        ([('mps: 1.0', "mps: '1.0'")], 1, "to '1.0' of type 'STRING'"),
        ([('distance_m: 2.0', 'distance_m: 2')], 0, "expected 'Type.DOUBLE' got 'Type.INTEGER'"),
        ([('mps: 1.0', 'mps: 1e0')], 1, "expected 'Type.DOUBLE' got 'Type.STRING'"),
        ([('/driver:', '/drive:')], 1, 'the file has another value for it, or is for another node'),
        ([('  ros__parameters', 'ros__parameters')], 0, 'it cannot'),
        ([('    max_speed', '\tmax_speed')], 0, 'YAML allows no tab there'),
        ([('    stop_distance_m: 2.0\n', '')], 0, 'it is `0.5`'),
        ([('distance_m: 2.0', 'distance_m 2.0')], 0, "could not find expected ':'"),
        ([('max_speed_mps', 'max_speed')], 0, 'Set parameter max_speed failed'),
    ],
}

RIGHT = {
    '5.1a': [
        [('/base wall_m', 'base wall_m'), ('set /driver max', 'set --timeout 5 /driver max')],
        [('max_speed_mps 1.2', 'max_speed_mps "1.2"  # m/s'), ('m 2.0', 'm 2.')],
    ],
    '5.1b': [
        [('1.0e-3', '.001'), ('retries 10', 'retries +10')],
        [('1.0e-3', '0.001'), ('retries 10', 'retries 0xA')],
        [('"\'42\'"', '\'"42"\''), ('"\'off\'"', '\\"off\\"')],
        [('"\'42\'"', '"!!str 42"'), ('"[1.0, 2.5]"', '[1.0,2.5]')],
    ],
    '5.1d': [
        [('/driver:', 'driver:')],
        [('/driver:', '/**:'), ('mps: 1.0', 'mps: 1.')],
        [('\n    max_speed_mps: 1.0\n    stop_distance_m: 2.0', ' {max_speed_mps: 1.0, stop_distance_m: 2.0}')],
    ],
}
