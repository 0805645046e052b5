"""An animated picture as data: its parts, the moments in which they are seen, and the places where they go.

No frames are drawn here: the parts of a picture carry CSS animations, so the browser moves them by itself, at its own
rate. Every part carries its last state too. That state is what stands where the animation has ended, where the reader
wants no motion, and where a page is printed.
"""

import html
import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from param_tutorial.views.drawing import svg

Part: TypeAlias = 'str | Seen | Moving'
"""SVG that stays as it is, or what comes, goes and moves."""

Stop = tuple[float, float, float]
"""When something is where: seconds, and x and y in the picture's units."""

_Frames = list[tuple[float, str]]
"""Seconds and CSS declarations without a semicolon, e.g. ``(0.5, 'opacity:1')``."""

WIDTH = 720
TRAVEL_SEC = 0.8
_FADE_SEC, _BLINK_SEC = 0.25, 0.05


@dataclass(frozen=True)
class Seen:
    """Parts that are there from one moment until another."""

    parts: 'Part | Sequence[Part]'
    from_sec: float = 0.0
    to_sec: float | None = None
    """None for to the end."""
    easing = 'linear'

    def frames(self) -> _Frames:
        """Return the states of the parts."""
        there_sec = self.from_sec + _FADE_SEC if self.to_sec is None else min(self.from_sec + _FADE_SEC, self.to_sec)
        frames = [(0.0, 'opacity:1')]
        if self.from_sec > 0:
            frames = [(0.0, 'opacity:0'), (self.from_sec, 'opacity:0'), (there_sec, 'opacity:1')]
        if self.to_sec is not None:
            frames += [(self.to_sec, 'opacity:1'), (self.to_sec + _FADE_SEC, 'opacity:0')]
        return frames


@dataclass(frozen=True)
class Moving:
    """Parts that stand at their first stop, and then travel from stop to stop."""

    parts: 'Part | Sequence[Part]'
    stops: Sequence[Stop]
    from_sec: float = 0.0
    """When they appear; 0 for what is there from the beginning."""
    goes: bool = False
    """Whether they are gone at the end."""
    easing: str = 'ease-in-out'

    def frames(self) -> _Frames:
        """Return the states of the parts."""
        first, last = self.stops[0], self.stops[-1]
        stops = [(0.0, *first[1:]), *self.stops] if first[0] > 0 else self.stops
        opaque = 'opacity:1;' if self.from_sec > 0 or self.goes else ''
        frames = [(at_sec, f'{opaque}{_place(x, y)}') for at_sec, x, y in stops]
        if self.from_sec > 0:
            hidden = f'opacity:0;{_place(*first[1:])}'
            frames = [(0.0, hidden), (self.from_sec, hidden),
                      *((max(at_sec, self.from_sec + _BLINK_SEC), state) for at_sec, state in frames)]
        if self.goes:
            frames.append((last[0] + _BLINK_SEC, f'opacity:0;{_place(*last[1:])}'))
        return frames


class Diagram:
    """A picture under a heading, which plays when it comes onto the page, and again when its button is pressed.

    It is as wide as it has to be for its letters; a narrow page scrolls it.
    """

    def __init__(self, subject: str, sentence: str, text: str, height: float) -> None:
        """
        :param subject: The node or the thing that the picture is of.
        :param sentence: What the picture shows, in short.
        :param text: The whole picture in words, as a screen reader tells it.
        """
        self.subject, self.sentence, self.text = subject, sentence, text
        self.height = height
        self._parts: list[Part] = []

    def add(self, *parts: Part) -> None:
        """Add parts, from the back to the front."""
        self._parts += parts

    def show(self, from_sec: float, *parts: Part, to_sec: float | None = None) -> None:
        """Add parts that are there from one moment on."""
        self.add(Seen(parts, from_sec, to_sec))

    def journey(self, token: str, half: float, begin_x: float, from_x: float, to_x: float, y: float,
                leaves_sec: float) -> float:
        """Add a token that travels to the left or to the right, and the road that it leaves behind.

        :param half: Half as wide as the token.
        :param begin_x: Where its road begins.
        :return: When it arrives.
        """
        there_sec, ahead = leaves_sec + TRAVEL_SEC, 1 if to_x > from_x else -1
        end_x = to_x - ahead * (half + 3)
        if ahead * (end_x - begin_x) > 10:
            self.show(there_sec - .2, svg.arrow(begin_x, y, end_x, y))
        self.add(Moving(token, [(leaves_sec, from_x, y), (there_sec, to_x, y)], from_sec=leaves_sec - .1))
        return there_sec

    def html(self, name: str) -> str:
        """Return the picture as HTML.

        The button needs no script: while it is pressed, nothing is animated, so everything begins anew afterwards.

        :param name: Begins the names of the keyframes, which belong to the whole page: two pictures on one page need
            different names, unless they are the same.
        """
        animation = _Animation(name)
        scene = animation.drawn(self._parts)
        # The sentence tells the end, so it appears at the end.
        sentence_style = animation.style(Seen('', animation.duration_sec - _FADE_SEC)) if animation.keyframes else ''
        again = '<button type="button" class="motion-again" tabindex="0">Play again</button>'
        moves = f'<style>{"".join(animation.keyframes)}</style>{again}' if animation.keyframes else ''
        return (f'<div class="motion">{moves}{head(self.subject, self.sentence, sentence_style)}'
                f'<div class="motion-scene" role="img" aria-label="{html.escape(self.text)}">'
                f'<svg viewBox="0 0 {WIDTH} {round(self.height)}" aria-hidden="true">{scene}</svg></div></div>')


class _Animation:
    """The animations of one picture; each begins when the picture comes onto the page."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._numbers = itertools.count(1)
        self.keyframes: list[str] = []
        self.duration_sec = 0.0
        """When the last animation ends."""

    def drawn(self, parts: 'Part | Iterable[Part]') -> str:
        """Return parts as SVG."""
        if isinstance(parts, str):
            return parts
        if isinstance(parts, Seen | Moving):
            return svg.group(self.drawn(parts.parts), self.style(parts))
        return ''.join(map(self.drawn, parts))

    def style(self, part: Seen | Moving) -> str:
        """Return a style attribute that leads through the states of a part, and stays in the last."""
        frames = part.frames()
        end_sec, rest = frames[-1]
        self.duration_sec = max(self.duration_sec, end_sec)
        if end_sec <= 0 or all(state == rest for _, state in frames):
            return f' style="{rest}"'
        name = f'{self._name}-{next(self._numbers)}'
        steps = ''.join(f'{100 * at_sec / end_sec:.2f}% {{{state};animation-timing-function:{part.easing}}}'
                        for at_sec, state in frames)
        self.keyframes.append(f'@keyframes {name} {{{steps}}}')
        return f' style="{rest};animation:{name} {end_sec:.2f}s both"'


def head(subject: str, sentence: str, style: str = '') -> str:
    """Return the heading above an animated picture."""
    return (f'<div class="motion-head"><span class="motion-name">{html.escape(subject)}</span>'
            f'<span class="motion-words"{style}>{html.escape(sentence)}</span></div>')


def _place(x: float, y: float) -> str:
    """Return the CSS that moves parts to a place in the picture's units."""
    return f'transform:translate({x:.1f}px,{y:.1f}px)'
