"""Exercises of chapter 5.2: judge and act, hunt faults, put a change in order, and write a whole program."""

import contextlib
from collections.abc import Iterator, Mapping
from typing import Any

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.errors import CallbackError
from param_tools.ros.rclpy_private import has_judge
from param_tools.values import INTEGER
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise, Kind
from param_tutorial.exercises.expectations import (
    expect_accepted,
    expect_declared,
    expect_follows,
    expect_left_alone,
    expect_rejected,
    expect_start_value,
    take_type_for_granted,
)
from param_tutorial.exercises.programs import (
    PROGRAM,
    expect_logs,
    expect_no_start,
    require_ends,
    require_program,
    running,
)
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, describe_error, expect

CHAPTER = '05_2_with_a_callback'
JUDGE = 'Build it: a callback that judges'
TOO_EARLY = 'Break it: acting too early'
ACT = 'Build it: a callback that acts'
LADDER = 'The callback ladder'
LIST = 'One by one, or all at once'
START = 'Who judges an override?'
ROBOT = 'The same on a robot'


judge = Exercise('5.2a', 'Judge and act', CHAPTER, NODE_CLASS, node_name='heater', hints=(
    'You need two callbacks: one registered with `add_on_set_parameters_callback`, which returns a '
    '`SetParametersResult`, and one registered with `add_post_set_parameters_callback`, which acts.',
    'A request may hold one of the two limits, or both. Begin with the stored ones, and let the proposed ones '
    "replace them: `new = {p.name: p.value for p in parameters}`, then `new.get('low_c', stored)`.",
    'In post-set everything is stored: read both with `get_parameter`, and set `self.target_c` to their middle. Do '
    'the same once at the end of the constructor.',
    'The values of the start come before any callback. Ask your own judge about them, after the declarations: '
    "`self.validate(self.get_parameters(['low_c', 'high_c']))`. If its result is not successful, raise an exception."))


def expect_working(trial: Trial, node: Node, new: Mapping[str, object], because: str = '') -> None:
    """Expect a request that breaks no rule to be accepted.

    :param because: What to think of if it is rejected.
    :raises NoUse: it is not, which would come to light in each requirement.
    """
    try:
        expect_accepted(trial, node, new, because)
    except NotYet as error:
        raise NoUse(error.expected, error.happened) from None


@contextlib.contextmanager
def answering() -> Iterator[None]:
    """Raise NoUse in place of what a callback raises: it would come to light in each requirement."""
    try:
        yield
    except CallbackError as error:
        raise NoUse('an answer', describe_error(error)) from None


@judge.require('a lower limit that is not below the upper one is rejected, with a reason', see=JUDGE)
@answering()
def order(trial: Trial) -> None:
    heater = trial.start()
    for good in ({'low_c': 20}, {'high_c': 23}, {'low_c': 18}, {'high_c': 22}):
        expect_working(trial, heater, good)
    for bad in ({'low_c': 25}, {'low_c': 22}, {'high_c': 10}, {'high_c': 18}):
        expect_rejected(trial, heater, bad, '' if has_judge(heater) else '. No callback of yours is asked: '
                        'a method alone is none before `add_on_set_parameters_callback` gets it')
    # Other limits are stored now, and each request is judged by them.
    expect_accepted(trial, heater, {'high_c': 40})
    expect_accepted(trial, heater, {'low_c': 39}, '. What counts is the limit that is stored at that moment')
    expect_accepted(trial, heater, {'low_c': -500})
    expect_accepted(trial, heater, {'high_c': -4}, '. What counts is the limit that is stored at that moment')
    expect_rejected(trial, heater, {'low_c': 19})
    expect_accepted(trial, heater, {'high_c': 1000})


_TOGETHER = '. Each proposed limit has to be compared with the other proposed one, not with the stored one'


@judge.require('both limits in one request are judged together', see=LIST)
def together(trial: Trial) -> None:
    heater = trial.start()
    for names in (('low_c', 'high_c'), ('high_c', 'low_c')):
        def both(low_c: int, high_c: int, names: tuple[str, str] = names) -> dict[str, int]:
            return {name: {'low_c': low_c, 'high_c': high_c}[name] for name in names}

        for bad in (both(21, 19), both(20, 20)):
            expect_rejected(trial, heater, bad, _TOGETHER if has_judge(heater) else '')
        expect_accepted(trial, heater, both(25, 30), _TOGETHER)
        expect_rejected(trial, heater, both(30, 25))
        expect_accepted(trial, heater, both(5, 10), _TOGETHER)
        expect_accepted(trial, heater, both(18, 22), _TOGETHER)


