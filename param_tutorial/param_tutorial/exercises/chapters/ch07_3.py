"""Exercises of chapter 7.3: order sources, predict which value wins, and write a file that reaches the right nodes."""

import contextlib
from collections.abc import Mapping
from typing import Any

from rclpy.node import Node

from param_tutorial.exercises.exercise import DICTIONARY, LIST, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_text
from param_tutorial.exercises.trial import NoStart, NotTried, NotYet, NoUse, Trial, expect, take_for_granted

CHAPTER = '07_3_overrides'
TWO = 'Two sources'
THREE = 'Break it: three sources'
REACHES = 'Which nodes does a file reach?'

# The files of 7.3b, which the chapter writes into its scratch folder.
FILES = {
    'mixed.yaml': """
/robot:
  ros__parameters: {speed: 200}
/**:
  ros__parameters: {speed: 300}
""",
    'every.yaml': '/**: {ros__parameters: {speed: 350}}',
    'any.yaml': '/**/robot: {ros__parameters: {speed: 250}}',
    'lab.yaml': '/lab/**: {ros__parameters: {speed: 150}}',
}


class Robot(Node):
    """The robot of the chapter."""

    def __init__(self) -> None:
        super().__init__('robot')
        self.declare_parameter('speed', 100)


predict = Exercise('7.3b', 'Predict the winner', CHAPTER, DICTIONARY, hints=(
    'Take a sheet of paper. Write down the blocks in the order in which their names first appear, with the value of '
    'each. Then find the last one that matches.',
    '`mixed.yaml` opens two blocks. A `-p` without a node name goes into the block `/**`, wherever that is.',
    'A block that is already open keeps its place and gets the new value. The robot is `/robot`.'))


def require_foresight(sources: str, because: Mapping[object, str], see: str = THREE) -> None:
    """Add the requirement to know the robot's speed after a start.

    :param sources: Names of files, or '-p 400', in their order.
    """
    words = [word for source in sources.split(', ') for word in (
        ('--params-file', source) if source in FILES else ('-p', source.replace('-p ', 'speed:=')))]

    @predict.require_prediction(sources, see=see, because=because)
    def speed(trial: Trial) -> Any:
        return trial.start_with_files(Robot, FILES, *words).get_parameter('speed').value


require_foresight('mixed.yaml', {
    200: 'The later block wins, not the more specific name', 100: 'Both blocks match the robot'})
require_foresight('mixed.yaml, -p 400', {
    300: '`-p` changes the block that is the last one here', 200: 'Which block is opened last?'})
require_foresight('-p 400, mixed.yaml', {
    300: 'Which block was opened first: that of `-p`, or that of `/robot`?',
    400: 'The file gives the block of `-p` another value'})
require_foresight('every.yaml, mixed.yaml', {
    300: 'The first file has already opened that block', 350: 'The second file changes this value'})
require_foresight('mixed.yaml, any.yaml', {
    300: 'Which block comes after this one?', 200: 'The more specific name does not win'}, REACHES)
require_foresight('any.yaml, mixed.yaml, -p 400', {
    250: 'Two more blocks are opened after this one', 300: '`-p` gives this block another value',
    200: 'Which block is opened last?'})
require_foresight('every.yaml, any.yaml, -p 400', {
    400: '`-p` goes into the first block', 350: '`any.yaml` matches the robot too'})
require_foresight('lab.yaml', {
    150: 'The robot is `/robot`: it is not in the laboratory'}, REACHES)


class Gripper(Node):
    """A gripper, or a neighbor of one under another name."""

    def __init__(self) -> None:
        super().__init__('gripper')
        self.declare_parameters('', [('force_n', 5.0), ('speed_mmps', 10)])


reach = Exercise('7.3c', 'Two of five', CHAPTER, TEXT, hints=(
    'Begin with one block, for `/lab/left/gripper` alone. Then put a wildcard where the two names differ.',
    '`*` stands for one name, `**` for any number of names. A double needs its dot, in a file too.',
    'Two blocks: `/lab/*/gripper` with both values, and below it `/lab/right/gripper` with its own force. In each, the '
    'second line is `ros__parameters:`.'))


def expect_holds(trial: Trial, place: str, name: str, force_n: float, speed_mmps: int) -> None:
    """Expect a node that starts with the learner's file to have these values."""
    wanted = {'force_n': force_n, 'speed_mmps': speed_mmps}
    found = held(trial, place, name)
    expect(found == wanted, _format_values(wanted), _format_values(found))


