"""Exercises of chapter 5.3: order the lines of a request, set two parameters of another node together, read an answer,
and write a whole program that asks another node."""

import itertools
import time
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, TypeVar

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import SetParameters
from rclpy.client import Client
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.node.client import ParameterValues
from param_tools.ros.waiting import wait
from param_tools.values import INTEGER
from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import (
    NotesQuestions,
    awake,
    expect_accepted,
    expect_no_wait,
    expect_start_value,
    run_lines,
    start_asking,
    take_type_for_granted,
)
from param_tutorial.exercises.programs import PROGRAM, Program, require_ends, require_program, running
from param_tutorial.exercises.trial import STUCK, TIME_LIMIT_SEC, NotYet, NoUse, Trial, expect

CHAPTER = '05_3_from_another_node'
HOW = 'How it works'
ATOMIC = 'Change it: all or nothing'
ONE_BY_ONE = 'Change it: one of four is wrong'


class Rover(Node):
    """The robot to slow down. It notes which parameters it is asked for, and whether it stores any."""

    rejected: tuple[str, ...] = ()
    """The parameters of which it accepts no value."""
    words = ''
    """Why not."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameter('max_speed_rpm', 100)
        self.declare_parameter('max_acceleration_mps2', 1.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=2.0)]))
        self.asked: set[str] = set()
        self.has_stored = False
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.note)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        names = {each.name for each in parameters}
        self.asked |= names
        is_rejected = not names.isdisjoint(self.rejected)
        return SetParametersResult(successful=not is_rejected, reason=self.words if is_rejected else '')

    def note(self, _: list[Parameter]) -> None:
        self.has_stored = True


RoverT = TypeVar('RoverT', bound=Rover)


class KeepsAcceleration(Rover):
    """Accepts a new speed only."""

    rejected, words = ('max_acceleration_mps2',), 'not while I am climbing'


class KeepsSpeed(Rover):
    """Accepts a new acceleration only."""

    rejected, words = ('max_speed_rpm',), 'the floor is wet'


OLD = ParameterValues(max_speed_rpm=100, max_acceleration_mps2=1.0)
NEW = ParameterValues(max_speed_rpm=40, max_acceleration_mps2=0.2)

supervise = Exercise('5.3b', 'Slow a rover down', CHAPTER, NODE_CLASS, node_name='supervisor', hints=(
    'Create the client once, in the constructor: `self.create_client(TYPE, NAME)`. Which of the six services takes a '
    'list as one?',
    'The service is `/rover/set_parameters_atomically`, of the type `SetParametersAtomically`. Make its request as '
    'the section “Change it: all or nothing” does, and send it with `call_async`.',
    '`call_async` returns a future. `future.add_done_callback(self.on_answer)` has rclpy call your method with it. '
    '`future.result().result` is the one result, and it has a `reason`. If you would rather await the future, the '
    'client needs a callback group of its own.'))


def slow_down(trial: Trial, rover_class: type[Rover]) -> tuple[Rover, Any]:
    """Put a rover and the learner's supervisor on the stage, and press the supervisor's button.

    :raises NoUse: it asks before that, or the button cannot be pressed, or does not get to its end.
    """
    rover = trial.start(rover_class)
    supervisor = start_asking(trial)
    if supervisor.questions_noted:
        raise NoUse('no request before `slow_down()` is called', 'the constructor has sent one')
    button = getattr(supervisor, 'slow_down', None)
    if not callable(button):
        raise NoUse('a method `slow_down`', 'the class has none')
    with awake():
        trial.press('`slow_down()`', supervisor, button)
    return rover, supervisor


@supervise.require('`slow_down()` sends both values, and neither blocks nor hangs', see=HOW)
def both(trial: Trial) -> None:
    rover, supervisor = slow_down(trial, Rover)
    client = trial.client(rover)
    try:
        trial.wait(lambda: client.get_parameters(NEW) == NEW, 'the rover holds 40 rpm and 0.2 m/s²',
                   lambda: f'it holds {" and ".join(map(str, client.get_parameters(NEW).values()))}' + (
                       f', and `self.rejection` is `{supervisor.rejection!r}`' if supervisor.rejection else ''))
    except NotYet as error:  # what rovers reject can tell nothing about other values
        raise NoUse(error.expected, trial.raised() or error.happened) from None
    others = ' and '.join(f'`{name}`' for name in sorted(rover.asked - set(NEW)))
    expect(not others, 'the rover is asked for nothing else', f'it is asked for {others} too')
    expect_no_wait(trial, 'slow_down')


@supervise.require('`self.rejection` is the reason of a rover that rejects', see=HOW)
def reason(trial: Trial) -> None:
    for rover_class in (KeepsAcceleration, KeepsSpeed, Rover):
        expect_reason(trial, rover_class)


def expect_reason(trial: Trial, rover_class: type[Rover]) -> None:
    """Expect the supervisor to know why a rover rejects, and nothing if it doesn't."""
    rover, supervisor = slow_down(trial, rover_class)
    trial.wait(lambda: rover.asked, 'the rover is asked', lambda: 'it is not')
    for _ in range(3):
        trial.ros.run(lambda: None, 'let the answer through')
    if rover.rejected:
        trial.wait(lambda: supervisor.rejection == rover.words, f'`self.rejection` is `{rover.words!r}`',
                   lambda: f'it is `{supervisor.rejection!r}`')
    else:
        expect(not supervisor.rejection, '`self.rejection` stays empty when the rover accepts',
               f'it is `{supervisor.rejection!r}`')
    trial.ros.remove(supervisor)
    trial.ros.remove(rover)


