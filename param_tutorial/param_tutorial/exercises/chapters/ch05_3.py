"""Exercises of chapter 5.3: order the lines of a request, set two parameters of another node together, and read an
answer."""

from typing import Any

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rcl_interfaces.srv import SetParameters
from rclpy.client import Client
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import WithoutDeadlock, derive, expect_service, run_lines
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect
from param_tutorial.parameters.client import ParameterValues

CHAPTER = '05_3_from_another_node'
HOW = 'How it works'
ATOMIC = 'Change it: all or nothing'
ONE_BY_ONE = 'Change it: one of four is wrong'
WAITING = 'Break it: waiting in the wrong place'


class Rover(Node):
    """The robot that is to be slowed down."""

    def __init__(self, gentlest_mps2: float = 0.1):
        """:param gentlest_mps2: The smallest acceleration that it accepts, in m/s^2."""
        super().__init__('rover')
        self.declare_parameter('max_speed_rpm', 100)
        self.declare_parameter('max_acceleration_mps2', 1.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=gentlest_mps2, to_value=2.0)]))


class StubbornRover(Rover):
    """Refuses to accelerate as gently as the supervisor wants it to."""

    def __init__(self) -> None:
        super().__init__(gentlest_mps2=0.5)


OLD = ParameterValues(max_speed_rpm=100, max_acceleration_mps2=1.0)
NEW = ParameterValues(max_speed_rpm=40, max_acceleration_mps2=0.2)

supervise = Exercise('5.3a', 'Slow a rover down', CHAPTER, NODE_CLASS, node_name='supervisor', hints=(
    'A client is made once, in the constructor: `self.create_client(TYPE, NAME)`. Which of the six services takes a '
    'list as one wish?',
    'The service is `/rover/set_parameters_atomically`, of the type `SetParametersAtomically`. Make its request as '
    'the section “How it works” does, and send it with `call_async`.',
    '`call_async` gives a future, and `future.add_done_callback(self.on_answer)` has your method called with it. '
    '`future.result().result` is the one result, and it has a `reason`.'))


def slow_down(trial: Trial, rover_class: type[Rover]) -> tuple[Rover, Any]:
    """Put a rover and the learner's supervisor on the stage, and press the supervisor's button."""
    rover = trial.start(rover_class)
    supervisor: Any = trial.start(derive(WithoutDeadlock, trial.work))
    expect(list(supervisor.clients), 'the supervisor has a client for a service of `/rover`', 'it has none')
    for client in supervisor.clients:
        expect_service(trial, client)
    trial.press('`slow_down()`', supervisor.slow_down)
    return rover, supervisor


@supervise.require('`slow_down()` sends both values, and does not wait for the answer', see=HOW)
def both(trial: Trial) -> None:
    rover, _ = slow_down(trial, Rover)
    client = trial.client(rover)
    trial.wait(lambda: client.get_parameters(NEW) == NEW, 'the rover holds 40 rpm and 0.2 m/s²',
               lambda: f'it holds {" and ".join(map(str, client.get_parameters(NEW).values()))}')


@supervise.require('`self.rejection` is the reason of a rover that rejects', see=HOW)
def reason(trial: Trial) -> None:
    _, supervisor = slow_down(trial, StubbornRover)
    trial.wait(lambda: 'out of range' in str(supervisor.rejection), 'the reason is in `self.rejection`',
               lambda: f'`self.rejection` is `{supervisor.rejection!r}`')


@supervise.require('both are set or neither: a rover that rejects one keeps the other', see=ATOMIC)
def neither(trial: Trial) -> None:
    both(trial)
    rover, supervisor = slow_down(trial, StubbornRover)
    trial.wait(lambda: supervisor.rejection, 'the answer has come', lambda: 'there is no reason in `self.rejection`')
    kept = trial.client(rover).get_parameters(OLD)
    expect(kept == OLD, 'the rover keeps 100 rpm when it rejects the acceleration',
           f'it drives at {kept["max_speed_rpm"]} rpm. `set_parameters` decides each parameter for itself')


