"""Exercises of chapter 1: two parameters that belong together, a number that becomes a parameter, and a default."""

import math
from typing import Any

from param_tools.node.client import ParameterClient
from param_tools.ros.waiting import wait
from param_tools.values import DOUBLE
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import WithSecondJudge, derive, expect_fixed_type, expect_start_value
from param_tutorial.exercises.programs import PROGRAM, START_SEC, running
from param_tutorial.exercises.steps import Bench, drive, expect_settings, expect_speed
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect

CHAPTER = '01_what_are_parameters'
TOUCH = 'Touch it'
BREAK = 'Break it'
WORDS = 'The words'
NUMBER = 'Why not write the number into the program?'
ONCE = 'Ask once, or each time'
START = 'Fixed at the start'
FILE = 'A default in a file'

FAST_MPS = 2.0
MOST_GAP_M = 1.0

fast = Exercise('1a', 'Fast and whole', CHAPTER, DICTIONARY, hints=(
    "A parameter and its value are written as in `'max_speed_mps': 2.0`, with a comma at the end of the line. The "
    'second parameter is the other one in the panel.',
    'How far does the robot go while it brakes? It can lose 1 m/s in each second, so from 2 m/s it takes 2 s, and '
    'drives 1 m/s on average.',
    'It needs 2 m, and a little more, because the driver hears of the distance a moment later. Move `stop_distance_m` '
    'to a value between 2 and 3, and press **Back to the start**.'))


@fast.require('the driver accepts each of your settings', see=WORDS)
def accepted(trial: Trial) -> None:
    expect_settings(trial)


@fast.require(f'the robot gets as fast as {FAST_MPS} m/s', see=TOUCH)
def speeds_up(trial: Trial) -> None:
    fastest_mps = drive(trial).fastest_mps
    expect(math.isclose(fastest_mps, FAST_MPS), f'{FAST_MPS:.2f} m/s', f'it gets up to {fastest_mps:.2f} m/s')


@fast.require('it stops in one piece', see=BREAK)
def stops(trial: Trial) -> None:
    end = drive(trial)
    expect(end.crash_speed_mps is None, 'it stops before the wall',
           f'it hits the wall at {end.crash_speed_mps or 0:.2f} m/s')


@fast.require(f'it stops at most {MOST_GAP_M:g} m from the wall', see=TOUCH)
def stops_near(trial: Trial) -> None:
    end = drive(trial)
    if end.crash_speed_mps is not None:
        raise NoUse('it stops before the wall', 'it has hit the wall')
    expect(end.gap_m <= MOST_GAP_M, f'at most {MOST_GAP_M:.2f} m', f'it stops {end.gap_m:.2f} m from the wall')


free = Exercise('1b', 'Free a number', CHAPTER, NODE_CLASS, node_name='pump', hints=(
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


@free.require('a change counts from the next `run` on, and what was pumped before is kept', see=ONCE)
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


own = Exercise('1c', 'Your own default', CHAPTER, PROGRAM, node_name='driver', hints=(
    'The second argument of `declare_parameter` is the default. Leave its dot: the default decides the type.',
    "The line becomes `self.declare_parameter('max_speed_mps', 0.8)`. Run the cell, so that it saves the file."))


@own.require('started without more words, `max_speed_mps` is a double, 0.8', see=FILE)
def starts_faster(trial: Trial) -> None:
    with running(trial, own) as program:
        try:
            expect_start_value(trial.client(program.node), 'max_speed_mps', DOUBLE, 0.8)
        except NotYet as error:
            raise NoUse(error.expected, error.happened) from None


@own.require('with `-p max_speed_mps:=1.5` it drives at 1.5 m/s, and near the wall it stops', see=START)
def still_drives(trial: Trial) -> None:
    with running(trial, own, '-p max_speed_mps:=1.5') as program:
        bench = trial.start(Bench, namespace=program.namespace)
        for distance_m, speed_mps in ((5.0, 1.5), (0.2, 0.0)):
            bench.measure(distance_m)
            # The two processes find each other's topics first, which a busy machine takes its time for.
            wait(lambda: bench.speeds_mps, START_SEC)
            expect_speed(trial, bench, speed_mps, f'when the wall is {distance_m} m away')


EXERCISES = (fast, free, own)
