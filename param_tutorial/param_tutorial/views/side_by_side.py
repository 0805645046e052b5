"""Two views as one: a picture, and beside it the panel that changes it."""

import ipywidgets as widgets
import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.close_with_cell import close_looks, close_with_cell
from param_tools.panel.front import Front
from param_tools.panel.view import View


class Offer(Front):
    """What a notebook's page puts beside the text."""

    _esm = bundle('param_tutorial/views/beside_text.js')
    _css = sheet('param_tutorial/views/side_by_side.css')
    box = traitlets.Instance(widgets.Box).tag(sync=True, **widgets.widget_serialization)
    views = traitlets.Unicode().tag(sync=True)
    """Which ones are in the box."""
    nodes = traitlets.Unicode().tag(sync=True)
    """The names of their nodes, in words."""
    shown = traitlets.Unicode().tag(sync=True)
    """The id of the widget that the cell shows."""


class SideBySide(widgets.VBox):
    """A picture and a panel: beside the text of the notebook where JupyterLab has room for that, or else in the cell.

    They belong to the section of the cell, up to the next heading ``## …``, and to each later section whose heading's
    cell has the tag ``stage``. Beside other text they are folded.

    In a cell they are side by side where there is room for both, and the picture is above the panel elsewhere. The
    picture stays in sight while you scroll through a long panel. Show it as the last line of a cell, and the same views
    again wherever you need them: closing it leaves them as they are.
    """

    def __init__(self, picture: View, panel: View) -> None:
        """
        :param picture: What stays in sight: a TrackView, for example, or any other view.
        :param panel: What is beside it, or below it: a ParameterPanel, for example.
        """
        self.parts: tuple[View, ...] = (picture, panel)
        self._box = widgets.HBox(self.parts)
        self._box.add_class('side-by-side-parts')
        self._offer = Offer(box=self._box, views=' '.join(part.model_id for part in self.parts),
                            nodes=' and '.join(dict.fromkeys(part.node for part in self.parts)))
        super().__init__([self._offer, self._box])
        self._offer.shown = self.model_id
        self.add_class('side-by-side')
        self._stop_watching = [part.on_close(self._drop) for part in self.parts]
        close_with_cell(self)

    def __repr__(self) -> str:
        # Without what is true at this moment only, such as whether a node is there.
        return f'<SideBySide: {" and ".join(f"{type(part).__name__} of {part.node}" for part in self.parts)}>'

    def close(self) -> None:
        """Remove it from the page, but not the views in it. Safe to call more than once."""
        if self.comm is None:
            return
        for stop in self._stop_watching:
            stop()
        self._box.children = self.children = ()
        for widget in (self._offer, self._box):
            widget.close()
            close_looks(widget)
        super().close()
        close_looks(self)

    def _drop(self, view: View) -> None:
        """Take a view out that is about to be closed: a browser cannot do so afterwards, and says so."""
        self._box.children = tuple(each for each in self._box.children if each is not view)
