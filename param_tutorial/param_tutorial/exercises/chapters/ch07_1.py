"""Exercises of chapter 7.1: write a small parameter file and a longer one by hand, and predict what comes back from a
dump."""

import re
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools import values
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_text
from param_tutorial.exercises.trial import CORNER, NoStart, NotYet, NoUse, Trial, expect

CHAPTER = '07_1_saving'
FORMAT = 'The format'
BACK = 'Load it back'
LOOKS_LIKE = 'Break it: strings that look like something else'
SECOND = 'Break it: the second reader'
NO_FILE = 'Break it: what no file can hold'


def expect_block(trial: Trial, full_name: str) -> None:
    """Expect the learner's file to hold something for a node.

    :raises NoUse: it holds nothing for it, so nothing that follows would say more.
    """
    expect_text(trial)
    namespace, _, name = full_name.rpartition('/')

    class Finder(Node):
        def __init__(self) -> None:
            super().__init__(name, automatically_declare_parameters_from_overrides=True)

    try:
        finder = trial.start_with_files(Finder, {'work.yaml': trial.work}, '--params-file', 'work.yaml',
                                        namespace=namespace)
    except NoStart:  # an empty array, for example: something has been found
        return
    # Two that every node has.
    if not set(trial.client(finder).list_parameters()) - {'use_sim_time', 'start_type_description_service'}:
        raise NoUse(f'a block for `{full_name}`', 'the file has nothing for this node. Whom does its key name?')


# Of the recorder that the learner writes a file for: each default, and the value that it should start with.
GOALS = {
    'version': ('0', '1.10'),
    'mode': ('manual', 'on'),
    'rate_hz': (10.0, 20.0),
    'gains.kp': (1.0, 1.5),
    'channels': (['left'], ['1', '2']),
    'serial_number': ('R-000', '0042'),
}
# What a value of the wrong type comes from, by the type that the recorder wants and the one that rcl has found.
CAUSES = {
    ('STRING', 'BOOL'): 'To rcl this word is a boolean, unless it is in quotes',
    ('STRING', 'INTEGER'): 'A string that looks like a number needs quotes',
    ('STRING', 'DOUBLE'): 'A string that looks like a number needs quotes',
    ('DOUBLE', 'INTEGER'): 'A double needs its dot, in a file too',
    ('DOUBLE', 'STRING'): 'In quotes it is a string',
    ('STRING_ARRAY', 'INTEGER_ARRAY'): 'Each element that looks like a number needs quotes of its own',
    ('STRING_ARRAY', 'STRING'): 'This is one string. A list has brackets, or a dash before each element',
}


def recorder(name: str) -> type[Node]:
    """Derive a recorder that declares one of its parameters, so that one mistake does not hide the others."""
    class Recorder(Node):
        def __init__(self) -> None:
            super().__init__('recorder')
            self.declare_parameter(name, GOALS[name][0], ParameterDescriptor(read_only=name == 'serial_number'))

    return Recorder


write = Exercise('7.1b', 'Write a file by hand', CHAPTER, TEXT, hints=(
    'Let a node write it: `ParameterClient(...).dump()` of a node with values like these shows you the form and the '
    'quotes.',
    'The key is the fully qualified name of the node, with a colon. The second line is `ros__parameters:`, '
    'indented by two spaces, and the parameters are indented by four. A dot in a name adds a level.',
    'To rcl, `1.10` and `0042` are numbers and `on` is true, so these strings need quotes. The double needs its dot.'))


@write.require('rcl can read the file, and it is for `/lab/recorder`', see=FORMAT)
def reaches_recorder(trial: Trial) -> None:
    expect_block(trial, '/lab/recorder')


def require_value(name: str, see: str) -> None:
    """Add the requirement that the recorder starts with a value."""
    default, goal = GOALS[name]

    @write.require(f'`{name}` starts as the {values.type_of(goal).label} `{goal!r}`', see=see)
    def starts(trial: Trial) -> None:
        try:
            node = trial.start_with_files(recorder(name), {'recorder.yaml': trial.work},
                                          '--params-file', 'recorder.yaml', namespace='/lab')
        except NoStart as error:  # the other values may be right
            types = re.search(r"of type '(\w+)', expecting type '(\w+)'", error.happened)
            cause = CAUSES.get((types[2], types[1]), '') if types else ''
            raise NotYet(error.expected, error.happened + (f'. {cause}' if cause else '')) from None
        found = trial.client(node).get_parameter(name)
        expect(values.same(found, goal), f'`{goal!r}`', 'it has no value' if found is None else f'it is `{found!r}`' + (
            f', the default: the file has no `{name}`' if values.same(found, default) else ''))


