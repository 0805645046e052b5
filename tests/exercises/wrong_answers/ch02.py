"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 2."""

PRINT = "print('I drive my_robot.')"
_SAID = '<description>A robot that stops in front of a wall, and whose parameters say how.'

WRONG = {
    '2a': [
        ([(_SAID, '<description>TODO: say it')], 2, 'it says `TODO: say it`'),
        ([('  <license>Apache-2.0</license>\n', '')], 2, 'it is empty, or missing'),
        ([('  <exec_depend>sensor_msgs</exec_depend>\n', '')], 2, 'there is none for `sensor_msgs`'),
        ([('<exec_depend>rclpy</exec_depend>', '<build_depend>rclpy</build_depend>')], 2,
         'there is none for `rclpy`. A `<build_depend>` says something else'),
        ([('<exec_depend>rclpy</exec_depend>', '<exec_depend>rclpy<exec_depend>')], 0,
         'mismatched tag: line 19, column 2: `</package>`'),
        ([('<exec_depend>rclpy', '<exec_depend>rclpy geometry_msgs'), ('  <exec_depend>geometry_msgs</exec_depend>\n',
                                                                     '')], 2, 'none for `rclpy`, `geometry_msgs`'),
        ([('<name>my_robot', '<name>robot')], 0, 'it says `robot`'),
        ([('  <test_depend>python3', '  <test_depend>ament_pep257</test_depend>\n  <test_depend>python3')], 2,
         'there are still `ament_pep257`'),
        ([('    <build_type>ament_python</build_type>\n', '')], 0, 'it says ``'),
        ([(_SAID, '<description> ')], 2, 'it is empty, or missing'),
        ([(_SAID, '<description>speed < 2')], 0, 'not well-formed'),
    ],
    '2b': [
        ([('cd ~/ros2_ws\n', ''), ('colcon build\n', 'colcon build\ncd ~/ros2_ws\n')],
         0, 'it is not there, but in `~/install`'),
        ([('colcon build\n', ''), ('source install/setup.bash\n', 'source install/setup.bash\ncolcon build\n')],
         1, 'it does not. You can source a file only when it is there'),
        ([('source install/setup.bash\n', ''), ('driver_node\n', 'driver_node\nsource install/setup.bash\n')],
         2, "it does not start; the terminal says `Package 'my_robot' not"),
        ([('source install/setup.bash\n', '')], 1, 'it does not'),
        ([('colcon build\n', '')], 0, 'it is not there'),
        ([('cd ~/ros2_ws\n', 'cd ~/ros2_ws/src\n')], 0, 'it is not there, but in `~/ros2_ws/src/install`'),
        ([('colcon build', 'colcon build --packages-select driver_node')], 0, 'no package that it should build'),
        ([('driver_node', 'driver')], 2, 'it does not start; the terminal says `No executable found`'),
        ([('ros2 run my_robot driver_node', 'echo Hi from my_robot.')], 2, 'it does not start'),
        ([('cd ~/ros2_ws\n', 'exit\n')], 0, "'exit\\ncolcon build"),
    ],
    '2c': [
        ([('go_up = lift', 'lift')], 0, 'it is `lift.cabin:start`'),
        ([('go_up =', 'cabin =')], 1, 'there is `lib/lift/cabin`'),
        ([('lift.cabin:start', 'cabin:start')], 2, "No module named 'cabin'"),
        ([(':start', ':stop')], 2, 'it prints `The lift stops.`'),
        ([('cabin:start', 'cabin.py:start')], 2, "'lift.cabin' is not a package"),
        ([('cabin:start', 'cabin:main')], 2, "has no attribute 'main'"),
        ([('go_up = lift.cabin:start', 'lift.cabin:start = go_up')], 0, 'it is `lift.cabin:start = go_up`'),
    ],
    '2d': [
        ([(PRINT, "print('Hi from my_robot.')")], 0, 'it prints `Hi from my_robot.`'),
        ([('def main', 'def start'), ('    main()', '    start()')], 0, "has no attribute 'main'"),
        ([(PRINT, PRINT[:-1])], 0, 'SyntaxError'),
        ([(PRINT, 'pass')], 0, 'it prints nothing'),
        ([("            'driver_node = my_robot.driver_node:main'\n", '')], 0, 'there is none'),
        ([("        ('share/ament_index/resource_index/packages',\n            ['resource/' + package_name]),\n", '')],
         0, 'the build installs none'),
        ([("['resource/' + package_name]", '[package_name]')], 0, "can't copy 'my_robot'"),
        ([('<name>my_robot', '<name>robot')], 0, 'it says `robot`'),
        ([('\nsetup(', '\nwhile True: pass\nsetup(')], 0, 'it is still running after 8 s'),
    ],
}

RIGHT = {
    '2a': [
        [('<exec_depend>rclpy</exec_depend>', '<depend>rclpy</depend>')],
        [(_SAID, '<description>\n    Drives.\n  '), ('Apache-2.0', 'MIT')],
    ],
    '2b': [
        [('source install/setup.bash\n', '. install/setup.bash\n')],
        [('source install/setup.bash\n', 'cd install\nsource setup.bash\n'),
         ('driver_node\n', 'driver_node &\nwait\n')],
        [('source install/setup.bash\nros2', 'cd; . ~/ros2_ws/install/setup.bash\nros2')],
        [('cd ~/ros2_ws\ncolcon build\nsource install/setup.bash\n',
          'cd ros2_ws && colcon build && source install/setup.bash\n')],
        [('colcon build\n', 'colcon build --symlink-install\n')],
        [('colcon build\n', 'colcon build --packages-select my_robot > /dev/null\n'),
         ('source install/setup.bash', 'source install/local_setup.bash')],
    ],
    '2c': [
        [('go_up = ', 'go_up=')],
        [("'go_up = lift.cabin:start'", '"\'go_up = lift.cabin:start\',"')],
    ],
    '2d': [
        [(PRINT, 'robot = "my_robot"\n    print(f"I drive {robot}.")')],
        [("'driver_node = my_robot.driver_node:main'", "'driver_node=my_robot.driver_node:main', 'd = my_robot:x'")],
        [("packages=find_packages(exclude=['test'])", "packages=['my_robot']")],
    ],
}
