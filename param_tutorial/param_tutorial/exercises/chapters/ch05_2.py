"""Exercises of chapter 5.2: the driver judges requests and start values, and acts on what is stored; faults to hunt."""

import contextlib
import time
from collections.abc import Iterator, Mapping
from typing import Any

from rclpy.node import Node

from param_tools.errors import CallbackError
from param_tools.ros.node_log import LogLine
from param_tools.ros.rclpy_private import has_judge
from param_tools.values import DOUBLE, INTEGER
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    WithSecondJudge,
    derive,
    expect_accepted,
    expect_declared,
    expect_follows,
    expect_left_alone,
    expect_rejected,
    take_type_for_granted,
)
from param_tutorial.exercises.steps import DRIVER, Bench, expect_commands, expect_speed
from param_tutorial.exercises.trial import (
    NoStart,
    NotTried,
    NotYet,
    NoUse,
    Trial,
    describe_error,
    expect,
    overrides,
    take_for_granted,
)

CHAPTER = '05_2_with_a_callback'
JUDGE = 'A rule about two values'
START = 'Who judges the start?'
TOO_EARLY = 'Acting too early'
ACT = 'Acting on what is stored'
SPEED, STOP = 'max_speed_mps', 'stop_distance_m'


def expect_working(trial: Trial, node: Node, new: Mapping[str, object], because: str = '') -> None:
    """Expect a request that breaks no rule to be accepted.

    :param because: What to think of if it is rejected.
    :raises NoUse: it is not, which would come to light in each requirement.
    """
    try:
        expect_accepted(trial, node, new, because)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None


@contextlib.contextmanager
def answering() -> Iterator[None]:
    """Raise NoUse in place of what a callback raises: it would come to light in each requirement."""
    try:
        yield
    except CallbackError as error:
        raise NoUse('an answer', describe_error(error)) from None


def start_driver(trial: Trial, start: Mapping[str, float] | None = None, *,
                 node_class: type[Node] | None = None) -> Any:
    """Start the learner's driver, which has its two parameters.

    :param start: Values to start with, in place of the defaults.
    :param node_class: The learner's class, or derived from it.
    """
    try:
        driver = trial.start(node_class, ros_args=overrides(start or {}))
    except NoStart as error:
        if 'ParameterNotDeclared' not in error.happened:
            raise
        raise NoStart(error.expected, f'{error.happened}. The declarations come first: a callback that is '
                      'registered before them is asked about each of them') from None
    try:
        take_type_for_granted(trial.client(driver), DOUBLE, SPEED, STOP)
    except NotTried:
        raise NoUse(f'doubles `{SPEED}` and `{STOP}`, as chapter 4 declares them', 'the node lacks one') from None
    return driver


def is_nobody_asked(driver: Node) -> str:
    """Return what to think of if a driver accepts everything."""
    return '' if has_judge(driver) else ('. No callback of yours is asked: a method alone is none before '
                                         '`add_on_set_parameters_callback` gets it')


judge = Exercise('5.2a', 'Your driver judges', CHAPTER, DRIVER, node_name='driver', hints=(
    'You need a method that takes `parameters` and returns a `SetParametersResult` on each way out, and a line in the '
    'constructor, after the declarations, that gives it to `add_on_set_parameters_callback`.',
    'A request may hold one of the two values, or both. Begin with the stored ones, and let the proposed ones '
    "replace them: `new = {p.name: p.value for p in parameters}`, then `new.get('max_speed_mps', stored)`.",
    'The rule is one comparison: `speed_mps ** 2 / 2 / BRAKING_MPS2 > stop_m`. If it is true, return '
    "`SetParametersResult(successful=False, reason=f'…')`."))


@judge.require('a value that leaves too little room to brake is rejected, with a reason', see=JUDGE)
@answering()
def rejects(trial: Trial) -> None:
    driver = start_driver(trial)
    for good in ({SPEED: 0.8}, {SPEED: 0.0}, {STOP: 0.3}, {'use_sim_time': False}, {STOP: 0.5}, {SPEED: 0.5}):
        expect_working(trial, driver, good)
    for bad in ({SPEED: 1.2}, {SPEED: 2.0}, {STOP: 0.1}):
        expect_rejected(trial, driver, bad, is_nobody_asked(driver))


_STORED = '. What counts for the other value is what is stored at that moment'


