"""WorldsView: who keeps a parameter's values, and what is left of them when a node is killed."""

from collections.abc import Mapping
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.worlds import World, draw_worlds


class WorldsView(PictureView):
    """Who keeps a parameter's values in one world and in another. Show it as the last line of a cell."""

    def __init__(self, name: str) -> None:
        """Begin without a world.

        :param name: The parameter.
        """
        self._worlds: list[World] = []
        super().__init__(draw_worlds(name, []))

    def add(self, title: str, values: Mapping[str, Any], *, killed: str, successor: Any, server: str = '') -> None:
        """Add a world, of which there is room for two; the picture plays anew with it.

        :param values: What each node has set the parameter to, as it was measured.
        :param killed: The node that is killed and started again.
        :param successor: What the new node of that name begins with.
        :param server: Who keeps the values of all nodes, which is then only one; empty if each node keeps its own.
        """
        self._worlds.append(World(title, {node: str(value) for node, value in values.items()}, killed, str(successor),
                                  server))
        self._replace(draw_worlds(self.node, self._worlds))
