"""Exercises of chapter 10.2: put names to values, read all parameters of another node, and let the tuner ask two."""

import math
import time
from collections.abc import Mapping
from textwrap import shorten

from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import NotesQuestions, awake, expect_no_gap, expect_no_wait, start_asking
from param_tutorial.exercises.steps import TUNER, Silent, log_of
from param_tutorial.exercises.trial import TIME_LIMIT_SEC, NotYet, NoUse, Trial, expect, take_for_granted

CHAPTER = '10_2_asking_another_node'
BY_NAME = 'Ask by name'
UNKNOWN = 'A name too many'
LIST_FIRST = ASK_TWICE = 'First the names, then the values'
SILENCE = 'When nobody answers'


class Rover(Node):
    """The robot to inspect, with values that are easily missed."""

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [
            ('speed', 0), ('offset', 0.0), ('label', ''), ('enabled', False), ('gains', [0.5, 0.0]),
            ('legs', ['left', '']), ('steps', [3, 0])])


class Sleigh(Node):
    """Has the same name as the rover, and other parameters.

    A client of default QoS keeps ten answers. There are more parameters, so an inspector that sends all its questions
    at once would miss some if this node were in another process.
    """

    def __init__(self) -> None:
        super().__init__('rover')
        self.declare_parameters('', [('reindeer', 9), ('bells.count', 12), ('bells.of.brass', True), ('a', 0.5)])
        for number in range(30):
            self.declare_parameter(f'gifts.number_{number}', number)


class Uncalibrated(Node):
    """A rover with parameters that are not set, between others."""

    def __init__(self) -> None:
        super().__init__('rover')
        for name in ('calibration', 'wear.left'):
            self.declare_parameter(name, Parameter.Type.DOUBLE)
            self.declare_parameter(f'{name}_count', 3)


inspect = Exercise('10.2b', 'Inspect a rover', CHAPTER, NODE_CLASS, node_name='inspector', hints=(
    'Create two clients in the constructor, and ask two questions: `list_parameters` for the names and, once they are '
    'there, `get_parameters` for the values. `Reader` does it.',
    '`call_async` returns a future. Await it in an `async def inspect`, or use '
    '`future.add_done_callback(self.on_names)`, which calls your method with the future. The names are in '
    '`future.result().result.names`; `zip` pairs names and values.',
    'An answer without values means that one of the parameters is not set: ask again, for each name separately.'))


def _asks_no_more(trial: Trial, inspector: NotesQuestions) -> bool:
    """True if a node does not go on asking because of what it has heard."""
    count = len(inspector.questions_noted)
    # The executor has set the last future when the first is over, has called what waited for it after the second, and
    # has gone on with what awaited it after the third.
    for _ in range(3):
        trial.ros.run(lambda: None, 'let the executor come round')
    return len(inspector.questions_noted) == count


def _lost(inspector: NotesQuestions) -> str:
    """Say how many questions have no answer, for a sentence; nothing if all have one."""
    count = inspector.count_unanswered()
    return f', and {count} of {len(inspector.questions_noted)} questions have no answer' if count else ''


