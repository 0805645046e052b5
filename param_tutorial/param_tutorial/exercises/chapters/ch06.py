"""Exercises of chapter 6: write descriptors, foresee rejections, and mend what nobody checks."""

import ast
from collections.abc import Mapping
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import client_for, expect_declared, expect_result
from param_tutorial.exercises.trial import Trial, expect
from param_tutorial.parameters import values
from param_tutorial.parameters.values import DOUBLE, INTEGER, INTEGER_ARRAY, STRING

CHAPTER = '06_descriptors_and_validation'
LIMITS = 'Change it: limits and steps'
LOCK = 'Change it: the lock'
FREE = 'Change it: a free type'
ARRAYS = 'Arrays'
SHARED = 'Break it: one descriptor for two'
ORDER = 'Who rejects, and in which order?'


def expect_answers(trial: Trial, name: str, kind: str, *new: object, because: str = '') -> None:
    """Expect the node's answer to each of some values, set one after the other, to be of a kind; as in ch03."""
    client = client_for(trial, name)
    for value in new:
        expect_result(client, name, value, kind, because)


describe = Exercise('6a', 'Say it in the descriptor', CHAPTER, NODE_CLASS, node_name='camera', hints=(
    'One `ParameterDescriptor` for each parameter that has something to say. Begin with `exposure_us`, and ask: '
    "`verdicts(ParameterClient(ros.add(Camera)), 'exposure_us', 100, 150, 20000)`.",
    'The fields are `integer_range`, `floating_point_range`, `read_only` and `dynamic_typing`. The two ranges stand in '
    'brackets, and each belongs to one type of default.',
    'What has a type and no value yet is declared with the type in the default’s place: '
    '`Parameter.Type.INTEGER_ARRAY`.'))


@describe.require('`exposure_us` is an integer, 500, and takes 100, 200, 300 and so on up to 10000', see=LIMITS)
def exposure(trial: Trial) -> None:
    expect_declared(trial, 'exposure_us', INTEGER, 500)
    expect_answers(trial, 'exposure_us', 'accepted', 100, 700, 10000)
    expect_answers(trial, 'exposure_us', 'out of range', 99, 10001, because='A range belongs into `integer_range`')
    expect_answers(trial, 'exposure_us', 'off the step', 150, because='Steps count from the smaller end')


@describe.require('`gain` is a double, 1.0, and takes everything from 0.0 to 16.0', see=LIMITS)
def gain(trial: Trial) -> None:
    expect_declared(trial, 'gain', DOUBLE, 1.0)
    expect_answers(trial, 'gain', 'accepted', 0.0, 0.123, 16.0)
    expect_answers(trial, 'gain', 'out of range', -0.1, 16.1,
                   because='A double takes its limits from a `floating_point_range`')


@describe.require('`sensor` is fixed while the node runs, and `-p sensor:=IMX477` can say it at the start', see=LOCK)
def sensor(trial: Trial) -> None:
    expect_declared(trial, 'sensor', STRING, 'IMX219')
    expect_answers(trial, 'sensor', 'read only', 'IMX477', because='A lock is a field of the descriptor, `read_only`')
    client = trial.client(trial.start(ros_args=['-p', 'sensor:=IMX477']))
    found = client.get_parameter('sensor')
    expect(found == 'IMX477', '`IMX477` after such a start', f'it is `{found!r}`')


@describe.require('`tag` takes a text, a number, a list, and can be deleted', see=FREE)
def tag(trial: Trial) -> None:
    expect_answers(trial, 'tag', 'accepted', 'night', 7, [0.5, 1.5])
    result = client_for(trial, 'tag').delete_parameter('tag')
    expect(result.successful, '`tag` can be deleted', f'{result}')


@describe.require('`crop_px` takes a list of integers, also an empty one, and has no value yet', see=ARRAYS)
def crop(trial: Trial) -> None:
    expect_declared(trial, 'crop_px', INTEGER_ARRAY, None)
    expect_answers(trial, 'crop_px', 'accepted', [0, 0, 640, 480], [])
    expect_answers(trial, 'crop_px', 'wrong type', [0.5], because='Its type is free, and was meant to be settled')


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


