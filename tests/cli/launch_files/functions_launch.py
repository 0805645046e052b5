"""Functions and environment variables."""

from launch import LaunchDescription
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    OpaqueFunction,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
)
from launch.substitutions import EnvironmentVariable, LaunchConfiguration
from launch_ros.actions import Node, SetParameter


def make(context, count, *, prefix):
    from launch.actions import LogInfo

    speed = LaunchConfiguration('speed').perform(context)
    context.launch_configurations['from_function'] = speed
    also = context.perform_substitution(EnvironmentVariable('TRY', default_value='unset'))
    return [LogInfo(msg='made'), *(Node(package='p', executable=f'{prefix}{number}', parameters=[
        {'speed': int(speed), 'also': also}]) for number in range(count))]


def variable(name):
    return Node(package='p', executable=name, parameters=[{
        'try': EnvironmentVariable('TRY', default_value='unset'),
        'path': EnvironmentVariable('TRY_PATH', default_value='')}])


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='60'),
        OpaqueFunction(function=make, args=[2], kwargs={'prefix': 'made_'}),
        OpaqueFunction(function=lambda context: None),
        Node(package='p', executable='after', parameters=[{'given': LaunchConfiguration('from_function')}]),
        SetEnvironmentVariable('TRY', '1'), AppendEnvironmentVariable('TRY_PATH', 'a'),
        AppendEnvironmentVariable('TRY_PATH', 'b'), AppendEnvironmentVariable('TRY_PATH', 'c', prepend=True),
        AppendEnvironmentVariable('TRY_PATH', 'd', separator=';'),
        variable('set'),
        GroupAction([SetEnvironmentVariable('TRY', '2'), variable('in_group')]),
        variable('after_group'),
        SetParameter('set_at_last', True),
        SetLaunchConfiguration('speed', '2'),
        ExecuteProcess(cmd=['echo', ['speed ', LaunchConfiguration('speed')], 'a b']),
        Node(executable='/usr/bin/program', arguments=['--x'], ros_arguments=['--log-level', 'debug'],
             prefix='nice -n 5'),
    ])
