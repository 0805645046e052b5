"""Start the robot with the parameters of a file: ros2 launch param_tutorial simple_param_launch.py."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Describe what to start. Nothing has been started when this returns."""
    share = get_package_share_directory('param_tutorial')
    return LaunchDescription([
        Node(
            package='param_tutorial',
            executable='simple_param_node',
            name='simple_param_node',
            output='screen',
            parameters=[os.path.join(share, 'config', 'clawbot_config.yaml')],
        ),
    ])
