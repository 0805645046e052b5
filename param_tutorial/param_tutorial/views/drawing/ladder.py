"""The ladder that a value climbs down on its way into a node, and up again when the node rejects it.

Time runs from top to bottom, as in a table. Drawn from what was recorded (``set_recorder``), slower than it happened:
the node itself is done in less than a thousandth of a second.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.timeline import Step

_TOP, _BOTTOM = 46, 16
_NAME_X, _RAIL, _STORED_X = 14, 44, 700
_VALUE_LETTERS, _STORED_LETTERS = 9, 14
_CLIMB_SEC, _STAY_SEC, _RETURN_SEC = 0.45, 0.55, 0.7

# From the top down: the word of the recorded step, and what stands beside the rung.
_RUNGS = (('asked', 'request'), ('pre-set', 'pre-set callbacks'), ('checks', "rclpy's own checks"),
          ('on-set', 'on-set callbacks'), ('stored', 'stored'), ('event', '/parameter_events'),
          ('post-set', 'post-set callbacks'), ('answer', 'answer'))
_REQUEST = 0
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


@dataclass(frozen=True)
class _Layout:
    """How high a rung is, and where things are beside it; on a narrow page, the rung's name stands above its words."""

    row: float
    ladder_x: float
    mark_x: float
    words_x: float
    letters: int


_WIDE, _NARROW = _Layout(44, 206, 272, 294, 44), _Layout(76, 56, 116, 132, 24)


