"""The robot that a reader's own node drives, on its track: what it looks like at one moment, and what that says.

Sizes are pixels, so words and the robot keep theirs on every page; the way to the wall is as long as there is room. The
picture is drawn once for a track. ``track.css`` moves its parts by variables, and for each moment
``views/track.js`` sets these and the words.
"""

import html
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

# Where the ground is in the picture of a crash.
GROUND = 226
# Slower looks like standing.
_STANDING_MPS = 0.005
# The arrow grows up to this speed; the number says more.
_FASTEST_SHOWN_MPS = 2.0
# As on a wheel of this radius, in m, although the robot is drawn larger than the track.
_WHEEL_M = 0.2
_SCALE = 1.9
# In centimeters: its upper side, the eye of its sensor, where that sits behind the front, and the wheels' radius.
_DECK, _EYE, _SENSOR, _RADIUS = -26.0, -33.0, -15.0, 9.0
# Where the pieces of a crash end, for one meter per second: forward, upward, turned by so many degrees.
_PIECES = ((-62, 40, 200), (-105, 8, -310), (-38, 95, 150), (-148, 30, 420), (-84, 66, -120), (-190, 6, 260),
           (-30, 22, -80), (-120, 84, 330), (-230, 12, -200), (-66, 112, 90), (-170, 58, 510), (-270, 4, 380))


# Where a reader has predicted that the robot stops; `exercises/marker.js` shows it and moves it.
_GHOST = (f'<div class="track-robot track-ghost" hidden=""><svg><g transform="scale({_SCALE})">'
          '<path class="robot-ghost" d="M-59 -26h55v17h-55zM-46 -18a9 9 0 1 0 .1 0M-17 -18a9 9 0 1 0 .1 0"/></g></svg>'
          '<strong>you</strong></div>')


@dataclass(frozen=True)
class Moment:
    """The base and its track at one moment."""

    node: str
    """Its fully qualified name."""
    wall_m: float
    position_m: float = 0.0
    speed_mps: float = 0.0
    commanded_mps: float = 0.0
    crash_speed_mps: float | None = None
    """How fast it hit the wall, if it did."""

    @property
    def distance_m(self) -> float:
        return max(0.0, self.wall_m - self.position_m)

    @property
    def word(self) -> str:
        """What it is doing."""
        missing = self.commanded_mps - self.speed_mps
        if self.crash_speed_mps is not None:
            return 'CRASHED'
        # At the start there is no way back.
        stays = abs(missing) < _STANDING_MPS or (self.position_m == 0 and missing < 0)
        if abs(self.speed_mps) < _STANDING_MPS and stays:
            return 'STOPPED' if self.position_m else 'READY'
        if abs(missing) < _STANDING_MPS:
            return 'DRIVING' if self.speed_mps > 0 else 'BACKING UP'
        return 'SPEEDING UP' if missing * (self.speed_mps or missing) > 0 else 'SLOWING DOWN'

    @property
    def sentence(self) -> str:
        """What there is to say when that begins."""
        return {
            'READY': 'The robot waits for a speed on cmd_vel.',
            'DRIVING': 'The robot is as fast as cmd_vel asks.',
            'BACKING UP': 'The robot drives backward, as cmd_vel asks.',
            'SPEEDING UP': 'The robot is slower than cmd_vel asks.',
            'SLOWING DOWN': 'The robot is faster than cmd_vel asks.',
            'STOPPED': f'The robot stands {self.distance_m:.2f} m from the wall.',
            'CRASHED': f'The robot has hit the wall at {self.crash_speed_mps or 0:.2f} m/s.'}[self.word]

    @property
    def text(self) -> str:
        """The whole picture in words, as a screen reader tells it."""
        return f'{self.word}. {self.sentence} ' + ', '.join(
            f'{name} {value}' for name, value in zip(('cmd_vel', 'speed', 'distance'), self._numbers)) + '.'

    @property
    def _numbers(self) -> tuple[str, str, str]:
        # Plus zero, or a speed that has come down to it may be -0.00.
        return (f'{round(self.commanded_mps, 2) + 0:.2f} m/s', f'{round(self.speed_mps, 2) + 0:.2f} m/s',
                f'{self.distance_m:.2f} m')

    @property
    def css(self) -> dict[str, float]:
        """The variables of CSS that bring all parts to their places."""
        def shown(speed_mps: float) -> float:
            return round(max(-1.0, min(1.0, speed_mps / _FASTEST_SHOWN_MPS)), 3)

        return {'--at': round(min(1.0, self.position_m / self.wall_m), 4), '--speed': shown(self.speed_mps),
                '--command': shown(self.commanded_mps), '--way': (self.speed_mps > 0) - (self.speed_mps < 0),
                '--told': int(self.word not in ('READY', 'STOPPED', 'CRASHED')),
                '--turn': round(self.position_m / _WHEEL_M, 2),
                '--lean': round(.15 * shown(self.speed_mps - self.commanded_mps), 3)}

    @property
    def says(self) -> dict[str, str]:
        """The words in the picture, by the class of the element that has them."""
        command, speed, distance = self._numbers
        crash = '' if self.crash_speed_mps is None else f'{self.crash_speed_mps:.2f} m/s'
        return {'robot-word': self.word, 'track-command': command, 'track-speed': speed, 'track-distance': distance,
                'track-gap-words': distance, 'track-arrow-words': speed, 'robot-bang-speed': crash}


