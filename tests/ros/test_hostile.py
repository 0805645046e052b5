"""Lines that tutorials teach or people type by mistake, which hang a kernel or end a stage elsewhere.

In a real kernel, each gets a word, and work goes on. Each stands in one place where it is likely.
"""

import re
import time
from typing import NamedTuple

import pytest

from tests.support.kernels import DEADLINE_SEC, Kernel

# Runs first: the stage with a node of the learner's, a right answer to an exercise, and the names that lines use.
SET_UP = '''
%load_ext param_tutorial
import sys, time, rclpy, param_tutorial
from rcl_interfaces.srv import GetParameters
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from param_tutorial import ParameterClient, exercises

class Keeper(Node):
    def __init__(self):
        super().__init__('keeper')
        self.declare_parameter('x', 1)

ros = param_tutorial.start()
keeper = ros.add(Keeper)
'''
ALIVE = "ParameterClient('keeper').set_parameter('x', 7), ros.is_running"
NEXT_CHECK = '''
class Rover(Node):
    def __init__(self):
        super().__init__('rover')
        self.declare_parameter('max_speed_mps', 1.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))
        self.declare_parameter('wheels', 6, ParameterDescriptor(read_only=True))
exercises.check('3b', Rover).done
'''


def indented(source: str, indent: int = 8) -> str:
    return '\n'.join(' ' * indent + line for line in source.splitlines())


def node(source: str, in_constructor: str, begins: str) -> str:
    """Return a class of nodes with a method act() that does what the line says."""
    return f'''
class Victim(Node):
    def __init__(self):
        super().__init__('victim')
        {in_constructor}
    def judge(self, parameters):
        self.act()
        return SetParametersResult(successful=True)
    def tick(self):
        self.timer.cancel()
        self.act()
    def act(self):
        global entered
        entered = True
{indented(source)}
        global left
        left = True
entered = left = False
{begins}
'''


# Until the callback has ended, in whichever way.
WAIT = '''
param_tutorial.wait_until(lambda: entered, 'the callback')
ParameterClient('keeper').get_parameter('x')
param_tutorial.wait_until(lambda: left or ros.failures or 'victim' not in [each.get_name() for each in ros.nodes],
                          'the end of the callback')
ros.run(lambda: None, 'see it through')
'''
PLACES = {
    'cell': lambda source: f"self = Node('by_hand')\n{source}",
    'constructor': lambda source: node(source, 'self.act()', 'ros.add(Victim)'),
    'timer': lambda source: node(source, 'self.timer = self.create_timer(0.01, self.tick)', f'ros.add(Victim){WAIT}'),
    'parameter callback': lambda source: node(
        source, "self.declare_parameter('y', 1); self.add_on_set_parameters_callback(self.judge)",
        "ros.add(Victim)\ntry: print(ParameterClient('victim').set_parameter('y', 2))\n"
        f"except Exception as error: print(error){WAIT}"),
    'check': lambda source: f'''
def act(parameters, results):
    self = Node('by_hand')
{indented(source, 4)}
exercises.check('5.3c', act)''',
}


class Line(NamedTuple):
    """What stands in a node's code, where the node is ``self``."""

    place: str
    source: str
    says: str
    """A pattern for the word that the learner gets."""


NO_SPIN = 'leave this line out|runs inside the executor|spun in the background|timed out after'
NOT_BACK = 'did not return|does not return|was still running'
LINES = {
    'spin': Line('cell', 'rclpy.spin(self)', NO_SPIN),
    'spin_once': Line('timer', 'rclpy.spin_once(self)', NO_SPIN),
    'spin until complete': Line('constructor', 'rclpy.spin_until_future_complete(self, rclpy.task.Future())', NO_SPIN),
    'SingleThreadedExecutor': Line('timer', 'SingleThreadedExecutor().spin()', NO_SPIN),
    'MultiThreadedExecutor': Line('cell', 'many = MultiThreadedExecutor(2); many.add_node(self); many.spin()', NO_SPIN),
    'call': Line('parameter callback',
                 "self.create_client(GetParameters, '/nobody/get_parameters').call(GetParameters.Request())", NO_SPIN),
    'init': Line('cell', 'rclpy.init()', r'rclpy\.init\(\) has nothing to do here'),
    'shutdown': Line('cell', 'rclpy.shutdown()', r'rclpy\.shutdown\(\) has nothing to do here'),
    'try_shutdown': Line('timer', 'rclpy.try_shutdown()', r'rclpy\.shutdown\(\) has nothing to do here'),
    'destroy_node': Line('timer', 'self.destroy_node()', ''),
    'sys.exit': Line('parameter callback', 'sys.exit(1)', 'SystemExit'),
    'exit': Line('cell', 'exit()', r'exit\(\) would end this kernel'),
    'raise SystemExit': Line('timer', 'raise SystemExit', 'SystemExit'),
    'input': Line('timer', "print(input('speed? '))", r'input\(\)'),
    'print flood': Line('timer', "for number in range(100_000): print('flood', number)", ''),
    'endless loop': Line('parameter callback', 'while True: pass',
                         r'set_parameters of /victim, in line \d+( \(`while True: pass`\))?, did not return'),
    'long sleep': Line('timer', 'time.sleep(1000)', NOT_BACK),
    'loop that catches all': Line('check', '''while True:
    try: time.sleep(0.01)
    except Exception: pass''', NOT_BACK),
    'main': Line('cell', '''def main(args=None):
    rclpy.init(args=args)
    node = Keeper()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()
main()''', NO_SPIN),
}


@pytest.fixture(scope='module')
def kernels():
    """One kernel for all tests, or a new one after one that hangs."""
    kernels = []
    yield kernels
    for kernel in kernels:
        kernel.kill()


@pytest.mark.parametrize('name', LINES)
def test_a_hostile_line_gets_a_word_and_work_goes_on(kernels, name):
    if not kernels:
        kernels.append(Kernel())
        assert kernels[0].run(SET_UP) == ''
    kernel, line = kernels[0], LINES[name]
    start = 'ros = param_tutorial.start(); ros.add(Keeper)'
    try:
        kernel.run(start)
        kernel.late = ''
        text = kernel.run(PLACES[line.place](line.source))
        if name == 'long sleep':
            kernel.run(start)  # as the learner was told
        stage, check = kernel.run(ALIVE), kernel.run(NEXT_CHECK)
        # What the executor's thread prints may come with the next cells, and lines may be broken anywhere.
        deadline = time.monotonic() + DEADLINE_SEC / 2
        while not re.search(line.says, ' '.join(f'{text}{kernel.late} {stage} {check}'.split())):
            assert time.monotonic() < deadline, text + kernel.late
            text += kernel.run("ros.run(lambda: None, 'let it print')")
    except TimeoutError:
        kernels.pop().kill()
        raise
    assert stage.endswith('(/keeper accepted x = 7, True)')
    assert check.endswith('True')
