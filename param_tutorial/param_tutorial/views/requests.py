"""RequestsView: the same requests, sent in two ways or in two worlds."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterNotDeclaredError
from param_tools.node.client import ParameterClient, SetResult
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.requests import SentValue, Side, draw_requests
from param_tutorial.views.handle import Ordering


@dataclass
class _Way:
    """What it takes to send the requests of a side again."""

    title: str
    client: ParameterClient
    before: Mapping[str, Any]
    """What the node had at first."""
    pairs: list[tuple[str, Any]]
    is_one: bool
    note: Callable[[], str] = lambda: ''

    def bring_back(self) -> None:
        """Give the node what it had at first."""
        now = self.client.get_parameters()
        if changed := {name: value for name, value in self.before.items() if now.get(name) != value}:
            self.client.set_parameters_atomically(changed)

    def send(self) -> Side:
        """Send the requests, and return what came of them."""
        sent = _sent_as_one(self.client, dict(self.pairs)) if self.is_one \
            else [_sent(self.client, *pair) for pair in self.pairs]
        return Side(self.title, self.client.node, _formatted(self.before), sent, is_one=self.is_one, note=self.note())


class RequestsView(PictureView):
    """Requests that are sent in two ways, or in two worlds, beside each other. Show it as the last line of a cell.

    Below it, a reader puts the requests into another order, in which they are sent again, on both sides; but not where
    a side has sent nothing, or one name twice.
    """

    def __init__(self, subject: str) -> None:
        """Begin without a side.

        :param subject: What the picture is of; a parameter of that name is not named again in each request.
        """
        self._sides: list[Side] = []
        self._ways: list[_Way] = []
        self._ordering = Ordering(self._send_again)
        super().__init__(draw_requests(subject, []), self._ordering)

    def send(self, title: str, node: str | Node | ParameterClient,
             requests: Mapping[str, Any] | Iterable[tuple[str, Any]], *, atomically: bool = False) -> None:
        """Send requests to a node, and add a side with what came of them; the node keeps what it accepts.

        There is room for two sides.

        :param title: Stands above the side.
        :param node: The node, or its name.
        :param requests: Names and values; of pairs, a name may be there more than once.
        :param atomically: Whether all go as one request, in which each name is there once.
        :raises InvalidValueError: no parameter can hold a value of an atomic request. A single request of that kind
            is shown as rejected.
        :raises NodeNotFoundError: there is no such node.
        """
        client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        pairs = list(requests.items() if isinstance(requests, Mapping) else requests)
        self._ways.append(_Way(title, client, client.get_parameters(), pairs, atomically))
        self._add(self._ways[-1].send())

    def add_lenient(self, title: str, node: str, has: Mapping[str, Any], requests: Iterable[tuple[str, Any]], *,
                    server: str) -> None:
        """Add a side of a world in which nothing is rejected; nothing is sent.

        :param title: Stands above the side.
        :param node: The node that gets the values in the end.
        :param has: What is kept at first.
        :param requests: Names and values.
        :param server: Who keeps the values for the node.
        """
        sent = [SentValue(name, shown, shown) for name, shown in
                ((name, values.format_value(value)) for name, value in requests)]
        self._add(Side(title, node, _formatted(has), sent, server=server))

    def conclude(self, note: str | Callable[[], str]) -> None:
        """Say below the last side what it comes to.

        :param note: The words, or what returns them: it is asked again when the requests are sent again.
        """
        tell = note if callable(note) else lambda: note
        self._sides[-1].note = tell()
        if self._ways:
            self._ways[-1].note = tell
        self._draw_sides()

    def _add(self, side: Side) -> None:
        self._sides.append(side)
        self._draw_sides()
        has_order = len(self._ways) == len(self._sides) and all(len(dict(each.pairs)) == len(each.pairs)
                                                                for each in self._ways)
        names = dict.fromkeys(name for each in self._ways for name, _ in each.pairs)
        self._ordering.items = list(names) if has_order else []

    def _draw_sides(self) -> str:
        return self._replace(draw_requests(self.node, self._sides))

    def _send_again(self, order: list[str]) -> str:
        """Send the requests of all sides in another order, each to a node that has what it had at first."""
        sides = []
        for way in self._ways:
            way.bring_back()
            way.pairs.sort(key=lambda pair: order.index(pair[0]))
            sides.append(way.send())
        self._sides = sides
        return self._draw_sides()


def _formatted(has: Mapping[str, Any]) -> dict[str, str]:
    return {name: values.format_value(value) for name, value in has.items()}


def _sent(client: ParameterClient, name: str, value: Any) -> SentValue:
    try:
        objection = _objection(client.set_parameter(name, value))
    except InvalidValueError:
        # It fits no message, so it never leaves.
        objection = 'no type for it'
    return SentValue(name, values.format_value(value), _stored(client, name), objection)


def _sent_as_one(client: ParameterClient, wanted: Mapping[str, Any]) -> list[SentValue]:
    results = client.set_parameters_atomically(dict(wanted))
    return [SentValue(each.name, values.format_value(each.value), _stored(client, each.name), _objection(each))
            for each in results]


def _objection(result: SetResult) -> str:
    return '' if result.successful else result.kind


def _stored(client: ParameterClient, name: str) -> str:
    """Return what the node has, as text, or a word in its place."""
    try:
        return values.format_value(client.get_parameter(name))
    except ParameterNotDeclaredError:
        return 'nothing'
