"""Exercises of chapter 10.4: state rules, rename parameters, and bring a node back to its defaults."""

from collections.abc import Mapping, Sequence

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tutorial.exercises.exercise import FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import expect_accepted, expect_rejected
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect
from param_tutorial.parameters.rules import Rules

CHAPTER = '10_4_beyond_today'
STATE = 'Build it: state the rule'
KINDS = 'Change it: more kinds of rules'
ACROSS = 'Rules across parameters'
ALIASES = 'Build it: aliases'
DEFAULTS = 'Node with defaults'
RESTORE = 'Back to where it was'

rules = Exercise('10.4a', 'State the rules', CHAPTER, NODE_CLASS, node_name='drone', hints=(
    'One `Rules(self)` behind the declarations, and three rules chained to it.',
    'The three are `matches`, `one_of` and `check`. The pattern for three capital letters is `[A-Z]{3}`.',
    "`.check(['land_percent', 'home_percent'], lambda land, home: ..., 'a sentence')`: the function gets the two "
    'values in the order of the names.'))


@rules.require('a call sign is three capital letters, no more and no less', see=STATE)
def call_sign(trial: Trial) -> None:
    drone = trial.start()
    for bad in ('abc', 'AB', 'ABCD', ''):
        expect_rejected(trial, drone, {'call_sign': bad})
    expect_accepted(trial, drone, {'call_sign': 'XYZ'})


@rules.require('there are three modes', see=KINDS)
def mode(trial: Trial) -> None:
    drone = trial.start()
    expect_rejected(trial, drone, {'mode': 'loop'})
    for good in ('track', 'land', 'hover'):
        expect_accepted(trial, drone, {'mode': good})


@rules.require('`land_percent` is below `home_percent`, whether one of them is set or both together', see=ACROSS)
def order(trial: Trial) -> None:
    drone = trial.start()
    for bad in ({'land_percent': 30}, {'home_percent': 5}, {'land_percent': 25, 'home_percent': 20}):
        expect_rejected(trial, drone, bad)
    expect_accepted(trial, drone, {'land_percent': 50, 'home_percent': 60})


@rules.require('with an override that breaks a rule the drone does not start', see=STATE)
def at_the_start(trial: Trial) -> None:
    for override in ('mode:=loop', 'call_sign:=ABCD', 'land_percent:=40'):
        try:
            trial.start(ros_args=['-p', override])
        except NoUse:
            continue
        raise NotYet(f'with `{override}` it does not start',
                     'it started. Are the rules stated, and behind the declarations?')


rename = Exercise('10.4b', 'A new name', CHAPTER, NODE_CLASS, node_name='wagon', hints=(
    'Declare the new names only. The old ones stand in one `Aliases`.',
    '`Aliases(self, {...})` comes before the first declaration: it has to move the overrides to the new names.',
    "`Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})`, and the declarations with the new names."))


def expect_values(trial: Trial, node: Node, wanted: Mapping[str, object], when: str) -> None:
    """Expect a node to hold values, after something."""
    client = trial.client(node)
    existing = client.list_parameters()
    for name, value in wanted.items():
        expect(name in existing, f'there is a parameter `{name}`', f'there are only {", ".join(existing[2:])}')
        found = client.get_parameter(name)
        expect(found == value, f'`{name}` is `{value!r}` {when}', f'it is `{found!r}`')


@rename.require('what is set under one name can be read under the other', see=ALIASES)
def both_ways(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800, 'plate_number': 'none', 'plate': 'none'}, 'at first')
    for name, value in (('width', 700), ('width_mm', 900)):
        expect_accepted(trial, wagon, {name: value})
        expect_values(trial, wagon, {'width_mm': value, 'width': value}, f'when `{name} = {value}` was set')


@rename.require('an old file reaches the new names, the read-only one too', see=ALIASES)
def old_overrides(trial: Trial) -> None:
    wagon = trial.start(ros_args=['-p', 'width:=600', '-p', 'plate:=W-7'])
    expect_values(trial, wagon, {'width_mm': 600, 'plate_number': 'W-7'},
                  'with the overrides `width:=600` and `plate:=W-7`')
    rejected = trial.client(wagon).set_parameter('plate_number', 'W-8')
    expect(not rejected.successful, '`plate_number` is read-only', 'it could be set')


@rename.require('two names with two values, in one request, are rejected', see=ALIASES)
def contradiction(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'at first')
    expect_rejected(trial, wagon, {'width': 1, 'width_mm': 2})


factory = Exercise('10.4c', 'Factory settings', CHAPTER, FUNCTION, hints=(
    '`ParameterSet.defaults(node_class)` is what you want the node to have. It is a mapping, so '
    '`{name: value for name, value in ….items() if …}` leaves some out.',
    '`restore(node, wanted)` sets what differs. What it returns can be looped over: each outcome has a `name` and a '
    "`word`, which is `'set'` if all is well.",
    "`return [outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']`."))


class Lamp(Node):
    """What is to be brought back: in order, locked, and with a rule that rejects some ways back."""

    def __init__(self) -> None:
        super().__init__('lamp')
        self.declare_parameter('dim_percent', 10)
        self.declare_parameter('full_percent', 90)
        self.declare_parameter('colour', 'white')
        self.declare_parameter('plate', 'none', ParameterDescriptor(read_only=True))
        Rules(self).check(['dim_percent', 'full_percent'], lambda dim, full: dim < full,
                          'dim_percent must be below full_percent')


def call(trial: Trial, keep: list[str], ros_args: Sequence[str] = ()) -> tuple[Lamp, object]:
    """Start a lamp, change it, call the learner's function, and return the lamp with what that returned."""
    lamp = trial.start(Lamp, ros_args=ros_args, all_services=True)
    trial.client(lamp).set_parameters_atomically({'dim_percent': 1, 'full_percent': 5, 'colour': 'red'})
    return lamp, trial.call(f'factory_settings(lamp, Lamp, {keep})', trial.work, lamp, Lamp, keep)


@factory.require('everything has its default again, also where a rule stands in the way of one after the other',
                 see=RESTORE)
def all_back(trial: Trial) -> None:
    lamp, failed = call(trial, [])
    expect_values(trial, lamp, {'dim_percent': 10, 'full_percent': 90, 'colour': 'white'}, 'afterwards')
    expect(failed == [], 'the function returns `[]`, since nothing failed', f'it returned `{failed!r}`')


@factory.require('what is named in `keep` stays', see=DEFAULTS)
def kept(trial: Trial) -> None:
    lamp, _ = call(trial, ['colour'])
    expect_values(trial, lamp, {'dim_percent': 10, 'full_percent': 90, 'colour': 'red'},
                  "afterwards, with `keep=['colour']`")


@factory.require('what could not be brought back is returned', see=RESTORE)
def told_what_failed(trial: Trial) -> None:
    _, failed = call(trial, [], ('-p', 'plate:=L-1'))
    expect(failed == ['plate'], "for a lamp that was started with another `plate` the function returns `['plate']`",
           f'it returned `{failed!r}`')


EXERCISES = (rules, rename, factory)
