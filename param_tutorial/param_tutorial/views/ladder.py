"""LadderView: a set of a parameter as a value that climbs the ladder of callbacks."""

from typing import Any

from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.views.base import SetView
from param_tutorial.views.drawing.ladder import Climb
from param_tutorial.views.set_recorder import RecordedSet


class LadderView(SetView):
    """A value that climbs the ladder of callbacks, or falls from it, whenever somebody sets a parameter of a node.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str | None = None, value: Any = ..., *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: The node, or its name; it has to be spun in this process, now or later.
        :param name: Only this parameter; by default whichever is set.
        :param value: Ask the node for this value, and show what comes of it and nothing after it; by default the view
            asks for nothing, and follows the node.
        :param executor: Spins it; by default the one that runs in the background, also after a stop and a new start.
        :raises NodeNotFoundError: a value is given, and the node is not running in this process.
        """
        self._name = name
        self._shown: object = self
        super().__init__(node, executor)
        if name is not None and value is not ...:
            self._hold(_climb(self._ask(name, value)).sentence)

    def _wants(self, record: RecordedSet) -> bool:
        return self._name in (None, record.timeline.name)

    def _show(self) -> None:
        is_there, record = self._followed is not None, self._latest
        shown = is_there if record is None else record
        if shown is self._shown:
            return
        self._shown = shown
        if record is not None:
            self._play(_climb(record))
        elif is_there:
            self._say(f'Set {self._name or "a parameter"}, and see how far the value climbs.')
        else:
            self._say('This node is not running in this process. The picture follows it when it does.')


def _climb(record: RecordedSet) -> Climb:
    return Climb(record.timeline.node, record.timeline.name, record.timeline.steps, record.objection)
