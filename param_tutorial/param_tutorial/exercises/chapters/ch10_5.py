"""Exercises of chapter 10.5: compare as ROS does, try something and go back, and bring back the defaults."""

import math
from collections.abc import Sequence
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.systems.restoring import restore
from param_tools.systems.sets import Difference, ParameterSet, compare
from param_tutorial.exercises.exercise import FUNCTION, TEXT, Exercise
from param_tutorial.exercises.expectations import ClientInCorner, run_lines
from param_tutorial.exercises.trial import NotYet, NoUse, Trial, expect

CHAPTER = '10_5_whole_sets'
DIFFERS = 'What differs?'
FOUR = 'Four things to compare'
BACK = 'Back to where it was'


def keep_apart(node: Node, low: str, high: str) -> None:
    """Have a node reject every change after which one parameter would not be below the other."""

    def judge(parameters: list[Parameter]) -> SetParametersResult:
        after = {name: node.get_parameter(name).value for name in (low, high)}
        after |= {each.name: each.value for each in parameters if each.name in after}
        return SetParametersResult(
            successful=after[low] < after[high],
            reason=f'{low} = {after[low]}, {high} = {after[high]}: {low} must be below {high}')

    node.add_on_set_parameters_callback(judge)


# -- 10.5b ----------------------------------------------------------------------------------------------------

experiment = Exercise('10.5b', 'An experiment in five lines', CHAPTER, TEXT, hints=(
    "The first two lines are `client = ParameterClient('/robot')` and `then = ParameterSet.of(client)`.",
    'Two sets are compared: one from before the change, and what the robot holds after it. So the change comes between '
    'them.',
    '`restore` makes the difference go away, so the comparison has to come first.'))
WINTER = {'low_c': -30, 'high_c': -10}


class Robot(Node):
    """What the learner's lines try a winter on."""

    def __init__(self) -> None:
        super().__init__('robot')
        self.declare_parameter('mode', 'careful')
        self.declare_parameter('low_c', -5)
        self.declare_parameter('high_c', 40)
        self.requests: list[dict[str, object]] = []
        keep_apart(self, 'low_c', 'high_c')
        self.add_on_set_parameters_callback(self.note)

    def note(self, parameters: list[Parameter]) -> SetParametersResult:
        # It is called for each parameter of set_parameters, and once for set_parameters_atomically.
        self.requests.append({each.name: each.value for each in parameters})
        return SetParametersResult(successful=True)


def _asked(what: Any) -> Any:
    """Return the client of a node in the corner for a name, and anything else as it is."""
    return ClientInCorner(what) if isinstance(what, str) else what


class SetInCorner(ParameterSet):
    """What ParameterSet is for the learner, whose robot is in the corner during a check."""

    @classmethod
    def of(cls, node: Any, label: str = '') -> ParameterSet:
        return super().of(_asked(node), label)


# An AttributeError, for one, names the class as the learner knows it.
SetInCorner.__name__ = ParameterSet.__name__


# The lines have to work wherever the robot stands, and one end of a winter may be there already.
STARTS: tuple[Sequence[str], ...] = ((), ('-p', 'low_c:=10', '-p', 'high_c:=20'))


def tried(trial: Trial, ros_args: Sequence[str]) -> tuple[Robot, Any, ParameterSet, ParameterSet]:
    """Run the learner's lines beside a robot; return it, what they call `changed`, and its set before and after."""
    robot = trial.start(Robot, ros_args=ros_args)
    client = trial.client(robot)
    before = ParameterSet.of(client)
    space = run_lines(
        trial, ParameterClient=ClientInCorner, ParameterSet=SetInCorner,
        compare=lambda before, after, **options: compare(_asked(before), _asked(after), **options),
        restore=lambda node, wanted, **options: restore(_asked(node), wanted, **options))
    return robot, space.get('changed'), before, ParameterSet.of(client)


