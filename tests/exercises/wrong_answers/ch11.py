"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 11."""

_SECOND = "        for name in ('left', 'right')\n"

WRONG = {
    '11a': [
        ([('<version>1.0.0</version>', '<version>1.0</version>')], 2, 'it says `1.0`'),
        ([("version='1.0.0'", "version='0.0.0'")], 2, "it says `'0.0.0'`"),
        ([("version='1.0.0'", 'version=1.0')], 2, 'it says `1.0`'),
        ([('  <exec_depend>sensor_msgs</exec_depend>\n', '')], 2, '`driver_node.py` imports `sensor_msgs`'),
        ([('    version=', '    version==')], 1, '(setup.py, line 30)'),
        ([('<exec_depend>sensor_msgs<', '<test_depend>sensor_msgs<'), ('sensor_msgs</exec', 'sensor_msgs</test')], 2,
         'A `<test_depend>` says something else'),
        ([('</version>', '<version>')], 0, 'mismatched tag: line '),
    ],
    '11b': [
        ([(_SECOND, "        for name in ('left',)\n")], 1, 'it starts `/left/driver`'),
        ([(_SECOND, "        for name in ('left', 'left')\n")], 1, 'it starts `/left/driver` and `/left/driver`'),
        ([("{'namespace': name}", "{'namespaces': name}")], 1, 'it starts `/driver` and `/driver`'),
        ([("'my_robot_launch.py'])\n", "'my_robot.launch.py'])\n")], 1, 'my_robot.launch.py'),
        ([('.items())\n', ')\n')], 1, 'ValueError: too many values to unpack'),
        ([(", 'launch/two_robots_launch.py'", '')], 2, 'no entry of `data_files` has `launch/two'),
        ([(", 'launch/two_robots_launch.py'", ''), ('\nsetup(', "\n# 'launch/two_robots_launch.py'\nsetup(")], 2,
         'no entry of `data_files` has `launch/two'),
        ([('def generate_launch_description', 'def generate_description')], 1, 'generate_launch_description'),
    ],
    '11c': [
        ([("'stop_distance_m': 1.2", "'stop_distance_m': 0.6")], 1, 'it hits the wall at'),
        ([("'max_speed_mps': 1.0", "'max_speed_mps': 0.5"), ("'stop_distance_m': 1.2", "'stop_distance_m': 0.4")], 3,
         'it takes '),
        ([("'stop_distance_m': 1.2", "'stop_distance_m': 2.0")], 3, 'from the wall'),
        ([("'max_speed_mps': 1.0", "'max_speed_mps': 1")], 0, 'Wrong parameter type'),
        ([("    'max_speed_mps': 1.0,\n    'stop_distance_m': 1.2,\n", '')], 0, 'there is no setting yet'),
    ],
}

RIGHT = {
    '11a': [[("version='1.0.0'", 'version="1.0.0"')]],
    '11b': [[(_SECOND, "        for name in ('right', 'left')\n")]],
    '11c': [[("'max_speed_mps': 1.0", "'max_speed_mps': 1.2"), ("'stop_distance_m': 1.2", "'stop_distance_m': 1.65")]],
}
