"""The robot of ClawbotNode on its track, as a widget that moves."""

from collections.abc import Callable
from typing import Any

from param_tools.errors import NodeNotFoundError
from param_tools.panel.view import FollowingView, no_op
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import full_name
from param_tutorial.nodes.clawbot_node import ROBOT_LENGTH_M, SENSOR_MOUNT_M, ClawbotNode, Motion
from param_tutorial.views.base import name_of
from param_tutorial.views.drawing.robot import Robot
from param_tutorial.views.driving import DrivingView


class RobotView(DrivingView, FollowingView):
    """A robot that moves as its parameters let it, until it is closed. Show it as the last line of a cell."""

    _show_period_sec = 0.05

    def __init__(self, robot: ClawbotNode | str) -> None:
        """:param robot: The node, or its name; it has to be spun in this process, now or later."""
        self._name = full_name(robot)
        self._robot: ClawbotNode | None = None
        self._stop_motion: Callable[[], None] = no_op
        super().__init__()
        self._begin()

    def __repr__(self) -> str:
        return f'<RobotView: {self._name}{", closed" if self._closed else ""}>'

    def drive(self) -> None:
        """Put the robot back to the start and let it go, as the button does.

        :raises NodeNotFoundError: it is not running in this process.
        """
        with self._drawing:
            robot = self._find_robot()
        if robot is None:
            raise NodeNotFoundError(self._name, [name_of(node) for node in self._executor.nodes]
                                    if self._executor else [])
        robot.drive()

    @property
    def node(self) -> str:
        return self._name

    # -- following the node ------------------------------------------------------------------------------

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        return executor.on_graph_change(self._job.wake)

    def _stop(self) -> None:
        super()._stop()
        self._stop_motion()

    def _find_robot(self) -> ClawbotNode | None:
        """Find the node that has the name now, and listen to it."""
        nodes = self._executor.nodes if self._executor else ()
        robot = next((node for node in nodes if isinstance(node, ClawbotNode) and name_of(node) == self._name), None)
        if robot is not self._robot:
            self._stop_motion()
            self._robot = robot
            self._stop_motion = robot.on_motion(self._job.wake) if robot else no_op
        return robot

    # -- drawing: the worker's thread -------------------------------------------------------------------

    def _show(self) -> None:
        robot = self._find_robot()
        if robot is None:
            self._draw_nothing(f'{self._name} is not running. It comes back here when it does.')
        else:
            motion, elapsed_sec = robot.motion
            self._draw(vehicle_of(robot, motion), elapsed_sec)


def vehicle_of(robot: ClawbotNode, motion: Motion) -> Robot:
    """Return what a picture needs to know about a robot, read from its node."""
    def value(name: str) -> Any:
        return robot.get_parameter(name).value

    return Robot(name=value('robot_name'), serial_number=value('robot_serial_number'), length_m=ROBOT_LENGTH_M,
                 wheel_m=value('simulation.wheel_radius_meters'), sensor_mount_m=SENSOR_MOUNT_M,
                 temperature_c=value('simulation.ambient_temperature_c'), settings=robot.settings, motion=motion,
                 waiting_for=robot.waiting_for() if motion.end.word == 'WAITING' else '')
