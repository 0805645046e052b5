"""Exercises of chapter 4: fill in how a parameter is read, read a parameter at the right moment, and predict what
is read."""

from typing import Any, NamedTuple

from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.values import INTEGER
from param_tutorial.exercises.exercise import DICTIONARY, FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import WithSecondJudge, derive, expect_declared
from param_tutorial.exercises.trial import NotTried, NotYet, NoUse, Trial, expect
from param_tutorial.nodes.simple_param_node import SimpleParamNode

CHAPTER = '04_retrieving'
OBJECT = 'An object and its value'
NOTICE = 'Change it: when does a node notice?'
FALLBACK = 'Several at once, and a fallback'
START = 'Which value does a node start with?'

read = Exercise('4b', 'Read at the right moment', CHAPTER, NODE_CLASS, node_name='wheel', hints=(
    'The constructor is like those of `Copies` and `Reads`: the name of the node, and a declaration with the default '
    '100. The method needs the value that the parameter has when someone calls the method.',
    '`self.get_parameter(name)` returns an object; the number in it is its `.value`.',
    'Python’s `min(a, b)` is the smaller of two numbers, so the method is one line: `return min(wanted_rpm, ...)`.'))


def expect_limited(trial: Trial, wheel: Any, wanted_rpm: float, allowed_rpm: int, wrong: dict[int, str]) -> None:
    """Expect what the method returns for a wanted speed.

    :param wrong: What to think of, for values that it may return instead.
    :raises NoUse: there is no such method, or it raises an exception, as it would in the other requirements.
    """
    if not callable(getattr(wheel, 'limited', None)):
        raise NoUse('a method `limited`', 'the wheel has none')
    try:
        given = trial.call(f'`limited({wanted_rpm})`', wheel.limited, wanted_rpm)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    goal = min(wanted_rpm, allowed_rpm)
    because = next((f'. {text}' for value, text in wrong.items() if values.same(value, given)), '')
    expect(isinstance(given, (int, float)) and given == goal, f'`limited({wanted_rpm})` is `{goal}`',
           f'it is {_format_given(given)}{because}{". Does the method return it?" if given is None else ""}')


@read.require('`limited(500)` is 100 at the start, and any speed below that comes back as it is', see=OBJECT)
def at_the_start(trial: Trial) -> None:
    wheel = trial.start()
    try:
        expect_declared(trial, 'max_speed_rpm', INTEGER, 100)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    try:
        for wanted_rpm in (500, 40, 100, 101, 0, 40.5, -40, -500):
            expect_limited(trial, wheel, wanted_rpm, 100, {})
    except NotYet as error:  # it would come to light in each requirement
        raise NoUse(error.expected, error.happened) from None


@read.require('when a client sets `max_speed_rpm`, `limited(500)` is the new value from then on', see=NOTICE)
def after_a_change(trial: Trial) -> None:
    wheel, other = trial.start(), trial.start(namespace='/other')
    expect_limited(trial, wheel, 500, 100, {})
    before = 100
    for rpm in (150, 60, 0, 175):
        trial.client(wheel).set_parameter('max_speed_rpm', rpm).raise_for_reason()
        expect_limited(trial, wheel, 500, rpm, {
            before: f'The node accepted {rpm} and still uses a copy that it made earlier'})
        expect_limited(trial, wheel, min(40, rpm), rpm, {})
        before = rpm
    expect_limited(trial, other, 500, 100, {175: 'That is the parameter of another wheel'})


@read.require('a value that is rejected changes nothing', see=NOTICE)
def after_a_rejection(trial: Trial) -> None:
    wheel = trial.start(derive(WithSecondJudge, trial.work))
    wheel.rejects = True
    trial.client(wheel).set_parameter('max_speed_rpm', 150)
    expect_limited(trial, wheel, 500, wheel.get_parameter('max_speed_rpm').value, {
        150: 'That value was rejected in the end, and the parameter never held it'})


@read.require('started with `-p max_speed_rpm:=120`, the node returns 120 for `limited(500)`', see=START)
def with_an_override(trial: Trial) -> None:
    for rpm in (120, 70):
        wheel = trial.start(ros_args=['-p', f'max_speed_rpm:={rpm}'])
        expect_limited(trial, wheel, 500, rpm, {
            100: 'That is the default in the source, not what the parameter holds'})


predict = Exercise('4c', 'Predict what is read', CHAPTER, DICTIONARY, hints=(
    'Write the number, `True` or `False` that Python would show. A wrong guess costs nothing.',
    'The object of a number is a photograph, and a fallback is stored nowhere.',
    'An override takes the place of the default when the parameter is declared.'))


class Story(NamedTuple):
    """What there is after the lines of the exercise."""

    robot: SimpleParamNode
    photo: Parameter
    fallback: Parameter
    second: SimpleParamNode


def story(trial: Trial) -> Story:
    """Run the lines of the exercise."""
    robot = trial.start(SimpleParamNode)
    photo = robot.get_parameter('max_speed_rpm')
    trial.client(robot).set_parameter('max_speed_rpm', 150)
    fallback = Parameter('battery_volts', value=12.0)
    second = trial.start(SimpleParamNode, ros_args=['-r', '__node:=second', '-p', 'max_speed_rpm:=120'])
    return Story(robot, photo, fallback, second)