def found_in(trial: Trial, rover_class: type[Node]) -> None:
    """Put a rover and the learner's inspector on the stage, let it inspect, and expect it to find everything."""
    rover = trial.start(rover_class)
    inspector = start_asking(trial)
    button = getattr(inspector, 'inspect', None)
    if not callable(button):
        raise NoUse('a method `inspect`', 'the class has none')
    held = trial.client(rover).get_parameters()
    wanted = {name: value for name, value in held.items() if value is not None}

    def has_found_all() -> bool:
        if not isinstance(inspector.found, Mapping):
            return False
        # A parameter that is not set may be there with None, or not.
        found = {name: values.normalize(value) for name, value in inspector.found.items()
                 if not (value is None and name in held)}
        return found.keys() == wanted.keys() and all(values.same(found[name], wanted[name]) for name in wanted)

    # In a group of its own, as the timer of the chapter's `Reader`.
    trial.press('`inspect()`', inspector, button, MutuallyExclusiveCallbackGroup())
    trial.wait(lambda: not inspector.count_unanswered() and _asks_no_more(trial, inspector) and has_found_all(),
               f'`self.found` is `{shorten(repr(wanted), 400)}`',
               lambda: f'it is `{shorten(repr(inspector.found), 400)}`{_lost(inspector)}')
    count, depth = inspector.most_open
    expect(count <= depth, f'at most {depth} questions are without an answer at once',
           f'{count} were, and the client keeps the last {depth} answers. With a rover in another process the others '
           f'are lost')
    if raised := trial.raised():  # under rclpy.spin it would be the node's end
        raise NoUse('no callback raises an exception', raised)


@inspect.require('`self.found` holds every parameter with its value, and `inspect()` does not block', see=BY_NAME)
def everything(trial: Trial) -> None:
    found_in(trial, Rover)
    expect_no_wait(trial, 'inspect')


@inspect.require('whatever the parameters are called, and however many there are', see=LIST_FIRST)
def any_names(trial: Trial) -> None:
    found_in(trial, Sleigh)


@inspect.require('parameters that are not set do not hide the others', see=UNKNOWN)
def unset(trial: Trial) -> None:
    found_in(trial, Uncalibrated)


protects = Exercise('10.2c', 'Your tuner asks two nodes', CHAPTER, TUNER, node_name='tuner', hints=(
    "A second client, `AsyncParameterClient(self, 'base')`, and a second timer, `self.create_timer(1.0, self.protect, "
    'callback_group=MutuallyExclusiveCallbackGroup())`. `protect` is an `async def`.',
    'A question with its deadline takes four lines, as in `Punctual`. Put them into a method of their own, `async def '
    'values_of(self, client, names)`, which returns a dictionary as your `with_names` does, or an empty one. Await it '
    'twice.',
    "The speed from which the base can stop is `math.sqrt(2 * base['max_acceleration_mps2'] * "
    "driver['stop_distance_m'])`. If the driver's is higher, set it, as `slow_down` does."))


class Base(Node):
    """The base. It counts the questions."""

    def __init__(self) -> None:
        self.times_asked = 0
        super().__init__('base')
        self.declare_parameters('', [('max_acceleration_mps2', 0.125), ('wall_m', 10.0)])

    def get_parameter(self, name: str) -> Parameter:
        self.times_asked += name == 'max_acceleration_mps2'
        return super().get_parameter(name)


class Driver(Node):
    """A driver that is slower than the tuner's limit, and may be too fast for the base. It notes requests."""

    def __init__(self) -> None:
        self.asked: list[Parameter] = []
        super().__init__('driver')
        self.declare_parameters('', [('max_speed_mps', 0.3), ('stop_distance_m', 0.25)])
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        self.asked += [each for each in parameters if each.name == 'max_speed_mps']
        return SetParametersResult(successful=True)


class Mute(Silent):
    """A base that never answers."""

    NAME = 'base'


def expect_speed(trial: Trial, driver: Driver, speed_mps: float, when: str) -> None:
    """Expect a tuner to have set the speed of a driver."""
    def held() -> float:
        return float(driver.get_parameter('max_speed_mps').value)

    trial.wait(lambda: math.isclose(held(), speed_mps, abs_tol=1e-3), f'the driver holds {speed_mps} {when}',
               lambda: trial.raised() or f'it holds {held()}')


def expect_warning(trial: Trial, tuner: Node, when: str) -> None:
    """Expect a tuner to log one more warning."""
    since_ns = time.time_ns()
    trial.wait(lambda: log_of(trial, tuner, since_ns, 'WARN', 'ERROR'), f'a warning in the log, {when}',
               lambda: trial.raised() or 'there is none')


