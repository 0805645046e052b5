"""NumberLineView: what happens to a parameter that holds a number, on a line with its range."""

import contextlib
from collections.abc import Callable
from typing import Any, TypeGuard

from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import ExecutorError
from param_tools.node.client import ParameterClient, descriptor_of, node_name
from param_tools.panel.view import FollowingView, no_op
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.views.asking import Asking
from param_tutorial.views.base import AnimatedView, name_of
from param_tutorial.views.drawing.diagram import head
from param_tutorial.views.drawing.number_line import Attempt, Scale, draw_number_line
from param_tutorial.views.set_recorder import RecordedSet, follow_sets, record_set


class NumberLineView(AnimatedView, FollowingView):
    """A parameter that holds a number, on a line with its range and steps; a rejected value springs back.

    The picture plays anew whenever somebody sets the parameter, until the view is closed; it is sent to the page only
    then, and the browser moves the rest. Show it as the last line of a cell. Below it, a reader types a value, and the
    node is asked for that; but not where the picture stays as it is.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any = ...) -> None:
        """
        :param node: The node, or its name; it has to be spun in this process, now or later.
        :param name: The parameter.
        :param value: Ask the node for this value, and show what comes of it and nothing after it; by default the view
            asks for nothing, and follows the node.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._subject, self._name = node_name(node), name
        # What is shown, and whether it is to stay.
        self._sentence, self._is_held = '', value is not ...
        self._followed: Node | None = None
        self._stop_sets: Callable[[], None] = no_op
        self._latest: RecordedSet | None = None
        self._shown: tuple[Descriptor, float, RecordedSet | None] | None = None
        super().__init__(*([] if self._is_held else [Asking(self._ask, name=name)]))
        self._begin()
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
        self._followed, self._stop_sets = None, no_op

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
            self._followed, self._stop_sets = node, no_op
            if node is not None:
                self._stop_sets = follow_sets(node, self._on_set)

    def _on_set(self, record: RecordedSet) -> None:
        if record.name == self._name:
            self._latest = record
            self._job.wake()

    def _say(self, words: str) -> None:
        """Put a sentence in the place of the picture."""
        self._text, self._shown = words, None
        self._drawn.value = f'<div class="motion">{head(self._subject, words)}</div>'

    def _show(self) -> None:
        node, record = self._followed, self._latest
        if node is None:
            self._say(f'{self._subject} is not running. It comes back here when it does.')
        elif not node.has_parameter(self._name):
            self._say(f'The node has no parameter {self._name} now.')
        elif not _is_number(stored := node.get_parameter_or(self._name).value):
            self._say(f'{self._name} is not a number.')
        else:
            shown = descriptor_of(self._name, node.describe_parameter(self._name)), stored, record
            if shown != self._shown:
                before, self._shown = self._shown, shown
                self._draw(before, *shown)

    def _draw(self, shown: tuple[Descriptor, float, RecordedSet | None] | None, descriptor: Descriptor, stored: float,
              record: RecordedSet | None) -> None:
        """Draw what the node has, and the latest set if it is new.

        :param shown: What was drawn before; None if that was no number.
        """
        before = shown[1] if shown else None
        request = None
        if record is not None and (shown is None or record is not shown[2]):
            request = Attempt(record.value if _is_number(record.value) else None, values.format_value(record.value),
                              record.objection)
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


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