@judge.require('the other value is the one that is stored at that moment', see=JUDGE)
@answering()
def uses_stored(trial: Trial) -> None:
    driver = start_driver(trial)
    for good in ({STOP: 3.0}, {SPEED: 2.0}, {STOP: 2.5}):
        expect_accepted(trial, driver, good, _STORED)
    expect_rejected(trial, driver, {STOP: 1.5}, is_nobody_asked(driver) or _STORED)
    for good in ({SPEED: 1.0}, {STOP: 1.0}):
        expect_accepted(trial, driver, good, _STORED)
    expect_rejected(trial, driver, {SPEED: 1.8}, _STORED)
    expect_accepted(trial, start_driver(trial, {STOP: 3.0}), {SPEED: 2.0}, _STORED)


_TOGETHER = '. Each proposed value has to be compared with the other proposed one, not with the stored one'


@judge.require('both values of one request are judged together', see=JUDGE)
@answering()
def together(trial: Trial) -> None:
    driver = start_driver(trial)
    for names in ((SPEED, STOP), (STOP, SPEED)):
        for values, is_good in (((2.0, 2.5), True), ((0.5, 0.5), True), ((0.9, 0.2), False), ((1.5, 0.5), False)):
            asked = dict(zip((SPEED, STOP), values, strict=True))
            (expect_accepted if is_good else expect_rejected)(
                trial, driver, {name: asked[name] for name in names}, is_nobody_asked(driver) or _TOGETHER)


@judge.require('it still stops before the wall, and drives at the speed that is stored', see=TOO_EARLY)
@answering()
def drives(trial: Trial) -> None:
    take_for_granted(trial, rejects)
    bench = trial.start(Bench)
    driver = start_driver(trial, node_class=derive(WithSecondJudge, trial.work))
    bench.measure(5.0)
    expect_commands(trial, bench)
    expect_accepted(trial, driver, {SPEED: 0.8})
    expect_speed(trial, bench, 0.8, 'once `max_speed_mps = 0.8` is stored')
    driver.rejects = True
    trial.client(driver).set_parameter(SPEED, 0.3)
    expect_speed(trial, bench, 0.8, 'still, when a second judge has rejected 0.3')
    bench.measure(0.3)
    expect_speed(trial, bench, 0.0, '0.3 m before the wall')


acts = Exercise('5.2b', 'The start, and the act', CHAPTER, DRIVER, node_name='driver', hints=(
    'The start: after the declarations, the constructor asks your own judge about '
    "`self.get_parameters(['max_speed_mps', 'stop_distance_m'])`. If the result is not `successful`, it raises "
    '`ValueError(result.reason)`.',
    'The act: a second method, registered with `add_post_set_parameters_callback`. It gets a list of parameters, '
    "asks each for its `name`, and logs with `self.get_logger().info(f'…')`."))


@acts.require('it does not start with values that break the rule', see=START)
def starts_only_right(trial: Trial) -> None:
    start_driver(trial, {SPEED: 2.0, STOP: 2.5})
    for start in ({SPEED: 2.0}, {STOP: 0.1}, {SPEED: 1.8, STOP: 1.0}):
        try:
            driver = start_driver(trial, start)
        except NoStart as error:
            expect(isinstance(error.__context__, ValueError), 'a `ValueError` from the constructor', error.happened)
            continue
        held = ' and '.join(f'`{name} = {driver.get_parameter(name).value}`' for name in (SPEED, STOP))
        raise NotYet('it does not start with ' + ' '.join(f'`-p {name}:={value}`' for name, value in start.items()),
                     f'it started, with {held}')


@acts.require('it judges requests as before', see=JUDGE)
def judges(trial: Trial) -> None:
    rejects(trial)
    uses_stored(trial)
    together(trial)


def lines_about_speed(trial: Trial, driver: Node, heard: list[LogLine]) -> list[str]:
    """Return what a driver has logged about its speed, up to now, of the lines that have been heard."""
    mark = f'the check has read the log up to here ({time.time_ns()})'
    trial.ros.run(lambda: driver.get_logger().fatal(mark), 'log')
    trial.wait(lambda: any(each.text == mark for each in list(heard)), 'a node that logs', lambda: 'nothing comes')
    return [each.text for each in list(heard) if f'{SPEED} is now' in each.text]


