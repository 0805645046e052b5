"""The strokes, boxes, words and animations that all drawings share, in the page's own colors.

Drawings are stored in the chapters and compared, so they have to come out the same to the byte on every machine.
JupyterLab's variables follow its theme; the colors behind them are for a page that has no such variables.

No frames are drawn here: the parts of a picture carry CSS animations, so the browser moves them by itself, at its own
rate. Every part carries its last state too. That state is what stands where the animation has ended, where the reader
wants no motion, and where a page is printed.

A ``kind`` is a class of ``svg.css`` without its prefix, or several; a ``style`` is an attribute from an Animation.
"""

import copy
import html
import itertools
import textwrap
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence

from param_tools.markup import styles

INK = 'var(--jp-ui-font-color1, #212121)'
FAINT = 'var(--jp-border-color2, #bdbdbd)'
BRAND = 'var(--jp-brand-color1, #1976d2)'
PAPER = 'var(--jp-layout-color2, #eee)'
BOLD = ' font-weight="bold"'
STROKE = f'stroke="{INK}" stroke-width="1.5"'
DASHES = ' stroke-dasharray="5 4"'
_TEXT = f' fill="{INK}" font-size="13" font-family="var(--jp-ui-font-family, sans-serif)"'

STYLE = styles.style('param_tutorial/views/drawing/svg.css')

# Estimates, since only the browser knows how wide a letter is: of the page's font, and of the font for code.
LETTER_WIDTH, CODE_WIDTH = 7.6, 8.3
_FADE_SEC, _BLINK_SEC = 0.25, 0.05
_WIDE, _NARROW = 720, 300

Stop = tuple[float, float, float]
"""When something is where: seconds, and x and y in the picture's units."""


# -- motion --------------------------------------------------------------------------------------------------


class Animation:
    """The animations of one picture; each begins when the picture comes onto the page."""

    def __init__(self, name: str = '', *, is_still: bool = False) -> None:
        """
        :param name: Begins the names of the keyframes, which belong to the whole page: two pictures on one page need
            different names, unless they are the same.
        :param is_still: Whether everything stands as it does at the end.
        """
        self._name = name
        self._is_still = is_still
        self._numbers = itertools.count(1)
        self._keyframes: list[str] = []
        self.duration_sec = 0.0
        """When the last animation ends."""

    def track(self, frames: Sequence[tuple[float, str]], easing: str = 'ease-in-out') -> str:
        """Return a style attribute that leads through some states, and stays in the last.

        :param frames: Seconds and CSS declarations without a semicolon, e.g. ``(0.5, 'opacity:1')``.
        :param easing: The CSS timing function from each state to the next.
        """
        end_sec, rest = frames[-1]
        self.duration_sec = max(self.duration_sec, end_sec)
        if self._is_still or end_sec <= 0 or all(state == rest for _, state in frames):
            return f' style="{rest}"'
        name = f'{self._name}-{next(self._numbers)}'
        steps = ''.join(f'{100 * at_sec / end_sec:.2f}% {{{state};animation-timing-function:{easing}}}'
                        for at_sec, state in frames)
        self._keyframes.append(f'@keyframes {name} {{{steps}}}')
        return f' style="{rest};animation:{name} {end_sec:.2f}s both"'

    def appear(self, at_sec: float) -> str:
        """Return a style attribute for what is not there before a moment, and then stays."""
        return self.track([(0, 'opacity:0'), (at_sec, 'opacity:0'), (at_sec + _FADE_SEC, 'opacity:1')], 'linear')

    def shown(self, from_sec: float, to_sec: float | None = None) -> str:
        """Return a style attribute for what is there from one moment until another; None for to the end."""
        frames = [(0.0, 'opacity:1')] if from_sec <= 0 else [
            (0.0, 'opacity:0'), (from_sec, 'opacity:0'), (from_sec + _BLINK_SEC, 'opacity:1')]
        if to_sec is not None:
            frames += [(to_sec, 'opacity:1'), (to_sec + _BLINK_SEC, 'opacity:0')]
        return self.track(frames, 'linear')

    def travel(self, stops: Iterable[Stop], easing: str = 'ease-in-out', *, from_sec: float = 0.0,
               goes: bool = False) -> str:
        """Return a style attribute for what stands at its first stop, and then travels from stop to stop.

        :param from_sec: When it appears; 0 for what is there from the beginning.
        :param goes: Whether it is gone at the end.
        """
        first, *others = stops
        stops = [(0.0, *first[1:]), first, *others] if first[0] > 0 else [first, *others]
        opaque = 'opacity:1;' if from_sec > 0 or goes else ''
        frames = [(at_sec, f'{opaque}{place(x, y)}') for at_sec, x, y in stops]
        if from_sec > 0:
            hidden = f'opacity:0;{place(*first[1:])}'
            frames = [(0.0, hidden), (from_sec, hidden),
                      *((max(at_sec, from_sec + _BLINK_SEC), state) for at_sec, state in frames)]
        if goes:
            end_sec, x, y = stops[-1]
            frames.append((end_sec + _BLINK_SEC, f'opacity:0;{place(x, y)}'))
        return self.track(frames, easing)

    @property
    def moves(self) -> bool:
        return bool(self._keyframes)

    def keyframes(self) -> str:
        """Return the keyframes of all tracks so far as a style element; empty if nothing moves."""
        return f'<style>{"".join(self._keyframes)}</style>' if self._keyframes else ''


