"""Exercises of chapter 1: order a drive, bring a robot to its goal by parameters alone, and turn a number into a
parameter."""

import math
from typing import Any, NamedTuple

from rclpy.parameter import Parameter

from param_tools.node.client import ParameterClient
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import ClientInCorner, WithSecondJudge, derive, expect_fixed_type, run_lines
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, describe_error, expect
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.views.drawing import driving
from param_tutorial.views.robot import vehicle_of

CHAPTER = '01_what_are_parameters'
WORDS = 'The words'
OWN = 'Two robots of one class'
NUMBER = 'Why not write the number into the program?'
DONE = 'Ask once, or each time'
START = 'Fixed at the start'

COLD_C = -10
GAP_M, GAP_TOLERANCE_M = 0.5, 0.01
SPEED_LIMIT_MPS = 1.0
TIME_SEC = 5.0

park = Exercise('1b', 'Park at the line', CHAPTER, DICTIONARY, hints=(
    'Try it on a robot of your own, a new one: `robot = ros.add(ClawbotNode)`, then '
    '`ParameterClient(robot).set_parameters(settings)`, then press Drive. For the cold, set its '
    '`simulation.ambient_temperature_c` to -10.',
    'The safety mode stops the robot where it believes that the wall is 20 cm away. What it believes depends on where '
    'it thinks its sensor is. In which direction does the stop move when `sensor_offset_meters` gets smaller?',
    'A wheel with a radius of 0.1 m rolls 0.63 m in one turn, so 100 rpm are 1.05 m/s. You need four parameters: the '
    'offset, the speed, the acceleration, and the temperature.'))


class Patient(ClawbotNode):
    """A Clawbot for which time passes only when the check says so."""

    def __init__(self) -> None:
        super().__init__(real_time=False)


class Drive(NamedTuple):
    """How a drive went."""

    word: str
    """STOPPED or CRASHED."""
    gap_m: float
    seconds: float
    fastest_mps: float


def drive(trial: Trial) -> Drive:
    """Let a new robot drive with the learner's settings, on a cold morning, until it is at rest.

    :raises NoUse: it does not drive at all.
    """
    robot: Patient = trial.start(Patient, ros_args=['-p', f'simulation.ambient_temperature_c:={COLD_C}'])
    trial.client(robot).set_parameters(trial.work)
    robot.drive()
    end = robot.step(math.inf)
    trial.picture = driving.replay(vehicle_of(robot, robot.motion[0]))
    if end.word == 'WAITING':
        raise NoUse('a robot that drives', f'it is waiting: {robot.waiting_for()}')
    corners = robot.velocity_over_time()
    return Drive(end.word, robot.settings.track_m - end.position_m, robot.motion[0].duration_sec,
                 max(speed_mps for _, speed_mps in corners))


@park.require('the robot accepts each of your settings', see=WORDS)
def accepted(trial: Trial) -> None:
    if not trial.work:
        raise NoUse('at least one parameter and its value', 'there is no setting yet')
    for name in trial.work:
        if not isinstance(name, str):
            raise NoUse('the names of parameters, as strings', f'`{name!r}` is not a string')
        if name.startswith('simulation.'):
            raise NoUse('settings of the robot itself', f'`{name}` is a setting of the world around it: the check '
                        'keeps the weather, the track, and the wheels as they are')
    try:
        results = trial.client(trial.start(Patient)).set_parameters(trial.work)
    except (TypeError, ValueError) as error:
        raise NoUse('values that a parameter can hold', describe_error(error)) from None
    rejected = [str(result) for result in results if not result.successful]
    if rejected:
        raise NoUse('no value is rejected', '; '.join(rejected))


@park.require(f'it pulls away at {COLD_C} °C', see=OWN)
def starts(trial: Trial) -> None:
    drive(trial)


@park.require(f'it never goes faster than {SPEED_LIMIT_MPS:g} m/s', see='A change, drawn')
def slowly(trial: Trial) -> None:
    fastest_mps = drive(trial).fastest_mps
    expect(fastest_mps <= SPEED_LIMIT_MPS, f'at most {SPEED_LIMIT_MPS:.2f} m/s', f'it gets up to {fastest_mps:.2f} m/s')


@park.require(f'it stops {GAP_M} m from the wall, to the centimeter', see=OWN)
def stops(trial: Trial) -> None:
    end = drive(trial)
    if end.word != 'STOPPED':
        raise NoUse('it stops by itself', 'it has run into the wall')
    expect(abs(end.gap_m - GAP_M) <= GAP_TOLERANCE_M, f'{GAP_M:.2f} m', f'it stops {end.gap_m:.2f} m from the wall')


@park.require(f'it is at rest within {TIME_SEC:g} s', see='Change it')
def in_time(trial: Trial) -> None:
    seconds = drive(trial).seconds
    expect(seconds <= TIME_SEC, f'at most {TIME_SEC:.2f} s', f'it takes {seconds:.2f} s')


free = Exercise('1c', 'Free a number', CHAPTER, NODE_CLASS, node_name='pump', hints=(
    'The robot in the section “Why not write the number into the program?” has been through this: compare '
    '`HardCoded` with `WithParameter`.',
    'One line is new, and one is different. The new one declares the parameter, in the constructor: '
    '`self.declare_parameter(name, 2.5)`. The other one asks for its value, in place of the number.',
    '`self.get_parameter(name).value` is the value at the moment when you ask. So ask in `run`, each time.'))
PARAMETER = 'liters_per_min'


def pump(trial: Trial, *ros_args: str) -> tuple[Any, ParameterClient]:
    """Start the learner's pump, and return it with a client.

    :raises NoUse: it does not have the parameter.
    """
    node = trial.start(ros_args=ros_args)
    client = trial.client(node)
    if PARAMETER not in client.list_parameters():
        raise NoUse(f'a parameter `{PARAMETER}`', 'the pump has none of that name')
    return node, client


