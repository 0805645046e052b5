"""Exercises of chapter 4: fill in how a parameter is read, read a parameter at the right moment, and predict what
is read."""

from typing import Any, NamedTuple

from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.exercises.exercise import DICTIONARY, FUNCTION, NODE_CLASS, Exercise
from param_tutorial.exercises.trial import NoUse, Trial, expect
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.parameters import values

CHAPTER = '04_retrieving'
OBJECT = 'An object and its value'
NOTICE = 'Change it: when does a node notice?'
FALLBACK = 'Several at once, and a fallback'
START = 'Which value does a node start with?'

read = Exercise('4a', 'Read at the right moment', CHAPTER, NODE_CLASS, node_name='wheel', hints=(
    'The method needs the value that the parameter has when the method is called.',
    '`self.get_parameter(name)` gives an object; the number in it is its `.value`.',
    'Python’s `min(a, b)` is the smaller of two numbers, so the method is one line: `return min(wanted_rpm, ...)`.'))


def limited(trial: Trial, wheel: Any, wanted_rpm: int) -> Any:
    return trial.call(f'`limited({wanted_rpm})`', wheel.limited, wanted_rpm)


@read.require('`limited(500)` is 100 at the start, and `limited(40)` is 40', see=OBJECT)
def at_the_start(trial: Trial) -> None:
    wheel = trial.start()
    given = limited(trial, wheel, 500), limited(trial, wheel, 40)
    expect(given == (100, 40), '100 and 40', f'they are `{given[0]!r}` and `{given[1]!r}`')


@read.require('after somebody has set `max_speed_rpm` to 150, `limited(500)` is 150', see=NOTICE)
def after_a_change(trial: Trial) -> None:
    wheel = trial.start()
    trial.client(wheel).set_parameter('max_speed_rpm', 150).raise_for_reason()
    given = limited(trial, wheel, 500)
    expect(given == 150, '150', f'it is `{given!r}`' + (
        '. The node accepted 150 and still uses a copy that it made in its constructor' if given == 100 else ''))


@read.require('started with `-p max_speed_rpm:=120`, the node gives 120 for `limited(500)`', see=START)
def with_an_override(trial: Trial) -> None:
    given = limited(trial, trial.start(ros_args=['-p', 'max_speed_rpm:=120']), 500)
    expect(given == 120, '120, the effective value', f'it is `{given!r}`' + (
        '. That is the default in the source, not what the parameter holds' if given == 100 else ''))


predict = Exercise('4b', 'Predict what is read', CHAPTER, DICTIONARY, hints=(
    'Write the number, `True` or `False` that Python would show. A wrong guess costs nothing.',
    'A parameter object is a photograph, and a fallback is stored nowhere.',
    'An override takes the default’s place when the parameter is declared.'))


class Scene(NamedTuple):
    """What there is when the exercise has been told."""

    robot: SimpleParamNode
    photo: Parameter
    fallback: Parameter
    second: SimpleParamNode


def story(trial: Trial) -> Scene:
    """Do what the exercise tells."""
    robot = trial.start(SimpleParamNode)
    photo = robot.get_parameter('max_speed_rpm')
    trial.client(robot).set_parameter('max_speed_rpm', 150)
    fallback = Parameter('battery_volts', value=12.0)
    second = trial.start(SimpleParamNode, ros_args=['-r', '__node:=second', '-p', 'max_speed_rpm:=120'])
    return Scene(robot, photo, fallback, second)


@predict.require_prediction('photo.value', see=OBJECT, because={
    150: 'That is what the robot holds now, and the photograph is older'})
def photograph(trial: Trial) -> Any:
    return story(trial).photo.value


@predict.require_prediction("robot.get_parameter('max_speed_rpm').value", see=OBJECT, because={
    100: 'A new photograph shows the new value'})
def present(trial: Trial) -> Any:
    return story(trial).robot.get_parameter('max_speed_rpm').value


@predict.require_prediction("robot.get_parameter_or('battery_volts', fallback).value", see=FALLBACK, because={
    12: 'The fallback holds a double', None: 'The parameter is not declared, so the fallback is used'})
def fallen_back(trial: Trial) -> Any:
    scene = story(trial)
    return scene.robot.get_parameter_or('battery_volts', scene.fallback).value


@predict.require_prediction("robot.has_parameter('battery_volts')", see=FALLBACK, because={
    True: 'The fallback is used on the spot and declares nothing'})
def stored(trial: Trial) -> Any:
    return story(trial).robot.has_parameter('battery_volts')


@predict.require_prediction("second.get_parameter('max_speed_rpm').value", see=START, because={
    100: 'That is the default, and somebody has said otherwise',
    150: 'That is what was set on the first robot: a parameter lives in one node'})
def overridden(trial: Trial) -> Any:
    return story(trial).second.get_parameter('max_speed_rpm').value


fill = Exercise('4c', 'Fill two gaps, and mend a line', CHAPTER, FUNCTION, hints=(
    '`get_parameter` takes the name of a parameter. What the robot holds is the `.value` of what it returns.',
    '`get_parameter_or` takes a name and a parameter object. The section “Several at once, and a fallback” '
    "makes one: `Parameter('battery_volts', value=12.0)`."))


class Battery(Node):
    """A robot that knows its battery."""

    def __init__(self) -> None:
        super().__init__('robot')
        self.declare_parameters('', [('max_speed_rpm', 80), ('battery_volts', 11.5)])


def report(trial: Trial, robot: Node) -> tuple[Any, Any]:
    """Call the learner's function, and return the two values."""
    given = trial.call('`report(robot)`', trial.work, robot)
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise NoUse('two values, the speed and the voltage', f'it returns `{given!r}`')
    return given[0], given[1]


def _format_given(given: object) -> str:
    return 'it is a parameter object, and not its value' if isinstance(given, Parameter) else f'it is `{given!r}`'


@fill.require('the first value is the speed that the robot holds, also after a change', see=OBJECT)
def reports_speed(trial: Trial) -> None:
    robot = trial.start(SimpleParamNode)
    for rpm in (100, 150):
        trial.client(robot).set_parameter('max_speed_rpm', rpm).raise_for_reason()
        speed, _ = report(trial, robot)
        expect(values.same(rpm, speed), f'`{rpm}`', _format_given(speed))


@fill.require('the second value is 12.0 if the robot has no `battery_volts`', see=FALLBACK)
def falls_back(trial: Trial) -> None:
    robot = trial.start(SimpleParamNode)
    _, volts = report(trial, robot)
    expect(values.same(12.0, volts), '`12.0`', _format_given(volts))
    expect(not robot.has_parameter('battery_volts'), 'the robot stays as it is', 'your function has declared it')


@fill.require('the second value is that of a robot that has one', see=FALLBACK)
def reports_voltage(trial: Trial) -> None:
    _, volts = report(trial, trial.start(Battery))
    expect(values.same(11.5, volts), '`11.5`, which this robot holds', _format_given(volts))


EXERCISES = (fill, read, predict)
