"""Step responses as curves, and a wheel that turns as a step response says: at its speeds, in its time, once."""

import hashlib
import itertools
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

from param_tutorial.views.drawing.plots import Band, LinePlot, Points
from param_tutorial.views.drawing.svg import BRAND, INK, PAPER

if TYPE_CHECKING:
    from param_tutorial.nodes.pid_controller_node import StepResponse

# A step response with more points than this is drawn with fewer, since they would lie on one another.
_MAX_POINTS = 200
# The axis has room for this much overshoot, so that it does not change while a gain is dragged.
_ROOM_FOR_OVERSHOOT = 1.5
_FRAMES = 40
_SPOKES = 5


def plot_responses(responses: Mapping[str, 'StepResponse'], *, before: 'StepResponse | None' = None,
                   band: Band | None = None) -> LinePlot:
    """Draw step responses over one another, with the reference of the first.

    :param responses: One to three, by name.
    :param before: One of before, to compare them with.
    :param band: Where they are to end up.
    :raises ValueError: there is none, or there are more.
    :raises TypeError: they are no step responses.
    """
    if not isinstance(responses, Mapping) or not all(hasattr(each, 'figures') for each in responses.values()):
        raise TypeError(f'plot_responses takes a dictionary of step responses, such as '
                        f'{{"p = 0.4": node.response()}}; got {responses!r}')
    if not 1 <= len(responses) <= 3:
        raise ValueError(f'plot_responses takes one to three responses; got {len(responses)}')
    first = next(iter(responses.values()))
    reference = [(0.0, first.reference), (first.points[-1][0], first.reference)]
    text = [f'reference: {first.reference:g} rad/s',
            *(f'{name}: {response.figures}' for name, response in responses.items())]
    return LinePlot({'reference': reference, **{name: _thinned(each.points) for name, each in responses.items()}},
                    x='time in s', y='speed in rad/s', y_reaches=_ROOM_FOR_OVERSHOOT * first.reference,
                    text='. '.join(text), before=_thinned(before.points) if before else (), band=band)


def _thinned(points: Points) -> Points:
    every = math.ceil(len(points) / _MAX_POINTS)
    return [*points[:-1:every], points[-1]]


class Wheel:
    """A wheel that starts from rest and turns as fast as it was measured or simulated."""

    def __init__(self, points: Points) -> None:
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
