"""Exercises of chapter 6.2: the driver's rate is read-only, declarations that say something else, and who rejects."""

import ast
from collections.abc import Mapping
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.values import DOUBLE_ARRAY, INTEGER, STRING
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    client_for,
    derive,
    expect_accepted,
    expect_answers,
    expect_declared,
    expect_no_start,
    expect_override,
    expect_range,
    expect_rejected,
)
from param_tutorial.exercises.steps import DRIVER, Bench, expect_commands, expect_speed, start_on_bench
from param_tutorial.exercises.trial import Trial, expect, overrides, take_for_granted

CHAPTER = '06_2_locks_types_and_order'
EFFECT = 'Accepted, and without effect'
FIXED = 'Fixed while the node runs'
FREE = 'A type that may change'
ARRAYS = 'Arrays'
ORDER = 'Who rejects, and in which order?'


rate = Exercise('6.2a', 'One rate for each run', CHAPTER, DRIVER, node_name='driver', hints=(
    'The declaration looks like those above it, with an `IntegerRange` in `integer_range=[...]`, and one more field.',
    'The field is `read_only=True`. An `IntegerRange` has whole numbers: `from_value=5, to_value=50`.',
    'The timer comes after the declaration: '
    "`self.create_timer(1 / self.get_parameter('rate_hz').value, self.drive)`."))


@rate.require('`rate_hz` is an integer, 10, from 5 to 50, with a description', see=EFFECT)
def declared(trial: Trial) -> None:
    expect_declared(trial, 'rate_hz', INTEGER, 10)
    client = client_for(trial, 'rate_hz')
    expect_range(client, 'rate_hz', 5, 50)
    expect(client.describe_parameter('rate_hz').description.strip(), 'a description of `rate_hz`', 'it is empty')


@rate.require('it is read-only, and each start may choose another', see=FIXED)
def fixed(trial: Trial) -> None:
    expect_answers(client_for(trial, 'rate_hz'), 'rate_hz', 'read only', 20, 10, because='`read_only` is not set')
    for rate_hz in (5, 50):
        expect_override(trial, 'rate_hz', str(rate_hz), rate_hz)


@rate.require('it sends that many commands a second', see=EFFECT)
def keeps_rate(trial: Trial) -> None:
    bench = trial.start(Bench)
    for rate_hz in (10, 25):
        driver = trial.start(ros_args=overrides({'rate_hz': rate_hz}))
        periods_ms = [each.timer_period_ns / 1e6 for each in driver.timers]
        expect(any(abs(each - 1000 / rate_hz) < 1 for each in periods_ms),
               f'a timer with a period of {1000 / rate_hz:g} ms after a start with `-p rate_hz:={rate_hz}`',
               ' and '.join(f'its timer has one of {each:g} ms' for each in periods_ms) or 'it has no timer')
        expect_commands(trial, bench)


@rate.require('it judges, drives and stops as before', see=EFFECT)
def as_before(trial: Trial) -> None:
    take_for_granted(trial, keeps_rate)
    driver, bench = start_on_bench(trial)
    for bad in ({'max_speed_mps': 2.0}, {'stop_distance_m': 0.1}, {'braking_mps2': 0.1}):
        expect_rejected(trial, driver, bad)
    expect_accepted(trial, driver, {'max_speed_mps': 0.75})
    expect_speed(trial, bench, 0.75, 'once `max_speed_mps = 0.75` is stored')
    bench.measure(0.3)
    expect_speed(trial, bench, 0.0, '0.3 m before the wall')
    expect_no_start(trial, overrides({'max_speed_mps': 2.0}), 'no start with `-p max_speed_mps:=2.0`',
                    'the node started')


mend = Exercise('6.2b', 'Fix three declarations', CHAPTER, NODE_CLASS, node_name='hoist', hints=(
    'Ask the hoist as it is: `ParameterClient(ros.add(Hoist)).describe_parameters()`. Compare what it says with the '
    'three sentences above.',
    'A description enforces nothing; `read_only` is another field of the descriptor. A parameter keeps its type '
    'unless its descriptor says otherwise.',
    'Declare `stops_m` with its type, `Parameter.Type.DOUBLE_ARRAY`. If it has no value then, set it to '
    "`Parameter('stops_m', Parameter.Type.DOUBLE_ARRAY, [])`."))


class NotesDefaults(Node):
    """A mixin: notes the default of each declaration."""

    defaults: dict[str, list[object]]

    def declare_parameters(self, *args: Any, **options: Any) -> list[Parameter]:
        noted = self.__dict__.setdefault('defaults', {})
        for name, *rest in options.get('parameters', args[1:2] and args[1]):
            noted.setdefault(name, []).extend(rest[:1])
        return super().declare_parameters(*args, **options)


def defaults(trial: Trial, name: str) -> list[list[object]]:
    """Return the lists that the learner's node declares a parameter with, other than the empty one.

    Each may be an override, too, and a node must not take that for its default.
    """
    node = trial.start(derive(NotesDefaults, trial.work))
    return [each for each in node.defaults.get(name, []) if isinstance(each, list) and each]


