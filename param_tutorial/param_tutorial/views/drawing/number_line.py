"""A number line with the values that a parameter may have, the one that it has, and one that somebody asks for."""

import math
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_WIDTH = svg.AnimatedPicture._width
_ASKED_Y, _PIN_Y, _LINE_Y, _LABEL_Y, _WORDS_Y = 40, 92, 126, 156, 188
_EDGE = 46
_MOST_DOTS = 60
# What is smaller is 0 to the eye.
_LEAST = 1e-100
_TOKEN_LETTERS = 12
_GO_SEC, _DROP_SEC, _PAUSE_SEC, _BACK_SEC = 0.6, 0.3, 0.35, 0.5


@dataclass(frozen=True)
class Scale:
    """Which values a parameter may have."""

    low: float
    high: float
    step: float = 0.0
    """Counted from the lower end; 0 for any value in between."""
    is_range: bool = True
    """False if there is no limit, and the ends are only those of the picture."""

    @staticmethod
    def around(*values: float) -> 'Scale':
        """Return a scale without limits on which all these values, and 0, have a place."""
        finite = [0.0, *(value for value in values if math.isfinite(value))]
        largest = max(map(abs, finite))
        largest = largest if largest > _LEAST else 1.0
        power = 10.0 ** math.floor(math.log10(largest))
        end = max(largest, math.ceil(largest / power - 1e-9) * power)
        return Scale(-end if min(finite) < 0 else 0.0, end if max(finite) > 0 else 0.0 if min(finite) < 0 else end,
                     is_range=False)

    def x(self, value: float, width: float = _WIDTH) -> float:
        """Return where a value stands in a picture of that width; what is far outside stands at the edge."""
        if math.isnan(value):
            return _EDGE
        # The range takes this part of the picture, so that there is a place for what is outside.
        low_x = 112 if width == _WIDTH else 64
        high_x = width - low_x
        share = 0.0 if self.high == self.low else (value - self.low) / (self.high - self.low)
        # Slightly outside must be seen to be outside.
        place = low_x + share * (high_x - low_x) if math.isfinite(share) else math.copysign(math.inf, share)
        if self.is_range and value < self.low:
            place = min(place, low_x - 22)
        if self.is_range and value > self.high:
            place = max(place, high_x + 22)
        return min(max(place, _EDGE), width - _EDGE)

    @property
    def dots(self) -> list[float]:
        """The values from step to step with both ends; empty if all in between are as good, or if they are too many."""
        if not self.is_range or self.step <= 0 or (self.high - self.low) / self.step > _MOST_DOTS:
            return []
        count = math.floor((self.high - self.low) / self.step + 1e-6)
        steps = [self.low + index * self.step for index in range(count + 1)]
        return steps if math.isclose(steps[-1], self.high, rel_tol=1e-6) else [*steps, self.high]

    @property
    def words(self) -> str:
        """What may be, in words."""
        if not self.is_range:
            return 'no limits'
        steps = f' in steps of {self.step:g}' if self.step > 0 else ''
        return f'{self.low:g} to {self.high:g}{steps}'


@dataclass(frozen=True)
class Request:
    """What somebody asked for, and what the node said."""

    value: float | None
    """None if it is not a number."""
    shown: str
    """The value as text."""
    objection: str = ''
    """Why it was rejected, in the node's words; empty if it is stored."""


