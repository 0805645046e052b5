"""NumberLineView: what happens to a parameter that holds a number, on a line with its range."""

import contextlib
from collections.abc import Callable
from typing import Any, TypeGuard

from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import ExecutorError
from param_tools.node.client import ParameterClient, node_name
from param_tools.node.live import LiveParameters
from param_tools.panel.view import FollowingView, nothing
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.views.base import AnimatedView, name_of
from param_tutorial.views.drawing.diagram import head
from param_tutorial.views.drawing.number_line import Request, Scale, draw_number_line
from param_tutorial.views.handle import Asking
from param_tutorial.views.set_recorder import RecordedSet, follow_sets, record_set


class NumberLineView(AnimatedView, FollowingView):
    """A parameter that holds a number, on a line with its range and steps; a rejected value springs back.

    The picture plays anew whenever something happens, until the view is closed; it is sent to the page only then, and
    the browser moves the rest. Show it as the last line of a cell. Below it, a reader types a value, and the node is
    asked for that; but not where the picture stays as it is.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any = ...) -> None:
        """
        :param node: The node, or its name. What it rejects is seen only if it is spun in this process.
        :param name: The parameter.
        :param value: Ask the node for this value, and show what comes of it and nothing after it; by default the view
            asks for nothing, and follows the node.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._subject, self._name = node_name(node), name
        # What is shown, and whether it is to stay.
        self._sentence, self._is_held = '', value is not ...
        self._followed: Node | None = None
        self._stop_sets: Callable[[], None] = nothing
        self._latest: RecordedSet | None = None
        self._live: LiveParameters | None = None
        self._shown: tuple[Descriptor, float, RecordedSet | None] | None = None
        super().__init__(*([] if self._is_held else [Asking(self._ask, name=name)]))
        self._begin()
        self._live = LiveParameters(self._subject, self._job.wake, names=[name])
        self._live.first_look()
        self._job.call_now(1.0)
        if self._is_held:
            record_set(node, name, value)
            self._job.call_now(1.0)
            self._job.end()
            self._stop()

    def __repr__(self) -> str:
        shown = self._sentence if self._is_held else f'{self._name} of {self._subject}'
        return f'<NumberLineView: {shown}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        return self._subject

    def _ask(self, value: Any) -> str:
        record = record_set(self._subject, self._name, value)  # which the view follows
        if record.objection:
            return f'{self._name} = {values.format_value(value)} is rejected: {record.objection}'
        return f'{self._name} = {values.format_value(record.stored)} is stored.'

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
                self._stop_sets = follow_sets(node, self._on_set)

    def _on_set(self, record: RecordedSet) -> None:
        if record.timeline.name == self._name:
            self._latest = record
            self._job.wake()

    def _say(self, words: str) -> None:
        """Put a sentence in the place of the picture."""
        self._text = words
        self._drawn.value = f'<div class="motion">{head(self._subject, words)}</div>'

    def _show(self) -> None:
        node, record = self._followed, self._latest
        if self._live is None:
            return
        parameter = self._live.parameters.get(self._name)
        if self._live.status or parameter is None:
            self._shown = None
            self._say(self._live.status or f'The node has no parameter {self._name} now.')
            return
        # What the node itself says is never older than the events.
        stored = parameter.value if node is None or not node.has_parameter(self._name) \
            else node.get_parameter_or(self._name).value
        descriptor = parameter.descriptor
        if not _is_number(stored):
            self._shown = None
            self._say(f'{self._name} is not a number.')
            return
        shown = descriptor, stored, record
        if shown == self._shown:
            return
        before = None if self._shown is None else self._shown[1]
        is_new = record is not None and (self._shown is None or record is not self._shown[2])
        self._shown = shown
        request = None
        if record is not None and is_new:
            request = Request(record.value if _is_number(record.value) else None, values.format_value(record.value),
                              record.objection)
        elif before is not None and before != stored:
            request = Request(stored, values.format_value(stored))
        asked = None if request is None else request.value
        scale = Scale.around(*(each for each in (stored, before, asked) if each is not None))
        if descriptor.range:
            scale = Scale(descriptor.range.from_value, descriptor.range.to_value, descriptor.range.step)
        line = draw_number_line(self._subject, self._name, scale, stored, before=before, request=request,
                                is_locked=descriptor.read_only)
        self._sentence = line.sentence
        self._play(line)

    def _stop(self) -> None:
        super()._stop()
        self._stop_sets()
        if self._live is not None:
            self._live.close()


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
