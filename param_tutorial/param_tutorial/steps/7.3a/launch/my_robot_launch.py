from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    ours = PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'my_robot.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('params_file', default_value=ours, description='The parameters of the driver.'),
        DeclareLaunchArgument('namespace', default_value='', description='The name of the robot.'),
        Node(package='my_robot', executable='driver_node', name='driver', namespace=LaunchConfiguration('namespace'),
             parameters=[ParameterFile(LaunchConfiguration('params_file'), allow_substs=True)]),
    ])