def expect_no_override(trial: Trial, name: str, word: str) -> None:
    """Expect the learner's node not to start with a value of another type."""
    expect_no_start(trial, ['-p', f'{name}:={word}'], f'no start with `-p {name}:="{word}"`, which has another type',
                    'the node started with it: the type may change')


@mend.require('`serial` is `H-01` and read-only, and a start with `-p serial:=H-07` gives another', see=FIXED)
def serial(trial: Trial) -> None:
    expect_declared(trial, 'serial', STRING, 'H-01')
    expect_answers(client_for(trial, 'serial'), 'serial', 'read only', 'H-02', 'H-01',
                   because='A description enforces nothing; `read_only` does')
    expect_override(trial, 'serial', 'H-07', 'H-07')
    expect_no_override(trial, 'serial', '7')


@mend.require('`label` starts as `north`, takes any string and nothing else, and cannot be deleted', see=FREE)
def label(trial: Trial) -> None:
    expect_declared(trial, 'label', STRING, 'north')
    client = client_for(trial, 'label')
    expect_answers(client, 'label', 'accepted', 'south', '7', '')
    for other in (7, 0.5, True, ['south']):
        result = client.set_parameter('label', other)
        expect(not result.successful, f'`label = {other!r}` is rejected', f'{result}. Its type may change')
    result = client.delete_parameter('label')
    expect(not result.successful, '`label` cannot be deleted', 'it was deleted')


@mend.require('`stops_m` takes a list of doubles, also an empty one, and is empty at the start', see=ARRAYS)
def stops(trial: Trial) -> None:
    expect_declared(trial, 'stops_m', DOUBLE_ARRAY, [])
    client = client_for(trial, 'stops_m')
    expect_answers(client, 'stops_m', 'accepted', [2.5, 10.0], [0.0], [])
    expect_answers(client, 'stops_m', 'wrong type', ['dock'], [1, 2], because='With dynamic typing everything goes in')
    for override in ([1.5, 2.5], *defaults(trial, 'stops_m')):
        expect_override(trial, 'stops_m', str(override), override)


class Oven(Node):
    """Bakes between 50 and 260 °C, and never at 225."""

    def __init__(self) -> None:
        super().__init__('oven')
        self.declare_parameter('target_c', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=50, to_value=260, step=25)]))
        self.declare_parameter('serial', 7, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=9, step=1)], read_only=True))
        self.declare_parameter('gain', 1, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters: list[Parameter]) -> SetParametersResult:
        """At 225 °C the door gets too hot."""
        too_hot = any(each.name == 'target_c' and each.value == 225 for each in parameters)
        return SetParametersResult(successful=not too_hot, reason='the door gets too hot')


foresee = Exercise('6.2c', 'Predict who rejects', CHAPTER, DICTIONARY, hints=(
    'Go through the checks in their order: declared, read-only, type, range, step, on-set callbacks. The first that '
    'fails decides the kind.',
    'Both ends of a range are valid. A range only counts for values of its own kind.',
    'Count the steps from 50: 75, 100, 125, and so on. Which of the requested values are among them, and which is an '
    'end?'))


KINDS = ('accepted', 'undeclared', 'read only', 'wrong type', 'out of range', 'off the step', 'rejected by the node')


def require_foresight(request: str, because: Mapping[object, str], see: str = ORDER) -> None:
    """Add the requirement to know the kind of the oven's answer to a request.

    :param request: As 'name = value'.
    """
    name, value = request.split(' = ')

    @foresee.require_prediction(request, see=see, because=because, words=KINDS)
    def answers(trial: Trial) -> Any:
        return trial.client(trial.start(Oven)).set_parameter(name, ast.literal_eval(value)).kind


require_foresight('target_c = 260', {
    'off the step': 'No step leads there, and yet there is something special about it',
    'out of range': 'The ends belong to a range'})
require_foresight('target_c = 110', {
    'accepted': 'The steps are 25 wide, and count from 50', 'out of range': 'It is between the ends'})
require_foresight('target_c = 275', {
    'off the step': 'rclpy looks at the ends before it counts steps'})
require_foresight('target_c = 225', {
    'accepted': 'The descriptor has nothing against it. Who is asked after the descriptor?',
    'off the step': '50 and seven steps of 25 are 225'})
require_foresight('target_c = 225.0', {
    'rejected by the node': 'The callback was not called: another check comes before it',
    'accepted': 'ROS converts nothing'})
require_foresight('serial = 7', {
    'accepted': 'rclpy does not compare the new value with the old one'}, FIXED)
require_foresight('serial = 12', {
    'out of range': 'It is out of range too, and that check comes later', 'accepted': 'It is read-only'})
require_foresight('gain = 50', {
    'out of range': 'The default is written without a dot. Which type does the range belong to?',
    'wrong type': 'Which type does the default have?'})


EXERCISES = (rate, mend, foresee)
