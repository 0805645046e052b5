"""The robot of ClawbotNode on its track, as a widget that moves.

The kernel draws no frames. A motion is a few phases of constant acceleration, and the distance driven in each is a
quadratic function of time, which a CSS ``cubic-bezier(1/3, p/3, 2/3, (1 + p)/3)`` is exactly. So each phase becomes
one step of a CSS animation, and the browser moves the robot by itself, at its own frame rate. Something is sent only
when the robot begins to do something else, or when a parameter changes; while it stands still, nothing is.
"""

import html
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import ipywidgets as widgets
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node

from param_tutorial.errors import ExecutorError, NodeNotFoundError
from param_tutorial.nodes.clawbot_node import ROBOT_LENGTH_M, ClawbotNode, Motion, Phase, Settings, State
from param_tutorial.runtime import stage
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import full_name
from param_tutorial.runtime.worker import Worker
from param_tutorial.widgets.cells import close_with_cell
from param_tutorial.widgets.view import View, nothing

_SHOW_PERIOD_SEC = 0.05
# How long to look for a robot that is known to be coming.
_LOOK_PERIOD_SEC = 0.1
_LOOKS_FOR_ROBOT = 50
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

STYLE = """<style>
.robot-view { box-sizing: border-box; max-width: 56em; margin: 4px 0; padding: 0; overflow: hidden;
  border: 1px solid var(--jp-border-color2, #bdbdbd); border-radius: 6px;
  background: var(--jp-layout-color1, #fff); color: var(--jp-ui-font-color1, #212121); }
.robot-view .widget-html, .robot-view .widget-html-content { line-height: 1.4; height: auto; margin: 0;
  min-height: 0; width: auto; overflow: visible; color: inherit; }
.robot-view .robot-head { display: flex; flex-wrap: wrap; align-items: baseline; gap: 2px 18px; padding: 6px 14px;
  border-bottom: 1px solid var(--jp-border-color2, #bdbdbd); background: var(--jp-layout-color2, #eee); }
.robot-view .robot-node { font-family: var(--jp-code-font-family, monospace); font-weight: 600; }
.robot-view .robot-word { font-weight: 700; letter-spacing: .04em; min-width: 10.5em; }
.robot-view .robot-window { display: inline-block; height: 20px; overflow: hidden; align-self: center; width: 19em; }
.robot-view .robot-strip { display: block; white-space: pre; line-height: 20px; font-variant-numeric: tabular-nums; }
.robot-view .robot-scene { position: relative; overflow: hidden; }
.robot-view .robot-scene > svg { display: block; width: 100%; height: auto; }
.robot-view .robot-mover { position: absolute; inset: 0; }
.robot-view .robot-mover > svg { position: absolute; overflow: visible; height: auto; }
.robot-view .robot-wheel { transform-box: fill-box; transform-origin: center; }
.robot-view svg text { fill: var(--jp-ui-font-color1, #212121); font-family: var(--jp-ui-font-family, sans-serif);
  font-size: 15px; }
.robot-view .robot-line { stroke: var(--jp-ui-font-color1, #212121); fill: none; stroke-width: 1.5; }
.robot-view .robot-ground { stroke: var(--jp-ui-font-color1, #212121); stroke-width: 2.5; }
.robot-view .robot-wall { fill: var(--jp-layout-color3, #bdbdbd); stroke: var(--jp-ui-font-color1, #212121);
  stroke-width: 2.5; }
.robot-view .robot-burst { fill: var(--jp-layout-color1, #fff); stroke: var(--jp-error-color1, #d32f2f);
  stroke-width: 3.5; stroke-linejoin: round; }
.robot-view .robot-body { fill: var(--jp-brand-color1, #1976d2); stroke: var(--jp-ui-font-color1, #212121);
  stroke-width: 1.2; stroke-linejoin: round; }
.robot-view .robot-part { fill: var(--jp-layout-color1, #fff); stroke: var(--jp-ui-font-color1, #212121);
  stroke-width: 1.2; stroke-linejoin: round; stroke-linecap: round; }
.robot-view .robot-arm { fill: none; stroke: var(--jp-ui-font-color1, #212121); stroke-width: 2.4;
  stroke-linejoin: round; stroke-linecap: round; }
.robot-view .robot-wave { fill: none; stroke: var(--jp-ui-font-color1, #212121); stroke-width: 1;
  stroke-linecap: round; }
.robot-view .robot-foot { align-items: center; padding: 4px 14px 8px; margin: 0; gap: 12px; overflow: visible; }
.robot-view .robot-foot > * { margin: 0; }
.robot-view .robot-foot .widget-button { flex: none; width: auto; padding: 0 16px; font-weight: 600; }
@media (prefers-reduced-motion: reduce) { .robot-view .robot-stage, .robot-view .robot-stage * {
  animation: none !important; } }
</style>"""


