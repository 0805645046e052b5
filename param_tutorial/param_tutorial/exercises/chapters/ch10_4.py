"""Exercises of chapter 10.4: state rules, rename parameters, and both in one node."""

import re
import time
from collections.abc import Mapping, Sequence
from textwrap import shorten

from rclpy.node import Node

from param_tools.ros.node_log import LogLine
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import expect_accepted, expect_rejected
from param_tutorial.exercises.trial import NoStart, NotYet, NoUse, Trial, expect

CHAPTER = '10_4_beyond_today'
STATE = 'Build it: a rule in a dozen lines'
KINDS = 'Change it: the rules of the package'
ACROSS = 'Rules across parameters'
MIRROR = 'Build it: a mirror'
ALIASES = 'Change it: the aliases of the package'


def expect_no_start(trial: Trial, requests: Sequence[Mapping[str, object]]) -> None:
    """Expect the learner's node not to start with what it rejects while it runs.

    What it accepts then is the business of another requirement.
    """
    client = trial.client(trial.start())
    rejected = [each for each in requests if not client.set_parameters_atomically(each)[0].successful]
    for request in rejected or requests[:1]:
        overrides = [f'{name}:={value}' for name, value in request.items()]
        try:
            trial.start(ros_args=[word for each in overrides for word in ('-p', each)])
        except NoStart:
            continue
        raise NotYet(f'with `{" ".join(overrides)}` the node does not start',
                     'it started. What is registered after the declarations never sees an override: judge the start '
                     'values, too')


def expect_values(trial: Trial, node: Node, wanted: Mapping[str, object], when: str) -> None:
    """Expect a node to hold values, after something.

    :raises NoUse: it has no such parameter.
    """
    client = trial.client(node)
    existing = client.list_parameters()
    own = [name for name in existing if name not in ('use_sim_time', 'start_type_description_service')]
    for name, value in wanted.items():
        if name not in existing:
            raise NoUse(f'there is a parameter `{name}`',
                        f'there are only `{"`, `".join(own)}`' if own else 'the node has declared none')
        found = client.get_parameter(name)
        expect(found == value, f'`{name}` is `{value!r}` {when}', f'it is `{found!r}`')


# -- 10.4a ----------------------------------------------------------------------------------------------------

rules = Exercise('10.4a', 'State the rules', CHAPTER, NODE_CLASS, node_name='drone', hints=(
    'One `Rules(self)` after the declarations, and three rules chained to it.',
    'The three are `matches`, `one_of` and `check`. The pattern for three capital letters is `[A-Z]{3}`.',
    "`.check(['land_percent', 'home_percent'], lambda land, home: ..., 'a sentence')`: the function gets the two "
    'values in the order of the names.'))


@rules.require('a call sign is three capital letters from A to Z, no more and no less', see=STATE)
def call_sign(trial: Trial) -> None:
    drone = trial.start()
    expect_values(trial, drone, {'call_sign': 'ABC'}, 'at first')
    for bad in ('abc', 'AB', 'ABCD', '', 'A1C', '007', 'ABc', 'ÄBC', 'A C', 'ABC\n'):
        expect_rejected(trial, drone, {'call_sign': bad})
    for good in ('XYZ', 'AAA', 'QEB'):
        expect_accepted(trial, drone, {'call_sign': good})


@rules.require('there are three modes', see=KINDS)
def mode(trial: Trial) -> None:
    drone = trial.start()
    expect_values(trial, drone, {'mode': 'hover'}, 'at first')
    for bad in ('loop', '', 'Hover', 'landing', 'hover, track', 'e'):
        expect_rejected(trial, drone, {'mode': bad})
    # Among others that are fine: each parameter of a request is judged, wherever it stands.
    for bad_request in ({'mode': 'loop', 'call_sign': 'XYZ'}, {'call_sign': 'XYZ', 'mode': 'loop'}):
        expect_rejected(trial, drone, bad_request)
    for good in ('track', 'land', 'hover'):
        expect_accepted(trial, drone, {'mode': good})