read = Exercise('5.3b', 'Read an answer', CHAPTER, FUNCTION, hints=(
    'A result has `successful` and `reason`, and no name.',
    'The results come in the order of the request, so `zip(parameters, results)` gives the pairs.',
    'A dictionary grows by `reasons[parameter.name] = result.reason`; return it behind the loop, not in it.'))


def answer_to(trial: Trial, *parameters: Parameter) -> tuple[object, dict[str, str]]:
    """Ask a rover to set parameters one by one; return what the learner's function makes of it, and what is true."""
    rover = trial.start(Rover)
    request = SetParameters.Request(parameters=[each.to_parameter_msg() for each in parameters])
    results = trial.ros.services.call(rover.get_fully_qualified_name(), 'set_parameters', request).results
    try:
        given = trial.call('the function', trial.work, list(parameters), list(results))
    except NotYet as error:
        if 'AttributeError' in error.happened:
            raise NotYet(error.expected, f'{error.happened}. A result has no name: results come in the order of the '
                                         f'request') from None
        raise
    return given, {each.name: result.reason for each, result in zip(parameters, results) if not result.successful}


@read.require('one rejection among three: its name, and the reason', see=HOW)
def one(trial: Trial) -> None:
    given, true = answer_to(trial, Parameter('max_speed_rpm', value=50), Parameter('max_acceleration_mps2', value=9.0),
                            Parameter('use_sim_time', value=False))
    expect(given == true, f'`{true!r}`', f'the function gave `{given!r}`')


@read.require('two rejections: both of them', see=ONE_BY_ONE)
def two(trial: Trial) -> None:
    given, true = answer_to(trial, Parameter('max_speed_rpm', value='fast'), Parameter('use_sim_time', value=False),
                            Parameter('max_acceleration_mps2', value=9.0))
    expect(given == true, f'`{true!r}`', f'the function gave `{given!r}`' + (
        '. Does it return before the loop has ended?' if given else ''))


@read.require('no rejection: an empty dictionary', see=HOW)
def none(trial: Trial) -> None:
    given, true = answer_to(trial, Parameter('max_speed_rpm', value=50))
    expect(given == true, f'`{true!r}`', f'the function gave `{given!r}`')


order = Exercise('5.3c', 'Put a request in order', CHAPTER, TEXT, hints=(
    'A name has to be there before a line can use it. Begin with the two lines that use none of the others’ names.',
    'The request needs the parameter, the call needs client and request, and the last line needs the future that the '
    'call returns.'))


class Asking(Node):
    """A node that lets no request go before the other side is there: it would be lost."""

    def __init__(self) -> None:
        super().__init__('asking')
        self.not_found = ''

    def create_client(self, *args: Any, **options: Any) -> Client:
        client = super().create_client(*args, **options)
        if not client.wait_for_service(timeout_sec=1.0):
            self.not_found = client.srv_name
        return client


def ordered(trial: Trial) -> tuple[Rover, list[Any]]:
    """Run the learner's lines beside a rover, and return it with the results that have come."""
    rover = trial.start(Rover)
    node = trial.start(Asking)
    results: list[Any] = []
    run_lines(trial, node=node, results=results, SetParameters=SetParameters, Parameter=Parameter)
    if node.not_found:
        raise NoUse('the client finds its service', f'nobody offers a service `{node.not_found}`, of that type')
    return rover, results


@order.require('the lines run to their end, and the rover gets 50 rpm', see=HOW)
def arrives(trial: Trial) -> None:
    rover, _ = ordered(trial)
    client = trial.client(rover)
    trial.wait(lambda: client.get_parameter('max_speed_rpm') == 50, 'the rover holds 50 rpm',
               lambda: f'it holds {client.get_parameter("max_speed_rpm")!r}')


@order.require('the answer of the rover comes into `results`', see=HOW)
def is_answered(trial: Trial) -> None:
    _, results = ordered(trial)
    trial.wait(lambda: results, 'one result', lambda: '`results` is empty')
    expect(len(results) == 1 and getattr(results[0], 'successful', False), 'one result, which is successful',
           f'`results` is `{results!r}`')


EXERCISES = (order, supervise, read)
