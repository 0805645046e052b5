"""Exercises of chapter 7.3: a file and a launch file for every namespace, an order of sources, and a file that does not
reach its robot."""

import contextlib
from collections.abc import Mapping
from typing import Any

from rclpy.node import Node

from param_tools.files.parsing import Parser
from param_tutorial.exercises.exercise import LIST, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_text
from param_tutorial.exercises.steps import CONFIG, PACKAGE, class_of, launch, text_of
from param_tutorial.exercises.trial import CORNER, NotTried, NotYet, NoUse, Trial, expect, take_for_granted
from param_tutorial.learner.package_files import our_copy

CHAPTER = '07_3_overrides'
REACHES = 'Which nodes does a file reach?'
TWO = 'Two sources'
THREE = 'Break it: three sources'
DIAGNOSE = 'A start that goes wrong'


# -- 7.3a: the reader's file and launch file --------------------------------------------------------------------------

move = Exercise('7.3a', 'A file for every namespace', CHAPTER, PACKAGE, hints=(
    'The key of the file is its first line that is no comment. In the table of keys, look for one that reaches the '
    'driver in each namespace, and no node of another name.',
    'The launch file declares `namespace` as it declares `params_file`, with an empty `default_value`. In `Node`, '
    '`namespace=LaunchConfiguration("namespace")` stands beside the name.'))


def given(trial: Trial) -> dict[str, Any]:
    """Return what the reader's parameter file gives."""
    parser = Parser(tolerant=True)
    parser.parse(text_of(trial.work, CONFIG).encode(), CONFIG)
    if not (found := {each.name: each.value for each in parser.assignments}):
        raise NoUse(f'values in `{CONFIG}`', 'there is none')
    return found


def start_driver(trial: Trial, *words: str, namespace: str = '') -> Node:
    """Start the reader's driver with their parameter file, in the corner.

    :param words: Further ones, after the file.
    """
    files = {'config.yaml': text_of(trial.work, CONFIG)}
    return trial.start_with_files(class_of(trial.work.path('driver_node.py')), files,
                                  '--params-file', 'config.yaml', *words, namespace=namespace)


def name_of(node: Node) -> str:
    """Return the full name that a node would have outside of the corner."""
    return str(node.get_fully_qualified_name()).removeprefix(CORNER)


def expect_values(node: Node, values: Mapping[str, Any], because: str) -> None:
    """Expect a node to hold these values."""
    for name, value in values.items():
        found = node.get_parameter_or(name).value
        expect(found == value, f'`{name}` of `{name_of(node)}` is `{value!r}`', f'it is `{found!r}`. {because}')


@move.require(f'`{CONFIG}` reaches your driver in every namespace', see=REACHES)
def reaches(trial: Trial) -> None:
    for namespace in ('', '/left', '/hall/left'):
        expect_values(start_driver(trial, namespace=namespace), given(trial),
                      'That is not what the file says. Does its key match this name?')


@move.require('it reaches no node of another name', see=REACHES)
def is_not_for_all(trial: Trial) -> None:
    take_for_granted(trial, reaches)
    plain = trial.start(class_of(trial.work.path('driver_node.py')))
    expect_values(start_driver(trial, '-r', '__node:=lifter'),
                  {name: plain.get_parameter_or(name).value for name in given(trial)},
                  'That is from the file: its key matches every name')


def launched(trial: Trial, name: str, config: str = '', **arguments: str) -> Node:
    """Start what the reader's launch file starts, with their parameter file, and expect it to have a full name.

    :param config: The text of another file, for the argument ``params_file``.
    """
    found = launch(trial, text_of(trial.work, CONFIG), config or None, **arguments)
    node = found.start(trial)
    words = ''.join(f' {argument}:={value}' for argument, value in arguments.items())
    expect(name_of(node) == name, f'`{name}`' + (f' with `{words.strip()}`' if words else ' without arguments'),
           f'it is `{name_of(node)}`. ' + ('Does `Node` use the argument?' if words else
                                           'What is the default of `namespace`?'))
    return node


@move.require('`ros2 launch my_robot my_robot_launch.py namespace:=left` starts `/left/driver`, with that file',
              see=REACHES)
def launches(trial: Trial) -> None:
    take_for_granted(trial, reaches)
    for namespace in ('left', 'right'):
        expect_values(launched(trial, f'/{namespace}/driver', namespace=namespace), given(trial),
                      'Does the launch file give it the file?')