@rules.require('`land_percent` is below `home_percent`, whether a request sets one of them or both', see=ACROSS)
def order(trial: Trial) -> None:
    drone = trial.start()
    expect_values(trial, drone, {'land_percent': 10, 'home_percent': 30}, 'at first')
    for bad in ({'land_percent': 30}, {'land_percent': 99}, {'home_percent': 5}, {'home_percent': 10},
                {'land_percent': 25, 'home_percent': 20}, {'home_percent': 20, 'land_percent': 25},
                {'land_percent': 50, 'mode': 'hover'}):
        expect_rejected(trial, drone, bad)
    for good in ({'land_percent': 50, 'home_percent': 60}, {'home_percent': 20, 'land_percent': 15},
                 {'land_percent': 19}, {'home_percent': 90, 'mode': 'hover'}):
        expect_accepted(trial, drone, good)


@rules.require('with an override that breaks a rule the drone does not start', see=STATE)
def at_the_start(trial: Trial) -> None:
    expect_no_start(trial, [{'mode': 'loop'}, {'call_sign': 'ABCD'}, {'land_percent': 40}, {'home_percent': 5},
                            {'land_percent': 70, 'home_percent': 60}])
    drone = trial.start(ros_args=['-p', 'land_percent:=40', '-p', 'home_percent:=50', '-p', 'mode:=track'])
    expect_values(trial, drone, {'land_percent': 40, 'home_percent': 50, 'mode': 'track'}, 'as the overrides say')


# -- 10.4b ----------------------------------------------------------------------------------------------------

rename = Exercise('10.4b', 'A new name', CHAPTER, NODE_CLASS, node_name='wagon', hints=(
    'Declare the new names only. The old ones stand in one `Aliases`.',
    '`Aliases(self, {...})` comes before the first declaration: it has to move the overrides to the new names.',
    "`Aliases(self, {'width': 'width_mm', 'plate': 'plate_number'})`, and the declarations with the new names."))


@rename.require('what is set under one name can be read under the other', see=MIRROR)
def both_ways(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800, 'plate_number': 'none', 'plate': 'none'}, 'at first')
    for name, value in (('width', 700), ('width_mm', 900), ('width', 650)):
        expect_accepted(trial, wagon, {name: value})
        expect_values(trial, wagon, {'width_mm': value, 'width': value}, f'once `{name} = {value}` is set')


@rename.require('start values reach both names, whichever name the file uses', see=ALIASES)
def start_values(trial: Trial) -> None:
    for width, plate in (('width', 'plate'), ('width_mm', 'plate_number'), ('width_mm', 'plate')):
        wagon = trial.start(ros_args=['-p', f'{width}:=600', '-p', f'{plate}:=W-7'])
        expect_values(trial, wagon, {'width_mm': 600, 'width': 600, 'plate_number': 'W-7', 'plate': 'W-7'},
                      f'with the overrides `{width}:=600` and `{plate}:=W-7`')


@rename.require('the plate is read-only under both names', see=ALIASES)
def read_only(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'plate_number': 'none', 'plate': 'none'}, 'at first')
    for name in ('plate_number', 'plate'):
        result = trial.client(wagon).set_parameter(name, 'W-8')
        expect(not result.successful, f'`{name}` is read-only', 'it could be set')


@rename.require('two names with two values, in one request, are rejected', see=ALIASES)
def contradiction(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'at first')
    for asked in ({'width': 1, 'width_mm': 2}, {'width_mm': 3, 'width': 4}, {'width': 800, 'width_mm': 5}):
        expect_rejected(trial, wagon, asked)
        expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'after the rejection')


def warnings_of(trial: Trial, request: Mapping[str, object], *ros_args: str) -> list[str]:
    """Start the learner's node, set something, and return what the node has logged as a warning."""
    began_ns = time.time_ns()
    lines: list[LogLine] = []
    stop_listening = trial.ros.node_log.on_line(lines.append)
    try:
        wagon = trial.start(ros_args=ros_args)
        trial.client(wagon).set_parameters(request)
        mark = f'the check has read the log up to here ({began_ns})'
        wagon.get_logger().fatal(mark)  # it comes after all other lines of this node
        trial.wait(lambda: any(line.text == mark for line in lines), 'a node that logs', lambda: 'nothing comes')
    finally:
        stop_listening()
    return [line.text for line in lines if line.level in ('WARN', 'ERROR') and line.time_ns >= began_ns]


