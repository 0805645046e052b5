"""What colcon installs: the two import packages, the nodes as programs for `ros2 run`, and the files they load.

pip reads pyproject.toml one folder up instead.
"""

import re
from glob import glob
from pathlib import Path

from setuptools import find_packages, setup

PACKAGE = 'param_tutorial'
# Where both pyproject.toml find it, too.
VERSION = re.search("^__version__ = '(.+)'$", Path('param_tools/__init__.py').read_text(), re.MULTILINE)[1]
NODES = ('simple_param_node', 'param_setter_node', 'param_event_monitor', 'param_query_node',
         'pid_controller_node', 'base_node', 'driver_node')

setup(
    name=PACKAGE,
    version=VERSION,
    packages=find_packages(include=['param_t*']),
    package_data={'': ['**/*.css', '**/*.js', '**/*.xml', '**/*.txt', 'steps/**/*', 'py.typed']},
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
        'param_tools.packages': [f'{PACKAGE} = {PACKAGE}.nodes'],
    },
)
