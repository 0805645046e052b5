"""RequestsView: the same requests, sent in two ways or in two worlds."""

from collections.abc import Iterable, Mapping
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterNotDeclaredError
from param_tools.node.client import ParameterClient, SetResult
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.requests import Request, Requests


class RequestsView(PictureView):
    """Requests that are sent in two ways, or in two worlds, beside each other. Show it as the last line of a cell."""

    def __init__(self, subject: str) -> None:
        """Begin without a side.

        :param subject: What the picture is of; a parameter of that name is not named again in each request.
        """
        self._requests = Requests(subject)
        super().__init__(self._requests)

    def send(self, title: str, node: str | Node | ParameterClient,
             requests: Mapping[str, Any] | Iterable[tuple[str, Any]], *, atomically: bool = False) -> None:
        """Send requests to a node, and add a side with what came of them; the node keeps what it accepts.

        :param title: Stands above the side.
        :param node: The node, or its name.
        :param requests: Names and values; of pairs, a name may be there more than once.
        :param atomically: Whether all go as one request, in which each name is there once.
        :raises ValueError: there are two sides already, or there is no request.
        :raises InvalidValueError: no parameter can hold a value of an atomic request. A single request of that kind
            is shown as rejected.
        :raises NodeNotFoundError: there is no such node.
        """
        self._requests.require_room()
        client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        pairs = list(requests.items() if isinstance(requests, Mapping) else requests)
        before = {name: values.format_value(value) for name, value in client.get_parameters().items()}
        told = _sent_as_one(client, dict(pairs)) if atomically else [_sent(client, *pair) for pair in pairs]
        self._requests.add(title, client.node, before, told, is_one=atomically)
        self._draw()

    def add_lenient(self, title: str, node: str, has: Mapping[str, Any], requests: Iterable[tuple[str, Any]], *,
                    server: str) -> None:
        """Add a side of a world in which nothing is rejected; nothing is sent.

        :param title: Stands above the side.
        :param node: The node that gets the values in the end.
        :param has: What is kept at first.
        :param requests: Names and values.
        :param server: Who keeps the values for the node.
        :raises ValueError: there are two sides already, or there is no request.
        """
        told = [Request(name, shown, shown) for name, shown in
                ((name, values.format_value(value)) for name, value in requests)]
        self._requests.add(title, node, {name: values.format_value(value) for name, value in has.items()}, told,
                           server=server)
        self._draw()

    def conclude(self, note: str) -> None:
        """Say below the last side what it comes to.

        :raises ValueError: there is no side yet.
        """
        self._requests.conclude(note)
        self._draw()


def _sent(client: ParameterClient, name: str, value: Any) -> Request:
    try:
        objection = _objection(client.set_parameter(name, value))
    except InvalidValueError:
        # It fits no message, so it never leaves.
        objection = 'no type for it'
    return Request(name, values.format_value(value), _stored(client, name), objection)


def _sent_as_one(client: ParameterClient, wanted: Mapping[str, Any]) -> list[Request]:
    results = client.set_parameters_atomically(dict(wanted))
    return [Request(each.name, values.format_value(each.value), _stored(client, each.name), _objection(each))
            for each in results]


def _objection(result: SetResult) -> str:
    return '' if result.successful else result.kind


def _stored(client: ParameterClient, name: str) -> str:
    """Return what the node has, as text, or a word in its place."""
    try:
        return values.format_value(client.get_parameter(name))
    except ParameterNotDeclaredError:
        return 'nothing'