@experiment.require('the lines run to their end, and `changed` shows what the winter changes', see=FOUR)
def notes_the_change(trial: Trial) -> None:
    for ros_args in STARTS:
        robot, changed, before, _ = tried(trial, ros_args)
        wanted = {name: (before[name], value) for name, value in WINTER.items()}
        expect(isinstance(changed, Difference), '`changed` is what `compare` returns', f'it is `{changed!r}`')
        found = {each.name: (each.before, each.after) for each in changed}
        expect(found == wanted, 'in `changed`: ' + _differences(wanted), _differences(found) or 'it is empty')
        held = [', '.join(f'`{name} = {value!r}`' for name, value in each.items()) for each in robot.requests]
        expect(WINTER in robot.requests, 'both ends of the winter in one request',
               f'the requests are, one after the other, {"; ".join(held)}')


def _differences(found: dict[str, tuple[Any, Any]]) -> str:
    return ', '.join(f'`{name}` from `{before!r}` to `{after!r}`' for name, (before, after) in found.items())


@experiment.require('afterwards the robot is as it was before', see=BACK)
def leaves_it_alone(trial: Trial) -> None:
    for ros_args in STARTS:
        _, _, before, after = tried(trial, ros_args)
        expect(before == after, 'the values from before',
               ', '.join(f'`{each.name}` is `{each.after!r}` and was `{each.before!r}`'
                         for each in compare(before, after)))


# -- 10.5a ----------------------------------------------------------------------------------------------------

equal = Exercise('10.5a', 'Compare arrays, too', CHAPTER, FUNCTION, hints=(
    'Begin with the lines of `same`. Two lists are both of type `list`; whether they are the same depends on their '
    'elements.',
    'Once the function knows what makes two single values the same, it may call itself for two elements.',
    '`all(same_value(one, other) for one, other in zip(before, after))`, and before that the lengths: `zip` stops at '
    'the shorter list.'))


def expect_verdict(trial: Trial, wanted: bool, *pairs: tuple[object, object]) -> None:
    """Expect the learner's function to find that pairs are the same, or not, in either order."""
    for pair in pairs:
        for before, after in (pair, pair[::-1]):
            asked = f'`{before!r}` and `{after!r}`'
            try:
                found = trial.call(f'the function, for {asked},', trial.work, before, after)
            except NotYet as error:  # as it would for other pairs
                raise NoUse(error.expected, error.happened) from None
            expect(isinstance(found, bool), '`True` or `False`', f'the function returned `{found!r}` for {asked}')
            expect(found is wanted, f'{asked} are {"the same" if wanted else "different"}',
                   f'the function returned `{found!r}`')


@equal.require('different types, values and lengths are different, in an array as well', see=DIFFERS)
def different_is_different(trial: Trial) -> None:
    expect_verdict(trial, False, ([1, 2], [1.0, 2.0]), ([True], [1]), ([0.0, 1.0], [False, True]), ([0], [0.0]),
                   (1, 1.0), (True, 1), ('1', 1), ([1], 1), (None, False),
                   ([1, 2], [2, 1]), ([1, 2], [1, 2, 3]), ([], [1]), (['a'], ['b']), ([0.5, math.nan], [0.5, 0.5]),
                   ([math.nan], [math.nan, math.nan]), (1, 2), ('a', 'b'), (math.nan, 0.0),
                   (0.1 + 0.2, 0.3), ([0.1 + 0.2], [0.3]), ('a', 'A'))


@equal.require('equal values are the same, `nan` in an array as well', see=DIFFERS)
def equal_is_equal(trial: Trial) -> None:
    # Two different objects: for the same one Python does not look whether it is equal to itself.
    expect_verdict(trial, True, ([0.5, float('nan')], [0.5, float('nan')]), (float('nan'), float('nan')),
                   ([1, 2, 3], [1, 2, 3]), ([True], [True]), (['a', ''], ['a', '']), ([], []), (1.5, 1.5),
                   ('a', 'a'), (None, None))


# -- 10.5c ----------------------------------------------------------------------------------------------------

factory = Exercise('10.5c', 'Factory settings', CHAPTER, FUNCTION, hints=(
    '`ParameterSet.defaults(node_class)` is what you want the node to have. It is a mapping, so '
    '`{name: value for name, value in ….items() if …}` leaves some out.',
    '`restore(node, wanted)` sets what differs. You can loop over what it returns: each outcome has a `name` and a '
    "`word`, which is `'set'` if all is well.",
    "`return [outcome.name for outcome in restore(node, wanted) if outcome.word != 'set']`."))


