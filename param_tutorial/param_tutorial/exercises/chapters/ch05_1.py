"""Exercises of chapter 5.1: what a reader types into a terminal is judged by what the nodes hold afterward; and a
parameter file that is read in two ways."""

import tempfile
from collections.abc import Callable
from pathlib import Path

from rclpy.node import Node

from param_tools import values
from param_tutorial.exercises import steps
from param_tutorial.exercises.exercise import TEXT, Exercise, Kind
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, expect
from param_tutorial.learner.package_files import NAME, ours
from param_tutorial.package.following import FollowedPackage

CHAPTER = '05_1_from_the_command_line'
LOOK = 'Look, then change'
SPELLING = 'Which type did you mean?'
REJECTIONS = 'Rejections and typos'
FILES = 'Values from a file'

# Not its files alone: what is judged is on the stage.
PACKAGE = steps.PACKAGE._replace(fits=lambda work: isinstance(work, FollowedPackage), open=lambda work: work)
NODE = Kind('a node, as `ros.add(...)` has returned it', lambda work: isinstance(work, Node), 'my_node')


def driver_of(package: FollowedPackage) -> Node:
    """Return the driver that is on the stage now.

    :raises NoUse: there is none.
    """
    driver = package.node()
    if driver is None:
        raise NoUse('your driver on the stage', 'there is none: `package.need()` puts it back')
    return driver


def base_of(package: FollowedPackage) -> Node:
    """Return the base of the robot."""
    return package.base


def itself(node: Node) -> Node:
    """Return the node: for work that is one."""
    return node


def require_value(exercise: Exercise, node_of: Callable[..., Node], name: str, goal: object, see: str,
                  because: str) -> None:
    """Add the requirement that a node on the stage holds a value.

    :param node_of: Returns the node, for the work.
    :param because: What to think of as long as it holds another one.
    """
    label = values.type_of(goal).label

    @exercise.require(f'`{name}` is the {label} `{goal!r}`', see=see)
    def holds(trial: Trial) -> None:
        found = trial.client(node_of(trial.work)).get_parameter(name)
        expect(values.same(found, goal), f'`{name}` is `{goal!r}`', f'it is `{found!r}`. {because}')


change = Exercise('5.1a', 'Faster, and farther from the wall', CHAPTER, PACKAGE, hints=(
    'Three parameters are to be changed, and one of them is the base’s. `%ros2 param list` shows which node has which.',
    'A line has the form `%ros2 param set NODE NAME VALUE`. The node begins with a slash.',
    'All three parameters are doubles, so each value needs a dot: `20.0`, and not `20`.'))
UNSET = 'Has a line set it, and has the node said `successful`?'
require_value(change, base_of, 'wall_m', 20.0, LOOK, UNSET)
require_value(change, driver_of, 'max_speed_mps', 1.2, LOOK, UNSET)
require_value(change, driver_of, 'stop_distance_m', 2.0, LOOK, UNSET)


spell = Exercise('5.1b', 'Spell five values', CHAPTER, NODE, hints=(
    'Begin with the type: a double needs a dot, an integer must not have one, and a string that looks like something '
    'else needs quotes.',
    'The shell takes one pair of quotes away, and YAML reads what is left. So a string may need two pairs, as in '
    '`"\'42\'"`.',
    'In YAML 1.1, a number with an exponent needs a dot and a sign: `1.0e-3`. All elements of a list need the same '
    'type, and quotes around the whole list keep it together.'))
for each in (
        ('retries', 10, 'An integer is written with digits only, and without a zero in front'),
        ('tolerance_m', 0.001, 'A double needs a dot, and with an exponent also a sign'),
        ('label', '42', 'A string that looks like a number needs two pairs of quotes, one for the shell and one for '
         'YAML'),
        ('mode', 'off', 'To YAML 1.1 this word means false, unless two pairs of quotes make it a string'),
        ('weights', [1.0, 2.5], 'A list has brackets, all its elements need the same type, and quotes keep it '
         'together')):
    require_value(spell, itself, each[0], each[1], SPELLING, each[2])


fix = Exercise('5.1c', 'Four lines that fail', CHAPTER, PACKAGE, hints=(
    'Each line gets an answer of its own. Which of them come from a node, and which one from the command?',
    '`%ros2 param list` shows how nodes and parameters are spelled. What arrived has the type that YAML sees in the '
    'word.',
    '`%ros2 param describe /base wall_m` shows how far away the wall can be.'))
require_value(fix, driver_of, 'max_speed_mps', 1.0, REJECTIONS, 'Is its name spelled as the driver spells it?')
require_value(fix, driver_of, 'stop_distance_m', 1.5, REJECTIONS, 'Which type, or which limit, did the rejection name?')
require_value(fix, base_of, 'wall_m', 50.0, REJECTIONS, 'A rejection names both ends of the range, or both types')
require_value(fix, base_of, 'command_timeout_sec', 1.0, REJECTIONS,
              'Is the node spelled as `node list` spells it, and the value as a double?')


file = Exercise('5.1d', 'A file for both', CHAPTER, TEXT, hints=(
    'Both parameters are doubles. What does each way make of a word in quotes, and what of a word without a dot?',
    '`ros2 param load` looks into quotes, and rcl does not. Neither adds a dot.'))
GOALS = {'max_speed_mps': 1.0, 'stop_distance_m': 2.0}
_NAME = 'driver.yaml'


def driver_class() -> type[Node]:
    """Return a driver of ours that has both parameters.

    It is not loaded as the reader's are: what goes wrong in it must not quote a line that the reader has not written.
    """
    space: dict[str, type[Node]] = {}
    exec(ours('4b')[f'{NAME}/driver_node.py'], space)
    return space['Driver']


@file.require('`ros2 param load` sets both values in a running driver', see=FILES)
def is_loaded(trial: Trial) -> None:
    driver = trial.start(driver_class())
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, _NAME)
        path.write_text(trial.work, encoding='utf-8')
        said = trial.ros2('param', 'load', f'{CORNER}/driver', str(path)).replace(str(path), _NAME)
    _expect_goals(trial, driver, said)


@file.require('a driver that is started with the file has both values', see=FILES)
def is_read_at_start(trial: Trial) -> None:
    driver = trial.start_with_files(driver_class(), {_NAME: trial.work}, '--params-file', _NAME)
    _expect_goals(trial, driver, 'the file has another value for it, or is for another node')


def _expect_goals(trial: Trial, driver: Node, said: str) -> None:
    for name, goal in GOALS.items():
        found = trial.client(driver).get_parameter(name)
        if not values.same(found, goal):
            lines = said.splitlines()
            about = [line for line in lines if name in line] or [line for line in lines if 'failed' in line] or lines
            raise NotYet(f'`{name}` is `{goal!r}`', f'it is `{found!r}`; {" ".join(map(str.strip, about))}')


EXERCISES = (change, spell, fix, file)
