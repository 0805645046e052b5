"""Exercises of chapter 3: fill in defaults, declare parameters, and mend declarations."""

from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import expect_answer, expect_declared
from param_tutorial.exercises.trial import Trial
from param_tutorial.parameters.values import BOOL, DOUBLE, INTEGER, STRING, ParameterType

CHAPTER = '03_declaring'
TYPE = 'Build it: one declaration, one type'
DESCRIPTOR = 'Build it: the descriptor'
WHO_DECIDES = 'Who decides the type?'


declare = Exercise('3a', 'Declare a rover', CHAPTER, NODE_CLASS, node_name='rover', hints=(
    'Each parameter takes one line `self.declare_parameter(name, default, descriptor)`, and the default decides its '
    'type. The section “Build it: one declaration, one type” shows the first two arguments.',
    'In Python `1` is an `int` and `1.0` a `float`. A double takes its range from a `FloatingPointRange`, in a list: '
    '`ParameterDescriptor(floating_point_range=[...])`.',
    'The descriptor has a field `read_only`. It is `False` unless you say `read_only=True`.'))


@declare.require('`max_speed_mps` is a double and starts at one metre per second', see=TYPE)
def speed(trial: Trial) -> None:
    expect_declared(trial, 'max_speed_mps', DOUBLE, 1.0)


@declare.require('`max_speed_mps` goes from 0.0 to 2.0, both ends included, and the node sees to it', see=DESCRIPTOR)
def speed_range(trial: Trial) -> None:
    because = ('A description is read by people only, an `integer_range` by integers only: a double has its '
               '`floating_point_range`')
    for end in (0.0, 2.0):
        expect_answer(trial, 'max_speed_mps', end, 'accepted')
    for beyond in (-0.5, 2.5):
        expect_answer(trial, 'max_speed_mps', beyond, 'out of range', because)


@declare.require('`wheels` is an integer, and it is 6', see=TYPE)
def wheels(trial: Trial) -> None:
    expect_declared(trial, 'wheels', INTEGER, 6)


@declare.require('nobody can change `wheels`', see=DESCRIPTOR)
def wheels_locked(trial: Trial) -> None:
    expect_answer(trial, 'wheels', 4, 'read only', 'A lock is a field of the descriptor, `read_only`')


mend = Exercise('3b', 'Mend a lamp', CHAPTER, NODE_CLASS, node_name='lamp', hints=(
    'Ask the lamp as it is: `ParameterClient(ros.add(Lamp)).describe_parameters()` shows the type of each parameter.',
    'A descriptor cannot choose a type, and a description limits nothing. The default is what decides, and a range '
    'is what limits.',
    'The type can stand in the default’s place: `Parameter.Type.DOUBLE`. The parameter then has no value yet.'))


@mend.require('`brightness_percent` takes 62.5', see=WHO_DECIDES)
def halves(trial: Trial) -> None:
    expect_answer(trial, 'brightness_percent', 62.5, 'accepted')


@mend.require('`brightness_percent` rejects 120.0', see=DESCRIPTOR)
def percent(trial: Trial) -> None:
    expect_answer(trial, 'brightness_percent', 120.0, 'out of range',
                  'What is said in a description is enforced by nobody, and an `integer_range` holds for integers only')


@mend.require('`warm_white` is a boolean, and it is on', see=TYPE)
def warm_white(trial: Trial) -> None:
    expect_declared(trial, 'warm_white', BOOL, True)


@mend.require('`calibration` is a double that has no value until somebody sets one', see=WHO_DECIDES)
def calibration(trial: Trial) -> None:
    expect_declared(trial, 'calibration', DOUBLE, None)


fill = Exercise('3c', 'Fill three gaps', CHAPTER, NODE_CLASS, node_name='door', hints=(
    'The default decides the type: how does Python write an integer, a float and a text?',
    'A double needs its dot, and a text its quotes: without them, 7 is a number.'))


def require_gap(name: str, wanted: ParameterType, value: object) -> None:
    """Add the requirement that a parameter of the door is declared."""
    article = 'an' if wanted is INTEGER else 'a'

    @fill.require(f'`{name}` is {article} {wanted.label}, and it is `{value!r}`', see=TYPE)
    def is_declared(trial: Trial) -> None:
        expect_declared(trial, name, wanted, value)


require_gap('max_angle_deg', INTEGER, 90)
require_gap('speed_dps', DOUBLE, 30.0)
require_gap('label', STRING, '7')


EXERCISES = (fill, declare, mend)