@protects.require('the driver is no faster than the base can stop within its stop distance', see=ASK_TWICE)
def slows_down(trial: Trial) -> None:
    with awake():
        base, driver = trial.start(Base), trial.start(Driver)
        trial.start()
        expect_speed(trial, driver, 0.25, 'when the base can do 0.125 m/s², within 0.25 m')
        trial.client(driver).set_parameter('stop_distance_m', 0.16)
        expect_speed(trial, driver, 0.2, 'once it is to stop within 0.16 m')
        trial.client(base).set_parameter('max_acceleration_mps2', 0.03125)
        expect_speed(trial, driver, 0.1, 'once the base can do 0.03125 m/s²')


@protects.require('a driver that is slow enough is left alone', see=ASK_TWICE)
def leaves_alone(trial: Trial) -> None:
    take_for_granted(trial, slows_down)
    with awake():
        base, driver = trial.start(Base), trial.start(Driver, ros_args=['-p', 'max_speed_mps:=0.2'])
        trial.start()
        trial.wait(lambda: base.times_asked >= 3, '`/base` is asked once a second', lambda: (
            trial.raised() or f'it has been asked {base.times_asked} times in {TIME_LIMIT_SEC:.0f} s'))
        expect(not driver.asked, 'nothing is set while the driver holds 0.2',
               'the driver was asked for ' + ', '.join(f'{each.value}' for each in driver.asked[:2]))


@protects.require('a base that is silent or not there gets a warning, and is asked again', see=SILENCE)
def has_deadline(trial: Trial) -> None:
    take_for_granted(trial, slows_down)
    with awake():
        driver, tuner = trial.start(Driver), trial.start()
        expect_warning(trial, tuner, 'without a base')
        mute = trial.start(Mute)
        trial.wait(lambda: mute.times_asked, 'a base that comes later is asked', lambda: trial.raised() or 'it is not')
        expect_warning(trial, tuner, 'when the base does not answer')
        trial.ros.remove(mute)
        trial.start(Base)
        expect_speed(trial, driver, 0.25, 'soon after a base has come that answers')


fill = Exercise('10.2a', 'Fill three gaps', CHAPTER, FUNCTION, hints=(
    'The values come in the order of the names, and `zip` takes the first of both, then the second of both, and so on.',
    'Each value is a message with a field for each type. `parameter_value_to_python` returns the Python value.'))


def pairs(trial: Trial, *names: str) -> None:
    """Ask a rover for some values, and expect the learner's function to give each its name."""
    rover = trial.start(Rover)
    request = GetParameters.Request(names=list(names))
    answer = trial.ros.services.call(rover.get_fully_qualified_name(), 'get_parameters', request).values
    try:
        given = trial.call('the function', trial.work, list(names), list(answer))
    except NotYet as error:
        expect_no_gap(error.happened)
        raise NoUse(error.expected, error.happened) from None
    expect(isinstance(given, dict), 'a dictionary', f'it returned `{shorten(repr(given), 120)}`')
    held = trial.client(rover).get_parameters(names)
    found = {name: values.normalize(value) for name, value in given.items()}
    expect(found.keys() == held.keys() and all(values.same(found[name], held[name]) for name in held),
           f'`{dict(held)!r}`', f'it returned `{shorten(repr(given), 120)}`')


@fill.require('one name and one value', see=BY_NAME)
def one_pair(trial: Trial) -> None:
    pairs(trial, 'speed')


@fill.require('several, in the order of the names, whatever that is', see=BY_NAME)
def several_pairs(trial: Trial) -> None:
    pairs(trial, 'speed', 'label')
    pairs(trial, 'label', 'speed')


@fill.require('values of each type, also 0.0, an empty string and lists', see=BY_NAME)
def typed_pairs(trial: Trial) -> None:
    pairs(trial, 'gains', 'offset', 'enabled', 'label', 'legs', 'steps')


EXERCISES = (fill, inspect, protects)
