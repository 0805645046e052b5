"""The robot of ClawbotNode on its track, as a widget that moves.

``pictures.robot`` draws it so that the browser moves it by itself. Something is sent only when the robot begins to do
something else, or when a parameter changes; while it stands still, nothing is.
"""

import html
import math
from collections.abc import Callable
from typing import Any, TypeGuard

import ipywidgets as widgets
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node

from param_tutorial.errors import ExecutorError, NodeNotFoundError
from param_tutorial.nodes.clawbot_node import ROBOT_LENGTH_M, ClawbotNode, Motion
from param_tutorial.pictures import robot as scene
from param_tutorial.pictures.styles import style
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

_STYLE = scene.STYLE + style('widgets/robot.css')

class RobotView(View):
    """A robot that moves as its parameters let it, until it is closed. Show it as the last line of a cell."""

    def __init__(self, robot: ClawbotNode | str, *, executor: BackgroundExecutor | None = None) -> None:
        """
        :param robot: The node, or its name; it has to be spun in this process, now or later.
        :param executor: Spins it; by default the one that runs in the background, also after a stop and a new start.
        """
        self._name = full_name(robot)
        self._chosen_executor = executor
        self._executor: BackgroundExecutor | None = None
        self._robot: ClawbotNode | None = None
        self._looks_left = 0
        self._count = 0
        self._text = ''
        self._shown: tuple[scene.Robot, str] | None = None
        self._picture, self._status = widgets.HTML(), widgets.HTML()
        self._button = widgets.Button(description='Drive', tooltip='Put the robot back to the start, and let it go')
        self._button.on_click(lambda _: self.drive())
        foot = widgets.HBox([self._button, self._status])
        foot.add_class('robot-foot')
        super().__init__([widgets.HTML(_STYLE), self._picture, foot], 'robot-view')
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
                self._shown = None
                self._text = f'{self._name} is not running. It comes back here when it does.'
                self._picture.value = f'<div class="robot-head">{html.escape(self._text)}</div>'
                self._status.value = ''
                self._button.disabled = True
                # The graph may tell of a node whose constructor is still running.
                self._looks_left -= 1
                coming = self._executor and self._looks_left > 0 and self._executor.node_incarnations(self._name)
                return _LOOK_PERIOD_SEC if coming else None
            motion, elapsed_sec = robot.motion
            facts = _facts(robot, motion)
            moment = facts.at(elapsed_sec)
            shown = facts, moment.state.word
            if shown == self._shown:
                return None  # the browser is at it
            self._shown = shown
            self._text = moment.text
            if elapsed_sec < motion.duration_sec:
                self._count += 1
                self._picture.value = scene.moving(facts, elapsed_sec, f'robot-{self.model_id[:8]}-{self._count}')
            else:
                self._picture.value = scene.still(moment)
            self._status.value = f'<div role="status">{html.escape(moment.sentence)}</div>'
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
        motion, elapsed_sec = robot.motion
        moment = _facts(robot, motion).at(elapsed_sec)
        return {'picture': scene.still(moment), 'text': moment.text, 'sentence': moment.sentence}

    def film(self) -> dict[str, Any] | None:
        """Let the robot drive, and return what there is to see; it is at its goal then."""
        if (robot := self._robot_here()) is None:
            return None
        robot.drive()
        motion, _ = robot.motion
        # Several pictures of one page have animations of their own names.
        film = scene.film(_facts(robot, motion), 'robot-NAME')
        robot.step(math.inf)
        return {'picture': film.picture, 'end': film.end, 'scenes': [list(each) for each in film.scenes]}


def _facts(robot: ClawbotNode, motion: Motion) -> scene.Robot:
    """Return what a picture needs to know about a robot, read from its node."""
    def value(name: str) -> Any:
        return robot.get_parameter(name).value

    return scene.Robot(name=value('robot_name'), serial_number=value('robot_serial_number'), length_m=ROBOT_LENGTH_M,
                       wheel_radius_m=value('simulation.wheel_radius_meters'), settings=robot.settings, motion=motion,
                       waiting_for=robot.waiting_for() if motion.end.word == 'WAITING' else '')


def _is_robot(node: Node, name: str) -> TypeGuard[ClawbotNode]:
    try:
        return isinstance(node, ClawbotNode) and node.get_fully_qualified_name() == name
    except InvalidHandle:  # destroyed after the list of nodes was made
        return False