@acts.require('it logs each `max_speed_mps` that is stored, and none that is not', see=ACT)
@answering()
def logs_stored(trial: Trial) -> None:
    heard: list[LogLine] = []
    stop_listening = trial.ros.node_log.on_line(heard.append)
    try:
        driver = start_driver(trial, node_class=derive(WithSecondJudge, trial.work))
        before = lines_about_speed(trial, driver, heard)
        for new in ({SPEED: 0.8}, {STOP: 0.6, SPEED: 0.3}):
            expect_accepted(trial, driver, new)
            lines, wanted = lines_about_speed(trial, driver, heard), f'{SPEED} is now {new[SPEED]}'
            expect(len(lines) > len(before) and wanted in lines[-1], f'`{wanted}` in the log once it is stored',
                   f'the last line of that kind is `{lines[-1]}`' if lines else 'it logs no line of that kind')
            before = lines
        for name, value, rejects_too, when in (
                (SPEED, 1.7, False, '`max_speed_mps = 1.7` breaks the rule'),
                (SPEED, 0.7, True, 'a second judge rejects `max_speed_mps = 0.7`'),
                (STOP, 0.9, False, 'only `stop_distance_m` is set')):
            driver.rejects = rejects_too
            trial.client(driver).set_parameter(name, value)
            lines = lines_about_speed(trial, driver, heard)
            expect(lines == before, f'no line `{SPEED} is now …` when {when}', f'it logs `{lines[-1]}`'
                   + (': an on-set callback has only a proposal' if name == SPEED else ''))
    finally:
        stop_listening()


@acts.require('it drives as before', see=TOO_EARLY)
def drives_as_before(trial: Trial) -> None:
    take_for_granted(trial, judges)
    drives(trial)


hunt = Exercise('5.2c', 'Hunt three faults', CHAPTER, NODE_CLASS, node_name='door', hints=(
    "Put the door on the stage and ask it: `ParameterClient(ros.add(Door)).set_parameters_atomically({'open_percent': "
    "50, 'force_percent': 150})`.",
    'One fault judges what is none of its business, one is a `return` that comes too soon, and one acts on a '
    'proposal.',
    'The rule is about two names, so ask for them first. The last `return` belongs after the loop. What moves the '
    'motor belongs in a post-set callback.'))


@hunt.require('each of the two takes percentages, and every other value is rejected, with a reason', see=JUDGE)
@answering()
def judges_each(trial: Trial) -> None:
    door = trial.start()
    for name in ('open_percent', 'force_percent'):
        for value in (50, 0, 100):
            expect_working(trial, door, {name: value})
        for wrong in (101, -1, 1000, 'wide', 12.5):
            expect_rejected(trial, door, {name: wrong})
    for both in ({'open_percent': 50, 'force_percent': 150}, {'force_percent': 50, 'open_percent': 150},
                 {'force_percent': -1, 'open_percent': 50}, {'open_percent': -1, 'force_percent': 50}):
        expect_rejected(trial, door, both)
    for name, start in (('open_percent', 0), ('force_percent', 50)):
        expect_declared(trial, name, INTEGER, start)


@hunt.require('other parameters are left alone', see=JUDGE)
def leaves_others(trial: Trial) -> None:
    class Labeled(trial.work):  # type: ignore[name-defined,misc]  # a subclass, as another person may write it
        def __init__(self) -> None:
            super().__init__()
            self.declare_parameter('label', 'north')
            self.declare_parameter('height_mm', 2100)

    Labeled.__name__ = trial.work.__name__
    expected = 'a subclass may have parameters of its own, `label` and `height_mm`'
    try:
        door = trial.start(Labeled)
    except NoStart as error:
        raise NotYet(expected, f'{error.happened}. The callback is called for them, too') from None
    for name, value in (('label', 'south'), ('height_mm', 2300), ('use_sim_time', False)):
        expect_accepted(trial, door, {name: value}, '. The rule is about two other parameters')


@hunt.require('the motor follows what is stored, and only that, from the start', see=ACT)
def motor(trial: Trial) -> None:
    door: Any = expect_follows(trial, 'motor_percent', [
        ({'open_percent': 50}, 50), ({'force_percent': 20}, 50), ({'force_percent': 90, 'open_percent': 70}, 70),
        ({'open_percent': 0, 'force_percent': 30}, 0), ({'open_percent': 40}, 40)])
    expect_left_alone(trial, door, 'motor_percent', {'open_percent': 80})
    door.rejects = False
    expect_accepted(trial, door, {'force_percent': 10})
    expect(door.motor_percent == 40, '`self.motor_percent` is still `40` after the next change',
           f'it is `{door.motor_percent!r}`: a value that was rejected has come through')
    door = trial.start(ros_args=['-p', 'open_percent:=35'])
    found = getattr(door, 'motor_percent', None)
    expect(found == 35, '`self.motor_percent` is `35` after a start with `-p open_percent:=35`', f'it is `{found!r}`')


EXERCISES = (judge, acts, hunt)
