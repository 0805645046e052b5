"""Curves as pictures in the page's own colors, without a plotting library.

The lessons draw curves with few corners, and compare the stored picture with a new one: it has to come out the same
to the byte on every machine, and to be readable in a light and a dark theme, without color, and without eyes.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing.svg import BRAND, FAINT, INK, line, picture, plain_words

Points = Sequence[tuple[float, float]]

# As narrow as the place beside the text of a notebook, where the letters are then 11 px high.
_WIDTH, _SHOWN_WIDTH = 420, 500
_LEFT, _RIGHT = 44, 408
_TOP, _LINES_HEIGHT, _FOOT, _ROW = 40, 140, 44, 18
# A letter of the key, on the safe side: only the browser knows its width. The stroke before a name, and both gaps.
_LETTER, _STROKE, _GAP = 8, 38, 16
_TICKS = 6
# Lines differ by their dashes too, so that color is not needed.
_STROKES = (
    f'stroke="{INK}" stroke-dasharray="7 5"',
    f'stroke="{BRAND}"',
    'stroke="var(--jp-error-color1, #d32f2f)" stroke-dasharray="2 4"',
    f'stroke="{INK}" stroke-dasharray="12 3 2 3"',
)
# What was there before: fainter than any line, and thin.
_BEFORE = f'stroke="{INK}" stroke-opacity="0.45"'
_BEFORE_NAME = 'before'


@dataclass(frozen=True)
class Band:
    """Where lines are to end up, in the units of the axes."""

    from_x: float
    low: float
    high: float

    def __str__(self) -> str:
        return f'target: {self.low:g} to {self.high:g} from {self.from_x:g} on'


class LinePlot:
    """Lines through points, with axes and a key. Show it as the last line of a cell."""

    def __init__(self, lines: Mapping[str, Points], *, x: str, y: str, marks: Mapping[float, str] | None = None,
                 y_reaches: float = 0.0, text: str = '', before: Points = (), band: Band | None = None) -> None:
        """
        :param lines: For each line its name and its points, x and y; four lines at most.
        :param x: What the horizontal axis shows, with its unit, e.g. ``'time in s'``. It begins at 0.
        :param y: What the vertical axis shows. It begins at 0, or below where a line goes there.
        :param marks: Places on the horizontal axis, each with a word.
        :param y_reaches: What the vertical axis reaches at least, so that plots can be compared.
        :param text: The lines in words, where they have too many points to name each.
        :param before: The line that was there before, to compare the others with.
        :param band: Where the lines are to end up.
        :raises ValueError: there is no point, or there are more than four lines.
        """
        if not any(lines.values()) or len(lines) > len(_STROKES):
            raise ValueError(f'a LinePlot takes one to {len(_STROKES)} lines, with points; got {len(lines)} lines')
        self._lines, self._x, self._y, self._marks = dict(lines), x, y, dict(marks or {})
        self._text = text
        self._before, self._band = before, band
        self._key = self._place_key()
        self._top = max(y for _, y in self._key) + _TOP - 16
        points = [point for line in lines.values() for point in line]
        self._x_step, self._x_end = _scale(max(x for x, _ in points))
        lowest, highest = min(0.0, *(y for _, y in points)), max(y_reaches, *(y for _, y in points))
        self._y_step, _ = _scale(max(0.0, highest) - lowest)
        self._y_begin = math.floor(lowest / self._y_step + 1e-9) * self._y_step
        self._y_end = max(1, math.ceil(highest / self._y_step - 1e-9)) * self._y_step

    @property
    def text(self) -> str:
        """The plot in words, as a screen reader tells it."""
        lines = [self._text] if self._text else [
            f'{name}: ' + ', '.join(f'{y:.2f} at {x:.2f}' for x, y in points) for name, points in self._lines.items()]
        marks = [f'{word} at {x:g}' for x, word in self._marks.items()]
        band = [f'{self._band}'] if self._band else []
        return f'{self._y} over {self._x}. ' + '. '.join([*lines, *marks, *band])

    def __repr__(self) -> str:
        return f'<LinePlot: {self.text}>'

    def _repr_html_(self) -> str:
        parts = [*self._band_parts(), *self._axis_parts(), *self._mark_parts(), *self._line_parts()]
        return picture(self.text, _WIDTH, self._bottom + _FOOT, parts, shown_width=_SHOWN_WIDTH)

    @property
    def _bottom(self) -> int:
        return self._top + _LINES_HEIGHT

    def _place_key(self) -> list[tuple[int, int]]:
        """Return where each name of the key begins: right of what the vertical axis shows, or in rows below."""
        widths = [_STROKE + _LETTER * len(name) for name in (*self._lines, *[_BEFORE_NAME] * bool(self._before))]
        begin = _RIGHT - sum(widths) - _GAP * (len(widths) - 1)
        places, x, y = [], begin, 16
        if begin < _LETTER * len(self._y) + 2 * _GAP:
            x, y = _LEFT, 16 + _ROW
        for width in widths:
            if y > 16 and x > _LEFT and x + width > _WIDTH:
                x, y = _LEFT, y + _ROW
            places.append((x + _STROKE, y))
            x += width + _GAP
        return places

    def _at(self, x: float, y: float) -> tuple[float, float]:
        return (_LEFT + (_RIGHT - _LEFT) * x / self._x_end,
                self._bottom - _LINES_HEIGHT * (y - self._y_begin) / (self._y_end - self._y_begin))

    def _band_parts(self) -> Iterator[str]:
        if self._band:
            (x, top), (_, bottom) = self._at(self._band.from_x, self._band.high), self._at(0, self._band.low)
            yield (f'<rect x="{x:.1f}" y="{top:.1f}" width="{_RIGHT - x:.1f}" height="{bottom - top:.1f}" '
                   f'fill="{BRAND}" fill-opacity="0.18" stroke="{INK}" stroke-opacity="0.5" stroke-dasharray="2 3"/>')
            yield plain_words(_RIGHT - 2, top - 5, 'target', 'end')

    def _axis_parts(self) -> Iterator[str]:
        for index in range(round(self._y_begin / self._y_step), round(self._y_end / self._y_step) + 1):
            _, at = self._at(0, index * self._y_step)
            yield line(_LEFT, at, _RIGHT, at, f'stroke="{FAINT}"')
            yield plain_words(_LEFT - 8, at + 4, f'{index * self._y_step:g}', 'end')
        for index in range(round(self._x_end / self._x_step) + 1):
            at, _ = self._at(index * self._x_step, 0)
            yield line(at, self._bottom, at, self._bottom + 5, f'stroke="{INK}"')
            yield plain_words(at, self._bottom + 20, f'{index * self._x_step:g}', 'middle')
        yield line(_LEFT, self._bottom, _RIGHT, self._bottom, f'stroke="{INK}"')
        yield plain_words((_LEFT + _RIGHT) / 2, self._bottom + _FOOT - 6, self._x, 'middle')
        yield plain_words(6, 16, self._y, 'start')

    def _mark_parts(self) -> Iterator[str]:
        for x, word in self._marks.items():
            at, _ = self._at(x, 0)
            yield line(at, self._top - 6, at, self._bottom, f'stroke="{INK}" stroke-dasharray="1 3"')
            yield plain_words(at, self._top - 10, word, 'middle')

    def _line_parts(self) -> Iterator[str]:
        strokes = [(2.5, stroke, name, points) for stroke, (name, points) in zip(_STROKES, self._lines.items())]
        if self._before:
            strokes.append((1.5, _BEFORE, _BEFORE_NAME, self._before))
        # The last is the first to be drawn, so that it lies below the others.
        for (x, y), (width, stroke, name, points) in reversed([*zip(self._key, strokes)]):
            corners = ' '.join('{:.1f},{:.1f}'.format(*self._at(*point)) for point in points)
            yield (f'<polyline points="{corners}" fill="none" stroke-width="{width}" stroke-linejoin="round" '
                   f'{stroke}/>')
            yield plain_words(x, y, name, 'start')
            yield line(x - _STROKE, y - 4, x - 8, y - 4, f'stroke-width="{width}" {stroke}')


def _scale(largest: float) -> tuple[float, float]:
    """Return a step of 1, 2 or 5 times a power of ten, and its first multiple that is not less than a value."""
    if largest <= 0:
        return 1.0, 1.0
    rough = largest / _TICKS
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough * (1 - 1e-9))
    return step, math.ceil(largest / step - 1e-9) * step
