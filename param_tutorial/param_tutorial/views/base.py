"""What the views of animated pictures have in common: what is played, and when."""

import ipywidgets as widgets
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node

from param_tools.markup.styles import style
from param_tools.panel.close_with_cell import close_with_cell
from param_tools.panel.view import View
from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram

_STYLE = svg.STYLE + style('param_tutorial/views/base.css')


class AnimatedView(View):
    """A picture that plays when it is put onto the page."""

    def __init__(self, *below: widgets.Widget) -> None:
        """:param below: What stands below the picture."""
        self._text = ''
        self._count = 0
        self._drawn = widgets.HTML()
        super().__init__([widgets.HTML(_STYLE), self._drawn, *below], 'motion-view')

    @property
    def text(self) -> str:
        """What the picture shows, in words, as a screen reader tells it."""
        return self._text

    def _play(self, picture: Diagram) -> None:
        """Put a picture onto the page in the place of the one before."""
        self._text = picture.text
        self._count += 1
        # The animations of several pictures on one page need different names.
        self._drawn.value = picture.html(f'motion-{self.model_id[:8]}-{self._count}')


class PictureView(AnimatedView):
    """A picture of what was measured before. It follows nothing, and plays anew when something is added to it."""

    def __init__(self, picture: Diagram, *below: widgets.Widget) -> None:
        super().__init__(*below)
        self._replace(picture)
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<{type(self).__name__}: {self._picture.sentence}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        """What the view is of; no node is asked."""
        return self._picture.subject

    def _replace(self, picture: Diagram) -> str:
        """Play another picture from now on, and return it in words."""
        self._picture = picture
        with self._drawing:
            if not self._closed:
                self._play(picture)
        return picture.text

    def _end(self) -> None:
        pass


def name_of(node: Node) -> str:
    """Return the fully qualified name of a node; empty if the node has been destroyed."""
    try:
        return str(node.get_fully_qualified_name())
    except InvalidHandle:
        return ''
