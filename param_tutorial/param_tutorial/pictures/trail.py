"""Places that hold values, moment by moment, and what travels between them. A place holds on to its value until
something new arrives: that is how a copy grows stale.

Time goes down the picture. So the last moment shows all that went before, also where nothing moves.
"""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from param_tutorial.pictures import motion

_WIDTH, _HEAD, _ROW, _BOTTOM = 720, 50, 48, 8
_WORDS_X, _BANDS_X, _GAP = 14, 192, 8
_WORDS_LETTERS, _NOTE_LETTERS = 20, 28
_BEGIN_SEC, _READ_SEC, _TRAVEL_SEC, _STAY_SEC = 0.3, 0.6, 0.8, 0.7
# How high a road goes over the places that it does not touch.
_ARC = 18
# How wide a letter of the headings is.
_HEAD_LETTER = 9.0


@dataclass(frozen=True)
class Move:
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
    moves: tuple[Move, ...]

    @property
    def text(self) -> str:
        parts = [f'{name} {value}' for name, value in self.values.items()]
        told = [f'{move.value} {"bounces off" if move.objection else "arrives at"} {move.target}'
                + (f' ({move.objection})' if move.objection else '') for move in self.moves]
        return f'{self.words}: ' + '; '.join(filter(None, [', '.join(told), ', '.join(parts), self.note]))


