"""A number line with the values that a parameter may have, the one that it has, and one that somebody asks for."""

import math
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import WIDTH, Diagram, Moving

_ASKED_Y, _PIN_Y, _LINE_Y, _LABEL_Y, _WORDS_Y = 40, 92, 126, 156, 188
_EDGE = 46
# The range takes the part of the picture in between, so that there is a place for what is outside.
_LOW_X, _HIGH_X = 112, WIDTH - 112
_MOST_DOTS = 60
# What is smaller is 0 to the eye.
_LEAST = 1e-100
_TOKEN_LETTERS, _LINE_LETTERS = 12, 84
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
        """Return where a value stands in the picture; what is far outside stands at the edge."""
        if math.isnan(value):
            return _EDGE
        share = 0.0 if self.high == self.low else (value - self.low) / (self.high - self.low)
        # Slightly outside must be seen to be outside.
        place = _LOW_X + share * (_HIGH_X - _LOW_X) if math.isfinite(share) else math.copysign(math.inf, share)
        if self.is_range and value < self.low:
            place = min(place, _LOW_X - 22)
        if self.is_range and value > self.high:
            place = max(place, _HIGH_X + 22)
        return min(max(place, _EDGE), WIDTH - _EDGE)

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
class Attempt:
    """What somebody asked for, and what the node said."""

    value: float | None
    """None if it is not a number."""
    shown: str
    """The value as text."""
    objection: str = ''
    """Why it was rejected, in the node's words; empty if it is stored."""


def draw_number_line(node: str, name: str, scale: Scale, stored: float, *, before: float | None = None,
                     request: Attempt | None = None, is_locked: bool = False) -> Diagram:
    """Draw the values that one parameter may have; at rest you see the stored one, and the place of a rejected one.

    :param stored: What the node has.
    :param before: What it had before the request.
    :param request: The latest request; None if there was none.
    :param is_locked: Whether the parameter is read-only.
    """
    sentence, objection = f'{name} = {stored}', request.objection if request else ''
    if request:
        outcome = f'is rejected; {stored} stays' if objection else 'is stored'
        sentence = f'{name} = {svg.cut(request.shown, 24)} {outcome}.'
    text = (f'Number line of {name} of {node}: {scale.words}{", read-only" * is_locked}; '
            f'stored is {stored}. {sentence}{objection and " "}{objection}')
    locked = '; read-only: it never changes while the node runs' * is_locked
    diagram = Diagram(node, sentence, text, 214)
    diagram.add(svg.words(14, 20, svg.cut(f'{name}: {scale.words}{locked}', _LINE_LETTERS), 'bold', anchor='start'))
    _add_scale(diagram, scale)
    if not objection:
        key = 'each ring is a value that the range allows' if scale.dots else (
            'the range allows each value on the thick line' if scale.is_range else '')
        diagram.add(_words(key, 'faint'))
    before = stored if before is None else before
    if request is None:
        diagram.add(_pin(scale, stored, is_locked=is_locked))
    elif objection:
        _add_rejected(diagram, scale, stored, request, is_locked=is_locked)
    else:
        _add_accepted(diagram, scale, stored, before, request, is_locked=is_locked)
    return diagram


def _add_scale(diagram: Diagram, scale: Scale) -> None:
    """Add the line, its rings and its labels."""
    values = scale.dots or [scale.low, scale.high]
    if scale.is_range:
        # Outside there is no road.
        low_x, high_x = scale.x(scale.low), scale.x(scale.high)
        diagram.add(svg.path(f'M12 {_LINE_Y}H{low_x - 8}M{high_x + 8} {_LINE_Y}H{WIDTH - 12}', 'dashed'),
                    svg.words(14, _LABEL_Y, 'out of range', 'small', anchor='start'),
                    svg.words(WIDTH - 14, _LABEL_Y, 'out of range', 'small', anchor='end'))
    else:
        low_x, high_x = 60.0, WIDTH - 60.0
        diagram.add(svg.arrow(high_x, _LINE_Y, WIDTH - 12, _LINE_Y), svg.arrow(low_x, _LINE_Y, 12, _LINE_Y))
    radius = max(1.5, min(5.0, .4 * (high_x - low_x) / len(scale.dots))) if scale.dots else 6.0
    diagram.add(svg.path(f'M{low_x:.1f} {_LINE_Y}H{high_x:.1f}', 'thin' if scale.dots else 'thick'),
                *(svg.circle(scale.x(value), _LINE_Y, radius, 'dot') for value in values))
    last_x, taken = scale.x(values[-1]), -math.inf
    room = 8 + svg.LETTER_WIDTH * max(len(f'{value:g}') for value in values)
    for value in values:
        x = scale.x(value)
        if value == values[-1] or (x - taken >= room and last_x - x >= room):
            taken = x
            diagram.add(svg.words(x, _LABEL_Y, f'{value:g}'))


