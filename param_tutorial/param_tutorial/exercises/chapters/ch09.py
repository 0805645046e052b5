"""Exercises of chapter 9: fill in what has become of ROS 1, translate a parameter file of ROS 1, and predict what
ROS 2 makes of ROS 1's habits."""

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.node import Node

from param_tutorial.errors import ParameterFileError
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_declared
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, expect
from param_tutorial.parameters import files, values

CHAPTER = '09_ros1_and_ros2'
TRANSLATE = 'Build it: translate a node'
TYPES = 'Types'
FILES = 'Files'
STORE = 'Who keeps the values?'
DIES = 'When something dies'
RULES = 'Rules, locks and descriptions'
NAMES = 'Names'


class TranslatedDrive(Node):
    """The node that takes the section ``drive`` of the old file."""

    def __init__(self) -> None:
        super().__init__('drive')
        self.declare_parameters('', [
            ('base_frame', 'base'), ('max_speed_mps', 0.5), ('gains.kp', 1.0), ('gains.kd', 0.0)])


class TranslatedCamera(Node):
    """The node that takes the section ``camera``."""

    def __init__(self) -> None:
        super().__init__('camera')
        self.declare_parameters('', [('base_frame', 'base'), ('label', 'none'), ('rates_hz', [5.0])])


translate = Exercise('9a', 'Translate a file', CHAPTER, TEXT, hints=(
    'A file of ROS 2 has a level more: the node, `ros__parameters`, then its values. A dictionary in it makes names '
    'with dots.',
    'Read each value as rcl does. `1` and `2` are integers where doubles were declared, a list has one type, and `1e5` '
    'is a number unless it stands in quotes.',
    'What belonged to everybody goes into a block `/**:`, with `ros__parameters` below it as well.'))


def expect_values(trial: Trial, node_class: type[Node], wanted: Mapping[str, Any], because: str = '') -> None:
    """Start a node with the learner's file, and expect it to hold some values.

    :param because: What to think of when it holds others.
    """
    expect(trial.work.strip(), '', 'the file is empty yet')
    name = {TranslatedDrive: '/drive', TranslatedCamera: '/camera'}[node_class]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / 'file.yaml'
        file.write_text(trial.work, encoding='utf-8')
        try:
            # In the trial's corner the node has a longer name, for which the file is written anew.
            files.render(f'{CORNER}{name}', files.read(file, name)).save(file)
        except ParameterFileError as error:
            raise NoUse(f'a file that rcl reads, with values for `{name}`',
                        str(error).replace(f'{folder}/', '')) from None
        try:
            node = trial.start(node_class, ros_args=['--params-file', str(file)])
        except NoUse as error:
            raise NotYet(error.expected, f'{error.happened}. Each value has to be written as the type that was '
                                         f'declared: a double with its dot, a text that looks like a number in quotes'
                         ) from None
    held = trial.client(node).get_parameters(wanted)
    for parameter, value in wanted.items():
        expect(values.same(held[parameter], value), f'`{parameter}` is `{value!r}`',
               f'it is `{held[parameter]!r}`' + (f'. {because}' if because else ''))


@translate.require('`/drive` starts with it, at a maximum of 1.0 m/s', see=TRANSLATE)
def speed(trial: Trial) -> None:
    expect_values(trial, TranslatedDrive, {'max_speed_mps': 1.0})


@translate.require('`/drive` has the gains 2.0 and 0.1', see=TRANSLATE)
def gains(trial: Trial) -> None:
    expect_values(trial, TranslatedDrive, {'gains.kp': 2.0, 'gains.kd': 0.1})


@translate.require('`/camera` starts with it, and its label is the text `1e5`', see=FILES)
def label(trial: Trial) -> None:
    expect_values(trial, TranslatedCamera, {'label': '1e5'})


@translate.require('`/camera` has the rates 10.0 and 12.5', see=TYPES)
def rates(trial: Trial) -> None:
    expect_values(trial, TranslatedCamera, {'rates_hz': [10.0, 12.5]})


@translate.require('both know that `base_frame` is `base_link`', see=TRANSLATE)
def frame(trial: Trial) -> None:
    for node_class in (TranslatedDrive, TranslatedCamera):
        expect_values(trial, node_class, {'base_frame': 'base_link'},
                      'Nothing belongs to everybody any more: the key `/**` gives it to each node')