@supervise.require('both are set or neither: a rover that rejects one keeps the other', see=ATOMIC)
def neither(trial: Trial) -> None:
    for rover_class, kept in ((KeepsAcceleration, 'max_speed_rpm'), (KeepsSpeed, 'max_acceleration_mps2')):
        expect_kept(trial, rover_class, kept)


def expect_kept(trial: Trial, rover_class: type[Rover], name: str) -> None:
    """Expect a parameter to stay as it is in a rover that rejects the other one."""
    rover, supervisor = slow_down(trial, rover_class)
    trial.wait(lambda: rover.asked >= set(NEW), 'the rover is asked for both values',
               lambda: f'it was asked for {" and ".join(f"`{each}`" for each in sorted(rover.asked)) or "nothing"}')
    trial.ros.run(lambda: None, 'let the rover finish')
    expect(not rover.has_stored, f'a rover that rejects the other value keeps `{name} = {OLD[name]}`',
           'it stored the new one. `set_parameters` decides about each parameter separately')
    trial.ros.remove(supervisor)
    trial.ros.remove(rover)


read = Exercise('5.3c', 'Read an answer', CHAPTER, FUNCTION, hints=(
    'A result has `successful` and `reason`, but no name.',
    'The results come in the order of the request, so `zip(parameters, results)` makes the pairs.',
    'Add to a dictionary with `reasons[parameter.name] = result.reason`, and return it after the loop, not inside it.'))


class Judge(Node):
    """Rejects two parameters in the same words and one without a word, and says something when it accepts."""

    def __init__(self) -> None:
        super().__init__('judge')
        self.declare_parameters('', [('left_rpm', 1), ('right_rpm', 1), ('lift_rpm', 1), ('note', '')])
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        name = parameters[0].name
        return SetParametersResult(successful=name == 'note', reason={'note': 'noted', 'lift_rpm': ''}.get(
            name, 'too fast'))


def expect_reasons(trial: Trial, node_class: type[Node], wanted: Mapping[str, object],
                   earlier: Mapping[str, str] = MappingProxyType({})) -> dict[str, str]:
    """Set parameters one by one, and expect the learner's function to find each rejection in the answer.

    :param earlier: What it had to find in an earlier answer.
    :return: What it had to find in this one.
    """
    node = trial.start(node_class)
    parameters = [Parameter(name, value=value) for name, value in wanted.items()]
    request = SetParameters.Request(parameters=[each.to_parameter_msg() for each in parameters])
    results = trial.ros.services.call(node.get_fully_qualified_name(), 'set_parameters', request).results
    true = {each.name: result.reason for each, result in zip(parameters, results) if not result.successful}
    try:
        given = trial.call('the function', trial.work, parameters, list(results))
    except NotYet as error:
        because = ''
        if "'SetParametersResult' object has no attribute 'name'" in error.happened:
            because = '. A result has no name: results come in the order of the request'
        raise NoUse(error.expected, error.happened + because) from None
    if not isinstance(given, dict):
        raise NoUse(f'a dictionary, `{true!r}`', f'the function returned `{given!r}`')
    if any(name not in true and given.get(name) == reason for name, reason in earlier.items()):
        raise NoUse(f'`{true!r}`', f'the function returned `{given!r}`. Some of it is from an earlier call: each call '
                    'needs a new dictionary')
    expect(given == true, f'`{true!r}`', f'the function returned `{given!r}`{why_some_lack(given, true)}')
    return true


def why_some_lack(given: dict[str, str], true: dict[str, str]) -> str:
    """Return what to think of when a function found only some of the rejections."""
    if not given or not given.items() < true.items():
        return ''
    if given == dict([*true.items()][:1]):
        return '. Does it return before the loop has ended?'
    if given == {name: reason for name, reason in true.items() if reason}:
        return '. A node may reject without a reason: `successful` decides'
    return '. Two results may be equal, so what counts is their position'


