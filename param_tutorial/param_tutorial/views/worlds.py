"""WorldsView: who keeps a parameter's values, and what is left of them when a node is killed."""

from collections.abc import Mapping
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.worlds import Worlds


class WorldsView(PictureView):
    """Who keeps a parameter's values in one world and in another. Show it as the last line of a cell."""

    def __init__(self, name: str) -> None:
        """Begin without a world.

        :param name: The parameter.
        """
        self._worlds = Worlds(name)
        super().__init__(self._worlds)

    def add(self, title: str, values: Mapping[str, Any], *, killed: str, successor: Any, server: str = '') -> None:
        """Add a world; the picture plays anew with it.

        :param values: What each node has set the parameter to, as it was measured.
        :param killed: The node that is killed and started again.
        :param successor: What the new node of that name begins with.
        :param server: Who keeps the values of all nodes, which is then only one; empty if each node keeps its own.
        :raises ValueError: there are two worlds already.
        """
        self._worlds.add(title, values, killed=killed, successor=successor, server=server)
        self._draw()
