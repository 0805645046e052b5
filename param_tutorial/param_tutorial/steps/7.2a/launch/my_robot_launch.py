from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    ours = PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'my_robot.yaml'])
    return LaunchDescription([
        Node(package='my_robot', executable='driver_node', name='driver', parameters=[ours]),
    ])
