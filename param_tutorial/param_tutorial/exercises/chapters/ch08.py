"""Exercises of chapter 8: fill in a declaration, repair a node, find the practice that would have prevented a
complaint, and write a whole program."""

import contextlib
import re
from collections.abc import Callable

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools.descriptor import is_housekeeping
from param_tools.errors import CallbackError
from param_tools.values import DOUBLE, STRING
from param_tutorial.exercises.exercise import DICTIONARY, NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import (
    expect_accepted,
    expect_declared,
    expect_filled,
    expect_follows,
    expect_left_alone,
    expect_range,
    expect_range_fields,
    expect_rejected,
    expect_result,
    expect_start_value,
    format_found,
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
from param_tutorial.exercises.trial import NoStart, NotTried, NotYet, NoUse, Trial, expect, overrides, take_for_granted

CHAPTER = '08_best_practices'
DECLARE = 'Practice 1: declare everything, with a default that works'
DESCRIBE = 'Practice 2: let the descriptor do the checking'
JUDGE = 'Practice 3: judge first, act afterwards'
GROUP = 'Practice 4: group names with dots'

SPEED, GAP = 'belt.speed_mps', 'belt.gap_m'

repair = Exercise('8b', 'Repair a conveyor', CHAPTER, NODE_CLASS, node_name='conveyor', hints=(
    'Begin with the declarations: new names with a dot, defaults with a dot, a range and a description for each. Only '
    'then look at the callback.',
    "In the callback, hold what would be stored against the rule: `new = {p.name: p.value for p in parameters}`, then "
    "`new.get('belt.gap_m', stored)`. It changes nothing.",
    "The line that moves the motor goes into a callback that is registered with `add_post_set_parameters_callback`, "
    "and reads `get_parameter('belt.speed_mps')` there.",
    'For the start, call `self.validate([])` after the declarations, and raise an error if it is not successful: an '
    'empty request judges what is stored.'))


@repair.require('it starts without a file, and the belt stands still', see=DECLARE)
def starts_alone(trial: Trial) -> None:
    motor = getattr(trial.start(), 'motor_mps', None)
    expect(motor == 0.0, '`self.motor_mps` is `0.0`', f'it is {format_found(motor)}')


@repair.require('the group `belt` holds `speed_mps` and `gap_m`, both doubles', see=GROUP)
def grouped(trial: Trial) -> None:
    client = trial.client(trial.start())
    found = client.get_parameters(client.list_parameters(['belt']))
    wanted = {SPEED: 0.0, GAP: 0.5}
    if missing := [f'`{name}`' for name in wanted if name not in found]:
        raise NoUse(f'`{SPEED}` and `{GAP}`', f'there is no {" and no ".join(missing)}')
    are_doubles(trial)
    for name, value in wanted.items():
        expect(found[name] == value, f'`{name}` is `{value!r}` at first', f'it is `{found[name]!r}`')


def are_doubles(trial: Trial) -> None:
    """Expect both parameters of the group to be doubles."""
    client = trial.client(trial.start())
    for name in (SPEED, GAP):
        label = client.describe_parameter(name).type.label
        expect(label == 'double', f'`{name}` is a double',
               f'it is of type {label}: the default decides, whatever the descriptor says')


@repair.require('values outside of 0 to 2 and 0 to 1 are rejected by a range', see=DESCRIBE)
def limited(trial: Trial) -> None:
    take_for_granted(trial, are_doubles)
    takes_what_it_should(trial)
    conveyor = trial.start()
    for name, highest in ((SPEED, 2.0), (GAP, 1.0)):
        expect_range_fields(conveyor, name)
        for bad in (-0.5, highest + 0.5):
            expect_rejected(trial, conveyor, {name: bad})
        expect_range(trial.client(conveyor), name, 0.0, highest)


def takes_what_it_should(trial: Trial) -> None:
    """Expect speeds and gaps within the limits to be accepted, where the rule allows them."""
    conveyor = trial.start()
    for name, highest in ((SPEED, 2.0), (GAP, 1.0)):
        for good in (highest, 0.37 * highest):
            expect_accepted(trial, conveyor, {name: good})


@repair.require('the serial number is fixed, and each parameter is described', see=DESCRIBE)
def described(trial: Trial) -> None:
    client = trial.client(trial.start())
    own = [name for name in client.list_parameters() if not is_housekeeping(name)]
    expect('serial_number' in own, '`serial_number` is there', 'there is no such parameter any more')
    told = client.describe_parameters(own)
    expect(told['serial_number'].read_only, '`serial_number` is read-only', 'anybody can change it')
    number = client.get_parameter('serial_number')
    expect(number == 'CB-0007', '`serial_number` is still `CB-0007`', f'it is `{number!r}`')
    silent = [f'`{name}`' for name in own if not told[name].description.strip().strip('.…')]
    expect(not silent, 'a description for each', f'there is none for {", ".join(silent)}')


@repair.require('above 1 m/s a gap below 0.3 m is rejected, with a reason', see=JUDGE)
def judges(trial: Trial) -> None:
    take_for_granted(trial, are_doubles, takes_what_it_should)
    conveyor = trial.start()
    together = '. Both are proposed together, so judge them together'
    for bad in ({SPEED: 1.5, GAP: 0.1}, {GAP: 0.29, SPEED: 1.125}):
        expect_rejected(trial, conveyor, bad)
    expect_accepted(trial, conveyor, {SPEED: 1.0, GAP: 0.1})
    expect_rejected(trial, conveyor, {SPEED: 1.5})
    expect_accepted(trial, conveyor, {GAP: 0.3})
    expect_accepted(trial, conveyor, {SPEED: 1.5}, '. A gap of 0.3 m is enough')
    expect_accepted(trial, conveyor, {SPEED: 0.5})
    expect_accepted(trial, conveyor, {GAP: 0.1})
    expect_accepted(trial, conveyor, {SPEED: 1.5, GAP: 0.3}, together)
    expect_rejected(trial, conveyor, {GAP: 0.2})
    expect_accepted(trial, conveyor, {GAP: 0.2, SPEED: 0.75}, together)
    expect_accepted(trial, conveyor, {GAP: 0.9, SPEED: 2.0}, together)
    expect_accepted(trial, conveyor, {SPEED: 1.25})


@repair.require('the motor follows what is stored, and only that', see=JUDGE)
def acts_late(trial: Trial) -> None:
    take_for_granted(trial, are_doubles, takes_what_it_should)
    conveyor = expect_follows(trial, 'motor_mps', [
        ({SPEED: 0.5}, 0.5), ({SPEED: 0.0}, 0.0), ({SPEED: 0.4}, 0.4), ({GAP: 0.4}, 0.4), ({SPEED: 0.6, GAP: 0.5}, 0.6),
        ({GAP: 0.6, SPEED: 0.7}, 0.7)])
    accepted = False
    with contextlib.suppress(CallbackError):  # the requirement for the rule says so
        accepted = trial.client(conveyor).set_parameters_atomically({SPEED: 1.5, GAP: 0.1})[0].successful
    if not accepted:
        motor = getattr(conveyor, 'motor_mps', None)
        expect(motor == 0.7, '`self.motor_mps` stays `0.7` when the callback rejects a speed',
               f'it became {format_found(motor)}: an on-set callback has only a proposal')
    expect_left_alone(trial, conveyor, 'motor_mps', {SPEED: 0.8})
    motor = getattr(trial.start(), 'motor_mps', None)
    if motor is None:  # the first requirement says so
        return
    expect(motor == 0.0, 'the belt of the next conveyor stands still at first',
           f'its motor runs at {format_found(motor)}. Does each conveyor have a motor of its own?')
    motor = trial.start(ros_args=['-p', f'{SPEED}:=0.9']).motor_mps
    expect(motor == 0.9, f'`self.motor_mps` is `0.9` after a start with `-p {SPEED}:=0.9`',
           f'it is {format_found(motor)}')


@repair.require('with start values that the rule forbids it does not start', see=JUDGE)
def judges_the_start(trial: Trial) -> None:
    take_for_granted(trial, are_doubles, takes_what_it_should)
    trial.start(ros_args=start_with(1.5, 0.5))
    for speed, gap in ((1.5, 0.1), (1.125, 0.29)):
        words = start_with(speed, gap)
        with contextlib.suppress(NoStart):
            trial.start(ros_args=words)
            raise NotYet(f'with `{" ".join(words)}` the conveyor ends in its constructor',
                         'it has started. An on-set callback that is registered after the declarations never sees the '
                         'start values')


def start_with(speed: float, gap: float) -> list[str]:
    """Return the words that start a conveyor with these values."""
    return overrides({SPEED: speed, GAP: gap})


class Belt(Node):
    """A belt that follows one of the seven practices, and no other; a class of its own for each, see ``belt``."""

    follows: int

    def __init__(self) -> None:
        super().__init__('belt')
        default = 0.5 if self.follows == 1 else Parameter.Type.DOUBLE
        self.declare_parameter('speed_mps', default, self.limits(0.0, 2.0))
        self.declare_parameters('controller' if self.follows == 4 else '', [('kp', 2.0), ('ki', 0.1)])
        if self.follows != 7:
            self.declare_parameter('gravity_mps2', 9.81, self.limits(9.7, 9.9))
        self.motor_mps: float = self.get_parameter('speed_mps').value
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)

    def limits(self, lowest: float, highest: float) -> ParameterDescriptor:
        ranges = [FloatingPointRange(from_value=lowest, to_value=highest)] if self.follows == 2 else []
        return ParameterDescriptor(floating_point_range=ranges)

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name == 'speed_mps' and self.follows != 3:
                self.motor_mps = parameter.value
            if parameter.name == 'kp' and parameter.value < 0.0:
                return SetParametersResult(successful=False, reason='kp must not be negative')
        return SetParametersResult(successful=True)

    def react(self, _: list[Parameter]) -> None:
        self.motor_mps = self.get_parameter('speed_mps').value


