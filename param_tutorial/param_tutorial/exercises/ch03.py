"""Exercises of chapter 3: declare parameters, and mend declarations."""

from param_tutorial.client import ParameterClient
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.trial import Trial, expect
from param_tutorial.values import BOOL, DOUBLE, INTEGER, ParameterType

CHAPTER = '03_declaring'
TYPE = 'Build it: one declaration, one type'
DESCRIPTOR = 'Build it: the descriptor'
WHO_DECIDES = 'Who decides the type?'


def client_for(trial: Trial, name: str) -> ParameterClient:
    """Start the learner's node, and expect it to have a parameter."""
    client = trial.client(trial.start())
    expect(name in client.list_parameters(), f'a parameter `{name}`', 'the node has none of that name')
    return client


def expect_declared(trial: Trial, name: str, wanted: ParameterType, value: object) -> None:
    """Expect a parameter of a type, with a value to start with."""
    client = client_for(trial, name)
    found, start = client.describe_parameter(name).type, client.get_parameter(name)
    expect(found is wanted and start == value, _facts(wanted, value), _facts(found, start))


def _facts(parameter_type: ParameterType, value: object) -> str:
    return f'type {parameter_type.label}, ' + ('no value' if value is None else f'value `{value!r}`')


def expect_answer(trial: Trial, name: str, value: object, kind: str, because: str = '') -> None:
    """Expect the node's answer to a value to be of a kind.

    :param kind: As in SetResult.kind.
    :param because: What to think of when it accepts what it should not.
    """
    expect_result(client_for(trial, name), name, value, kind, because)


def expect_result(client: ParameterClient, name: str, value: object, kind: str, because: str = '') -> None:
    """Expect the answer of a node that is there already; as above."""
    result = client.set_parameter(name, value)
    expect(result.kind == kind, f'`{name} = {value!r}` is {"" if kind == "accepted" else "refused: "}{kind}',
           f'{result}' + (f'. {because}' if result.successful else ''))


declare = Exercise('3a', CHAPTER, NODE_CLASS, node_name='rover', hints=(
    'Each parameter takes one line `self.declare_parameter(name, default, descriptor)`, and the default decides its '
    'type. The section “Build it: one declaration, one type” shows the first two arguments.',
    'In Python `1` is an `int` and `1.0` a `float`. A double takes its range from a `FloatingPointRange`, in a list: '
    '`ParameterDescriptor(floating_point_range=[...])`.',
    'The descriptor has a field `read_only`. It is `False` unless you say `read_only=True`.'))


@declare.require('`max_speed_mps` is a double and starts at one metre per second', see=TYPE)
def speed(trial):
    expect_declared(trial, 'max_speed_mps', DOUBLE, 1.0)


@declare.require('`max_speed_mps` goes from 0.0 to 2.0, both ends included, and the node sees to it', see=DESCRIPTOR)
def speed_range(trial):
    because = ('A description is read by people only, an `integer_range` by integers only: a double has its '
               '`floating_point_range`')
    for end in (0.0, 2.0):
        expect_answer(trial, 'max_speed_mps', end, 'accepted')
    for beyond in (-0.5, 2.5):
        expect_answer(trial, 'max_speed_mps', beyond, 'out of range', because)


@declare.require('`wheels` is an integer, and it is 6', see=TYPE)
def wheels(trial):
    expect_declared(trial, 'wheels', INTEGER, 6)


@declare.require('nobody can change `wheels`', see=DESCRIPTOR)
def wheels_locked(trial):
    expect_answer(trial, 'wheels', 4, 'read only', 'A lock is a field of the descriptor, `read_only`')


mend = Exercise('3b', CHAPTER, NODE_CLASS, node_name='lamp', hints=(
    'Ask the lamp as it is: `ParameterClient(ros.add(Lamp)).describe_parameters()` shows the type of each parameter.',
    'A descriptor cannot choose a type, and a description limits nothing. The default is what decides, and a range '
    'is what limits.',
    'The type can stand in the default’s place: `Parameter.Type.DOUBLE`. The parameter then has no value yet.'))


@mend.require('`brightness_percent` takes 62.5', see=WHO_DECIDES)
def halves(trial):
    expect_answer(trial, 'brightness_percent', 62.5, 'accepted')


@mend.require('`brightness_percent` refuses 120.0', see=DESCRIPTOR)
def percent(trial):
    expect_answer(trial, 'brightness_percent', 120.0, 'out of range',
                  'What is said in a description is enforced by nobody, and an `integer_range` holds for integers only')


@mend.require('`warm_white` is a boolean, and it is on', see=TYPE)
def warm_white(trial):
    expect_declared(trial, 'warm_white', BOOL, True)


@mend.require('`calibration` is a double that has no value until somebody sets one', see=WHO_DECIDES)
def calibration(trial):
    expect_declared(trial, 'calibration', DOUBLE, None)


EXERCISES = (declare, mend)
