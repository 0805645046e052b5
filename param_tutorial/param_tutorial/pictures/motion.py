"""What the moving pictures have in common: a stage, boxes, and tokens that travel. Data in, text out.

As with the robot, no frames are drawn here. A picture is SVG whose parts carry CSS animations, so the browser moves
them by itself, at its own rate. Every part carries its last state too: that is what stands where the animation has
ended, where the reader wants no motion, and where a page is printed.
"""

import html
import itertools
from collections.abc import Iterable, Sequence

from param_tools.markup.styles import style

# An estimate, since only the browser knows it.
LETTER_WIDTH = 7.6
_FADE_SEC, _BLINK_SEC = 0.25, 0.05

STYLE = style('param_tutorial/pictures/motion.css')


class Reel:
    """The animations of one picture; each begins when the picture comes onto the page."""

    def __init__(self, name: str = '', *, is_still: bool = False) -> None:
        """
        :param name: Begins the animations' names, which must differ from those of all other pictures on the page
            that are not the same.
        :param is_still: Whether everything is to stand as it does at the end.
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
        if self._is_still or end_sec <= 0 or all(look == rest for _, look in frames):
            return f' style="{rest}"'
        name = f'{self._name}-{next(self._numbers)}'
        steps = ''.join(f'{100 * at_sec / end_sec:.2f}% {{{look};animation-timing-function:{easing}}}'
                        for at_sec, look in frames)
        self._keyframes.append(f'@keyframes {name} {{{steps}}}')
        return f' style="{rest};animation:{name} {end_sec:.2f}s both"'

    def appear(self, at_sec: float) -> str:
        """Return a style attribute for what is not there before a moment, and then stays."""
        return self.track([(0, 'opacity:0'), (at_sec, 'opacity:0'), (at_sec + _FADE_SEC, 'opacity:1')], 'linear')

    def shown(self, from_sec: float, to_sec: float | None = None) -> str:
        """Return a style attribute for what is there from a moment on, and until another; None for to the end."""
        frames = [(0.0, 'opacity:1')] if from_sec <= 0 else [
            (0.0, 'opacity:0'), (from_sec, 'opacity:0'), (from_sec + _BLINK_SEC, 'opacity:1')]
        if to_sec is not None:
            frames += [(to_sec, 'opacity:1'), (to_sec + _BLINK_SEC, 'opacity:0')]
        return self.track(frames, 'linear')

    def travel(self, stops: Iterable[tuple[float, float, float]], easing: str = 'ease-in-out') -> str:
        """Return a style attribute for what travels from place to place.

        :param stops: Seconds, x and y, in the picture's units.
        """
        return self.track([(at_sec, place(x, y)) for at_sec, x, y in stops], easing)

    def travel_and_go(self, stops: Sequence[tuple[float, float, float]], easing: str = 'ease-in-out') -> str:
        """Return a style attribute for what travels from place to place and is gone at the end."""
        end_sec, x, y = stops[-1]
        frames = [(at_sec, f'opacity:1;{place(at_x, at_y)}') for at_sec, at_x, at_y in stops]
        return self.track([*frames, (end_sec + _BLINK_SEC, f'opacity:0;{place(x, y)}')], easing)

    @property
    def moves(self) -> bool:
        """True if anything is animated."""
        return bool(self._keyframes)

    def style(self) -> str:
        """Return the keyframes of all tracks so far as a style element; empty if nothing moves."""
        return f'<style>{"".join(self._keyframes)}</style>' if self._keyframes else ''


def place(x: float, y: float) -> str:
    """Return the CSS that moves a part, drawn around 0, 0, to a place in the picture's units."""
    return f'transform:translate({x:.1f}px,{y:.1f}px)'


def stage(heading: str, words: str, text: str, size: tuple[int, int], parts: Iterable[str], reel: Reel) -> str:
    """Return parts put together as a picture under a heading, with a button that plays it again.

    The button needs no script: while it is pressed, nothing is animated, so everything begins anew afterwards.

    :param heading: The node or the thing that the picture is of.
    :param words: What the picture shows now, in a sentence.
    :param text: The whole picture in words, for those who cannot see it.
    :param size: Its width and height in its own units.
    """
    width, height = size
    body = ''.join(parts)
    # What comes of it is told when it has come of it.
    told = reel.appear(reel.duration_sec - _FADE_SEC) if reel.moves else ''
    again = '<button type="button" class="motion-again" tabindex="0">Play again</button>' if reel.moves else ''
    return (f'<div class="motion">{reel.style()}{again}<div class="motion-head"><span class="motion-name">'
            f'{html.escape(heading)}</span><span class="motion-words"{told}>{html.escape(words)}</span></div>'
            f'<div class="motion-scene" role="img" aria-label="{html.escape(text)}">'
            f'<svg viewBox="0 0 {width} {height}" aria-hidden="true">{body}</svg></div></div>')


def group(parts: Iterable[str] | str, look: str = '', css_class: str = '') -> str:
    """Return parts as one that can move.

    :param look: A style attribute from a reel.
    """
    named = f' class="{css_class}"' if css_class else ''
    return f'<g{named}{look}>{"".join(parts)}</g>'


def label(x: float, y: float, text: str, *, anchor: str = 'middle', css_class: str = '', look: str = '') -> str:
    """Return a line of text; y is its baseline."""
    named = f' class="{css_class}"' if css_class else ''
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{named}{look}>{html.escape(text)}</text>'


def box(x: float, y: float, width: float, height: float, css_class: str = 'motion-box', *, rounding: float = 4,
        look: str = '') -> str:
    """Return a box with its upper left corner at a place."""
    return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="{rounding:.1f}" '
            f'class="{css_class}"{look}/>')


def path(way: str, css_class: str = 'motion-line', look: str = '') -> str:
    """Return a line along an SVG path."""
    return f'<path d="{way}" class="{css_class}"{look}/>'


def arrow(x1: float, y1: float, x2: float, y2: float, css_class: str = 'motion-line') -> str:
    """Return a line with a head at its second end."""
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    along_x, along_y = (x2 - x1) / length, (y2 - y1) / length
    foot_x, foot_y = x2 - 8 * along_x, y2 - 8 * along_y
    return path(f'M{x1:.1f} {y1:.1f}L{foot_x:.1f} {foot_y:.1f}', css_class) + path(
        f'M{x2:.1f} {y2:.1f}L{foot_x - 4 * along_y:.1f} {foot_y + 4 * along_x:.1f}'
        f'L{foot_x + 4 * along_y:.1f} {foot_y - 4 * along_x:.1f}z', 'motion-tip')


def token(text: str, *, css_class: str = 'motion-token') -> str:
    """Return a small tag with a value, whose middle is at 0, 0."""
    width = token_width(text)
    return box(-width / 2, -13, width, 26, css_class, rounding=13) + label(0, 4.5, text, css_class='motion-value')


def token_width(text: str) -> float:
    """Return how wide a token is."""
    return max(34.0, LETTER_WIDTH * len(text) + 20)


def cut(text: str, letters: int) -> str:
    """Return a text that is not longer than so many letters."""
    return text if len(text) <= letters else f'{text[:letters - 1]}…'
