"""Exercises of chapter 5.3: the tuner asks the driver for a value, and sets a slower one; and reading an answer."""

import inspect
import time
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import SetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.node.client import ParameterClient
from param_tools.ros.waiting import wait
from param_tools.values import DOUBLE
from param_tutorial.exercises.exercise import FUNCTION, Exercise
from param_tutorial.exercises.expectations import (
    awake,
    expect_accepted,
    expect_start_value,
    start_asking,
    take_type_for_granted,
)
from param_tutorial.exercises.programs import require_program
from param_tutorial.exercises.steps import TUNER, TUNER_PROGRAM, Silent, class_of, expect_entry_points, log_of
from param_tutorial.exercises.trial import (
    GROUP_IS_BUSY,
    STUCK,
    TIME_LIMIT_SEC,
    NotYet,
    NoUse,
    Trial,
    cleared,
    expect,
)

CHAPTER = '05_3_from_another_node'
ASK = 'Ask for a value'
WAITING = "Don't wait for it"
SILENCE = 'When nobody answers'
SET = 'Set a value'
ONE_BY_ONE = 'One by one, or all or nothing'
TUNING = '5.3b · It slows the driver down'


class Driver(Node):
    """The driver to be tuned. It notes how often it is asked for its speed, and what it is asked to store."""

    words = ''
    """Why it accepts no speed; empty if it does."""

    def __init__(self) -> None:
        self.times_asked: list[float] = []
        self.asked: list[Parameter] = []
        super().__init__('driver')
        self.declare_parameter('max_speed_mps', 0.5)
        self.declare_parameter('stop_distance_m', 0.5, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=5.0)]))
        self.add_on_set_parameters_callback(self.judge)

    def get_parameter(self, name: str) -> Parameter:
        if name == 'max_speed_mps':
            self.times_asked.append(time.monotonic())
        return super().get_parameter(name)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        self.asked += parameters
        return SetParametersResult(successful=not self.words, reason=self.words)


class Keeps(Driver):
    """Accepts no other speed."""

    words = 'not while I am climbing'


class Frozen(Silent):
    """A driver that never answers."""

    NAME = 'driver'


def at_speed(speed_mps: float) -> list[str]:
    """Return the words that start a driver with a speed."""
    return ['-p', f'max_speed_mps:={speed_mps}']


def expect_log(trial: Trial, tuner: Node, since_ns: int, text: str, when: str) -> None:
    """Expect a tuner to log a text."""
    def happened() -> str:
        lines = log_of(trial, tuner, since_ns)
        return f'its last line is `{lines[-1]}`' if lines else 'it logs nothing'

    trial.wait(lambda: any(text in each for each in log_of(trial, tuner, since_ns)), f'it logs `{text}` {when}',
               happened)


asks = Exercise('5.3a', 'It asks', CHAPTER, TUNER, node_name='tuner', hints=(
    'The constructor has two lines after `super().__init__`: one makes the client and keeps it in `self`, the other '
    'makes a timer that calls a method `ask` twice a second, every 0.5 s.',
    '`ask` has one line: `self.driver.get_parameters(names, callback=self.on_speed)`, with a list of names. It does '
    'not wait.',
    '`on_speed(self, future)` reads `future.result().values[0].double_value`, and logs it with '
    "`self.get_logger().info(f'max_speed_mps is {speed_mps}')`."))


@asks.require('`tuner_node.py` makes a node, whose client finds the services of `driver`', see=ASK)
def finds_driver(trial: Trial) -> None:
    trial.start(Driver)
    with awake():
        start_asking(trial)


@asks.require('it asks for `max_speed_mps` twice a second', see=WAITING)
def asks_twice(trial: Trial) -> None:
    driver = trial.start(Driver)
    with awake():
        start_asking(trial)
        driver.times_asked.clear()
        expect_questions(trial, driver)