class Climb(svg.AnimatedPicture):
    """One set of a parameter as a value on the ladder; at rest the value is where it has got to, or back at the top."""

    _has_narrow = True

    def __init__(self, node: str, name: str, steps: Sequence[Step], objection: str = '') -> None:
        """
        :param steps: What happened, as it was recorded.
        :param objection: Why the node did not take the value; empty if it did.
        """
        self.subject, self._name, self._objection = node, name, objection
        self._rungs = tuple(_rungs(name, steps, objection))
        self._reached = [rung for rung in self._rungs if rung.mark != 'unreached']
        self._is_answered = steps[-1].what != 'no answer'
        self._is_rejected = bool(objection) and not any(step.what == 'stored' for step in steps)

    @property
    def sentence(self) -> str:
        asked, last = self._rungs[_REQUEST].value, self._reached[-1]
        told = f'{self._name} = {svg.cut(asked, 40)}'
        if not self._is_answered:
            return f'{told}: an exception at {last.title}, and the caller gets no answer.'
        if self._objection:
            return f'{told} is rejected at {last.title}.'
        return f'{told} is accepted.' if asked == last.stored else f'{told} is accepted, and {last.stored} is stored.'

    @property
    def text(self) -> str:
        reached = [f'{number}, {rung.title}: {rung.words}; stored is {rung.stored}'
                   for number, rung in enumerate(self._reached, start=1)]
        return f'The ladder of {self.subject}. {self.sentence} {". ".join(reached)}.'

    @property
    def _layout(self) -> _Layout:
        return _NARROW if self._is_narrow else _WIDE

    def _y(self, index: int) -> float:
        """Return where the middle of a rung is; the first is at the top."""
        return _TOP + self._layout.row * index + 10.0

    @property
    def _height(self) -> float:
        return self._y(len(_RUNGS) - 1) + self._layout.row / 2 + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        layout = self._layout
        left, right = layout.ladder_x - _RAIL, layout.ladder_x + _RAIL
        foot = self._y(len(_RUNGS) - 1) + layout.row / 2 + 4
        yield svg.path(f'M{left} {foot}V{_TOP - 16}M{right} {foot}V{_TOP - 16}', 'thick')
        yield svg.path(''.join(f'M{left} {self._y(index) + 17}H{right}' for index in range(len(_RUNGS))))
        # Below this line nobody can say no.
        border, end, kind = self._y(_STORED) - layout.row / 2, _STORED_X, 'faint'
        if self._is_narrow:
            end, kind = self._width - 12, 'small'
            yield svg.words(_NAME_X, 16, f'the value of {svg.cut(self._name, 26)}', 'bold', anchor='start')
        else:
            yield svg.words(_STORED_X, 22, f'stored {svg.cut(self._name, 22)}', 'bold', anchor='end')
            yield svg.words(layout.words_x, 22, 'what happens', 'bold', anchor='start')
            yield svg.words(_NAME_X, 22, 'rung', 'bold', anchor='start')
        yield svg.path(f'M{right + 8} {border}H{end}', 'dashed')
        yield svg.words(end if self._is_narrow else end - 60, border + 15, 'too late to reject', kind, anchor='end')
        arrivals = [index * (_CLIMB_SEC + _STAY_SEC) for index in range(len(_RUNGS))]
        for index, rung in enumerate(self._rungs):
            kind, y = 'faint' if rung.mark in ('unreached', 'idle') else 'bold', self._y(index)
            yield svg.words(layout.words_x, y - 18, rung.title, kind, anchor='start') if self._is_narrow else \
                svg.paragraph(_NAME_X, y + 4, svg.in_two_lines(rung.title, 17), kind, anchor='start')
            if rung in self._reached:
                yield svg.group(self._beside(index, rung), animation.appear(arrivals[index] + .3 * _STAY_SEC))
        yield self._value(arrivals, animation)

    def _beside(self, index: int, rung: _Rung) -> Iterator[str]:
        """Yield what happens at a rung, and what is stored then."""
        layout, y, stored = self._layout, self._y(index), svg.cut(rung.stored, _STORED_LETTERS)
        yield {'passed': svg.check(layout.mark_x, y), 'rejected': svg.cross(layout.mark_x, y)}.get(
            rung.mark, svg.path(f'M{layout.mark_x - 6} {y}h10', 'thin'))
        kind = 'small' if self._is_narrow else 'bold' * (rung.mark == 'rejected')
        lines = svg.in_two_lines(rung.words, layout.letters)
        is_new = index > 0 and rung.stored != self._rungs[index - 1].stored
        if self._is_narrow:
            yield ''.join(svg.words(layout.words_x, y + 16 * number, line, kind, anchor='start')
                          for number, line in enumerate([*lines, f'stored: {stored}'][:3]))
            return
        yield svg.paragraph(layout.words_x, y + 4.5, lines, kind, anchor='start')
        yield svg.words(_STORED_X, y + 4.5, stored, 'value' if is_new else 'faint', anchor='end')
        if is_new:
            width = svg.LETTER_WIDTH * len(stored) + 14
            yield svg.box(_STORED_X - width + 7, y - 13, width, 26, 'line')

    def _value(self, arrivals: Sequence[float], animation: svg.Animation) -> str:
        """Return the value: it climbs down, may change on its way, and goes back from where it is rejected."""
        asked, lowest, request = self._rungs[_REQUEST].value, len(self._reached) - 1, self._y(_REQUEST)
        stops = [(0.0, request)]
        for index in range(1, lowest + 1):
            stops += [(arrivals[index] - _CLIMB_SEC, self._y(index - 1)), (arrivals[index], self._y(index))]
        # The values that it has on its way, each with the moment from which it has it.
        faces = [(0.0, asked, 'token')]
        faces += [(arrivals[index] + .5 * _STAY_SEC, rung.value, 'token') for index, rung in enumerate(self._reached)
                  if rung.value != self._rungs[max(0, index - 1)].value]
        if self._is_rejected:
            leaves_sec = arrivals[lowest] + _STAY_SEC
            faces.append((leaves_sec - .2, asked, 'token-bad'))
            if self._is_answered:  # otherwise nothing comes back to the caller
                stops += [(leaves_sec, self._y(lowest)), (leaves_sec + _RETURN_SEC, request)]
        ends_sec = [*(from_sec for from_sec, _, _ in faces[1:]), None]
        return svg.group(
            (svg.group(svg.token(svg.cut(value, _VALUE_LETTERS), kind), animation.shown(from_sec, to_sec))
             for (from_sec, value, kind), to_sec in zip(faces, ends_sec)),
            animation.travel((at_sec, self._layout.ladder_x, y) for at_sec, y in stops))


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
        words = {'asked': f'set {name} to {svg.cut(asked, 24)}', 'checks': 'declared, not locked, type, range, step',
                 'stored': f'{svg.cut(value, 24)} is written', 'event': 'a message tells everybody',
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
            told.append(f'{step.who} gives {svg.cut(step.proposed, 20)}' if step.proposed else step.happened)
        else:
            told.append(f'{step.who} acts on {svg.cut(step.proposed, 20)}')
    return '; '.join(told) or 'there is none'

