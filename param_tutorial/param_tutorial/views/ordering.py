"""A line below a picture in which a reader puts things into another order, and the node is asked in that order."""

import traitlets

from param_tools.markup.scripts import bundle
from param_tutorial.views.handle import Handle


class Ordering(Handle):
    """The line; hidden as long as there are no two things to put in order. What is chosen are all items, in order."""

    _esm = bundle('param_tutorial/views/ordering.js')
    items = traitlets.List(traitlets.Unicode()).tag(sync=True)
    """The names of the things, each once, in the order in which the node was asked last."""

    def _answer(self, chosen: list[str]) -> str:
        told = super()._answer(chosen)
        self.items = chosen
        return told
