"""The robot of ClawbotNode on its track, as HTML that moves by itself.

No frames are drawn here. A motion is a few phases of constant acceleration, and the distance driven in each is a
quadratic function of time, which a CSS ``cubic-bezier(1/3, p/3, 2/3, (1 + p)/3)`` is exactly. So each phase becomes
one step of a CSS animation, and the browser moves the robot at its own frame rate.
"""

import html
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from param_tutorial.pictures.styles import style

if TYPE_CHECKING:
    from param_tutorial.nodes.clawbot_node import Motion, Phase, Settings, State

# How often the numbers change, and how often in one motion at most.
_TICK_SEC = 0.1
_MAX_TICKS = 100
_LINE_PX = 20

# The picture is 1000 units wide whatever the track's length, so that its text keeps its size.
_WIDTH = 1000
_BEFORE_START_M = 0.8
_BEHIND_WALL_M = 0.35
_ROBOT_HEIGHT_M = 0.4
_BELOW_GROUND = 34
_ABOVE_ROBOT = 44

STYLE = style('pictures/robot.css')


@dataclass(frozen=True)
class Robot:
    """What a picture needs to know about a robot."""

    name: str
    serial_number: str
    length_m: float
    wheel_radius_m: float
    settings: 'Settings'
    motion: 'Motion'
    """What it is doing now, up to the moment when it is at rest."""
    waiting_for: str = ''
    """What keeps it from driving, if the motion ends with WAITING."""

    def at(self, elapsed_sec: float) -> 'Moment':
        """Return the robot so many seconds after the motion began."""
        return Moment(self, self.motion.at(elapsed_sec))

    def gap_m(self, state: 'State') -> float:
        """Return how far its front is from the wall."""
        return self.settings.track_m - state.position_m


@dataclass(frozen=True)
class Moment:
    """A robot at one moment of its motion, and the words for it."""

    robot: Robot
    state: 'State'

    @property
    def safety(self) -> str:
        """Whether the safety mode is on."""
        return f'safety {"on" if self.robot.settings.safety_on else "off"}'

    @property
    def numbers(self) -> str:
        """How fast it is, and how far from the wall."""
        return f'speed {self.state.velocity_mps:.2f} m/s, {self.robot.gap_m(self.state):.2f} m to the wall'

    @property
    def sentence(self) -> str:
        """What it is doing."""
        return f'{self.robot.name} {self._predicate()}.'

    @property
    def text(self) -> str:
        """The whole picture in words, as a screen reader tells it."""
        return f'{self.state.word}. {self.sentence} {self.numbers.capitalize()}, {self.safety}.'

    def _predicate(self) -> str:
        state, settings = self.state, self.robot.settings
        match state.word:
            case 'READY':
                return 'stands at the start'
            case 'SPEEDING UP':
                return (f'is speeding up with {state.acceleration_mps2:.2f} m/s², '
                        f'up to {settings.max_speed_mps:.2f} m/s')
            case 'CRUISING':
                return 'is driving at a steady speed'
            case 'SLOWING DOWN':
                return f'is slowing down to {settings.max_speed_mps:.2f} m/s'
            case 'BRAKING' | 'EMERGENCY BRAKING':
                gap_m = self.robot.gap_m(self.robot.motion.end)
                hard = ' as hard as it can' if state.word == 'EMERGENCY BRAKING' else ''
                return f'is braking{hard}, ' + (f'to stop {gap_m:.2f} m from the wall' if gap_m > 0 else 'too late')
            case 'WAITING':
                return f'is waiting: {self.robot.waiting_for}'
            case 'STOPPED':
                return f'has stopped {self.robot.gap_m(state):.2f} m from the wall'
            case 'CRASHED':
                return f'has run into the wall at {state.crash_speed_mps:.2f} m/s'
        raise AssertionError(f'no words for {state.word}')


@dataclass(frozen=True)
class Film:
    """A drive, for a page that has no kernel to ask."""

    picture: str
    """HTML that moves by itself, from now on."""
    scenes: tuple[tuple[float, str, str, str], ...]
    """What changes in words, and after how many seconds: word, text alternative, sentence."""
    end: str
    """HTML of the robot at rest."""


def still(moment: Moment) -> str:
    """Return the picture of a robot at one moment."""
    return _picture(moment, None)


def moving(robot: Robot, elapsed_sec: float, name: str) -> str:
    """Return the picture of a robot that goes on by itself from this moment to the end of its motion.

    :param name: Of the animation; must differ from those of all other pictures on the page.
    """
    moment = robot.at(elapsed_sec)
    return _picture(moment, _Animation(name, moment, elapsed_sec) if robot.motion.phases else None)


