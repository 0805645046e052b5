"""The layer: where it may be installed, that it needs neither threads nor numpy, and that it does as the real one."""

import subprocess
import sys

import pytest
import rclpy

from param_tools.errors import LayerError
from param_tools.rcl_in_python.install import install, is_installed
from tests.support.paths import ROOT

BEGIN = '''
import sys, threading
from param_tools.rcl_in_python.install import install
install(even_beside_the_real_one=True)
'''


def run(program):
    """Run a program in a process of its own, and return what it prints; raise if it fails."""
    done = subprocess.run([sys.executable, '-c', BEGIN + program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_it_is_not_installed_beside_the_real_one():
    assert 'without_network' not in rclpy.get_rmw_implementation_identifier()
    with pytest.raises(LayerError, match='imported already'):
        install()
    assert not is_installed()
    other = subprocess.run([sys.executable, '-c', 'from param_tools.rcl_in_python.install import install; install()'],
                           capture_output=True, text=True)
    assert 'LayerError: the real rclpy is installed here' in other.stderr


def test_it_says_what_it_is():
    assert run('''
install()
import rclpy
from rclpy.impl.implementation_singleton import rclpy_implementation
print(rclpy.get_rmw_implementation_identifier(), rclpy_implementation.__doc__)
import param_tutorial
print(param_tutorial.start())
''') == ("rclpy_in_python_without_network rclpy's own code, without a network: the layer in Python.\n"
         '<BackgroundExecutor: spinning no node, on rclpy_in_python_without_network>\n')


def test_what_is_not_part_of_it_says_so():
    assert run('''
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


def test_it_needs_no_thread():
    assert run('''
def start(self):
    raise RuntimeError("can't start new thread")
threading.Thread.start = start
import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.parameter import Parameter
rclpy.init(args=[])
node = rclpy.create_node('node')
node.declare_parameter('a', 1)
ticks = []
node.create_timer(0.01, lambda: ticks.append(1))
client = node.create_client(SetParameters, 'node/set_parameters')
future = client.call_async(SetParameters.Request(parameters=[Parameter('a', value=2).to_parameter_msg()]))
rclpy.spin_until_future_complete(node, future)
while len(ticks) < 2:
    rclpy.spin_once(node)
print(future.result().results[0].successful, node.get_parameter('a').value, threading.active_count())
node.destroy_node()
rclpy.shutdown()
''') == 'True 2 1\n'


def test_the_layer_itself_needs_no_numpy():
    assert run('print("numpy" in sys.modules, "rclpy" in sys.modules)') == 'False False\n'


def test_where_there_is_no_numpy_messages_get_what_they_use_of_it():
    assert run('''
from importlib.machinery import PathFinder
find_spec = PathFinder.find_spec
PathFinder.find_spec = lambda name, *more: None if name == 'numpy' else find_spec(name, *more)
from service_msgs.msg import ServiceEventInfo
from rclpy.serialization import deserialize_message, serialize_message
info = ServiceEventInfo(client_gid=range(16), sequence_number=7)
print(deserialize_message(serialize_message(info), ServiceEventInfo) == info, info == ServiceEventInfo())
print(sys.modules['numpy'].__doc__.startswith('As much of numpy'))
''') == 'True False\nTrue\n'


def test_where_there_is_no_multiprocessing_the_event_handler_has_a_lock_all_the_same():
    assert run('''
import multiprocessing
from param_tools.rcl_in_python import install
multiprocessing.Lock = install.Lock
import rclpy
from rclpy.parameter_event_handler import ParameterEventHandler
rclpy.init(args=[])
mutex = ParameterEventHandler(rclpy.create_node('node'))._callbacks.mutex
with mutex:
    print(mutex.acquire(block=False), mutex.acquire(timeout=0.01))
print(mutex.acquire(), mutex.release())
''') == 'False False\nTrue None\n'


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.timeout(300)
def test_what_the_real_one_passes_the_layer_passes():
    """The tests of rclpy's behavior that are written here; tests/README.md says how to run rclpy's own."""
    # Stops at the first that fails: of a broken layer, many would wait for a minute each.
    done = subprocess.run([sys.executable, '-m', 'pytest', '-p', 'tests.support.rcl_in_python', '-x', '-n', '2',
                           '--dist', 'loadscope', 'tests/conformance', 'tests/node', 'tests/ros/test_services.py'],
                          cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
