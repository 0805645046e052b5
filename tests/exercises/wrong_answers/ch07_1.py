"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.1."""

# Lines of the steps, which the answers replace.
_KEY = '/driver:\n  ros__parameters:\n'
_PAIR = "('share/' + package_name + '/config', ['config/my_robot.yaml'])"
_XML = "('share/' + package_name, ['package.xml']),"

WRONG = {
    '7.1a': [
        ([('rate_hz: 20', 'rate_hz: 20\n    start_type_description_service: true\n    use_sim_time: false')],
         3, 'there is also `start_type_description_service`, `use_sim_time`'),
        ([('    rate_hz: 20\n', '')], 3, 'it is `10`'),
        ([('rate_hz: 20', 'rate_hz: 20.0')], 1, 'An integer has no dot'),
        ([('max_speed_mps: 0.8', 'max_speed_mps: 0.5')], 3, 'it is `0.5`'),
        ([('stop_distance_m: 0.6', 'stop_distance: 0.6')], 2, 'it is `0.5`'),
        ([('max_speed_mps: 0.8', 'max_speed_mps: 1')], 1, 'A double needs its dot'),
        ([('braking_mps2: 0.8', "braking_mps2: '0.8'")], 1, 'neither a comma nor quotes'),
        ([('stop_distance_m: 0.6', 'stop_distance_m: 0.2')], 1, '0.8 m/s takes 0.40 m to brake, not 0.2 m'),
        ([('/driver:', '/Driver:')], 0, 'Whom does its key name?'),
        ([('/driver:', '/my_robot/driver:')], 0, 'Whom does its key name?'),
        ([(_KEY, '/driver:\n')], 0, 'the file has no ros__parameters'),
        ([('    rate_hz', '\trate_hz')], 0, 'YAML allows no tab there'),
        ([('rate_hz: 20', 'rate_hz:20')], 0, 'A name ends with a colon and a space'),
        ([('    rate_hz: 20', '    rate_hz:')], 0, 'rate_hz has no value'),
    ],
    '7.1b': [
        ([(f'        {_PAIR},\n', '')], 2, 'no entry of `data_files` has `config/'),
        ([("package_name + '/config'", 'package_name')], 2, 'it goes to `share/my_robot/my_robot.yaml`'),
        ([("'share/' + package_name + '/config'", "'config'")], 2, 'it goes to `config/my_robot.yaml`'),
        ([("['config/my_robot.yaml']", "['my_robot.yaml']")], 0, 'there is no `my_robot.yaml`'),
        ([("['config/my_robot.yaml']", "'config/my_robot.yaml'")], 0, 'is no list'),
        ([(f'{_XML}\n', f'{_XML[:-1]}\n')], 0, "'tuple' object is not callable"),
        ([(f'{_PAIR},', f'{_PAIR[:-1]},')], 0, "closing parenthesis ']' does not match"),
        ([(f'        {_XML}\n', '')], 2, 'does not name it any more'),
        ([(_PAIR, "'config/my_robot.yaml'")], 0, 'too many values to unpack'),
    ],
    '7.1c': [
        ([("label: '1e5'", 'label: 1e5')], 6, 'A string that looks like a number'),
        ([("side: 'N'", 'side: N')], 6, 'To rcl this word is a boolean'),
        ([("['2e5', '3e5']", '[2e5, 3e5]')], 6, 'needs quotes of its own'),
        ([("['2e5', '3e5']", "'2e5, 3e5'")], 6, 'This is one string'),
        ([("['2e5', '3e5']", "['2e5', 3e5]")], 0, 'must all be of one type'),
        ([("side: 'N'", "side: 'N'\n    stops: []")], 6, 'it has no value'),
        ([("side: 'N'", "side: 'N'\n    stops: ['']")], 6, "it is `['']`"),
        ([("side: 'N'", "side: 'N'\n    firmware: ['AQ==', '/w==']")], 6, 'no notation for bytes'),
        ([('    range_m: 12.0\n', '')], 6, 'the default: the file has no `range_m`'),
        ([("    label: '1e5'\n", '')], 6, 'the default: the file has no `label`'),
        ([('range_m: 12.0', "range_m: '12.0'")], 6, 'neither a comma nor quotes'),
        ([('/courier', '/driver')], 0, 'Whom does its key name?'),
    ],
}

RIGHT = {
    '7.1a': [
        [('/driver', '/**')],
        [('/driver', 'driver')],
        [('    max_speed_mps: 0.8\n', ''), ('rate_hz: 20', 'rate_hz: 20\n    max_speed_mps: 8.0e-1  # slow')],
        # Another node has its block in the same file.
        [('rate_hz: 20', 'rate_hz: 20\n/tuner:\n  ros__parameters:\n    slow_mps: 0.3')],
    ],
    '7.1b': [
        [(_PAIR, "('share/my_robot/config', ['config/my_robot.yaml'])")],
        [("['config/my_robot.yaml']", "glob('config/*.yaml')"), ('from setuptools', 'from glob import glob\n\nfrom '
                                                                'setuptools')],
        [(_PAIR, "(os.path.join('share', package_name, 'config'), glob(os.path.join('config', '*.yaml')))"),
         ('from setuptools', 'import os\nfrom glob import glob\n\nfrom setuptools')],
        [('from setuptools import find_packages, setup', 'import setuptools'), ('\nsetup(', '\nsetuptools.setup('),
         ("find_packages(exclude=['test'])", '[package_name]')],
    ],
    '7.1c': [
        [("['2e5', '3e5']", "\n    - '2e5'\n    - '3e5'"), ("'1e5'", '"1e5"')],
        [("side: 'N'", "side: 'N'\n    start_type_description_service: true\n    use_sim_time: false")],
        [("label: '1e5'", 'label: !!str 1e5'), ('12.0', '12e0')],
    ],
}