def held(trial: Trial, place: str, name: str) -> dict[str, object]:
    """Return the values of a node that starts with the learner's file."""
    node = trial.start_with_files(Gripper, {'lab.yaml': trial.work}, '--params-file', 'lab.yaml',
                                  '-r', f'__node:={name}', namespace=place)
    return dict(trial.client(node).get_parameters(['force_n', 'speed_mmps']))


def _format_values(held: Mapping[str, object]) -> str:
    return ', '.join(f'`{name}` is `{value!r}`' for name, value in held.items())


@reach.require('rcl can read the file', see=REACHES)
def is_read(trial: Trial) -> None:
    expect_text(trial)
    with contextlib.suppress(NoStart):  # what a value does to a node is another requirement
        trial.start_with_files(Gripper, {'lab.yaml': trial.work}, '--params-file', 'lab.yaml')


@reach.require('`/lab/left/gripper` starts with 12.0 N and 40 mm/s', see=REACHES)
def left(trial: Trial) -> None:
    expect_holds(trial, '/lab/left', 'gripper', 12.0, 40)


@reach.require('`/lab/right/gripper` starts with 20.0 N and 40 mm/s', see=THREE)
def right(trial: Trial) -> None:
    if held(trial, '/lab/right', 'gripper')['force_n'] == 20.0:
        # Its speed is then that of the left one, or a mistake of its own.
        take_for_granted(trial, same_speed_on_the_left)
    expect_holds(trial, '/lab/right', 'gripper', 20.0, 40)


def same_speed_on_the_left(trial: Trial) -> None:
    """Expect the speed of the left gripper to be right, unless the right one has another."""
    left_one, right_one = (held(trial, place, 'gripper')['speed_mmps'] for place in ('/lab/left', '/lab/right'))
    expect(left_one != right_one or left_one == 40, '', '')


def expect_a_gripper(trial: Trial) -> None:
    """Expect the file to reach a gripper in the laboratory: one that reaches nobody leaves others alone, too.

    :raises NotTried: it reaches neither.
    """
    for each in (left, right):
        with contextlib.suppress(NotYet):
            each(trial)
            return
    raise NotTried


@reach.require('`/lab/right/camera_arm` keeps its defaults', see=REACHES)
def arm(trial: Trial) -> None:
    expect_a_gripper(trial)
    expect_holds(trial, '/lab/right', 'camera_arm', 5.0, 10)


@reach.require('`/gripper` and `/store/left/gripper` keep theirs', see=REACHES)
def spare(trial: Trial) -> None:
    expect_a_gripper(trial)
    for place in ('', '/store/left'):
        expect_holds(trial, place, 'gripper', 5.0, 10)


order = Exercise('7.3a', 'Put three sources in order', CHAPTER, LIST, hints=(
    'Both files write into the block `/robot`. Within a block the later value wins.',
    'A `-p` without a node name goes into the block `/**`. It wins if this block is opened after `/robot`.'))

# The sources of this exercise: both files name the robot.
SOURCES = {
    'slow.yaml': "/robot: {ros__parameters: {speed: 80, label: 'slow'}}",
    'fast.yaml': "/robot: {ros__parameters: {speed: 300, label: 'fast'}}",
}
WORDS = ('-p speed:=400', '--params-file slow.yaml', '--params-file fast.yaml')


class Labeled(Robot):
    """The robot, with a label."""

    def __init__(self) -> None:
        super().__init__()
        self.declare_parameter('label', 'none')


def labeled(trial: Trial) -> Labeled:
    """Start the robot with the learner's sources.

    :raises NoUse: they are not the three of the exercise.
    """
    words = [' '.join(word.split()) for word in trial.work if isinstance(word, str)]
    if sorted(words) != sorted(WORDS) or len(words) != len(trial.work):
        raise NoUse('the three sources, each of them once and unchanged', f'the list is `{trial.work!r}`')
    return trial.start_with_files(Labeled, SOURCES, *(each for word in words for each in word.split()))


@order.require('the robot starts with 400', see=TWO)
def wins(trial: Trial) -> None:
    found = labeled(trial).get_parameter('speed').value
    expect(found == 400, '`speed` is `400`', f'it is `{found!r}`. Which block is opened last?')


@order.require("its label is `'slow'`", see=TWO)
def is_slow(trial: Trial) -> None:
    found = labeled(trial).get_parameter('label').value
    expect(found == 'slow', "`label` is `'slow'`", f'it is `{found!r}`. Both files write into the same block')


EXERCISES = (order, predict, reach)
