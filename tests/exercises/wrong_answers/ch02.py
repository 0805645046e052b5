"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 2."""

WRONG = {
    '2c': [
        ([('cd ~/ros2_ws\n', ''),
          ('colcon build\n', 'colcon build\ncd ~/ros2_ws\n')],
         0, 'it is not. `colcon build` builds what is in `src` of the'),
        ([('colcon build\n', ''),
          ('source install/setup.bash\n', 'source install/setup.bash\ncolcon build\n')],
         1, 'it does not. A file can be sourced only when it is there'),
        ([('source install/setup.bash\n', ''),
          ('ros2 run lift lift_node\n', 'ros2 run lift lift_node\nsource install/setup.bash\n')],
         2, "it does not say so; the terminal says `Package 'lift' not"),
        ([('source install/setup.bash\n', '')], 1, 'it does not'),
        ([('colcon build\n', '')], 0, 'it is not'),
        ([('cd ~/ros2_ws\n', ''),
          ('ros2 run lift lift_node\n', 'ros2 run lift lift_node\ncd ~/ros2_ws\n')],
         0, 'it is not. `colcon build` builds what is in `src` of the'),
        ([('lift_node', 'lift')], 2, 'it does not say so; the terminal says `No executable found`'),
        ([('~/ros2_ws', 'ros2')], 0, 'it is not. `colcon build` builds what is in `src` of the'),
        ([('source install', 'bash install')], 1, 'it does not'),
        ([('source install', 'source build')], 1, 'it does not. A file can be sourced only when it is there'),
    ],
    '2a': [
        ([("['resource/lift']", "['lift']")], 0, "can't copy 'lift'"),
        ([("        ('share/ament_index/resource_index/packages', ['resource/lift']),\n", '')], 3,
         'what is installed in `share` is `share/lift/package.xml`'),
        ([("'lift_node = ", "'lift = ")], 3, 'No executable found'),
        ([('lift.lift_node:main', 'lift:main')], 4, "has no attribute 'main'"),
        ([("'0.0.0',", "'0.0.0'")], 0, 'SyntaxError'),
        ([('\nsetup(', '\ndict(')], 0, 'does it call `setup(...)`?'),
    ],
    '2b': [
        ([("(prefix / 'share/ament_index/resource_index/packages' / package).exists()", 'True')], 2,
         'Without the marker, ROS does not know of the package'),
        ([("'share/ament_index/resource_index/packages' / package", "'share' / package")], 1,
         "Package 'lift' not found"),
        ([("path if path.exists() else 'No executable found'", 'path')], 2, '`first/lib/lift/lift_node`'),
        ([("            return path if path.exists() else 'No executable found'",
           '            if path.exists():\n                return path')], 2, 'looks no further'),
        ([('in prefixes', 'in reversed(prefixes)')], 3, 'hides the other'),
    ],
}

RIGHT = {
    '2c': [
        [('source install/setup.bash\n', '. install/setup.bash\n')],
        [('source install/setup.bash\n', ''),
         ('cd ~/ros2_ws\n', 'cd ~/ros2_ws\n'),
         ('ros2 run lift lift_node\n', 'cd; . ~/ros2_ws/install/setup.bash\nros2 run lift lift_node\n')],
        [('cd ~/ros2_ws\ncolcon build\nsource install/setup.bash\n',
          'cd ros2_ws && colcon build && source install/setup.bash\n')],
        [('colcon build\n', 'colcon build --symlink-install\n')],
    ],
}
