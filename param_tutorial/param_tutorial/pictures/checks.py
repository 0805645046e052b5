"""The checks that a request goes through, one after another, and the first one that stops it."""

import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from param_tutorial.pictures import motion

_WIDTH, _HEAD, _ROW, _BOTTOM = 748, 48, 42, 8
_WORDS_X, _GATES_X, _PITCH, _STORED_X = 14, 212, 84, 708
_WORDS_LETTERS, _VALUE_LETTERS = 15, 6
_BEGIN_SEC, _READ_SEC, _GATE_SEC, _STAY_SEC = 0.3, 0.4, 0.25, 0.5

# In rclpy's order: what stands above a gate, and the kinds of answers that come from there.
_GATES = (('declared', ('undeclared',)), ('read-only', ('read only',)), ('type', ('wrong type', 'not deletable')),
          ('range', ('out of range',)), ('step', ('off the step',)), ('on-set callbacks', ('rejected by the node',)))


@dataclass(frozen=True)
class _Request:
    name: str
    value: str
    gate: int | None
    """The number of the gate that stops it; None if it gets through."""
    kind: str

    @property
    def words(self) -> str:
        return f'{self.name} = {self.value}'

    @property
    def text(self) -> str:
        if self.gate is None:
            return f'{self.words} passes all checks and is stored'
        before = [title for title, _ in _GATES[:self.gate]]
        return (f'{self.words} ' + (f'passes {", ".join(before)}, and ' if before else '')
                + f'is stopped at {_GATES[self.gate][0]}: {self.kind}')


class Checks:
    """Requests on their way through the checks. ChecksView (``widgets.pictured``) explains the arguments."""

    def __init__(self, node: str, requests: Iterable[tuple[str, str, str]]) -> None:
        """
        :param requests: Names, values as text, and kinds of answers (``SetResult.kind``).
        :raises ValueError: there is no request, or no such kind.
        """
        self.subject = node
        self._requests = [_Request(name, value, _gate_of(kind), kind) for name, value, kind in requests]
        if not self._requests:
            raise ValueError('Checks takes one request at least')

    @property
    def sentence(self) -> str:
        """How many get through."""
        stored = sum(request.gate is None for request in self._requests)
        return f'{stored} of {len(self._requests)} get through all checks.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        order = ', '.join(title for title, _ in _GATES)
        return f'Checks in their order: {order}. {". ".join(request.text for request in self._requests)}.'

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each request stands before the gate that has stopped it."""
        height = _HEAD + len(self._requests) * _ROW + _BOTTOM
        parts = list(self._gates(height))
        begin_sec = _BEGIN_SEC
        for number, request in enumerate(self._requests):
            parts += self._row(_HEAD + (number + .5) * _ROW, request, begin_sec, reel)
            begin_sec = _arrival(request, begin_sec) + _STAY_SEC
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    @staticmethod
    def _gates(height: int) -> Iterator[str]:
        for number, (title, _) in enumerate(_GATES):
            yield from _heading(_gate_x(number), title)
            yield motion.path(f'M{_gate_x(number)} {_HEAD - 4}V{height - _BOTTOM}', 'motion-thin')
        yield from _heading(_STORED_X, 'stored')

    @staticmethod
    def _row(y: float, request: _Request, begin_sec: float, reel: motion.Reel) -> Iterator[str]:
        reached = len(_GATES) if request.gate is None else request.gate
        leaves_sec, there_sec = begin_sec + _READ_SEC, _arrival(request, begin_sec)
        # The value travels; so the name alone will do where both are too long.
        words = request.words if len(request.words) <= _WORDS_LETTERS else motion.cut(request.name, _WORDS_LETTERS)
        yield motion.group(motion.label(_WORDS_X, y - 2, words, anchor='start', css_class='motion-code'),
                           reel.appear(begin_sec))
        yield motion.group(motion.label(_WORDS_X, y + 14, request.kind, anchor='start', css_class='motion-small'),
                           reel.appear(there_sec))
        for number in range(reached):
            yield motion.group(motion.path(f'M{_gate_x(number) - 6} {y}l4 5l8 -10', 'motion-check'),
                               reel.appear(leaves_sec + (number + .6) * _GATE_SEC))
        is_stopped = request.gate is not None
        if is_stopped:
            x = _gate_x(reached)
            yield motion.group(motion.path(f'M{x - 6} {y - 6}l12 12M{x + 6} {y - 6}l-12 12', 'motion-cross'),
                               reel.appear(there_sec))
        start_x, end_x = _before_gate(0), _before_gate(reached) if is_stopped else _STORED_X
        token = motion.token(motion.cut(request.value, _VALUE_LETTERS),
                             css_class='motion-token-bad' if is_stopped else 'motion-token')
        yield motion.group(motion.group(token, reel.shown(begin_sec)), reel.travel(
            [(0.0, start_x, y), (leaves_sec, start_x, y), (there_sec, end_x, y)], 'linear'))


def _gate_of(kind: str) -> int | None:
    if kind == 'accepted':
        return None
    for number, (_, kinds) in enumerate(_GATES):
        if kind in kinds:
            return number
    raise ValueError(f'no check answers {kind!r}')


def _gate_x(number: int) -> int:
    return _GATES_X + number * _PITCH


def _before_gate(number: int) -> float:
    return _gate_x(number) - _PITCH / 2 - 1


def _arrival(request: _Request, begin_sec: float) -> float:
    """Return when a request has come to its end."""
    gates = len(_GATES) if request.gate is None else request.gate
    return begin_sec + _READ_SEC + (gates + .2) * _GATE_SEC


def _heading(x: float, title: str) -> Iterator[str]:
    lines = textwrap.wrap(title, 9)
    for number, line in enumerate(lines):
        yield motion.label(x, 27 + 16 * (number - (len(lines) - 1) / 2), line, css_class='motion-bold')
