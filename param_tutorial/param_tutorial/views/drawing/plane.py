"""Two parameters that depend on each other, as a plane: each point is a pair of values, and a rule parts the plane."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram, Moving

_TOP, _SIDE, _BOTTOM = 34, 320, 54
_FOOT = _TOP + _SIDE
_LEFT, _WORDS_X = 64, 424
_HEADING, _STEP = 66, 44
_BEGIN_SEC, _MOVE_SEC, _STAY_SEC = 0.5, 0.9, 0.8
_MARK = 3.2
_LETTERS = 38

Point = tuple[float, float]
# In words, the pair that was asked for, and the pair that the node had afterwards.
Step = tuple[str, Point, Point]


@dataclass(frozen=True)
class Way:
    """A sequence of requests."""

    name: str
    start: Point
    steps: Sequence[Step]


def draw_plane(names: Sequence[str], answers: Mapping[Point, bool], ways: Sequence[Way]) -> Diagram:
    """Draw which pairs of values a node takes, and the ways that requests go; at rest all requests are there.

    :param names: The parameter to the right, and the one upward.
    :param answers: Pairs that the node was asked for, and whether it took them; they differ in both values.
    """
    taken = f'The node takes {sum(answers.values())} of {len(answers)} pairs.'
    ends = '; '.join(f'{way.name}: ends at {_pair(way.steps[-1][2])}' for way in ways)
    lines = [f'{way.name}, from {_pair(way.start)}: '
             + ', '.join(f'{words} {"is accepted" if wanted == had else "is rejected"}, now {_pair(had)}'
                         for words, wanted, had in way.steps) + '.' for way in ways]
    words_height = sum(_HEADING + _STEP * len(way.steps) for way in ways)
    diagram = Diagram(' and '.join(names), f'{ends}.' if ways else taken,
                      ' '.join([f'{names[0]} to the right and {names[1]} upward.', taken, *lines]),
                      max(_FOOT + _BOTTOM, _TOP + words_height + 36))
    points = [*answers]
    for way in ways:
        points += [way.start, *(wanted for _, wanted, _ in way.steps)]
    ranges = [(min(values), max(values)) for values in zip(*points, strict=True)]

    def at(point: Point) -> Point:
        """Return where a pair stands in the picture."""
        right, up = ((value - low) / (high - low) for value, (low, high) in zip(point, ranges, strict=True))
        return _LEFT + 14 + right * (_SIDE - 28), _FOOT - 14 - up * (_SIDE - 28)

    diagram.add(svg.box(_LEFT, _TOP, _SIDE, _SIDE, 'blank', rounding=2),
                *(_mark(*at(point), is_taken) for point, is_taken in answers.items()))
    _add_axes(diagram, names, answers, at)
    begin_sec, y = _BEGIN_SEC, _TOP + 16.0
    for way in ways:
        _add_way(diagram, way, begin_sec, y, at, is_first=way is ways[0])
        begin_sec += _STAY_SEC + len(way.steps) * (_MOVE_SEC + _STAY_SEC)
        y += _HEADING + _STEP * len(way.steps)
    diagram.add(*(svg.circle(x, y, 8, 'dot') for x, y in {at(way.start): None for way in ways}))
    return diagram


def _add_axes(diagram: Diagram, names: Sequence[str], points: Iterable[Point], at: Callable[[Point], Point]) -> None:
    rights, ups = (sorted(set(values)) for values in zip(*points, strict=True))
    for value in rights:
        x, _ = at((value, ups[0]))
        diagram.add(svg.path(f'M{x:.1f} {_FOOT}v4'), svg.words(x, _FOOT + 18, f'{value:g}'))
    for value in ups:
        _, y = at((rights[0], value))
        diagram.add(svg.path(f'M{_LEFT} {y:.1f}h-4'), svg.words(_LEFT - 8, y + 4.5, f'{value:g}', anchor='end'))
    diagram.add(svg.words(_LEFT + _SIDE / 2, _FOOT + 40, f'{names[0]} →', 'bold'),
                svg.words(_LEFT, _TOP - 12, f'↑ {names[1]}', 'bold'))
    for below, is_taken, words in ((-22, True, 'the node takes this pair'), (-2, False, 'the node rejects it')):
        diagram.add(_mark(_WORDS_X + 10, _FOOT + below - 4, is_taken),
                    svg.words(_WORDS_X + 30, _FOOT + below, words, anchor='start'))


def _add_way(diagram: Diagram, way: Way, begin_sec: float, y: float, at: Callable[[Point], Point], *,
             is_first: bool) -> None:
    """Add one sequence of requests: its label, an arrow for each request, and a marker that moves along them."""
    kind = 'dashed' if is_first else 'thick'
    diagram.show(begin_sec - .2, svg.path(f'M{_WORDS_X} {y - 4}h34', kind),
                 svg.words(_WORDS_X + 44, y + 1, way.name, 'big', anchor='start'))
    here, leaves_sec, stops = way.start, begin_sec + _STAY_SEC, []
    for words, wanted, had in way.steps:
        there_sec, is_taken = leaves_sec + _MOVE_SEC, wanted == had
        y += _STEP
        stops += [(leaves_sec, *at(here)), (there_sec, *at(wanted))]
        if not is_taken:
            stops.append((there_sec + .4, *at(had)))  # it springs back
        answer = f'{"accepted" if is_taken else "rejected"}: now {_pair(had)}'
        diagram.show(there_sec - .15,
                     svg.arrow(*at(here), *at(wanted), kind) if is_taken else svg.cross(*at(wanted), 9),
                     svg.check(_WORDS_X + 10, y - 5) if is_taken else svg.cross(_WORDS_X + 10, y - 5),
                     svg.words(_WORDS_X + 30, y, svg.cut(words, _LETTERS), 'code', anchor='start'),
                     svg.words(_WORDS_X + 30, y + 17, answer, 'small', anchor='start'))
        here, leaves_sec = had, there_sec + _STAY_SEC
    name = svg.words(0, -14 if is_first else 26, way.name, 'bold over')
    diagram.add(Moving(svg.circle(0, 0, 8) + name, stops, from_sec=0 if is_first else begin_sec))


def _mark(x: float, y: float, is_taken: bool) -> str:
    """Return a ring for a pair that the node takes, and a cross for a pair that it rejects."""
    return svg.circle(x, y, _MARK, 'line') if is_taken else svg.cross(x, y, _MARK, 'line faint')


def _pair(point: Point) -> str:
    return f'({point[0]:g}, {point[1]:g})'
