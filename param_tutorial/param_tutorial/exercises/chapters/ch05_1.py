"""Exercises of chapter 5.1: order the words of commands, spell values for the command line, and predict what
becomes of them."""

import re
import shlex
from collections.abc import Mapping
from typing import Any

from rclpy.node import Node

from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, expect
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.parameters import values

CHAPTER = '05_1_from_the_command_line'
SPELLING = 'Break it: which type did you mean?'
REFUSALS = 'Break it: rejections and mistakes'


class Gripper(Node):
    """Waits for what is typed; it holds one value of each type that is easily missed."""

    def __init__(self) -> None:
        super().__init__('gripper')
        self.declare_parameters('', [
            ('speed_mps', 0.25), ('tolerance_m', 0.5), ('retries', 3), ('label', 'none'), ('mode', 'auto'),
            ('weights', [0.5, 0.5])])


def type_in(trial: Trial, node: Node, words: str) -> str:
    """Type ``ros2 param set NODE`` and some words, as in a terminal, and return what it prints."""
    return trial.ros2('param', 'set', f'{CORNER}/{node.get_name()}', *shlex.split(words))


spell = Exercise('5.1a', 'Spell six values', CHAPTER, DICTIONARY, hints=(
    'Ask which type is wanted: a double wants its dot, an integer must not have one, a text that looks like '
    'something else needs quotes.',
    'The shell takes one pair of quotes away and YAML reads what is left: two pairs around a text, as in `"\'42\'"`.',
    'YAML 1.1 wants a dot in a number with an exponent: `1.0e-3`. All elements of a list are of one type.'))

# Parameter, the value it should hold, and what to think of where another one comes out.
GOALS = (
    ('speed_mps', 1.0, 'A double wants its dot'),
    ('tolerance_m', 0.001, 'Without a dot, YAML 1.1 takes a number with an exponent for a text'),
    ('retries', 10, 'An integer must not have a dot, and no zero in front, which would make it octal'),
    ('label', '42', 'A text that looks like a number needs two pairs of quotes, one for the shell and one for YAML'),
    ('mode', 'off', 'To YAML 1.1 this word means false, unless two pairs of quotes make it a text'),
    ('weights', [1.0, 2.5], 'All elements need one type; and where blanks are in it, the list needs quotes around it'),
)


def require_spelling(name: str, goal: object, because: str) -> None:
    """Add the requirement that a word makes a parameter hold a value."""
    label = values.type_of(goal).label

    @spell.require(f'`{name}` becomes the {label} `{goal!r}`', see=SPELLING)
    def arrives(trial: Trial) -> None:
        word = trial.work.get(name)
        expect(isinstance(word, str), 'a text, in quotes, as you would type it', f'there is `{word!r}`')
        expect(word.strip(), '', 'there is nothing to type yet')
        gripper = trial.start(Gripper)
        try:
            answer = type_in(trial, gripper, f'{name} {word}')
        except ValueError as error:
            raise NotYet('words that a shell can take apart', f'`{word}`: {error}') from None
        holds = trial.client(gripper).get_parameter(name)
        expect(values.same(holds, goal), f'`{name}` holds `{goal!r}`',
               f'it holds `{holds!r}`, and the command said: {answer.splitlines()[0]}. {because}')


for each in GOALS:
    require_spelling(*each)


foresee = Exercise('5.1b', 'Predict what the robot holds', CHAPTER, DICTIONARY, hints=(
    'Two questions for each line: what does YAML make of the word, and does the robot take a value of that type?',
    'A robot that rejects keeps the value it has. `%ros2 param describe` shows types and limits.',
    'The table in the section “Break it: which type did you mean?” shows what YAML 1.1 makes of `off` and `12:30`.'))


def require_foresight(words: str, because: Mapping[object, str], see: str = SPELLING) -> None:
    """Add the requirement to know what the robot holds after a command."""
    @foresee.require_prediction(words, see=see, because=because)
    def holds(trial: Trial) -> Any:
        robot = trial.start(SimpleParamNode)
        type_in(trial, robot, words)
        return trial.client(robot).get_parameter(words.split(maxsplit=1)[0])


require_foresight('max_speed_rpm 12:30', {
    100: 'It was not rejected: YAML 1.1 counts in sixties', 12.5: 'A time of day becomes an integer',
    '12:30': 'It would have been rejected as a text; YAML 1.1 reads a number'})
require_foresight('enable_safety_mode off', {
    True: 'It was not rejected: YAML 1.1 has more words for false', 'off': 'A boolean never holds a text'})
require_foresight('max_acceleration_mps2 1', {
    1.0: 'ROS converts nothing: an integer is rejected, and the old value stays'})
require_foresight('max_acceleration_mps2 2.0', {0.5: 'The ends of a range belong to it'}, REFUSALS)
require_foresight('robot_name 007', {
    '007': 'YAML reads a number, so it was rejected, and the old value stays',
    7: 'A text never holds a number: it is rejected, and the old value stays'})


order = Exercise('5.1c', 'Put the words in order', CHAPTER, TEXT, hints=(
    'Each command begins with `ros2 param`, and then says what to do: `get`, `set` or `describe`.',
    'After the verb comes the node, after the node the parameter, and with `set` the value at the end.'))


def typed(trial: Trial) -> tuple[Gripper, str]:
    """Type the learner's lines, and return the gripper with what was printed."""
    if not trial.work.strip():
        raise NoUse('three commands', 'there is none')
    gripper = trial.start(Gripper)
    printed = []
    for line in trial.work.strip().splitlines():
        try:
            words = shlex.split(line, comments=True)
        except ValueError as error:
            raise NoUse('words that a shell can take apart', f'`{line}`: {error}') from None
        if words and words[0].lstrip('%') != 'ros2':
            printed.append(f'{words[0]}: command not found')
        elif words[1:2] == ['param']:
            own = [f'{CORNER}/gripper' if word in ('/gripper', 'gripper') else word for word in words[1:]]
            printed.append(trial.ros2(*own))
        elif words:
            printed.append(f'after `ros2`, `{" ".join(words[1:2])}` is not `param`')
    return gripper, '\n'.join(printed)


def _complaint(said: str) -> str:
    lines = [line for line in said.splitlines() if re.search('not found|error|invalid|failed|is not `param`', line)]
    return f'; the terminal says: {lines[0].strip()}' if lines else ''


@order.require('`retries` of the gripper becomes 5', see='Change it')
def is_set(trial: Trial) -> None:
    gripper, said = typed(trial)
    found = trial.client(gripper).get_parameter('retries')
    expect(found == 5, '`retries` is `5`', f'it is `{found!r}`{_complaint(said)}')


@order.require('the value of `mode` is printed', see='See it')
def is_read(trial: Trial) -> None:
    _, said = typed(trial)
    expect(re.search(r'\bauto\b', said), 'the text `auto` is printed', f'it is not{_complaint(said)}')


@order.require('`speed_mps` is described, with its type', see='See it')
def is_described(trial: Trial) -> None:
    _, said = typed(trial)
    expect(re.search(r'speed_mps\s+Type: double', said), 'the description of `speed_mps` is printed',
           f'it is not{_complaint(said)}')


EXERCISES = (order, spell, foresee)