@rename.require('the log warns of an old name that is used, and of no new one', see=ALIASES)
def warns(trial: Trial) -> None:
    expect_values(trial, trial.start(), {'width_mm': 800, 'width': 800, 'plate_number': 'none', 'plate': 'none'},
                  'at first')
    for width, plate, is_old in (('width', 'plate', True), ('width_mm', 'plate_number', False)):
        for name, request, ros_args in ((width, {width: 700}, ()), (width, {}, ('-p', f'{width}:=600')),
                                        (plate, {}, ('-p', f'{plate}:=W-7'))):
            warnings = warnings_of(trial, request, *ros_args)
            how = f'when `{name}` is set' if request else f'when an override sets `{name}`'
            shown = f'it has `{shorten(" ".join(warnings), 200)}`' if warnings else 'there is none'
            if is_old:
                expect(any(re.search(rf'\b{name}\b', line) for line in warnings),
                       f'a warning about `{name}`, {how}', shown)
            else:
                expect(not warnings, f'no warning, {how}', shown)


# -- 10.4c ----------------------------------------------------------------------------------------------------

both = Exercise('10.4c', 'A new name under an old rule', CHAPTER, NODE_CLASS, node_name='conveyor', hints=(
    'Three statements in one order: the old names, the declarations, the rule. Which of them has to come first?',
    '`Aliases` comes before the first declaration, and `Rules` after the last. The rule needs the new names only: a '
    'change under an old name is a change of the new one, too.',
    "`Rules(self).check(['speed_mmps', 'limit_mmps'], lambda speed, limit: ..., 'a sentence')`."))


def values_of(speed: int, limit: int) -> dict[str, int]:
    """Return what a conveyor holds, under all names."""
    return {'speed_mmps': speed, 'speed': speed, 'limit_mmps': limit, 'limit': limit}


@both.require('both parameters answer to their old names and to their new ones', see=MIRROR)
def both_names(trial: Trial) -> None:
    conveyor = trial.start()
    expect_values(trial, conveyor, values_of(100, 500), 'at first')
    for asked, speed, limit in (({'speed': 150}, 150, 500), ({'limit': 450}, 150, 450),
                                ({'speed_mmps': 200, 'limit': 400}, 200, 400), ({'limit_mmps': 300}, 200, 300)):
        expect_accepted(trial, conveyor, asked)
        expect_values(trial, conveyor, values_of(speed, limit), f'once `{asked}` is set')


@both.require('a speed above the limit is rejected, under any of the names', see=ACROSS)
def one_rule(trial: Trial) -> None:
    conveyor = trial.start()
    expect_values(trial, conveyor, values_of(100, 500), 'at first')
    for bad in ({'speed_mmps': 501}, {'speed': 600}, {'limit_mmps': 99}, {'limit': 50},
                {'speed': 300, 'limit': 200}, {'limit_mmps': 200, 'speed': 300}):
        expect_rejected(trial, conveyor, bad)
    expect_values(trial, conveyor, values_of(100, 500), 'after six rejections')
    for good in ({'speed': 600, 'limit_mmps': 700}, {'limit': 650, 'speed_mmps': 640}, {'speed': 650},
                 {'limit': 90, 'speed': 80}):
        expect_accepted(trial, conveyor, good)


# What it starts with, and the values that come of it.
STARTS: tuple[tuple[Sequence[str], int, int], ...] = (
    (['speed:=600', 'limit_mmps:=700'], 600, 700), (['limit:=300'], 100, 300), (['speed_mmps:=500'], 500, 500))


@both.require('it starts with good values under any of the names, and not with bad ones', see=STATE)
def its_start(trial: Trial) -> None:
    for overrides, speed, limit in STARTS:
        conveyor = trial.start(ros_args=[word for each in overrides for word in ('-p', each)])
        expect_values(trial, conveyor, values_of(speed, limit), f'with `{" ".join(overrides)}`')
    expect_no_start(trial, [{'speed': 600}, {'speed_mmps': 600}, {'limit': 50}, {'limit_mmps': 50}])


EXERCISES = (rules, rename, both)