@read.require('one rejection among three: its name, and the reason', see=HOW)
def one(trial: Trial) -> None:
    found = expect_reasons(trial, Rover, {'max_speed_rpm': 50, 'max_acceleration_mps2': 9.0, 'use_sim_time': False})
    expect_reasons(trial, Rover, {'max_speed_rpm': 'fast', 'max_acceleration_mps2': 0.5, 'use_sim_time': False}, found)


@read.require('several rejections: all of them, also in the same words or without a word', see=ONE_BY_ONE)
def several(trial: Trial) -> None:
    expect_reasons(trial, Rover, {'max_speed_rpm': 'fast', 'use_sim_time': False, 'max_acceleration_mps2': 9.0})
    expect_reasons(trial, Judge, {'left_rpm': 2, 'note': 'now', 'right_rpm': 2, 'lift_rpm': 2})
    expect_reasons(trial, Judge, {'note': 'now', 'use_sim_time': False, 'lift_rpm': 2, 'left_rpm': 3, 'right_rpm': 4})


@read.require('no rejection: an empty dictionary', see=HOW)
def none(trial: Trial) -> None:
    expect_reasons(trial, Rover, {'max_speed_rpm': 50})


order = Exercise('5.3a', 'Put a request in order', CHAPTER, TEXT, hints=(
    'A name has to exist before a line can use it. Start with the two lines that use none of the other lines’ names.',
    'The request needs the parameter, the call needs the client and the request, and the last line needs the future '
    'that the call returns.'))


class Asking(NotesQuestions):
    """A node whose clients are created only once their service is found: an earlier request would be lost."""

    def __init__(self) -> None:
        super().__init__('asking')
        self.not_found = ''

    def create_client(self, *args: Any, **options: Any) -> Client:
        client = super().create_client(*args, **options)
        if not client.wait_for_service(timeout_sec=1.0):
            self.not_found = client.srv_name
        return client


def ordered(trial: Trial) -> tuple[Rover, list[Any]]:
    """Run the learner's lines beside a rover, and return it with the results that have arrived.

    :raises NoUse: the lines do not run to their end, find no rover, or ask it more than once.
    """
    rover = trial.start(Rover)
    node = trial.start(Asking)
    results: list[Any] = []
    run_lines(trial, node=node, results=results, SetParameters=SetParameters, Parameter=Parameter)
    if node.not_found:
        raise NoUse('the client finds its service', f'there is no service `{node.not_found}` of that type')
    if (count := len(node.questions_noted)) > 1:
        raise NoUse('the rover is asked once', f'it is asked {count} times. Is a line there twice?')
    return rover, results


@order.require('the lines run to their end, and the rover gets 50 rpm', see=HOW)
def arrives(trial: Trial) -> None:
    rover, _ = ordered(trial)
    client = trial.client(rover)
    try:
        trial.wait(lambda: client.get_parameter('max_speed_rpm') == 50, 'the rover holds 50 rpm',
                   lambda: f'it holds {client.get_parameter("max_speed_rpm")!r}')
    except NotYet as error:  # without the right request there is no right answer
        raise NoUse(error.expected, trial.raised() or error.happened) from None


@order.require('the answer of the rover is added to `results`', see=HOW)
def is_answered(trial: Trial) -> None:
    rover, results = ordered(trial)
    trial.wait(lambda: results, 'one result', lambda: '`results` is empty')
    expect(rover.has_stored and len(results) == 1 and getattr(results[0], 'successful', False),
           'one result, which is successful', f'`results` is `{results!r}`')


GUARD = '5.3d · A guard from an empty file'
program = Exercise('5.3d', 'A guard from an empty file', CHAPTER, PROGRAM, node_name='guard', hints=(
    'The constructor declares the limit, makes two clients (`GetParameters` and `SetParameters`, of `/rover`) and a '
    'timer. `main` is that of every node.',
    'The timer’s callback sends the question with `call_async`, and leaves the rest to a callback of the future: '
    '`future.add_done_callback(self.on_speed)`. If `service_is_ready()` is false, it returns at once.',
    '`on_speed` reads `future.result().values[0].integer_value`. If that is above the limit, it sends '
    "`Parameter('max_speed_rpm', value=limit).to_parameter_msg()`, and another callback logs the reason of a result "
    'that is not `successful`.'))
require_program(program, 'guard_node.py', GUARD)


class NotesTimes(Rover):
    """Notes when it is asked for a value."""

    def __init__(self) -> None:
        self.times_asked: list[float] = []
        super().__init__()

    def get_parameter(self, name: str) -> Parameter:
        self.times_asked.append(time.monotonic())
        return super().get_parameter(name)


