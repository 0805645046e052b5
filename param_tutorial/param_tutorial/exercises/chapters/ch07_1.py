"""Exercises of chapter 7.1: order the lines of a parameter file, write a parameter file by hand, and foresee what
comes back of a dump."""

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.trial import CORNER, NoStart, NotYet, NoUse, Trial, expect
from param_tutorial.parameters import values

CHAPTER = '07_1_saving'
FORMAT = 'The format'
BACK = 'Load it back'
LOOKS_LIKE = 'Break it: texts that look like something else'
SECOND = 'Break it: the second reader'
NO_FILE = 'Break it: what no file can hold'

# Of the recorder that the learner writes a file for: each default, and the value that it should start with.
GOALS = {
    'version': ('0', '1.10'),
    'mode': ('manual', 'on'),
    'rate_hz': (10.0, 20.0),
    'gains.kp': (1.0, 1.5),
    'channels': (['left'], ['1', '2']),
    'serial_number': ('R-000', '0042'),
}


def recorder(name: str) -> type[Node]:
    """Derive a recorder that declares one of its parameters, so that one mistake does not hide the others."""
    class Recorder(Node):
        def __init__(self) -> None:
            super().__init__('recorder')
            self.declare_parameter(name, GOALS[name][0], ParameterDescriptor(read_only=name == 'serial_number'))

    return Recorder


write = Exercise('7.1a', 'Write a file by hand', CHAPTER, TEXT, hints=(
    'Let a node write it: `ParameterClient(...).dump()` of a node with such values shows the form, and its quotes.',
    'The first line is the full name of the node, with a colon. The second is `ros__parameters:`, two blanks further '
    'in, and the parameters stand another two blanks further in. A dot in a name makes a level more.',
    'To rcl `1.10` and `0042` are numbers and `on` is true: such texts need quotes. The double wants its dot.'))


def require_value(name: str, because: str, see: str) -> None:
    """Add the requirement that the recorder starts with a value."""
    goal = GOALS[name][1]

    @write.require(f'`{name}` starts as the {values.type_of(goal).label} `{goal!r}`', see=see)
    def starts(trial: Trial) -> None:
        if not trial.work.strip():
            raise NoUse('the text of a parameter file', 'there is nothing in it yet')
        try:
            node = trial.start_with_files(recorder(name), {'recorder.yaml': trial.work},
                                          '--params-file', 'recorder.yaml', namespace='/lab')
        except NoStart as error:  # the others may be better
            raise NotYet(error.expected, f'{error.happened}. {because}') from None
        found = trial.client(node).get_parameter(name)
        expect(values.same(found, goal), f'`{goal!r}`', f'it is `{found!r}`' + (
            ', the default: the file does not reach it' if values.same(found, GOALS[name][0]) else f'. {because}'))


require_value('version', 'A text that looks like a number needs quotes', LOOKS_LIKE)
require_value('mode', 'To rcl this word is a boolean, unless it stands in quotes', LOOKS_LIKE)
require_value('rate_hz', 'A double wants its dot, in a file too', FORMAT)
require_value('gains.kp', 'A double wants its dot, in a file too', FORMAT)
require_value('channels', 'Each element that looks like a number needs quotes of its own', FORMAT)
require_value('serial_number', 'A text that looks like a number needs quotes', BACK)


def holder(name: str, **declared: object) -> type[Node]:
    """Derive a node that declares parameters with defaults, or, without any, takes whatever it is started with."""
    class Holder(Node):
        def __init__(self) -> None:
            super().__init__(name, automatically_declare_parameters_from_overrides=not declared)
            for parameter, default in declared.items():
                self.declare_parameter(parameter, default)

    return Holder


def start_value(text: str) -> object:
    """Return the default of the same type."""
    return ['dock'] if text == '[]' else 'old'


def dumped(trial: Trial, text: str) -> str:
    """Let a node hold a value, and ``ros2 param dump`` write its file."""
    node = trial.start(holder('trip', value=start_value(text)))
    trial.client(node).set_parameter('value', [] if text == '[]' else text).raise_for_reason()
    return trial.ros2('param', 'dump', f'{CORNER}/trip')