def belt(follows: int) -> type[Belt]:
    """Return the class of belts that follow a practice.

    :param follows: Its number, from 1.
    """
    return type('Belt', (Belt,), {'follows': follows})


find = Exercise('8c', 'Which practice would have prevented it?', CHAPTER, DICTIONARY, hints=(
    'Name the practice that you believe in, by its number: a wrong guess costs nothing, the check tries it out.',
    'Practices 5 and 6 are for readers and for launches. No complaint is about these.',
    'Ask of each: when did it hurt? At the start, at a wrong value, at a rejection, in a list, or at a knob that '
    'should not be there?'))

# Does again what a complaint is about, with a belt, and returns what happened; nothing if all was well.
Reenact = Callable[[Trial, type[Belt]], str]


def require_practice(complaint: str) -> Callable[[Reenact], Reenact]:
    """Add the requirement to name the practice with which a complaint would not have come up.

    The decorated function does again what the complaint is about, on a belt that follows one practice. If the complaint
    still holds, it returns what happened.
    """
    def add(still: Reenact) -> Reenact:
        # A link to the practice would give the answer away.
        @find.require(f'“{complaint}”', see='What you can do now')
        def examine(trial: Trial) -> None:
            given = trial.work.get(complaint, ...)
            expect(given is not ..., '', 'there is no answer yet')
            practice = _practice(given)
            expect(practice, 'the number of a practice, 1 to 7', f'there is `{given!r}`')
            words = still(trial, belt(practice))
            expect(not words, 'a practice with which that does not happen',
                   f'a belt that follows practice {practice}, and no other: {words}')
        return still
    return add


