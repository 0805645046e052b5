"""LayersView: where a value comes from, as layers that cover each other."""

from collections.abc import Iterable
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.layers import draw_layers

Source = tuple[str, Any] | tuple[str, str, Any]
"""Its name and the value, with the name of the layer in between if several sources go into one."""


class LayersView(PictureView):
    """The sources of one parameter's value, as layers that cover each other. Show it as the last line of a cell."""

    def __init__(self, name: str, sources: Iterable[Source], *, has: Any) -> None:
        """
        :param name: The parameter.
        :param sources: In the order in which they are given to the node: a source and its value, or a source, the
            name of the layer into which it goes, and its value. A layer that is there already is changed where it
            lies; a new one, and a source without such a name, comes on top.
        :param has: What the node has in the end, as it says itself.
        """
        super().__init__(draw_layers(name, list(sources), has=has))
