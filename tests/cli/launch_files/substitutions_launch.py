"""Each substitution as the value of a parameter."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import (
    AndSubstitution,
    Command,
    EqualsSubstitution,
    FileContent,
    IfElseSubstitution,
    LaunchConfiguration,
    NotEqualsSubstitution,
    NotSubstitution,
    PythonExpression,
)
from launch_ros.actions import Node, SetParameter
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import Parameter

FILE = str(Path(__file__).parent / 'inner/all.yaml')


def generate_launch_description():
    mode, speed = LaunchConfiguration('mode'), LaunchConfiguration('speed')
    return LaunchDescription([
        DeclareLaunchArgument('mode', default_value='slow'), DeclareLaunchArgument('speed', default_value='1'),
        DeclareLaunchArgument('robot', default_value='claw'), SetParameter('global', 'text'),
        Node(package='p', executable='e', parameters=[{
            'equals': EqualsSubstitution(mode, 'slow'), 'as_booleans': EqualsSubstitution(speed, 'TRUE'),
            'as_numbers': EqualsSubstitution(speed, 1.0), 'with_bool': EqualsSubstitution(speed, True),
            'with_none': EqualsSubstitution('', None), 'not_equals': NotEqualsSubstitution(mode, 'slow'),
            'not': NotSubstitution(speed), 'and': AndSubstitution(speed, 'off'),
            'if': IfElseSubstitution(speed, 'fast', mode), 'else': IfElseSubstitution('no', 'fast'),
            'python': PythonExpression(['"', mode, '" == "slow" and ', speed, ' + pi > 4']),
            'list': PythonExpression(['[', speed, '.0, 2.5]']),
            'command': Command(['echo -n ', mode]), 'content': FileContent(FILE.replace('all.yaml', 'number')),
            'default': LaunchConfiguration('nobody', default=5),
            'parts': LaunchConfiguration('nobody', default=['a', 1]),
            'parameter': Parameter('global'), 'no_parameter': Parameter('nobody', default='x')}]),
        Node(package='p', executable='f', parameters=[ParameterFile(FILE, allow_substs=True)]),
    ])
