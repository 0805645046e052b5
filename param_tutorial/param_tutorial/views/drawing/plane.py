"""Two parameters that depend on each other, as a plane: each point is a pair of values, and a rule parts the plane."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_TOP, _SIDE, _BOTTOM = 34, 320, 54
_FOOT = _TOP + _SIDE
_LEFT, _WORDS_X = 64, 424
_HEADING, _STEP = 66, 44
_BEGIN_SEC, _MOVE_SEC, _STAY_SEC = 0.5, 0.9, 0.8
_MARK = 3.2
_LETTERS = 38
_MOST_TICKS = 11

Point = tuple[float, float]
# In words, the pair that was asked for, and the pair that the node had afterwards.
Step = tuple[str, Point, Point]


@dataclass(frozen=True)
class _Way:
    """Requests that follow each other."""

    name: str
    start: Point
    steps: tuple[Step, ...]


class Plane(svg.AnimatedPicture):
    """Which pairs of values a node takes, and the ways that requests go; at rest all requests of all ways are there."""

    def __init__(self, names: tuple[str, str], answers: Mapping[Point, bool]) -> None:
        """
        :param names: The parameter to the right, and the one upward.
        :param answers: Pairs that the node was asked for, and whether it took them; they differ in both values.
        """
        self.subject = ' and '.join(names)
        self._names, self._answers = names, dict(answers)
        self._ways: list[_Way] = []

    def add_way(self, name: str, start: Point, steps: Sequence[Step]) -> None:
        """Add a way.

        :param start: The pair with which it begins.
        :param steps: Its requests: in words, the pair that was asked for, and the pair that the node had afterwards.
        """
        self._ways.append(_Way(name, start, tuple(steps)))

    @property
    def _ends(self) -> list[tuple[float, float]]:
        """The lowest and the highest value of each axis."""
        points = [*self._answers]
        for way in self._ways:
            points += [way.start, *(wanted for _, wanted, _ in way.steps)]
        return [(min(values), max(values)) for values in zip(*points, strict=True)]

    @property
    def sentence(self) -> str:
        if not self._ways:
            return f'The node takes {sum(self._answers.values())} of {len(self._answers)} pairs.'
        return '; '.join(f'{way.name}: ends at {_pair(way.steps[-1][2])}' for way in self._ways) + '.'

    @property
    def text(self) -> str:
        lines = [f'{way.name}, from {_pair(way.start)}: '
                 + ', '.join(f'{words} {"is accepted" if wanted == had else "is rejected"}, now {_pair(had)}'
                             for words, wanted, had in way.steps) + '.' for way in self._ways]
        return ' '.join([f'{self._names[0]} to the right and {self._names[1]} upward. The node takes '
                         f'{sum(self._answers.values())} of {len(self._answers)} pairs.', *lines])

    @property
    def _height(self) -> float:
        words = sum(_HEADING + _STEP * len(way.steps) for way in self._ways)
        return max(_FOOT + _BOTTOM, _TOP + words + 36)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        yield svg.box(_LEFT, _TOP, _SIDE, _SIDE, 'blank', rounding=2)
        for point, is_taken in self._answers.items():
            yield _mark(*self._at(point), is_taken)
        yield from self._axes()
        begin_sec, y = _BEGIN_SEC, _TOP + 16.0
        for number, way in enumerate(self._ways):
            yield from self._way(way, begin_sec, y, animation, is_first=number == 0)
            begin_sec += _STAY_SEC + len(way.steps) * (_MOVE_SEC + _STAY_SEC)
            y += _HEADING + _STEP * len(way.steps)
        for x, y in {self._at(way.start): None for way in self._ways}:
            yield svg.circle(x, y, 8, 'dot')

    def _at(self, point: Point) -> Point:
        """Return where a pair stands in the picture."""
        right, up = ((value - low) / (high - low) for value, (low, high) in zip(point, self._ends, strict=True))
        return _LEFT + 14 + right * (_SIDE - 28), _FOOT - 14 - up * (_SIDE - 28)

    def _axes(self) -> Iterator[str]:
        (left, _), (low, _) = self._ends
        for value in _ticks(point[0] for point in self._answers):
            x, _ = self._at((value, low))
            yield svg.path(f'M{x:.1f} {_FOOT}v4') + svg.words(x, _FOOT + 18, f'{value:g}')
        for value in _ticks(point[1] for point in self._answers):
            _, y = self._at((left, value))
            yield svg.path(f'M{_LEFT} {y:.1f}h-4') + svg.words(_LEFT - 8, y + 4.5, f'{value:g}', anchor='end')
        yield svg.words(_LEFT + _SIDE / 2, _FOOT + 40, f'{self._names[0]} →', 'bold')
        yield svg.words(_LEFT, _TOP - 12, f'↑ {self._names[1]}', 'bold')
        for y, is_taken, told in ((-22, True, 'the node takes this pair'), (-2, False, 'the node rejects it')):
            yield _mark(_WORDS_X + 10, _FOOT + y - 4, is_taken)
            yield svg.words(_WORDS_X + 30, _FOOT + y, told, anchor='start')

    def _way(self, way: _Way, begin_sec: float, y: float, animation: svg.Animation, *, is_first: bool) -> Iterator[str]:
        """Yield a way: what is asked, where its arrows go, and a marker that comes with it and goes it."""
        kind = 'dashed' if is_first else 'thick'
        yield svg.group([svg.path(f'M{_WORDS_X} {y - 4}h34', kind),
                         svg.words(_WORDS_X + 44, y + 1, way.name, 'big', anchor='start')],
                        animation.appear(begin_sec - .2))
        at, leaves_sec, stops = way.start, begin_sec + _STAY_SEC, []
        for told, wanted, had in way.steps:
            there_sec, is_taken = leaves_sec + _MOVE_SEC, wanted == had
            y += _STEP
            stops += [(leaves_sec, *self._at(at)), (there_sec, *self._at(wanted))]
            if is_taken:
                parts = [svg.arrow(*self._at(at), *self._at(wanted), kind), svg.check(_WORDS_X + 10, y - 5)]
            else:
                stops.append((there_sec + .4, *self._at(had)))  # it springs back
                parts = [svg.cross(*self._at(wanted), 9), svg.cross(_WORDS_X + 10, y - 5)]
            answer = f'{"accepted" if is_taken else "rejected"}: now {_pair(had)}'
            parts += [svg.words(_WORDS_X + 30, y, svg.cut(told, _LETTERS), 'code', anchor='start'),
                      svg.words(_WORDS_X + 30, y + 17, answer, 'small', anchor='start')]
            yield svg.group(parts, animation.appear(there_sec - .15))
            at, leaves_sec = had, there_sec + _STAY_SEC
        name = svg.words(0, -14 if is_first else 26, way.name, 'bold over')
        yield svg.group([svg.circle(0, 0, 8), name], animation.travel(stops, from_sec=0 if is_first else begin_sec))


def _mark(x: float, y: float, is_taken: bool) -> str:
    """Return a ring for a pair that the node takes, and a cross for a pair that it rejects."""
    return svg.circle(x, y, _MARK, 'line') if is_taken else svg.cross(x, y, _MARK, 'line faint')


def _ticks(values: Iterable[float]) -> list[float]:
    """Return which values of an axis stand beside it: all if there is room, and otherwise both ends."""
    ordered = sorted(set(values))
    return ordered if len(ordered) <= _MOST_TICKS else [ordered[0], ordered[-1]]


def _pair(point: Point) -> str:
    return f'({point[0]:g}, {point[1]:g})'
