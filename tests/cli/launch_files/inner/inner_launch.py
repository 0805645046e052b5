"""Included by includes_launch.py."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('robot'), DeclareLaunchArgument('wheels', default_value='6'),
        DeclareLaunchArgument('color', default_value='gray', choices=['gray', 'red']),
        Node(package='p', executable='inner', parameters=[{name: LaunchConfiguration(name) for name in (
            'robot', 'wheels', 'color', 'undeclared')}])])
