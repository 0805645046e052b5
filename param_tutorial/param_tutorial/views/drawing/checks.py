"""The checks that a request goes through, one after another, and the first one that stops it."""

import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_HEAD, _ROW, _BOTTOM = 48, 42, 8
_WORDS_X, _GATES_X, _PITCH, _STORED_X = 14, 212, 84, 708
_WORDS_LETTERS, _VALUE_LETTERS = 15, 6
_BEGIN_SEC, _READ_SEC, _GATE_SEC, _STAY_SEC = 0.3, 0.4, 0.25, 0.5

# In rclpy's order: what stands above a gate, and the kinds of answers that come from there.
_GATES = (('declared', ('undeclared',)), ('read-only', ('read only',)), ('type', ('wrong type', 'not deletable')),
          ('range', ('out of range',)), ('step', ('off the step',)), ('on-set callbacks', ('rejected by the node',)))
# How many gates let a request through, by the kind of its answer.
_PASSED = {kind: number for number, (_, kinds) in enumerate([*_GATES, ('stored', ('accepted',))]) for kind in kinds}


@dataclass(frozen=True)
class _Request:
    name: str
    value: str
    kind: str
    passed: int
    """How many gates let it through."""

    @property
    def is_stored(self) -> bool:
        return self.passed == len(_GATES)

    @property
    def words(self) -> str:
        return f'{self.name} = {self.value}'

    @property
    def text(self) -> str:
        if self.is_stored:
            return f'{self.words} passes all checks and is stored'
        before = ', '.join(title for title, _ in _GATES[:self.passed])
        return (f'{self.words} ' + (f'passes {before}, and ' if before else '')
                + f'is stopped at {_GATES[self.passed][0]}: {self.kind}')

    @property
    def duration_sec(self) -> float:
        """How long its way takes."""
        return _READ_SEC + (self.passed + .2) * _GATE_SEC


class Checks(svg.AnimatedPicture):
    """Requests on their way through the checks; at rest each stands before the gate that has stopped it."""

    _width = 748

    def __init__(self, node: str, requests: Iterable[tuple[str, str, str]]) -> None:
        """:param requests: Names, values as text, and kinds of answers (``SetResult.kind``)."""
        self.subject = node
        self._requests = [_Request(name, value, kind, _PASSED[kind]) for name, value, kind in requests]

    @property
    def sentence(self) -> str:
        return f'{sum(each.is_stored for each in self._requests)} of {len(self._requests)} get through all checks.'

    @property
    def text(self) -> str:
        order = ', '.join(title for title, _ in _GATES)
        return f'Checks in their order: {order}. {". ".join(request.text for request in self._requests)}.'

    @property
    def _height(self) -> float:
        return _HEAD + len(self._requests) * _ROW + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, (title, _) in enumerate(_GATES):
            yield svg.paragraph(_gate_x(number), 27, textwrap.wrap(title, 9), 'bold')
            yield svg.path(f'M{_gate_x(number)} {_HEAD - 4}V{self._height - _BOTTOM}', 'thin')
        yield svg.words(_STORED_X, 27, 'stored', 'bold')
        begin_sec = _BEGIN_SEC
        for number, request in enumerate(self._requests):
            yield from _row(_HEAD + (number + .5) * _ROW, request, begin_sec, animation)
            begin_sec += request.duration_sec + _STAY_SEC


def _row(y: float, request: _Request, begin_sec: float, animation: svg.Animation) -> Iterator[str]:
    leaves_sec, there_sec = begin_sec + _READ_SEC, begin_sec + request.duration_sec
    # The value travels; so the name alone will do where both are too long.
    told = request.words if len(request.words) <= _WORDS_LETTERS else svg.cut(request.name, _WORDS_LETTERS)
    yield svg.words(_WORDS_X, y - 2, told, 'code', anchor='start', style=animation.appear(begin_sec))
    yield svg.words(_WORDS_X, y + 14, request.kind, 'small', anchor='start', style=animation.appear(there_sec))
    for number in range(request.passed):
        yield svg.group(svg.check(_gate_x(number), y), animation.appear(leaves_sec + (number + .6) * _GATE_SEC))
    end_x: float = _STORED_X
    if not request.is_stored:
        yield svg.group(svg.cross(_gate_x(request.passed), y), animation.appear(there_sec))
        end_x = _gate_x(request.passed) - _PITCH / 2 - 1
    kind = 'token' if request.is_stored else 'token-bad'
    yield svg.group(svg.token(svg.cut(request.value, _VALUE_LETTERS), kind), animation.travel(
        [(leaves_sec, _gate_x(0) - _PITCH / 2 - 1, y), (there_sec, end_x, y)], 'linear', from_sec=begin_sec))


def _gate_x(number: int) -> int:
    return _GATES_X + number * _PITCH
