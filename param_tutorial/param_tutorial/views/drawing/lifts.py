"""Two lifts, or more, that rise beside each other at the speeds of their nodes."""

import itertools
from collections.abc import Iterator, Mapping, Sequence

from param_tutorial.views.drawing import svg

_TOP, _SHAFT, _BOTTOM = 44, 236, 74
_AXIS_X, _RIGHT = 64, 706
_CABIN_WIDTH, _CABIN_HEIGHT = 92, 22
# Slow enough that a mark can be read before the next one comes.
_SLOWER = 2.0
_BEGIN_SEC = 0.6


class Lifts(svg.AnimatedPicture):
    """The heights of lifts over time, as lifts; at rest each is where it ends. LiftsView explains the arguments."""

    _height = _TOP + _SHAFT + _BOTTOM

    def __init__(self, heights: Mapping[str, Sequence[tuple[float, float]]],
                 marks: Mapping[float, str] | None = None) -> None:
        self.subject = ' and '.join(heights)
        self._heights = {name: [(float(at), float(height)) for at, height in points]
                         for name, points in heights.items()}
        self._marks = dict(sorted((marks or {}).items()))
        self._end = max(points[-1][0] for points in self._heights.values())
        self._most = max(height for points in self._heights.values() for _, height in points) or 1.0

    @property
    def sentence(self) -> str:
        ends = ', '.join(f'{name} at {points[-1][1]:.2f} m' for name, points in self._heights.items())
        return f'After {self._end:g} s: {ends}.'

    @property
    def text(self) -> str:
        lines = [f'{name} rises: ' + ', '.join(f'{height:.2f} m at {at:g} s' for at, height in points) + '.'
                 for name, points in self._heights.items()]
        marks = [f'At {at:g} s: {words}.' for at, words in self._marks.items()]
        return ' '.join(['Lifts beside each other.', *lines, *marks, self.sentence])

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        step = next(each for each in (.01, .02, .05, .1, .2, .5, 1, 2, 5, 10, 20, 50, 100, 1e9)
                    if self._most / each <= 7)
        for number in range(int(self._most / step + 1e-6) + 1):
            y = self._y(number * step)
            yield svg.path(f'M{_AXIS_X} {y:.1f}H{_RIGHT}', 'thin')
            yield svg.words(_AXIS_X - 8, y + 4.5, f'{number * step:g} m', anchor='end')
        for number, (name, points) in enumerate(self._heights.items()):
            yield from self._lift(self._x(number), name, points, animation)
        yield from self._difference(animation)
        yield from self._clock(animation)

    def _y(self, height: float) -> float:
        """Return where the floor of a cabin at this height is."""
        return _TOP + _SHAFT - (_SHAFT - 34) * height / self._most

    def _x(self, number: int) -> float:
        return _AXIS_X + 20 + (number + .5) * (_RIGHT - _AXIS_X - 20) / len(self._heights)

    @staticmethod
    def _seconds(at: float) -> float:
        """Return when something is seen."""
        return _BEGIN_SEC + _SLOWER * at

    def _lift(self, x: float, name: str, points: list[tuple[float, float]], animation: svg.Animation) -> Iterator[str]:
        half, foot = _CABIN_WIDTH / 2, self._y(0)
        yield svg.path(f'M{x - half - 6} {foot}V{_TOP - 8}M{x + half + 6} {foot}V{_TOP - 8}'
                       f'M{x - half - 16} {foot}H{x + half + 16}', 'thick')
        yield svg.words(x, 24, name, 'big')
        cabin = [svg.box(-half, -_CABIN_HEIGHT, _CABIN_WIDTH, _CABIN_HEIGHT, 'fill', rounding=2),
                 svg.path(f'M{-half} 0h{_CABIN_WIDTH}', 'thick'),
                 svg.box(-24, -_CABIN_HEIGHT - 20, 48, 20, 'blank', rounding=1),
                 svg.path(f'M-24 {-_CABIN_HEIGHT - 13}h48')]

        def beside(text: str, kind: str, style: str) -> str:
            return svg.words(half + 18, 4 - _CABIN_HEIGHT / 2, text, kind, anchor='start', style=style)
        # A new speed for each stretch, and the height at the end.
        for index, ((begin, low), (end, high)) in enumerate(itertools.pairwise(points)):
            speed = (high - low) / (end - begin) if end > begin else 0.0
            cabin.append(beside(f'{speed:.1f} m/s', 'bold', animation.shown(
                self._seconds(begin) if index else 0, self._seconds(end))))
        cabin.append(beside(f'{points[-1][1]:.2f} m', 'big', animation.appear(self._seconds(self._end))))
        yield svg.group(cabin, animation.travel(((self._seconds(at), x, self._y(high)) for at, high in points),
                                                'linear'))

    def _difference(self, animation: svg.Animation) -> Iterator[str]:
        """Yield a line from the highest lift to the lowest, which shows how far apart they are."""
        ends = [points[-1][1] for points in self._heights.values()]
        highest, lowest = max(ends), min(ends)
        if len(ends) < 2 or highest - lowest < self._most / 50:
            return
        high_x, low_x = self._x(ends.index(highest)), self._x(ends.index(lowest))
        y, roof = self._y(highest), self._y(lowest) - _CABIN_HEIGHT
        side = 1 if low_x > high_x else -1
        yield svg.group([
            svg.path(f'M{high_x + side * (_CABIN_WIDTH / 2 + 8)} {y}H{low_x + side * (_CABIN_WIDTH / 2 + 6)}'),
            svg.arrow(low_x - 34, roof - 4, low_x - 34, y + 2),
            svg.words(low_x - 24, (y + roof) / 2 - 5, f'{highest - lowest:.2f} m', 'big', anchor='start')],
            animation.appear(self._seconds(self._end)))

    def _clock(self, animation: svg.Animation) -> Iterator[str]:
        y, end_x = _TOP + _SHAFT + 26, _RIGHT - 12

        def x_of(at: float) -> float:
            return _AXIS_X + (end_x - _AXIS_X) * at / self._end
        yield svg.path(f'M{_AXIS_X} {y}H{end_x}')
        for second in range(int(self._end) + 1):
            yield svg.path(f'M{x_of(second):.1f} {y - 5}v10')
            yield svg.words(x_of(second), y - 9, f'{second} s', 'small')
        for at, words in self._marks.items():
            # Toward the end there is room on the left only.
            anchor, beside = ('start', 6) if at < .6 * self._end else ('end', -6)
            yield svg.group([svg.path(f'M{x_of(at):.1f} {y - 5}v20', 'thick'),
                             svg.words(x_of(at) + beside, y + 22, words, 'bold', anchor=anchor)],
                            animation.appear(self._seconds(at)))
        yield svg.group(svg.circle(0, 0, 6), animation.travel(
            [(self._seconds(0), _AXIS_X, y), (self._seconds(self._end), end_x, y)], 'linear'))
        yield svg.words(_AXIS_X, y + 40, f'{_SLOWER:g} times slower than it was', 'small', anchor='start')
