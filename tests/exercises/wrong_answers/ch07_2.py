"""Wrong answers that people give, and unusual right ones, to the exercises of chapter 7.2."""

PATH = "PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'my_robot.yaml'])"
ENTRY = "        ('share/' + package_name + '/launch', ['launch/my_robot_launch.py']),\n"
CONFIG = "        ('share/' + package_name + '/config', ['config/my_robot.yaml']),\n"
DEPENDS = '  <exec_depend>ros2launch</exec_depend>\n'
ARGUMENT = ("        DeclareLaunchArgument('params_file', default_value=ours, "
            "description='The parameters of the driver.'),\n")
FILE = "ParameterFile(LaunchConfiguration('params_file'), allow_substs=True)"

WRONG = {
    '7.2a': [
        ([("package='my_robot'", "package='my_robots'")], 0, "package 'my_robots' not found"),
        ([("name='driver'", "name='my_driver'")], 1, 'it is 0.5. The check has put another'),
        ([("executable='driver_node'", "executable='driver'")], 0, "not found in package 'my_robot', which has driver"),
        ([("executable='driver_node'", "executable='driver_node.py'")], 0, "executable 'driver_node.py' not found"),
        ([('parameters=[ours]', "parameters=[{'max_speed_mps': 0.8}]")], 1, 'it is 0.8'),
        ([('parameters=[ours]', "parameters=[ours, {'max_speed_mps': 0.8}]")], 1, 'does no later source'),
        ([(', parameters=[ours]', '')], 1, 'it is 0.5'),
        ([('parameters=[ours]', 'parameters=ours')], 0, "expected 'parameters' to be a list"),
        ([('parameters=[ours]', "parameters=['config/my_robot.yaml']")], 1,
         'Parameter file path is not a file: config/my_robot.yaml'),
        ([("'my_robot.yaml'", "'my_robt.yaml'")], 1, 'Parameter file path is not a file'),
        ([("'config', 'my_robot.yaml'", "'my_robot.yaml'")], 1, 'Parameter file path is not a file'),
        ([("name='driver'", "name='driver', namespace='lab'")], 1, 'is the node called `driver`'),
        ([('    return LaunchDescription', '    LaunchDescription')], 0, 'must return a LaunchDescription'),
        ([('def generate_launch_description', 'def describe')], 0, "required function 'generate_launch_description()'"),
        ([('from launch_ros.actions import Node\n', '')], 0, "NameError: name 'Node' is not defined"),
        ([('    ])\n', '    )\n')], 0, 'SyntaxError'),
        ([('        Node(', "        Node(package='my_robot', executable='driver_node'),\n        Node(")], 0,
         'it starts `driver_node`, `driver_node`'),
        ([(PATH, "'/nowhere/my_robot.yaml'")], 1, 'Parameter file path is not a file: /nowhere'),
    ],
    '7.2b': [
        ([(ENTRY, '')], 1, 'no entry of `data_files` has `launch/my_robot_launch.py`'),
        ([(DEPENDS, '')], 1, 'there is none'),
        ([(CONFIG, '')], 1, 'no entry of `data_files` has `config/my_robot.yaml`'),
        ([("'/launch', [", "'/config', [")], 1, 'it goes to `share/my_robot/config/my_robot_launch.py`'),
        ([("['launch/my_robot_launch.py']", "['my_robot_launch.py']")], 0, 'there is no `my_robot_launch.py`'),
        ([(CONFIG, CONFIG.replace('),\n', ')\n'))], 0, "'tuple' object is not callable"),
        ([("'/launch', ['launch/my_robot_launch.py']", "'/launch', 'launch/my_robot_launch.py'")], 0,
         'is no list'),
        ([("'/launch', ['launch/my_robot_launch.py']", "'/launch'")], 0, 'too many values to unpack'),
        ([("'/launch', ['launch/my_robot_launch.py']", "'/launch', glob('launch/*.py')")], 0, "name 'glob' is not"),
        ([(DEPENDS, DEPENDS.replace('exec', 'test'))], 1, 'there is none. A `<test_depend>` says'),
        ([(DEPENDS, DEPENDS.replace('</exec', '<exec'))], 1, 'mismatched tag'),
        ([("'share/' + package_name + '/launch'", "package_name + '/launch'")], 1, 'it goes to `my_robot/launch'),
    ],
    '7.2c': [
        ([(ARGUMENT, '')], 0, "launch configuration 'params_file' does not exist"),
        ([('default_value=ours, ', '')], 0, 'Required launch argument "params_file"'),
        ([(f'[{FILE}]', '[ours]')], 2, 'Does `parameters` take the file from the argument?'),
        ([(f'[{FILE}]', "[LaunchConfiguration('params_file')]")], 3, 'the launch only warns: Parameter file path'),
        ([(', allow_substs=True', '')], 3, 'the launch only warns'),
        ([(f'[{FILE}]', f'[{FILE}, ours]')], 2, 'it is 0.65'),
        ([("'params_file'", "'param_file'")], 2, 'it declares `param_file`'),
        ([("('params_file'), ", "('params'), ")], 0, "launch configuration 'params' does not exist"),
        ([('default_value=ours', "default_value='my_robot.yaml'")], 0, 'No such file or directory: my_robot.yaml'),
        ([(FILE, "'params_file'")], 1, 'Parameter file path is not a file: params_file'),
        ([("name='driver'", "name='my_driver'")], 1, 'it is 0.5'),
    ],
}

RIGHT = {
    '7.2a': [
        [(PATH, "[FindPackageShare('my_robot'), '/config/my_robot.yaml']")],
        [("name='driver', ", '')],
        [(PATH, "__import__('pathlib').Path(__file__).parents[1] / 'config' / 'my_robot.yaml'")],
        [('    ours =', '    from ament_index_python.packages import get_package_share_directory as share\n    ours ='),
         (PATH, "share('my_robot') + '/config/my_robot.yaml'")],
        [("name='driver'", "name='driver', output='screen', namespace=''")],
    ],
    '7.2b': [
        [("['launch/my_robot_launch.py']", "glob('launch/*')"),
         ('from setuptools', 'from glob import glob\n\nfrom setuptools')],
        [('>ros2launch<', '>launch_ros<')],
        [(DEPENDS, DEPENDS.replace('exec_', ''))],
        [('from setuptools import find_packages, setup', 'import setuptools'), ('\nsetup(', '\nsetuptools.setup('),
         ("find_packages(exclude=['test'])", '[package_name]')],
    ],
    '7.2c': [
        [('default_value=ours', "default_value=[FindPackageShare('my_robot'), '/config/my_robot.yaml']")],
        [(", description='The parameters of the driver.'", '')],
    ],
}