def _practice(given: object) -> int:
    """Return the number of the practice that an answer means; 0 if it means none. 3, 3.0 and '3' mean the same."""
    text = str(given).strip().removesuffix('.0')
    return int(text) if text in {'1', '2', '3', '4', '5', '6', '7'} else 0


def started(trial: Trial, belt_class: type[Belt]) -> Belt:
    """Start a belt as its author does, with what the file holds."""
    return trial.start(belt_class, ros_args=['-p', 'speed_mps:=0.5'])


@require_practice('I started the belt with ros2 run, without a file, and it died at once.')
def does_not_start(trial: Trial, belt_class: type[Belt]) -> str:
    try:
        trial.start(belt_class)
    except NoUse as error:
        return error.happened
    return ''


@require_practice('I typed 50.0 and meant 0.5, and the belt took it.')
def takes_everything(trial: Trial, belt_class: type[Belt]) -> str:
    client = trial.client(started(trial, belt_class))
    return 'it accepted 50.0 m/s' if client.set_parameter('speed_mps', 50.0).successful else ''


@require_practice('My request was rejected, and the belt sped up all the same.')
def acts_on_proposals(trial: Trial, belt_class: type[Belt]) -> str:
    node = started(trial, belt_class)
    gain = next(name for name in ('kp', 'controller.kp') if node.has_parameter(name))
    trial.client(node).set_parameters_atomically({'speed_mps': 1.5, gain: -1.0})
    return f'the motor runs at {node.motor_mps} m/s, and the parameter says 0.5' if node.motor_mps != 0.5 else ''


