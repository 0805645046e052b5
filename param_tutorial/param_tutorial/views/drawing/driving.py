"""A vehicle on its track, as HTML that moves by itself: what the robot and the cart have in common.

No frames are drawn here. A motion is a few phases of constant acceleration, and the distance driven in each is a
quadratic function of time, which a CSS ``cubic-bezier(1/3, p/3, 2/3, (1 + p)/3)`` is exactly. So each phase becomes
one step of a CSS animation, and the browser moves the vehicle by itself.

What the vehicles look like and what they say is in ``robot`` and ``cart``. What a picture tells in words changes with
each phase: those are its scenes, and ``views/driving.js`` tells them.
"""

import html
import math
import zlib
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from param_tools.markup.styles import style
from param_tutorial.views.drawing import svg

if TYPE_CHECKING:
    from param_tutorial.nodes.clawbot_node import Motion, Phase, Settings, State

# How often the numbers change, and how often in one motion at most. Faster, they could not be read, and each change
# makes a browser without a graphics card draw everything again from the head down to the vehicle.
_TICK_SEC = 0.2
_MAX_TICKS = 100
_LINE_PX = 20

# The picture has this size in units whatever the track's length, so that its text keeps its size.
WIDTH = 1000
HEIGHT = 260
GROUND = HEIGHT - 34
# Of the bar that is stretched to the way in which the vehicle would come to rest.
_BAR = 100
_PAINTS = 8

# In the names of a moving picture's keyframes, which belong to the whole page: each place where it is shown puts a name
# of its own there.
_NAME = 'robot-NAME'

STYLE = style('param_tutorial/views/drawing/track.css')


def view(button: str, title: str) -> str:
    """Return where a script shows a vehicle: its picture, its words and a button."""
    return ('<div class="robot-picture"></div><div class="robot-foot">'
            f'<button type="button" class="robot-drive" title="{title}" disabled>{button}'
            '</button><div class="robot-says" role="status"></div></div>')


@dataclass(frozen=True)
class Vehicle(ABC):
    """What a picture needs to know about something that drives on a straight track."""

    name: str
    settings: 'Settings'
    motion: 'Motion'
    """What it is doing now, up to the moment when it is at rest."""

    @property
    @abstractmethod
    def label(self) -> str:
        """What it is called in the picture's head."""

    @property
    @abstractmethod
    def shown_m(self) -> tuple[float, float]:
        """Where the picture begins and ends, in meters from the start line."""

    @property
    @abstractmethod
    def wheel_radius_m(self) -> float:
        """How far it drives while a wheel turns by one radian."""

    @property
    @abstractmethod
    def mode(self) -> str:
        """What is switched on, in words; empty if there is nothing to say."""

    @abstractmethod
    def numbers(self, state: 'State', elapsed_sec: float) -> str:
        """Return how fast it is, and what else changes on the way."""

    def predicate(self, state: 'State') -> str:
        """Return what it is doing: a sentence without its name and its full stop.

        These are the words for driving. Each vehicle adds its own for standing and stopping.
        """
        match state.word:
            case 'SPEEDING UP':
                return (f'is speeding up with {state.acceleration_mps2:.2f} m/s², '
                        f'up to {self.settings.max_speed_mps:.2f} m/s')
            case 'CRUISING':
                return 'is driving at a steady speed'
            case 'SLOWING DOWN':
                return f'is slowing down to {self.settings.max_speed_mps:.2f} m/s'
        raise AssertionError(f'no words for {state.word}')

    @abstractmethod
    def behind(self, moment: 'Moment') -> str:
        """Return SVG of what stands still behind it."""

    @abstractmethod
    def drawn(self, moment: 'Moment', wheel_css: str, cargo_css: str) -> str:
        """Return SVG of the vehicle; its front is at 0, the ground at 0, and upward is negative.

        :param wheel_css: Turns an element around its center as the wheels turn.
        :param cargo_css: Tilts an element as what stands on it leans.
        """

    @abstractmethod
    def in_front(self, moment: 'Moment') -> str:
        """Return SVG of what stands still in front of it."""

    @property
    def units_per_m(self) -> float:
        begin_m, end_m = self.shown_m
        return WIDTH / (end_m - begin_m)

    def x(self, position_m: float) -> float:
        """Return where a place on the track is in the picture."""
        return (position_m - self.shown_m[0]) * self.units_per_m

    def at(self, elapsed_sec: float) -> 'Moment':
        """Return the vehicle so many seconds after its motion began."""
        return Moment(self, self.motion.at(elapsed_sec), min(elapsed_sec, self.motion.duration_sec))

    def stopping_m(self, state: 'State') -> float:
        """Return the way in which it would come to rest if it braked now."""
        return state.velocity_mps ** 2 / (2 * self.settings.max_acceleration_mps2)