def expect_pumped(trial: Trial, node: Any, minutes: float, rate: float, before: float = 0.0) -> None:
    """Expect what the pump has counted after one more run, at a rate in liters per minute.

    :raises NoUse: it has not: each other requirement would meet the same.
    """
    try:
        trial.call(f'`run({minutes})`', node.run, minutes)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    wanted, counted = before + rate * minutes, node.liters
    is_right = isinstance(counted, (int, float)) and math.isclose(counted, wanted)
    if not is_right:
        raise NoUse(f'`liters` is {wanted:g} after `run({minutes})` at {rate:g} liters per minute',
                    f'`liters` is `{counted!r}`' + (f'; before, it was {before:g}' if before else ''))


@free.require(f'`{PARAMETER}` is a double, and 2.5 at the start', see=NUMBER)
def declared(trial: Trial) -> None:
    node, client = pump(trial)
    found, value = client.describe_parameter(PARAMETER).type.label, client.get_parameter(PARAMETER)
    if (found, value) != ('double', 2.5):
        raise NoUse('a double, 2.5', f'type {found}, value `{value!r}`')
    expect_pumped(trial, node, 4, 2.5)
    expect_fixed_type(client, PARAMETER)


@free.require(f'started with `-p {PARAMETER}:=4.0`, it pumps 40 liters in ten minutes', see=START)
def overridden(trial: Trial) -> None:
    for rate in (4.0, 1.25):
        node, client = pump(trial, '-p', f'{PARAMETER}:={rate}')
        value = client.get_parameter(PARAMETER)
        expect(value == rate, f'`{PARAMETER}` starts at {rate}', f'it starts at `{value!r}`')
        expect_pumped(trial, node, 10, rate)


@free.require('a change counts from the next `run` on, and what was pumped before is kept', see=DONE)
def changed(trial: Trial) -> None:
    node, client = pump(trial)
    expect_pumped(trial, node, 10, 2.5)
    before = 25.0
    for rate, minutes in ((1.0, 10), (0.0, 5), (7.5, 0.5), (2.5, 2)):
        client.set_parameter(PARAMETER, rate).raise_for_reason()
        for _ in range(2):
            expect_pumped(trial, node, minutes, rate, before)
            before += rate * minutes
    judged: Any = trial.start(derive(WithSecondJudge, trial.work))
    judged.rejects = True
    trial.client(judged).set_parameter(PARAMETER, 9.0)
    rate = judged.get_parameter(PARAMETER).value
    trial.call('`run(1)`', judged.run, 1)
    expect(judged.liters != 9.0 or rate == 9.0, f'`liters` is {rate:g} after `run(1)` if 9.0 is rejected',
           f'`liters` is `{judged.liters!r}`: that value was rejected in the end, and the parameter never held it')


order = Exercise('1a', 'Put a drive in order', CHAPTER, TEXT, hints=(
    'A line can use a name only after another line has created it. Which line creates `client`?',
    'The robot drives off when `robot.drive()` is called, with the values that it has at that moment. So what should '
    'hold for the whole drive comes before that line.'))
LIMIT_RPM = 50


class Noting(Patient):
    """A Clawbot without safety mode, which notes what holds whenever it drives off."""

    def __init__(self) -> None:
        super().__init__()
        self.starts: list[dict[str, Any]] = []
        self.set_parameters([Parameter('enable_safety_mode', value=False)])

    def drive(self) -> None:
        names = ('max_speed_rpm', 'enable_safety_mode')
        self.starts.append({name: self.get_parameter(name).value for name in names})
        super().drive()


def ordered(trial: Trial) -> Noting:
    """Run the learner's lines with a new robot."""
    robot = trial.start(Noting)
    run_lines(trial, robot=robot, ParameterClient=ClientInCorner, Parameter=Parameter)
    if not robot.starts:
        raise NoUse('the robot drives', 'nothing has made it drive')
    return robot


@order.require('the lines run to their end, and the robot drives once', see=WORDS)
def drives_once(trial: Trial) -> None:
    starts = ordered(trial).starts
    expect(len(starts) == 1, 'it drives off once', f'it drives off {len(starts)} times')


def _and_later(found: object, later: object) -> str:
    return '' if found == later else f', and becomes `{later!r}` only later'


@order.require(f'it drives at {LIMIT_RPM} rpm at most, from the start to the end', see='Change it')
def limited(trial: Trial) -> None:
    robot = ordered(trial)
    found, later = robot.starts[0]['max_speed_rpm'], robot.get_parameter('max_speed_rpm').value
    expect(found <= LIMIT_RPM, f'`max_speed_rpm` is at most {LIMIT_RPM} when the robot drives off',
           f'it is `{found!r}`{_and_later(found, later)}')
    expect(later <= LIMIT_RPM, f'`max_speed_rpm` stays at most {LIMIT_RPM}', f'it becomes `{later!r}` during the drive')


@order.require('the safety mode is on when it drives off, and the robot stops in front of the wall', see='Break it')
def safely(trial: Trial) -> None:
    robot = ordered(trial)
    end = robot.step(math.inf)
    trial.picture = driving.replay(vehicle_of(robot, robot.motion[0]))
    found, later = robot.starts[0]['enable_safety_mode'], robot.get_parameter('enable_safety_mode').value
    expect(found is True, '`enable_safety_mode` is `True` when the robot drives off',
           f'it is `{found!r}`{_and_later(found, later)}')
    expect(end.word == 'STOPPED', 'it stops by itself', f'it is waiting: {robot.waiting_for()}'
           if end.word == 'WAITING' else 'it has run into the wall')


EXERCISES = (order, park, free)