def _words(text: str, kind: str) -> str:
    """Return a text below the line."""
    return ''.join(svg.words(14, _WORDS_Y + 17 * number, line, kind, anchor='start')
                   for number, line in enumerate(svg.in_two_lines(text, _LINE_LETTERS)))


def _add_accepted(diagram: Diagram, scale: Scale, stored: float, before: float, request: Attempt, *,
                  is_locked: bool) -> None:
    """Add the old pin, the new pin, and what was asked for, which a callback may have changed on the way."""
    stored_x, asks_sec = scale.x(stored), _GO_SEC + _PAUSE_SEC
    asked_x = stored_x if request.value is None else scale.x(request.value)
    landed_sec = asks_sec + _DROP_SEC
    diagram.show(0, _pin(scale, before, kind='', is_locked=is_locked), to_sec=landed_sec - .5 * _DROP_SEC)
    diagram.show(landed_sec, _pin(scale, stored, is_locked=is_locked))
    diagram.add(Moving(svg.token(svg.cut(request.shown, _TOKEN_LETTERS)), goes=True, stops=[
        (0, scale.x(before), _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (asks_sec, asked_x, _ASKED_Y),
        (landed_sec, stored_x, _PIN_Y)]))


def _add_rejected(diagram: Diagram, scale: Scale, stored: float, request: Attempt, *, is_locked: bool) -> None:
    """Add the pin, what was asked for, which bounces off the line, and the trace that it leaves."""
    stored_x, hit_sec = scale.x(stored), _GO_SEC + _PAUSE_SEC
    asked_x = stored_x if request.value is None else scale.x(request.value)
    up_sec = hit_sec + .8 * _DROP_SEC
    rests_sec = up_sec + _PAUSE_SEC
    asked, pin = svg.cut(request.shown, _TOKEN_LETTERS), _pin(scale, stored, is_locked=is_locked)
    shaking = [(0.0, 0, 0), *((hit_sec + .07 * index, shift, 0) for index, shift in enumerate((0, 3, -3, 3, -3, 0)))]
    diagram.add(Moving(pin, shaking) if is_locked else pin,
                Moving(svg.token(asked), goes=True, stops=[
                    (0, stored_x, _ASKED_Y), (_GO_SEC, asked_x, _ASKED_Y), (hit_sec, asked_x, _ASKED_Y),
                    (hit_sec + .5 * _DROP_SEC, asked_x, _LINE_Y - 16), (up_sec, asked_x, _ASKED_Y),
                    (rests_sec, asked_x, _ASKED_Y), (rests_sec + _BACK_SEC, stored_x, _PIN_Y)]))
    trace = [_at(asked_x, _ASKED_Y, svg.token(asked, 'token-bad'))]
    if request.value is not None:
        trace += [svg.cross(asked_x, _LINE_Y), svg.path(f'M{asked_x} {_ASKED_Y + 16}V{_LINE_Y - 10}', 'dashed')]
    diagram.show(up_sec, *trace, _words(f'rejected: {request.objection}', 'bold'))


def _pin(scale: Scale, stored: float, *, is_locked: bool, kind: str = 'pin') -> str:
    """Return the marker of the stored value, which is locked if the parameter is, and is dragged if it is a pin."""
    x, value = scale.x(stored), svg.cut(str(stored), _TOKEN_LETTERS)
    parts = [svg.path(f'M{x:.1f} {_LINE_Y - 4}l-8 -17h16z', 'fill'), _at(x, _PIN_Y, svg.token(value, 'blank'))]
    if is_locked:
        lock_x = x + svg.token_width(value) / 2 + 14
        parts += [svg.path(f'M{lock_x - 5:.1f} {_PIN_Y - 3}v-5a5 5 0 0 1 10 0v5'),
                  svg.box(lock_x - 8, _PIN_Y - 3, 16, 13, 'fill', rounding=2)]
    # For the script that lets a reader drag it: two values, and where they stand.
    axis = f' data-axis="{scale.low} {scale.x(scale.low):.1f} {scale.high} {scale.x(scale.high):.1f}"'
    return svg.group(parts, axis + ' data-whole=""' * isinstance(stored, int), kind)


def _at(x: float, y: float, part: str) -> str:
    return svg.group(part, f' transform="translate({x:.1f} {y})"')
