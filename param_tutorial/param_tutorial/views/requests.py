"""RequestsView: the same requests, sent in two ways or in two worlds."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterNotDeclaredError
from param_tools.node.client import ParameterClient, SetResult
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.requests import Request, Requests
from param_tutorial.views.handle import Ordering


@dataclass
class _Side:
    """What it takes to send the requests of a side again."""

    title: str
    client: ParameterClient
    before: Mapping[str, Any]
    """What the node had at first."""
    pairs: list[tuple[str, Any]]
    is_one: bool
    note: Callable[[], str] | None = None

    def bring_back(self) -> None:
        """Give the node what it had at first."""
        now = self.client.get_parameters()
        if changed := {name: value for name, value in self.before.items() if now.get(name) != value}:
            self.client.set_parameters_atomically(changed)

    def send(self, requests: Requests) -> None:
        """Send the requests, and add what came of them to a picture."""
        told = _sent_as_one(self.client, dict(self.pairs)) if self.is_one \
            else [_sent(self.client, *pair) for pair in self.pairs]
        before = {name: values.format_value(value) for name, value in self.before.items()}
        requests.add(self.title, self.client.node, before, told, is_one=self.is_one)
        if self.note is not None:
            requests.conclude(self.note())


class RequestsView(PictureView):
    """Requests that are sent in two ways, or in two worlds, beside each other. Show it as the last line of a cell.

    Below it, a reader puts the requests into another order, in which they are sent again, on both sides; but not where
    a side has sent nothing, or one name twice.
    """

    def __init__(self, subject: str) -> None:
        """Begin without a side.

        :param subject: What the picture is of; a parameter of that name is not named again in each request.
        """
        self._requests = Requests(subject)
        self._sides: list[_Side] = []
        self._has_order = True
        self._ordering = Ordering(self._send_again)
        super().__init__(self._requests, self._ordering)

    def send(self, title: str, node: str | Node | ParameterClient,
             requests: Mapping[str, Any] | Iterable[tuple[str, Any]], *, atomically: bool = False) -> None:
        """Send requests to a node, and add a side with what came of them; the node keeps what it accepts.

        :param title: Stands above the side.
        :param node: The node, or its name.
        :param requests: Names and values; of pairs, a name may be there more than once.
        :param atomically: Whether all go as one request, in which each name is there once.
        :raises ValueError: there are two sides already.
        :raises InvalidValueError: no parameter can hold a value of an atomic request. A single request of that kind
            is shown as rejected.
        :raises NodeNotFoundError: there is no such node.
        """
        self._requests.require_room()
        client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        pairs = list(requests.items() if isinstance(requests, Mapping) else requests)
        side = _Side(title, client, client.get_parameters(), pairs, atomically)
        side.send(self._requests)
        self._sides.append(side)
        self._has_order &= len(dict(pairs)) == len(pairs)
        self._draw()
        self._offer_order()

    def add_lenient(self, title: str, node: str, has: Mapping[str, Any], requests: Iterable[tuple[str, Any]], *,
                    server: str) -> None:
        """Add a side of a world in which nothing is rejected; nothing is sent.

        :param title: Stands above the side.
        :param node: The node that gets the values in the end.
        :param has: What is kept at first.
        :param requests: Names and values.
        :param server: Who keeps the values for the node.
        :raises ValueError: there are two sides already.
        """
        told = [Request(name, shown, shown) for name, shown in
                ((name, values.format_value(value)) for name, value in requests)]
        self._requests.add(title, node, {name: values.format_value(value) for name, value in has.items()}, told,
                           server=server)
        self._has_order = False
        self._draw()
        self._offer_order()

    def conclude(self, note: str | Callable[[], str]) -> None:
        """Say below the last side what it comes to.

        :param note: The words, or what returns them: it is asked again when the requests are sent again.
        """
        tell = note if callable(note) else lambda: note
        self._requests.conclude(tell())
        if self._sides:
            self._sides[-1].note = tell
        self._draw()

    def _offer_order(self) -> None:
        names = dict.fromkeys(name for side in self._sides for name, _ in side.pairs)
        self._ordering.items = list(names) if self._has_order else []

    def _send_again(self, order: list[str]) -> str:
        """Send the requests of all sides in another order, each to a node that has what it had at first."""
        requests = Requests(self._requests.subject)
        for side in self._sides:
            side.bring_back()
            side.pairs.sort(key=lambda pair: order.index(pair[0]))
            side.send(requests)
        self._requests = requests
        return self._replace(requests)


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