require_value('version', LOOKS_LIKE)
require_value('mode', LOOKS_LIKE)
require_value('rate_hz', FORMAT)
require_value('gains.kp', FORMAT)
require_value('channels', FORMAT)
require_value('serial_number', BACK)


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


foresee = Exercise('7.1c', 'Predict what comes back', CHAPTER, DICTIONARY, hints=(
    'Does the command put quotes around the string? It does if PyYAML would take it for something else. Then ask '
    'what the reader makes of what is written there.',
    'To rcl, `n` is a boolean and `2e3` is a number, and a string in quotes stays a string. `load` reads by the rules '
    'of PyYAML, twice, and the first reading removes the quotes.',
    'rcl turns an empty array into a parameter that is declared and has no value: `None`. If a node rejects a value, '
    'the old one stays.'))


def require_start(text: str, because: Mapping[object, str], see: str = LOOKS_LIKE) -> None:
    """Add the requirement to know what a node holds that is started with a dump of a value.

    :param text: The value; '[]' stands for the array.
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


EXPONENT = 'In YAML 1.1 an exponent needs a dot and a sign, so this is a string'

require_start('n', {
    'n': 'The command wrote it without quotes, and rcl has more words for false than PyYAML has'})
require_load('n', {
    False: 'To this reader it is a string, both times', 'old': 'The node accepts it: to this reader it is a string'})
require_start('no', {
    False: 'The command puts quotes around this one, and rcl respects them'})
require_load('no', {
    'no': 'Quotes do not survive the first of the two readings', False: 'The node rejects a boolean'})
require_start('2e3', {
    '2e3': f'{EXPONENT}, and the command writes no quotes. rcl takes it for a number', 2000: 'It is a double'})
require_load('2e3', {'old': f'The node accepts it. {EXPONENT}', 2000.0: EXPONENT})
require_start('[]', {
    (): 'rcl cannot tell the type of an array without elements', ('dock',): 'The file takes the default away'}, NO_FILE)
require_load('[]', {
    (): 'To this reader an empty array is one of booleans, and the node wants strings',
    None: 'What the node rejects takes nothing away'}, NO_FILE)


light = Exercise('7.1a', 'Write a file for a lamp', CHAPTER, TEXT, hints=(
    'Four levels: each line belongs to the nearest line above it that is indented less.',
    'The node is at the left margin, below it `ros__parameters`, and below that the parameters. A dot in a name adds a '
    'level: `color.red` is `red` below `color`.'))
LAMP: dict[str, tuple[Any, Any]] = {'brightness_percent': (100, 60), 'color.red': (1.0, 0.5)}


def lamp(*names: str) -> type[Node]:
    """Derive the lamp that the file is for, with some of its parameters."""
    class Lamp(Node):
        def __init__(self) -> None:
            super().__init__('lamp')
            for name in names:
                self.declare_parameter(name, LAMP[name][0])

    return Lamp


@light.require('rcl can read the file, and it is for `/lamp`', see=FORMAT)
def reaches_lamp(trial: Trial) -> None:
    expect_block(trial, '/lamp')


def require_lamp(name: str) -> None:
    """Add the requirement that the lamp starts with a value."""
    default, value = LAMP[name]

    @light.require(f'the lamp starts with a `{name}` of `{value!r}`', see=FORMAT)
    def starts(trial: Trial) -> None:
        try:
            node = trial.start_with_files(lamp(name), {'lamp.yaml': trial.work}, '--params-file', 'lamp.yaml')
        except NoStart as error:  # the other value may be right
            raise NotYet(error.expected, error.happened) from None
        found = trial.client(node).get_parameter(name)
        expect(values.same(found, value), f'`{value!r}`', f'it is `{found!r}`' + (
            f', the default: the file has no `{name}`' if values.same(found, default) else ''))


for each in LAMP:
    require_lamp(each)


EXERCISES = (light, write, foresee)
