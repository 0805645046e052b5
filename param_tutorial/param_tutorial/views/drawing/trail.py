"""Places that hold values, moment by moment, and what travels between them. A place holds on to its value until
something new arrives: that is how a copy grows stale.

Time goes down the picture. So the last moment shows all that went before, also where nothing moves.
"""

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import TRAVEL_SEC, WIDTH, Diagram, Moving

_HEAD, _ROW, _BOTTOM = 50, 48, 8
_WORDS_X, _COLUMNS_X, _GAP, _MARGIN = 14, 192, 8, 14
_WORDS_LETTERS, _NOTE_LETTERS = 20, 28
_BEGIN_SEC, _READ_SEC, _STAY_SEC = 0.3, 0.6, 0.7
# How wide a letter of the headings is.
_HEAD_LETTER = 9.0


@dataclass(frozen=True)
class Move:
    """What travels in a moment."""

    source: str
    """The place that it comes from; empty for from outside."""
    target: str


@dataclass(frozen=True)
class Moment:
    """What some places hold at one time, and how it got there."""

    words: str
    """What happens, e.g. ``'colcon build'``."""
    note: str
    """What is worth seeing in this moment."""
    values: Mapping[str, str]
    """By place, when the moment is over; a place without a value is not in it."""
    moves: Sequence[Move]

    @property
    def text(self) -> str:
        """The moment in words."""
        parts = [f'{name} {value}' for name, value in self.values.items()]
        moves = [f'{self.values[move.target]} arrives at {move.target}' for move in self.moves]
        return f'{self.words}: ' + '; '.join(filter(None, [', '.join(moves), ', '.join(parts), self.note]))


def draw_trail(subject: str, places: Sequence[str], moments: Sequence[Moment]) -> Diagram:
    """Draw what some places hold; at rest all moments stand below each other.

    :param subject: What the picture is of, e.g. a node's name or a file's.
    :param places: Their names, from the left to the right; each stands in the heading of a column.
    """
    notes = [f'{moment.words}: {moment.note}.' for moment in moments if moment.note]
    diagram = Diagram(subject, notes[-1] if notes else f'{len(moments)} moments.',
                      f'{subject}, moment by moment. ' + ' '.join(f'{moment.text}.' for moment in moments),
                      _HEAD + len(moments) * _ROW + _BOTTOM)
    columns = _Columns(places)
    for place in places:
        lines = textwrap.wrap(place, max(6, int(columns.width / _HEAD_LETTER)))[:2]
        diagram.add(svg.box(columns.x(place) - columns.width / 2, 4, columns.width, diagram.height - 8, rounding=8),
                    svg.paragraph(columns.x(place), 29, lines, 'bold'))
    begin_sec, y = _BEGIN_SEC, _HEAD + _ROW / 2
    for moment in moments:
        if y > _HEAD + _ROW:
            diagram.show(begin_sec, svg.path(f'M{_WORDS_X} {y - _ROW / 2}H{WIDTH - _MARGIN}', 'thin'))
        _add_moment(diagram, columns, y, moment, begin_sec)
        begin_sec += _READ_SEC + (TRAVEL_SEC if moment.moves else 0.0) + _STAY_SEC
        y += _ROW
    return diagram


class _Columns:
    """Where the places stand."""

    def __init__(self, places: Sequence[str]) -> None:
        self._places = list(places)
        self.width = (WIDTH - _COLUMNS_X - _MARGIN + _GAP) / len(places) - _GAP

    def x(self, place: str) -> float:
        """Return where the middle of a place's column is."""
        return _COLUMNS_X + self._places.index(place) * (self.width + _GAP) + self.width / 2

    def cut(self, value: str) -> str:
        """Return as much of a value as there is room for."""
        return svg.cut(value, max(4, int((self.width - 28) / svg.LETTER_WIDTH)))


def _add_moment(diagram: Diagram, columns: _Columns, y: float, moment: Moment, begin_sec: float) -> None:
    leaves_sec = begin_sec + _READ_SEC
    diagram.show(begin_sec, svg.words(_WORDS_X, y - 3 if moment.note else y + 4.5,
                                      svg.cut(moment.words, _WORDS_LETTERS), 'bold', anchor='start'))
    if moment.note:
        diagram.show(leaves_sec + TRAVEL_SEC if moment.moves else begin_sec, svg.words(
            _WORDS_X, y + 15, svg.cut(moment.note, _NOTE_LETTERS), 'small', anchor='start'))
    arriving = {move.target for move in moment.moves}
    # Without the frame of what has moved.
    diagram.show(begin_sec, *(svg.words(columns.x(place), y + 4.5, columns.cut(value), 'code')
                              for place, value in moment.values.items() if place not in arriving))
    for move in moment.moves:
        if move.source:
            _add_way(diagram, columns, y, moment, move, leaves_sec)
        else:
            _add_fall(diagram, columns.x(move.target), y, columns.cut(moment.values[move.target]), leaves_sec)


def _add_fall(diagram: Diagram, x: float, y: float, value: str, leaves_sec: float) -> None:
    """Add a value that comes from outside, and so from above."""
    there_sec, top = leaves_sec + TRAVEL_SEC, y - _ROW / 2
    diagram.show(there_sec - .2, svg.arrow(x, top + 1, x, y - 14))
    diagram.add(Moving(svg.token(value), [(leaves_sec, x, top - 6), (there_sec, x, y)], from_sec=leaves_sec - .1))


def _add_way(diagram: Diagram, columns: _Columns, y: float, moment: Moment, move: Move, leaves_sec: float) -> None:
    """Add a value that travels to the right."""
    value, held = (columns.cut(moment.values.get(place, '')) for place in (move.target, move.source))
    from_x, to_x, half = columns.x(move.source), columns.x(move.target), svg.token_width(value) / 2
    begin_x = from_x + .55 * svg.LETTER_WIDTH * len(held) + 6
    diagram.journey(svg.token(value), half, begin_x, from_x, to_x, y, leaves_sec)
