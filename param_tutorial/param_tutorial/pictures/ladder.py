"""The ladder that a value climbs on its way into a node, and from which it falls when the node rejects it.

Drawn from what was recorded (``parameters.recording``), slower than it happened: the node itself is done in less than
a thousandth of a second.
"""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from param_tutorial.pictures import motion
from param_tutorial.pictures.diagrams import Step

_WIDTH, _ROW, _TOP, _BOTTOM = 720, 44, 46, 16
_NAME_X, _LADDER_X, _RAIL, _MARK_X, _WORDS_X, _STORED_X = 14, 206, 44, 272, 294, 700
_LETTERS, _VALUE_LETTERS = 44, 9
_CLIMB_SEC, _STAY_SEC, _FALL_SEC = 0.45, 0.55, 0.7

# From the ground up: the word of the recorded step, and what stands beside the rung.
_RUNGS = (('asked', 'request'), ('pre-set', 'pre-set callbacks'), ('checks', "rclpy's own checks"),
          ('on-set', 'on-set callbacks'), ('stored', 'stored'), ('event', '/parameter_events'),
          ('post-set', 'post-set callbacks'), ('answer', 'answer'))
_GROUND = 0
_CHECKS = 2
_STORED = 4


@dataclass(frozen=True)
class _Rung:
    """What became of the value at one rung."""

    title: str
    words: str
    stored: str
    value: str
    """On its way beyond this rung."""
    mark: str
    """'passed', 'rejected', 'idle' if there was nothing to pass, 'unreached'."""