class Trail:
    """What some places hold, moment by moment. TrailView (``widgets.pictured``) explains the arguments."""

    def __init__(self, subject: str, places: Sequence[str]) -> None:
        if not places or len(set(places)) < len(places):
            raise ValueError(f'a Trail takes one place at least, and each once, not {list(places)}')
        self.subject, self._places = subject, tuple(places)
        self._moments: list[_Moment] = []

    def add(self, words: str, values: Sequence[Any], *moves: tuple[str, str] | tuple[str, str, Any, str],
            note: str = '') -> None:
        """Add a moment."""
        if len(values) != len(self._places):
            raise ValueError(f'{len(values)} values for {len(self._places)} places')
        held = {place: _told(value) for place, value in zip(self._places, values, strict=True) if value is not ...}
        self._moments.append(_Moment(words, note, held, tuple(self._move(held, *move) for move in moves)))

    def _move(self, held: dict[str, str], source: str, target: str, value: Any = ..., objection: str = '') -> Move:
        for place in filter(None, (source, target)):
            if place not in self._places:
                raise ValueError(f'{place!r} is not one of the places {list(self._places)}')
        if value is ... and target not in held:
            raise ValueError(f'{target} holds nothing, so nothing can have arrived there')
        return Move(source, target, held[target] if value is ... else _told(value), objection)

    @property
    def sentence(self) -> str:
        """What it comes to: the last note, or what the last moment leaves behind."""
        notes = [f'{moment.words}: {moment.note}.' for moment in self._moments if moment.note]
        return notes[-1] if notes else f'{len(self._moments)} moments.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return f'{self.subject}, moment by moment. ' + ' '.join(f'{moment.text}.' for moment in self._moments)

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest all moments stand below each other."""
        height = _HEAD + len(self._moments) * _ROW + _BOTTOM
        parts = list(self._bands(height))
        begin_sec = _BEGIN_SEC
        for number, moment in enumerate(self._moments):
            parts += self._row(number, moment, begin_sec, reel)
            begin_sec += _READ_SEC + (_TRAVEL_SEC if moment.moves else 0.0) + _STAY_SEC
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    @property
    def _band_width(self) -> float:
        return (_WIDTH - _BANDS_X - 14 + _GAP) / len(self._places) - _GAP

    def _x(self, place: str) -> float:
        """Return where the middle of a place's column is."""
        return _BANDS_X + self._places.index(place) * (self._band_width + _GAP) + self._band_width / 2

    @property
    def _letters(self) -> int:
        """How long a value may be."""
        return max(4, int((self._band_width - 28) / motion.LETTER_WIDTH))

    def _bands(self, height: int) -> Iterator[str]:
        for place in self._places:
            x = self._x(place)
            yield motion.box(x - self._band_width / 2, 4, self._band_width, height - 8, rounding=8)
            lines = textwrap.wrap(place, max(6, int(self._band_width / _HEAD_LETTER)))[:2]
            for number, line in enumerate(lines):
                yield motion.label(x, 29 + 16 * (number - (len(lines) - 1) / 2), line, css_class='motion-bold')

    def _row(self, number: int, moment: _Moment, begin_sec: float, reel: motion.Reel) -> Iterator[str]:
        y = _HEAD + (number + .5) * _ROW
        arrives_sec = begin_sec + _READ_SEC + _TRAVEL_SEC
        if number:
            yield motion.path(f'M{_WORDS_X} {y - _ROW / 2}H{_WIDTH - 14}', 'motion-thin', reel.appear(begin_sec))
        yield motion.group(motion.label(_WORDS_X, y - 3 if moment.note else y + 4.5,
                                        motion.cut(moment.words, _WORDS_LETTERS), anchor='start',
                                        css_class='motion-bold'), reel.appear(begin_sec))
        if moment.note:
            yield motion.group(motion.label(_WORDS_X, y + 15, motion.cut(moment.note, _NOTE_LETTERS), anchor='start',
                                            css_class='motion-small'),
                               reel.appear(arrives_sec if moment.moves else begin_sec))
        arriving = {move.target for move in moment.moves if not move.objection}
        for place, value in moment.values.items():
            if place not in arriving:
                # Without the frame of what has moved.
                yield motion.group(motion.label(self._x(place), y + 4.5, motion.cut(value, self._letters),
                                                css_class='motion-code'), reel.appear(begin_sec))
        for move in moment.moves:
            draw = self._bounce if move.objection else self._journey
            yield from draw(move, y, moment, begin_sec + _READ_SEC, reel)

    def _bounce(self, move: Move, y: float, moment: _Moment, leaves_sec: float, reel: motion.Reel) -> Iterator[str]:
        """Yield a value that its target does not take: it comes to the edge, and goes back."""
        token = motion.cut(move.value, self._letters)
        from_x, to_x = self._x(move.source) if move.source else _BANDS_X - 30, self._x(move.target)
        edge_x = to_x - self._band_width / 2 if from_x < to_x else to_x + self._band_width / 2
        there_sec = leaves_sec + _TRAVEL_SEC
        touch_x = edge_x - (motion.token_width(token) / 2 + 2) * (1 if from_x < to_x else -1)
        x = to_x - self._band_width / 2 + 16
        yield motion.group([motion.path(f'M{x - 6:.1f} {y - 6}l12 12M{x + 6:.1f} {y - 6}l-12 12', 'motion-cross'),
                            motion.label(x + 14, y + 4.5, motion.cut(move.objection, self._letters), anchor='start')],
                           reel.appear(there_sec - .3))
        yield motion.group(motion.group(motion.token(token, css_class='motion-token-bad'), reel.shown(leaves_sec - .1)),
                           reel.travel([(0, from_x, y), (leaves_sec, from_x, y), (there_sec - .3, touch_x, y),
                                        (there_sec, from_x, y)]))

    def _journey(self, move: Move, y: float, moment: _Moment, leaves_sec: float, reel: motion.Reel) -> Iterator[str]:
        """Yield a value that travels, and the road that it leaves behind."""
        token, to_x = motion.cut(move.value, self._letters), self._x(move.target)
        half, there_sec = motion.token_width(token) / 2, leaves_sec + _TRAVEL_SEC
        target = self._places.index(move.target)
        if not move.source:
            # From the left if nothing is in the way, and otherwise from above.
            start = (_BANDS_X - 30, y) if target == 0 else (to_x, y - _ROW / 2 - 6)
            road = motion.arrow(start[0], y, to_x - half - 4, y) if target == 0 else \
                motion.arrow(to_x, y - _ROW / 2 + 1, to_x, y - 14)
            stops = [(leaves_sec, *start), (there_sec, to_x, y)]
        else:
            source = self._places.index(move.source)
            from_x, sign = self._x(move.source), 1 if source < target else -1
            held = motion.cut(moment.values.get(move.source, ''), self._letters)
            begin, end = from_x + sign * (motion.LETTER_WIDTH * .55 * len(held) + 6), to_x - sign * (half + 4)
            covered = [place for place in self._places[min(source, target) + 1:max(source, target)]
                       if place in moment.values]
            if covered:
                road = motion.path(f'M{begin:.1f} {y - 6}Q{(begin + end) / 2:.1f} {y - _ARC - 16} {end - sign * 8:.1f} '
                                   f'{y - 10}') + motion.arrow(end - sign * 12, y - 12, end + sign * 2, y - 5)
                road += ''.join(self._struck(place, y, moment.values[place]) for place in covered)
                stops = [(leaves_sec, from_x, y), ((leaves_sec + there_sec) / 2, (from_x + to_x) / 2, y - _ARC),
                         (there_sec, to_x, y)]
            else:
                road = motion.arrow(begin, y, end, y)
                stops = [(leaves_sec, from_x, y), (there_sec, to_x, y)]
        yield motion.group(road, reel.appear(there_sec - .2))
        yield motion.group(motion.group(motion.token(token), reel.shown(leaves_sec - .1)),
                           reel.travel([(0.0, *stops[0][1:]), *stops]))

    def _struck(self, place: str, y: float, value: str) -> str:
        """Return a line through a value that does not count."""
        half = motion.LETTER_WIDTH * .55 * len(motion.cut(value, self._letters)) + 5
        return motion.path(f'M{self._x(place) - half:.1f} {y}h{2 * half:.1f}', 'motion-thick')


def _told(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)