foresee = Exercise('7.1b', 'Predict what comes back', CHAPTER, DICTIONARY, hints=(
    'First: does the command put quotes around it? It does so where YAML 1.1 would see something else in the text. '
    'Then: what does the reader see in what stands there?',
    'For rcl `n` is a boolean and `2e3` a number, and quotes are respected. `load` reads as YAML 1.1 does, twice, and '
    'the quotes are gone after the first time.',
    'Of an empty list rcl makes a parameter that is declared and has no value: `None`. What is rejected leaves the old '
    'value.'))


def require_start(text: str, because: Mapping[object, str], see: str = LOOKS_LIKE) -> None:
    """Add the requirement to know what a node holds that is started with a dump of a value.

    :param text: The value; '[]' stands for the list.
    """
    @foresee.require_prediction(f'{text}: --params-file', see=see, because=because)
    def holds(trial: Trial) -> Any:
        reader = holder('trip', value=['dock']) if text == '[]' else holder('trip')
        node = trial.start_with_files(reader, {'trip.yaml': dumped(trial, text)}, '--params-file', 'trip.yaml')
        return trial.client(node).get_parameter('value')


def require_load(text: str, because: Mapping[object, str], see: str = SECOND) -> None:
    """Add the requirement to know what a node holds after ``ros2 param load`` of a dump of a value; as above."""
    @foresee.require_prediction(f'{text}: load', see=see, because=because)
    def holds(trial: Trial) -> Any:
        file = dumped(trial, text)
        node = trial.start(holder('trip', value=start_value(text)))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, 'trip.yaml')
            path.write_text(file, encoding='utf-8')
            trial.ros2('param', 'load', f'{CORNER}/trip', str(path))
        return trial.client(node).get_parameter('value')


require_start('n', {
    'n': 'The command wrote it without quotes, and rcl has more words for false than YAML 1.1'})
require_load('n', {
    False: 'To this reader it is a text, twice', 'old': 'It was not rejected: to this reader it is a text'})
require_start('no', {
    False: 'The command has put quotes around this one, and rcl respects them'})
require_load('no', {
    'no': 'Quotes do not survive the first of its two readings', False: 'A boolean is rejected where a text is wanted'})
require_start('2e3', {
    '2e3': 'Without a dot it is no number to YAML 1.1, so no quotes were put, and rcl sees one',
    2000: 'It is a double'})
require_load('2e3', {
    'old': 'It was not rejected: YAML 1.1 wants a dot in a number', 2000.0: 'YAML 1.1 wants a dot in a number'})
require_start('[]', {
    (): 'rcl cannot tell the type of a list without elements', ('dock',): 'The default has been taken away'}, NO_FILE)
require_load('[]', {
    (): 'An empty list is a boolean array to this reader, and the node wants texts',
    None: 'Nothing is taken away here: what is rejected leaves the old value'}, NO_FILE)


order = Exercise('7.1c', 'Put a file in order', CHAPTER, TEXT, hints=(
    'The indentation is right: each line belongs to the nearest line above it that stands further left.',
    'The node stands at the left, below it `ros__parameters:`, and below that the parameters. A dot in a name makes a '
    'level more: `color.red` is `red` below `color`.'))


class Lamp(Node):
    """The lamp that the file is for."""

    def __init__(self) -> None:
        super().__init__('lamp')
        self.declare_parameters('', [('brightness_percent', 100), ('color.red', 1.0)])


def require_lamp(name: str, value: object) -> None:
    """Add the requirement that the lamp starts with a value."""
    @order.require(f'the lamp starts with `{name}` of `{value!r}`', see=FORMAT)
    def starts(trial: Trial) -> None:
        if not trial.work.strip():
            raise NoUse('the text of a parameter file', 'there is nothing in it')
        lamp = trial.start_with_files(Lamp, {'lamp.yaml': trial.work}, '--params-file', 'lamp.yaml')
        found = trial.client(lamp).get_parameter(name)
        expect(values.same(found, value), f'`{value!r}`', f'it is `{found!r}`' + (
            ', the default: the file has no value for it' if found in (100, 1.0) else ''))


require_lamp('brightness_percent', 60)
require_lamp('color.red', 0.5)


EXERCISES = (order, write, foresee)
