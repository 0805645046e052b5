"""Exercises of chapter 1: order a drive, bring a robot to its goal by parameters alone, and make a parameter of a
number."""

import math
from typing import Any, NamedTuple

from rclpy.parameter import Parameter

from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import client_in_corner, run_lines
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect
from param_tutorial.nodes.clawbot_node import ClawbotNode
from param_tutorial.parameters.client import ParameterClient
from param_tutorial.pictures import track
from param_tutorial.widgets.robot import vehicle_of

CHAPTER = '01_what_are_parameters'
WORDS = 'The words'
OWN = 'Each node has its own'
NUMBER = 'Why not simply write the number into the program?'
DONE = 'Accepted is not yet done'
START = 'Fixed at the start'

COLD_C = -10
GAP_M, GAP_TOLERANCE_M = 0.5, 0.01
SPEED_LIMIT_MPS = 1.0
TIME_SEC = 5.0

park = Exercise('1a', 'Park at the line', CHAPTER, DICTIONARY, hints=(
    'Try it on a robot of your own, a new one: `robot = ros.add(ClawbotNode)`, `client.set_parameters(settings)`, then '
    'press Drive. For the cold, set its `simulation.ambient_temperature_c` to -10.',
    'The safety mode stops where the robot believes to be 20 cm from the wall. What it believes depends on where it '
    'thinks its sensor sits: in which direction does the stop move when `sensor_offset_meters` gets smaller?',
    'A wheel with a radius of 0.1 m rolls 0.63 m in one turn, so 100 rpm are 1.05 m/s. And four parameters are '
    'needed: the offset, the speed, the acceleration and the temperature.'))


class Patient(ClawbotNode):
    """A Clawbot for which time passes only when the check says so."""

    def __init__(self) -> None:
        super().__init__(real_time=False)


class Drive(NamedTuple):
    """What became of a drive."""

    word: str
    """STOPPED or CRASHED."""
    gap_m: float
    seconds: float
    fastest_mps: float


def pulling_away(trial: Trial) -> Patient:
    """Let a new robot drive off with the learner's settings, on a cold morning."""
    robot: Patient = trial.start(Patient, ros_args=['-p', f'simulation.ambient_temperature_c:={COLD_C}'])
    trial.client(robot).set_parameters(trial.work)
    robot.drive()
    return robot


def drive(trial: Trial) -> Drive:
    """Let a new robot drive until it is at rest."""
    robot = pulling_away(trial)
    end = robot.step(math.inf)
    if end.word == 'WAITING':
        raise NotYet('a robot that drives', f'it is waiting: {robot.waiting_for()}')
    corners = robot.velocity_over_time()
    return Drive(end.word, robot.settings.track_m - end.position_m, robot.motion[0].duration_sec,
                 max(speed_mps for _, speed_mps in corners))


@park.require('the robot accepts each of your settings', see=WORDS)
def accepted(trial: Trial) -> None:
    if not trial.work:
        raise NoUse('at least one parameter and its value', 'there is no setting yet')
    for name in trial.work:
        if str(name).startswith('simulation.'):
            raise NoUse('settings of the robot itself', f'`{name}` is a setting of the world around it: the check '
                        'keeps the weather, the track and the wheels as they are')
    results = trial.client(trial.start(Patient)).set_parameters(trial.work)
    rejected = [result for result in results if not result.successful]
    expect(not rejected, 'no value is rejected', ''.join(map(str, rejected[:1])))


@park.require(f'it pulls away at {COLD_C} °C', see=OWN)
def starts(trial: Trial) -> None:
    drive(trial)


@park.require(f'it stops {GAP_M} m from the wall, to the centimetre', see=OWN)
def stops(trial: Trial) -> None:
    end = drive(trial)
    expect(end.word == 'STOPPED', 'it stops by itself', 'it has run into the wall')
    expect(abs(end.gap_m - GAP_M) <= GAP_TOLERANCE_M, f'{GAP_M:.2f} m', f'it stops {end.gap_m:.2f} m from the wall')


@park.require(f'it is there within {TIME_SEC:g} s', see='Change it')
def in_time(trial: Trial) -> None:
    end = drive(trial)
    expect(end.word == 'STOPPED', 'it stops by itself', 'it has run into the wall')
    expect(end.seconds <= TIME_SEC, f'at most {TIME_SEC:.2f} s', f'it takes {end.seconds:.2f} s')


