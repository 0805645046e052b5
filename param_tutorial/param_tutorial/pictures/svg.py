"""The strokes and words that plots and diagrams consist of, in the page's own colors. No ROS, no Jupyter.

Pictures are stored in the chapters and compared, so they have to come out the same to the byte on every machine.
JupyterLab's variables follow its theme; the colors behind them are for a page that has no such variables.
"""

import html
from collections.abc import Iterable

INK = 'var(--jp-ui-font-color1, #212121)'
FAINT = 'var(--jp-border-color2, #bdbdbd)'
BRAND = 'var(--jp-brand-color1, #1976d2)'
PAPER = 'var(--jp-layout-color2, #eee)'
_TEXT = f'fill="{INK}" font-size="13" font-family="var(--jp-ui-font-family, sans-serif)"'


def picture(text: str, width: int, height: int, parts: Iterable[str]) -> str:
    """Return parts put together as a picture that shrinks with its page.

    :param text: The picture in words, for those who cannot see it.
    """
    return (f'<svg role="img" aria-label="{html.escape(text)}" viewBox="0 0 {width} {height}" '
            f'width="{width}" style="max-width:100%;height:auto">{"".join(parts)}</svg>')


def line(x1: float, y1: float, x2: float, y2: float, style: str) -> str:
    """Return a line."""
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}/>'


def words(x: float, y: float, text: str, anchor: str, style: str = '') -> str:
    """Return a line of text.

    :param anchor: What stands at x: the text's 'start', 'middle' or 'end'.
    """
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {_TEXT}{style}>{html.escape(text)}</text>'


def arrow(x1: float, y1: float, x2: float, y2: float, style: str) -> str:
    """Return a line with a head at its second end."""
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    along_x, along_y = (x2 - x1) / length, (y2 - y1) / length
    foot_x, foot_y = x2 - 9 * along_x, y2 - 9 * along_y
    corners = [(x2, y2), (foot_x - 4 * along_y, foot_y + 4 * along_x), (foot_x + 4 * along_y, foot_y - 4 * along_x)]
    head = ' '.join(f'{x:.1f},{y:.1f}' for x, y in corners)
    return line(x1, y1, foot_x, foot_y, style) + f'<polygon points="{head}" fill="{INK}"/>'