@judge.require('`self.target_c` is the middle of both limits, as soon as they are stored', see=ACT)
def follows(trial: Trial) -> None:
    heater: Any = expect_follows(trial, 'target_c', [
        ({'low_c': 10}, 16), ({'high_c': 30}, 20), ({'low_c': 25, 'high_c': 30}, 27.5),
        ({'high_c': 12, 'low_c': -3}, 4.5)])
    expect_accepted(trial, heater, {'use_sim_time': False})  # rclpy calls both callbacks for this one, too
    expect(heater.target_c == 4.5, '`self.target_c` stays `4.5` when another parameter is set',
           f'it is `{heater.target_c!r}`')
    heater = trial.start(ros_args=['-p', 'low_c:=10'])
    expect_accepted(trial, heater, {'high_c': 30})
    expect(heater.target_c == 20,
           '`self.target_c` is `20` once `high_c = 30` is stored, after a start with `-p low_c:=10`',
           f'it is `{heater.target_c!r}`. What counts for the other limit is what is stored, not its default')


@judge.require('it is the middle from the start, also with an override', see=ACT)
def starts_right(trial: Trial) -> None:
    for override, middle in (('low_c:=10', 16), ('high_c:=41', 29.5), ('', 20)):
        heater = trial.start(ros_args=['-p', override] if override else [])
        found = getattr(heater, 'target_c', None)
        expect(found == middle, f'`self.target_c` is `{middle}` after a start with '
               + (f'`-p {override}`' if override else 'the defaults'), f'it is `{found!r}`'
               + ('. That is the middle of the defaults' if found == 20 else ''))


@judge.require('it does not start with limits that break the rule', see=START)
def starts_only_right(trial: Trial) -> None:
    for override in ('low_c:=30', 'high_c:=18', 'high_c:=-5'):
        try:
            heater = trial.start(ros_args=['-p', override])
        except NoStart:
            continue
        raise NotYet(f'it does not start with `-p {override}`', f'it started, with `low_c = '
                     f'{heater.get_parameter("low_c").value}` and `high_c = {heater.get_parameter("high_c").value}`')


@judge.require('a rejected value changes nothing', see=TOO_EARLY)
def acts_late(trial: Trial) -> None:
    heater: Any = expect_follows(trial, 'target_c', [({'low_c': 10}, 16)])
    expect_left_alone(trial, heater, 'target_c', {'low_c': 12})
    heater.rejects = False
    expect_accepted(trial, heater, {'high_c': 30})
    expect(heater.target_c == 20, '`self.target_c` is the middle of what is stored, `20`, after the next change',
           f'it is `{heater.target_c!r}`: a value that was rejected has come through')


hunt = Exercise('5.2b', 'Hunt four faults', CHAPTER, NODE_CLASS, node_name='door', hints=(
    "Put the door on the stage and ask it: `ParameterClient(ros.add(Door)).set_parameter('open_percent', 50)`. "
    'Then read its reason again.',
    'One fault is a comparison that is never equal, one judges what is none of its business, one is a `return` that '
    'comes too soon, and one acts on a proposal.',
    'The declaration fixes the type, so that check can go. The rule is about two names, so ask for them first. The '
    'last `return` belongs after the loop. What moves the motor belongs in a post-set callback.'))


@hunt.require('a percentage is accepted, and everything else rejected with a reason', see=JUDGE)
@answering()
def accepts(trial: Trial) -> None:
    door = trial.start()
    expect_working(trial, door, {'open_percent': 50},
                   '. But 50 is an integer and a percentage: look at what the comparison compares')
    for name in ('open_percent', 'force_percent'):
        for value in (50, 0, 100):
            expect_accepted(trial, door, {name: value})
        for bad in (101, -1, 1000, 'wide', 12.5):
            expect_rejected(trial, door, {name: bad})
    for name, value in (('open_percent', 0), ('force_percent', 50)):
        expect_declared(trial, name, INTEGER, value)


