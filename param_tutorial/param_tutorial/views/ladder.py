"""LadderView: a set of a parameter as a value that climbs down the ladder of callbacks."""

from typing import Any

from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.ladder import Climb
from param_tutorial.views.set_recorder import record_set


class LadderView(PictureView):
    """A value that climbs down the ladder of callbacks, or back from it. Show it as the last line of a cell."""

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any) -> None:
        """Ask a node for a value, and show what comes of it.

        :param node: The node, or its name; it has to be spun in this process.
        :param name: The parameter.
        :raises NodeNotFoundError: the node is not running in this process.
        :raises InvalidValueError: no parameter can hold this value.
        """
        record = record_set(node, name, value)
        super().__init__(Climb(record.timeline.node, name, record.timeline.steps, record.objection))
