"""Groups: what they set ends with them, but for a list that was there before."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetLaunchConfiguration
from launch.conditions import IfCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace, SetParameter, SetRemap


def node(name, **options):
    return Node(package='p', executable=name, name=name, parameters=[{'own': 1}], **options)


def generate_launch_description():
    speed = LaunchConfiguration('speed')
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='60'),
        GroupAction([PushRosNamespace('lab'), SetParameter('first', 1), SetRemap('a', 'b'), node('in_group')]),
        node('after_group'),
        SetParameter('second', [speed, '0']),
        GroupAction([
            PushRosNamespace('/floor/'), PushRosNamespace(['room_', speed]), SetParameter('third', ['a', 'b']),
            SetLaunchConfiguration('speed', '99'), node('nested', namespace='desk'),
            node('absolute', namespace='/else'),
            GroupAction([PushRosNamespace('/'), node('at_root')]), Node(package='p', executable='unnamed'),
            node('number'),
        ]),
        node('with_leak', namespace='n'),
        GroupAction([SetLaunchConfiguration('speed', '7')], scoped=False),
        Node(package='p', executable='unscoped', parameters=[{'speed': speed}]),
        node('one', condition=IfCondition('1')), node('two', condition=IfCondition(' FALSE ')),
        node('three', condition=UnlessCondition('0')), node('four', condition=UnlessCondition('True')),
        node('five', condition=LaunchConfigurationEquals('speed', '7')),
        node('six', condition=LaunchConfigurationEquals('nobody', None)),
        node('seven', condition=LaunchConfigurationNotEquals('speed', '7')),
        node('eight', condition=LaunchConfigurationNotEquals('nobody', 'x')),
        GroupAction([node('nine')], condition=IfCondition('false')),
    ])