@move.require('without `namespace` it starts `/driver`, and `params_file` still names another file', see=REACHES)
def launches_as_before(trial: Trial) -> None:
    take_for_granted(trial, launches)
    expect_values(launched(trial, '/driver'), given(trial), 'Does the launch file give it the file?')
    expect_values(launched(trial, '/driver', '/**:\n  ros__parameters:\n    max_speed_mps: 0.3\n'),
                  {'max_speed_mps': 0.3}, 'Is `params_file` still declared, and used?')


# -- 7.3b and 7.3c: with a driver of ours -----------------------------------------------------------------------------

def our_driver(trial: Trial, files: Mapping[str, str], *words: str, namespace: str = '') -> Node:
    """Start the driver as it is after this chapter, in the corner, with parameter files."""
    return trial.start_with_files(class_of(our_copy('7.3a') / 'my_robot' / 'driver_node.py'), files, *words,
                                  namespace=namespace)


order = Exercise('7.3b', 'Put three sources in order', CHAPTER, LIST, hints=(
    'Both files write into the block `/driver`. Within a block the later value wins.',
    'A `-p` without a node name goes into the block `/**`. It wins if this block is opened after `/driver`.'))

SOURCES = {
    'slow.yaml': '/driver: {ros__parameters: {max_speed_mps: 0.4, stop_distance_m: 1.0}}',
    'fast.yaml': '/driver: {ros__parameters: {max_speed_mps: 0.8, stop_distance_m: 0.6}}',
}
WORDS = ('-p max_speed_mps:=0.7', '--params-file slow.yaml', '--params-file fast.yaml')


def value_of(trial: Trial, name: str) -> Any:
    """Start the driver with the reader's sources, and return a value.

    :raises NoUse: they are not the three of the exercise.
    """
    words = [' '.join(word.split()) for word in trial.work if isinstance(word, str)]
    if sorted(words) != sorted(WORDS) or len(words) != len(trial.work):
        raise NoUse('the three sources, each of them once and unchanged', f'the list is `{trial.work!r}`')
    return our_driver(trial, SOURCES, *(each for word in words for each in word.split())).get_parameter(name).value


@order.require('the driver starts with 0.7 m/s', see=TWO)
def wins(trial: Trial) -> None:
    found = value_of(trial, 'max_speed_mps')
    expect(found == 0.7, '`max_speed_mps` is `0.7`', f'it is `{found!r}`. Which block is opened last?')


@order.require('it stops 1.0 m before the wall', see=THREE)
def is_slow(trial: Trial) -> None:
    found = value_of(trial, 'stop_distance_m')
    expect(found == 1.0, '`stop_distance_m` is `1.0`', f'it is `{found!r}`. Both files write into the same block')


repair = Exercise('7.3c', 'The night shift', CHAPTER, TEXT, hints=(
    'Begin with what the driver reports: an integer where a double is declared. Then ask which names there are: `%ros2 '
    'node list`. Which of the three keys in the file match `/left/driver`, and which match `/driver`?',
    '`%ros2 check night.yaml --against /left/driver` names the lines whose values do not arrive. It does not know that '
    'the other robot should keep its defaults.',
    'One block is enough: `/left/driver:`, and below it `ros__parameters:` with all four values.'))
NIGHT = {'max_speed_mps': 0.3, 'stop_distance_m': 1.0, 'braking_mps2': 0.5, 'rate_hz': 20}


def at_night(trial: Trial, namespace: str) -> Node:
    """Start a driver with the reader's file."""
    return our_driver(trial, {'night.yaml': trial.work}, '--params-file', 'night.yaml', namespace=namespace)


@repair.require('`/left/driver` starts with the file', see=DIAGNOSE)
def starts(trial: Trial) -> None:
    expect_text(trial)
    at_night(trial, '/left')


@repair.require('it holds the four values of the night', see=DIAGNOSE)
def holds(trial: Trial) -> None:
    expect_values(at_night(trial, '/left'), NIGHT,
                  'Which keys match `/left/driver`, and what is the parameter called that the driver declares?')


@repair.require('`/driver` keeps its defaults', see=REACHES)
def leaves_alone(trial: Trial) -> None:
    with contextlib.suppress(NotYet):
        left, plain = at_night(trial, '/left'), our_driver(trial, {})
        if all(left.get_parameter(name).value == plain.get_parameter(name).value for name in NIGHT):
            raise NotTried  # a file that reaches nobody leaves others alone, too
    plain = our_driver(trial, {}, namespace='/plain')
    expect_values(at_night(trial, ''), {name: plain.get_parameter(name).value for name in NIGHT},
                  'That is from your file. Which of its keys match `/driver`?')


EXERCISES = (move, order, repair)
