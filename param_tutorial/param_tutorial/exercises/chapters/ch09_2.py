"""Exercises of chapter 9.2: clamp a request as ROS 1 did, predict what ROS 2 makes of ROS 1's habits, and replace a
server of dynamic_reconfigure."""

import contextlib
from collections.abc import Mapping
from typing import Any

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import is_housekeeping
from param_tools.errors import CallbackError
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_accepted,
    expect_declared,
    expect_filled,
    expect_follows,
    expect_left_alone,
    expect_range,
    expect_range_fields,
    expect_rejected,
    format_found,
)
from param_tutorial.exercises.trial import NoUse, Trial, expect, take_for_granted

CHAPTER = '09_2_ros1_and_ros2'
STORE = 'Who keeps the values?'
DIES = 'When something dies'
RULES = 'Rules, read-only values and descriptions'
CHANGES = 'Who hears of a change?'

clamp = Exercise('9.2a', 'Fill four gaps', CHAPTER, NODE_CLASS, node_name='mixer', hints=(
    'One of the three kinds of callbacks may return other parameters than it was given. Its method begins with '
    '`self.add_` and ends without parentheses here.',
    'A request may hold other parameters too, so the first gap in `clamp` is a name. The last two are the ends of the '
    'range.'))
LOWEST, HIGHEST = 20, 300


@clamp.require('a speed beyond the limits becomes the nearest limit', see=RULES)
def clamps(trial: Trial) -> None:
    expect_filled(trial)
    mixer = trial.start()
    for asked, wanted in ((900, HIGHEST), (-5, LOWEST), (301, HIGHEST), (19, LOWEST)):
        expect_accepted(trial, mixer, {'speed_rpm': asked})
        expect_held(trial, mixer, f'`speed_rpm = {asked}`', speed_rpm=wanted)
    expect_range(trial.client(mixer), 'speed_rpm', LOWEST, HIGHEST)


@clamp.require('a speed within them, and `minutes`, stay as they were asked for', see=CHANGES)
def leaves_alone(trial: Trial) -> None:
    take_for_granted(trial, clamps)
    mixer = trial.start()
    expect_held(trial, mixer, 'the start', speed_rpm=100, minutes=5)
    for speed_rpm, minutes in ((150, 900), (LOWEST, 0), (HIGHEST, -5), (21, 301)):
        expect_accepted(trial, mixer, {'minutes': minutes, 'speed_rpm': speed_rpm})
        expect_held(trial, mixer, f'`minutes = {minutes}` and `speed_rpm = {speed_rpm}`',
                    speed_rpm=speed_rpm, minutes=minutes)
    expect_accepted(trial, mixer, {'speed_rpm': 1000, 'minutes': 1000})
    expect_held(trial, mixer, '`speed_rpm = 1000` and `minutes = 1000`', speed_rpm=HIGHEST, minutes=1000)
    with contextlib.suppress(CallbackError):  # the requirement for words says so
        trial.client(mixer).set_parameter('speed_rpm', 'fast')
        expect_accepted(trial, mixer, {'minutes': 7}, '. Does a request that was rejected come back with the next one?')


@clamp.require('a word is rejected, and so is a double', see=CHANGES)
def rejects(trial: Trial) -> None:
    take_for_granted(trial, clamps)
    mixer = trial.start()
    expect_accepted(trial, mixer, {'speed_rpm': 200})
    for wrong in ('fast', 900.5):
        expect_rejected(trial, mixer, {'speed_rpm': wrong})
    expect_held(trial, mixer, '`speed_rpm = 900.5`', speed_rpm=200)


def expect_held(trial: Trial, node: Node, after: str, **wanted: object) -> None:
    held = trial.client(node).get_parameters(wanted)
    for name, value in wanted.items():
        expect(values.same(held[name], value), f'`{name}` is `{value!r}` after {after}', f'it is `{held[name]!r}`')


class Drive(Node):
    """The node of exercise 9.2b, as the chapter shows it."""

    def __init__(self) -> None:
        super().__init__('drive')
        self.declare_parameter('max_speed_rpm', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=300)]))
        self.declare_parameter('ticks', 0)
        self.declare_parameter('gains.kp', 0.5)


foresee = Exercise('9.2b', 'What will it hold?', CHAPTER, DICTIONARY, hints=(
    'Three questions, in this order: is the name declared, is the type the declared one, is the value in the range?',
    'A node that rejects keeps what it has and clamps nothing. A name that nobody declared does not come to be.',
    'Integers have 64 bits now. And values live in the node, so they end with it.'))


def require_foresight(what: str, because: Mapping[object, str], see: str, *, name: str, value: object,
                      restart: bool = False) -> None:
    """Add the requirement to know what the node holds after somebody set a parameter."""
    @foresee.require_prediction(what, see=see, because=because)
    def held(trial: Trial) -> Any:
        client = trial.client(trial.start(Drive))
        client.set_parameter(name, value)
        if restart:
            client = trial.client(trial.start(Drive))
        return client.get_parameter(name) if name in client.list_parameters() else None


