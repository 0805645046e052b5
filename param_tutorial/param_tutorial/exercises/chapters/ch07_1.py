"""Exercises of chapter 7.1: the reader's parameter file and its installation, and a dump with five traps."""

import re
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.files import parameter_files
from param_tutorial.exercises.exercise import TEXT, Exercise
from param_tutorial.exercises.steps import PACKAGE, class_of, expect_installed, installed_files
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect
from param_tutorial.learner.package_files import NAME, PackageFiles, our_copy

CHAPTER = '07_1_saving'
FORMAT = 'The format'
BACK = 'Load it back'
LOOKS_LIKE = 'Break it: strings that look like something else'
NO_FILE = 'Break it: what no file can hold'
FILE = 'config/my_robot.yaml'
OF_EVERY_NODE = {'use_sim_time', 'start_type_description_service'}


def expect_block(trial: Trial, text: str, full_name: str) -> None:
    """Expect a parameter file to hold something for a node.

    :raises NoUse: it holds nothing for it, so nothing that follows would say more.
    """
    if not text.strip():
        raise NoUse('the text of a parameter file', 'there is nothing in it yet')

    class Finder(Node):
        def __init__(self) -> None:
            super().__init__(full_name.strip('/'), automatically_declare_parameters_from_overrides=True)

    try:
        finder = trial.start_with_files(Finder, {'work.yaml': text}, '--params-file', 'work.yaml')
    except NoStart:  # an empty array, for example: something has been found
        return
    if not set(trial.client(finder).list_parameters()) - OF_EVERY_NODE:
        raise NoUse(f'a block for `{full_name}`', 'the file has nothing for this node. Whom does its key name?')


# What a value of the wrong type comes from, by the type that a node wants and the one that rcl has found.
CAUSES = {
    ('STRING', 'BOOL'): 'To rcl this word is a boolean, unless it is in quotes',
    ('STRING', 'INTEGER'): 'A string that looks like a number needs quotes',
    ('STRING', 'DOUBLE'): 'A string that looks like a number needs quotes',
    ('DOUBLE', 'INTEGER'): 'A double needs its dot, in a file too',
    ('DOUBLE', 'STRING'): 'To rcl it is a string: a number has a dot, and neither a comma nor quotes',
    ('INTEGER', 'DOUBLE'): 'An integer has no dot',
    ('STRING_ARRAY', 'DOUBLE_ARRAY'): 'Each element that looks like a number needs quotes of its own',
    ('STRING_ARRAY', 'STRING'): 'This is one string. A list has brackets, or a dash before each element',
    ('BYTE_ARRAY', 'STRING_ARRAY'): 'A file has no notation for bytes',
}


def start(trial: Trial, node_class: type[Node], text: str) -> Node:
    """Start a node with a parameter file.

    :raises NotYet: it does not start; with what the type of a value comes from.
    """
    try:
        return trial.start_with_files(node_class, {'work.yaml': text}, '--params-file', 'work.yaml')
    except NoStart as error:
        found = re.search(r"of type '(\w+)', expecting type '(\w+)'", error.happened)
        cause = CAUSES.get((found[2], found[1]), '') if found else ''
        raise NotYet(error.expected, error.happened + (f'. {cause}' if cause else '')) from None


# -- 7.1a: the reader's file -----------------------------------------------------------------------------------------

TUNED = {'max_speed_mps': 0.8, 'stop_distance_m': 0.6, 'braking_mps2': 0.8}
RATE_HZ = 20

own = Exercise('7.1a', 'A file for your robot', CHAPTER, PACKAGE, hints=(
    'Begin with the text of the dump. It has the name of your driver, and the values that you have set.',
    'Two lines are about parameters of every rclpy node, `start_type_description_service` and `use_sim_time`. Take '
    'them out.',
    'The value of `rate_hz` is typed in, not tuned: `rate_hz: 20`, without a dot.'))


def text_of(trial: Trial) -> str:
    """Return what is in the reader's parameter file.

    :raises NoUse: there is none.
    """
    files: PackageFiles = trial.work
    if not files.path(FILE).exists():
        raise NoUse(f'a file `{FILE}` in your package', 'there is none')
    return files.text(FILE)


def driver(trial: Trial) -> Node:
    """Start a driver with the reader's file: ours, in which nothing but the file can be wrong.

    :raises NoUse: it does not start.
    """
    try:
        return start(trial, class_of(our_copy('6.2a') / NAME / 'driver_node.py'), text_of(trial))
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None


