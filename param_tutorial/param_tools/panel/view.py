"""What the live views have in common: they follow something until they are closed, and are closed with their cell."""

import threading
from collections.abc import Callable, Iterable
from typing import Any

import ipywidgets as widgets

from param_tools.errors import ExecutorError
from param_tools.node.live import FIRST_LOOK_TIMEOUT_SEC, LiveParameters
from param_tools.panel.close_with_cell import close_looks, close_with_cell
from param_tools.panel.front import Front, answer_beside_cells
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.listeners import Listeners
from param_tools.ros.schedule import Job


def no_op() -> None:
    """Do nothing. Stands in for an unsubscribe function before anything is subscribed."""


class View(widgets.VBox):
    """A box of widgets that follows something as long as it is not closed."""

    children: tuple[widgets.Widget, ...]
    """The widgets in the box; a trait of ipywidgets."""
    # Until it is built: ipywidgets closes even a widget whose constructor has raised an exception.
    _closed = True

    def __init__(self, parts: Iterable[widgets.Widget], css_class: str):
        self._closed = False
        # Held by the thread that writes to the widgets.
        self._drawing = threading.RLock()
        self._on_close: Listeners[[View]] = Listeners()
        super().__init__(list(parts))
        self.add_class(css_class)
        for widget in (self, *_all_within(self)):
            answer_beside_cells(widget)
            if isinstance(widget, Front):
                widget.drawing = self._drawing

    @property
    def node(self) -> str:
        """The fully qualified name of the node that it shows, or what it says in the place of one."""
        raise NotImplementedError

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """Be shown by the cell that runs, as ipywidgets has it, and stay as long as that cell shows the view."""
        close_with_cell(self)
        return super()._repr_mimebundle_(**options)

    def on_close(self, listener: Callable[['View'], object]) -> Callable[[], None]:
        """Call a listener with the view when it is about to be closed.

        :return: Call it to stop listening.
        """
        return self._on_close.add(listener)

    def close(self) -> None:
        """Stop following, and remove the view from the page. Safe to call more than once."""
        if self._closed:
            return
        self._on_close.call(self)
        with self._drawing:
            self._closed = True
            self._end()
            parts = _all_within(self)
            # Emptied first: a browser cannot take a widget out of a box that is gone, and says so.
            for box in (self, *parts):
                if isinstance(box, widgets.Box):
                    box.children = ()
            super().close()
            close_looks(self)
            for part in parts:
                part.close()
                close_looks(part)

    def _end(self) -> None:
        """Stop following."""
        raise NotImplementedError


def _all_within(box: widgets.Box) -> list[widgets.Widget]:
    parts = []
    for each in box.children:
        parts += [each, *(_all_within(each) if isinstance(each, widgets.Box) else ())]
    return parts


class ParameterView(View):
    """A view of the parameters of one node. A constructor sets ``_live`` first, and calls ``_begin`` last."""

    _live: LiveParameters

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self.node}{", closed" if self._closed else ""}>'

    def _begin(self, patience_sec: float = FIRST_LOOK_TIMEOUT_SEC) -> None:
        """Follow the node, show what it has, and close with the cell.

        :param patience_sec: How long to wait for the first answers; later ones are shown when they come.
        """
        self._live.first_look(patience_sec)
        close_with_cell(self)

    @property
    def node(self) -> str:
        """The fully qualified name of the node."""
        return self._live.node

    def settle(self, timeout_sec: float = 10.0) -> None:
        """Wait until the node has answered every change made so far and the view shows what the node has now.

        :raises WaitTimeoutError: it took too long; the message names the parameters.
        """
        self._live.settle(timeout_sec)

    def _end(self) -> None:
        self._live.close()


class FollowingView(View):
    """A view that listens to the executor in the background until it is closed. A constructor calls ``_begin`` last."""

    # What happens more often than this is shown once: nobody could follow it.
    _show_period_sec = 0.1

    def _begin(self) -> None:
        """Listen, show what there is to show, and close with the cell."""
        self._executor: BackgroundExecutor | None = None
        self._stop_listening: Callable[[], object] = no_op
        self._job = Job(self._step, self._show_period_sec, self._drawing)
        self._stop_following = stage.on_change(self._on_executor_change)
        self._listen()
        self._job.call_now(1.0)
        close_with_cell(self)

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], object]:
        """Wake the job whenever there is something to show.

        :return: Ends that.
        """
        raise NotImplementedError

    def _lose(self) -> None:
        """Take note that there is no executor any more; what was shown before stays."""

    def _show(self) -> float | None:
        """Draw what there is to show; called with the lock held, in any thread.

        :return: In how many seconds to draw again, even if nothing happens; None if only what happens counts.
        """
        raise NotImplementedError

    def _step(self) -> float | None:
        return None if self._closed else self._show()

    def _stop(self) -> None:
        """Stop following; what is shown stays."""
        self._stop_following()
        self._stop_listening()

    def _end(self) -> None:
        self._stop()
        self._job.end()

    def _on_executor_change(self) -> None:
        self._listen()
        self._job.wake()

    def _listen(self) -> None:
        self._stop_listening()
        self._stop_listening = no_op
        try:
            self._executor = stage.current()
        except ExecutorError:
            self._executor = None
            self._lose()
        else:
            self._stop_listening = self._subscribe(self._executor)
