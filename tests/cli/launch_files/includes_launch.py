"""Included files: their arguments stay set, and the file that was included last stays the current one."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource, PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import Node, PushRosNamespace, SetParametersFromFile

FOLDER = str(Path(__file__).parent)


def where(name):
    return Node(package='p', executable=name, parameters=[{
        'folder': ThisLaunchFileDir(), 'robot': LaunchConfiguration('robot', default='none')}])


def generate_launch_description():
    inner = PathJoinSubstitution([FOLDER, 'inner', 'inner_launch.py'])
    return LaunchDescription([
        DeclareLaunchArgument('wheels', default_value='4'),
        where('before'),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(inner), launch_arguments={
            'robot': ['claw', 'bot'], 'undeclared': 'x'}.items()),
        where('after'),
        GroupAction([
            PushRosNamespace('group'), SetParametersFromFile(f'{FOLDER}/inner/all.yaml'),
            IncludeLaunchDescription(AnyLaunchDescriptionSource(f'{FOLDER}/xml.launch.xml'),
                                     launch_arguments=[('robot', 'xml_bot')]),
            where('in_group')]),
        IncludeLaunchDescription(f'{FOLDER}/yaml.launch.yaml', launch_arguments=[('robot', 'yaml_bot')],
                                 condition=IfCondition('true')),
        IncludeLaunchDescription('/nowhere/x_launch.py', condition=IfCondition('false')),
        where('at_the_end'),
    ])