def expect_questions(trial: Trial, driver: Driver | Frozen) -> None:
    """Expect a tuner to ask a driver for its speed twice a second."""
    before, count = len(driver.times_asked), 4
    wait(lambda: len(driver.times_asked) > before + count or trial.raised(), TIME_LIMIT_SEC)
    times = driver.times_asked[before:]
    awaits = isinstance(trial.work, type) and any(map(inspect.iscoroutinefunction, vars(trial.work).values()))
    expect(len(times) > count and times[count] - times[0] < count * 0.8, 'the driver is asked twice a second', (
        f'it is asked {len(times)} times in {times[-1] - times[0]:.1f} s' if len(times) > 1 else
        'it is asked once' if times else 'it is not asked') + (f'. {GROUP_IS_BUSY}' if awaits else ''))


@asks.require('it logs the value from each answer', see=ASK)
def logs_speed(trial: Trial) -> None:
    for speed_mps in (0.5, 1.25):
        with cleared(trial.ros), awake():
            since_ns = time.time_ns()
            driver = trial.start(Driver, ros_args=at_speed(speed_mps))
            tuner, when = start_asking(trial), f'when the driver holds {speed_mps}'
            if tuner.has_parameter('limit_mps'):  # the tuner of 5.3b, which acts on the value in place of a log
                expect_speed_set(trial, driver, tuner.get_parameter('limit_mps').value, when)
            else:
                expect_log(trial, tuner, since_ns, f'max_speed_mps is {speed_mps}', when)


@asks.require('it waits for no answer: it starts, and goes on, without a driver', see=WAITING)
def waits_for_none(trial: Trial) -> None:
    with awake():
        tuner = trial.start()
        expect_at_once(trial, tuner, 'without a driver')
    trial.start(Frozen)
    with awake():
        expect_at_once(trial, tuner, 'when the driver does not answer')


def expect_at_once(trial: Trial, tuner: Node, when: str) -> None:
    """Expect a tuner to answer for as long as its timer takes to come twice."""
    client = trial.client(tuner)
    until = time.monotonic() + 1.2
    while time.monotonic() < until:
        began = time.monotonic()
        client.list_parameters()
        took_sec = time.monotonic() - began
        expect(took_sec < 0.5, f'an answer at once {when}', f'it takes {took_sec:.1f} s. {STUCK}')
        expect(not trial.raised(), f'it goes on {when}', trial.raised())


tunes = Exercise('5.3b', 'It slows the driver down', CHAPTER, TUNER_PROGRAM, node_name='tuner', hints=(
    'Keep the future of each question, `self.question = self.driver.get_parameters(...)`. At the beginning of `ask`, '
    'the one from before can be canceled, if there is one. That is the deadline.',
    '`on_speed` begins with `if future.cancelled():`, logs a warning there, and returns. After that the answer is '
    'as before.',
    "If the speed is above the limit: `self.driver.set_parameters([Parameter('max_speed_mps', value=limit_mps)], "
    'callback=self.on_result)`. `on_result` looks at `future.result().results[0]`.'))


def start_tuner(trial: Trial, *words: str) -> tuple[Node, ParameterClient]:
    """Put the learner's tuner on the stage, with a client for its parameters.

    :raises NoUse: its file makes none.
    """
    tuner: Node = trial.start(class_of(trial.work), ros_args=words)
    trial.names.add(tuner.get_name())
    return tuner, trial.client(tuner)


def start_tuning(trial: Trial) -> tuple[Node, ParameterClient]:
    """Put it there if it has its limit, as the first requirement says."""
    tuner, client = start_tuner(trial)
    take_type_for_granted(client, DOUBLE, 'limit_mps')
    return tuner, client


@tunes.require('`limit_mps` is a double, and it starts at 0.3', see=TUNING)
def has_limit(trial: Trial) -> None:
    expect_start_value(start_tuner(trial)[1], 'limit_mps', DOUBLE, 0.3)


def expect_speed_set(trial: Trial, driver: Driver, speed_mps: float, when: str) -> None:
    """Expect a tuner to have changed the speed of a driver, soon."""
    def held() -> Any:
        return Node.get_parameter(driver, 'max_speed_mps').value

    trial.wait(lambda: held() == speed_mps, f'the driver holds {speed_mps} {when}', lambda: f'it holds {held()}')