@dataclass(frozen=True)
class Moment:
    """A vehicle at one moment of its motion, and the words for it."""

    vehicle: Vehicle
    state: 'State'
    elapsed_sec: float = 0.0

    @property
    def numbers(self) -> str:
        return self.vehicle.numbers(self.state, self.elapsed_sec)

    @property
    def sentence(self) -> str:
        return f'{self.vehicle.name} {self.vehicle.predicate(self.state)}.'

    @property
    def text(self) -> str:
        """The whole picture in words, as a screen reader tells it."""
        facts = ', '.join(each for each in (self.numbers.capitalize(), self.vehicle.mode) if each)
        return f'{self.state.word}. {self.sentence} {facts}.'

    @property
    def lean_rad(self) -> float:
        """How far what stands on the vehicle leans; clockwise, which is forward, is positive."""
        # What hangs free would lean as much.
        return -math.atan(self.state.acceleration_mps2 / 9.81)

    @property
    def scene(self) -> 'Scene':
        """What a picture tells from this moment on."""
        # More digits would only make what is sent longer.
        return Scene(round(self.elapsed_sec, 4), self.state.word, self.text, self.sentence, round(self.lean_rad, 4))


class Scene(NamedTuple):
    """What a picture tells from a moment of its motion on. As JSON it is an array in this order."""

    at_sec: float
    word: str
    text: str
    """The whole picture in words."""
    sentence: str
    lean_rad: float


def still(moment: Moment) -> str:
    return _picture(moment, None)


def moving(vehicle: Vehicle) -> str:
    """Return the picture of a vehicle that goes through its motion by itself; its scenes have to be told."""
    return _picture(vehicle.at(0.0), _Animation(_NAME, vehicle, is_told=True) if vehicle.motion.phases else None)


def replay(vehicle: Vehicle) -> str:
    """Return a motion that a page without a kernel and without a script shows once, with its words, when it opens."""
    # The same motion has the same name, so a picture is the same whenever it is drawn.
    name = f'robot-{zlib.crc32(repr(vehicle).encode()):08x}'
    picture = _picture(vehicle.at(math.inf), _Animation(name, vehicle) if vehicle.motion.phases else None)
    return f'{STYLE}<div class="robot-view">{picture}</div>'


def paint(name: str) -> int:
    """Return the number of the color and the pattern with which something of this name is painted."""
    return zlib.crc32(name.strip().encode()) % _PAINTS


def _starts_sec(motion: 'Motion') -> list[float]:
    """Return when each phase begins, and when the motion ends."""
    return [sum(phase.duration_sec for phase in motion.phases[:index]) for index in range(len(motion.phases) + 1)]