@hunt.require('every parameter of a request is judged', see=LIST)
def judges_each(trial: Trial) -> None:
    door = trial.start()
    expect_accepted(trial, door, {'open_percent': 50, 'force_percent': 60})
    for bad in ({'open_percent': 50, 'force_percent': 150}, {'force_percent': 50, 'open_percent': 150},
                {'force_percent': -1, 'open_percent': 50}, {'open_percent': -1, 'force_percent': 50}):
        expect_rejected(trial, door, bad)


@hunt.require('other parameters are left alone', see=JUDGE)
def leaves_others(trial: Trial) -> None:
    class Labeled(trial.work):  # type: ignore[name-defined,misc]  # a subclass, as another person may write it
        def __init__(self) -> None:
            super().__init__()
            self.declare_parameter('label', 'north')
            self.declare_parameter('height_mm', 2100)

    Labeled.__name__ = trial.work.__name__
    expected = 'a subclass may have parameters of its own, `label` and `height_mm`'
    try:
        door = trial.start(Labeled)
    except NoStart as error:
        raise NotYet(expected, f'{error.happened}. The callback is called for them, too') from None
    for name, value in (('label', 'south'), ('height_mm', 2300), ('use_sim_time', False)):
        expect_accepted(trial, door, {name: value}, '. The rule is about two other parameters')


@hunt.require('the motor follows what is stored, and only that, from the start', see=ACT)
def motor(trial: Trial) -> None:
    door: Any = expect_follows(trial, 'motor_percent', [
        ({'open_percent': 50}, 50), ({'force_percent': 20}, 50), ({'force_percent': 90, 'open_percent': 70}, 70),
        ({'open_percent': 0, 'force_percent': 30}, 0), ({'open_percent': 40}, 40)])
    expect_left_alone(trial, door, 'motor_percent', {'open_percent': 80})
    door.rejects = False
    expect_accepted(trial, door, {'force_percent': 10})
    expect(door.motor_percent == 40, '`self.motor_percent` is still `40` after the next change',
           f'it is `{door.motor_percent!r}`: a value that was rejected has come through')
    door = trial.start(ros_args=['-p', 'open_percent:=35'])
    found = getattr(door, 'motor_percent', None)
    expect(found == 35, '`self.motor_percent` is `35` after a start with `-p open_percent:=35`', f'it is `{found!r}`')


class Ladder(Node):
    """Notes which rung a request reaches, by its letter in the exercise, and what is stored at that moment."""

    def __init__(self) -> None:
        super().__init__('ladder')
        self.declare_parameter('speed', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=300, step=1)]))
        self.notes: list[tuple[str, int]] = []
        self.add_pre_set_parameters_callback(self.rewrite)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.act)

    def rewrite(self, parameters: list[Parameter]) -> list[Parameter]:
        self.note('d')
        return parameters

    def judge(self, _: list[Parameter]) -> SetParametersResult:
        self.note('e')
        return SetParametersResult(successful=True)

    def act(self, _: list[Parameter]) -> None:
        self.note('a')

    def note(self, rung: str) -> None:
        self.notes.append((rung, self.get_parameter('speed').value))


LETTERS = Kind('five letters in a string, as in the cell above',
               lambda work: isinstance(work, (str, list, tuple)) and all(isinstance(each, str) for each in work),
               'my_order')

put_in_order = Exercise('5.2c', 'Put a change in order', CHAPTER, LETTERS, hints=(
    'Which callback may still rewrite the request, which may only reject it, and which comes too late for both?',
    'A value of the wrong type never gets to an on-set callback, but it does get to a pre-set callback.',
    'The table in the section “The callback ladder” shows the order.'))


def true_order(trial: Trial) -> list[str]:
    """Let a node climb the ladder, and return the letters of the exercise in the order in which it did so."""
    ladder = trial.start(Ladder)
    trial.client(ladder).set_parameter('speed', 900)  # beyond the range: what it reaches comes before the checks
    unchecked = [rung for rung, _ in ladder.notes]
    ladder.notes.clear()
    trial.client(ladder).set_parameter('speed', 150)
    checked = ladder.notes[len(unchecked):]
    return [*unchecked, 'b', *(rung for rung, stored in checked if stored == 100),
            'c', *(rung for rung, stored in checked if stored == 150)]


