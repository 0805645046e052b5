"""The layer: where it may be installed, that it needs no numpy, and that it does as the real one."""

import subprocess
import sys

import pytest
import rclpy

from param_tools.errors import LayerError
from param_tools.rcl_in_python.install import install, is_installed
from tests.support.paths import ROOT
from tests.support.processes import output_of

BEGIN = '''
import sys
from param_tools.rcl_in_python.install import install
install(even_beside_the_real_one=True)
'''


def test_it_is_not_installed_beside_the_real_one():
    assert 'without_network' not in rclpy.get_rmw_implementation_identifier()
    with pytest.raises(LayerError, match='imported already'):
        install()
    assert not is_installed()
    other = subprocess.run([sys.executable, '-c', 'from param_tools.rcl_in_python.install import install; install()'],
                           capture_output=True, text=True)
    assert 'LayerError: the real rclpy is installed here' in other.stderr


def test_what_is_not_part_of_it_says_so():
    assert output_of(BEGIN + '''
import rclpy
from rclpy.action import ActionClient
from rclpy.experimental import EventsExecutor
from rclpy.lifecycle import LifecycleNode
rclpy.init(args=[])
for attempt in (EventsExecutor, lambda: LifecycleNode('node')):
    try:
        attempt()
    except NotImplementedError as error:
        print(error)
''').count('not part of rclpy in Python') == 2


def test_where_there_is_no_numpy_messages_get_what_they_use_of_it():
    assert output_of(BEGIN + '''
from importlib.machinery import PathFinder
find_spec = PathFinder.find_spec
PathFinder.find_spec = lambda name, *more: None if name == 'numpy' else find_spec(name, *more)
from geometry_msgs.msg import Twist, Vector3
from sensor_msgs.msg import Range
from service_msgs.msg import ServiceEventInfo
from rclpy.serialization import deserialize_message, serialize_message
info = ServiceEventInfo(client_gid=range(16), sequence_number=7)
print(deserialize_message(serialize_message(info), ServiceEventInfo) == info, info == ServiceEventInfo())
print(deserialize_message(serialize_message(Twist(linear=Vector3(x=0.1))), Twist).linear.x,
      deserialize_message(serialize_message(Range(range=0.1)), Range).range)
print(sys.modules['numpy'].__doc__.startswith('As much of numpy'))
''') == 'True False\n0.1 0.10000000149011612\nTrue\n'


@pytest.mark.thorough
@pytest.mark.timeout(300)
def test_what_the_real_one_passes_the_layer_passes():
    """The tests of rclpy's behavior that are written here; tests/README.md says how to run rclpy's own."""
    # Stops at the first that fails: of a broken layer, many would wait for a minute each.
    done = subprocess.run([sys.executable, '-m', 'pytest', '-p', 'tests.support.rcl_in_python', '-x', '-n', '2',
                           '--dist', 'loadscope', 'tests/conformance', 'tests/node', 'tests/ros/test_services.py'],
                          cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
