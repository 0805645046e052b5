"""Places that hold values, moment by moment, and what travels between them. A place holds on to its value until
something new arrives: that is how a copy grows stale.

Time goes down the picture. So the last moment shows all that went before, also where nothing moves.
"""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from param_tutorial.views.drawing import svg

_HEAD, _ROW, _BOTTOM = 50, 48, 8
_WORDS_X, _COLUMNS_X, _GAP, _MARGIN = 14, 192, 8, 14
# Where a value comes from that comes from the left of all places.
_OUTSIDE_X = _COLUMNS_X - 30
_WORDS_LETTERS, _NOTE_LETTERS = 20, 28
_BEGIN_SEC, _READ_SEC, _TRAVEL_SEC, _STAY_SEC = 0.3, 0.6, 0.8, 0.7
# How high a road goes over the places that it does not touch.
_ARC = 18
# How wide a letter of the headings is.
_HEAD_LETTER = 9.0


@dataclass(frozen=True)
class _Move:
    """What travels in a moment."""

    source: str
    """The place that it comes from; empty for from outside."""
    target: str
    value: str
    """What arrives, or would have."""
    objection: str = ''
    """Why the target does not take it; empty if it does."""


@dataclass(frozen=True)
class _Moment:
    words: str
    note: str
    values: dict[str, str]
    """By place, when the moment is over; a place without a value is not in it."""
    moves: tuple[_Move, ...]

    @property
    def text(self) -> str:
        parts = [f'{name} {value}' for name, value in self.values.items()]
        told = [f'{move.value} {"bounces off" if move.objection else "arrives at"} {move.target}'
                + (f' ({move.objection})' if move.objection else '') for move in self.moves]
        return f'{self.words}: ' + '; '.join(filter(None, [', '.join(told), ', '.join(parts), self.note]))


