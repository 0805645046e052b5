"""Exercises of chapter 3: fill in defaults, declare parameters, mend declarations, and write a whole program."""

from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tools.values import BOOL, DOUBLE, INTEGER, STRING, ParameterType
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_answers,
    expect_declared,
    expect_fixed_type,
    expect_range,
    expect_range_fields,
    expect_result,
    expect_start_value,
    take_type_for_granted,
)
from param_tutorial.exercises.programs import PROGRAM, require_ends, require_program, running
from param_tutorial.exercises.trial import NoStart, NotTried, Trial, expect

CHAPTER = '03_declaring'
TYPE = 'Build it: one declaration, one type'
DESCRIPTOR = 'Build it: the descriptor'
WHO_DECIDES = 'Who decides the type?'
WHOLE = 'From a class to a command'
STAGE = 'What the stage does for you'
PUT_BACK = 'the node accepted it, and put the value back only afterward'


def start_with(trial: Trial, name: str, wanted: ParameterType) -> tuple[Any, ParameterClient]:
    """Start the learner's node, which has a parameter of a type.

    :raises NotTried: it has not, as an earlier requirement says.
    """
    node = trial.start()
    client = trial.client(node)
    if name not in client.list_parameters() or client.describe_parameter(name).type is not wanted:
        raise NotTried
    return node, client


def expect_start(trial: Trial, name: str, wanted: ParameterType, value: object) -> None:
    """Expect a parameter of a type that stays, with a value to start with."""
    expect_declared(trial, name, wanted, value)
    _, client = start_with(trial, name, wanted)
    expect_fixed_type(client, name)


def note_values(node: Node, name: str) -> list[Any]:
    """Return a list of all values that a parameter is going to hold, however briefly; it grows with each set."""
    held: list[Any] = []
    node.add_post_set_parameters_callback(
        lambda parameters: held.extend(each.value for each in parameters if each.name == name))
    return held


def expect_limits(trial: Trial, name: str, low: float, high: float, *between: float) -> None:
    """Expect a double to stay within two ends, in whatever way the node sees to it, and its description to agree."""
    node, client = start_with(trial, name, DOUBLE)
    expect_range_fields(node, name)
    held = note_values(node, name)
    for value in (low, high, *between):
        expect_result(client, name, value, 'accepted')
    for beyond in (low - 0.01, high + 0.5, low - 1000.0, high + 0.01, high + 1000.0):
        client.set_parameter(name, beyond)
        stored = client.get_parameter(name)
        expect(stored is not None and low <= stored <= high, f'`{name} = {beyond!r}` is rejected',
               f'the node accepted it. {_what_limits(node.describe_parameter(name))}')
        expect(beyond not in held, f'`{name} = {beyond!r}` is rejected', PUT_BACK)
    if described := client.describe_parameter(name).range:
        expect((described.from_value, described.to_value) == (low, high),
               f'the node describes the range as {low} to {high}',
               f'it describes it as {described.from_value} to {described.to_value}')
    try:
        start = trial.client(trial.start(ros_args=['-p', f'{name}:={high + 1}'])).get_parameter(name)
    except NoStart:
        return
    expect(start is not None and low <= start <= high, f'a start with `-p {name}:={high + 1}` is rejected too',
           f'the node starts with {start}')


def _what_limits(descriptor: ParameterDescriptor) -> str:
    if ranges := descriptor.floating_point_range:
        return f'Its range goes from {ranges[0].from_value} to {ranges[0].to_value}'
    if descriptor.integer_range:
        return 'An `integer_range` limits integers; a double needs a `floating_point_range`'
    if descriptor.description or descriptor.additional_constraints:
        return 'A description is for people, and nothing enforces it'
    return 'Nothing limits it yet'


declare = Exercise('3b', 'Declare a rover', CHAPTER, NODE_CLASS, node_name='rover', hints=(
    'Each parameter takes one line `self.declare_parameter(name, default, descriptor)`, and the default decides its '
    'type. The section “Build it: one declaration, one type” shows the first two arguments.',
    'In Python `1` is an `int` and `1.0` a `float`. A double takes its range from a `FloatingPointRange`, in a list: '
    '`ParameterDescriptor(floating_point_range=[...])`. Both ends of it are floats, too.',
    'The descriptor has a field `read_only`. It is `False` unless you write `read_only=True`.'))


@declare.require('`max_speed_mps` is a double and starts at one meter per second', see=TYPE)
def speed(trial: Trial) -> None:
    expect_start(trial, 'max_speed_mps', DOUBLE, 1.0)


@declare.require('`max_speed_mps` can be anything from 0.0 to 2.0, both ends included, and nothing else',
                 see=DESCRIPTOR)
def speed_range(trial: Trial) -> None:
    expect_limits(trial, 'max_speed_mps', 0.0, 2.0, 0.01, 1.37)


@declare.require('`wheels` is an integer, and it is 6', see=TYPE)
def wheels(trial: Trial) -> None:
    expect_declared(trial, 'wheels', INTEGER, 6)


@declare.require('nobody can change `wheels`', see=DESCRIPTOR)
def wheels_locked(trial: Trial) -> None:
    node, client = start_with(trial, 'wheels', INTEGER)
    held = note_values(node, 'wheels')
    before = client.get_parameter('wheels')
    for other in (4, 8, 0):
        client.set_parameter('wheels', other)
        expect(client.get_parameter('wheels') == before, f'`wheels = {other}` is rejected',
               'the node accepted it. The field `read_only` of the descriptor makes a parameter read-only')
        expect(other not in held, f'`wheels = {other}` is rejected', PUT_BACK)


