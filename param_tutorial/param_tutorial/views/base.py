"""What the views of animated pictures have in common: what is played, and when."""

import contextlib
from collections.abc import Callable
from typing import Any

import ipywidgets as widgets
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node

from param_tools.errors import CallbackError, ExecutorError, NodeNotFoundError
from param_tools.markup.styles import style
from param_tools.node.client import ParameterClient, node_name
from param_tools.panel.close_with_cell import close_with_cell
from param_tools.panel.view import FollowingView, View, nothing
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.views.drawing import svg
from param_tutorial.views.set_recorder import RecordedSet, follow_sets

_STYLE = svg.STYLE + style('param_tutorial/views/base.css')


class AnimatedView(View):
    """A picture that plays when it is put onto the page."""

    def __init__(self) -> None:
        self._text = ''
        self._count = 0
        self._drawn = widgets.HTML()
        super().__init__([widgets.HTML(_STYLE), self._drawn], 'motion-view')

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def _play(self, picture: svg.AnimatedPicture, *, is_still: bool = False) -> None:
        """Put a picture onto the page in the place of the one before.

        :param is_still: Whether everything in it stands as it does at the end.
        """
        self._text = picture.text
        self._count += 1
        # The animations of several pictures on one page need different names.
        self._drawn.value = picture.html(
            svg.Animation(f'motion-{self.model_id[:8]}-{self._count}', is_still=is_still))


class PictureView(AnimatedView):
    """A picture of what was measured before. It follows nothing, and plays anew when something is added to it."""

    def __init__(self, picture: svg.AnimatedPicture) -> None:
        self._picture = picture
        super().__init__()
        self._draw()
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self._picture.sentence}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        """What the view is of; no node is asked."""
        return self._picture.subject

    def _draw(self) -> None:
        with self._drawing:
            if not self._closed:
                self._play(self._picture)

    def _end(self) -> None:
        pass


class LivePictureView(AnimatedView, FollowingView):
    """A picture of something live: it plays anew whenever something happens, until it is closed.

    A picture is sent to the page only when something has happened; the browser moves the rest.
    """

    def __init__(self, subject: str, executor: BackgroundExecutor | None) -> None:
        """
        :param subject: The node, or what the view is of in the place of one.
        :param executor: None for whichever runs in the background, also after a stop and a new start.
        """
        self._subject = subject
        # What is shown, if it is to stay.
        self._held = ''
        super().__init__()
        self._begin(executor)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self._held or self._subject}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        """The fully qualified name of the node, or what it says in the place of one."""
        return self._subject

    def snapshot(self) -> dict[str, object]:
        """Return what a page without a kernel needs: the picture plays there once, and again when it is told to."""
        self._job.call_now(1.0)
        return super().snapshot()

    def _say(self, words: str) -> None:
        """Put a sentence in the place of the picture."""
        self._text = words
        self._drawn.value = f'<div class="motion">{svg.head(self._subject, words)}</div>'

    def _step(self) -> float | None:
        with self._drawing:
            return None if self._held else super()._step()

    def _hold(self, sentence: str) -> None:
        """Let the picture stay as it is from now on, whatever happens.

        :param sentence: What it shows.
        """
        self._job.call_now(1.0)
        with self._drawing:
            self._held = sentence
        self._stop()


class SetView(LivePictureView):
    """A picture that plays each set of one node's parameters, also one that the node rejects."""

    def __init__(self, node: str | Node | ParameterClient, executor: BackgroundExecutor | None) -> None:
        """
        :param node: The node, or its name; it has to be spun in this process, now or later.
        :param executor: As for LivePictureView.
        """
        self._followed: Node | None = None
        self._stop_sets: Callable[[], None] = nothing
        self._latest: RecordedSet | None = None
        super().__init__(node_name(node), executor)

    def _wants(self, record: RecordedSet) -> bool:
        """True if a set is to be shown."""
        raise NotImplementedError

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        stop_listening = executor.on_graph_change(self._on_graph_change)
        with contextlib.suppress(ExecutorError):
            executor.run(self._follow, f'follow {self._subject}')
        return stop_listening

    def _lose(self) -> None:
        self._followed, self._stop_sets = None, nothing

    def _on_graph_change(self) -> None:
        self._follow()
        self._job.wake()

    def _follow(self) -> None:
        """Follow the node that has the name now: in the executor's thread, so that no set of a new node is missed."""
        executor = self._executor
        if self._closed or executor is None:
            return
        node = next((each for each in executor.nodes if name_of(each) == self._subject), None)
        if node is not self._followed:
            self._stop_sets()
            self._followed, self._stop_sets = node, nothing
            if node is not None:
                self._stop_sets = follow_sets(node, self._on_set, executor=executor)

    def _on_set(self, record: RecordedSet) -> None:
        if self._wants(record):
            self._latest = record
            self._job.wake()

    def _ask(self, name: str, value: Any) -> RecordedSet:
        """Ask the node for a value, and return what came of it.

        :raises NodeNotFoundError: it is not running in this process.
        :raises InvalidValueError: no parameter can hold this value.
        """
        if self._followed is None:
            raise NodeNotFoundError(self._subject, [name_of(each) for each in self._executor.nodes]
                                    if self._executor is not None else [])
        self._latest = None
        with contextlib.suppress(CallbackError):
            ParameterClient(self._subject, executor=self._executor).set_parameter(name, value)
        record: RecordedSet | None = self._latest
        if record is None:
            raise ExecutorError(f'{self._subject} has answered, and nobody has asked it for {name}')
        return record

    def _stop(self) -> None:
        super()._stop()
        self._stop_sets()


def name_of(node: Node) -> str:
    """Return the fully qualified name of a node; empty if the node has been destroyed."""
    try:
        return str(node.get_fully_qualified_name())
    except InvalidHandle:
        return ''
