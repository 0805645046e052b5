"""Lines below a picture in which a reader chooses what each of several things has, and the node is asked with that."""

import traitlets

from param_tools.markup.scripts import bundle
from param_tutorial.views.handle import Handle


class Choosing(Handle):
    """The lines. A choice is a thing, one of its properties, and the new value of that property."""

    _esm = bundle('param_tutorial/views/choosing.js')
    caption = traitlets.Unicode().tag(sync=True)
    """Stands above the lines."""
    options = traitlets.Dict().tag(sync=True)
    """For each property its possible values."""
    things = traitlets.Dict().tag(sync=True)
    """For each thing the value of each property."""
