"""Exercises of chapter 5.1: order the words of commands, spell values for the command line, and predict what
becomes of them."""

import itertools
import re
import shlex
from collections.abc import Mapping
from typing import Any, NamedTuple

from rclpy.node import Node

from param_tools import values
from param_tutorial.exercises.exercise import DICTIONARY, TEXT, Exercise
from param_tutorial.exercises.trial import CORNER, NotYet, NoUse, Trial, expect
from param_tutorial.nodes.simple_param_node import SimpleParamNode

CHAPTER = '05_1_from_the_command_line'
SPELLING = 'Break it: which type did you mean?'
REJECTIONS = 'Break it: rejections and mistakes'
WAIT = 'Build it: wait for a node'


class Gripper(Node):
    """Waits for what is typed; it holds one value of each type that is easily missed."""

    def __init__(self) -> None:
        super().__init__('gripper')
        self.declare_parameters('', [
            ('speed_mps', 0.25), ('tolerance_m', 0.5), ('retries', 3), ('label', 'none'), ('mode', 'auto'),
            ('weights', [0.5, 0.5])])


def split(line: str) -> list[str]:
    """Take a line apart as a shell does.

    :raises NotYet: a shell could not, either.
    """
    try:
        return shlex.split(line, comments=True)
    except ValueError as error:
        raise NotYet('words that a shell can take apart', f'`{line}`: {error}') from None


def type_in(trial: Trial, node: Node, words: str) -> str:
    """Type ``ros2 param set NODE`` and some words, as in a terminal, and return what it prints."""
    own = ['param', 'set', f'{CORNER}/{node.get_name()}', *split(words)]
    answer: str = trial.call(f'`{words}`', trial.ros2, *own)
    return answer


spell = Exercise('5.1b', 'Spell six values', CHAPTER, DICTIONARY, hints=(
    'Begin with the type: a double needs a dot, an integer must not have one, and a string that looks like something '
    'else needs quotes.',
    'The shell takes one pair of quotes away, and YAML reads what is left. So a string may need two pairs, as in '
    '`"\'42\'"`.',
    'In YAML 1.1, a number with an exponent needs a dot and a sign: `1.0e-3`. All elements of a list need the same '
    'type.'))

# Parameter, the value it should hold, and what to think of if YAML reads another type in the word.
GOALS = (
    ('speed_mps', 1.0, 'A double needs a dot'),
    ('tolerance_m', 0.001, 'A double needs a dot, and with an exponent also a sign'),
    ('retries', 10, 'An integer is written with digits only'),
    ('label', '42', 'A string that looks like a number needs two pairs of quotes, one for the shell and one for YAML'),
    ('mode', 'off', 'To YAML 1.1 this word means false, unless two pairs of quotes make it a string'),
    ('weights', [1.0, 2.5], 'A list has brackets, and all its elements need the same type'),
)


def _complaint_about(name: str, word: str, goal: object, because: str) -> str:
    """Return why a word has not become the goal.

    :param because: What to think of if YAML reads another type in it.
    """
    words = split(word)
    if not words:
        return 'the shell finds nothing in it'
    if words[0] in ('ros2', '%ros2', name):
        return f'you wrote `{word}`. Write only what comes after the name of the parameter'
    if len(words) > 1:
        return (f'the shell makes {len(words)} words of it: {", ".join(f"`{each}`" for each in words)}. Quotes around '
                'the whole keep it together')
    value = values.parse(words[0])
    if values.type_of(value) is not values.type_of(goal):
        return f'to YAML, `{words[0]}` is the {values.type_of(value).label} `{value!r}`. {because}'
    return f'to YAML, `{words[0]}` is `{value!r}`' + (
        '. An integer that begins with 0 is octal' if isinstance(goal, int) and words[0].startswith('0') else '')


def require_spelling(name: str, goal: object, because: str) -> None:
    """Add the requirement that a word makes a parameter hold a value."""
    label = values.type_of(goal).label

    @spell.require(f'`{name}` becomes the {label} `{goal!r}`', see=SPELLING)
    def arrives(trial: Trial) -> None:
        word = trial.work.get(name)
        expect(isinstance(word, str), 'a Python string, with what you would type', f'there is `{word!r}`')
        expect(word.strip(), '', 'there is nothing to type yet')
        gripper = trial.start(Gripper)
        type_in(trial, gripper, f'{name} {word}')
        holds = trial.client(gripper).get_parameter(name)
        if not values.same(holds, goal):
            raise NotYet(f'`{name}` holds `{goal!r}`', _complaint_about(name, word, goal, because))


for each in GOALS:
    require_spelling(*each)


foresee = Exercise('5.1c', 'Predict what the robot holds', CHAPTER, DICTIONARY, hints=(
    'There are two questions for each line: what does YAML make of the word, and does the robot accept a value of '
    'that type?',
    'A robot that rejects a value keeps the one it has. `%ros2 param describe` shows types and limits.',
    'The list in the section “Break it: which type did you mean?” shows what YAML 1.1 makes of `off` and `12:30`.'))


def require_foresight(words: str, because: Mapping[object, str], see: str = SPELLING) -> None:
    """Add the requirement to know what the robot holds after a command."""
    @foresee.require_prediction(words, see=see, because=because)
    def holds(trial: Trial) -> Any:
        robot = trial.start(SimpleParamNode)
        type_in(trial, robot, words)
        return trial.client(robot).get_parameter(words.split(maxsplit=1)[0])


require_foresight('max_speed_rpm 12:30', {
    100: 'The robot did not reject it: YAML 1.1 reads a number in base 60',
    12.5: 'YAML 1.1 reads an integer in it', 12: 'YAML 1.1 does not stop at the colon',
    '12:30': 'An integer parameter never holds a string; YAML 1.1 reads a number'})