def start_rover(trial: Trial, guard: Program, rover_class: type[RoverT], rpm: int = 100) -> RoverT:
    """Put a rover beside the guard."""
    return trial.start(rover_class, namespace=guard.namespace, ros_args=['-p', f'max_speed_rpm:={rpm}'])


def expect_speed(trial: Trial, guard: Program, rover: Rover, rpm: int, when: str) -> None:
    """Expect the guard to have changed the speed of a rover, soon."""
    client = trial.client(rover)
    try:
        trial.wait(lambda: client.get_parameter('max_speed_rpm') == rpm, f'the rover holds {rpm} rpm {when}',
                   lambda: f'it holds {client.get_parameter("max_speed_rpm")}')
    except NotYet:
        trial.client(guard.node).list_parameters()  # a guard that waits in a callback does not answer
        raise


@program.require('`limit_rpm` is an integer, 60 at first, and the guard answers also without a rover', see=HOW)
def lives_alone(trial: Trial) -> None:
    with running(trial, program) as guard:
        expect_start_value(trial.client(guard.node), 'limit_rpm', INTEGER, 60)
        # Its timer comes twice a second, so each of these times holds a callback from its begin to its end. On a busy
        # machine an answer may be late, but not in each of them.
        pauses = [longest_pause(trial, guard) for _ in range(2)]
        while min(pauses) > PAUSE_SEC and len(pauses) < 4:
            pauses.append(longest_pause(trial, guard))
        expect(min(pauses) <= PAUSE_SEC, 'an answer at once, also without a rover',
               f'again and again an answer takes {min(pauses):.1f} s or more. {STUCK}')


# Shorter than what wait_for_service() sleeps.
PAUSE_SEC = 0.15


def longest_pause(trial: Trial, guard: Program) -> float:
    """Ask the guard for 0.8 s, again and again, and return how long the slowest answer takes."""
    times = [time.monotonic()]
    while times[-1] < times[0] + 0.8:
        expect_accepted(trial, guard.node, {'limit_rpm': 60})
        times.append(time.monotonic())
    return max(after - before for before, after in itertools.pairwise(times))


@program.require('a rover at 100 rpm gets the limit', see=HOW)
def slows_down(trial: Trial) -> None:
    with running(trial, program) as guard:
        expect_speed(trial, guard, start_rover(trial, guard, Rover), 60, 'soon after it has come')


@program.require('the limit can be changed meanwhile', see=HOW)
def follows_limit(trial: Trial) -> None:
    with running(trial, program) as guard:
        take_type_for_granted(trial.client(guard.node), INTEGER, 'limit_rpm')
        rover = start_rover(trial, guard, Rover)
        for rpm in (45, 30):
            expect_accepted(trial, guard.node, {'limit_rpm': rpm})
            expect_speed(trial, guard, rover, rpm, f'once `limit_rpm = {rpm}` is stored')


@program.require('a rover that is slow enough is left alone', see=HOW)
def leaves_alone(trial: Trial) -> None:
    with running(trial, program) as guard:
        take_type_for_granted(trial.client(guard.node), INTEGER, 'limit_rpm')
        rover = start_rover(trial, guard, NotesTimes, 50)
        for limit_rpm, more in ((60, 6), (50, 2)):  # it is slower than the limit, and then just as fast
            expect_accepted(trial, guard.node, {'limit_rpm': limit_rpm})
            rover.times_asked.clear()
            wait(lambda more=more: len(rover.times_asked) > more or rover.has_stored, TIME_LIMIT_SEC)  # type: ignore[misc]
            expect(not rover.has_stored, f'nothing is set while the rover holds 50 rpm and the limit is {limit_rpm}',
                   f'the guard has set `max_speed_rpm` to {rover.get_parameter("max_speed_rpm").value}')
            times = rover.times_asked
            expect(len(times) > more and times[more] - times[0] < more * 0.8,
                   'the rover is asked for its speed twice a second', f'it has been asked {len(times)} times in '
                   f'{times[-1] - times[0] if times else TIME_LIMIT_SEC:.1f} s')


@program.require('the reason of a rover that rejects is logged, and the guard goes on', see=HOW)
def logs_reason(trial: Trial) -> None:
    with running(trial, program) as guard:
        take_type_for_granted(trial.client(guard.node), INTEGER, 'limit_rpm')
        start_rover(trial, guard, KeepsSpeed)
        guard.expect_line(KeepsSpeed.words, f'when the rover says “{KeepsSpeed.words}”')
        expect_accepted(trial, guard.node, {'limit_rpm': 50})


require_ends(program, GUARD)


EXERCISES = (order, supervise, read, program)
