from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    one = PathJoinSubstitution([FindPackageShare('my_robot'), 'launch', 'my_robot_launch.py'])
    return LaunchDescription([
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(one), launch_arguments={'namespace': name}.items())
        for name in ('left', 'right')
    ])