class _Animation:
    """A motion as CSS: one step of the animation for each phase, and the numbers as a strip of film."""

    def __init__(self, name: str, vehicle: Vehicle, *, is_told: bool = False):
        """
        :param name: Of the animation; must differ from those of all other pictures on the page.
        :param is_told: Whether a script tells the scenes, and with them how the cargo leans: each part that moves by
            itself costs the browser a layer.
        """
        self._name = name
        self.is_told = is_told
        self._kinds = [kind for kind in _KINDS if kind != 'cargo' or not is_told]
        self._vehicle, self._motion = vehicle, vehicle.motion
        self._timing = f'{self._motion.duration_sec:.4f}s linear both'
        # Digits that change with each frame could not be read.
        self._ticks = min(_MAX_TICKS, math.ceil(self._motion.duration_sec / _TICK_SEC))

    def css(self, kind: str) -> str:
        """Return the CSS that animates an element; the kinds are those of _KINDS, and strip."""
        return f'animation:{self._name}-{kind} {self._timing};' if kind in (*self._kinds, 'strip') else ''

    def keyframes(self) -> str:
        steps = {kind: ''.join(self._steps(kind)) for kind in self._kinds}
        # A strip that is pulled past a window is moved by the browser's compositor, like the vehicle itself. Text
        # that really changes would make the page's own thread lay it out again for each frame.
        steps['strip'] = (f'0% {{transform:none;animation-timing-function:steps({self._ticks})}}'
                          f'100% {{transform:translateY({-self._ticks * _LINE_PX}px)}}')
        return '<style>' + ''.join(f'@keyframes {self._name}-{kind} {{{each}}}' for kind, each in steps.items()) \
            + '</style>'

    def strip(self) -> str:
        """Return the numbers of all ticks, one below the other."""
        ticks_sec = (index / self._ticks * self._motion.duration_sec for index in range(self._ticks))
        moments = [*map(self._vehicle.at, ticks_sec), self._vehicle.at(math.inf)]
        lines = '\n'.join(moment.numbers for moment in moments)
        # Told, the script shows the line; otherwise the last one stands where nothing may move.
        shown_px = 0 if self.is_told else -self._ticks * _LINE_PX
        return (f'<span class="robot-strip" style="transform:translateY({shown_px}px);{self.css("strip")}">'
                f'{lines}</span>')

    def words(self) -> str:
        """Return the words of all phases in one place, each to be seen in its time."""
        starts_sec = [*_starts_sec(self._motion), math.inf]
        words = [self._vehicle.at(start_sec).state.word for start_sec in starts_sec[:-1]]
        css, spans = '', ''
        for index, word in enumerate(words):
            begin, end = (min(100.0, 100 * each / self._motion.duration_sec) for each in starts_sec[index:index + 2])
            name, last = f'{self._name}-word-{index}', index == len(words) - 1
            css += (f'@keyframes {name} {{0%{{opacity:{int(begin == 0)}}}{begin:.4f}%{{opacity:1}}'
                    f'{end:.4f}%{{opacity:{int(last)}}}100%{{opacity:{int(last)}}}}}')
            spans += (f'<span style="opacity:{int(last)};animation:{name} {self._timing};'
                      f'animation-timing-function:step-end">{word}</span>')
        return f'<style>{css}</style><span class="robot-word robot-words">{spans}</span>'

    def _steps(self, kind: str) -> Iterator[str]:
        for begin_sec, phase in zip(_starts_sec(self._motion), self._motion.phases):
            timing = 'step-end' if kind == 'cargo' else _timing_function(phase)
            yield (f'{100 * begin_sec / self._motion.duration_sec:.4f}% {{{_css(kind, self._vehicle, phase.at(0))}'
                   f'animation-timing-function:{timing}}}')
        yield f'100% {{{_css(kind, self._vehicle, self._motion.end)}}}'


def _timing_function(phase: 'Phase') -> str:
    """Return the CSS timing function of a phase: which part of its way is done after which part of its time."""
    way_m = phase.at(phase.duration_sec).position_m - phase.position_m
    start = phase.velocity_mps * phase.duration_sec / way_m if way_m else 1.0
    return f'cubic-bezier(0.333333,{start / 3:.6f},0.666667,{(1 + start) / 3:.6f})'


# What can move by itself.
_KINDS = ('robot', 'wheel', 'brake', 'cargo')


def _css(kind: str, vehicle: Vehicle, state: 'State') -> str:
    """Return the CSS that brings a part to its place in a state of the vehicle."""
    match kind:
        case 'robot':
            return f'transform:translateX({vehicle.x(state.position_m):.3f}px);'
        case 'wheel':
            return f'transform:rotate({state.position_m / vehicle.wheel_radius_m:.4f}rad);'
        case 'brake':
            # The square of the speed changes with the way driven in the same proportion, so the timing is that of the
            # place.
            return f'transform:scaleX({vehicle.stopping_m(state) * vehicle.units_per_m / _BAR:.5f});'
    return f'transform:rotate({Moment(vehicle, state).lean_rad:.4f}rad);'


def _picture(moment: Moment, animation: _Animation | None) -> str:
    """Return a picture with its head, of a moment; with an animation, that is what stands where nothing may move."""
    strip = animation.strip() if animation else f'<span class="robot-strip">{moment.numbers}</span>'
    word = f'<span class="robot-word">{moment.state.word}</span>'
    if animation and not animation.is_told:
        word = animation.words()
    return (
        f'{animation.keyframes() if animation else ""}'
        f'<div class="robot-stage{" robot-film" if animation and animation.is_told else ""}">'
        f'<div class="robot-head" aria-hidden="true">{word}<span class="robot-window">{strip}</span>'
        f'<span>{moment.vehicle.mode}</span><span class="robot-node">{html.escape(moment.vehicle.label)}</span></div>'
        f'<div class="robot-scene" role="img" aria-label="{html.escape(moment.text)}">'
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" aria-hidden="true"'
        f'{" class=" + chr(34) + "robot-crashed" + chr(34) if moment.state.word == "CRASHED" else ""}>'
        f'{_layers(moment, animation)}</svg></div></div>')