def draw_track(moment: Moment) -> str:
    """Return HTML of the track at a moment, as it is before a script moves it."""
    says = moment.says
    css = ''.join(f'{name}:{value};' for name, value in moment.css.items())
    readouts = ''.join(
        f'<span class="track-readout"><i class="track-{kind}-sign"></i>{name} <strong class="track-{kind}">'
        f'{says[f"track-{kind}"]}</strong></span>'
        for kind, name in (('command', 'cmd_vel'), ('speed', 'speed'), ('distance', 'distance')))
    step = next(step for step in (1, 2, 5, 10) if moment.wall_m / step <= 10)
    # Where the picture is narrow there is no room for every number.
    marks = ''.join(
        f'<span class="track-mark{" track-between" if moment.wall_m > 5 * step and meter // step % 2 else ""}" '
        f'style="left:{100 * meter / moment.wall_m:.2f}%">{meter} m</span>'
        for meter in range(0, int(moment.wall_m) + 1, step))
    # The wall hides where the ray ends.
    ray = (f'<g class="track-ray"><path class="robot-beam" d="M-12 {_EYE:g}l44 -8v16z"/>'
           f'<path class="robot-laser" style="stroke-width:.8" d="M-12 {_EYE:g}h9999"/></g>')
    return (
        f'<div class="robot-stage track-stage" style="{css}">'
        f'<div class="robot-head" aria-hidden="true"><span class="robot-word">{moment.word}</span>{readouts}'
        f'<span class="robot-node">{html.escape(moment.node)}</span></div>'
        f'<div class="track-scene{" robot-crashed" if moment.crash_speed_mps is not None else ""}" role="img" '
        f'aria-label="{html.escape(moment.text)}"><div class="track-way" aria-hidden="true">{marks}'
        f'<div class="track-robot"><svg><g transform="scale({_SCALE})">{ray}'
        f'<g class="robot-machine" style="--crash:.6">{_machine()}</g></g></svg></div>'
        f'{_GHOST}<div class="track-wall"></div><div class="track-gap"></div>'
        f'<strong class="track-gap-words">{says["track-gap-words"]}</strong>'
        f'<div class="track-robot"><i class="track-end"></i><div class="track-arrow"><i class="track-arrow-shaft"></i>'
        f'<i class="track-arrow-head"></i><i class="track-arrow-command"></i>'
        f'<strong class="track-arrow-words">{says["track-arrow-words"]}</strong></div></div>'
        f'<svg class="track-crash"><g transform="translate(0 {1 - GROUND})">'
        f'{_crash(moment.crash_speed_mps or 1)}</g></svg></div></div></div>')