class RobotView(View):
    """A robot that moves as its parameters let it, until it is closed. Show it as the last line of a cell."""

    def __init__(self, robot: ClawbotNode | str, *, executor: BackgroundExecutor | None = None):
        """
        :param robot: The node, or its name; it has to be spun in this process, now or later.
        :param executor: Spins it; by default whichever runs in the background, also after a stop and a new start.
        """
        self._name = full_name(robot)
        self._chosen_executor = executor
        self._executor: BackgroundExecutor | None = None
        self._robot: ClawbotNode | None = None
        self._looks_left = 0
        self._count = 0
        self._text = ''
        self._shown: tuple = ()
        self._picture, self._status = widgets.HTML(), widgets.HTML()
        self._button = widgets.Button(description='Drive', tooltip='Put the robot back to the start, and let it go')
        self._button.on_click(lambda _: self.drive())
        foot = widgets.HBox([self._button, self._status])
        foot.add_class('robot-foot')
        super().__init__([widgets.HTML(STYLE), self._picture, foot], 'robot-view')
        self._worker = Worker(self._show, 'robot view', _SHOW_PERIOD_SEC)
        self._stop_graph: Callable[[], None] = nothing
        self._stop_motion: Callable[[], None] = nothing
        self._stop_following = stage.on_change(self._on_executor_change)
        self._on_executor_change()
        self._worker.call_now(1.0)
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<RobotView: {self._name}{", closed" if self._closed else ""}>'

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def drive(self) -> None:
        """Put the robot back to the start and let it go, as the button does.

        :raises NodeNotFoundError: it is not running in this process.
        """
        robot = self._robot_here()
        if robot is None:
            raise NodeNotFoundError(self._name, [node.get_fully_qualified_name() for node in self._executor.nodes]
                                    if self._executor else [])
        robot.drive()

    def _robot_here(self) -> ClawbotNode | None:
        with self._drawing:
            return self._find_robot()

    def _end(self) -> None:
        for stop in (self._stop_following, self._stop_graph, self._stop_motion, self._worker.end):
            stop()

    # -- following the node ------------------------------------------------------------------------------

    def _on_executor_change(self) -> None:
        self._stop_graph()
        try:
            self._executor = self._chosen_executor or stage.current()
            self._stop_graph = self._executor.on_graph_change(self._on_graph_change)
        except ExecutorError:
            self._executor, self._stop_graph = None, nothing
        self._on_graph_change()

    def _on_graph_change(self) -> None:
        self._looks_left = _LOOKS_FOR_ROBOT
        self._worker.wake()

    def _find_robot(self) -> ClawbotNode | None:
        """Find the node that has the name now, and listen to it."""
        nodes = self._executor.nodes if self._executor else ()
        robot = next((node for node in nodes if _is_robot(node, self._name)), None)
        if robot is not self._robot:
            self._stop_motion()
            self._robot = robot
            self._stop_motion = robot.on_motion(self._worker.wake) if robot else nothing
        return robot

    # -- drawing: the worker's thread -------------------------------------------------------------------

    def _show(self) -> float | None:
        with self._drawing:
            if self._closed:
                return None
            robot = self._find_robot()
            if robot is None:
                self._shown = ()
                self._text = f'{self._name} is not running. It comes back here when it does.'
                self._picture.value = f'<div class="robot-head">{html.escape(self._text)}</div>'
                self._status.value = ''
                self._button.disabled = True
                # The graph may tell of a node whose constructor is still running.
                self._looks_left -= 1
                coming = self._executor and self._looks_left > 0 and self._executor.node_incarnations(self._name)
                return _LOOK_PERIOD_SEC if coming else None
            motion, elapsed_sec = robot.motion
            facts = _Facts(robot, motion, motion.at(elapsed_sec))
            shown = motion, facts.state.word, facts.settings, facts.head
            if shown == self._shown:
                return None  # the browser is at it
            self._shown = shown
            self._text = facts.text
            animation = None
            if elapsed_sec < motion.duration_sec:
                self._count += 1
                animation = _Animation(f'robot-{self.model_id[:8]}-{self._count}', motion, elapsed_sec, facts)
            self._picture.value = _picture(facts, animation)
            self._status.value = f'<div role="status">{html.escape(facts.sentence)}</div>'
            self._button.disabled = False
        return None

    # -- recording: see ``recordable`` -------------------------------------------------------------------

    in_motion = True

    @property
    def node(self) -> str:
        """The fully qualified name of the robot's node."""
        return self._name

    def rest(self) -> None:
        """Let the robot's motion come to its end at once."""
        if robot := self._robot_here():
            robot.step(math.inf)

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw it as it stands."""
        shown = self.look()
        return super().snapshot() if shown is None else {'kind': 'robot', 'node': self.node, 'look': shown}

    def look(self) -> dict[str, str] | None:
        """Return the robot as it stands; None if it is not running in this process."""
        if (robot := self._robot_here()) is None:
            return None
        picture, text, sentence = still(robot)
        return {'picture': picture, 'text': text, 'sentence': sentence}

    def film(self) -> dict[str, Any] | None:
        """Let the robot drive, and return what there is to see; it is at its goal then."""
        if (robot := self._robot_here()) is None:
            return None
        robot.drive()
        # Several pictures of one page have animations of their own names.
        seen = film(robot, 'robot-NAME')
        robot.step(math.inf)
        return {'picture': seen.picture, 'end': seen.end, 'scenes': [list(scene) for scene in seen.scenes]}


class _Facts:
    """What is shown of a robot at one moment."""

    def __init__(self, robot: ClawbotNode, motion: Motion, state: State):
        self.settings: Settings = robot.settings
        self.state = state
        self.name = robot.get_parameter('robot_name').value
        self.wheel_m = robot.get_parameter('simulation.wheel_radius_meters').value
        self.gap_m = self.settings.track_m - state.position_m
        self.safety = f'safety {"on" if self.settings.safety_on else "off"}'
        self.head = (self.name, robot.get_parameter('robot_serial_number').value)
        self.sentence = f'{self.name} {self._does(robot, motion)}.'
        self.text = f'{state.word}. {self.sentence} {_numbers(self, state).capitalize()}, {self.safety}.'

    def _does(self, robot: ClawbotNode, motion: Motion) -> str:
        state, settings = self.state, self.settings
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
                gap_m = settings.track_m - motion.end.position_m
                hard = ' as hard as it can' if state.word == 'EMERGENCY BRAKING' else ''
                return f'is braking{hard}, ' + (f'to stop {gap_m:.2f} m from the wall' if gap_m > 0 else 'too late')
            case 'WAITING':
                return f'is waiting: {robot.waiting_for()}'
            case 'STOPPED':
                return f'has stopped {self.gap_m:.2f} m from the wall'
            case 'CRASHED':
                return f'has run into the wall at {state.crash_speed_mps:.2f} m/s'
        raise AssertionError(f'no words for {state.word}')


class _Animation:
    """A motion as CSS: one step of the animation for each phase, and the numbers as a strip of film."""

    def __init__(self, name: str, motion: Motion, elapsed_sec: float, facts: _Facts):
        self._name = name
        self._motion = motion
        self._facts = facts
        self._timing = f'{motion.duration_sec:.4f}s linear {-elapsed_sec:.4f}s both'
        # Digits that change with each frame could not be read.
        self._ticks = min(_MAX_TICKS, math.ceil(motion.duration_sec / _TICK_SEC))
        self._tick = int(elapsed_sec / motion.duration_sec * self._ticks)

    def use(self, kind: str) -> str:
        """Give the CSS that animates an element; the kinds are those of _LOOKS, and strip."""
        return f'animation:{self._name}-{kind} {self._timing};'

    def sheet(self) -> str:
        """Give the keyframes of every kind."""
        steps = {kind: ''.join(self._steps(kind)) for kind in _LOOKS}
        # A strip that is pulled past a window is moved by the browser's compositor, like the robot itself. Text
        # that really changes would make the page's own thread lay it out again for each frame.
        steps['strip'] = (f'0% {{transform:none;animation-timing-function:steps({self._ticks})}}'
                          f'100% {{transform:translateY({-self._ticks * _LINE_PX}px)}}')
        return '<style>' + ''.join(f'@keyframes {self._name}-{kind} {{{each}}}' for kind, each in steps.items()) \
            + '</style>'

    def strip(self) -> str:
        """Give the numbers of all ticks, one below the other."""
        states = [self._motion.at(index / self._ticks * self._motion.duration_sec) for index in range(self._ticks)]
        lines = '\n'.join(_numbers(self._facts, state) for state in (*states, self._motion.end))
        return (f'<span class="robot-strip" style="transform:translateY({-self._tick * _LINE_PX}px);'
                f'{self.use("strip")}">{lines}</span>')

    def _steps(self, kind: str) -> Iterator[str]:
        begins_sec = 0.0
        for phase in self._motion.phases:
            yield (f'{100 * begins_sec / self._motion.duration_sec:.4f}% {{{_LOOKS[kind](self._facts, phase.at(0))}'
                   f'animation-timing-function:{_curve(phase)}}}')
            begins_sec += phase.duration_sec
        yield f'100% {{{_LOOKS[kind](self._facts, self._motion.end)}}}'


@dataclass(frozen=True)
class Film:
    """A drive, for a page that has no kernel to ask."""

    picture: str
    """HTML that moves by itself, from now on."""
    scenes: tuple[tuple[float, str, str, str], ...]
    """What changes in words, and after how many seconds: word, text alternative, sentence."""
    end: str
    """HTML of the robot at rest."""


def still(robot: ClawbotNode) -> tuple[str, str, str]:
    """Give the picture of a robot at this moment as HTML, its text alternative, and the sentence below it."""
    motion, elapsed_sec = robot.motion
    facts = _Facts(robot, motion, motion.at(elapsed_sec))
    return _picture(facts, None), facts.text, facts.sentence


def film(robot: ClawbotNode, name: str) -> Film:
    """Give what a RobotView would show of the motion that the robot has just begun, up to its end.

    :param name: Of the animation; must differ from those of all other pictures on the page.
    """
    motion, _ = robot.motion
    starts = [sum(phase.duration_sec for phase in motion.phases[:index]) for index in range(len(motion.phases) + 1)]
    facts = [_Facts(robot, motion, motion.at(at_sec)) for at_sec in starts]
    animation = _Animation(name, motion, 0.0, facts[0]) if motion.phases else None
    return Film(_picture(facts[0], animation),
                tuple((at_sec, each.state.word, each.text, each.sentence) for at_sec, each in zip(starts, facts)),
                _picture(facts[-1], None))


def _curve(phase: Phase) -> str:
    """Give the CSS timing function of a phase: which part of its way is done after which part of its time."""
    way_m = phase.at(phase.duration_sec).position_m - phase.position_m
    start = phase.velocity_mps * phase.duration_sec / way_m if way_m else 1.0
    return f'cubic-bezier(0.333333,{start / 3:.6f},0.666667,{(1 + start) / 3:.6f})'


def _robot_css(facts: _Facts, state: State) -> str:
    return f'transform:translateX({100 * state.position_m / _length_m(facts.settings):.4f}%);'


def _wheel_css(facts: _Facts, state: State) -> str:
    return f'transform:rotate({state.position_m / facts.wheel_m:.4f}rad);'


_LOOKS = {'robot': _robot_css, 'wheel': _wheel_css}


def _numbers(facts: _Facts, state: State) -> str:
    return f'speed {state.velocity_mps:.2f} m/s, {facts.settings.track_m - state.position_m:.2f} m to the wall'


def _length_m(settings: Settings) -> float:
    """Give how many metres the picture shows."""
    return _BEFORE_START_M + settings.track_m + _BEHIND_WALL_M


def _picture(facts: _Facts, animation: _Animation | None) -> str:
    def look(kind: str) -> str:
        # Without an animation, or where the reader wants none, the state of this moment.
        return _LOOKS[kind](facts, facts.state) + (animation.use(kind) if animation else '')

    settings, (name, serial) = facts.settings, facts.head
    strip = animation.strip() if animation else f'<span class="robot-strip">{_numbers(facts, facts.state)}</span>'
    unit = _WIDTH / _length_m(settings)
    left_m = _BEFORE_START_M - ROBOT_LENGTH_M
    place = f'left:{100 * left_m / _length_m(settings):.4f}%;width:{100 * ROBOT_LENGTH_M / _length_m(settings):.4f}%'
    height = _ABOVE_ROBOT + _ROBOT_HEIGHT_M * unit + _BELOW_GROUND
    tilt = 'transform:rotate(-5deg);transform-origin:100% 100%;' if facts.state.word == 'CRASHED' else ''
    return (
        f'{animation.sheet() if animation else ""}<div class="robot-stage">'
        f'<div class="robot-head" aria-hidden="true"><span class="robot-node">{html.escape(name)} '
        f'({html.escape(serial)})</span><span class="robot-word">{facts.state.word}</span>'
        f'<span class="robot-window">{strip}</span>'
        f'<span>{facts.safety}</span></div>'
        f'<div class="robot-scene" role="img" aria-label="{html.escape(facts.text)}">'
        f'{_scene(facts, unit, height)}<div class="robot-mover" style="{look("robot")}">'
        f'<svg viewBox="0 0 60 40" aria-hidden="true" '
        f'style="{place};bottom:{100 * _BELOW_GROUND / height:.3f}%;{tilt}">'
        f'{_robot(facts, look("wheel"))}</svg></div></div></div>')


def _scene(facts: _Facts, unit: float, height: float) -> str:
    """Draw what stands still: the track with its ruler, the start line, the wall, where the robot is to stop."""
    settings = facts.settings
    ground = height - _BELOW_GROUND

    def x(position_m: float) -> float:
        return (_BEFORE_START_M + position_m) * unit

    wall = x(settings.track_m)
    parts = [f'<path class="robot-ground" d="M0 {ground:.1f}H{_WIDTH}"/>']
    every_m = 1 if settings.track_m <= 10 else 2
    for metre in range(0, int(settings.track_m) + 1, every_m):
        parts.append(f'<path class="robot-line" d="M{x(metre):.1f} {ground:.1f}v8"/><text x="{x(metre):.1f}" '
                     f'y="{ground + 25:.1f}" text-anchor="middle">{metre} m</text>')
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
    if facts.state.word == 'CRASHED':
        parts.append(f'<polygon class="robot-burst" points="{_burst(wall, ground - 0.22 * unit, 0.24 * unit)}"/>')
    return f'<svg viewBox="0 0 {_WIDTH} {height:.1f}" aria-hidden="true">{"".join(parts)}</svg>'


def _burst(x: float, y: float, radius: float) -> str:
    """Give the corners of a star of eight rays, in whole eighths so that no library is needed for the circle."""
    directions = ((1, 0), (.92, .38), (.71, .71), (.38, .92), (0, 1), (-.38, .92), (-.71, .71), (-.92, .38))
    circle = [*directions, *((-a, -b) for a, b in directions)]
    return ' '.join(f'{x + a * radius * (1 - index % 2 * .5):.1f},{y + b * radius * (1 - index % 2 * .5):.1f}'
                    for index, (a, b) in enumerate(circle))


def _robot(facts: _Facts, wheel_css: str) -> str:
    """Draw the robot, in centimetres; its claws end at 60, where its front is."""
    radius = 100 * facts.wheel_m
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
        f'{waves if facts.settings.safety_on else ""}{wheels}')


def _is_robot(node: Node, name: str) -> bool:
    try:
        return isinstance(node, ClawbotNode) and node.get_fully_qualified_name() == name
    except InvalidHandle:  # destroyed after the list of nodes was made
        return False
