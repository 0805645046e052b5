"""Exercises of chapter 5.2: judge and act, hunt faults, and put a change into its order."""

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.exercises.exercise import NODE_CLASS, TEXT, Exercise
from param_tutorial.exercises.expectations import expect_accepted, expect_follows, expect_left_alone, expect_rejected
from param_tutorial.exercises.trial import NoUse, Trial, expect

CHAPTER = '05_2_with_a_callback'
JUDGE = 'Build it: a callback that judges'
TOO_EARLY = 'Break it: acting too early'
ACT = 'Build it: a callback that acts'
LADDER = 'The callback ladder'


judge = Exercise('5.2a', 'Judge and act', CHAPTER, NODE_CLASS, node_name='heater', hints=(
    'Two callbacks: one registered with `add_on_set_parameters_callback`, which answers with a '
    '`SetParametersResult`, and one with `add_post_set_parameters_callback`, which acts.',
    'A request may hold one of the two limits, or both. Begin with the stored ones, and let the proposed ones '
    "replace them: `new = {p.name: p.value for p in parameters}`, then `new.get('low_c', stored)`.",
    'In post-set everything is stored: read both with `get_parameter`, and set `self.target_c` to their middle.'))


@judge.require('a lower limit that is not below the upper one is rejected, with a reason', see=JUDGE)
def order(trial: Trial) -> None:
    heater = trial.start()
    for bad in ({'low_c': 25}, {'low_c': 22}, {'high_c': 10}):
        expect_rejected(trial, heater, bad)
    expect_accepted(trial, heater, {'low_c': 20})


@judge.require('both limits in one request are judged together', see=JUDGE)
def together(trial: Trial) -> None:
    heater = trial.start()
    expect_rejected(trial, heater, {'low_c': 21, 'high_c': 19})
    expect_accepted(trial, heater, {'low_c': 25, 'high_c': 30},
                    '. Each proposed limit has to be held against the other proposed one, not against the stored one')


@judge.require('`self.target_c` is the middle of both limits, as soon as they are stored', see=ACT)
def follows(trial: Trial) -> None:
    expect_follows(trial, 'target_c', [({'low_c': 10}, 16), ({'low_c': 25, 'high_c': 30}, 27.5)])


@judge.require('nothing is acted upon that is rejected in the end', see=TOO_EARLY)
def acts_late(trial: Trial) -> None:
    heater = expect_follows(trial, 'target_c', [({'low_c': 10}, 16)])
    expect_left_alone(trial, heater, 'target_c', {'low_c': 12})


hunt = Exercise('5.2b', 'Hunt three faults', CHAPTER, NODE_CLASS, node_name='door', hints=(
    "Put the door on the stage and ask it: `ParameterClient(ros.add(Door)).set_parameter('open_percent', 50)`. "
    'Then read its reason again.',
    'One fault is a comparison that is never equal, one is a `return` that comes too soon, one acts on a proposal.',
    'The declaration settles the type, so that check can go. `return` stands behind the loop. What moves the motor '
    'goes into a post-set callback.'))


@hunt.require('a percentage is accepted', see=JUDGE)
def accepts(trial: Trial) -> None:
    door = trial.start()
    for value in (50, 0, 100):
        expect_accepted(trial, door, {'open_percent': value},
                        '. A member of `Parameter.Type` and a number of `ParameterType` are never equal')


@hunt.require('every parameter of a request is judged', see=JUDGE)
def judges_each(trial: Trial) -> None:
    door = trial.start()
    expect_accepted(trial, door, {'open_percent': 50, 'force_percent': 60})
    expect_rejected(trial, door, {'open_percent': 50, 'force_percent': 150})
    expect_rejected(trial, door, {'force_percent': -1, 'open_percent': 50})


@hunt.require('the motor follows what is stored, and only that', see=ACT)
def motor(trial: Trial) -> None:
    door = expect_follows(trial, 'motor_percent', [({'open_percent': 50}, 50), ({'force_percent': 20}, 50)])
    expect_left_alone(trial, door, 'motor_percent', {'open_percent': 80})


class Ladder(Node):
    """Notes which rung is reached, and what is stored at that moment."""

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


put_in_order = Exercise('5.2c', 'Put a change in order', CHAPTER, TEXT, hints=(
    'Which callback may still rewrite the request, which may only say no, and which comes when it is too late for '
    'both?',
    'An on-set callback never sees a value of the wrong type, and a pre-set callback does.',
    'The last table of the section “The callback ladder” is the order.'))


def true_order(trial: Trial) -> list[str]:
    """Let a node climb the ladder, and return the letters of the exercise in the order in which it did."""
    ladder = trial.start(Ladder)
    trial.client(ladder).set_parameter('speed', 900)  # beyond the range: what is reached comes before the checks
    unchecked = [rung for rung, _ in ladder.notes]
    ladder.notes.clear()
    trial.client(ladder).set_parameter('speed', 150)
    checked = ladder.notes[len(unchecked):]
    return [*unchecked, 'b', *(rung for rung, stored in checked if stored == 100),
            'c', *(rung for rung, stored in checked if stored == 150)]


def require_order(position: int, sentence: str, proof: str) -> None:
    """Add the requirement that the letters at a position, and after it, are in their order.

    :param proof: What the node shows to those who had it the other way round.
    """
    @put_in_order.require(sentence, see=LADDER)
    def in_order(trial: Trial) -> None:
        letters = [letter for letter in trial.work.lower() if letter.isalpha()]
        if sorted(letters) != list('abcde'):
            raise NoUse('each letter from `a` to `e`, once', f'your order is {trial.work!r}')
        first, second = true_order(trial)[position:position + 2]
        expect(letters.index(first) < letters.index(second), f'`{first}` before `{second}`', proof)


require_order(0, 'what may come before type, range and lock are checked',
              'set to 900, beyond its range, a node called its pre-set callback, and then rejected')
require_order(1, 'what may come only after that',
              'set to 900, beyond its range, a node rejected and never called its on-set callback')
require_order(2, 'what comes before the value is stored',
              'set from 100 to 150, a node still held 100 while its on-set callback ran')
require_order(3, 'what comes after that',
              'set from 100 to 150, a node held 150 while its post-set callback ran')

EXERCISES = (judge, hunt, put_in_order)
