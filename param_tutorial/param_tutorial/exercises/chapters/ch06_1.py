"""Exercises of chapter 6.1: fill the gaps of two ranges, mend descriptors that nobody checks, and write your own."""

from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor

from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import expect_answers
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect
from param_tutorial.parameters import values
from param_tutorial.parameters.client import ParameterClient

CHAPTER = '06_1_descriptors_and_ranges'
LIMITS = 'Change it: limits and steps'
IGNORED = 'Break it: a range that nobody looks at'
SHARED = 'Break it: one descriptor for two'
# What is expected, and what happens, while the stub still has a gap.
_GAP = 'a value in place of each `...`', 'a `...` is still there'


def start(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter with a descriptor that can be sent.

    rclpy looks at no field of a descriptor: it sends an integer in place of a double as garbage, and never answers
    with a double in place of an integer.

    :raises NoUse: the node does not start.
    """
    try:
        node = trial.start()
    except NoStart as error:
        if 'ellipsis' in error.happened.casefold():
            raise NoUse(*_GAP) from None
        raise
    expect(node.has_parameter(name), f'a parameter `{name}`', 'the node has none of that name')
    descriptor = node.describe_parameter(name)
    try:
        ParameterDescriptor(integer_range=descriptor.integer_range, check_fields=True,
                            floating_point_range=descriptor.floating_point_range)
        for each in descriptor.integer_range:
            IntegerRange(**_fields(each), check_fields=True)
        for each in descriptor.floating_point_range:
            FloatingPointRange(**_fields(each), check_fields=True)
    except AssertionError as error:
        if 'Ellipsis' in repr(descriptor):
            raise NotYet(*_GAP) from None
        raise NotYet(f'the range of `{name}` has fields of the right types',
                     f'with `check_fields=True` Python raises AssertionError: {error}') from None
    return trial.client(node)


def _fields(message: IntegerRange | FloatingPointRange) -> dict[str, Any]:
    return {name: getattr(message, name) for name in message.get_fields_and_field_types()}


def expect_start(client: ParameterClient, name: str, value: object) -> None:
    """Expect a parameter to start with a value, of its type."""
    found = client.get_parameter(name)
    expect(values.same(found, value), f'`{name}` starts at `{value!r}`',
           'it has no value' if found is None else f'it starts at `{found!r}`')


def expect_range(client: ParameterClient, name: str, low: float, high: float, step: float = 0) -> None:
    """Expect a node to describe a range, so that a panel can show it; its ends in either order."""
    expected = f'the node describes {_format(low, high, step)}'
    found = client.describe_parameter(name).range
    if found is None:
        raise NotYet(expected, 'it describes no range of the type of the parameter')
    first, last = sorted((found.from_value, found.to_value))
    expect((first, last, found.step) == (low, high, step), expected, f'it describes {_format(first, last, found.step)}')


def _format(low: float, high: float, step: float) -> str:
    return f'a range from `{low!r}` to `{high!r}`' + (f' in steps of `{step!r}`' if step else ', in any steps')


fill = Exercise('6.1a', 'Fill the gaps', CHAPTER, NODE_CLASS, node_name='valve', hints=(
    'The list 0, 25, 50, 75, 100 tells you both ends and the step.',
    'The second range has a type of its own, `FloatingPointRange`, with the same three fields. Leave out the step, or '
    'make it `0.0`, and every value between the ends is valid.',
    'The default and the range must be of the same kind: doubles, each with its dot.'))


@fill.require('`opening_percent` takes 0, 25, 50, 75 and 100, and nothing else', see=LIMITS)
def opening(trial: Trial) -> None:
    client = start(trial, 'opening_percent')
    expect_answers(client, 'opening_percent', 'accepted', 0, 25, 50, 75, 100)
    expect_answers(client, 'opening_percent', 'out of range', -25, 125, -1, 101)
    expect_answers(client, 'opening_percent', 'off the step', 5, 10, 20, 99)
    expect_answers(client, 'opening_percent', 'wrong type', 50.0)
    expect_range(client, 'opening_percent', 0, 100, 25)


@fill.require('`pressure_bar` starts at 2.5 and takes every double from 0.0 to 6.0', see=LIMITS)
def pressure(trial: Trial) -> None:
    client = start(trial, 'pressure_bar')
    expect_start(client, 'pressure_bar', 2.5)
    expect_answers(client, 'pressure_bar', 'accepted', 0.0, 0.001, 1.234, 6.0)
    expect_answers(client, 'pressure_bar', 'out of range', -0.001, 6.001)
    expect_answers(client, 'pressure_bar', 'wrong type', 3)
    expect_range(client, 'pressure_bar', 0.0, 6.0)


mend = Exercise('6.1b', 'Mend two silent faults', CHAPTER, NODE_CLASS, node_name='winch', hints=(
    'Ask the winch as it is: `ParameterClient(ros.add(Winch)).describe_parameters()`. Compare what it says with what '
    'is declared.',
    'A range only counts for a default of its own kind. A descriptor serves one declaration.',
    'Write a function `meters()` that returns a new descriptor each time, and give the default its dot.'))


@mend.require('`rope_m` starts at 10.0 and `hook_m` at 0.0, and both take every double from 0.0 to 30.0', see=IGNORED)
def limits(trial: Trial) -> None:
    for name, value in (('rope_m', 10.0), ('hook_m', 0.0)):
        client = start(trial, name)
        expect_start(client, name, value)
        expect_answers(client, name, 'accepted', 0.0, 0.001, 12.34, 30.0)
        expect_answers(client, name, 'out of range', -0.001, 30.001, because='Does it have a range?')
        expect_answers(client, name, 'wrong type', 20)
        expect_range(client, name, 0.0, 30.0)


@mend.require('each of the two has a descriptor of its own', see=SHARED)
def own_descriptors(trial: Trial) -> None:
    node = trial.start()
    for name in filter(node.has_parameter, ('rope_m', 'hook_m')):
        found = node.describe_parameter(name).name
        expect(found == name, f'the descriptor of `{name}` names `{name}`',
               f'it names `{found}`: a later declaration has overwritten it')


describe = Exercise('6.1c', 'Say it in the descriptor', CHAPTER, NODE_CLASS, node_name='camera', hints=(
    'Each parameter needs one `ParameterDescriptor`. Begin with `exposure_us`, and ask the node: '
    "`verdicts(ParameterClient(ros.add(Camera)), 'exposure_us', 100, 150, 20000)`.",
    'The fields are `integer_range` and `floating_point_range`. The range stands in brackets, and each of the two '
    'fields belongs to one type of default.',
    'For the second parameter: `ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, '
    'to_value=16.0)])`.'))


@describe.require('`exposure_us` is an integer, 500, and takes 100, 200, 300 and so on up to 10000', see=LIMITS)
def exposure(trial: Trial) -> None:
    client = start(trial, 'exposure_us')
    expect_start(client, 'exposure_us', 500)
    expect_answers(client, 'exposure_us', 'accepted', 100, 200, 300, 700, 9900, 10000)
    expect_answers(client, 'exposure_us', 'out of range', 0, 10100, 99, 10001,
                   because='The limits of an integer belong in `integer_range`')
    expect_answers(client, 'exposure_us', 'off the step', 101, 150, 9999,
                   because='The step is the third field of `IntegerRange`')
    expect_answers(client, 'exposure_us', 'wrong type', 200.0)
    expect_range(client, 'exposure_us', 100, 10000, 100)


@describe.require('`gain` is a double, 1.0, and takes every double from 0.0 to 16.0', see=LIMITS)
def gain(trial: Trial) -> None:
    client = start(trial, 'gain')
    expect_start(client, 'gain', 1.0)
    expect_answers(client, 'gain', 'accepted', 0.0, 0.001, 12.345, 16.0)
    expect_answers(client, 'gain', 'out of range', -0.001, 16.001,
                   because='The limits of a double belong in `floating_point_range`')
    expect_answers(client, 'gain', 'wrong type', 2)
    expect_range(client, 'gain', 0.0, 16.0)


EXERCISES = (fill, mend, describe)
