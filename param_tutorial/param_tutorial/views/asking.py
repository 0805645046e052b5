"""A line below a picture in which a reader types another value, and the node is asked for it."""

import traitlets

from param_tools import values
from param_tools.markup.scripts import bundle
from param_tutorial.views.handle import Handle


class Asking(Handle):
    """The line; the value has the type that ``ros2 param set`` would give it."""

    _esm = bundle('param_tutorial/views/asking.js')
    name = traitlets.Unicode().tag(sync=True)
    """The parameter's."""
    text = traitlets.Unicode().tag(sync=True)
    """What the line begins with."""

    def _answer(self, chosen: str) -> str:
        return super()._answer(values.parse(chosen))
