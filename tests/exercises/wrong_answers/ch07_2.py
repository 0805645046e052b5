"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.2."""

WRONG = {
    '7.2c': [
        ([("'param_tutorial'", "'param_tutorials'")],
         0, 'LaunchFailed: [ERROR] [launch]: Caught exception in launch'),
        ([("executable='simple_param_node'", "executable='simple_node'")],
         0, 'LaunchFailed: [ERROR] [launch]: Caught exception in launch'),
        ([('150', "'150'")], 0, 'its constructor did not get to its end.'),
        ([("'Berta'", '...')], 0, 'LaunchFailed: [ERROR] [launch]: Caught exception in launch'),
        ([("'Berta'", "'Bertha'")], 2, "it is `'Bertha'`"),
        ([('150', '15')], 2, 'it is `15`'),
        ([("'max_speed_rpm': 150, ", '')], 2, 'it is `100`'),
        ([('            parameters', '            params')],
         0, 'LaunchFailed: Caught exception when trying to load file of'),
        ([('    ])\n', '    )\n')], 0, 'LaunchFailed: Caught exception when trying to load file of'),
    ],
    '7.2a': [
        ([("PathJoinSubstitution([FindPackageShare('param_tutorial'), 'config', 'clawbot_config.yaml']),", '')], 2,
         'Is the file in `parameters`'),
        ([('clawbot_config.yaml', 'clawbot.yaml')], 2, 'Is the file in `parameters`'),
        ([("name='simple_param_node'", "name='clawbot'")], 2, 'is it for this node?'),
        ([("                    'enable_safety_mode': True,\n", '')], 3, 'Of two sources the later one wins'),
        ([("LaunchConfiguration('max_speed_rpm')", '90')], 3, 'Is the argument used?'),
        ([(", default_value='90'", '')], 0, 'Required launch argument "max_speed_rpm" was not provided'),
        ([("ParameterValue(LaunchConfiguration('serial'), value_type=str)", "LaunchConfiguration('serial')")], 3,
         'What is typed is read as YAML'),
        ([("'robot_serial_number'", "'serial_number'")], 3, 'The parameter is called `robot_serial_number`'),
        ([("executable='simple_param_node'", "executable='simple_param'")], 0, 'No executable found'),
        ([('return LaunchDescription([', 'LaunchDescription([')], 0, 'must return a LaunchDescription'),
        ([('def generate_launch_description', 'def describe')], 0, 'does not contain a required function'),
    ],
    '7.2b': [
        ([("config]': 180", "config]': 100")], 6, 'The file is for `/simple_param_node`'),
        ([('200}]": 200', '200}]": 180')], 6, 'Which source is the later one?'),
        ([('config]": 180', 'config]": 200')], 6, 'Which source is the later one?'),
        ([('\'berta\'": 100', '\'berta\'": 180')], 6, 'For whom is the file?'),
        ([('.yaml\']": 100', '.yaml\']": \'dead\'')], 6, 'a warning and no error'),
        ([("'dead'", '200')], 6, 'There are quotes around it'),
        ([('200}]": 180', '200}]": 200')], 6, 'Is there a parameter of that name?'),
    ],
}

RIGHT = {
    '7.2c': [
        [("[{'max_speed_rpm': 150, 'robot_name': 'Berta'}]",
          "[{'max_speed_rpm': 150}, {'robot_name': 'Berta'}]")],
        [("            name='simple_param_node',\n", '')],
        [("'Berta'", "'Ber' + 'ta'"),
         ('150', 'int(1.5e2)')],
    ],
}
