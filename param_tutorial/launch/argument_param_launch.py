"""Start the robot with values of your choice: add robot_name:=Berta or max_speed_rpm:=60 to the command."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    """Describe the arguments, and what to start with them.

    A launch reads the string of an argument as YAML. A name must stay a string, even 42: ``ParameterValue`` sees to it.
    """
    return LaunchDescription([
        DeclareLaunchArgument('robot_name', default_value='Clawbot', description='Name of the robot.'),
        DeclareLaunchArgument('max_speed_rpm', default_value='100', description='Maximum wheel speed in rpm.'),
        Node(
            package='param_tutorial',
            executable='simple_param_node',
            name='simple_param_node',
            output='screen',
            parameters=[{
                'robot_name': ParameterValue(LaunchConfiguration('robot_name'), value_type=str),
                'max_speed_rpm': LaunchConfiguration('max_speed_rpm'),
            }],
        ),
    ])
