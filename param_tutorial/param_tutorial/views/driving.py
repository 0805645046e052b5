"""A vehicle on its track, as a widget with a button: what the views of the robot and the cart have in common.

``drawing.driving`` draws it so that the browser moves it by itself, and ``driving.js`` shows it. A picture is sent only
when the vehicle begins a motion or ends it; on the way, a few words for each thing that it begins to do. While it
stands still, nothing is sent.
"""

import contextlib
import html
from typing import Any

import traitlets

from param_tools.errors import NodeNotFoundError
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front
from param_tools.panel.view import View
from param_tutorial.views.drawing import driving


class _Front(Front):
    """The vehicle in the browser."""

    _esm = bundle('param_tutorial/views/driving.js')
    _css = sheet('param_tutorial/views/drawing/track.css') + sheet('param_tutorial/views/driving.css')
    markup = traitlets.Unicode(driving.view('Drive', 'Put it back to the start, and let it go')).tag(sync=True)
    picture = traitlets.Unicode().tag(sync=True)
    take = traitlets.Int().tag(sync=True)
    """The number of the picture: the same one may be shown again, from its beginning."""
    scene: traitlets.List[Any] = traitlets.List().tag(sync=True)
    """What the picture tells; empty if there is no vehicle."""


class DrivingView(View):
    """A vehicle that drives when its button is pressed. Its picture is drawn anew only when it has to be."""

    def __init__(self) -> None:
        self._text = ''
        # What is shown, and the word for what it does.
        self._vehicle: driving.Vehicle | None = None
        self._word = ''
        self._front = _Front()
        self._front.on_msg(self._on_message)
        super().__init__([self._front], 'robot-view')

    def drive(self) -> None:
        """Put the vehicle back to the start and let it go, as the button does."""
        raise NotImplementedError

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        # One that has just gone is about to be said to be gone.
        if content == {'do': 'drive'}:
            with contextlib.suppress(NodeNotFoundError):
                self.drive()

    def _draw(self, vehicle: driving.Vehicle, elapsed_sec: float) -> None:
        """Show a vehicle so many seconds after its motion began, unless the browser is at it already."""
        moment = vehicle.at(elapsed_sec)
        # The same drive may begin anew.
        goes_on = vehicle == self._vehicle and vehicle.motion is self._vehicle.motion
        if goes_on and moment.state.word == self._word:
            return
        self._vehicle, self._word, self._text = vehicle, moment.state.word, moment.text
        is_moving = elapsed_sec < vehicle.motion.duration_sec
        with self._front.hold_sync():
            if not is_moving or not goes_on:
                self._show_picture(driving.moving(vehicle) if is_moving else driving.still(moment))
            self._front.scene = list(moment.scene)

    def _draw_nothing(self, words: str) -> None:
        """Say why there is nothing to see."""
        self._vehicle = None
        self._text = words
        with self._front.hold_sync():
            self._show_picture(f'<div class="robot-head">{html.escape(words)}</div>')
            self._front.scene = []

    def _show_picture(self, picture: str) -> None:
        self._front.picture = picture
        self._front.take += 1
