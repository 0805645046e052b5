"""LayersView: where a value comes from, as layers that cover each other."""

from collections.abc import Callable, Iterable
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.diagram import Diagram
from param_tutorial.views.drawing.layers import draw_layers
from param_tutorial.views.handle import Ordering

Source = tuple[str, Any] | tuple[str, str, Any]
"""Its name and the value, with the name of the layer in between if several sources go into one."""


class LayersView(PictureView):
    """The sources of one parameter's value, as layers that cover each other. Show it as the last line of a cell.

    If the view can start a node, a reader puts the sources into another order below it, and a node starts with them.
    """

    def __init__(self, name: str, sources: Iterable[Source], *, has: Any = ...,
                 start: Callable[..., Any] | None = None) -> None:
        """
        :param name: The parameter.
        :param sources: In the order in which they are given to the node: a source and its value, or a source, the
            name of the layer into which it goes, and its value. A layer that is there already is changed where it
            lies; a new one, and a source without such a name, comes on top.
        :param has: What the node has in the end, if it was asked.
        :param start: Starts a node with sources, whose names it gets in their order, and returns the value that the
            node has. It never gets the first source, which is the default; the names of the others differ.
        """
        sources = list(sources)
        if start is None:
            super().__init__(draw_layers(name, sources, has=has))
            return
        by_name = {source[0]: source for source in sources[1:]}

        def started(order: Iterable[str]) -> Diagram:
            return draw_layers(name, [*sources[:1], *(by_name[each] for each in order)], has=start(*order))

        super().__init__(started(by_name), Ordering(lambda order: self._replace(started(order)), items=list(by_name)))
