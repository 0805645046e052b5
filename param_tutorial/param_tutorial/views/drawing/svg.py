"""The strokes, boxes and words that all drawings share, in the page's own colors.

Drawings are stored in the chapters and compared, so they have to come out the same to the byte on every machine.
JupyterLab's variables follow its theme; the colors behind them are for a page that has no such variables.

A ``kind`` is a class of ``svg.css`` without its prefix, or several; a ``style`` is an attribute.
"""

import html
import textwrap
from collections.abc import Iterable, Sequence

from param_tools.markup import styles

INK = 'var(--jp-ui-font-color1, #212121)'
FAINT = 'var(--jp-border-color2, #bdbdbd)'
BRAND = 'var(--jp-brand-color1, #1976d2)'
PAPER = 'var(--jp-layout-color2, #eee)'
_TEXT = f' fill="{INK}" font-size="13" font-family="var(--jp-ui-font-family, sans-serif)"'

STYLE = styles.style('param_tutorial/views/drawing/svg.css')

# Estimates, since only the browser knows how wide a letter is: of the page's font, and of the font for code.
LETTER_WIDTH, CODE_WIDTH = 7.6, 8.3


def picture(text: str, width: int, height: int, parts: Iterable[str], *, shown_width: int = 0) -> str:
    """Return parts as a picture that needs no style sheet, does not move, and shrinks with its page.

    :param text: The picture in words, for those who cannot see it.
    :param shown_width: In pixels, where there is room; by default that of the parts.
    """
    return (f'<svg role="img" aria-label="{html.escape(text)}" viewBox="0 0 {width} {height}" '
            f'width="{shown_width or width}" style="max-width:100%;height:auto">{"".join(parts)}</svg>')


def _class(kind: str) -> str:
    return f' class="{" ".join(f"motion-{each}" for each in kind.split())}"' if kind else ''


def group(parts: Iterable[str] | str, style: str = '', kind: str = '') -> str:
    """Return parts as one that can move."""
    return f'<g{_class(kind)}{style}>{"".join(parts)}</g>'


def words(x: float, y: float, text: str, kind: str = '', *, anchor: str = 'middle', style: str = '',
          css_class: str = '') -> str:
    """Return a line of text; y is its baseline.

    :param anchor: What stands at x: the text's 'start', 'middle' or 'end'.
    :param css_class: In the place of a kind, for a picture that has a style sheet of its own.
    """
    named = f' class="{css_class}"' if css_class else _class(kind)
    return f'<text{named} x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{style}>{html.escape(text)}</text>'


def plain_words(x: float, y: float, text: str, anchor: str) -> str:
    """Return a line of text for a picture that has no style sheet."""
    return words(x, y, text, anchor=anchor, style=_TEXT)


def paragraph(x: float, y: float, lines: Sequence[str], kind: str = '', *, anchor: str = 'middle') -> str:
    """Return lines of text; y is the baseline of the line in the middle."""
    return ''.join(words(x, y + 16 * (number - (len(lines) - 1) / 2), line, kind, anchor=anchor)
                   for number, line in enumerate(lines))


def line(x1: float, y1: float, x2: float, y2: float, attributes: str) -> str:
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {attributes}/>'


def arrow(x1: float, y1: float, x2: float, y2: float, kind: str = 'line') -> str:
    """Return a line with a head at its second end."""
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    along_x, along_y = (x2 - x1) / length, (y2 - y1) / length
    foot_x, foot_y = x2 - 9 * along_x, y2 - 9 * along_y
    corners = [(x2, y2), (foot_x - 4 * along_y, foot_y + 4 * along_x), (foot_x + 4 * along_y, foot_y - 4 * along_x)]
    tip = ' '.join(f'{x:.1f},{y:.1f}' for x, y in corners)
    return (line(x1, y1, foot_x, foot_y, _class(kind).lstrip())
            + f'<polygon points="{tip}" fill="{INK}"/>')


def path(way: str, kind: str = 'line') -> str:
    return f'<path d="{way}"{_class(kind)}/>'


def box(x: float, y: float, width: float, height: float, kind: str = 'box', *, rounding: float = 4) -> str:
    """Return a box with its upper left corner at a place."""
    return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="{rounding:.1f}"'
            f'{_class(kind)}/>')


def named_box(x: float, y: float, width: float, height: float, name: str, note: str = '', kind: str = 'blank', *,
              rounding: float = 4) -> str:
    """Return a box with a name in its middle, and with a note below the name."""
    middle_x, middle_y, name = x + width / 2, y + height / 2, cut(name, int((width - 8) / CODE_WIDTH))
    return (box(x, y, width, height, kind, rounding=rounding)
            + words(middle_x, middle_y - 3 if note else middle_y + 4.5, name, 'code')
            + (words(middle_x, middle_y + 13, note, 'small') if note else ''))


def circle(x: float, y: float, radius: float, kind: str = 'fill') -> str:
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}"{_class(kind)}/>'


def check(x: float, y: float, reach: float = 6) -> str:
    return path(f'M{x - reach:.1f} {y:.1f}l{.75 * reach:.1f} {.8 * reach:.1f}l{1.3 * reach:.1f} {-1.8 * reach:.1f}',
                'check')


def cross(x: float, y: float, reach: float = 6, kind: str = 'cross') -> str:
    return path(f'M{x - reach:.1f} {y - reach:.1f}l{2 * reach} {2 * reach}'
                f'M{x + reach:.1f} {y - reach:.1f}l{-2 * reach} {2 * reach}', kind)


def token(text: str, kind: str = 'token') -> str:
    """Return a small tag with a value, around 0, 0."""
    width = token_width(text)
    return box(-width / 2, -13, width, 26, kind, rounding=13) + words(0, 4.5, text, 'value')


def token_width(text: str) -> float:
    return max(34.0, LETTER_WIDTH * len(text) + 20)


def cut(text: str, letters: int) -> str:
    """Return a text that is not longer than so many letters."""
    return text if len(text) <= letters else f'{text[:letters - 1]}…'


def in_two_lines(text: str, letters: int) -> list[str]:
    """Return a text in one line or two; what does not fit is cut off."""
    first, *rest = textwrap.wrap(text, letters) or ['']
    return [first, cut(' '.join(rest), letters)] if rest else [first]
