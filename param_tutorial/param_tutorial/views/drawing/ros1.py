"""What the real ROS 1 says, recorded, for lessons that put it beside what ROS 2 says now.

    ros1.scene('types')                     what was typed into ROS 1, and its answers
    ros1.scene('types').beside(a, b, c)     the same, each step beside an answer of ROS 2
    ros1.scene('types')[1:3]                some of its steps

The scenes stand in ros1_recording.txt, as text to read. ROS 1 has come to its end, so they will not change.
"""

import functools
import html
import re
import textwrap
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import zip_longest
from pathlib import Path
from typing import Any

from param_tools.errors import nearest
from param_tools.markup.styles import style
from param_tools.markup.tables import Markup, table

RECORDING = Path(__file__).with_name('ros1_recording.txt')
_SCENE = re.compile(r'== (\S.*)')
_STEP = re.compile(r'(master>>>|/\S*>>>|\$|!) (.*)')
_MORE = re.compile(r'\.\.\.( .*|)')
_LEFT, _RIGHT = 'ROS 1, recorded', 'ROS 2, now'
_NO_COUNTERPART = '—'
_WIDTH = 58
_CSS_CLASS = 'param-ros1'
# JupyterLab's own rules for tables and <pre> are as specific as these, so some of these have to be important.
_STYLE = style('param_tutorial/views/drawing/ros1.css')


@dataclass(frozen=True)
class Step:
    """Something that was typed or done, and what came of it."""

    prompt: str
    """Who: ``/robot>>>`` a node, ``master>>>`` the master, ``$`` a shell, ``!`` the one who does what it says."""
    typed: str
    answer: str = ''
    """Empty where nothing was printed, which in ROS 1 means: done."""


def parse(text: str) -> Mapping[str, tuple[Step, ...]]:
    """Read a recording.

    :return: The steps of each scene by its name. Each scene begins with an empty parameter server and fresh nodes.
    """
    scenes: dict[str, list[Step]] = {}
    steps: list[Step] = []
    for line in text.splitlines():
        if match := _SCENE.fullmatch(line):
            steps = scenes[match[1]] = []
        elif match := _STEP.fullmatch(line):
            steps.append(Step(match[1], match[2]))
        elif (match := _MORE.fullmatch(line)) and not steps[-1].answer:
            steps[-1] = replace(steps[-1], typed=f'{steps[-1].typed}\n{match[1][1:]}')
        elif steps:
            steps[-1] = replace(steps[-1], answer=f'{steps[-1].answer}\n{line}'.lstrip('\n'))
    return {name: tuple(replace(step, answer=step.answer.rstrip()) for step in steps)
            for name, steps in scenes.items()}


def scene(name: str) -> 'Recorded':
    """Return a scene of the recording.

    :raises KeyError: there is none of that name; the message names the likeliest.
    """
    scenes = _scenes()
    if name not in scenes:
        raise KeyError(f'there is no scene {name!r}{nearest(str(name), list(scenes), "The recording is empty")}')
    return Recorded(scenes[name])


@functools.cache
def _scenes() -> Mapping[str, tuple[Step, ...]]:
    return parse(RECORDING.read_text(encoding='utf-8'))


class Recorded:
    """Steps that were typed into ROS 1, with its answers. Show it as the last line of a cell."""

    def __init__(self, steps: tuple[Step, ...]):
        self.steps = steps

    def __getitem__(self, which: slice) -> 'Recorded':
        """Return some of the steps; one step is ``[2:3]``."""
        return Recorded(self.steps[which])

    @property
    def answers(self) -> list[str]:
        """What ROS 1 printed at each step; an empty text where it printed nothing."""
        return [step.answer for step in self.steps]

    def beside(self, *answers: Any) -> 'SideBySide':
        """Put the answers of ROS 2 beside those of ROS 1.

        :param answers: One for each step, in order; ``...`` where ROS 2 has no counterpart. A function without
            arguments is called, and an exception that it raises is its answer.
        :raises ValueError: there are more or fewer answers than steps.
        """
        if len(answers) != len(self.steps):
            raise ValueError(f'{len(self.steps)} steps were recorded, so beside() takes {len(self.steps)} answers and '
                             f'not {len(answers)}; ... stands for none')
        return SideBySide(self.steps, [_answer(each) for each in answers])

    def __repr__(self) -> str:
        return '\n'.join(filter(None, (text for step in self.steps for text in (_format_typed(step), step.answer))))

    def _repr_html_(self) -> str:
        return _STYLE + table([_LEFT], [[_step_markup(step, step.answer)] for step in self.steps], css_class=_CSS_CLASS)


class SideBySide:
    """Steps of ROS 1, and beside each an answer of ROS 2. Show it as the last line of a cell."""

    def __init__(self, steps: tuple[Step, ...], answers: list[str]):
        """:param answers: One for each step."""
        self.steps = steps
        self.answers = answers

    def __repr__(self) -> str:
        lines = [f'{_LEFT:{_WIDTH}}  {_RIGHT}', f'{"-" * _WIDTH}  {"-" * _WIDTH}']
        for step, answer in zip(self.steps, self.answers):
            left = _wrapped(_format_typed(step)) + _wrapped(_format_answer(step))
            lines += [f'{ours:{_WIDTH}}  {theirs}'.rstrip()
                      for ours, theirs in zip_longest(left, _wrapped(answer), fillvalue='')]
        return '\n'.join(lines)

    def _repr_html_(self) -> str:
        rows = [(_step_markup(step, _format_answer(step)), Markup(f'<pre>{html.escape(answer)}</pre>'))
                for step, answer in zip(self.steps, self.answers)]
        return _STYLE + table([_LEFT, _RIGHT], rows, css_class=_CSS_CLASS)


def _answer(value: Any) -> str:
    if value is ...:
        return _NO_COUNTERPART
    if callable(value):
        try:
            value = value()
        except Exception as error:
            return f'{type(error).__name__}: {error}'
    return repr(value)


def _format_typed(step: Step) -> str:
    """Return what was typed as it looked, or what happened in parentheses."""
    if step.prompt == '!':
        return f'({step.typed})'
    first, *more = step.typed.split('\n')
    return '\n'.join([f'{step.prompt} {first}', *(f'{" " * len(step.prompt)} {line}'.rstrip() for line in more)])


def _format_answer(step: Step) -> str:
    """Return ROS 1's answer, or a word in its place if it printed nothing."""
    return step.answer or ('' if step.prompt == '!' else '(done)')


def _step_markup(step: Step, answer: str) -> Markup:
    kind = ' class="param-event"' if step.prompt == '!' else ''
    return Markup(f'<pre{kind}>{html.escape(_format_typed(step))}</pre>'
                  + (f'<pre class="param-said">{html.escape(answer)}</pre>' if answer else ''))


def _wrapped(text: str) -> list[str]:
    return [part for line in text.splitlines() for part in textwrap.wrap(
        line, _WIDTH, subsequent_indent='    ', break_on_hyphens=False) or ['']]