class Climb:
    """One set of a parameter as a value on the ladder."""

    def __init__(self, node: str, name: str, steps: Sequence[Step], objection: str = '') -> None:
        """
        :param steps: What happened, as it was recorded.
        :param objection: Why the node did not take the value; empty if it did.
        :raises ValueError: there is no step.
        """
        if not steps:
            raise ValueError('a Climb takes one step at least')
        self.node, self.name, self.objection = node, name, objection
        self._rungs = tuple(_rungs(name, steps, objection))
        self._is_answered = steps[-1].what != 'no answer'
        self._is_stored = any(step.what == 'stored' for step in steps)

    @property
    def sentence(self) -> str:
        """What came of it."""
        asked = f'{self.name} = {motion.cut(self._rungs[_GROUND].value, 40)}'
        last = self._reached[-1]
        if not self._is_answered:
            return f'{asked}: an exception at {last.title}, and the caller gets no answer.'
        if self.objection:
            return f'{asked} is rejected at {last.title}.'
        as_asked = self._rungs[_GROUND].value == last.stored
        return f'{asked} is accepted.' if as_asked else f'{asked} is accepted, and {last.stored} is stored.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        reached = [f'{number}, {rung.title}: {rung.words}; stored is {rung.stored}'
                   for number, rung in enumerate(self._reached, start=1)]
        return f'The ladder of {self.node}. {self.sentence} {". ".join(reached)}.'

    @property
    def _reached(self) -> list[_Rung]:
        return [rung for rung in self._rungs if rung.mark != 'unreached']

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest it shows how far the value got."""
        parts = [*self._ladder()]
        arrivals = [index * (_CLIMB_SEC + _STAY_SEC) for index in range(len(_RUNGS))]
        for index, rung in enumerate(self._rungs):
            parts += self._beside(index, rung, arrivals[index], reel)
        parts += self._value(arrivals, reel)
        height = _y(0) + _ROW / 2 + _BOTTOM
        return motion.stage(self.node, self.sentence, self.text, (_WIDTH, round(height)), parts, reel)

    def _ladder(self) -> Iterator[str]:
        left, right = _LADDER_X - _RAIL, _LADDER_X + _RAIL
        foot = _y(0) + _ROW / 2 + 4
        yield motion.path(f'M{left} {foot}V{_TOP - 16}M{right} {foot}V{_TOP - 16}', 'motion-thick')
        for index in range(len(_RUNGS)):
            yield motion.path(f'M{left} {_y(index) + 17}H{right}', 'motion-line')
        # Above this line nobody can say no.
        border = _y(_STORED) + _ROW / 2
        yield motion.path(f'M{right + 8} {border}H{_STORED_X}', 'motion-dashed')
        yield motion.label(640, border - 7, 'too late to reject', anchor='end', css_class='motion-faint')
        yield motion.label(_STORED_X, 22, f'stored {motion.cut(self.name, 22)}', anchor='end', css_class='motion-bold')
        yield motion.label(_WORDS_X, 22, 'what happens', anchor='start', css_class='motion-bold')
        yield motion.label(_NAME_X, 22, 'rung', anchor='start', css_class='motion-bold')

    def _beside(self, index: int, rung: _Rung, arrival_sec: float, reel: motion.Reel) -> Iterator[str]:
        y = _y(index)
        unreached = rung.mark == 'unreached'
        faint = 'motion-faint' if unreached or rung.mark == 'idle' else 'motion-bold'
        lines = rung.title.split(' ', 1) if len(rung.title) > 17 else [rung.title]
        for number, line in enumerate(lines):
            yield motion.label(_NAME_X, y + 4 + 16 * (number - (len(lines) - 1) / 2), line, anchor='start',
                               css_class=faint)
        if unreached:
            return
        told_sec = arrival_sec + .3 * _STAY_SEC
        parts = [_mark(rung.mark, y)]
        lines = textwrap.wrap(rung.words, _LETTERS)
        lines = [*lines[:1], motion.cut(' '.join(lines[1:]), _LETTERS)] if len(lines) > 2 else lines
        for number, line in enumerate(lines):
            parts.append(motion.label(_WORDS_X, y + 4.5 + 16 * (number - (len(lines) - 1) / 2), line, anchor='start',
                                      css_class='motion-bold' if rung.mark == 'rejected' else ''))
        before = self._rungs[index - 1].stored if index else rung.stored
        is_new = rung.stored != before
        parts.append(motion.label(_STORED_X, y + 4.5, motion.cut(rung.stored, 14), anchor='end',
                                  css_class='motion-value' if is_new else 'motion-faint'))
        if is_new:
            width = motion.LETTER_WIDTH * len(motion.cut(rung.stored, 14)) + 14
            parts.append(motion.box(_STORED_X - width + 7, y - 13, width, 26, 'motion-line', rounding=4))
        yield motion.group(parts, reel.appear(told_sec))

    def _value(self, arrivals: Sequence[float], reel: motion.Reel) -> Iterator[str]:
        """Yield the value: it climbs, changes where a callback changes it, and falls where it is rejected."""
        top = len(self._reached) - 1
        stops = [(0.0, _LADDER_X, _y(0))]
        for index in range(1, top + 1):
            stops += [(arrivals[index] - _CLIMB_SEC, _LADDER_X, _y(index - 1)), (arrivals[index], _LADDER_X, _y(index))]
        end_sec = arrivals[top] + _STAY_SEC
        falls = bool(self.objection) and not self._is_stored
        if falls:
            # It bounces once on the ground.
            stops += [(end_sec, _LADDER_X, _y(top)), (end_sec + .75 * _FALL_SEC, _LADDER_X, _y(0)),
                      (end_sec + .88 * _FALL_SEC, _LADDER_X, _y(0) - 12), (end_sec + _FALL_SEC, _LADDER_X, _y(0))]
        # The values that it has on its way, each with the moment from which it has it.
        faces = [(0.0, self._rungs[_GROUND].value, 'motion-token')]
        faces += [(arrivals[index] + .5 * _STAY_SEC, rung.value, 'motion-token')
                  for index, rung in enumerate(self._reached) if rung.value != self._rungs[max(0, index - 1)].value]
        if falls:
            faces.append((end_sec - .2, self._rungs[_GROUND].value, 'motion-token-bad'))
        yield motion.group(
            (motion.group(motion.token(motion.cut(value, _VALUE_LETTERS), css_class=css_class),
                          reel.shown(from_sec, faces[number + 1][0] if number + 1 < len(faces) else None))
             for number, (from_sec, value, css_class) in enumerate(faces)), reel.travel(stops))


def _rungs(name: str, steps: Sequence[Step], objection: str) -> Iterator[_Rung]:
    by_rung = {what: [step for step in steps if step.what == what] for what, _ in _RUNGS}
    last = len(_RUNGS) - 1
    if objection:
        stopped = [index for index, (what, _) in enumerate(_RUNGS[:-1])
                   if any(step.objection for step in by_rung[what])]
        # rclpy's own checks leave no trace but the answer.
        last = stopped[-1] if stopped else _CHECKS
    asked = value = steps[0].proposed
    stored = steps[0].stored
    for index, (what, title) in enumerate(_RUNGS):
        here = by_rung[what]
        value = next((step.proposed for step in reversed(here) if step.proposed), value)
        if index > last:
            yield _Rung(title, '', stored, value, 'unreached')
            continue
        stored = here[-1].stored if here else stored
        if objection and index == last:
            yield _Rung(title, _calls(here) if here else objection, stored, value, 'rejected')
            continue
        words = {'asked': f'set {name} to {motion.cut(asked, 24)}', 'checks': 'declared, not locked, type, range, step',
                 'stored': f'{motion.cut(value, 24)} is written', 'event': 'a message tells everybody',
                 'answer': 'successful'}.get(what) or _calls(here)
        yield _Rung(title, words, stored, value, 'passed' if here or index == _CHECKS else 'idle')


def _calls(steps: Sequence[Step]) -> str:
    """Return in words what the callbacks of one rung said."""
    told = []
    for step in steps:
        if step.objection.startswith('raises '):
            told.append(f'{step.who} {step.objection}')
        elif step.objection:
            told.append(f'{step.who} rejects: {step.objection}')
        elif step.what == 'on-set':
            told.append(f'{step.who} accepts')
        elif step.what == 'pre-set':
            told.append(f'{step.who} gives {motion.cut(step.proposed, 20)}' if step.proposed else step.happened)
        else:
            told.append(f'{step.who} acts on {motion.cut(step.proposed, 20)}')
    return '; '.join(told) or 'there is none'


def _mark(kind: str, y: float) -> str:
    """Return a check mark, a cross, or a dash for a rung without callbacks."""
    x = _MARK_X
    if kind == 'passed':
        return motion.path(f'M{x - 6} {y}l4.5 5l8 -11', 'motion-check')
    if kind == 'rejected':
        return motion.path(f'M{x - 6} {y - 6}l12 12M{x + 6} {y - 6}l-12 12', 'motion-cross')
    return motion.path(f'M{x - 6} {y}h10', 'motion-thin')


def _y(index: int) -> float:
    """Return where the middle of a rung is; the first is at the bottom."""
    return _TOP + _ROW * (len(_RUNGS) - 1 - index) + 10.0
