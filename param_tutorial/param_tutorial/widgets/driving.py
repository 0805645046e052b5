"""A vehicle on its track, as a widget with a button: what the views of the robot and the cart have in common.

``pictures.track`` draws it so that the browser moves it by itself. Something is sent only when the vehicle begins to do
something else, or when a parameter changes; while it stands still, nothing is.
"""

import html
from typing import Any

import ipywidgets as widgets

from param_tutorial.pictures import track
from param_tutorial.pictures.styles import style
from param_tutorial.widgets.view import View

_STYLE = track.STYLE + style('widgets/driving.css')


class DrivingView(View):
    """A vehicle that drives when its button is pressed. Its picture is drawn anew only when it has to be."""

    def __init__(self, tooltip: str) -> None:
        self._count = 0
        self._text = ''
        self._shown: tuple[track.Vehicle, str] | None = None
        self._picture, self._status = widgets.HTML(), widgets.HTML()
        self._button = widgets.Button(description='Drive', tooltip=tooltip)
        self._button.on_click(lambda _: self.drive())
        foot = widgets.HBox([self._button, self._status])
        foot.add_class('robot-foot')
        super().__init__([widgets.HTML(_STYLE), self._picture, foot], 'robot-view')

    def drive(self) -> None:
        """Put the vehicle back to the start and let it go, as the button does."""
        raise NotImplementedError

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def _draw(self, vehicle: track.Vehicle, elapsed_sec: float) -> None:
        """Show a vehicle so many seconds after its motion began, unless the browser is at it already."""
        moment = vehicle.at(elapsed_sec)
        shown = vehicle, moment.state.word
        if shown == self._shown:
            return
        self._shown = shown
        self._text = moment.text
        if elapsed_sec < vehicle.motion.duration_sec:
            self._count += 1
            self._picture.value = track.moving(vehicle, elapsed_sec, f'robot-{self.model_id[:8]}-{self._count}')
        else:
            self._picture.value = track.still(moment)
        self._status.value = f'<div role="status">{html.escape(moment.sentence)}</div>'
        self._button.disabled = False

    def _draw_nothing(self, words: str) -> None:
        """Say why there is nothing to see."""
        self._shown = None
        self._text = words
        self._picture.value = f'<div class="robot-head">{html.escape(words)}</div>'
        self._status.value = ''
        self._button.disabled = True

    # -- recording: see ``recordable`` -------------------------------------------------------------------

    in_motion = True

    def _vehicle(self, *, driving: bool) -> track.Vehicle | None:
        """Return the vehicle as it stands, or as it begins to drive and then arrives at once; None without one."""
        raise NotImplementedError

    def snapshot(self) -> dict[str, Any]:
        """Return what a page without a kernel needs to draw it as it stands."""
        shown = self.look()
        return super().snapshot() if shown is None else {'kind': 'robot', 'node': self.node, 'look': shown}

    def look(self) -> dict[str, str] | None:
        """Return the vehicle as it stands; None if it is not there."""
        vehicle = self._vehicle(driving=False)
        if vehicle is None:
            return None
        moment = vehicle.at(vehicle.motion.duration_sec)
        return {'picture': track.still(moment), 'text': moment.text, 'sentence': moment.sentence}

    def film(self) -> dict[str, Any] | None:
        """Let the vehicle drive, and return what there is to see; it is at its goal then."""
        vehicle = self._vehicle(driving=True)
        if vehicle is None:
            return None
        # Several pictures of one page have animations of their own names.
        film = track.film(vehicle, 'robot-NAME')
        return {'picture': film.picture, 'end': film.end, 'scenes': [list(each) for each in film.scenes]}
