"""Lines that tutorials teach or people type by mistake, and the places where they can stand in a notebook."""

import re
import time
from typing import NamedTuple

from tests.support.kernels import DEADLINE_SEC, Kernel

# Runs first: the stage with a node of the learner's, a right answer to an exercise, and the names that lines use.
SET_UP = '''
%load_ext param_tutorial
import sys, time, rclpy, param_tutorial
from rcl_interfaces.srv import GetParameters, SetParameters
from rcl_interfaces.msg import FloatingPointRange, Log, ParameterDescriptor, SetParametersResult
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
ALIVE_SAYS = '(/keeper accepted x = 7, True)'
NEXT_CHECK = '''
class Rover(Node):
    def __init__(self):
        super().__init__('rover')
        self.declare_parameter('max_speed_mps', 1.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))
        self.declare_parameter('wheels', 6, ParameterDescriptor(read_only=True))
exercises.check('3b', Rover).done
'''
BEGUN = '<begun>'


class Line(NamedTuple):
    """What stands in a node's code, where the node is ``self``."""

    source: str
    says: str
    """A pattern for the word that the learner gets."""
    ends: bool = True
    """False if it runs until someone presses Interrupt."""


_NO_SPIN = ('leave this line out|runs inside the executor|spun in the background|timed out after|only the executor can '
            'bring')
_NOT_BACK = 'did not return|blocks the thread|does not return|was still running|did not answer|KeyboardInterrupt'
LINES = {
    'spin': Line('rclpy.spin(self)', _NO_SPIN),
    'spin_once': Line('rclpy.spin_once(self)', _NO_SPIN),
    'spin until complete': Line('rclpy.spin_until_future_complete(self, rclpy.task.Future())', _NO_SPIN),
    'SingleThreadedExecutor': Line('SingleThreadedExecutor().spin()', _NO_SPIN),
    'MultiThreadedExecutor': Line('many = MultiThreadedExecutor(2); many.add_node(self); many.spin()', _NO_SPIN),
    'call': Line("self.create_client(GetParameters, '/nobody/get_parameters').call(GetParameters.Request())", _NO_SPIN),
    'init': Line('rclpy.init()', r'rclpy\.init\(\) has nothing to do here'),
    'shutdown': Line('rclpy.shutdown()', r'rclpy\.shutdown\(\) has nothing to do here'),
    'try_shutdown': Line('rclpy.try_shutdown()', r'rclpy\.shutdown\(\) has nothing to do here'),
    'destroy_node': Line('self.destroy_node()', ''),
    'sys.exit': Line('sys.exit(1)', 'SystemExit'),
    'exit': Line('exit()', r'exit\(\) would end this kernel'),
    'raise SystemExit': Line('raise SystemExit', 'SystemExit'),
    'input': Line("print(input('speed? '))", r'input\(\)'),
    'print flood': Line("for number in range(100_000): print('flood', number)", ''),
    'endless loop': Line('while True: pass', _NOT_BACK, ends=False),
    'long sleep': Line('time.sleep(1000)', _NOT_BACK, ends=False),
    'loop that catches all': Line('''while True:
    try: time.sleep(0.01)
    except Exception: pass''', _NOT_BACK, ends=False),
    'main': Line('''def main(args=None):
    rclpy.init(args=args)
    node = Keeper()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()
main()''', _NO_SPIN),
}


def _method(source: str, indent: int = 8) -> str:
    """Return a line as the body of a method."""
    return '\n'.join(' ' * indent + line for line in source.splitlines())


def _node(source: str, *, begins: str = '', name: str = 'victim', in_constructor: str = 'pass') -> str:
    """Return a class of nodes with a method act() that does what the line says."""
    return f'''
class Victim(Node):
    def __init__(self):
        super().__init__({name!r})
        {in_constructor}
    def judge(self, parameters):
        self.act()
        return SetParametersResult(successful=True)
    def serve(self, request, response):
        self.act()
        return response
    def hear(self, message):
        self.act()
    def tick(self):
        self.timer.cancel()
        self.act()
    def act(self, *_):
        global entered
        entered = True
        print({BEGUN!r}, flush=True)
{_method(source)}
        global left
        left = True
entered = left = False
{begins}
'''


_WAIT = '''
param_tutorial.wait_until(lambda: entered, 'the callback')
ParameterClient('keeper').get_parameter('x')
param_tutorial.wait_until(lambda: left or ros.failures or 'victim' not in [each.get_name() for each in ros.nodes],
                          'the end of the callback')
