"""Exercises of chapter 9.1: fill in what has become of a node of ROS 1, mend a hasty translation, and translate a
parameter file."""

import math
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import ParameterFileError
from param_tools.files import parameter_files
from param_tutorial.exercises.exercise import NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import (
    expect_declared,
    expect_filled,
    expect_follows,
    expect_left_alone,
    format_found,
)
from param_tutorial.exercises.trial import CORNER, NotTried, NotYet, NoUse, Trial, expect, take_for_granted

CHAPTER = '09_1_moving_from_ros1'
TRANSLATE = 'Build it: translate a node'
TYPES = 'Types'
FILES = 'Files'
NAMES = 'Names'


fill = Exercise('9.1a', 'Fill five gaps', CHAPTER, NODE_CLASS, node_name='drive', hints=(
    'What ROS 1 calls `~gains/kp` is private to its node. In ROS 2 every parameter is, so the `~` goes, and a dot '
    'takes the place of the slash.',
    'The default settles the type: both numbers are doubles, so each default has a dot.',
    'The last gap is the value of the gain, read when `command` needs it: `self.get_parameter(…).value`.'))


def expect_translated(trial: Trial, name: str, value: float) -> None:
    expect_filled(trial)
    found = trial.client(trial.start()).list_parameters()
    slashed = name.replace('.', '/')
    old = [f'`{each}`' for each in (f'~{slashed}', slashed, f'~{name}') if each in found]
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
    plain = trial.client(trial.start())
    if 'gains.kp' not in plain.list_parameters() or plain.describe_parameter('gains.kp').type is not values.DOUBLE:
        raise NotTried
    drive = trial.start(ros_args=['-p', 'gains.kp:=4.0'])
    held = trial.client(drive).get_parameter('gains.kp')
    expect(held == 4.0, '`gains.kp` is `4.0` after a start with `-p gains.kp:=4.0`', f'it is `{held!r}`')
    for gain in (4.0, 3.0, -1.5, 0.0):
        trial.client(drive).set_parameter('gains.kp', gain).raise_for_reason()
        for error in (0.5, -2.0):
            given = trial.call(f'`command({error})`', drive.command, error)
            expect(is_number(given) and math.isclose(given, gain * error),
                   f'`command({error})` is `{gain * error!r}` with a gain of {gain}', f'it is {format_found(given)}')


def is_number(given: object) -> bool:
    return isinstance(given, (int, float)) and not isinstance(given, bool)


FILE = """
/**:
  ros__parameters: {unit: K}
/heater:
  ros__parameters:
    limit_c: 62.5
    targets_c: {left: 19.0, right: 22.5}
"""
ANOTHER_FILE = FILE.replace('K', 'F').replace('62.5', '144.5').replace('19.0', '66.0').replace('22.5', '70.5')

mend = Exercise('9.1b', 'Fix a translation', CHAPTER, NODE_CLASS, node_name='heater', hints=(
    'Four things are as in ROS 1: two types, the slashes in two names, a parameter that nobody declares, and values '
    'that are read once.',
    'A file reaches declared parameters only, and a group has dots. `get_parameters_by_prefix` returns `Parameter` '
    'objects, so take the `.value` of each.',
    'Register a method with `add_post_set_parameters_callback` that reads `limit_c` and `unit` again.'))


@mend.require('`limit_c` is the double 60.0 and `unit` the string `C`, without a file', see=TYPES)
def plain_declared(trial: Trial) -> None:
    expect_declared(trial, 'limit_c', values.DOUBLE, 60.0)
    expect_declared(trial, 'unit', values.STRING, 'C')
    expect_held(trial.start(), limit_c=60.0, unit='C')


@mend.require('`targets_c` is a group of two doubles, and `targets()` returns them', see=NAMES)
def group_declared(trial: Trial) -> None:
    for name, value in (('targets_c.left', 20.5), ('targets_c.right', 21.0)):
        expect_declared(trial, name, values.DOUBLE, value)
    heater = trial.start()
    expect_targets(trial, heater, left=20.5, right=21.0)
    trial.client(heater).set_parameter('targets_c.right', 23.0).raise_for_reason()
    expect_targets(trial, heater, left=20.5, right=23.0)


@mend.require('it starts with the file, and has its values', see=TRANSLATE)
def starts_with_file(trial: Trial) -> None:
    take_for_granted(trial, plain_declared, group_declared)
    for text, left, right in ((FILE, 19.0, 22.5), (ANOTHER_FILE, 66.0, 70.5)):
        heater = trial.start_with_files(trial.work, {'heater.yaml': text}, '--params-file', 'heater.yaml')
        expect_targets(trial, heater, left=left, right=right)
    held_from_file(trial)


def held_from_file(trial: Trial) -> None:
    """Expect the attributes to hold what a file has brought."""
    for text, limit_c, unit in ((FILE, 62.5, 'K'), (ANOTHER_FILE, 144.5, 'F')):
        heater = trial.start_with_files(trial.work, {'heater.yaml': text}, '--params-file', 'heater.yaml')
        expect_held(heater, limit_c=limit_c, unit=unit)


@mend.require('`self.limit_c` and `self.unit` follow what is stored, and only that', see=TRANSLATE)
def follows(trial: Trial) -> None:
    take_for_granted(trial, plain_declared, held_from_file)
    heater = expect_follows(trial, 'limit_c', [({'limit_c': 65.5}, 65.5), ({'unit': 'K'}, 65.5),
                                               ({'unit': 'F', 'limit_c': 70.0}, 70.0)])
    expect_held(heater, unit='F')
    trial.client(heater).set_parameter('unit', 'K').raise_for_reason()
    expect_held(heater, limit_c=70.0, unit='K')
    expect_left_alone(trial, heater, 'limit_c', {'limit_c': 80.0, 'unit': 'C'})
    expect_held(heater, unit='K')


