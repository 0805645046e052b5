"""DeclarationsView: a node's parameters as they come to be."""

from collections.abc import Mapping
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tools.node.declarations import record_declarations
from param_tutorial.views.drawing.trail import Move
from param_tutorial.views.trail import TrailView


class DeclarationsView(TrailView):
    """A node's parameters as they come to be, with what comes from outside. Show it as the last line of a cell."""

    _OUTSIDE, _DECLARED, _HAS = 'from outside', 'declare_parameter', 'the node has'

    def __init__(self, node_class: type[Node], overrides: Mapping[str, Any] | None = None) -> None:
        """Start a node on the stage, and record what it declares.

        :param node_class: As for ``ros.add()``; its constructor takes no arguments.
        :param overrides: Values from outside, by name, as after ``-p``.
        :raises ExecutorError: no executor is running, or node_class is not a class of nodes.
        """
        overrides = overrides or {}
        node, declarations = record_declarations(node_class, overrides)
        self._client = ParameterClient(node)
        super().__init__(self._client.node, (self._OUTSIDE, self._DECLARED, self._HAS))
        for each in declarations:
            moves = [] if each.value is None else [
                Move(self._OUTSIDE if each.name in overrides else self._DECLARED, self._HAS)]
            self._add(each.name, (_or_nothing(overrides.get(each.name)), _or_nothing(each.default),
                                 _or_nothing(each.value)), *moves,
                     note='an override' if each.name in overrides else '')
        declared = {each.name for each in declarations}
        for name in (each for each in overrides if each not in declared):
            asked = values.format_value(overrides[name])
            self._add(name, (asked, ..., ...), Move(self._OUTSIDE, self._HAS, asked, 'ignored'),
                     note='an override, never declared')

    def set_parameter(self, name: str, value: Any) -> None:
        """Set a parameter of the node from outside, and add what comes of it.

        :raises NodeNotFoundError: the node has been removed.
        """
        result, asked = self._client.set_parameter(name, value), values.format_value(value)
        if result.successful:
            stored = values.format_value(self._client.get_parameter(name))
            self._add(f'set {name}', (asked, ..., stored), Move(self._OUTSIDE, self._HAS))
        else:
            self._add(f'set {name}', (asked, ..., ...), Move(self._OUTSIDE, self._HAS, asked, 'rejected'),
                     note=result.kind)


def _or_nothing(value: Any) -> Any:
    return ... if value is None else values.format_value(value)