require_foresight('enable_safety_mode off', {
    True: 'The robot did not reject it: YAML 1.1 has more words for false',
    'off': 'A boolean parameter never holds a string'})
require_foresight('max_acceleration_mps2 1', {
    1.0: 'The robot converts nothing: it rejects the integer, and the old value stays'})
require_foresight('max_acceleration_mps2 2.0', {
    0.5: 'The ends of a range belong to it, so the robot accepts this one', 2: 'The parameter is a double'}, REJECTIONS)
require_foresight('robot_name 007', {
    '007': 'YAML reads a number, so the robot rejects it, and the old value stays',
    7: 'A string parameter never holds a number: the robot rejects it, and the old value stays'})


order = Exercise('5.1a', 'Put the words in order', CHAPTER, TEXT, hints=(
    'Each command begins with `ros2 param`, and then says what to do: `get`, `set` or `describe`.',
    'After the verb comes the node, then the parameter, and with `set` the value at the end.',
    'For your own two: `list` has an option `--param-type`, and `set` has an option `--timeout`, with a number of '
    'seconds after it. An option goes right after the verb.'))
PATIENCE_SEC = 20


class Typed(NamedTuple):
    """A line of the learner's, and what it printed."""

    line: str
    printed: str


def typed(trial: Trial) -> tuple[Gripper, list[Typed]]:
    """Type the learner's lines, and return the gripper with what they printed."""
    lines = [command for line in trial.work.replace('\\\n', ' ').strip().splitlines()
             for command in re.split(r'\s*(?:;|&&)\s*', line)]  # no quoted word of this exercise has one of these
    if not lines:
        raise NoUse('five commands', 'there is none')
    gripper = trial.start(Gripper)
    result = []
    for line in lines:
        try:
            words = split(line)
        except NotYet as error:
            raise NoUse(error.expected, error.happened) from None
        if not words:
            continue
        if words[0].lstrip('%') != 'ros2':
            what = 'No such file or directory' if '/' in words[0] else 'command not found'  # as bash has it
            printed = f'{words[0]}: {what}'
        elif words[1:2] == ['param']:
            own = [f'{CORNER}/gripper' if word in ('/gripper', 'gripper') else word for word in words[1:]]
            printed = trial.call(f'`{line}`', trial.ros2, *own)  # a long --timeout has an end here
        else:
            printed = f'after `ros2`, `{" ".join(words[1:2])}` is not `param`'
        result.append(Typed(line, printed))
    return gripper, result


def expect_printed(lines: list[Typed], verb: str, pattern: str, expected: str) -> None:
    """Expect one of the lines to have printed something.

    :param verb: What the line for it has in it; if it fails, its own message explains that best.
    """
    expect(any(re.search(pattern, each.printed) for each in lines), expected, f'it is not{_complaint(lines, verb)}')


def _complaint(lines: list[Typed], verb: str) -> str:
    own = [each for each in lines if verb in each.line.split() and 'successful' not in each.printed]
    if not any(verb in each.line.split() for each in lines):
        return f'; there is no `{verb}` in your lines'
    if not own:
        return ''
    # Of a usage error, the last line says what is wrong.
    return f'; the terminal says: {own[0].printed.splitlines()[-1].strip()}' if own[0].printed else ''


@order.require('`retries` of the gripper becomes 5', see='Change it')
def is_set(trial: Trial) -> None:
    gripper, lines = typed(trial)
    found = trial.client(gripper).get_parameter('retries')
    own = [each for each in lines if 'label' not in each.line]
    expect(found == 5, '`retries` is `5`', f'it is `{found!r}`{_complaint(own, "set")}')


@order.require('the value of `mode` is printed', see='See it')
def is_read(trial: Trial) -> None:
    _, lines = typed(trial)
    expect_printed(lines, 'get', r'\bauto\b', 'its value `auto` is printed')


@order.require('`speed_mps` is described, with its type', see='See it')
def is_described(trial: Trial) -> None:
    _, lines = typed(trial)
    expect_printed(lines, 'describe', r'speed_mps\s+Type: double', 'the description of `speed_mps` is printed')


@order.require('all parameters of the gripper are listed, with their types', see='See it')
def is_listed(trial: Trial) -> None:
    _, lines = typed(trial)
    if any(re.search(r'^ *weights$', each.printed, re.MULTILINE) for each in lines):
        raise NotYet('a list of names, each with its type', 'the types are missing: an option of `list` adds them')
    expect_printed(lines, 'list', r'label \(type: string\)[^/]*weights \(type: double array\)',
                   'a list of all names, each with its type')


@order.require(f'`label` becomes `ready`, and the gripper may take {PATIENCE_SEC} s to start', see=WAIT)
def is_set_with_patience(trial: Trial) -> None:
    gripper, lines = typed(trial)
    found = trial.client(gripper).get_parameter('label')
    own = [each for each in lines if 'label' in each.line]
    why = _complaint(own, 'set') if own else '; none of your lines sets it'
    expect(found == 'ready', "`label` is `'ready'`", f'it is `{found!r}`{why}')
    words = [word for each in own for word in split(each.line.replace('=', ' '))]
    given = next((after for word, after in itertools.pairwise(words) if word == '--timeout'), '0')
    expect(float(given) >= PATIENCE_SEC, f'the command waits up to {PATIENCE_SEC} s for the gripper',
           f'it waits {given} s' if float(given) else 'it has no option for that, and waits one second')


EXERCISES = (order, spell, foresee)