@park.require(f'it is never faster than {SPEED_LIMIT_MPS:g} m/s', see='A change, drawn')
def slowly(trial: Trial) -> None:
    fastest_mps = drive(trial).fastest_mps
    expect(fastest_mps <= SPEED_LIMIT_MPS, f'at most {SPEED_LIMIT_MPS:.2f} m/s', f'it gets up to {fastest_mps:.2f} m/s')


@park.show
def parking(trial: Trial) -> str:
    robot = pulling_away(trial)
    return track.replay(vehicle_of(robot, robot.motion[0]))


free = Exercise('1b', 'Free a number', CHAPTER, NODE_CLASS, node_name='pump', hints=(
    'The robot in the section “Why not simply write the number into the program?” has been through this: compare '
    '`HardCoded` with `WithParameter`.',
    'Two lines change. One declares the parameter, in the constructor: `self.declare_parameter(name, 2.5)`. The other '
    'asks for its value where the number stands now.',
    '`self.get_parameter(name).value` is the value at the moment of asking. So ask in `run`, each time.'))
PARAMETER = 'litres_per_min'


def pump(trial: Trial, *ros_args: str) -> tuple[Any, ParameterClient]:
    """Start the learner's pump, and return it with a client; it has to have the parameter."""
    node = trial.start(ros_args=ros_args)
    client = trial.client(node)
    expect(PARAMETER in client.list_parameters(), f'a parameter `{PARAMETER}`', 'the pump has none of that name')
    return node, client


def run(trial: Trial, node: Any, minutes: int) -> None:
    trial.call(f'`run({minutes})`', node.run, minutes)


@free.require(f'`{PARAMETER}` is a double, and 2.5 at the start', see=NUMBER)
def declared(trial: Trial) -> None:
    _, client = pump(trial)
    found, value = client.describe_parameter(PARAMETER).type.label, client.get_parameter(PARAMETER)
    expect((found, value) == ('double', 2.5), 'a double, 2.5', f'type {found}, value `{value!r}`')


@free.require(f'started with `-p {PARAMETER}:=4.0`, it pumps 40 litres in ten minutes', see=START)
def overridden(trial: Trial) -> None:
    node, _ = pump(trial, '-p', f'{PARAMETER}:=4.0')
    run(trial, node, 10)
    expect(node.litres == 40, '40 litres', f'`litres` is `{node.litres!r}`' + (
        '. That is the number in the program, and the parameter says otherwise' if node.litres == 25 else ''))


@free.require('a change counts from the next `run` on, and what was pumped before is not forgotten', see=DONE)
def changed(trial: Trial) -> None:
    node, client = pump(trial)
    run(trial, node, 10)
    client.set_parameter(PARAMETER, 1.0).raise_for_reason()
    run(trial, node, 10)
    expect(node.litres == 35, '25 litres at the old rate and 10 at the new one', f'`litres` is `{node.litres!r}`' + (
        '. The change was accepted, and the pump goes on as before: it has asked too early' if node.litres == 50
        else ''))


order = Exercise('1c', 'Put a drive in order', CHAPTER, TEXT, hints=(
    'A name has to be there before a line can use it. Which line makes `client`?',
    'The robot drives off in the moment in which `robot.drive()` is called, with the values that it has then. So what '
    'should hold for the whole drive comes before that line.'))


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
    run_lines(trial, robot=robot, ParameterClient=client_in_corner, Parameter=Parameter)
    if not robot.starts:
        raise NoUse('the robot drives', 'nothing has made it drive')
    return robot


@order.require('the lines run to their end, and the robot drives once', see=WORDS)
def drives_once(trial: Trial) -> None:
    starts = ordered(trial).starts
    expect(len(starts) == 1, 'it drives off once', f'it drives off {len(starts)} times')


def expect_at_start(trial: Trial, name: str, wanted: object) -> None:
    robot = ordered(trial)
    found, later = robot.starts[0][name], robot.get_parameter(name).value
    expect(found == wanted, f'`{name}` is `{wanted!r}` when the robot drives off', f'it is `{found!r}`' + (
        ', and becomes what you want only later' if later == wanted else ''))


@order.require('when it drives off, the limit is 50 rpm', see='Change it')
def limited(trial: Trial) -> None:
    expect_at_start(trial, 'max_speed_rpm', 50)


@order.require('when it drives off, the safety mode is on, and the robot stops before the wall', see='Break it')
def safely(trial: Trial) -> None:
    expect_at_start(trial, 'enable_safety_mode', True)
    end = ordered(trial).step(math.inf)
    expect(end.word == 'STOPPED', 'it stops by itself', 'it has run into the wall' if end.word == 'CRASHED'
           else f'it is {end.word.lower()}')


EXERCISES = (order, park, free)