def place(x: float, y: float) -> str:
    """Return the CSS that moves a part, drawn around 0, 0, to a place in the picture's units."""
    return f'transform:translate({x:.1f}px,{y:.1f}px)'


# -- whole pictures ------------------------------------------------------------------------------------------


class AnimatedPicture(ABC):
    """A picture under a heading, which plays when it comes onto the page, and again when its button is pressed."""

    subject: str
    """The node or the thing that the picture is of."""
    _width = _WIDE
    _has_narrow = False
    """Whether the picture can be drawn for a narrow page, too; another one scrolls there."""

    @property
    @abstractmethod
    def sentence(self) -> str:
        """What the picture shows, in short."""

    @property
    @abstractmethod
    def text(self) -> str:
        """The whole picture in words, as a screen reader tells it."""

    @property
    @abstractmethod
    def _height(self) -> float:
        """How high the picture is, in its own units."""

    @abstractmethod
    def _parts(self, animation: Animation) -> Iterator[str]:
        """Yield the parts of the picture, from the back to the front."""

    def html(self, animation: Animation) -> str:
        """Return the picture as HTML.

        The button needs no script: while it is pressed, nothing is animated, so everything begins anew afterwards.
        """
        scenes = [self._scene(animation)]
        if self._has_narrow:
            narrow = copy.copy(self)
            narrow._width = _NARROW
            scenes.append(narrow._scene(animation))
        # The sentence tells the end, so it appears at the end.
        told = animation.appear(animation.duration_sec - _FADE_SEC) if animation.moves else ''
        again = '<button type="button" class="motion-again" tabindex="0">Play again</button>' * animation.moves
        return (f'<div class="motion">{animation.keyframes()}{again}{head(self.subject, self.sentence, told)}'
                f'<div class="motion-scene" role="img" aria-label="{html.escape(self.text)}">'
                f'{"".join(scenes)}</div></div>')

    @property
    def _is_narrow(self) -> bool:
        return self._width < _WIDE

    def _scene(self, animation: Animation) -> str:
        kind = ' class="motion-narrow"' * self._is_narrow
        parts = ''.join(self._parts(animation))
        return f'<svg{kind} viewBox="0 0 {self._width} {round(self._height)}" aria-hidden="true">{parts}</svg>'


def head(subject: str, sentence: str, style: str = '') -> str:
    """Return the heading above an animated picture."""
    return (f'<div class="motion-head"><span class="motion-name">{html.escape(subject)}</span>'
            f'<span class="motion-words"{style}>{html.escape(sentence)}</span></div>')


def picture(text: str, width: int, height: int, parts: Iterable[str], *, shown_width: int = 0) -> str:
    """Return parts as a picture that needs no style sheet, does not move, and shrinks with its page.

    :param text: The picture in words, for those who cannot see it.
    :param shown_width: In pixels, where there is room; by default that of the parts.
    """
    return (f'<svg role="img" aria-label="{html.escape(text)}" viewBox="0 0 {width} {height}" '
            f'width="{shown_width or width}" style="max-width:100%;height:auto">{"".join(parts)}</svg>')


# -- parts of pictures ---------------------------------------------------------------------------------------


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


def plain_words(x: float, y: float, text: str, anchor: str, attributes: str = '') -> str:
    """Return a line of text for a picture that has no style sheet."""
    return words(x, y, text, anchor=anchor, style=_TEXT + attributes)


def paragraph(x: float, y: float, lines: Sequence[str], kind: str = '', *, anchor: str = 'middle') -> str:
    """Return lines of text; y is the baseline of the line in the middle."""
    return ''.join(words(x, y + 16 * (number - (len(lines) - 1) / 2), line, kind, anchor=anchor)
                   for number, line in enumerate(lines))


def line(x1: float, y1: float, x2: float, y2: float, attributes: str) -> str:
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {attributes}/>'


def arrow(x1: float, y1: float, x2: float, y2: float, kind: str = 'line', *, attributes: str = '') -> str:
    """Return a line with a head at its second end.

    :param attributes: Of the line, in the place of a kind.
    """
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    along_x, along_y = (x2 - x1) / length, (y2 - y1) / length
    foot_x, foot_y = x2 - 9 * along_x, y2 - 9 * along_y
    corners = [(x2, y2), (foot_x - 4 * along_y, foot_y + 4 * along_x), (foot_x + 4 * along_y, foot_y - 4 * along_x)]
    tip = ' '.join(f'{x:.1f},{y:.1f}' for x, y in corners)
    return (line(x1, y1, foot_x, foot_y, attributes or _class(kind).lstrip())
            + f'<polygon points="{tip}" fill="{INK}"/>')


def path(way: str, kind: str = 'line', style: str = '') -> str:
    return f'<path d="{way}"{_class(kind)}{style}/>'


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


def strike(x: float, y: float, text: str, style: str = '') -> str:
    """Return a line through a text that stands around a place."""
    half = .55 * LETTER_WIDTH * len(text) + 5
    return path(f'M{x - half:.1f} {y:.1f}h{2 * half:.1f}', 'thick', style)


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
