"""What the views of moving pictures have in common, whether they follow a node (``motion``) or not (``pictured``)."""

from collections.abc import Callable

import ipywidgets as widgets

from param_tools.markup.styles import style
from param_tools.panel.view import View
from param_tutorial.pictures import motion

_STYLE = motion.STYLE + style('param_tutorial/views/motion.css')


class ReelView(View):
    """A picture that moves when it is put onto the page."""

    def __init__(self) -> None:
        self._count = 0
        self._drawn = widgets.HTML()
        super().__init__([widgets.HTML(_STYLE), self._drawn], 'motion-view')

    def _put(self, picture: Callable[[motion.Reel], str], *, is_still: bool = False) -> None:
        """Put a picture onto the page in the place of the one before.

        :param is_still: Whether everything in it is to stand as it does at the end.
        """
        self._count += 1
        # The animations of several pictures on one page need different names.
        self._drawn.value = picture(motion.Reel(f'reel-{self.model_id[:8]}-{self._count}', is_still=is_still))
