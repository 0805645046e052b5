"""The robot of BaseNode on its track, as a widget that follows it: what a reader's own driver makes it do."""

import contextlib
import html
from collections.abc import Callable
from typing import Any

import traitlets

from param_tools.errors import ExecutorError, NodeNotFoundError
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front
from param_tools.panel.view import FollowingView
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import full_name
from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.views.base import name_of
from param_tutorial.views.drawing.track import Moment, draw_track


class _Front(Front):
    """The track in the browser."""

    _esm = bundle('param_tutorial/views/track.js')
    _css = sheet('param_tutorial/views/drawing/track.css')
    markup = traitlets.Unicode(
        '<div class="robot-picture"></div><div class="robot-foot"><button type="button" class="robot-drive" '
        'title="Put the robot back, at rest" disabled>Back to the start</button>'
        '<div class="robot-says" role="status"></div></div>').tag(sync=True)
    picture = traitlets.Unicode().tag(sync=True)
    moment = traitlets.Dict().tag(sync=True)
    """What the picture shows now; empty if there is no robot."""


class TrackView(FollowingView):
    """A robot that moves as its base does, until it is closed. Show it as the last line of a cell.

    While the robot stands still, nothing is sent to the browser.
    """

    def __init__(self, base: BaseNode | str = '/base') -> None:
        """:param base: The node, or its name; it has to be spun in this process, now or later."""
        self._name = full_name(base)
        self._track: tuple[str, float] | None = None
        self._text = ''
        self._front = _Front()
        self._front.on_msg(self._on_message)
        super().__init__([self._front], 'robot-view')
        self._begin()

    def __repr__(self) -> str:
        return f'<TrackView: {self._name}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        return self._name

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def reset(self) -> None:
        """Put the robot back to the start, as the button does.

        :raises NodeNotFoundError: it is not running in this process.
        """
        executor, base = self._executor, self._find_base()
        if executor is None or base is None:
            raise NodeNotFoundError(self._name, [name_of(node) for node in executor.nodes] if executor else [])
        executor.run(base.reset, 'put the robot back to the start')

    def drive(self, limit_sec: float = 60.0) -> None:
        """Put the robot back to the start, and wait until it has driven and stands again.

        :raises NodeNotFoundError: it is not running in this process.
        :raises WaitTimeoutError: it doesn't move, or still does after the limit.
        """
        self.reset()

        def has_driven() -> bool:
            base = self._find_base()
            return base is not None and base.position_m > 0 and base.speed_mps == 0

        wait_until(has_driven, 'the robot to drive and stand', limit_sec)

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        # One that has just gone is about to be said to be gone; of one that hangs, the log tells.
        if content == {'do': 'reset'}:
            with contextlib.suppress(NodeNotFoundError, ExecutorError):
                self.reset()

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        return executor.on_graph_change(self._job.wake)

    def _find_base(self) -> BaseNode | None:
        nodes = self._executor.nodes if self._executor else ()
        return next((node for node in nodes if isinstance(node, BaseNode) and name_of(node) == self._name), None)

    def _show(self) -> float | None:
        base = self._find_base()
        with self._front.hold_sync():
            if base is None:
                self._track, self._text = None, f'{self._name} is not running. It comes back here when it does.'
                self._front.picture = f'<div class="robot-head">{html.escape(self._text)}</div>'
                self._front.moment = {}
                return None
            wall_m = float(base.get_parameter('wall_m').value)
            moment = Moment(self._name, wall_m, base.position_m, base.speed_mps, base.commanded_mps,
                            base.crash_speed_mps if base.has_crashed else None)
            if self._track != (self._name, wall_m):
                self._track = self._name, wall_m
                self._front.picture = draw_track(moment)
            self._text = moment.text
            # The same moment again is not sent.
            self._front.moment = {'css': moment.css, 'says': moment.says, 'text': moment.text,
                                  'sentence': moment.sentence, 'hasCrashed': moment.crash_speed_mps is not None}
        return self._show_period_sec