def film(robot: Robot, name: str) -> Film:
    """Return a motion from its beginning to its end.

    :param name: As for ``moving``.
    """
    phases = robot.motion.phases
    starts_sec = [sum(phase.duration_sec for phase in phases[:index]) for index in range(len(phases) + 1)]
    moments = [robot.at(start_sec) for start_sec in starts_sec]
    return Film(moving(robot, 0.0, name),
                tuple((start_sec, moment.state.word, moment.text, moment.sentence)
                      for start_sec, moment in zip(starts_sec, moments)),
                still(moments[-1]))


class _Animation:
    """A motion as CSS: one step of the animation for each phase, and the numbers as a strip of film."""

    def __init__(self, name: str, moment: Moment, elapsed_sec: float) -> None:
        self._name = name
        self._robot, self._motion = moment.robot, moment.robot.motion
        self._timing = f'{self._motion.duration_sec:.4f}s linear {-elapsed_sec:.4f}s both'
        # Digits that change with each frame could not be read.
        self._ticks = min(_MAX_TICKS, math.ceil(self._motion.duration_sec / _TICK_SEC))
        self._tick = int(elapsed_sec / self._motion.duration_sec * self._ticks)

    def css(self, kind: str) -> str:
        """Return the CSS that animates an element; the kinds are those of _LOOKS, and strip."""
        return f'animation:{self._name}-{kind} {self._timing};'

    def keyframes(self) -> str:
        """Return the keyframes of every kind, as a style element."""
        steps = {kind: ''.join(self._steps(kind)) for kind in _LOOKS}
        # A strip that is pulled past a window is moved by the browser's compositor, like the robot itself. Text
        # that really changes would make the page's own thread lay it out again for each frame.
        steps['strip'] = (f'0% {{transform:none;animation-timing-function:steps({self._ticks})}}'
                          f'100% {{transform:translateY({-self._ticks * _LINE_PX}px)}}')
        return '<style>' + ''.join(f'@keyframes {self._name}-{kind} {{{each}}}' for kind, each in steps.items()) \
            + '</style>'

    def strip(self) -> str:
        """Return the numbers of all ticks, one below the other."""
        ticks_sec = (index / self._ticks * self._motion.duration_sec for index in range(self._ticks))
        moments = [*map(self._robot.at, ticks_sec), Moment(self._robot, self._motion.end)]
        lines = '\n'.join(moment.numbers for moment in moments)
        return (f'<span class="robot-strip" style="transform:translateY({-self._tick * _LINE_PX}px);'
                f'{self.css("strip")}">{lines}</span>')

    def _steps(self, kind: str) -> Iterator[str]:
        begins_sec = 0.0
        for phase in self._motion.phases:
            yield (f'{100 * begins_sec / self._motion.duration_sec:.4f}% {{{_LOOKS[kind](self._robot, phase.at(0))}'
                   f'animation-timing-function:{_timing_function(phase)}}}')
            begins_sec += phase.duration_sec
        yield f'100% {{{_LOOKS[kind](self._robot, self._motion.end)}}}'


def _timing_function(phase: 'Phase') -> str:
    """Return the CSS timing function of a phase: which part of its way is done after which part of its time."""
    way_m = phase.at(phase.duration_sec).position_m - phase.position_m
    start = phase.velocity_mps * phase.duration_sec / way_m if way_m else 1.0
    return f'cubic-bezier(0.333333,{start / 3:.6f},0.666667,{(1 + start) / 3:.6f})'


def _robot_css(robot: Robot, state: 'State') -> str:
    return f'transform:translateX({100 * state.position_m / _width_m(robot.settings):.4f}%);'


def _wheel_css(robot: Robot, state: 'State') -> str:
    return f'transform:rotate({state.position_m / robot.wheel_radius_m:.4f}rad);'


_LOOKS = {'robot': _robot_css, 'wheel': _wheel_css}


def _width_m(settings: 'Settings') -> float:
    """Return how many meters the picture shows."""
    return _BEFORE_START_M + settings.track_m + _BEHIND_WALL_M


def _picture(moment: Moment, animation: _Animation | None) -> str:
    robot, state = moment.robot, moment.state

    def look(kind: str) -> str:
        # Without an animation, or where the reader wants none, the state of this moment.
        return _LOOKS[kind](robot, state) + (animation.css(kind) if animation else '')

    strip = animation.strip() if animation else f'<span class="robot-strip">{moment.numbers}</span>'
    width_m = _width_m(robot.settings)
    units_per_m = _WIDTH / width_m
    place = (f'left:{100 * (_BEFORE_START_M - robot.length_m) / width_m:.4f}%;'
             f'width:{100 * robot.length_m / width_m:.4f}%')
    height = _ABOVE_ROBOT + _ROBOT_HEIGHT_M * units_per_m + _BELOW_GROUND
    tilt = 'transform:rotate(-5deg);transform-origin:100% 100%;' if state.word == 'CRASHED' else ''
    return (
        f'{animation.keyframes() if animation else ""}<div class="robot-stage">'
        f'<div class="robot-head" aria-hidden="true"><span class="robot-node">{html.escape(robot.name)} '
        f'({html.escape(robot.serial_number)})</span><span class="robot-word">{state.word}</span>'
        f'<span class="robot-window">{strip}</span>'
        f'<span>{moment.safety}</span></div>'
        f'<div class="robot-scene" role="img" aria-label="{html.escape(moment.text)}">'
        f'{_scene(moment, units_per_m, height)}<div class="robot-mover" style="{look("robot")}">'
        f'<svg viewBox="0 0 60 40" aria-hidden="true" '
        f'style="{place};bottom:{100 * _BELOW_GROUND / height:.3f}%;{tilt}">'
        f'{_robot(robot, look("wheel"))}</svg></div></div></div>')