@predict.require_prediction('photo.value', see=OBJECT, because={
    150: 'That is what the robot holds now, and the photograph is older'})
def photograph(trial: Trial) -> Any:
    return story(trial).photo.value


@predict.require_prediction("robot.get_parameter('max_speed_rpm').value", see=OBJECT, because={
    100: 'This expression takes a new photograph'})
def present(trial: Trial) -> Any:
    return story(trial).robot.get_parameter('max_speed_rpm').value


@predict.require_prediction("robot.get_parameter_or('battery_volts', fallback).value", see=FALLBACK, because={
    12: 'The fallback holds a double', None: 'The parameter is not declared, so the fallback is used'})
def fallen_back(trial: Trial) -> Any:
    scene = story(trial)
    return scene.robot.get_parameter_or('battery_volts', scene.fallback).value


@predict.require_prediction("robot.has_parameter('battery_volts')", see=FALLBACK, because={
    True: 'The fallback is used once and declares nothing'})
def stored(trial: Trial) -> Any:
    return story(trial).robot.has_parameter('battery_volts')


@predict.require_prediction("second.get_parameter('max_speed_rpm').value", see=START, because={
    100: 'That is the default, and this robot was started with an override',
    150: 'That is what was set on the first robot, and each node has its own parameters'})
def overridden(trial: Trial) -> Any:
    return story(trial).second.get_parameter('max_speed_rpm').value


fill = Exercise('4a', 'Fill two gaps, and mend a line', CHAPTER, FUNCTION, hints=(
    '`get_parameter` takes the name of a parameter. The number is the `.value` of what it returns.',
    '`get_parameter_or` takes a name and a parameter object. The section “Several at once, and a fallback” '
    "makes one: `Parameter('battery_volts', value=12.0)`."))


class Battery(Node):
    """A robot that knows its battery."""

    def __init__(self) -> None:
        super().__init__('robot')
        self.declare_parameters('', [('max_speed_rpm', 80), ('battery_volts', 11.5)])


def report(trial: Trial, robot: Node) -> tuple[Any, Any]:
    """Call the learner's function, and return the two values.

    :raises NoUse: it returns something else, or raises an exception, as it would in the other requirements.
    """
    try:
        given = trial.call('`report(robot)`', trial.work, robot)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise NoUse('two values, the speed and the voltage', f'it returns `{given!r}`')
    return given[0], given[1]


def _format_given(given: object) -> str:
    if isinstance(given, Parameter):
        return 'a parameter object, and not its value'
    return f'the string `{given!r}`' if isinstance(given, str) else f'`{given!r}`'


def _expect_number(given: Any, goal: float) -> None:
    """Expect a number; a double has to be one, since 12 and 12.0 are of different types to ROS.

    :raises NoUse: it is still a parameter object, as it would be in the other requirements.
    """
    if isinstance(given, Parameter):
        raise NoUse(f'`{goal}`', f'it is {_format_given(given)}')
    met = values.same(goal, given) if isinstance(goal, float) else (
        isinstance(given, (int, float)) and not isinstance(given, bool) and given == goal)
    expect(met, f'`{goal}`', f'it is {_format_given(given)}')


@fill.require('the first value is the speed that the robot holds, also after a change', see=OBJECT)
def reports_speed(trial: Trial) -> None:
    robot, other = trial.start(SimpleParamNode), trial.start(Battery)
    for rpm in (100, 150, 0):
        trial.client(robot).set_parameter('max_speed_rpm', rpm).raise_for_reason()
        speed, _ = report(trial, robot)
        if trial.client(robot).get_parameter('max_speed_rpm') != rpm:
            raise NotTried  # the last requirement says that the function has changed it
        _expect_number(speed, rpm)
    speed, _ = report(trial, other)
    _expect_number(speed, 80)


@fill.require('the second value is 12.0 if the robot has no `battery_volts`', see=FALLBACK)
def falls_back(trial: Trial) -> None:
    _, volts = report(trial, trial.start(SimpleParamNode))
    _expect_number(volts, 12.0)


@fill.require('the second value is that of a robot that has one', see=FALLBACK)
def reports_voltage(trial: Trial) -> None:
    robot = trial.start(Battery)
    for volts in (11.5, 0.0, 13.25):
        trial.client(robot).set_parameter('battery_volts', volts).raise_for_reason()
        _, given = report(trial, robot)
        _expect_number(given, volts)


@fill.require('the robot stays as it is', see=FALLBACK)
def leaves_alone(trial: Trial) -> None:
    for node_class in (SimpleParamNode, Battery):
        robot = trial.start(node_class)
        client = trial.client(robot)
        client.set_parameter('max_speed_rpm', 120).raise_for_reason()  # back at the default is a change, too
        before = client.get_parameters()
        report(trial, robot)
        after = client.get_parameters()
        new = sorted(set(after) - set(before))
        expect(not new, 'no new parameter', f'your function has declared `{", ".join(new)}`')
        changed = [name for name in before if not values.same(before[name], after.get(name))]
        expect(not changed, 'the values from before', f'your function has changed `{", ".join(changed)}`')


EXERCISES = (fill, read, predict)