@require_practice('I wanted a list of just the controller gains, and got none.')
def has_no_groups(trial: Trial, belt_class: type[Belt]) -> str:
    names = trial.client(started(trial, belt_class)).list_parameters(['controller'])
    return '' if names else 'the list of names that begin with `controller.` is empty'


@require_practice('Somebody set gravity to 0, and now the load weighs nothing.')
def has_gravity(trial: Trial, belt_class: type[Belt]) -> str:
    client = trial.client(started(trial, belt_class))
    return 'it accepted a gravity of 0' if client.set_parameter('gravity_mps2', 0.0).successful else ''


fill = Exercise('8a', 'Fill five gaps', CHAPTER, NODE_CLASS, node_name='fan', hints=(
    'A group is a name in front, and a dot: the last line shows what this parameter is called.',
    'The default, and both ends of a range for doubles, are doubles too. The description is any sentence that says '
    'what the number means.'))
FAN_SPEED = 'fan.speed'


@fill.require(f'`{FAN_SPEED}` is a double in a group `fan`, and the fan starts with 0.5', see=GROUP)
def fan_grouped(trial: Trial) -> None:
    expect_filled(trial)
    fan = trial.start()
    names = trial.client(fan).list_parameters()
    expect(FAN_SPEED in names, f'a parameter `{FAN_SPEED}`', 'the node has none of that name')
    others = [f'`{name}`' for name in names if name.startswith('fan.') and name != FAN_SPEED]
    expect(not others, 'one parameter in the group `fan`', f'there is also {", ".join(others)}')
    expect_rejected(trial, fan, {FAN_SPEED: 'full'})
    expect_declared(trial, FAN_SPEED, DOUBLE, 0.5)
    motor = getattr(fan, 'motor', None)
    expect(motor == 0.5, '`self.motor` is `0.5`', f'it is {format_found(motor)}')


@fill.require('its range goes from 0.0 to 1.0', see=DESCRIBE)
def fan_limited(trial: Trial) -> None:
    fan = trial.start()
    if trial.client(fan).describe_parameter(FAN_SPEED).type is not DOUBLE:
        raise NotTried
    expect_range_fields(fan, FAN_SPEED)
    for good in (0.0, 1.0, 0.37):
        expect_accepted(trial, fan, {FAN_SPEED: good})
    for bad in (-0.5, 1.5):
        expect_rejected(trial, fan, {FAN_SPEED: bad})
    expect_range(trial.client(fan), FAN_SPEED, 0.0, 1.0)


@fill.require('it is described', see=DESCRIBE)
def fan_described(trial: Trial) -> None:
    told = trial.client(trial.start()).describe_parameter(FAN_SPEED).description
    wanted = 'a sentence that says what the number means'
    expect(told.strip().strip('.…'), wanted, 'there is none')
    words = set(re.findall(r'\w+', told.casefold())) - {'a', 'the', 'of'}
    expect(words - {'todo', 'tbd', 'fixme', 'xxx', 'description'}, wanted, f'there is only `{told}`')
    expect(words - set(FAN_SPEED.split('.')), wanted, f'there is `{told}`, which the name says already')


