"""NumberLineView: what happens to a parameter that holds a number, on a line with its range."""

from typing import Any, TypeGuard

from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.client import ParameterClient
from param_tools.node.live import LiveParameters
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tutorial.views.base import SetView
from param_tutorial.views.drawing.number_line import NumberLine, Request, Scale
from param_tutorial.views.set_recorder import RecordedSet


class NumberLineView(SetView):
    """A parameter that holds a number, on a line with its range and steps; a rejected value springs back.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any = ..., *,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC) -> None:
        """
        :param node: The node, or its name. What it rejects is seen only if it is spun in this process.
        :param name: The parameter.
        :param value: As for LadderView.
        :param executor: As for LadderView.
        :param timeout_sec: How long the node may take for each answer.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._name = name
        self._sentence = ''
        self._live: LiveParameters | None = None
        self._shown: tuple[Descriptor, float, RecordedSet | None] | None = None
        super().__init__(node, executor)
        self._live = LiveParameters(self._subject, self._job.wake, names=[name], executor=executor,
                                    timeout_sec=timeout_sec)
        self._live.first_look()
        self._job.call_now(1.0)
        if value is not ...:
            self._ask(name, value)
            self._job.call_now(1.0)
            self._hold(self._sentence)

    def __repr__(self) -> str:
        shown = self._held or f'{self._name} of {self._subject}'
        return f'<NumberLineView: {shown}{", closed" if self._closed else ""}>'

    def settle(self, timeout_sec: float = 10.0) -> None:
        """Wait until the view shows what the node has now.

        :raises WaitTimeoutError: it took too long.
        """
        if self._live is not None:
            self._live.settle(timeout_sec)
        self._job.call_now(timeout_sec)

    def _wants(self, record: RecordedSet) -> bool:
        return record.timeline.name == self._name

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
        line = NumberLine(self._subject, self._name, scale, stored, before=before, request=request,
                          is_locked=descriptor.read_only)
        self._sentence = line.sentence
        self._play(line)

    def _stop(self) -> None:
        super()._stop()
        if self._live is not None:
            self._live.close()


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
