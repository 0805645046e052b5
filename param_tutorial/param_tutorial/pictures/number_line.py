"""A number line with the values that a parameter may have, the one that it has, and one that somebody asks for."""

import math
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass

from param_tutorial.pictures import motion

_WIDTH, _HEIGHT = 720, 214
_ASKED_Y, _PIN_Y, _LINE_Y, _LABEL_Y, _WORDS_Y = 40, 92, 126, 156, 188
# The range takes this part of the picture, so that there is a place for what is outside.
_LOW_X, _HIGH_X = 112, 608
_EDGE = 46
_MOST_DOTS = 60
# What is smaller is 0 to the eye.
_LEAST = 1e-100
_LETTERS = 84
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

    def x(self, value: float) -> float:
        """Return where a value stands; what is far outside stands at the edge."""
        if math.isnan(value):
            return _EDGE
        share = 0.0 if self.high == self.low else (value - self.low) / (self.high - self.low)
        # Slightly outside must be seen to be outside.
        place = _LOW_X + share * (_HIGH_X - _LOW_X) if math.isfinite(share) else math.copysign(math.inf, share)
        if self.is_range and value < self.low:
            place = min(place, _LOW_X - 22)
        if self.is_range and value > self.high:
            place = max(place, _HIGH_X + 22)
        return min(max(place, _EDGE), _WIDTH - _EDGE)

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


