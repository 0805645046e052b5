"""The warehouse cart of CartNode in its aisle, as HTML that moves by itself.

No frames are drawn here. A motion is a few phases of constant acceleration, and the distance driven in each is a
quadratic function of time, which a CSS ``cubic-bezier(1/3, p/3, 2/3, (1 + p)/3)`` is exactly. So each phase becomes
one step of a CSS animation, and the browser moves the cart by itself.

What a picture tells in words changes with
each phase: those are its scenes, and ``views/driving.js`` tells them.
"""

import html
import math
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from param_tools.markup.styles import style
from param_tutorial.views.drawing import svg

if TYPE_CHECKING:
    from param_tutorial.nodes.clawbot_node import Motion, Phase, Settings, State

# How often the numbers change, and how often in one motion at most. Faster, they could not be read, and each change
# makes a browser without a graphics card draw everything again from the head down to the cart.
_TICK_SEC = 0.2
_MAX_TICKS = 100
_LINE_PX = 20

# The picture has this size in units whatever the track's length, so that its text keeps its size.
WIDTH = 1000
HEIGHT = 260
GROUND = HEIGHT - 34
# Of the bar that is stretched to the way in which the cart would come to rest.
_BAR = 100
_PAINTS = 8
_WHEEL_M = 0.15
_LENGTH_M = 1.5
_MARGIN_M = 0.5

# In the names of a moving picture's keyframes, which belong to the whole page: each place where it is shown puts a name
# of its own there.
_NAME = 'robot-NAME'

STYLE = style('param_tutorial/views/drawing/track.css')


def view(button: str, title: str) -> str:
    """Return where a script shows a cart: its picture, its words and a button."""
    return ('<div class="robot-picture"></div><div class="robot-foot">'
            f'<button type="button" class="robot-drive" title="{title}" disabled>{button}'
            '</button><div class="robot-says" role="status"></div></div>')


@dataclass(frozen=True)
class Cart:
    """What a picture needs to know about a cart. Its settings' ``stop_m`` is where the aisle ends."""

    name: str
    settings: 'Settings'
    motion: 'Motion'
    """What it is doing now, up to the moment when it is at rest."""
    node: str
    """The name of its node."""
    sight_m: float
    """How far its scanner sees."""
    before_sec: float = 0.0
    """For how long it had driven when this motion began, because a parameter was changed on the way."""

    @property
    def shown_m(self) -> tuple[float, float]:
        """Where the picture begins and ends, in meters from the start line."""
        return -_LENGTH_M - _MARGIN_M, self.settings.stop_m + _MARGIN_M

    @property
    def mode(self) -> str:
        """What it has been set to."""
        return f'{self.settings.max_speed_mps:g} m/s, {self.settings.max_acceleration_mps2:g} m/s²'

    def numbers(self, state: 'State', elapsed_sec: float) -> str:
        """Return how fast it is, and what else changes on the way."""
        return f'speed {state.velocity_mps:.2f} m/s, {self.before_sec + elapsed_sec:.1f} s on its way'

    def predicate(self, state: 'State') -> str:
        """Return what it is doing: a sentence without its name and its full stop."""
        match state.word:
            case 'READY':
                return 'stands at the beginning of the aisle'
            case 'SPEEDING UP':
                return (f'is speeding up with {state.acceleration_mps2:.2f} m/s², '
                        f'up to {self.settings.max_speed_mps:.2f} m/s')
            case 'CRUISING':
                return 'is driving at a steady speed'
            case 'SLOWING DOWN':
                return f'is slowing down to {self.settings.max_speed_mps:.2f} m/s'
            case 'BRAKING':
                return 'is braking, to stop at the end of the aisle'
            case 'EMERGENCY BRAKING':
                return 'is braking as hard as it can'
            case 'STOPPED':
                seconds = self.before_sec + self.motion.duration_sec
                return f'has reached the end of the aisle after {seconds:.2f} s' if seconds else 'stands still'
        raise AssertionError(f'no words for {state.word}')

    def behind(self) -> str:
        """Return SVG of what stands still behind it."""
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
                f'{_ruler(self)}{_post(self, 0.0, "start")}'
                f'{_legend()}')

    def in_front(self) -> str:
        """Return SVG of what stands still in front of it."""
        words = 'end of the aisle' if self.shown_m[1] > 20 else 'end'
        return _post(self, self.settings.stop_m, words, 'robot-stop')

    def drawn(self, wheel_css: str, cargo_css: str) -> str:
        """Return SVG of the cart; its front, with the scanner, is at 0, the ground at 0, and upward is negative.

        :param wheel_css: Turns an element around its center as the wheels turn.
        :param cargo_css: Tilts an element as what stands on it leans.
        """
        scale, radius = self.units_per_m / 100, 100 * _WHEEL_M
        deck = -2 * radius - 12
        color, length = _paint(self.node), 100 * _LENGTH_M
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
            f'height="24" rx="4"/>{pattern(color, -length + 8, deck + 4, length - 26, 16)}'
            f'<rect class="robot-part" x="-9" y="{eye - 7:g}" width="9" height="14" rx="2"/>'
            f'<circle class="robot-eye" cx="-3.5" cy="{eye:g}" r="3"/>'
            f'{wheel(-length + 28, radius, wheel_css)}{wheel(-32, radius, wheel_css)}')
        tag = svg.words(-length / 2 * scale, (deck - 74) * scale, self.name, css_class='robot-tag')
        return f'<g class="robot-machine robot-big" transform="scale({scale:.4f})">{drawn}</g>{tag}'

    @property
    def units_per_m(self) -> float:
        begin_m, end_m = self.shown_m
        return WIDTH / (end_m - begin_m)

    def x(self, position_m: float) -> float:
        """Return where a place on the track is in the picture."""
        return (position_m - self.shown_m[0]) * self.units_per_m

    def at(self, elapsed_sec: float) -> 'Moment':
        """Return the cart so many seconds after its motion began."""
        return Moment(self, self.motion.at(elapsed_sec), min(elapsed_sec, self.motion.duration_sec))

    def stopping_m(self, state: 'State') -> float:
        """Return the way in which it would come to rest if it braked now."""
        return state.velocity_mps ** 2 / (2 * self.settings.max_acceleration_mps2)