class Trail(svg.AnimatedPicture):
    """What some places hold; at rest all moments stand below each other. TrailView explains the arguments."""

    def __init__(self, subject: str, places: Sequence[str]) -> None:
        self.subject, self._places = subject, tuple(places)
        self._moments: list[_Moment] = []
        self._column_width = (self._width - _COLUMNS_X - _MARGIN + _GAP) / len(places) - _GAP
        # How long a value may be.
        self._letters = max(4, int((self._column_width - 28) / svg.LETTER_WIDTH))

    def add(self, words: str, values: Sequence[Any], *moves: tuple[str, str] | tuple[str, str, Any, str],
            note: str = '') -> None:
        held = {place: _told(value) for place, value in zip(self._places, values, strict=True) if value is not ...}
        self._moments.append(_Moment(words, note, held, tuple(self._move(held, *move) for move in moves)))

    def _move(self, held: dict[str, str], source: str, target: str, value: Any = ..., objection: str = '') -> _Move:
        return _Move(source, target, held[target] if value is ... else _told(value), objection)

    @property
    def sentence(self) -> str:
        """What it comes to: the last note, or how many moments there are."""
        notes = [f'{moment.words}: {moment.note}.' for moment in self._moments if moment.note]
        return notes[-1] if notes else f'{len(self._moments)} moments.'

    @property
    def text(self) -> str:
        return f'{self.subject}, moment by moment. ' + ' '.join(f'{moment.text}.' for moment in self._moments)

    @property
    def _height(self) -> float:
        return _HEAD + len(self._moments) * _ROW + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for place in self._places:
            x = self._x(place)
            yield svg.box(x - self._column_width / 2, 4, self._column_width, self._height - 8, rounding=8)
            lines = textwrap.wrap(place, max(6, int(self._column_width / _HEAD_LETTER)))[:2]
            yield svg.paragraph(x, 29, lines, 'bold')
        begin_sec, y = _BEGIN_SEC, _HEAD + _ROW / 2
        for moment in self._moments:
            if moment is not self._moments[0]:
                yield svg.path(f'M{_WORDS_X} {y - _ROW / 2}H{self._width - _MARGIN}', 'thin',
                               animation.appear(begin_sec))
            yield from self._moment(y, moment, begin_sec, animation)
            begin_sec += _READ_SEC + (_TRAVEL_SEC if moment.moves else 0.0) + _STAY_SEC
            y += _ROW

    def _x(self, place: str) -> float:
        """Return where the middle of a place's column is."""
        return _COLUMNS_X + self._places.index(place) * (self._column_width + _GAP) + self._column_width / 2

    def _moment(self, y: float, moment: _Moment, begin_sec: float, animation: svg.Animation) -> Iterator[str]:
        begins, leaves_sec = animation.appear(begin_sec), begin_sec + _READ_SEC
        yield svg.words(_WORDS_X, y - 3 if moment.note else y + 4.5, svg.cut(moment.words, _WORDS_LETTERS), 'bold',
                        anchor='start', style=begins)
        if moment.note:
            yield svg.words(_WORDS_X, y + 15, svg.cut(moment.note, _NOTE_LETTERS), 'small', anchor='start',
                            style=animation.appear(leaves_sec + _TRAVEL_SEC) if moment.moves else begins)
        arriving = {move.target for move in moment.moves if not move.objection}
        for place, value in moment.values.items():
            if place not in arriving:
                # Without the frame of what has moved.
                yield svg.words(self._x(place), y + 4.5, svg.cut(value, self._letters), 'code', style=begins)
        for move in moment.moves:
            draw = self._bounce if move.objection else self._journey
            yield from draw(move, y, moment, leaves_sec, animation)

    def _bounce(self, move: _Move, y: float, _moment: _Moment, leaves_sec: float,
                animation: svg.Animation) -> Iterator[str]:
        """Yield a value that its target does not take: it comes to the edge, and goes back."""
        token, to_x = svg.cut(move.value, self._letters), self._x(move.target)
        from_x = self._x(move.source) if move.source else _OUTSIDE_X
        sign = 1 if from_x < to_x else -1
        touch_x = to_x - sign * (self._column_width / 2 + svg.token_width(token) / 2 + 2)
        cross_x, there_sec = to_x - self._column_width / 2 + 16, leaves_sec + _TRAVEL_SEC
        yield svg.group([svg.cross(cross_x, y), svg.words(cross_x + 14, y + 4.5, svg.cut(
            move.objection, self._letters), anchor='start')], animation.appear(there_sec - .3))
        yield svg.group(svg.token(token, 'token-bad'), animation.travel(
            [(leaves_sec, from_x, y), (there_sec - .3, touch_x, y), (there_sec, from_x, y)], from_sec=leaves_sec - .1))

    def _journey(self, move: _Move, y: float, moment: _Moment, leaves_sec: float,
                 animation: svg.Animation) -> Iterator[str]:
        """Yield a value that travels, and the road that it leaves behind."""
        token, to_x = svg.cut(move.value, self._letters), self._x(move.target)
        half, target = svg.token_width(token) / 2, self._places.index(move.target)
        there_sec = leaves_sec + _TRAVEL_SEC
        between: list[svg.Stop] = []
        if move.source:
            source, from_x, from_y = self._places.index(move.source), self._x(move.source), y
            sign = 1 if source < target else -1
            held = svg.cut(moment.values.get(move.source, ''), self._letters)
            begin, end = from_x + sign * (.55 * svg.LETTER_WIDTH * len(held) + 6), to_x - sign * (half + 4)
            covered = [place for place in self._places[min(source, target) + 1:max(source, target)]
                       if place in moment.values]
            if covered:
                # Over what does not count, which is struck out.
                road = svg.path(f'M{begin:.1f} {y - 6}Q{(begin + end) / 2:.1f} {y - _ARC - 16} {end - sign * 8:.1f} '
                                f'{y - 10}') + svg.arrow(end - sign * 12, y - 12, end + sign * 2, y - 5)
                road += ''.join(svg.strike(self._x(place), y, svg.cut(moment.values[place], self._letters))
                                for place in covered)
                between = [((leaves_sec + there_sec) / 2, (from_x + to_x) / 2, y - _ARC)]
            else:
                road = svg.arrow(begin, y, end, y)
        elif target == 0:
            # From the left if nothing is in the way, and otherwise from above.
            from_x, from_y, road = _OUTSIDE_X, y, svg.arrow(_OUTSIDE_X, y, to_x - half - 4, y)
        else:
            from_x, from_y, road = to_x, y - _ROW / 2 - 6, svg.arrow(to_x, y - _ROW / 2 + 1, to_x, y - 14)
        yield svg.group(road, animation.appear(there_sec - .2))
        yield svg.group(svg.token(token), animation.travel(
            [(leaves_sec, from_x, from_y), *between, (there_sec, to_x, y)], from_sec=leaves_sec - .1))


def _told(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)