class NumberLine:
    """The values that one parameter may have."""

    def __init__(self, node: str, name: str, scale: Scale, stored: float | None, *, before: float | None = None,
                 request: Request | None = None, is_locked: bool = False) -> None:
        """
        :param stored: What the node has; None if it has no value.
        :param before: What it had before the request.
        :param request: The latest request; None if there was none.
        :param is_locked: Whether the parameter is read-only.
        """
        self.node, self.name, self.scale, self.stored = node, name, scale, stored
        self._before = stored if before is None else before
        self._request, self._is_locked = request, is_locked

    @property
    def sentence(self) -> str:
        """What came of the request, or what is stored."""
        if self._request is None:
            return f'{self.name} = {_number(self.stored)}'
        outcome = f'is rejected; {_number(self.stored)} stays' if self._request.objection else 'is stored'
        return f'{self.name} = {motion.cut(self._request.shown, 24)} {outcome}.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        objection = f' {self._request.objection}' if self._request and self._request.objection else ''
        return (f'Number line of {self.name} of {self.node}: {self.scale.words}{", read-only" * self._is_locked}; '
                f'stored is {_number(self.stored)}. {self.sentence}{objection}')

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest it shows the stored value, and the place of one that was rejected."""
        parts = [*self._line(), *self._request_parts(reel)]
        return motion.stage(self.node, self.sentence, self.text, (_WIDTH, _HEIGHT), parts, reel)

    def _line(self) -> Iterator[str]:
        scale = self.scale
        low_x, high_x = scale.x(scale.low), scale.x(scale.high)
        if scale.is_range:
            # Outside there is no road.
            yield motion.path(f'M12 {_LINE_Y}H{low_x - 8}M{high_x + 8} {_LINE_Y}H{_WIDTH - 12}', 'motion-dashed')
            yield motion.label(14, _LABEL_Y, 'out of range', anchor='start', css_class='motion-small')
            yield motion.label(_WIDTH - 14, _LABEL_Y, 'out of range', anchor='end', css_class='motion-small')
        else:
            yield motion.arrow(_WIDTH - 60, _LINE_Y, _WIDTH - 12, _LINE_Y)
            yield motion.arrow(60, _LINE_Y, 12, _LINE_Y)
            low_x, high_x = 60, _WIDTH - 60
        dots = scale.dots
        yield motion.path(f'M{low_x:.1f} {_LINE_Y}H{high_x:.1f}', 'motion-thin' if dots else 'motion-thick')
        for value in dots or [scale.low, scale.high]:
            yield f'<circle cx="{scale.x(value):.1f}" cy="{_LINE_Y}" r="{5 if dots else 6}" class="motion-dot"/>'
        yield from self._labels(dots or [scale.low, scale.high])
        locked = '; read-only: it never changes while the node runs' if self._is_locked else ''
        if self._request is None or not self._request.objection:
            key = 'each ring is a value that the range allows' if dots else (
                'the range allows each value on the thick line' if scale.is_range else '')
            yield motion.label(14, _WORDS_Y, key, anchor='start', css_class='motion-faint')
        yield motion.label(14, 20, f'{self.name}: {scale.words}{locked}', anchor='start', css_class='motion-bold')

    def _labels(self, values: list[float]) -> Iterator[str]:
        last_x = self.scale.x(values[-1])
        room = 8 + motion.LETTER_WIDTH * max(len(f'{value:g}') for value in values)
        taken = -math.inf
        for value in values:
            x = self.scale.x(value)
            if value == values[-1] or (x - taken >= room and last_x - x >= room):
                taken = x
                yield motion.label(x, _LABEL_Y, f'{value:g}')

    def _request_parts(self, reel: motion.Reel) -> Iterator[str]:
        if self.stored is None:
            return
        stored_x = self.scale.x(self.stored)
        before_x = stored_x if self._before is None else self.scale.x(self._before)
        request = self._request
        if request is None:
            yield self._pin(stored_x, _number(self.stored))
            return
        asked_x = stored_x if request.value is None else self.scale.x(request.value)
        asked = motion.token(motion.cut(request.shown, 12))
        if not request.objection:
            landed_sec = _GO_SEC + _PAUSE_SEC + _DROP_SEC
            if self._before is not None:
                yield motion.group(self._pin(before_x, _number(self._before)),
                                   reel.shown(0, landed_sec - .5 * _DROP_SEC))
            # What was asked for becomes what is stored, which a callback may have changed on the way.
            yield motion.group(self._pin(stored_x, _number(self.stored)), reel.shown(landed_sec))
            yield motion.group(asked, reel.travel_and_go(
                [(0, before_x, _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (_GO_SEC + _PAUSE_SEC, asked_x, _ASKED_Y),
                 (landed_sec, stored_x, _PIN_Y)]))
            return
        hit_sec = _GO_SEC + _PAUSE_SEC
        up_sec = hit_sec + .8 * _DROP_SEC
        end_sec = up_sec + _PAUSE_SEC + _BACK_SEC
        yield self._pin(stored_x, _number(self.stored), reel, hit_sec)
        yield motion.group(asked, reel.travel_and_go(
            [(0, stored_x, _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (hit_sec, asked_x, _ASKED_Y),
             (hit_sec + .5 * _DROP_SEC, asked_x, _LINE_Y - 16), (up_sec, asked_x, _ASKED_Y),
             (up_sec + _PAUSE_SEC, asked_x, _ASKED_Y), (end_sec, stored_x, _PIN_Y)]))
        rest = [motion.group(motion.token(motion.cut(request.shown, 12), css_class='motion-token-bad'),
                             f' transform="translate({asked_x:.1f} {_ASKED_Y})"')]
        if request.value is not None:
            rest += [motion.path(f'M{asked_x - 6} {_LINE_Y - 6}l12 12m0 -12l-12 12', 'motion-cross'),
                     motion.path(f'M{asked_x} {_ASKED_Y + 16}V{_LINE_Y - 10}', 'motion-dashed')]
        lines = textwrap.wrap(f'rejected: {request.objection}', _LETTERS)
        lines = [*lines[:1], motion.cut(' '.join(lines[1:]), _LETTERS)] if len(lines) > 1 else lines
        rest += [motion.label(14, _WORDS_Y + 17 * number, line, anchor='start', css_class='motion-bold')
                 for number, line in enumerate(lines)]
        yield motion.group(rest, reel.appear(up_sec))

    def _pin(self, x: float, value: str, reel: motion.Reel | None = None, shaken_sec: float = 0.0) -> str:
        """Return the marker of the stored value, which is locked if the parameter is."""
        parts = [motion.path(f'M{x:.1f} {_LINE_Y - 4}l-8 -17h16z', 'motion-fill'),
                 motion.group(motion.token(motion.cut(value, 12), css_class='motion-blank'),
                              f' transform="translate({x:.1f} {_PIN_Y})"')]
        if self._is_locked:
            lock_x = x + motion.token_width(motion.cut(value, 12)) / 2 + 14
            lock = (motion.path(f'M{lock_x - 5:.1f} {_PIN_Y - 3}v-5a5 5 0 0 1 10 0v5', 'motion-line')
                    + motion.box(lock_x - 8, _PIN_Y - 3, 16, 13, 'motion-fill', rounding=2))
            look = '' if reel is None else reel.track(
                [(0, 'transform:none'), *((shaken_sec + .07 * index, f'transform:translate({shift}px,0)')
                                          for index, shift in enumerate((0, 3, -3, 3, -3, 0)))])
            parts.append(motion.group(lock, look, 'motion-lock'))
        return motion.group(parts)


def _number(value: float | None) -> str:
    return 'nothing' if value is None else str(value)