def expect_held(heater: Any, **wanted: object) -> None:
    for name, value in wanted.items():
        found = getattr(heater, name, None)
        expect(values.same(found, value), f'`self.{name}` is `{value!r}`',
               f'it is {format_found(found)}')


def expect_targets(trial: Trial, heater: Any, **wanted: float) -> None:
    given = trial.call('`targets()`', heater.targets)
    if isinstance(given, Mapping) and any(isinstance(each, Parameter) for each in given.values()):
        raise NotYet(f'`targets()` returns `{wanted}`', 'it returns `Parameter` objects and not their values')
    expect(isinstance(given, Mapping) and dict(given) == wanted, f'`targets()` returns `{wanted}`',
           f'it returns `{given!r}`')


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


translate = Exercise('9.1c', 'Translate a file', CHAPTER, TEXT, hints=(
    'A file of ROS 2 has a level more: the node, `ros__parameters`, then its values. A dictionary in it makes names '
    'with dots.',
    'Read each value as rcl does. `1` and `2` are integers where doubles were declared, a list has one type, and `1e5` '
    'is a number unless it stands in quotes.',
    'What belonged to everyone goes into a block `/**:`, with `ros__parameters` below it as well.'))


# What tells whether a node has started with the file, and holds something of its own block.
SIGNS: Mapping[type[Node], Mapping[str, object]] = {
    TranslatedDrive: {'max_speed_mps': 0.5, 'gains.kp': 1.0, 'gains.kd': 0.0},
    TranslatedCamera: {'label': 'none', 'rates_hz': [5.0]}}


def take_for_granted_that_it_starts(trial: Trial, node_class: type[Node], *, is_reached: bool = True) -> None:
    """Raise NotTried unless a node starts with the file; the first requirement for that node says why.

    :param is_reached: True if something of the file's has to reach it.
    """
    try:
        held = trial.client(started(trial, node_class)).get_parameters(SIGNS[node_class])
    except NotYet:
        raise NotTried from None
    if is_reached and all(values.same(held[name], default) for name, default in SIGNS[node_class].items()):
        raise NotTried


def expect_values(trial: Trial, node_class: type[Node], wanted: Mapping[str, Any], because: str = '') -> None:
    """Start a node with the learner's file, and expect it to hold some values.

    :param because: What to think of when it holds others.
    """
    held = trial.client(started(trial, node_class)).get_parameters(wanted)
    for parameter, value in wanted.items():
        expect(values.same(held[parameter], value), f'`{parameter}` is `{value!r}`',
               f'it is `{held[parameter]!r}`' + (f'. {because}' if because else ''))


def started(trial: Trial, node_class: type[Node]) -> Node:
    """Start a node with the learner's file.

    :raises NotYet: the node does not start.
    :raises NoUse: rcl cannot read the file.
    """
    if not trial.work.strip():
        raise NoUse('', 'the file is still empty')
    name = {TranslatedDrive: '/drive', TranslatedCamera: '/camera'}[node_class]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / 'file.yaml'
        file.write_text(trial.work, encoding='utf-8')
        try:
            # In the trial's corner the node has a longer name, for which the file is written anew.
            parameter_files.render(f'{CORNER}{name}', parameter_files.read(file, name)).save(file)
        except ParameterFileError as error:
            raise NoUse(f'a file that rcl reads, with values for `{name}`',
                        str(error).replace(f'{folder}/', '')) from None
        try:
            return trial.start(node_class, ros_args=['--params-file', str(file)])
        except NoUse as error:
            raise NotYet(error.expected, f'{error.happened}. Write each value as the type that was declared: a double '
                                         f'with its dot, a string that looks like a number in quotes') from None


@translate.require('`/drive` starts with it, at a maximum of 1.0 m/s', see=TRANSLATE)
def speed(trial: Trial) -> None:
    expect_values(trial, TranslatedDrive, {'max_speed_mps': 1.0})


@translate.require('`/drive` has the gains 2.0 and 0.1', see=TRANSLATE)
def gains(trial: Trial) -> None:
    take_for_granted_that_it_starts(trial, TranslatedDrive)
    expect_values(trial, TranslatedDrive, {'gains.kp': 2.0, 'gains.kd': 0.1})


@translate.require('`/camera` starts with it, and its label is the string `1e5`', see=FILES)
def label(trial: Trial) -> None:
    expect_values(trial, TranslatedCamera, {'label': '1e5'})


@translate.require('`/camera` has the rates 10.0 and 12.5', see=TYPES)
def rates(trial: Trial) -> None:
    take_for_granted_that_it_starts(trial, TranslatedCamera)
    expect_values(trial, TranslatedCamera, {'rates_hz': [10.0, 12.5]})


@translate.require('both know that `base_frame` is `base_link`', see=TRANSLATE)
def frame(trial: Trial) -> None:
    for node_class in (TranslatedDrive, TranslatedCamera):
        take_for_granted_that_it_starts(trial, node_class, is_reached=False)
        expect_values(trial, node_class, {'base_frame': 'base_link'},
                      'Nothing belongs to everyone any more: the key `/**` gives it to each node')


EXERCISES = (fill, mend, translate)
