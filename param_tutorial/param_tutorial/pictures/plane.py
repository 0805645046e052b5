"""Two parameters that depend on each other, as a plane: each point is a pair of values, and a rule parts the plane."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.pictures import motion

_WIDTH, _TOP, _SIDE, _BOTTOM = 720, 34, 320, 54
_LEFT, _WORDS_X = 64, 424
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


class Plane:
    """Which pairs of values a node takes, and the ways that requests go."""

    def __init__(self, names: tuple[str, str], answers: Mapping[Point, bool]) -> None:
        """
        :param names: The parameter to the right, and the one upward.
        :param answers: Pairs that the node was asked for, and whether it took them.
        :raises ValueError: no pair was asked for, or all in one line.
        """
        self.subject = ' and '.join(names)
        self._names, self._answers = names, dict(answers)
        self._ways: list[_Way] = []
        if any(low == high for low, high in self._ends):
            raise ValueError('a Plane takes pairs that differ in both values')

    def add_way(self, name: str, start: Point, steps: Sequence[Step]) -> None:
        """Add a way.

        :param start: The pair with which it begins.
        :param steps: Its requests: in words, the pair that was asked for, and the pair that the node had afterwards.
        :raises ValueError: there is no step.
        """
        if not steps:
            raise ValueError('a way takes one step at least')
        self._ways.append(_Way(name, start, tuple(steps)))

    @property
    def _ends(self) -> list[tuple[float, float]]:
        """The lowest and the highest value of each axis."""
        points = [*self._answers]
        for way in self._ways:
            points += [way.start, *(wanted for _, wanted, _ in way.steps)]
        return [(min(values), max(values)) for values in zip(*points, strict=True)] or [(0.0, 0.0)]

    @property
    def sentence(self) -> str:
        """Where the ways end."""
        if not self._ways:
            return f'The node takes {sum(self._answers.values())} of {len(self._answers)} pairs.'
        return '; '.join(f'{way.name}: ends at {_pair(way.steps[-1][2])}' for way in self._ways) + '.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        taken = sum(self._answers.values())
        lines = [f'{way.name}, from {_pair(way.start)}: '
                 + ', '.join(f'{words} {"is accepted" if wanted == had else "is rejected"}, now {_pair(had)}'
                             for words, wanted, had in way.steps) + '.' for way in self._ways]
        return ' '.join([f'{self._names[0]} to the right and {self._names[1]} upward. The node takes {taken} of '
                         f'{len(self._answers)} pairs.', *lines])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each way stands with all its requests."""
        parts = [*self._map(), *self._axes()]
        begin_sec, y = _BEGIN_SEC, _TOP + 16.0
        for number, way in enumerate(self._ways):
            parts += self._way(number, way, begin_sec, y, reel)
            begin_sec += _STAY_SEC + len(way.steps) * (_MOVE_SEC + _STAY_SEC)
            y += 66 + 44 * len(way.steps)
        for x, y in {self._at(way.start) for way in self._ways}:
            parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="8" class="motion-dot"/>')
        return motion.stage(self.subject, self.sentence, self.text,
                            (_WIDTH, max(_TOP + _SIDE + _BOTTOM, round(y) + 20)), parts, reel)

    def _at(self, point: Point) -> Point:
        """Return where a pair stands in the picture."""
        right, up = ((value - low) / (high - low) for value, (low, high) in zip(point, self._ends, strict=True))
        return _LEFT + 14 + right * (_SIDE - 28), _TOP + _SIDE - 14 - up * (_SIDE - 28)

    def _map(self) -> Iterator[str]:
        """Yield a ring for each pair that the node takes, and a cross for each that it rejects."""
        yield motion.box(_LEFT, _TOP, _SIDE, _SIDE, 'motion-blank', rounding=2)
        for point, is_taken in self._answers.items():
            x, y = self._at(point)
            if is_taken:
                yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{_MARK}" class="motion-line"/>'
            else:
                yield _cross(x, y, _MARK, 'motion-line motion-faint')

    def _axes(self) -> Iterator[str]:
        foot = _TOP + _SIDE
        for low in _ticks(point[0] for point in self._answers):
            x, _ = self._at((low, self._ends[1][0]))
            yield motion.path(f'M{x:.1f} {foot}v4', 'motion-line')
            yield motion.label(x, foot + 18, f'{low:g}')
        for high in _ticks(point[1] for point in self._answers):
            _, y = self._at((self._ends[0][0], high))
            yield motion.path(f'M{_LEFT} {y:.1f}h-4', 'motion-line')
            yield motion.label(_LEFT - 8, y + 4.5, f'{high:g}', anchor='end')
        yield motion.label(_LEFT + _SIDE / 2, foot + 40, f'{self._names[0]} →', css_class='motion-bold')
        yield motion.group([
            f'<circle cx="{_WORDS_X + 10}" cy="{foot - 26}" r="{_MARK}" class="motion-line"/>',
            motion.label(_WORDS_X + 30, foot - 22, 'the node takes this pair', anchor='start'),
            _cross(_WORDS_X + 10, foot - 6, _MARK, 'motion-line motion-faint'),
            motion.label(_WORDS_X + 30, foot - 2, 'the node rejects it', anchor='start')])
        yield motion.label(_LEFT, _TOP - 12, f'↑ {self._names[1]}', css_class='motion-bold')

    def _way(self, number: int, way: _Way, begin_sec: float, y: float, reel: motion.Reel) -> Iterator[str]:
        line = 'motion-thick' if number else 'motion-dashed'
        yield motion.group([motion.path(f'M{_WORDS_X} {y - 4}h34', line),
                            motion.label(_WORDS_X + 44, y + 1, way.name, anchor='start', css_class='motion-big')],
                           reel.appear(begin_sec - .2))
        at, moves = way.start, [(0.0, *self._at(way.start))]
        leaves_sec = begin_sec + _STAY_SEC
        for words, wanted, had in way.steps:
            there_sec = leaves_sec + _MOVE_SEC
            is_taken = wanted == had
            y += 44
            moves += [(leaves_sec, *self._at(at)), (there_sec, *self._at(wanted))]
            parts = []
            if is_taken:
                parts.append(motion.arrow(*self._at(at), *self._at(wanted), line))
            else:
                x, cross_y = self._at(wanted)
                # It springs back.
                moves.append((there_sec + .4, *self._at(had)))
                parts.append(_cross(x, cross_y, 9, 'motion-cross'))
            parts += [motion.path(f'M{_WORDS_X + 4} {y - 5}l4.5 5l8 -11', 'motion-check') if is_taken else
                      _cross(_WORDS_X + 10, y - 5, 6, 'motion-cross'),
                      motion.label(_WORDS_X + 30, y, motion.cut(words, _LETTERS), anchor='start',
                                   css_class='motion-code'),
                      motion.label(_WORDS_X + 30, y + 17, f'{"accepted" if is_taken else "rejected"}: now '
                                   + _pair(had), anchor='start', css_class='motion-small')]
            yield motion.group(parts, reel.appear(there_sec - .15))
            at = had
            leaves_sec = there_sec + _STAY_SEC
        name = motion.label(0, 26 if number else -14, way.name, css_class='motion-bold motion-over')
        yield motion.group(f'<circle r="8" class="motion-fill"/>{name}', self._stays(moves, begin_sec, number, reel))

    def _stays(self, moves: list[tuple[float, float, float]], begin_sec: float, number: int,
               reel: motion.Reel) -> str:
        """Return the look of a marker that comes with its way, goes it, and stays at its end."""
        frames = [(at_sec, f'opacity:1;{motion.place(x, y)}') for at_sec, x, y in moves]
        if number:
            _, x, y = moves[0]
            frames = [(0.0, f'opacity:0;{motion.place(x, y)}'), (begin_sec - .2, f'opacity:0;{motion.place(x, y)}'),
                      (begin_sec, f'opacity:1;{motion.place(x, y)}'), *frames[1:]]
        return reel.track(frames)


def _cross(x: float, y: float, half: float, css_class: str) -> str:
    return motion.path(f'M{x - half:.1f} {y - half:.1f}l{2 * half} {2 * half}'
                       f'M{x + half:.1f} {y - half:.1f}l{-2 * half} {2 * half}', css_class)


def _ticks(values: Iterable[float]) -> list[float]:
    """Return which values of an axis stand beside it: all if there is room, and otherwise both ends."""
    ordered = sorted(set(values))
    return ordered if len(ordered) <= _MOST_TICKS else [ordered[0], ordered[-1]]


def _pair(point: Point) -> str:
    return f'({point[0]:g}, {point[1]:g})'
