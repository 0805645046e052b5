"""The cart of chapter 11 in its aisle, as a widget that moves.

The view asks the node for nothing but its parameters, and works out the drive itself. So it shows the finished cart as
well as one that a learner is building, and a cart in another process.
"""

import time
from typing import Any

from rclpy.node import Node

from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import LiveParameters
from param_tools.panel.view import ParameterView
from param_tools.ros.schedule import Job
from param_tutorial.nodes.cart_node import AISLE_M, SIGHT_M
from param_tutorial.nodes.clawbot_node import SAFETY_GAP_M, Motion, Settings, State, plan
from param_tutorial.views.drawing.cart import Cart
from param_tutorial.views.driving import DrivingView

_SHOW_PERIOD_SEC = 0.05
_READY = Motion((), State('READY', 0.0))


def settings_of(speed_mps: float, acceleration_mps2: float) -> Settings:
    """Return what a drive to the end of the aisle depends on."""
    return Settings(speed_mps, acceleration_mps2, track_m=AISLE_M + SAFETY_GAP_M)


def cart_on_trip(node: str, speed_mps: float, acceleration_mps2: float) -> Cart:
    """Return a cart that is about to drive along the aisle.

    :param node: The name of its node.
    """
    settings = settings_of(speed_mps, acceleration_mps2)
    return _cart(node, settings, plan(0.0, 0.0, settings))


def _cart(node: str, settings: Settings, motion: Motion, before_sec: float = 0.0) -> Cart:
    return Cart(name=node.rpartition('/')[2], node=node, settings=settings, motion=motion, sight_m=SIGHT_M,
                before_sec=before_sec)


class CartView(DrivingView, ParameterView):
    """A cart that drives along its aisle as its parameters say, until it is closed.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient) -> None:
        """
        :param node: The node or its name, with the parameters max_speed_mps and max_acceleration_mps2; it may run in
            another process, and it may be absent now.
        """
        self._settings: Settings | None = None
        self._motion, self._begin_sec, self._before_sec = _READY, 0.0, 0.0
        # It comes back when the cart begins to do something else.
        self._clock = Job(self._show, _SHOW_PERIOD_SEC)
        self._live = LiveParameters(node_name(node), self._follow)
        super().__init__()
        self._begin()

    def drive(self) -> None:
        """Put the cart back to the start and let it go, as the button does; nothing happens while it is not there."""
        with self._drawing:
            if self._settings is not None:
                self._go(_READY.end, 0.0)
        self._follow()

    def _end(self) -> None:
        self._clock.end()
        super()._end()

    @property
    def _elapsed_sec(self) -> float:
        return time.monotonic() - self._begin_sec

    def _go(self, state: State, before_sec: float) -> None:
        """Begin a new motion here and now."""
        assert self._settings is not None
        self._before_sec, self._begin_sec = before_sec, time.monotonic()
        self._motion = plan(state.position_m, state.velocity_mps, self._settings)

    def _follow(self) -> None:
        self._clock.call_now(1.0)

    def _show(self) -> float | None:
        with self._drawing:
            if self._closed:
                return None
            status = self._live.status or self._take_settings()
            if status:
                self._draw_nothing(status)
                return None
            assert self._settings is not None  # it was taken
            elapsed_sec = self._elapsed_sec
            self._draw(_cart(self.node, self._settings, self._motion, self._before_sec), elapsed_sec)
            for phase in self._motion.phases:
                if elapsed_sec < phase.duration_sec:
                    return phase.duration_sec - elapsed_sec
                elapsed_sec -= phase.duration_sec
            return None

    def _take_settings(self) -> str:
        """Take over what the node has, on the way too; return why the cart cannot drive with it."""
        def value(name: str) -> Any:
            parameter = self._live.parameters.get(name)
            return None if parameter is None else parameter.value

        speed, acceleration = value('max_speed_mps'), value('max_acceleration_mps2')
        for name, number in (('max_speed_mps', speed), ('max_acceleration_mps2', acceleration)):
            if not isinstance(number, float) or not number > 0:
                self._settings = None
                return f'{self.node} cannot drive: {name} is {"not there" if number is None else repr(number)}.'
        settings = settings_of(speed, acceleration)
        if settings != self._settings:
            state, driven_sec = self._motion.at(self._elapsed_sec), self._before_sec + self._elapsed_sec
            self._settings = settings
            # Where a drive has ended, only the next one makes a difference.
            if state.word not in ('READY', 'STOPPED'):
                self._go(state, driven_sec)
        return ''
