"""PlaneView: which pairs of two parameters' values a node takes."""

import itertools
from collections.abc import Iterable, Mapping

from rclpy.node import Node

from param_tools.node.client import ParameterClient
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.plane import Point, Way, draw_plane


class PlaneView(PictureView):
    """Which pairs of values a node takes, and how requests get from one to another. Show it as the last line of a cell.

    The node is asked for each pair, and then has again what it had before.
    """

    def __init__(self, node: str | Node | ParameterClient, values: Mapping[str, Iterable[float]]) -> None:
        """
        :param node: The node, or its name.
        :param values: Two parameters by name, to the right and upward, and the values to ask for.
        :raises NodeNotFoundError: there is no such node.
        """
        self._client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        self._names = list(values)
        before = self._pair()
        right, up = values.values()
        answers = {pair: self._ask(dict(zip(self._names, pair, strict=True))) for pair in itertools.product(right, up)}
        self._ask(dict(zip(self._names, before, strict=True)))
        self._answers, self._ways = answers, list[Way]()
        super().__init__(draw_plane(self._names, answers, []))

    def go(self, name: str, start: Mapping[str, float], *requests: Mapping[str, float]) -> None:
        """Bring the node to a pair, and send it requests; the picture plays the way that they go.

        :param name: What the way is called.
        :param start: Both values with which it begins.
        :param requests: Each is one atomic change of one value or both.
        :raises ValueError: the node does not take the start.
        """
        before = self._pair()
        if not self._ask(start):
            raise ValueError(f'the node does not take the start {dict(start)}')
        begin, steps = self._pair(), []
        for request in requests:
            has = dict(zip(self._names, self._pair(), strict=True))
            wanted = tuple(request.get(each, has[each]) for each in self._names)
            self._ask(request)
            words = ', '.join(f'{each} = {value:g}' for each, value in request.items())
            steps.append((words, (wanted[0], wanted[1]), self._pair()))
        self._ask(dict(zip(self._names, before, strict=True)))
        self._ways.append(Way(name, begin, steps))
        self._replace(draw_plane(self._names, self._answers, self._ways))

    def _ask(self, request: Mapping[str, float]) -> bool:
        return all(result.successful for result in self._client.set_parameters_atomically(dict(request)))

    def _pair(self) -> Point:
        has = self._client.get_parameters(self._names)
        return has[self._names[0]], has[self._names[1]]
