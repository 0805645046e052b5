"""The robot of ClawbotNode and its world: what it looks like, and what it says. ``driving`` makes it move."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from param_tutorial.views.drawing import driving, svg
from param_tutorial.views.drawing.driving import GROUND, HEIGHT, WIDTH, Moment, Vehicle

if TYPE_CHECKING:
    from param_tutorial.nodes.clawbot_node import State

_BEFORE_START_M = 0.8
_BEHIND_WALL_M = 0.35
_WALL_TOP = 52
_DECK_OVER_WHEEL_M, _EYE_OVER_DECK_M = 0.17, 0.07
# The width of its sensor's ray, in the picture's units, as in track.css.
_LASER = 1.6
# What looks like the same place is not marked as a mistake.
_SAME_PLACE_M = 0.005
# Where the pieces of a crash end, for one meter per second: forward, upward, turned by so many degrees.
_PIECES = ((-62, 40, 200), (-105, 8, -310), (-38, 95, 150), (-148, 30, 420), (-84, 66, -120), (-190, 6, 260),
           (-30, 22, -80), (-120, 84, 330), (-230, 12, -200), (-66, 112, 90), (-170, 58, 510), (-270, 4, 380))


@dataclass(frozen=True)
class Robot(Vehicle):
    """What a picture needs to know about a robot."""

    serial_number: str
    wheel_m: float
    """The radius of its wheels."""
    length_m: float = 0.6
    sensor_mount_m: float = 0.15
    """Where its sensor really sits, before its center."""
    temperature_c: int = 15
    """How warm it is around it."""
    waiting_for: str = ''
    """What keeps it from driving, if the motion ends with WAITING."""

    @property
    def label(self) -> str:
        return f'{self.name} ({self.serial_number})'

    @property
    def shown_m(self) -> tuple[float, float]:
        return -_BEFORE_START_M, self.settings.track_m + _BEHIND_WALL_M

    @property
    def wheel_radius_m(self) -> float:
        return self.wheel_m

    @property
    def mode(self) -> str:
        return f'safety {"on" if self.settings.safety_on else "off"}'

    def gap_m(self, state: 'State') -> float:
        """Return how far its front is from the wall."""
        return self.settings.track_m - state.position_m

    def numbers(self, state: 'State', elapsed_sec: float) -> str:
        return f'speed {state.velocity_mps:.2f} m/s, {self.gap_m(state):.2f} m to the wall'

    def predicate(self, state: 'State') -> str:
        match state.word:
            case 'READY':
                return 'stands at the start'
            case 'BRAKING' | 'EMERGENCY BRAKING':
                gap_m = self.gap_m(self.motion.end)
                hard = ' as hard as it can' if state.word == 'EMERGENCY BRAKING' else ''
                return f'is braking{hard}, ' + (f'to stop {gap_m:.2f} m from the wall' if gap_m > 0 else 'too late')
            case 'WAITING':
                return f'is waiting: {self.waiting_for}'
            case 'STOPPED':
                return f'has stopped {self.gap_m(state):.2f} m from the wall'
            case 'CRASHED':
                return f'has run into the wall at {state.crash_speed_mps:.2f} m/s'
        return super().predicate(state)

    # -- what stands still -------------------------------------------------------------------------------

    def behind(self, moment: Moment) -> str:
        """Return SVG of the sky, the weather, the ruler and the start line."""
        cold = self.temperature_c < 0
        degrees = f'{self.temperature_c} °C'.replace('-', '−')
        parts = [f'<rect class="robot-sky{" robot-cold" if cold else ""}" width="{WIDTH}" height="{GROUND}"/>',
                 f'<rect class="robot-floor" y="{GROUND}" width="{WIDTH}" height="{HEIGHT - GROUND}"/>',
                 driving.ruler(self, self.settings.track_m), driving.post(self, 0.0, 'start'),
                 svg.words(215, 24, f'{"❄ " if cold else ""}air {degrees}', anchor='start', css_class='robot-weather'),
                 driving.legend()]
        if cold:
            parts.append(f'<path class="robot-ice" d="{_drift(0, self.x(self.settings.track_m))}"/>')
        return ''.join(parts)

    def in_front(self, moment: Moment) -> str:
        """Return SVG of the wall, of where the robot is to stop, of a crash, and of snow."""
        wall, track_m = self.x(self.settings.track_m), self.settings.track_m
        crashed = moment.state.word == 'CRASHED'
        parts = [f'<rect class="robot-wall" x="{wall:.1f}" y="{_WALL_TOP}" width="{WIDTH - wall + 5:.1f}" '
                 f'height="{GROUND - _WALL_TOP}"/><path class="robot-line robot-bricks" d="{_bricks(wall)}"/>']
        if self.settings.safety_on:
            parts.append(driving.post(self, self.settings.stop_m, 'stop', 'robot-stop'))
        if crashed:
            parts.append(crash(wall, moment.state.crash_speed_mps, self.units_per_m))
        if self.temperature_c < 0:
            parts.append(f'<path class="robot-ice" d="M{wall - 5:.1f} {_WALL_TOP + 2}q4 -9 14 -8T{WIDTH + 6} '
                         f'{_WALL_TOP - 4}V{_WALL_TOP + 2}z"/><g class="robot-snow"><path d="{_flakes(0)}'
                         f'{_flakes(-GROUND)}"/></g>')
        if track_m > 0 and not crashed:
            parts.append(svg.words((wall + WIDTH) / 2, _WALL_TOP - 12, 'wall'))
        return ''.join(parts)

    # -- the robot ---------------------------------------------------------------------------------------

    def drawn(self, moment: Moment, wheel_css: str, cargo_css: str) -> str:
        """Return SVG of the robot, drawn in centimeters; its bumper ends at 0, where its front is."""
        scale, radius = self.units_per_m / 100, 100 * self.wheel_m
        deck = -radius - 100 * _DECK_OVER_WHEEL_M
        center = -50 * self.length_m
        sensor = center + 100 * self.sensor_mount_m
        eye = eye_over(deck)
        color = driving.paint(self.name)
        listens = ''
        if self.settings.safety_on and moment.state.word != 'CRASHED':
            # The wall hides where the ray ends.
            lens, reach = sensor + 3, 10 * self.settings.track_m
            cones = ''.join(f'<path class="robot-beam" d="M{lens:g} {eye:g}l{reach * part:g} -{9 * part:g}'
                            f'v{18 * part:g}z"/>' for part in (1, .75, .5))
            listens = (f'{cones}<path class="robot-laser" d="M{lens:g} {eye:g}h{10 * reach:g}" '
                       f'style="stroke-width:{_LASER / scale:.2f}"/>')
        believed = self.settings.sensor_offset_m
        ghost = ''
        if abs(believed - self.sensor_mount_m) > _SAME_PLACE_M:
            at = center + 100 * believed
            ghost = (f'<g class="robot-ghost"><rect x="{at - 4:g}" y="{eye - 4:g}" width="8" height="8" rx="2"/>'
                     f'<path d="M{at:g} {eye - 6:g}v-16"/></g>'
                     f'<text class="robot-ghost-word" x="{at:g}" y="{eye - 24:g}" text-anchor="middle" '
                     f'style="font-size:{15 / scale:.2f}px">sensor?</text>')
        frost = (f'<path class="robot-ice" d="M-58 {deck + 1:g}q3 -5 9 -3t12 -1t14 0t12 1t7 3z"/>'
                 if self.temperature_c < 0 else '')
        body = machine(color, deck, radius, sensor, wheel_css, cargo_css, behind_arm=listens, on_top=frost + ghost)
        name = svg.words(-33 * scale, (deck - 40) * scale, svg.cut(self.name, 18), css_class='robot-tag')
        return (f'<g transform="scale({scale:.4f})"><g class="robot-machine" style="--crash:'
                f'{min(1.0, moment.state.crash_speed_mps / 1.5):.2f}">{body}</g></g>{name}')


def eye_over(deck: float) -> float:
    """Return how high the eye of its sensor is, in centimeters; upward is negative."""
    return deck - 100 * _EYE_OVER_DECK_M


def machine(color: int, deck: float, radius: float, sensor: float, wheel_css: str, cargo_css: str, *,
            behind_arm: str = '', on_top: str = '') -> str:
    """Return SVG of a robot in centimeters; its bumper ends at 0, where its front is.

    :param color: The number of its paint.
    :param deck: How high its upper side is.
    :param radius: Of its wheels.
    :param sensor: Where its sensor sits.
    """
    eye = eye_over(deck)
    return (
        # The antenna leans as the robot speeds up and brakes. Parts that move by themselves come first and last:
        # each is a layer of the browser's, and so is what lies between two of them.
        f'<g class="robot-antenna" style="{cargo_css}"><path d="M-53 {deck:g}v-30"/>'
        f'<path class="robot-paint robot-paint-{color}" d="M-53 {deck - 30:g}h-12l3 4l-3 4h12z"/></g>'
        f'{behind_arm}'
        # An arm with a claw, raised.
        f'<path class="robot-arm" d="M-43 {deck:g}V{deck - 24:g}L-20 {deck - 33:g}L-11 {deck - 24:g}"/>'
        f'<path class="robot-claw" d="M-15 {deck - 20:g}q-1 -8 5 -8l7 1M-11 {deck - 24:g}q8 5 6 13l-5 4"/>'
        f'<circle class="robot-joint" cx="-43" cy="{deck - 24:g}" r="3"/>'
        f'<circle class="robot-joint" cx="-20" cy="{deck - 33:g}" r="3"/>'
        f'<rect class="robot-paint robot-paint-{color}" x="-59" y="{deck:g}" width="55" height="17" rx="3.5"/>'
        f'{driving.pattern(color, -55, deck + 2, 42, 11)}'
        f'<rect class="robot-bumper" x="-4.4" y="{-radius - 7:g}" width="4" height="12" rx="1.6"/>'
        f'<path class="robot-arm" d="M{sensor:g} {deck:g}v-4"/>'
        f'<rect class="robot-part" x="{sensor - 4:g}" y="{eye - 4:g}" width="8" height="8" rx="2"/>'
        f'<circle class="robot-eye" cx="{sensor + 1.5:g}" cy="{eye:g}" r="2.2"/>{on_top}'
        f'{driving.wheel(-46, radius, wheel_css)}{driving.wheel(-17, radius, wheel_css)}')


def _bricks(wall: float) -> str:
    d = ''
    for row, y in enumerate(range(_WALL_TOP + 22, GROUND, 22)):
        d += f'M{wall:.1f} {y}H{WIDTH}'
        d += ''.join(f'M{x:.1f} {y}v-22' for x in (wall + 14 + 22 * (row % 2) + 44 * n for n in range(3)) if x < WIDTH)
    return d


def _drift(begin: float, end: float) -> str:
    """Return the outline of snow on the ground."""
    waves = ''.join(f'q{(end - begin) / 16:.1f} {-9 if n % 2 else -15} {(end - begin) / 8:.1f} 0' for n in range(8))
    return f'M{begin:.1f} {GROUND}{waves}v4H{begin:.1f}z'


def _flakes(top: float) -> str:
    """Return some forty snowflakes, each of three strokes, spread evenly and yet without order."""
    d = ''
    for n in range(40):
        # Powers of 1 / 1.3247, the plastic number: neighbors in number are far from one another.
        x, y, r = WIDTH * (n * .754878 % 1), top + 8 + (GROUND - 12) * (n * .56984 % 1), 3 + n % 3
        d += (f'M{x - r:.1f} {y:.1f}h{2 * r}M{x - r / 2:.1f} {y - r * .87:.1f}l{r} {r * 1.74:.1f}'
              f'M{x + r / 2:.1f} {y - r * .87:.1f}l{-r} {r * 1.74:.1f}')
    return d


def crash(wall: float, speed_mps: float, units_per_m: float) -> str:
    """Return the cracks, the pieces that fly, and a star with the word."""
    hit = GROUND - 0.22 * units_per_m
    cracks = f'M{wall:.1f} {hit:.1f}l14 -9l8 -22l16 -8m-24 30l20 12l26 -6m-46 -6l-4 14l12 18l-4 16l14 14'
    force = min(1.6, max(0.35, speed_mps))
    pieces = ''.join(
        f'<path class="robot-debris" style="--x:{x * force:.0f}px;--y:{-y * force * (.2 if index % 2 else 0):.0f}px;'
        f'--top:{-60 * force - y * force:.0f}px;--r:{turn}deg" '
        f'd="M{wall - 8:.1f} {GROUND - 4:.1f}l{5 + index % 4} -{7 + index % 3}l{4 + index % 3} {5 + index % 4}z"/>'
        for index, (x, y, turn) in enumerate(_PIECES[:max(4, min(len(_PIECES), round(10 * speed_mps)))]))
    x, y = wall - 250, 96
    return (f'<path class="robot-line robot-crack" d="{cracks}"/>{pieces}<g class="robot-burst">'
            f'<polygon points="{_burst(x, y, 122, 76)}"/>{svg.words(x, y + 2, "CRASH", css_class="robot-bang")}'
            f'{svg.words(x, y + 32, f"{speed_mps:.2f} m/s", css_class="robot-bang-speed")}</g>')


def _burst(x: float, y: float, width: float, height: float) -> str:
    """Return the corners of a star of sixteen points, long and short ones by turns."""
    # The sines of a quarter circle to two digits, so that no math library decides on the last digit of a corner.
    directions = ((1, 0), (.92, .38), (.71, .71), (.38, .92), (0, 1), (-.38, .92), (-.71, .71), (-.92, .38))
    circle = [*directions, *((-a, -b) for a, b in directions)]
    return ' '.join(f'{x + a * width * (1 - index % 2 * .32):.1f},{y + b * height * (1 - index % 2 * .32):.1f}'
                    for index, (a, b) in enumerate(circle))