class Lamp(Node):
    """A node to bring back: with a rule that rejects some orders, and a read-only parameter."""

    def __init__(self) -> None:
        super().__init__('lamp')
        self.declare_parameter('dim_percent', 10)
        self.declare_parameter('full_percent', 90)
        self.declare_parameter('color', 'white')
        self.declare_parameter('color_temperature_k', 2700)
        self.declare_parameter('plate', 'none', ParameterDescriptor(read_only=True))
        keep_apart(self, 'dim_percent', 'full_percent')


class Kettle(Node):
    """A kettle whose `offset_c` is not a number until somebody has measured it."""

    def __init__(self) -> None:
        super().__init__('kettle')
        self.declare_parameter('boil_c', 100.0)
        self.declare_parameter('offset_c', math.nan)
        self.declare_parameter('steps_c', [70.0, 85.0])


CHANGED: dict[type[Node], dict[str, object]] = {
    Lamp: {'dim_percent': 1, 'full_percent': 5, 'color': 'red', 'color_temperature_k': 4000},
    Kettle: {'boil_c': 95.5, 'steps_c': [60.0]}}


def call(trial: Trial, node_class: type[Node], keep: list[str], ros_args: Sequence[str] = ()
         ) -> tuple[ParameterSet, ParameterSet, object]:
    """Start a node, change it and call the learner's function.

    :return: What the node holds then, its defaults, and what the function returned.
    """
    node = trial.start(node_class, ros_args=ros_args, all_services=True)
    client = trial.client(node)
    client.set_parameters_atomically(CHANGED[node_class])
    defaults = ParameterSet.defaults(node_class)
    asked = f'factory_settings({node.get_name()}, {node_class.__name__}, {keep})'
    returned = trial.call(f'`{asked}`', trial.work, node, node_class, given := list(keep))
    if not any(each is node for each in trial.ros.nodes):
        raise NoUse(f'after `{asked}` the node runs on, with other values', 'the function has put an end to the node')
    expect(given == keep, f'the list `keep` stays `{keep}`', f'the function has made it `{given!r}`')
    return ParameterSet.of(client), defaults, returned


def expect_back(held: ParameterSet, wanted: dict[str, Any], when: str) -> None:
    """Expect a node to hold values, after something."""
    for name, value in wanted.items():
        expect(values.same(held.get(name), value), f'`{name}` is `{value!r}` {when}', f'it is `{held.get(name)!r}`')


@factory.require('everything has its default again, even where a rule rejects the values one after the other', see=BACK)
def all_back(trial: Trial) -> None:
    for node_class in (Lamp, Kettle):
        held, defaults, returned = call(trial, node_class, [])
        expect_back(held, {name: defaults[name] for name in CHANGED[node_class]}, 'afterwards')
        expect(returned == [], 'the function returns `[]`, since nothing failed', f'it returned `{returned!r}`')


@factory.require('what is named in `keep` stays', see=FOUR)
def kept(trial: Trial) -> None:
    for node_class, keep in ((Lamp, ['color']), (Lamp, ['dim_percent', 'color']), (Kettle, ['steps_c'])):
        held, defaults, _ = call(trial, node_class, keep)
        changed = CHANGED[node_class]
        expect_back(held, {name: changed[name] if name in keep else defaults[name] for name in changed},
                    f'afterwards, with `keep={keep}`')


@factory.require('what could not be brought back is returned', see=BACK)
def reports_what_failed(trial: Trial) -> None:
    # With a full_percent of 5 the rule rejects the default of dim_percent. One request for both leaves the color as
    # well, and one after the other brings it back: the function may do either, as long as it reports what is so.
    for keep in ([], ['full_percent']):
        held, defaults, returned = call(trial, Lamp, keep, ('-p', 'plate:=L-1'))
        failed = [name for name in defaults if name not in keep and not values.same(held[name], defaults[name])]
        expect(isinstance(returned, list) and sorted(map(str, returned)) == sorted(failed),
               f'for a lamp that was started with another `plate`, with `keep={keep}`, the function returns '
               f'`{failed!r}`',
               f'it returned `{returned!r}`')


EXERCISES = (equal, experiment, factory)
