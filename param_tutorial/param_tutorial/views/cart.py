"""The cart of chapter 11 in its aisle, as a widget that moves.

The view asks the node for nothing but its parameters, and works out the drive itself. So it shows the finished cart as
well as one that a learner is building, and a cart in another process. ``drawing.driving`` draws it so that the browser
moves it by itself, and ``driving.js`` shows it. A picture is sent only when the cart begins a motion or ends it; on the
way, a few words for each thing that it begins to do. While it stands still, nothing is sent.
"""

import html
import time
from typing import Any

import traitlets
from rclpy.node import Node

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import LiveParameters
from param_tools.panel.front import Front
from param_tools.panel.view import ParameterView
from param_tools.ros.schedule import Job
from param_tutorial.nodes.cart_node import AISLE_M, SIGHT_M
from param_tutorial.nodes.clawbot_node import SAFETY_GAP_M, Motion, Settings, State, plan
from param_tutorial.views.drawing import driving

_SHOW_PERIOD_SEC = 0.05
_READY = Motion((), State('READY', 0.0))


def settings_of(speed_mps: float, acceleration_mps2: float) -> Settings:
    """Return what a drive to the end of the aisle depends on."""
    return Settings(speed_mps, acceleration_mps2, track_m=AISLE_M + SAFETY_GAP_M)


def cart_on_trip(node: str, speed_mps: float, acceleration_mps2: float) -> driving.Cart:
    """Return a cart that is about to drive along the aisle.

    :param node: The name of its node.
    """
    settings = settings_of(speed_mps, acceleration_mps2)
    return _cart(node, settings, plan(0.0, 0.0, settings))


def _cart(node: str, settings: Settings, motion: Motion, before_sec: float = 0.0) -> driving.Cart:
    return driving.Cart(name=node.rpartition('/')[2], node=node, settings=settings, motion=motion, sight_m=SIGHT_M,
                before_sec=before_sec)


class _Front(Front):
    """The cart in the browser."""

    _esm = bundle('param_tutorial/views/driving.js')
    _css = sheet('param_tutorial/views/drawing/track.css') + sheet('param_tutorial/views/driving.css')
    markup = traitlets.Unicode(driving.view('Drive', 'Put it back to the start, and let it go')).tag(sync=True)
    picture = traitlets.Unicode().tag(sync=True)
    take = traitlets.Int().tag(sync=True)
    """The number of the picture: the same one may be shown again, from its beginning."""
    scene: traitlets.List[Any] = traitlets.List().tag(sync=True)
    """What the picture tells; empty if there is no cart."""


class CartView(ParameterView):
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
        self._text = ''
        # What is shown, and the word for what it does.
        self._cart: driving.Cart | None = None
        self._word = ''
        self._front = _Front()
        self._front.on_msg(self._on_message)
        super().__init__([self._front], 'robot-view')
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

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        if content == {'do': 'drive'}:
            self.drive()

    def _draw(self, cart: driving.Cart, elapsed_sec: float) -> None:
        """Show the cart so many seconds after its motion began, unless the browser is at it already."""
        moment = cart.at(elapsed_sec)
        # The same drive may begin anew.
        goes_on = cart == self._cart and cart.motion is self._cart.motion
        if goes_on and moment.state.word == self._word:
            return
        self._cart, self._word, self._text = cart, moment.state.word, moment.text
        is_moving = elapsed_sec < cart.motion.duration_sec
        with self._front.hold_sync():
            if not is_moving or not goes_on:
                self._show_picture(driving.moving(cart) if is_moving else driving.still(moment))
            self._front.scene = list(moment.scene)

    def _draw_nothing(self, words: str) -> None:
        """Say why there is nothing to see."""
        self._cart = None
        self._text = words
        with self._front.hold_sync():
            self._show_picture(f'<div class="robot-head">{html.escape(words)}</div>')
            self._front.scene = []

    def _show_picture(self, picture: str) -> None:
        self._front.picture = picture
        self._front.take += 1