def _layers(moment: Moment, animation: _Animation | None) -> str:
    """Return what stands behind, the vehicle, and what stands in front of it."""
    vehicle, state = moment.vehicle, moment.state

    def css(kind: str) -> str:
        if kind == 'cargo' and animation and animation.is_told:
            return 'transform:rotate(var(--lean));'
        # Without an animation, or where the reader wants none, the state of this moment.
        return _css(kind, vehicle, state) + (animation.css(kind) if animation else '')

    bar = f'<path class="robot-brake" d="M0 {GROUND + 5}h{_BAR}" style="{css("brake")}"/>'
    return (f'{vehicle.behind(moment)}<g class="robot-mover" style="{css("robot")}">{bar}'
            f'<g transform="translate(0 {GROUND})">{vehicle.drawn(moment, css("wheel"), css("cargo"))}</g></g>'
            f'{vehicle.in_front(moment)}')


# -- parts of pictures -----------------------------------------------------------------------------------------


def ruler(vehicle: Vehicle, end_m: float) -> str:
    """Return the ground, with a mark at each meter, or at each second one of a long track."""
    parts = [f'<path class="robot-ground" d="M0 {GROUND}H{WIDTH}"/>']
    for meter in range(0, int(end_m) + 1, 1 if end_m <= 12 else 2):
        # Where the picture is narrow there is no room for every number of a long track.
        css_class = 'robot-between' if end_m > 6 and meter % 2 else ''
        parts.append(f'<path class="robot-line" d="M{vehicle.x(meter):.1f} {GROUND}v8"/>'
                     f'{svg.words(vehicle.x(meter), GROUND + 26, f"{meter} m", css_class=css_class)}')
    return ''.join(parts)


def post(vehicle: Vehicle, position_m: float, words: str, css_class: str = '') -> str:
    """Return a dashed line across the track, with words above it."""
    x = vehicle.x(position_m)
    return (f'<path class="robot-line robot-post {css_class}" d="M{x:.1f} {GROUND}V30"/>'
            f'{svg.words(x, 23, words, css_class=css_class)}')


def legend() -> str:
    """Return what the bar before the vehicle means."""
    x = WIDTH * .45
    words = svg.words(x + 36, 24, 'way it needs to stop', anchor='start')
    return f'<path class="robot-brake" d="M{x:g} 19h28"/>{words}'


def wheel(x: float, radius: float, css: str) -> str:
    """Return a wheel that stands on the ground, with spokes, and one mark that shows how it turns."""
    rim = radius * .62
    # The sines of thirds of a half circle to three digits, so that no math library decides on the last one.
    spokes = ''.join(f'M{x - a * rim:.2f} {-radius - b * rim:.2f}L{x + a * rim:.2f} {-radius + b * rim:.2f}'
                     for a, b in ((1, 0), (.5, .866), (-.5, .866)))
    return (f'<g class="robot-wheel" style="{css}"><circle class="robot-tire" cx="{x:g}" cy="{-radius:g}" '
            f'r="{radius:g}"/><circle class="robot-rim" cx="{x:g}" cy="{-radius:g}" r="{rim:g}"/>'
            f'<path class="robot-spokes" d="{spokes}"/>'
            f'<circle class="robot-mark" cx="{x:g}" cy="{-radius * 1.8:g}" r="{radius * .13:.2f}"/></g>')


def pattern(number: int, x: float, y: float, width: float, height: float) -> str:
    """Return the pattern of a paint within a rectangle, so that colors need not be told apart."""
    if number % 4 == 0:  # one broad stripe
        d = f'M{x:g} {y + height / 2:g}h{width:g}'
    elif number % 4 == 1:  # chevrons
        d = ''.join(f'M{x + width * at:g} {y + height * .2:g}l{height * .3:g} {height * .3:g}'
                    f'l{-height * .3:g} {height * .3:g}' for at in (.15, .4, .65))
    elif number % 4 == 2:  # dots: a line without length has round ends
        d = ''.join(f'M{x + width * at:g} {y + height / 2:g}h0' for at in (.15, .38, .61, .84))
    else:  # bars
        d = ''.join(f'M{x + width * at:g} {y + height * .2:g}v{height * .6:g}' for at in (.12, .31, .5, .69, .88))
    return f'<path class="robot-pattern{" robot-thin" if number >= _PAINTS // 2 else ""}" d="{d}"/>'
