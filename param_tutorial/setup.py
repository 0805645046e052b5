"""What colcon installs: the import package, its nodes as programs for `ros2 run`, the files they load, and its commands
as extensions of `ros2`.

pip reads pyproject.toml one folder up instead.
"""

from glob import glob

from setuptools import find_packages, setup

PACKAGE = 'param_tutorial'
NODES = ('simple_param_node', 'param_setter_node', 'param_event_monitor', 'param_query_node', 'clawbot_node',
         'pallet_lift_node', 'pid_controller_node', 'cart_node')

setup(
    name=PACKAGE,
    version='0.1.0',
    packages=find_packages(include=[PACKAGE, f'{PACKAGE}.*']),
    package_data={PACKAGE: ['**/*.css', '**/*.js', 'runtime/*.xml', 'pictures/ros1_recording.txt']},
    data_files=[
        ('share/ament_index/resource_index/packages', [f'resource/{PACKAGE}']),
        (f'share/{PACKAGE}', ['package.xml']),
        (f'share/{PACKAGE}/launch', glob('launch/*.py')),
        # config/ stands at the top of the course, where learners find it, and not inside the ROS package.
        (f'share/{PACKAGE}/config', glob('../config/*.yaml')),
    ],
    install_requires=['setuptools'],
    zip_safe=False,  # Fast DDS opens fastdds.xml and fastdds_this_host.xml by their paths
    description="The nodes, panel and tools of the course 'Mastering ROS 2 Parameters with Python'",
    license='Apache-2.0',
    entry_points={
        # Not each node's own main(): a signal would find it unprepared until it spins.
        'console_scripts': [f'{node} = {PACKAGE}.nodes.__main__:program' for node in NODES],
        'ros2cli.command': [
            'param_check = param_tutorial.ros2.extension:CheckCommand',
            'param_describe = param_tutorial.ros2.extension:DescribeCommand',
            'param_diff = param_tutorial.ros2.extension:DiffCommand',
            'param_history = param_tutorial.ros2.extension:HistoryCommand',
            'param_restore = param_tutorial.ros2.extension:RestoreCommand',
            'param_snapshot = param_tutorial.ros2.extension:SnapshotCommand',
            'param_watch = param_tutorial.ros2.extension:WatchCommand',
        ],
    },
)
