"""Start the pallet lift with the values of the robot that is meant: add robot:=physical to the command."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    """Describe the argument, and what is to be started with it."""
    config = os.path.join(get_package_share_directory('param_tutorial'), 'config')
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='sim', choices=['sim', 'physical'], description='Which lift.'),
        Node(
            package='param_tutorial',
            executable='pallet_lift_node',
            name='pallet_lift_node',
            output='screen',
            # One path in three parts, of which the middle one is known only at the start.
            parameters=[[os.path.join(config, 'pallet_lift_'), LaunchConfiguration('robot'), '.yaml']],
        ),
    ])
