"""Exercises of chapter 6.1: fill the gaps of two ranges, mend descriptors that nobody checks, and write your own."""

from param_tools.node.client import ParameterClient
from param_tools.values import DOUBLE, INTEGER
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_answers,
    expect_declared,
    expect_no_gap,
    expect_range,
    expect_range_fields,
)
from param_tutorial.exercises.trial import NoUse, Trial, expect

CHAPTER = '06_1_descriptors_and_ranges'
LIMITS = 'Change it: limits and steps'
IGNORED = 'Break it: a range that nobody looks at'
SHARED = 'Break it: one descriptor for two'


def start(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter whose range has fields of the right types.

    :raises NoUse: the node does not start, or a gap is left.
    """
    try:
        node = trial.start()
    except NoUse as error:
        expect_no_gap(error.happened)
        raise
    expect(node.has_parameter(name), f'a parameter `{name}`', 'the node has none of that name')
    expect_no_gap(repr(node.describe_parameter(name)))
    expect_range_fields(node, name)
    return trial.client(node)


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
    expect_declared(trial, 'pressure_bar', DOUBLE, 2.5)
    expect_answers(client, 'pressure_bar', 'accepted', 0.0, 0.001, 1.234, 6.0)
    expect_answers(client, 'pressure_bar', 'out of range', -0.001, 6.001)
    expect_answers(client, 'pressure_bar', 'wrong type', 3)
    expect_range(client, 'pressure_bar', 0.0, 6.0, 0)


mend = Exercise('6.1b', 'Fix two silent faults', CHAPTER, NODE_CLASS, node_name='winch', hints=(
    'Ask the winch as it is: `ParameterClient(ros.add(Winch)).describe_parameters()`. Compare what it says with what '
    'is declared.',
    'A range only counts for a default of its own kind. A descriptor serves one declaration.',
    'Write a function `meters()` that returns a new descriptor each time, and give the default its dot.'))


@mend.require('`rope_m` starts at 10.0 and `hook_m` at 0.0, and both take every double from 0.0 to 30.0', see=IGNORED)
def limits(trial: Trial) -> None:
    for name, value in (('rope_m', 10.0), ('hook_m', 0.0)):
        client = start(trial, name)
        expect_declared(trial, name, DOUBLE, value)
        expect_answers(client, name, 'accepted', 0.0, 0.001, 12.34, 30.0)
        expect_answers(client, name, 'out of range', -0.001, 30.001,
                       because='Does it have a range of doubles, with these two ends?')
        expect_answers(client, name, 'wrong type', 20)
        expect_range(client, name, 0.0, 30.0, 0)


@mend.require('each of the two has a descriptor of its own', see=SHARED)
def own_descriptors(trial: Trial) -> None:
    node = trial.start()
    for name in filter(node.has_parameter, ('rope_m', 'hook_m')):
        found = node.describe_parameter(name).name
        expect(found == name, f'the descriptor of `{name}` names `{name}`',
               f'it names `{found}`: a later declaration has overwritten it')


describe = Exercise('6.1c', 'Say it in the descriptor', CHAPTER, NODE_CLASS, node_name='camera', hints=(
    'Each parameter needs one `ParameterDescriptor`. Begin with `exposure_us`, and ask the node: '
    "`verdicts(Camera, 'exposure_us', 100, 150, 20000)`.",
    'The fields are `integer_range` and `floating_point_range`. The range stands in brackets, and each of the two '
    'fields belongs to one type of default.',
    'For the second parameter: `ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, '
    'to_value=16.0)])`.'))


@describe.require('`exposure_us` is an integer, 500, and takes 100, 200, 300 and so on up to 10000', see=LIMITS)
def exposure(trial: Trial) -> None:
    client = start(trial, 'exposure_us')
    expect_declared(trial, 'exposure_us', INTEGER, 500)
    expect_answers(client, 'exposure_us', 'accepted', 100, 200, 300, 700, 9900, 10000)
    expect_answers(client, 'exposure_us', 'out of range', 0, 10100, 99, 10001,
                   because='The limits of an integer are the two ends of its `integer_range`')
    expect_answers(client, 'exposure_us', 'off the step', 101, 150, 9999,
                   because='The step is the third field of `IntegerRange`')
    expect_answers(client, 'exposure_us', 'wrong type', 200.0)
    expect_range(client, 'exposure_us', 100, 10000, 100)


@describe.require('`gain` is a double, 1.0, and takes every double from 0.0 to 16.0', see=LIMITS)
def gain(trial: Trial) -> None:
    client = start(trial, 'gain')
    expect_declared(trial, 'gain', DOUBLE, 1.0)
    expect_answers(client, 'gain', 'accepted', 0.0, 0.001, 12.345, 16.0)
    expect_answers(client, 'gain', 'out of range', -0.001, 16.001,
                   because='The limits of a double are the two ends of its `floating_point_range`')
    expect_answers(client, 'gain', 'wrong type', 2)
    expect_range(client, 'gain', 0.0, 16.0, 0)


@describe.require('`tilt_deg` is a double, 0.0, and takes every half degree from -90.0 to 90.0', see=LIMITS)
def tilt(trial: Trial) -> None:
    client = start(trial, 'tilt_deg')
    expect_declared(trial, 'tilt_deg', DOUBLE, 0.0)
    expect_answers(client, 'tilt_deg', 'accepted', -90.0, -0.5, 0.0, 12.5, 90.0)
    expect_answers(client, 'tilt_deg', 'out of range', -90.5, 91.0,
                   because='The limits of a double are the two ends of its `floating_point_range`')
    expect_answers(client, 'tilt_deg', 'off the step', 0.25, 12.3,
                   because='The step is the third field of `FloatingPointRange`')
    expect_answers(client, 'tilt_deg', 'wrong type', 2)
    expect_range(client, 'tilt_deg', -90.0, 90.0, 0.5)


@describe.require('each of the three has a description', see='Eight fields')
def described(trial: Trial) -> None:
    node = trial.start()
    for name in ('exposure_us', 'gain', 'tilt_deg'):
        expect(node.has_parameter(name), f'a parameter `{name}`', 'the node has none of that name')
        expect(node.describe_parameter(name).description.strip().strip('.…'), 'a description for each',
               f'`{name}` has none')


EXERCISES = (fill, mend, describe)