class Drive(Node):
    """The node of exercise 9b, as the chapter shows it."""

    def __init__(self) -> None:
        super().__init__('drive')
        self.declare_parameter('max_speed_rpm', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=300)]))
        self.declare_parameter('ticks', 0)
        self.declare_parameter('gains.kp', 0.5)


foresee = Exercise('9b', 'What will it hold?', CHAPTER, DICTIONARY, hints=(
    'Three questions, in this order: is the name declared, is the type the declared one, is the value in the range?',
    'A node that rejects keeps what it has, and nothing is bent. A name that nobody declared does not come to be.',
    'Integers have 64 bits now. And values live in the node, so they end with it.'))


def require_foresight(what: str, because: Mapping[object, str], see: str, *, name: str, value: object,
                      restart: bool = False) -> None:
    """Add the requirement to know what the node holds after somebody set a parameter."""
    @foresee.require_prediction(what, see=see, because=because)
    def held(trial: Trial) -> Any:
        client = trial.client(trial.start(Drive))
        client.set_parameter(name, value)
        if restart:
            client = trial.client(trial.start(Drive))
        return client.get_parameter(name) if name in client.list_parameters() else None


require_foresight('gains.kp = 1', {
    1: 'ROS 1 would have stored it. To ROS 2 an integer is no double, and it converts nothing'},
    TYPES, name='gains.kp', value=1)
require_foresight('gains/kp = 2.0', {
    2.0: 'Only what was declared exists, and a slash is not a dot',
    0.5: 'A slash is not a dot: that is another name, and nobody declared it'}, NAMES, name='gains/kp', value=2.0)
require_foresight('max_speed_rpm = 900', {
    300: '`dynamic_reconfigure` would have bent it. ROS 2 rejects, and the old value stays',
    900: 'There is a range, and the node sees to it'}, RULES, name='max_speed_rpm', value=900)
require_foresight('ticks = 3000000000', {
    0: 'It is an integer, and there is no range. Only XML-RPC ended at 32 bits'}, TYPES, name='ticks', value=3000000000)
require_foresight("colour = 'green'", {
    'green': 'Nobody declared it, and a stranger cannot'}, STORE, name='colour', value='green')
require_foresight('max_speed_rpm = 200, and then the node is restarted', {
    200: 'There is no server that would have kept it'}, DIES, name='max_speed_rpm', value=200, restart=True)


fill = Exercise('9c', 'Fill five gaps', CHAPTER, NODE_CLASS, node_name='drive', hints=(
    'What ROS 1 calls `~gains/kp` is private to its node. In ROS 2 all parameters are, so the `~` goes, and a dot '
    'takes the place of the slash.',
    'The default decides the type: the node calculates with doubles, so each default has a dot.'))
OLD_NAMES = ('~max_speed_mps', '~gains/kp', 'gains/kp')


def expect_translated(trial: Trial, name: str, value: float) -> None:
    found = trial.client(trial.start()).list_parameters()
    old = [f'`{each}`' for each in found if each in OLD_NAMES]
    expect(name in found, f'a parameter `{name}`',
           f'there is {old[0]}, as ROS 1 writes it' if old else 'the node has none of that name')
    expect_declared(trial, name, values.DOUBLE, value)


@fill.require('`max_speed_mps` is a double, and 0.5 at the start', see=TRANSLATE)
def speed_translated(trial: Trial) -> None:
    expect_translated(trial, 'max_speed_mps', 0.5)


@fill.require('`gains.kp` is a double, and 2.0 at the start', see=NAMES)
def gain_translated(trial: Trial) -> None:
    expect_translated(trial, 'gains.kp', 2.0)


@fill.require('`command(error)` uses the gain that the node has at that moment', see=TRANSLATE)
def commands(trial: Trial) -> None:
    gain_translated(trial)
    drive = trial.start()
    for gain in (2.0, 3.0):
        trial.client(drive).set_parameter('gains.kp', gain).raise_for_reason()
        given = trial.call('`command(0.1)`', drive.command, 0.1)
        expect(given == gain * 0.1, f'`{gain * 0.1!r}` with a gain of {gain}', f'it is `{given!r}`')


EXERCISES = (fill, translate, foresee)