@own.require(f'rcl can read `{FILE}`, and it is for `/driver`', see=FORMAT)
def reaches_driver(trial: Trial) -> None:
    expect_block(trial, text_of(trial), '/driver')


@own.require('the driver starts with the three values that were tuned', see=FORMAT)
def is_tuned(trial: Trial) -> None:
    node = driver(trial)
    for name, value in TUNED.items():
        found = node.get_parameter(name).value
        expect(found == value, f'`{name} = {value}`', f'it is `{found}`')


@own.require(f'it starts with a `rate_hz` of {RATE_HZ}', see=FORMAT)
def has_rate(trial: Trial) -> None:
    found = driver(trial).get_parameter('rate_hz').value
    expect(found == RATE_HZ, f'`rate_hz = {RATE_HZ}`', f'it is `{found}`')


@own.require('the file holds these four, and nothing else', see=FORMAT)
def holds_no_more(trial: Trial) -> None:
    text_of(trial)
    more = sorted(set(parameter_files.read(trial.work.path(FILE), '/driver')) - {*TUNED, 'rate_hz'})
    expect(not more, 'no more than the parameters of your driver', 'there is also '
           + ', '.join(f'`{each}`' for each in more))


# -- 7.1b: its installation ------------------------------------------------------------------------------------------

SHARE = f'share/{NAME}'

installed = Exercise('7.1b', 'The package takes it along', CHAPTER, PACKAGE, hints=(
    f"`data_files` has two pairs so far. Yours is the third: the folder, `'{SHARE}/config'`, and a list with one path.",
    'The path begins in the folder of `setup.py`, and each pair ends with a comma: '
    f"`('share/' + package_name + '/config', ['{FILE}']),`."))


@installed.require('`setup.py` runs, and a build finds each file that it names', see=BACK)
def is_found(trial: Trial) -> None:
    installed_files(trial, trial.work.root)


@installed.require(f'it installs `{FILE}` in `{SHARE}/config`', see=BACK)
def is_installed(trial: Trial) -> None:
    expect_installed(trial, FILE)


@installed.require('it still installs the marker of the package, and `package.xml`', see=BACK)
def keeps_others(trial: Trial) -> None:
    places = installed_files(trial, trial.work.root)
    for each in (f'share/ament_index/resource_index/packages/{NAME}', f'{SHARE}/package.xml'):
        expect(each in places, f'`{each}`', '`data_files` does not name it any more')


# -- 7.1c: five traps ------------------------------------------------------------------------------------------------

# Of the courier: each default, and the value that it should start with.
GOALS: dict[str, tuple[Any, Any]] = {
    'range_m': (5.0, 12.0),
    'label': ('C-07', '1e5'),
    'side': ('left', 'N'),
    'codes': (['1e1'], ['2e5', '3e5']),
    'stops': (['dock'], ['dock']),
    'firmware': ([b'\x00'], [b'\x00']),
}

courier = Exercise('7.1c', 'Five traps', CHAPTER, TEXT, hints=(
    'Two of the five can be in no file at all: bytes, and an array without elements. Take them out, with all their '
    'lines.',
    'To rcl, `2e5` is a number and `N` is a boolean. A list needs quotes around each element.'))


def declares(name: str) -> type[Node]:
    """Derive a courier that declares one of its parameters, so that one mistake does not hide the others."""
    class Courier(Node):
        def __init__(self) -> None:
            super().__init__('courier')
            self.declare_parameter(name, GOALS[name][0])

    return Courier


@courier.require('rcl can read the file, and it is for `/courier`', see=FORMAT)
def reaches_courier(trial: Trial) -> None:
    expect_block(trial, trial.work, '/courier')


def require_value(name: str, see: str) -> None:
    """Add the requirement that the courier starts with a value."""
    default, goal = GOALS[name]
    is_default = values.same(default, goal)

    @courier.require(f'`{name}` starts as ' + (
        'its default' if is_default else f'the {values.type_of(goal).label} `{goal!r}`'), see=see)
    def starts(trial: Trial) -> None:
        found = trial.client(start(trial, declares(name), trial.work)).get_parameter(name)
        expect(values.same(found, goal), f'`{goal!r}`', 'it has no value' if found is None else f'it is `{found!r}`' + (
            f', the default: the file has no `{name}`' if values.same(found, default) else ''))


for each in GOALS:
    require_value(each, FORMAT if each == 'range_m' else NO_FILE if GOALS[each][0] == GOALS[each][1] else LOOKS_LIKE)


EXERCISES = (own, installed, courier)