MIXER = '8d · A mixer from an empty file'
TURNS, TILT = 'drum.speed_rpm', 'drum.tilt_deg'
program = Exercise('8d', 'A mixer from an empty file', CHAPTER, PROGRAM, node_name='mixer', hints=(
    'Follow the practices in their order: three declarations with a dot in the name where it belongs, a default and a '
    'descriptor each; then the rule; then what happens once it is met.',
    'Let one method judge a speed and a tilt. The constructor calls it with the start values, before it registers the '
    'callbacks, and raises a `ValueError`; the on-set callback calls it with what would be stored.',
    'The post-set callback logs what is stored: `self.get_logger().info(f"drum turns at {speed} rpm")`. `main` is '
    'that of every node, and catches `KeyboardInterrupt` and `ExternalShutdownException`.'))
require_program(program, 'mixer_node.py', MIXER)


@program.require(f'`{TURNS}` and `{TILT}` are doubles with a range', see=DESCRIBE)
def drum(trial: Trial) -> None:
    with running(trial, program) as mixer:
        client = trial.client(mixer.node)
        for name, start, highest in ((TURNS, 0.0, 30.0), (TILT, 15.0, 60.0)):
            expect_start_value(client, name, DOUBLE, start)
            expect_range(client, name, 0.0, highest)


@program.require('`serial_number` is fixed, but by a start, and each parameter is described', see=DESCRIBE)
def mixer_described(trial: Trial) -> None:
    with running(trial, program, '-p serial_number:=MX-0002') as mixer:
        client = trial.client(mixer.node)
        expect_start_value(client, 'serial_number', STRING, 'MX-0002')
        expect_result(client, 'serial_number', 'MX-0003', 'read only')
        told = client.describe_parameters([name for name in client.list_parameters() if not is_housekeeping(name)])
        silent = [f'`{name}`' for name in told if not told[name].description.strip().strip('.…')]
        expect(not silent, 'a description for each', f'there is none for {", ".join(silent)}')


@program.require('above 20 rpm a tilt above 30° is rejected, with a reason', see=JUDGE)
def mixer_judges(trial: Trial) -> None:
    together = '. Both are proposed together, so judge them together'
    with running(trial, program) as mixer:
        take_type_for_granted(trial.client(mixer.node), DOUBLE, TURNS, TILT)
        expect_accepted(trial, mixer.node, {TURNS: 30.0})
        expect_accepted(trial, mixer.node, {TILT: 30.0}, '. A tilt of 30° is still allowed')
        expect_rejected(trial, mixer.node, {TILT: 30.5})
        expect_accepted(trial, mixer.node, {TILT: 45.0, TURNS: 20.0}, together)
        expect_rejected(trial, mixer.node, {TURNS: 20.5})
        expect_rejected(trial, mixer.node, {TILT: 60.0, TURNS: 30.0})
        expect_accepted(trial, mixer.node, {TURNS: 25.0, TILT: 0.0}, together)


@program.require('it does not start with what it would reject later', see=MIXER)
def mixer_starts(trial: Trial) -> None:
    with running(trial, program) as mixer:
        take_type_for_granted(trial.client(mixer.node), DOUBLE, TURNS, TILT)
    with running(trial, program, f'-p {TURNS}:=12.0 -p {TILT}:=45.0') as mixer:
        expect_start_value(trial.client(mixer.node), TURNS, DOUBLE, 12.0)
    expect_no_start(trial, program, f'-p {TURNS}:=25.0 -p {TILT}:=45.0')


@program.require('it logs a speed once it is stored, and none that is rejected', see=JUDGE)
def mixer_acts_late(trial: Trial) -> None:
    expect_logs(trial, program, 'drum turns at {} rpm', TURNS, (17.5, 7.5, 27.5, 2.5), {TILT: 35.0},
                f'-p {TILT}:=40.0')


require_ends(program, MIXER)

EXERCISES = (fill, repair, find, program)
