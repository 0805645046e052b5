"""Two lifts, or more, that rise beside each other at the speeds of their nodes."""

import itertools
from collections.abc import Mapping, Sequence

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram, Moving, Part, Seen

_TOP, _SHAFT, _BOTTOM = 44, 236, 74
_FOOT = _TOP + _SHAFT
_AXIS_X, _RIGHT = 64, 706
_CABIN_WIDTH, _CABIN_HEIGHT = 92, 22
# Slow enough that a mark can be read before the next one comes.
_SLOWER = 2.0
_BEGIN_SEC = 0.6

Points = Sequence[tuple[float, float]]
"""Points in time in s and a lift's height there in m; in between it rises evenly."""


def draw_lifts(heights: Mapping[str, Points], marks: Mapping[float, str]) -> Diagram:
    """Draw the heights of lifts over time, as lifts; at rest each is where it ends.

    LiftsView explains the arguments.
    """
    marks = dict(sorted(marks.items()))
    end = max(points[-1][0] for points in heights.values())
    most = max(height for points in heights.values() for _, height in points) or 1.0
    ends = ', '.join(f'{name} at {points[-1][1]:.2f} m' for name, points in heights.items())
    sentence = f'After {end:g} s: {ends}.'
    lines = [f'{name} rises: ' + ', '.join(f'{height:.2f} m at {at:g} s' for at, height in points) + '.'
             for name, points in heights.items()]
    lines += [f'At {at:g} s: {words}.' for at, words in marks.items()]
    diagram = Diagram(' and '.join(heights), sentence, ' '.join(['Lifts beside each other.', *lines, sentence]),
                      _FOOT + _BOTTOM)
    step = next(each for each in (.01, .02, .05, .1, .2, .5, 1, 2, 5, 10, 20, 50, 100, 1e9) if most / each <= 7)
    for number in range(int(most / step + 1e-6) + 1):
        y = _y(number * step, most)
        diagram.add(svg.path(f'M{_AXIS_X} {y:.1f}H{_RIGHT}', 'thin'),
                    svg.words(_AXIS_X - 8, y + 4.5, f'{number * step:g} m', anchor='end'))
    for number, (name, points) in enumerate(heights.items()):
        _add_lift(diagram, _x(number, len(heights)), name, points, most)
    _add_difference(diagram, [points[-1][1] for points in heights.values()], most, _seconds(end))
    _add_clock(diagram, end, marks)
    return diagram


def _y(height: float, most: float) -> float:
    """Return where the floor of a cabin at this height is."""
    return _FOOT - (_SHAFT - 34) * height / most


def _x(number: int, count: int) -> float:
    return _AXIS_X + 20 + (number + .5) * (_RIGHT - _AXIS_X - 20) / count


def _seconds(at: float) -> float:
    """Return when something is seen."""
    return _BEGIN_SEC + _SLOWER * at


def _add_lift(diagram: Diagram, x: float, name: str, points: Points, most: float) -> None:
    half = _CABIN_WIDTH / 2
    diagram.add(svg.path(f'M{x - half - 6} {_FOOT}V{_TOP - 8}M{x + half + 6} {_FOOT}V{_TOP - 8}'
                         f'M{x - half - 16} {_FOOT}H{x + half + 16}', 'thick'), svg.words(x, 24, name, 'big'))
    cabin: list[Part] = [
        svg.box(-half, -_CABIN_HEIGHT, _CABIN_WIDTH, _CABIN_HEIGHT, 'fill', rounding=2),
        svg.path(f'M{-half} 0h{_CABIN_WIDTH}', 'thick'), svg.box(-24, -_CABIN_HEIGHT - 20, 48, 20, 'blank', rounding=1),
        svg.path(f'M-24 {-_CABIN_HEIGHT - 13}h48')]

    def beside(text: str, kind: str) -> str:
        return svg.words(half + 18, 4 - _CABIN_HEIGHT / 2, text, kind, anchor='start')
    # A new speed for each stretch, and the height at the end.
    for (begin, low), (end, high) in itertools.pairwise(points):
        speed = (high - low) / (end - begin) if end > begin else 0.0
        cabin.append(Seen(beside(f'{speed:.1f} m/s', 'bold'), _seconds(begin) if begin else 0, _seconds(end)))
    cabin.append(Seen(beside(f'{points[-1][1]:.2f} m', 'big'), _seconds(points[-1][0])))
    diagram.add(Moving(cabin, [(_seconds(at), x, _y(height, most)) for at, height in points], easing='linear'))


def _add_difference(diagram: Diagram, ends: Sequence[float], most: float, at_sec: float) -> None:
    """Add a line from the highest lift to the lowest, which shows how far apart they are."""
    highest, lowest = max(ends), min(ends)
    if highest - lowest < most / 50:
        return
    high_x, low_x = _x(ends.index(highest), len(ends)), _x(ends.index(lowest), len(ends))
    y, roof, side = _y(highest, most), _y(lowest, most) - _CABIN_HEIGHT, 1 if low_x > high_x else -1
    diagram.show(at_sec,
                 svg.path(f'M{high_x + side * (_CABIN_WIDTH / 2 + 8)} {y}H{low_x + side * (_CABIN_WIDTH / 2 + 6)}'),
                 svg.arrow(low_x - 34, roof - 4, low_x - 34, y + 2),
                 svg.words(low_x - 24, (y + roof) / 2 - 5, f'{highest - lowest:.2f} m', 'big', anchor='start'))


def _add_clock(diagram: Diagram, end: float, marks: Mapping[float, str]) -> None:
    y, end_x = _FOOT + 26, _RIGHT - 12

    def x_of(at: float) -> float:
        return _AXIS_X + (end_x - _AXIS_X) * at / end
    diagram.add(svg.path(f'M{_AXIS_X} {y}H{end_x}'))
    for second in range(int(end) + 1):
        diagram.add(svg.path(f'M{x_of(second):.1f} {y - 5}v10'), svg.words(x_of(second), y - 9, f'{second} s', 'small'))
    for at, words in marks.items():
        # Toward the end there is room on the left only.
        anchor, beside = ('start', 6) if at < .6 * end else ('end', -6)
        diagram.show(_seconds(at), svg.path(f'M{x_of(at):.1f} {y - 5}v20', 'thick'),
                     svg.words(x_of(at) + beside, y + 22, words, 'bold', anchor=anchor))
    diagram.add(Moving(svg.circle(0, 0, 6), [(_seconds(0), _AXIS_X, y), (_seconds(end), end_x, y)], easing='linear'),
                svg.words(_AXIS_X, y + 40, f'{_SLOWER:g} times slower than it was', 'small', anchor='start'))