foresee = Exercise('6b', 'Predict who rejects', CHAPTER, DICTIONARY, hints=(
    'Go through the checks in their order: declared, read-only, type, range, step, on-set callbacks. The first that '
    'fails gives the answer its kind.',
    'Both ends of a range are valid. A range looks only at values of its own kind.',
    'Count the steps from 50: 75, 100, 125, and so on. Which of the wishes are among them, and which is an end?'))


def require_foresight(wish: str, because: Mapping[object, str], see: str = ORDER) -> None:
    """Add the requirement to know of which kind the oven's answer to a wish is.

    :param wish: As 'name = value'.
    """
    name, value = wish.split(' = ')

    @foresee.require_prediction(wish, see=see, because=because)
    def answers(trial: Trial) -> Any:
        return trial.client(trial.start(Oven)).set_parameter(name, ast.literal_eval(value)).kind


require_foresight('target_c = 260', {
    'off the step': 'No step leads there, and yet there is something special about it',
    'out of range': 'The ends belong to a range'}, LIMITS)
require_foresight('target_c = 110', {
    'accepted': 'The steps are 25 wide, and count from 50', 'out of range': 'It is between the ends'}, LIMITS)
require_foresight('target_c = 275', {
    'off the step': 'Before the steps are counted, the ends are looked at'}, ORDER)
require_foresight('target_c = 225', {
    'accepted': 'All that the descriptor says is met, and one more is asked after it',
    'off the step': '50 and seven steps of 25 are 225'})
require_foresight('target_c = 225.0', {
    'rejected by the node': 'The callback was not asked: another check comes before it',
    'accepted': 'ROS converts nothing'})
require_foresight('serial = 7', {
    'accepted': 'The lock does not look whether the value is another one'}, LOCK)
require_foresight('serial = 12', {
    'out of range': 'It is out of range too, and that check comes later', 'accepted': 'It is locked'})
require_foresight('gain = 50', {
    'out of range': 'The default is written without a dot. To which type does the range belong?',
    'wrong type': 'Which type has the default?'}, LIMITS)


mend = Exercise('6c', 'Mend three silent faults', CHAPTER, NODE_CLASS, node_name='winch', hints=(
    'Ask the winch as it is: `ParameterClient(ros.add(Winch)).describe_parameters()`. Compare what it tells with what '
    'is declared.',
    'A range is looked at if the default is of its kind. A descriptor serves one declaration. An empty list has no '
    'elements to tell a type by.',
    'A function `metres()` that returns a new descriptor each time; a dot in the default; and '
    '`Parameter.Type.DOUBLE_ARRAY`.'))


@mend.require('`rope_m` starts at 10.0 and `hook_m` at 0.0, and both go from 0.0 to 30.0', see=LIMITS)
def limits(trial: Trial) -> None:
    for name, start in (('rope_m', 10.0), ('hook_m', 0.0)):
        found = client_for(trial, name).get_parameter(name)
        expect(values.same(found, start), f'`{name}` starts at `{start!r}`', f'it starts at `{found!r}`')
        expect_answers(trial, name, 'accepted', 12.5, 30.0)
        expect_answers(trial, name, 'out of range', 31.0, -1.0, because='Does it have a range?')


@mend.require('each of the two is described by a descriptor of its own', see=SHARED)
def own_descriptors(trial: Trial) -> None:
    client = client_for(trial, 'rope_m')
    found = client.describe_parameter('rope_m').name
    expect(found == 'rope_m', 'the descriptor of `rope_m` has its name',
           f'its name is `{found}`: a later declaration has overwritten it')


@mend.require('`stops_m` takes a list of doubles, also an empty one, and no text', see=ARRAYS)
def stops(trial: Trial) -> None:
    expect_answers(trial, 'stops_m', 'accepted', [2.5, 10.0], [])
    expect_answers(trial, 'stops_m', 'wrong type', ['dock'], because='With a free type everything goes in')


EXERCISES = (describe, foresee, mend)
