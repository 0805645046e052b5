"""Two lifts, or more, that rise beside each other at the speeds of their nodes."""

import itertools
from collections.abc import Iterator, Mapping, Sequence

from param_tutorial.pictures import motion

_WIDTH, _TOP, _SHAFT, _BOTTOM = 720, 44, 236, 74
_AXIS_X, _RIGHT = 64, 706
_CABIN_WIDTH, _CABIN_HEIGHT = 92, 22
# Slow enough that one can read a mark before the next one comes.
_SLOWER = 2.0
_BEGIN_SEC = 0.6


class Lifts:
    """The heights of lifts over time, as lifts. LiftsView (``widgets.pictured``) explains the arguments."""

    def __init__(self, heights: Mapping[str, Sequence[tuple[float, float]]],
                 marks: Mapping[float, str] | None = None) -> None:
        if not heights or any(len(points) < 2 for points in heights.values()):
            raise ValueError('Lifts takes one lift at least, and two points for each')
        self.subject = ' and '.join(heights)
        self._heights = {name: [(float(at), float(height)) for at, height in points]
                         for name, points in heights.items()}
        self._marks = dict(sorted((marks or {}).items()))
        self._end = max(points[-1][0] for points in self._heights.values())
        if self._end <= 0:
            raise ValueError('no time passes in these Lifts')
        self._most = max(height for points in self._heights.values() for _, height in points) or 1.0

    @property
    def sentence(self) -> str:
        """Where they are in the end."""
        ends = ', '.join(f'{name} at {points[-1][1]:.2f} m' for name, points in self._heights.items())
        return f'After {self._end:g} s: {ends}.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        lines = [f'{name} rises: ' + ', '.join(f'{height:.2f} m at {at:g} s' for at, height in points) + '.'
                 for name, points in self._heights.items()]
        marks = [f'At {at:g} s: {words}.' for at, words in self._marks.items()]
        return ' '.join(['Lifts beside each other.', *lines, *marks, self.sentence])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each lift is where it is in the end."""
        height = _TOP + _SHAFT + _BOTTOM
        parts = [*self._scale()]
        for number, (name, points) in enumerate(self._heights.items()):
            parts += self._lift(number, name, points, reel)
        parts += self._difference(reel)
        parts += self._clock(reel)
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    def _y(self, height: float) -> float:
        """Return where the floor of a cabin at this height is."""
        return _TOP + _SHAFT - (_SHAFT - 34) * height / self._most

    @staticmethod
    def _seconds(at: float) -> float:
        """Return when something is seen."""
        return _BEGIN_SEC + _SLOWER * at

    def _x(self, number: int) -> float:
        room = (_RIGHT - _AXIS_X - 20) / len(self._heights)
        return _AXIS_X + 20 + (number + .5) * room

    def _scale(self) -> Iterator[str]:
        step = next(each for each in (.01, .02, .05, .1, .2, .5, 1, 2, 5, 10, 20, 50, 100, 1e9)
                    if self._most / each <= 7)
        for number in range(int(self._most / step + 1e-6) + 1):
            y = self._y(number * step)
            yield motion.path(f'M{_AXIS_X} {y:.1f}H{_RIGHT}', 'motion-thin')
            yield motion.label(_AXIS_X - 8, y + 4.5, f'{number * step:g} m', anchor='end')

    def _lift(self, number: int, name: str, points: list[tuple[float, float]], reel: motion.Reel) -> Iterator[str]:
        x, half = self._x(number), _CABIN_WIDTH / 2
        foot = self._y(0)
        yield motion.path(f'M{x - half - 6} {foot}V{_TOP - 8}M{x + half + 6} {foot}V{_TOP - 8}', 'motion-thick')
        yield motion.path(f'M{x - half - 16} {foot}H{x + half + 16}', 'motion-thick')
        yield motion.label(x, 24, name, css_class='motion-big')
        cabin = [motion.box(-half, -_CABIN_HEIGHT, _CABIN_WIDTH, _CABIN_HEIGHT, 'motion-fill', rounding=2),
                 motion.path(f'M{-half} 0h{_CABIN_WIDTH}', 'motion-thick'),
                 motion.box(-24, -_CABIN_HEIGHT - 20, 48, 20, 'motion-blank', rounding=1),
                 motion.path(f'M-24 {-_CABIN_HEIGHT - 13}h48', 'motion-line')]
        # The rope of the cabin, and how fast it goes: a new figure for each stretch.
        speeds = [((later - earlier) and (high - low) / (later - earlier), earlier)
                  for (earlier, low), (later, high) in itertools.pairwise(points)]
        faces = []
        for index, (speed, at) in enumerate(speeds):
            last = index + 1 == len(speeds)
            faces.append(motion.group(
                motion.label(half + 18, -_CABIN_HEIGHT / 2 + 4, f'{speed:.1f} m/s', anchor='start',
                             css_class='motion-bold'),
                reel.shown(0 if index == 0 else self._seconds(at), self._seconds(points[-1][0] if last
                                                                                 else speeds[index + 1][1]))))
        height = points[-1][1]
        faces.append(motion.group(motion.label(half + 18, -_CABIN_HEIGHT / 2 + 4, f'{height:.2f} m', anchor='start',
                                               css_class='motion-big'), reel.appear(self._seconds(self._end))))
        yield motion.group([*cabin, *faces], reel.travel(
            [(0.0, x, self._y(points[0][1])), *((self._seconds(at), x, self._y(high)) for at, high in points)],
            'linear'))

    def _difference(self, reel: motion.Reel) -> Iterator[str]:
        """Yield a line from the highest lift to the others, which shows how far apart they are."""
        ends = [points[-1][1] for points in self._heights.values()]
        highest, lowest = max(ends), min(ends)
        if len(ends) < 2 or highest - lowest < self._most / 50:
            return
        high_x, low_x = self._x(ends.index(highest)), self._x(ends.index(lowest))
        y, low_y = self._y(highest), self._y(lowest)
        side = 1 if low_x > high_x else -1
        begin, end = high_x + side * (_CABIN_WIDTH / 2 + 8), low_x + side * (_CABIN_WIDTH / 2 + 6)
        yield motion.group([
            motion.path(f'M{begin} {y}H{end}', 'motion-line'),
            motion.arrow(low_x - 34, low_y - _CABIN_HEIGHT - 4, low_x - 34, y + 2),
            motion.label(low_x - 24, (y + low_y - _CABIN_HEIGHT - 20) / 2 + 5, f'{highest - lowest:.2f} m',
                         anchor='start', css_class='motion-big')], reel.appear(self._seconds(self._end)))

    def _clock(self, reel: motion.Reel) -> Iterator[str]:
        y = _TOP + _SHAFT + 26

        def x_of(at: float) -> float:
            return _AXIS_X + (_RIGHT - 12 - _AXIS_X) * at / self._end
        yield motion.path(f'M{_AXIS_X} {y}H{_RIGHT - 12}', 'motion-line')
        for second in range(int(self._end) + 1):
            yield motion.path(f'M{x_of(second):.1f} {y - 5}v10', 'motion-line')
            yield motion.label(x_of(second), y - 9, f'{second} s', css_class='motion-small')
        for at, words in self._marks.items():
            # Toward the end there is room on the left only.
            anchor = 'start' if at < .6 * self._end else 'end'
            yield motion.group([motion.path(f'M{x_of(at):.1f} {y - 5}v20', 'motion-thick'),
                                motion.label(x_of(at) + (6 if anchor == 'start' else -6), y + 22, words,
                                             anchor=anchor, css_class='motion-bold')], reel.appear(self._seconds(at)))
        yield motion.group('<circle r="6" class="motion-fill"/>', reel.travel(
            [(0.0, x_of(0), y), (self._seconds(0), x_of(0), y), (self._seconds(self._end), x_of(self._end), y)],
            'linear'))
        yield motion.label(_AXIS_X, y + 40, f'{_SLOWER:g} times slower than it was', anchor='start',
                           css_class='motion-small')