def require_order(position: int, sentence: str, proof: str) -> None:
    """Add the requirement that the letter at a position stands before the next one.

    :param proof: What the node shows to a learner who had the two the other way round.
    """
    @put_in_order.require(sentence, see=LADDER)
    def in_order(trial: Trial) -> None:
        letters = [letter for letter in ''.join(trial.work).lower() if letter.isalpha()]
        if sorted(letters) != list('abcde'):
            raise NoUse('each letter from `a` to `e`, once', f'your order is `{trial.work!r}`')
        first, second = true_order(trial)[position:position + 2]
        expect(letters.index(first) < letters.index(second), f'`{first}` before `{second}`', proof)


require_order(0, 'what comes before rclpy checks read-only, type and range',
              'when it was set to 900, beyond its range, a node called its pre-set callback, and then rejected it')
require_order(1, 'what comes only after these checks',
              'when it was set to 900, beyond its range, a node rejected it and never called its on-set callback')
require_order(2, 'what comes before the value is stored',
              'when it was set from 100 to 150, a node still held 100 while its on-set callback ran')
require_order(3, 'what comes after that',
              'when it was set from 100 to 150, a node held 150 while its post-set callback ran')

ELEVATOR = '5.2d · An elevator from an empty file'
program = Exercise('5.2d', 'An elevator from an empty file', CHAPTER, PROGRAM, node_name='elevator', hints=(
    'Begin with the frame: imports, a class with its two declarations, `main`, and the two last lines. It runs before '
    'it has a callback, so the check can tell you how far you are.',
    'Write the rule once, as a method that takes a floor and a top floor and returns a reason or an empty string. The '
    'on-set callback calls it with `{p.name: p.value for p in parameters}` in place of what is stored.',
    'In the constructor, call the rule with the start values before you register the callbacks, and `raise '
    'ValueError(reason)` if there is one. The log line belongs in the post-set callback.'))
require_program(program, 'elevator_node.py', ROBOT)


@program.require('floors below 0 or above `top_floor` are rejected, with a reason', see=JUDGE)
def floors(trial: Trial) -> None:
    with running(trial, program) as elevator:
        client = trial.client(elevator.node)
        expect_start_value(client, 'floor', INTEGER, 0)
        expect_start_value(client, 'top_floor', INTEGER, 5)
        for good in ({'floor': 5}, {'floor': 0}, {'top_floor': 9}, {'floor': 8}, {'use_sim_time': False}):
            expect_accepted(trial, elevator.node, good)
        for bad in ({'floor': 10}, {'floor': -1}, {'top_floor': 7}):
            expect_rejected(trial, elevator.node, bad)


@program.require('both in one request are judged together', see=LIST)
def floors_together(trial: Trial) -> None:
    with running(trial, program) as elevator:
        take_type_for_granted(trial.client(elevator.node), INTEGER, 'floor', 'top_floor')
        for bad in ({'floor': 5, 'top_floor': 4}, {'top_floor': 4, 'floor': 5}):
            expect_rejected(trial, elevator.node, bad)
        for good in ({'floor': 12, 'top_floor': 12}, {'top_floor': 3, 'floor': 2}):
            expect_accepted(trial, elevator.node, good, '. What counts are the two proposed values')


@program.require('it does not start with such values', see=ELEVATOR)
def floors_at_start(trial: Trial) -> None:
    with running(trial, program) as elevator:
        take_type_for_granted(trial.client(elevator.node), INTEGER, 'floor', 'top_floor')
    with running(trial, program, '-p floor:=7 -p top_floor:=8') as elevator:
        expect_start_value(trial.client(elevator.node), 'floor', INTEGER, 7)
    for words in ('-p floor:=6', '-p floor:=-1'):
        expect_no_start(trial, program, words)


@program.require('it logs each floor that is stored, and none that is rejected', see=ACT)
def logs_floor(trial: Trial) -> None:
    expect_logs(trial, program, 'going to floor {}', 'floor', (1, 4, 77, 2), {'top_floor': 9})


require_ends(program, ELEVATOR)

EXERCISES = (judge, hunt, put_in_order, program)