@dataclass(frozen=True)
class Moment:
    """A cart at one moment of its motion, and the words for it."""

    cart: Cart
    state: 'State'
    elapsed_sec: float = 0.0

    @property
    def numbers(self) -> str:
        return self.cart.numbers(self.state, self.elapsed_sec)

    @property
    def sentence(self) -> str:
        return f'{self.cart.name} {self.cart.predicate(self.state)}.'

    @property
    def text(self) -> str:
        """The whole picture in words, as a screen reader tells it."""
        return f'{self.state.word}. {self.sentence} {self.numbers.capitalize()}, {self.cart.mode}.'

    @property
    def lean_rad(self) -> float:
        """How far what stands on the cart leans; clockwise, which is forward, is positive."""
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


def moving(cart: Cart) -> str:
    """Return the picture of a cart that goes through its motion by itself; its scenes have to be told."""
    return _picture(cart.at(0.0), _Animation(_NAME, cart, is_told=True) if cart.motion.phases else None)


def replay(cart: Cart) -> str:
    """Return a motion that a page without a kernel and without a script shows once, with its words, when it opens."""
    # The same motion has the same name, so a picture is the same whenever it is drawn.
    name = f'robot-{zlib.crc32(repr(cart).encode()):08x}'
    picture = _picture(cart.at(math.inf), _Animation(name, cart) if cart.motion.phases else None)
    return f'{STYLE}<div class="robot-view">{picture}</div>'


def _paint(name: str) -> int:
    """Return the number of the color and the pattern with which something of this name is painted."""
    return zlib.crc32(name.strip().encode()) % _PAINTS


def _starts_sec(motion: 'Motion') -> list[float]:
    """Return when each phase begins, and when the motion ends."""
    return [sum(phase.duration_sec for phase in motion.phases[:index]) for index in range(len(motion.phases) + 1)]


class _Animation:
    """A motion as CSS: one step of the animation for each phase, and the numbers as a strip of film."""

    def __init__(self, name: str, cart: Cart, *, is_told: bool = False):
        """
        :param name: Of the animation; must differ from those of all other pictures on the page.
        :param is_told: Whether a script tells the scenes, and with them how the cargo leans: each part that moves by
            itself costs the browser a layer.
        """
        self._name = name
        self.is_told = is_told
        self._kinds = [kind for kind in _KINDS if kind != 'cargo' or not is_told]
        self._cart, self._motion = cart, cart.motion
        self._timing = f'{self._motion.duration_sec:.4f}s linear both'
        # Digits that change with each frame could not be read.
        self._ticks = min(_MAX_TICKS, math.ceil(self._motion.duration_sec / _TICK_SEC))

    def css(self, kind: str) -> str:
        """Return the CSS that animates an element; the kinds are those of _KINDS, and strip."""
        return f'animation:{self._name}-{kind} {self._timing};' if kind in (*self._kinds, 'strip') else ''

    def keyframes(self) -> str:
        steps = {kind: ''.join(self._steps(kind)) for kind in self._kinds}
        # A strip that is pulled past a window is moved by the browser's compositor, like the cart itself. Text
        # that really changes would make the page's own thread lay it out again for each frame.
        steps['strip'] = (f'0% {{transform:none;animation-timing-function:steps({self._ticks})}}'
                          f'100% {{transform:translateY({-self._ticks * _LINE_PX}px)}}')
        return '<style>' + ''.join(f'@keyframes {self._name}-{kind} {{{each}}}' for kind, each in steps.items()) \
            + '</style>'

    def strip(self) -> str:
        """Return the numbers of all ticks, one below the other."""
        ticks_sec = (index / self._ticks * self._motion.duration_sec for index in range(self._ticks))
        moments = [*map(self._cart.at, ticks_sec), self._cart.at(math.inf)]
        lines = '\n'.join(moment.numbers for moment in moments)
        # Told, the script shows the line; otherwise the last one stands where nothing may move.
        shown_px = 0 if self.is_told else -self._ticks * _LINE_PX
        return (f'<span class="robot-strip" style="transform:translateY({shown_px}px);{self.css("strip")}">'
                f'{lines}</span>')

    def words(self) -> str:
        """Return the words of all phases in one place, each to be seen in its time."""
        starts_sec = [*_starts_sec(self._motion), math.inf]
        words = [self._cart.at(start_sec).state.word for start_sec in starts_sec[:-1]]
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
            yield (f'{100 * begin_sec / self._motion.duration_sec:.4f}% {{{_css(kind, self._cart, phase.at(0))}'
                   f'animation-timing-function:{timing}}}')
        yield f'100% {{{_css(kind, self._cart, self._motion.end)}}}'