@tunes.require('a driver that is faster gets the limit, whatever it is by then', see=SET)
def slows_down(trial: Trial) -> None:
    for start_mps in (0.5, 1.25):
        with cleared(trial.ros), awake():
            driver = trial.start(Driver, ros_args=at_speed(start_mps))
            tuner, _ = start_tuning(trial)
            expect_speed_set(trial, driver, 0.3, 'soon after the tuner has come')
            expect_accepted(trial, tuner, {'limit_mps': 0.2})
            expect_speed_set(trial, driver, 0.2, 'once `limit_mps = 0.2` is stored')


@tunes.require('a driver that is slow enough is left alone', see=SET)
def leaves_alone(trial: Trial) -> None:
    driver = trial.start(Driver, ros_args=at_speed(0.25))
    with awake():
        tuner, _ = start_tuning(trial)
        for limit_mps in (0.3, 0.25):  # it is slower than the limit, and then just as fast
            expect_accepted(trial, tuner, {'limit_mps': limit_mps})
            expect_questions(trial, driver)
            expect(not driver.asked, f'nothing is set while the driver holds 0.25 and the limit is {limit_mps}',
                   'the tuner has asked for ' + ', '.join(f'`{each.name} = {each.value}`' for each in driver.asked[:3]))


@tunes.require('the reason of a driver that rejects is logged', see=SET)
def tells_rejection(trial: Trial) -> None:
    trial.start(Keeps)
    with awake():
        since_ns = time.time_ns()
        tuner, _ = start_tuning(trial)
        expect_log(trial, tuner, since_ns, Keeps.words, f'when the driver says “{Keeps.words}”')


@tunes.require('a question without an answer ends with a warning, and the next one is asked', see=SILENCE)
def has_deadline(trial: Trial) -> None:
    with awake():
        tuner, _ = start_tuning(trial)
        expect_warning(trial, tuner, 'without a driver')
    frozen = trial.start(Frozen)
    with awake():
        trial.wait(lambda: frozen.times_asked, 'a driver that comes later is asked', lambda: 'it is not')
        expect_warning(trial, tuner, 'when the driver does not answer')
    trial.ros.remove(frozen)
    driver = trial.start(Driver)
    with awake():
        expect_speed_set(trial, driver, 0.3, 'soon after one has come that answers')
        expect_at_once(trial, tuner, 'all the time')


def expect_warning(trial: Trial, tuner: Node, when: str) -> None:
    """Expect a tuner to log one more warning, soon."""
    since_ns = time.time_ns()
    trial.wait(lambda: log_of(trial, tuner, since_ns, 'WARN', 'ERROR'), f'a warning in the log, {when}', lambda: (
        f'its last line is `{lines[-1]}`, and no warning' if (lines := log_of(trial, tuner, since_ns))
        else 'it logs nothing'))


require_program(tunes, 'tuner_node.py', TUNING)


@tunes.require('`setup.py` names the executable `tuner_node`', see=TUNING)
def is_installed(trial: Trial) -> None:
    expect_entry_points(trial, Path(trial.work).parents[1], 'tuner_node', 'driver_node')


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


@read.require('one rejection among three: its name, and the reason', see=ONE_BY_ONE)
def one(trial: Trial) -> None:
    found = expect_reasons(trial, Driver, {'max_speed_mps': 1.0, 'stop_distance_m': 9.0, 'use_sim_time': False})
    expect_reasons(trial, Driver, {'max_speed_mps': 'fast', 'stop_distance_m': 0.5, 'use_sim_time': False}, found)


@read.require('several rejections: all of them, also in the same words or without a word', see=ONE_BY_ONE)
def several(trial: Trial) -> None:
    expect_reasons(trial, Driver, {'max_speed_mps': 'fast', 'use_sim_time': False, 'stop_distance_m': 9.0})
    expect_reasons(trial, Judge, {'left_rpm': 2, 'note': 'now', 'right_rpm': 2, 'lift_rpm': 2})
    expect_reasons(trial, Judge, {'note': 'now', 'use_sim_time': False, 'lift_rpm': 2, 'left_rpm': 3, 'right_rpm': 4})


@read.require('no rejection: an empty dictionary', see=ONE_BY_ONE)
def none(trial: Trial) -> None:
    expect_reasons(trial, Driver, {'max_speed_mps': 1.0})


EXERCISES = (asks, tunes, read)