def _scene(moment: Moment, units_per_m: float, height: float) -> str:
    """Return what stands still: the track with its ruler, the start line, the wall, where the robot is to stop."""
    settings = moment.robot.settings
    ground = height - _BELOW_GROUND

    def x(position_m: float) -> float:
        return (_BEFORE_START_M + position_m) * units_per_m

    wall = x(settings.track_m)
    parts = [f'<path class="robot-ground" d="M0 {ground:.1f}H{_WIDTH}"/>']
    every_m = 1 if settings.track_m <= 10 else 2
    for meter in range(0, int(settings.track_m) + 1, every_m):
        parts.append(f'<path class="robot-line" d="M{x(meter):.1f} {ground:.1f}v8"/><text x="{x(meter):.1f}" '
                     f'y="{ground + 25:.1f}" text-anchor="middle">{meter} m</text>')
    parts.append(f'<path class="robot-line" stroke-dasharray="3 4" d="M{x(0):.1f} {ground:.1f}V26"/>'
                 f'<text x="{x(0):.1f}" y="18" text-anchor="middle">start</text>')
    parts.append(f'<rect class="robot-wall" x="{wall:.1f}" y="8" width="{_WIDTH - wall + 5:.1f}" '
                 f'height="{ground - 8:.1f}"/>')
    bricks = ''.join(f'M{wall:.1f} {y:.1f}H{_WIDTH}' for y in range(30, int(ground), 22))
    parts.append(f'<path class="robot-line" d="{bricks}"/>')
    if settings.safety_on:
        stop = x(settings.stop_m)
        parts.append(f'<path class="robot-line" stroke-dasharray="8 5" d="M{stop:.1f} {ground:.1f}V26"/>'
                     f'<text x="{stop - 6:.1f}" y="18" text-anchor="middle">stop</text>')
    if moment.state.word == 'CRASHED':
        burst = _burst(wall, ground - 0.22 * units_per_m, 0.24 * units_per_m)
        parts.append(f'<polygon class="robot-burst" points="{burst}"/>')
    return f'<svg viewBox="0 0 {_WIDTH} {height:.1f}" aria-hidden="true">{"".join(parts)}</svg>'


def _burst(x: float, y: float, radius: float) -> str:
    """Return the corners of a star of sixteen points, long and short ones by turns."""
    # The sines of a quarter circle to two digits, so that no math library decides on the last digit of a corner.
    directions = ((1, 0), (.92, .38), (.71, .71), (.38, .92), (0, 1), (-.38, .92), (-.71, .71), (-.92, .38))
    circle = [*directions, *((-a, -b) for a, b in directions)]
    return ' '.join(f'{x + a * radius * (1 - index % 2 * .5):.1f},{y + b * radius * (1 - index % 2 * .5):.1f}'
                    for index, (a, b) in enumerate(circle))


def _robot(robot: Robot, wheel_css: str) -> str:
    """Return the robot, drawn in centimeters; its claws end at 60, where its front is."""
    radius = 100 * robot.wheel_radius_m
    axle = 40 - radius
    body = min(24.0, axle - 2)
    wheels = ''.join(
        f'<g class="robot-wheel" style="{wheel_css}">'
        f'<circle class="robot-part" cx="{x}" cy="{axle:g}" r="{radius - .6:g}"/>'
        f'<path class="robot-part" d="M{x - radius * .6:g} {axle:g}h{radius * 1.2:g}M{x} {axle - radius * .6:g}'
        f'v{radius * 1.2:g}"/></g>' for x in (13, 38))
    # The waves of the range sensor: the safety mode is listening.
    waves = ''.join(f'<path class="robot-wave" d="M{x} {body - 13:g}q3 4.5 0 9"/>' for x in (53, 57, 61))
    return (
        f'<rect class="robot-body" x="2" y="{body - 10:g}" width="46" height="{axle - body + 14:g}" rx="4"/>'
        f'<rect class="robot-part" x="41" y="{body - 12:g}" width="8" height="6" rx="1.5"/>'
        f'<path class="robot-part" d="M10 {body - 10:g}v-5h14v5z"/>'
        f'<path class="robot-arm" d="M48 {axle - 3:g}h4M59.5 {axle - 9:g}l-7 1v11l7 1"/>'
        f'{waves if robot.settings.safety_on else ""}{wheels}')
