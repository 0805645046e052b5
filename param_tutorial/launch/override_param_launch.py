"""Start the robot with a file, and with values in the launch file that come after it."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Describe what to start."""
    share = get_package_share_directory('param_tutorial')
    return LaunchDescription([
        Node(
            package='param_tutorial',
            executable='simple_param_node',
            name='simple_param_node',
            output='screen',
            parameters=[
                os.path.join(share, 'config', 'clawbot_config.yaml'),
                {'max_speed_rpm': 200, 'enable_safety_mode': True},
            ],
        ),
    ])