require_foresight('gains.kp = 1', {
    1: 'ROS 1 would have stored it. To ROS 2 an integer is no double, and it converts nothing'},
    RULES, name='gains.kp', value=1)
require_foresight('gains/kp = 2.0', {
    2.0: 'Only what was declared exists, and a slash is not a dot',
    0.5: 'A slash is not a dot: that is another name, and nobody declared it'}, STORE, name='gains/kp', value=2.0)
require_foresight('max_speed_rpm = 900', {
    300: '`dynamic_reconfigure` would have clamped it. ROS 2 rejects, and the old value stays',
    900: 'There is a range, and the node enforces it'}, RULES, name='max_speed_rpm', value=900)
require_foresight('ticks = 3000000000', {
    0: 'It is an integer, and there is no range. Only XML-RPC ends at 32 bits'}, RULES, name='ticks', value=3000000000)
require_foresight("color = 'green'", {
    'green': 'Nobody declared it, and a stranger cannot'}, STORE, name='color', value='green')
require_foresight('max_speed_rpm = 200, and then the node is restarted', {
    200: 'There is no server that would have kept it'}, DIES, name='max_speed_rpm', value=200, restart=True)


replace = Exercise('9.2c', 'Replace `dynamic_reconfigure`', CHAPTER, NODE_CLASS, node_name='fan', hints=(
    'Each `cfg.add` becomes one `declare_parameter`: `double_t` asks for a default with a dot, the last two numbers '
    'for a `FloatingPointRange` in the descriptor, and the sentence for its description.',
    "What the server's callback did goes into a post-set callback, which reads both parameters with `get_parameter`.",
    'Call that method once at the end of the constructor too, for what an override has brought.'))
DESCRIPTIONS = {'speed': 'A fraction of full speed, 3000 rpm.', 'boost': 'Doubles the speed for a moment.'}


@replace.require('`speed` is a double, 0.5 at the start, and `boost` a boolean, false at the start', see=RULES)
def fan_declared(trial: Trial) -> None:
    found = trial.client(trial.start()).list_parameters()
    if missing := [f'`{name}`' for name in DESCRIPTIONS if name not in found]:
        raise NoUse('both parameters', f'the node has no {" and no ".join(missing)}')
    others = [f'`{name}`' for name in found if name not in DESCRIPTIONS and not is_housekeeping(name)]
    expect(not others, 'the same two parameters', f'there is also {", ".join(others)}')
    expect_declared(trial, 'speed', values.DOUBLE, 0.5)
    expect_declared(trial, 'boost', values.BOOL, False)


@replace.require('a range rejects a speed below 0.0 or above 1.0, and both are described', see=RULES)
def fan_described(trial: Trial) -> None:
    fan = trial.start()
    client = trial.client(fan)
    expect_range_fields(fan, 'speed')
    for good in (0.0, 1.0, 0.125):
        expect_accepted(trial, fan, {'speed': good})
    for bad in (-0.5, 1.5):
        expect_rejected(trial, fan, {'speed': bad})
        expect_held(trial, fan, f'`speed = {bad}`', speed=0.125)
    expect_range(client, 'speed', 0.0, 1.0)
    told = client.describe_parameters(DESCRIPTIONS)
    for name, wanted in DESCRIPTIONS.items():
        description = told[name].description
        expect(description.strip().rstrip('.') == wanted.rstrip('.'), f'`{name}` is described as in the `.cfg`',
               f'its description is `{description}`' if description.strip() else 'it has no description')


@replace.require('`self.motor_rpm` is right at the start, with an override too', see=CHANGES)
def fan_starts(trial: Trial) -> None:
    take_for_granted(trial, fan_declared)
    for ros_args, wanted in (([], 1500), (['-p', 'speed:=0.25'], 750), (['-p', 'boost:=true'], 3000),
                             (['-p', 'boost:=true', '-p', 'speed:=0.125'], 750)):
        fan = trial.start(ros_args=ros_args)
        motor = getattr(fan, 'motor_rpm', None)
        how = f'with `{" ".join(ros_args)}`' if ros_args else 'without an override'
        expect(motor == wanted, f'`self.motor_rpm` is {wanted} after a start {how}', f'it is {format_found(motor)}')


@replace.require('`self.motor_rpm` follows what is stored, and only that', see=CHANGES)
def fan_follows(trial: Trial) -> None:
    take_for_granted(trial, fan_declared, fan_starts)
    fan = expect_follows(trial, 'motor_rpm', [
        ({'speed': 0.0625}, 187.5), ({'speed': 0.25}, 750), ({'boost': True}, 1500), ({'speed': 0.5}, 3000),
        ({'boost': False, 'speed': 1.0}, 3000),
        ({'speed': 0.125, 'boost': True}, 750), ({'boost': False}, 375)])
    expect_left_alone(trial, fan, 'motor_rpm', {'speed': 0.75, 'boost': True})


EXERCISES = (clamp, foresee, replace)