def _machine() -> str:
    """Return SVG of the robot in centimeters; its bumper ends at 0, where its front is."""
    turn, lean = 'transform:rotate(calc(var(--turn)*1rad))', 'transform:rotate(calc(var(--lean)*1rad))'
    return (
        # The antenna leans as the robot speeds up and brakes. Parts that move by themselves come first and last:
        # each is a layer of the browser's, and so is what lies between two of them.
        f'<g class="robot-antenna" style="{lean}"><path d="M-53 {_DECK:g}v-30"/>'
        f'<path class="robot-paint robot-paint-0" d="M-53 {_DECK - 30:g}h-12l3 4l-3 4h12z"/></g>'
        # An arm with a claw, raised.
        f'<path class="robot-arm" d="M-43 {_DECK:g}V{_DECK - 24:g}L-20 {_DECK - 33:g}L-11 {_DECK - 24:g}"/>'
        f'<path class="robot-claw" d="M-15 {_DECK - 20:g}q-1 -8 5 -8l7 1M-11 {_DECK - 24:g}q8 5 6 13l-5 4"/>'
        f'<circle class="robot-joint" cx="-43" cy="{_DECK - 24:g}" r="3"/>'
        f'<circle class="robot-joint" cx="-20" cy="{_DECK - 33:g}" r="3"/>'
        f'<rect class="robot-paint robot-paint-0" x="-59" y="{_DECK:g}" width="55" height="17" rx="3.5"/>'
        f'<path class="robot-pattern" d="M-55 {_DECK + 7.5:g}h42"/>'
        f'<rect class="robot-bumper" x="-4.4" y="{-_RADIUS - 7:g}" width="4" height="12" rx="1.6"/>'
        f'<path class="robot-arm" d="M{_SENSOR:g} {_DECK:g}v-4"/>'
        f'<rect class="robot-part" x="{_SENSOR - 4:g}" y="{_EYE - 4:g}" width="8" height="8" rx="2"/>'
        f'<circle class="robot-eye" cx="{_SENSOR + 1.5:g}" cy="{_EYE:g}" r="2.2"/>'
        f'{_wheel(-46, turn)}{_wheel(-17, turn)}')


def _wheel(x: float, css: str) -> str:
    """Return a wheel that stands on the ground, with spokes, and one mark that shows how it turns.

    :param css: Turns an element around its center.
    """
    rim = _RADIUS * .62
    # The sines of thirds of a half circle to three digits, so that no math library decides on the last one.
    spokes = ''.join(f'M{x - a * rim:.2f} {-_RADIUS - b * rim:.2f}L{x + a * rim:.2f} {-_RADIUS + b * rim:.2f}'
                     for a, b in ((1, 0), (.5, .866), (-.5, .866)))
    return (f'<g class="robot-wheel" style="{css}"><circle class="robot-tire" cx="{x:g}" cy="{-_RADIUS:g}" '
            f'r="{_RADIUS:g}"/><circle class="robot-rim" cx="{x:g}" cy="{-_RADIUS:g}" r="{rim:g}"/>'
            f'<path class="robot-spokes" d="{spokes}"/>'
            f'<circle class="robot-mark" cx="{x:g}" cy="{-_RADIUS * 1.8:g}" r="{_RADIUS * .13:.2f}"/></g>')


def _crash(speed_mps: float) -> str:
    """Return the cracks in the wall, which is at 0, the pieces that fly, and a star with the word."""
    cracks = f'M0.0 {GROUND - 42.68:.1f}l14 -9l8 -22l16 -8m-24 30l20 12l26 -6m-46 -6l-4 14l12 18l-4 16l14 14'
    force = min(1.6, max(0.35, speed_mps))
    pieces = ''.join(
        f'<path class="robot-debris" style="--x:{x * force:.0f}px;--y:{-y * force * (.2 if index % 2 else 0):.0f}px;'
        f'--top:{-60 * force - y * force:.0f}px;--r:{turn}deg" '
        f'd="M-8.0 {GROUND - 4:.1f}l{5 + index % 4} -{7 + index % 3}l{4 + index % 3} {5 + index % 4}z"/>'
        for index, (x, y, turn) in enumerate(_PIECES[:max(4, min(len(_PIECES), round(10 * speed_mps)))]))
    x, y = -250, 96
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