class NumberLine(svg.AnimatedPicture):
    """The values that one parameter may have; at rest you see the stored value, and the place of a rejected one."""

    _has_narrow = True

    def __init__(self, node: str, name: str, scale: Scale, stored: float | None, *, before: float | None = None,
                 request: Request | None = None, is_locked: bool = False) -> None:
        """
        :param stored: What the node has; None if it has no value.
        :param before: What it had before the request.
        :param request: The latest request; None if there was none.
        :param is_locked: Whether the parameter is read-only.
        """
        self.subject, self._name, self._scale, self._stored = node, name, scale, stored
        self._before = stored if before is None else before
        self._request, self._is_locked = request, is_locked

    @property
    def sentence(self) -> str:
        if self._request is None:
            return f'{self._name} = {_number(self._stored)}'
        outcome = f'is rejected; {_number(self._stored)} stays' if self._request.objection else 'is stored'
        return f'{self._name} = {svg.cut(self._request.shown, 24)} {outcome}.'

    @property
    def text(self) -> str:
        objection = f' {self._request.objection}' if self._request and self._request.objection else ''
        return (f'Number line of {self._name} of {self.subject}: {self._scale.words}{", read-only" * self._is_locked}; '
                f'stored is {_number(self._stored)}. {self.sentence}{objection}')

    @property
    def _height(self) -> float:
        return 214 + 17 * (len(self._title) - 1) + (34 if self._is_narrow else 0)

    @property
    def _title(self) -> list[str]:
        locked = '; read-only: it never changes while the node runs' * self._is_locked
        return self._lines(f'{self._name}: {self._scale.words}{locked}')

    def _lines(self, text: str) -> list[str]:
        """Return a text in as many lines as there is room for."""
        return textwrap.wrap(text, 34, max_lines=4, placeholder='…') if self._is_narrow else svg.in_two_lines(text, 84)

    def _x(self, value: float) -> float:
        return self._scale.x(value, self._width)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, line in enumerate(self._title):
            yield svg.words(14, 20 + 17 * number, line, 'bold', anchor='start')
        below = f' transform="translate(0 {17 * (len(self._title) - 1)})"' if len(self._title) > 1 else ''
        yield svg.group([*self._line(), *self._value(animation)], below)

    def _value(self, animation: svg.Animation) -> Iterator[str]:
        if self._stored is None:
            return
        if self._request is None:
            yield self._pin(self._stored)
        elif self._request.objection:
            yield from self._rejected(self._stored, self._request, animation)
        else:
            yield from self._accepted(self._stored, self._request, animation)

    def _line(self) -> Iterator[str]:
        scale, dots, width = self._scale, self._scale.dots, self._width
        if scale.is_range:
            # Outside there is no road.
            low_x, high_x, y = self._x(scale.low), self._x(scale.high), _LABEL_Y
            yield svg.path(f'M12 {_LINE_Y}H{low_x - 8}M{high_x + 8} {_LINE_Y}H{width - 12}', 'dashed')
            y += 16 if self._is_narrow else 0
            yield svg.words(14, y, 'out of range', 'small', anchor='start')
            yield svg.words(width - 14, y, 'out of range', 'small', anchor='end')
        else:
            low_x, high_x = 60.0, width - 60.0
            yield svg.arrow(high_x, _LINE_Y, width - 12, _LINE_Y) + svg.arrow(low_x, _LINE_Y, 12, _LINE_Y)
        yield svg.path(f'M{low_x:.1f} {_LINE_Y}H{high_x:.1f}', 'thin' if dots else 'thick')
        radius = max(1.5, min(5.0, .4 * (high_x - low_x) / len(dots))) if dots else 6.0
        for value in dots or [scale.low, scale.high]:
            yield svg.circle(self._x(value), _LINE_Y, radius, 'dot')
        yield from self._labels(dots or [scale.low, scale.high])
        if self._request is None or not self._request.objection:
            key = 'each ring is a value that the range allows' if dots else (
                'the range allows each value on the thick line' if scale.is_range else '')
            yield self._words(key, 'faint')

    def _words(self, text: str, kind: str) -> str:
        """Return a text below the line."""
        y = _WORDS_Y + (8 if self._is_narrow else 0)
        return ''.join(svg.words(14, y + 17 * number, line, kind, anchor='start')
                       for number, line in enumerate(self._lines(text)))

    def _labels(self, values: list[float]) -> Iterator[str]:
        last_x, taken = self._x(values[-1]), -math.inf
        room = 8 + svg.LETTER_WIDTH * max(len(f'{value:g}') for value in values)
        for value in values:
            x = self._x(value)
            if value == values[-1] or (x - taken >= room and last_x - x >= room):
                taken = x
                yield svg.words(x, _LABEL_Y, f'{value:g}')

    def _accepted(self, stored: float, request: Request, animation: svg.Animation) -> Iterator[str]:
        """Yield the old pin, the new pin, and what was asked for, which a callback may have changed on the way."""
        stored_x, asks_sec = self._x(stored), _GO_SEC + _PAUSE_SEC
        asked_x = stored_x if request.value is None else self._x(request.value)
        before_x = stored_x if self._before is None else self._x(self._before)
        landed_sec = asks_sec + _DROP_SEC
        if self._before is not None:
            yield svg.group(self._pin(self._before, kind=''), animation.shown(0, landed_sec - .5 * _DROP_SEC))
        yield svg.group(self._pin(stored), animation.shown(landed_sec))
        yield svg.group(svg.token(svg.cut(request.shown, _TOKEN_LETTERS)), animation.travel(
            [(0, before_x, _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (asks_sec, asked_x, _ASKED_Y),
             (landed_sec, stored_x, _PIN_Y)], goes=True))

    def _rejected(self, stored: float, request: Request, animation: svg.Animation) -> Iterator[str]:
        """Yield the pin, what was asked for, which bounces off the line, and the trace that it leaves."""
        stored_x, hit_sec = self._x(stored), _GO_SEC + _PAUSE_SEC
        asked_x = stored_x if request.value is None else self._x(request.value)
        up_sec = hit_sec + .8 * _DROP_SEC
        rests_sec = up_sec + _PAUSE_SEC
        asked = svg.cut(request.shown, _TOKEN_LETTERS)
        yield self._pin(stored, animation.track([(0, 'transform:none'), *(
            (hit_sec + .07 * index, f'transform:translate({shift}px,0)')
            for index, shift in enumerate((0, 3, -3, 3, -3, 0)))]) if self._is_locked else '')
        yield svg.group(svg.token(asked), animation.travel(
            [(0, stored_x, _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (hit_sec, asked_x, _ASKED_Y),
             (hit_sec + .5 * _DROP_SEC, asked_x, _LINE_Y - 16), (up_sec, asked_x, _ASKED_Y),
             (rests_sec, asked_x, _ASKED_Y), (rests_sec + _BACK_SEC, stored_x, _PIN_Y)], goes=True))
        trace = [_at(asked_x, _ASKED_Y, svg.token(asked, 'token-bad'))]
        if request.value is not None:
            trace += [svg.cross(asked_x, _LINE_Y),
                      svg.path(f'M{asked_x} {_ASKED_Y + 16}V{_LINE_Y - 10}', 'dashed')]
        trace.append(self._words(f'rejected: {request.objection}', 'bold'))
        yield svg.group(trace, animation.appear(up_sec))

    def _pin(self, stored: float, style_of_lock: str = '', *, kind: str = 'pin') -> str:
        """Return the marker of the stored value, which is locked if the parameter is, and is dragged if it is a pin."""
        x, value = self._x(stored), svg.cut(_number(stored), _TOKEN_LETTERS)
        parts = [svg.path(f'M{x:.1f} {_LINE_Y - 4}l-8 -17h16z', 'fill'),
                 _at(x, _PIN_Y, svg.token(value, 'blank'))]
        if self._is_locked:
            lock_x = x + svg.token_width(value) / 2 + 14
            parts.append(svg.group([svg.path(f'M{lock_x - 5:.1f} {_PIN_Y - 3}v-5a5 5 0 0 1 10 0v5'),
                                    svg.box(lock_x - 8, _PIN_Y - 3, 16, 13, 'fill', rounding=2)],
                                   style_of_lock, 'lock'))
        # For the script that lets a reader drag it: two values, and where they stand.
        low, high = self._scale.low, self._scale.high
        axis = f' data-axis="{low} {self._x(low):.1f} {high} {self._x(high):.1f}"'
        return svg.group(parts, axis + ' data-whole=""' * isinstance(stored, int), kind)


def _at(x: float, y: float, part: str) -> str:
    return svg.group(part, f' transform="translate({x:.1f} {y})"')


def _number(value: float | None) -> str:
    return 'nothing' if value is None else str(value)
