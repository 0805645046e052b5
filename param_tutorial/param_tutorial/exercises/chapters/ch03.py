"""Exercises of chapter 3: the driver declares, drives, and becomes a program; and a rover to declare."""

from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tools.values import DOUBLE, INTEGER, ParameterType
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_declared,
    expect_fixed_type,
    expect_range_fields,
    expect_result,
    expect_start_value,
)
from param_tutorial.exercises.programs import require_ends, require_program, running
from param_tutorial.exercises.steps import (
    DRIVER,
    DRIVER_PROGRAM,
    FAR,
    expect_commands,
    expect_start_speeds,
    start_on_bench,
)
from param_tutorial.exercises.trial import NoStart, NotTried, Trial, expect, take_for_granted

CHAPTER = '03_declaring'
OWN = 'A node of your own'
TYPE = 'One default, one type'
DESCRIPTOR = 'Limits'
DRIVE = 'Let it drive'
WHOLE = 'From a class to a program'
PUT_BACK = 'the node accepted it, and put the value back only afterward'


def start_with(trial: Trial, name: str, wanted: ParameterType) -> tuple[Any, ParameterClient]:
    """Start the learner's node, which has a parameter of a type.

    :raises NotTried: it has not, as an earlier requirement says.
    """
    node = trial.start(ros_args=FAR)
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
        start = trial.client(trial.start(ros_args=[*FAR, '-p', f'{name}:={high + 1}'])).get_parameter(name)
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
    'type. The section “One default, one type” shows the first two arguments.',
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


steps = Exercise('3a', 'The first line of your driver', CHAPTER, DRIVER, node_name='driver', hints=(
    'The file needs three things: `from rclpy.node import Node`, a class derived from `Node`, and in its `__init__` '
    'the call `super().__init__(...)` with the name of the node.',
    'A declaration is `self.declare_parameter(name, default)`, below the call of `super().__init__`. The default '
    'decides the type: a double has a dot.'))


@steps.require('`driver_node.py` makes a node', see=OWN)
def is_called_driver(trial: Trial) -> None:
    trial.client(trial.start())


@steps.require('`max_speed_mps` is a double, and it starts at 0.5', see=OWN)
def has_speed(trial: Trial) -> None:
    expect_start(trial, 'max_speed_mps', DOUBLE, 0.5)


drives = Exercise('3c', 'It drives', CHAPTER, DRIVER, node_name='driver', hints=(
    'Three lines in `__init__`: `self.speed_mps = self.get_parameter(...).value`, a publisher that is kept in `self`, '
    'and a timer. All of them come after the declaration.',
    'The timer calls a method of the class, `self.create_timer(0.1, self.drive)`. The method makes a `Twist`, sets its '
    '`linear.x`, and gives it to `publish` of the publisher.',
    'The limits go into the declaration, as in the rover: a descriptor with `floating_point_range=[...]`.'))


@drives.require('it publishes a `Twist` on `cmd_vel`, again and again', see=DRIVE)
def publishes(trial: Trial) -> None:
    node, bench = start_on_bench(trial)
    expect_commands(trial, bench)
    # Not the time between two commands, which a busy machine draws out.
    periods = [each.timer_period_ns / 1e9 for each in node.timers]
    expect(not periods or any(0.05 < each < 0.15 for each in periods), 'ten commands a second, one every 0.1 s',
           'its timer comes every ' + ' and '.join(f'{each:g} s' for each in periods))


@drives.require('the command is the speed with which the node has started', see=DRIVE)
def commands_speed(trial: Trial) -> None:
    take_for_granted(trial, publishes)
    expect_start_speeds(trial)


@drives.require('`max_speed_mps` has a description, and can be anything from 0.0 to 2.0, and nothing else',
                see=DESCRIPTOR)
def has_limits(trial: Trial) -> None:
    expect_limits(trial, 'max_speed_mps', 0.0, 2.0, 0.01, 1.37)
    node, _ = start_with(trial, 'max_speed_mps', DOUBLE)
    expect(node.describe_parameter('max_speed_mps').description.strip(), 'a description of `max_speed_mps`',
           'its descriptor has none')


program = Exercise('3d', 'A program', CHAPTER, DRIVER_PROGRAM, node_name='driver', hints=(
    "Below the class: `def main():`, and two last lines. The first is `if __name__ == '__main__':`, and the second "
    'calls `main()`.',
    '`main` calls `rclpy.init()`, and then `rclpy.spin(Driver())`, which returns only when something ends the program.',
    'Both lines of `main` stand in a `try:`. After it comes `except (KeyboardInterrupt, ExternalShutdownException):`, '
    'with a `pass`. `ExternalShutdownException` is in `rclpy.executors`.'))
require_program(program, 'driver_node.py', WHOLE)


@program.require('it takes `-p max_speed_mps:=1.5`', see=WHOLE)
def takes_override(trial: Trial) -> None:
    with running(trial, program, ' '.join((*FAR, '-p max_speed_mps:=1.5'))) as driver:
        expect_start_value(trial.client(driver.node), 'max_speed_mps', DOUBLE, 1.5)


require_ends(program, WHOLE)


EXERCISES = (steps, declare, drives, program)
