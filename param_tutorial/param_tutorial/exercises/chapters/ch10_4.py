"""Exercises of chapter 10.4: state rules, and rename a parameter."""

import re
import time
from collections.abc import Mapping, Sequence
from textwrap import shorten

from rclpy.node import Node

from param_tools.ros.node_log import LogLine
from param_tutorial.exercises.exercise import NODE_CLASS, Exercise
from param_tutorial.exercises.expectations import expect_accepted, expect_no_start, expect_rejected
from param_tutorial.exercises.trial import NoUse, Trial, expect, overrides

CHAPTER = '10_4_beyond_today'
STATE = 'A rule in a dozen lines'
ACROSS = 'Five gaps'
TWIN = 'Names that change'


def expect_no_starts(trial: Trial, requests: Sequence[Mapping[str, object]]) -> None:
    """Expect the learner's node not to start with what it rejects while it runs.

    What it accepts then is the business of another requirement.
    """
    client = trial.client(trial.start())
    rejected = [each for each in requests if not client.set_parameters_atomically(each)[0].successful]
    for request in rejected or requests[:1]:
        words = overrides(request)
        expect_no_start(trial, words, f'with `{" ".join(words[1::2])}` the node does not start',
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
    'Three calls of `rule` after the four declarations, each with the names, a function, and a sentence.',
    "`re.fullmatch('[A-Z]{3}', call_sign)` for the first; `mode in ('hover', 'track', 'land')` for the second.",
    "`rule(self, ['land_percent', 'home_percent'], lambda land, home: ..., 'a sentence')`: the function gets the two "
    'values in the order of the names.'))


@rules.require('a call sign is three capital letters from A to Z, no more and no less', see=STATE)
def call_sign(trial: Trial) -> None:
    drone = trial.start()
    expect_values(trial, drone, {'call_sign': 'ABC'}, 'at first')
    for bad in ('abc', 'AB', 'ABCD', '', 'A1C', '007', 'ABc', 'ÄBC', 'A C', 'ABC\n'):
        expect_rejected(trial, drone, {'call_sign': bad})
    for good in ('XYZ', 'AAA', 'QEB'):
        expect_accepted(trial, drone, {'call_sign': good})


@rules.require('there are three modes', see=STATE)
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
    expect_no_starts(trial, [{'mode': 'loop'}, {'call_sign': 'ABCD'}, {'land_percent': 40}, {'home_percent': 5},
                            {'land_percent': 70, 'home_percent': 60}])
    drone = trial.start(ros_args=['-p', 'land_percent:=40', '-p', 'home_percent:=50', '-p', 'mode:=track'])
    expect_values(trial, drone, {'land_percent': 40, 'home_percent': 50, 'mode': 'track'}, 'as the overrides say')


# -- 10.4b ----------------------------------------------------------------------------------------------------

rename = Exercise('10.4b', 'A new name', CHAPTER, NODE_CLASS, node_name='wagon', hints=(
    'Declare both names. `Twin` of the chapter shows how a start value goes from one to the other and back, and how '
    'a change of one becomes a change of both.',
    'The pre-set callback sees which name a request has used, so it is the one that can log a warning.',
    'An on-set callback sees both names. It collects the values of all that are called `width` or `width_mm`, and '
    'rejects the request if there are two different ones.'))


@rename.require('what is set under one name can be read under the other', see=TWIN)
def both_ways(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'at first')
    for name, value in (('width', 700), ('width_mm', 900), ('width', 650)):
        expect_accepted(trial, wagon, {name: value})
        expect_values(trial, wagon, {'width_mm': value, 'width': value}, f'once `{name} = {value}` is set')


@rename.require('a start value reaches both names, whichever name the file uses', see=TWIN)
def start_values(trial: Trial) -> None:
    for name in ('width', 'width_mm'):
        wagon = trial.start(ros_args=['-p', f'{name}:=600'])
        expect_values(trial, wagon, {'width_mm': 600, 'width': 600}, f'with the override `{name}:=600`')


@rename.require('two names with two values, in one request, are rejected', see=TWIN)
def contradiction(trial: Trial) -> None:
    wagon = trial.start()
    expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'at first')
    for asked in ({'width': 1, 'width_mm': 2}, {'width_mm': 3, 'width': 4}, {'width': 800, 'width_mm': 5}):
        expect_rejected(trial, wagon, asked)
        expect_values(trial, wagon, {'width_mm': 800, 'width': 800}, 'after the rejection')


def warnings_of(trial: Trial, request: Mapping[str, object]) -> list[str]:
    """Start the learner's node, set something, and return what the node has logged as a warning."""
    began_ns = time.time_ns()
    lines: list[LogLine] = []
    stop_listening = trial.ros.node_log.on_line(lines.append)
    try:
        wagon = trial.start()
        trial.client(wagon).set_parameters(request)
        mark = f'the check has read the log up to here ({began_ns})'
        wagon.get_logger().fatal(mark)  # it comes after all other lines of this node
        trial.wait(lambda: any(line.text == mark for line in lines), 'a node that logs', lambda: 'nothing comes')
    finally:
        stop_listening()
    return [line.text for line in lines if line.level in ('WARN', 'ERROR') and line.time_ns >= began_ns]


@rename.require('the log warns of the old name when it is set, and not of the new one', see=TWIN)
def warns(trial: Trial) -> None:
    expect_values(trial, trial.start(), {'width_mm': 800, 'width': 800}, 'at first')
    for name in ('width', 'width_mm'):
        warnings = warnings_of(trial, {name: 700})
        shown = f'it has `{shorten(" ".join(warnings), 200)}`' if warnings else 'there is none'
        if name == 'width':
            expect(any(re.search(r'\bwidth\b', line) for line in warnings),
                   'a warning about `width`, when `width` is set', shown)
        else:
            expect(not warnings, 'no warning, when `width_mm` is set', shown)


EXERCISES = (rules, rename)
