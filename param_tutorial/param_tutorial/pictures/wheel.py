"""A wheel that turns as a step response says: at its speeds, in its time, once. Data in, text out."""

import hashlib
import itertools
import math
from collections.abc import Sequence

from param_tutorial.pictures.svg import BRAND, INK, PAPER

_FRAMES = 40
_SPOKES = 5


class Wheel:
    """A wheel that starts from rest and turns as fast as it was measured or simulated."""

    def __init__(self, points: Sequence[tuple[float, float]]) -> None:
        """Take over the points.

        :param points: Time in s, and speed in rad/s; in between the speed changes evenly.
        :raises ValueError: there are not two points.
        """
        if len(points) < 2:
            raise ValueError('a Wheel takes two points at least')
        self.duration_sec = points[-1][0] - points[0][0]
        """How long it turns."""
        angle = 0.0
        angles = [(0.0, 0.0)]
        for (begin, before), (end, after) in itertools.pairwise(points):
            angle += (before + after) / 2 * (end - begin)
            angles.append((end - points[0][0], angle))
        every = math.ceil(len(angles) / _FRAMES)
        self.angles = [*angles[:-1:every], angles[-1]]
        """Time in s, and how far it has turned, in rad."""

    def html(self) -> str:
        """Return it as HTML; the same motion has the same name, so that pictures can be compared."""
        frames = ''.join(f'{100 * at / self.duration_sec:.2f}% {{transform:rotate({math.degrees(angle):.1f}deg)}}'
                         for at, angle in self.angles)
        name = f'wheel-{hashlib.sha256(frames.encode()).hexdigest()[:12]}'
        spokes = ''.join(f'<path d="M50 50V12" transform="rotate({360 * number / _SPOKES:.0f} 50 50)" stroke="{INK}" '
                         f'stroke-width="4"/>' for number in range(_SPOKES))
        rest = f'transform:rotate({math.degrees(self.angles[-1][1]):.1f}deg)'
        keyframes = f'@keyframes {name} {{{frames}}}'
        return (f'<style>{keyframes}</style>'
                f'<svg class="step-wheel" viewBox="0 0 100 100" aria-hidden="true"><g class="step-turn" '
                f'style="{rest};animation:{name} {self.duration_sec:.2f}s linear both">'
                f'<circle cx="50" cy="50" r="42" fill="{PAPER}" stroke="{INK}" stroke-width="8"/>{spokes}'
                f'<circle cx="50" cy="50" r="7" fill="{INK}"/><circle cx="50" cy="20" r="6" fill="{BRAND}" '
                f'stroke="{INK}"/></g></svg>')