mend = Exercise('3c', 'Mend a lamp', CHAPTER, NODE_CLASS, node_name='lamp', hints=(
    'Ask the lamp as it is: `ParameterClient(ros.add(Lamp)).describe_parameters()` shows the type of each parameter.',
    'A descriptor cannot choose a type, and a description limits nothing. The default decides the type, and a range '
    'sets the limits.',
    'You can give the type in place of the default: `Parameter.Type.DOUBLE`. The parameter then has no value yet.'))


@mend.require('`brightness_percent` is a double that starts at 50.0, and it accepts halves', see=WHO_DECIDES)
def halves(trial: Trial) -> None:
    expect_start(trial, 'brightness_percent', DOUBLE, 50.0)
    _, client = start_with(trial, 'brightness_percent', DOUBLE)
    for half in (62.5, 0.5):
        expect_result(client, 'brightness_percent', half, 'accepted')


@mend.require('`brightness_percent` can be 0.0 to 100.0, both ends included, and nothing below or above',
              see=DESCRIPTOR)
def percent(trial: Trial) -> None:
    expect_limits(trial, 'brightness_percent', 0.0, 100.0)


@mend.require('`warm_white` is a boolean, and it is on', see=TYPE)
def warm_white(trial: Trial) -> None:
    expect_start(trial, 'warm_white', BOOL, True)
    _, client = start_with(trial, 'warm_white', BOOL)
    for switched in (False, True):
        expect_result(client, 'warm_white', switched, 'accepted')


@mend.require('`calibration` is a double that has no value until somebody sets one', see=WHO_DECIDES)
def calibration(trial: Trial) -> None:
    expect_start(trial, 'calibration', DOUBLE, None)
    _, client = start_with(trial, 'calibration', DOUBLE)
    for value in (0.98, -12.5):
        expect_result(client, 'calibration', value, 'accepted')


fill = Exercise('3a', 'Fill three gaps', CHAPTER, NODE_CLASS, node_name='door', hints=(
    'The default decides the type: how does Python write an integer, a float, and a string?',
    'A double needs its dot, and a string its quotes: without them, 7 is a number.'))


def require_gap(name: str, wanted: ParameterType, value: object) -> None:
    """Add the requirement that a parameter of the door is declared."""
    article = 'an' if wanted is INTEGER else 'a'

    @fill.require(f'`{name}` is {article} {wanted.label}, and it is `{value!r}`', see=TYPE)
    def is_declared(trial: Trial) -> None:
        expect_start(trial, name, wanted, value)


require_gap('max_angle_deg', INTEGER, 90)
require_gap('speed_dps', DOUBLE, 30.0)
require_gap('label', STRING, '7')


KETTLE = '3d · A kettle from an empty file'
program = Exercise('3d', 'A kettle from an empty file', CHAPTER, PROGRAM, node_name='kettle', hints=(
    'Four parts, from top to bottom: imports, the class, `def main():`, and two last lines that begin with '
    "`if __name__ == '__main__':` and call `main()`. The class is like the rover of 3b.",
    '`main` calls `rclpy.init()`, and then `rclpy.spin(Kettle())`, which returns only when something ends the program. '
    "A line in the log is `self.get_logger().info(f'...')`.",
    'Both lines of `main` stand in a `try:`. After it comes `except (KeyboardInterrupt, ExternalShutdownException):`, '
    'with a `pass`. `ExternalShutdownException` is in `rclpy.executors`.'))
require_program(program, 'kettle_node.py', STAGE)


@program.require('`target_c` is a double, starts at 80.0, and has a range from 20.0 to 100.0', see=DESCRIPTOR)
def target(trial: Trial) -> None:
    with running(trial, program) as kettle:
        client = trial.client(kettle.node)
        expect_start_value(client, 'target_c', DOUBLE, 80.0)
        expect_answers(client, 'target_c', 'accepted', 20.0, 100.0, 37.5)
        expect_answers(client, 'target_c', 'out of range', 19.9, 100.1, because=_NO_LIMIT)
        expect_range(client, 'target_c', 20.0, 100.0)
        expect_fixed_type(client, 'target_c')


_NO_LIMIT = 'A `FloatingPointRange` limits a double'


@program.require('`model` is a string, `K-1`, and nobody can change it', see=DESCRIPTOR)
def model(trial: Trial) -> None:
    with running(trial, program) as kettle:
        client = trial.client(kettle.node)
        expect_start_value(client, 'model', STRING, 'K-1')
        expect_result(client, 'model', 'K-2', 'read only', 'The field `read_only` of the descriptor makes it so')


@program.require('it logs the temperature that it starts with', see=KETTLE)
def logs_target(trial: Trial) -> None:
    for words, value in (('', '80.0'), ('-p target_c:=95.5', '95.5')):
        with running(trial, program, words) as kettle:
            take_type_for_granted(trial.client(kettle.node), DOUBLE, 'target_c')
            kettle.expect_line(value, f'after a start with `{words}`' if words else 'after its start')


require_ends(program, WHOLE)


EXERCISES = (fill, declare, mend, program)
