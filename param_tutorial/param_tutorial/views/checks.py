"""ChecksView: requests on their way through the checks of a node."""

from collections.abc import Iterable
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.checks import draw_checks


class ChecksView(PictureView):
    """Requests on their way through a node's checks, to the one that stops them. Show it as the last line of a cell.

    The node is asked once for each, and keeps what it accepts.
    """

    def __init__(self, node: str | Node | ParameterClient, requests: Iterable[tuple[str, Any]]) -> None:
        """
        :param node: The node, or its name.
        :param requests: Names and values, one request for each; None deletes a parameter.
        :raises InvalidValueError: no parameter can hold a value.
        :raises NodeNotFoundError: there is no such node.
        """
        client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        super().__init__(draw_checks(client.node, [
            (name, values.format_value(value), client.set_parameter(name, value).kind) for name, value in requests]))
