"""LadderView: a set of a parameter as a value that climbs down the ladder of callbacks."""

from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tutorial.views.asking import Asking
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.diagram import Diagram
from param_tutorial.views.drawing.ladder import draw_ladder
from param_tutorial.views.set_recorder import record_set


class LadderView(PictureView):
    """A value that climbs down the ladder of callbacks, or back from it. Show it as the last line of a cell.

    Below it, a reader types another value, and the node is asked for that.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any) -> None:
        """Ask a node for a value, and show what comes of it.

        :param node: The node, or its name; it has to be spun in this process.
        :param name: The parameter.
        :raises NodeNotFoundError: the node is not running in this process.
        :raises InvalidValueError: no parameter can hold this value.
        """
        self._name = name
        super().__init__(self._climb(node, value), Asking(self._ask, name=name, text=values.format_value(value)))

    def _climb(self, node: str | Node | ParameterClient, value: Any) -> Diagram:
        record = record_set(node, self._name, value)
        return draw_ladder(record.node, self._name, record.steps, record.objection)

    def _ask(self, value: Any) -> str:
        self._replace(self._climb(self.node, value))
        return self._picture.sentence