def _timing_function(phase: 'Phase') -> str:
    """Return the CSS timing function of a phase: which part of its way is done after which part of its time."""
    way_m = phase.at(phase.duration_sec).position_m - phase.position_m
    start = phase.velocity_mps * phase.duration_sec / way_m if way_m else 1.0
    return f'cubic-bezier(0.333333,{start / 3:.6f},0.666667,{(1 + start) / 3:.6f})'


# What can move by itself.
_KINDS = ('robot', 'wheel', 'brake', 'cargo')


def _css(kind: str, cart: Cart, state: 'State') -> str:
    """Return the CSS that brings a part to its place in a state of the cart."""
    match kind:
        case 'robot':
            return f'transform:translateX({cart.x(state.position_m):.3f}px);'
        case 'wheel':
            return f'transform:rotate({state.position_m / _WHEEL_M:.4f}rad);'
        case 'brake':
            # The square of the speed changes with the way driven in the same proportion, so the timing is that of the
            # place.
            return f'transform:scaleX({cart.stopping_m(state) * cart.units_per_m / _BAR:.5f});'
    return f'transform:rotate({Moment(cart, state).lean_rad:.4f}rad);'


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
        f'<span>{moment.cart.mode}</span><span class="robot-node">{html.escape(moment.cart.node)}</span></div>'
        f'<div class="robot-scene" role="img" aria-label="{html.escape(moment.text)}">'
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" aria-hidden="true">'
        f'{_layers(moment, animation)}</svg></div></div>')


def _layers(moment: Moment, animation: _Animation | None) -> str:
    """Return what stands behind, the cart, and what stands in front of it."""
    cart, state = moment.cart, moment.state

    def css(kind: str) -> str:
        if kind == 'cargo' and animation and animation.is_told:
            return 'transform:rotate(var(--lean));'
        # Without an animation, or where the reader wants none, the state of this moment.
        return _css(kind, cart, state) + (animation.css(kind) if animation else '')

    bar = f'<path class="robot-brake" d="M0 {GROUND + 5}h{_BAR}" style="{css("brake")}"/>'
    return (f'{cart.behind()}<g class="robot-mover" style="{css("robot")}">{bar}'
            f'<g transform="translate(0 {GROUND})">{cart.drawn(css("wheel"), css("cargo"))}</g></g>'
            f'{cart.in_front()}')


# -- parts of pictures -----------------------------------------------------------------------------------------


def _ruler(cart: Cart) -> str:
    """Return the ground, with a mark at each meter, or at each second one of a long aisle."""
    end_m = cart.settings.stop_m
    parts = [f'<path class="robot-ground" d="M0 {GROUND}H{WIDTH}"/>']
    for meter in range(0, int(end_m) + 1, 1 if end_m <= 12 else 2):
        # Where the picture is narrow there is no room for every number of a long aisle.
        css_class = 'robot-between' if end_m > 6 and meter % 2 else ''
        parts.append(f'<path class="robot-line" d="M{cart.x(meter):.1f} {GROUND}v8"/>'
                     f'{svg.words(cart.x(meter), GROUND + 26, f"{meter} m", css_class=css_class)}')
    return ''.join(parts)


def _post(cart: Cart, position_m: float, words: str, css_class: str = '') -> str:
    """Return a dashed line across the aisle, with words above it."""
    x = cart.x(position_m)
    return (f'<path class="robot-line robot-post {css_class}" d="M{x:.1f} {GROUND}V30"/>'
            f'{svg.words(x, 23, words, css_class=css_class)}')


def _legend() -> str:
    """Return what the bar before the cart means."""
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