ros.run(lambda: None, 'see it through')
'''


PLACES = {
    'cell, node made by hand': lambda source: f"self = Node('by_hand')\nprint({BEGUN!r}, flush=True)\n{source}",
    'cell, node on the stage': lambda source: (
        f"self = ros.add(Node, 'victim')\nprint({BEGUN!r}, flush=True)\n{source}"),
    'constructor': lambda source: _node(source, in_constructor='self.act()', begins='ros.add(Victim)'),
    'timer': lambda source: _node(
        source, in_constructor='self.timer = self.create_timer(0.01, self.tick)', begins=f'ros.add(Victim){_WAIT}'),
    'parameter callback': lambda source: _node(
        source, in_constructor="self.declare_parameter('y', 1); self.add_on_set_parameters_callback(self.judge)",
        begins="ros.add(Victim)\ntry: print(ParameterClient('victim').set_parameter('y', 2))\n"
               f"except Exception as error: print(error){_WAIT}"),
    'subscription': lambda source: _node(
        source, in_constructor="self.create_subscription(Log, 'topic', self.hear, 1)",
        begins="ros.add(Victim); sender = ros.add(Node, 'sender').create_publisher(Log, 'topic', 1)\n"
               "param_tutorial.wait_until(sender.get_subscription_count, 'the subscription')\n"
               "sender.publish(Log(name='x'))" + _WAIT),
    'service': lambda source: _node(
        source, in_constructor="self.create_service(GetParameters, 'ask', self.serve)",
        begins="ros.add(Victim); asking = ros.add(Node, 'asking').create_client(GetParameters, 'ask')\n"
               "param_tutorial.wait_until(asking.service_is_ready, 'the service', 60)\n"
               "asking.call_async(GetParameters.Request())" + _WAIT),
    'check, constructor': lambda source: _node(
        source, name='rover', in_constructor='self.act()', begins="exercises.check('3b', Victim)"),
    'check, parameter callback': lambda source: _node(
        source, name='heater', in_constructor="self.declare_parameters('', [('low_c', 18), ('high_c', 22)]); "
        "self.target_c = 20; self.add_on_set_parameters_callback(self.judge)",
        begins="exercises.check('5.2a', Victim)"),
    'check, function': lambda source: f'''
def act(parameters, results):
    self = Node('by_hand')
{_method(source, 4)}
exercises.check('5.3c', act)''',
    'check, button': lambda source: _node(
        source, name='supervisor', in_constructor="self.rejection = ''; self.slow_down = self.act; "
        "self.client = self.create_client(SetParameters, '/rover/set_parameters')",
        begins="exercises.check('5.3b', Victim)"),
}

# In code that a cell itself runs, input() asks as usual, and the learner may print anything.
IN_THE_CELL = ('cell, node made by hand', 'cell, node on the stage', 'constructor')


class Attempt(NamedTuple):
    """The result of a line in a place."""

    text: str
    stage: str
    """What ALIVE says afterwards."""
    check: str
    """What NEXT_CHECK says afterwards."""

    # What the executor's thread prints may come with the next cells.

    def says(self, pattern: str) -> bool:
        """True if the learner could read this; lines may be broken anywhere."""
        return re.search(pattern, ' '.join(f'{self.text} {self.stage} {self.check}'.split())) is not None

    @property
    def goes_on(self) -> tuple[bool, bool]:
        """Two truth values: the stage is alive, and the next check works."""
        return self.stage.endswith(ALIVE_SAYS), self.check.endswith('True')


def started() -> Kernel:
    """Return a new kernel with the stage in it."""
    kernel = Kernel()
    said = kernel.run(SET_UP)
    assert not said, said
    return kernel


def attempt(kernel: Kernel, name: str, place: str) -> Attempt:
    """Run a line in a place, then ask the node that was there before, then check a right answer.

    :raises TimeoutError: a cell does not end.
    """
    line = LINES[name]
    kernel.run('ros = param_tutorial.start(); ros.add(Keeper)')
    kernel.late = ''
    interrupt_on = BEGUN if not line.ends and place in IN_THE_CELL else ''
    deadline = time.monotonic() + DEADLINE_SEC / 2
    text = kernel.run(PLACES[place](line.source), interrupt_on=interrupt_on, answer=lambda: 'seven')
    if name == 'long sleep' and place not in IN_THE_CELL:
        kernel.run('ros = param_tutorial.start(); ros.add(Keeper)')  # as the learner was told
    stage, check = kernel.run(ALIVE), kernel.run(NEXT_CHECK)
    while not (tried := Attempt(text + kernel.late, stage, check)).says(line.says):
        if place in IN_THE_CELL or time.monotonic() > deadline:
            break
        text += kernel.run("ros.run(lambda: None, 'let it print')")
    return tried
