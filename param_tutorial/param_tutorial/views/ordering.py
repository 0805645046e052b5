"""A line below a picture in which a reader puts things into another order, and the node is asked in that order."""

from collections.abc import Callable, Sequence

import traitlets

from param_tools.markup.scripts import bundle
from param_tutorial.views.handle import Handle


class Ordering(Handle):
    """The line; empty as long as there are no two things to be put in order."""

    _esm = bundle('param_tutorial/views/ordering.js')
    caption = traitlets.Unicode().tag(sync=True)
    """What happens in this order."""
    items = traitlets.List(traitlets.Unicode()).tag(sync=True)
    """The names of the things, each once, in the order in which the node was asked last."""

    def __init__(self, caption: str, items: Sequence[str], ask: Callable[[list[str]], str]):
        """:param ask: Gets all items in their new order."""
        def ask_in_order(items: list[str]) -> str:
            told = ask(items)
            self.items = items
            return told
        super().__init__(ask_in_order, caption=caption, items=list(items))
