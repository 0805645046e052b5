"""The warehouse cart of CartNode in its aisle: what it looks like, and what it says. ``driving`` makes it move."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from param_tutorial.views.drawing import driving, svg
from param_tutorial.views.drawing.driving import GROUND, HEIGHT, WIDTH, Moment, Vehicle

if TYPE_CHECKING:
    from param_tutorial.nodes.clawbot_node import State

_WHEEL_M = 0.15
_LENGTH_M = 1.5
_MARGIN_M = 0.5


@dataclass(frozen=True)
class Cart(Vehicle):
    """What a picture needs to know about a cart. Its settings' ``stop_m`` is where the aisle ends."""

    node: str
    """The name of its node."""
    sight_m: float
    """How far its scanner sees."""
    before_sec: float = 0.0
    """For how long it had driven when this motion began, because a parameter was changed on the way."""

    @property
    def label(self) -> str:
        return self.node

    @property
    def shown_m(self) -> tuple[float, float]:
        return -_LENGTH_M - _MARGIN_M, self.settings.stop_m + _MARGIN_M

    @property
    def wheel_radius_m(self) -> float:
        return _WHEEL_M

    @property
    def mode(self) -> str:
        """What it has been set to."""
        return f'{self.settings.max_speed_mps:g} m/s, {self.settings.max_acceleration_mps2:g} m/s²'

    def numbers(self, state: 'State', elapsed_sec: float) -> str:
        return f'speed {state.velocity_mps:.2f} m/s, {self.before_sec + elapsed_sec:.1f} s on its way'

    def predicate(self, state: 'State') -> str:
        match state.word:
            case 'READY':
                return 'stands at the beginning of the aisle'
            case 'BRAKING':
                return 'is braking, to stop at the end of the aisle'
            case 'EMERGENCY BRAKING':
                return 'is braking as hard as it can'
            case 'WAITING':
                return 'is waiting'
            case 'STOPPED':
                seconds = self.before_sec + self.motion.duration_sec
                return f'has reached the end of the aisle after {seconds:.2f} s' if seconds else 'stands still'
        return super().predicate(state)

    def behind(self, moment: Moment) -> str:
        shelves = ''
        for n, x in enumerate(range(18, WIDTH, 164)):
            shelves += f'M{x} {GROUND}V48h126V{GROUND}M{x} 92h126M{x} 142h126'
            # Some boxes on each shelf, of several sizes.
            shelves += ''.join(f'M{x + 10 + at} {y}v-{high}h{wide}v{high}' for y, at, wide, high in (
                (92, 4 + 9 * (n % 3), 34, 26), (92, 62, 40 - 6 * (n % 2), 20), (142, 10, 44, 30 - 8 * (n % 2)),
                (142, 70 - 8 * (n % 3), 28, 22)))
        return (f'<rect class="robot-sky" width="{WIDTH}" height="{GROUND}"/>'
                f'<path class="robot-shelves" d="{shelves}"/>'
                f'<rect class="robot-floor" y="{GROUND}" width="{WIDTH}" height="{HEIGHT - GROUND}"/>'
                f'{driving.ruler(self, self.settings.stop_m)}{driving.post(self, 0.0, "start")}'
                f'{driving.legend()}')

    def in_front(self, moment: Moment) -> str:
        words = 'end of the aisle' if self.shown_m[1] > 20 else 'end'
        return driving.post(self, self.settings.stop_m, words, 'robot-stop')

    def drawn(self, moment: Moment, wheel_css: str, cargo_css: str) -> str:
        """Return SVG of the cart, drawn in centimeters; its scanner is at 0, where its front is."""
        scale, radius = self.units_per_m / 100, 100 * _WHEEL_M
        deck = -2 * radius - 12
        color, length = driving.paint(self.node), 100 * _LENGTH_M
        eye, sight = -radius - 6, 100 * self.sight_m
        drawn = (
            f'<g class="robot-cargo" style="{cargo_css}">'
            f'<rect class="robot-box" x="{-length + 22:g}" y="{deck - 42:g}" width="58" height="42" rx="1"/>'
            f'<path class="robot-tape" d="M{-length + 51:g} {deck - 42:g}v42"/></g>'
            f'<g class="robot-cargo" style="{cargo_css}">'
            f'<rect class="robot-box" x="{-length + 84:g}" y="{deck - 60:g}" width="46" height="60" rx="1"/>'
            f'<path class="robot-tape" d="M{-length + 107:g} {deck - 60:g}v60"/></g>'
            f'<path class="robot-beam" d="M-2 {eye:g}L{sight:g} {eye - 16:g}V0H-2Z"/>'
            f'<path class="robot-ray" d="M{sight:g} {eye - 18:g}V0"/>'
            f'<path class="robot-arm" d="M{-length + 6:g} {deck:g}v-58q0 -8 -8 -8"/>'
            f'<rect class="robot-paint robot-paint-{color}" x="{-length:g}" y="{deck:g}" width="{length - 3:g}" '
            f'height="24" rx="4"/>{driving.pattern(color, -length + 8, deck + 4, length - 26, 16)}'
            f'<rect class="robot-part" x="-9" y="{eye - 7:g}" width="9" height="14" rx="2"/>'
            f'<circle class="robot-eye" cx="-3.5" cy="{eye:g}" r="3"/>'
            f'{driving.wheel(-length + 28, radius, wheel_css)}{driving.wheel(-32, radius, wheel_css)}')
        tag = svg.words(-length / 2 * scale, (deck - 74) * scale, self.name, css_class='robot-tag')
        return f'<g class="robot-machine robot-big" transform="scale({scale:.4f})">{drawn}</g>{tag}'
