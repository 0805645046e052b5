"""The robot that the reader's nodes drive, and above it what became of their files."""

import ipywidgets as widgets

from param_tools.markup.styles import style
from param_tools.markup.tables import with_code
from param_tools.panel.close_with_cell import close_with_cell
from param_tools.panel.view import View
from param_tutorial.package.following import FollowedPackage
from param_tutorial.views.side_by_side import Offer
from param_tutorial.views.track import TrackView

_STYLE = style('param_tutorial/package/editor.css')


class RobotPicture(View):
    """The base on its track, with a line for each file. Show it as the last line of a cell.

    In JupyterLab it stands beside the text, as what a ``SideBySide`` shows does.
    """

    def __init__(self, package: FollowedPackage):
        self._package = package
        self._said = widgets.HTML()
        box = widgets.VBox([self._said, TrackView(package.base)])
        box.add_class('robot-parts')
        offer = Offer(box=box, views=box.model_id, nodes=self.node)
        super().__init__([offer, box], 'robot-picture')
        offer.shown = self.model_id
        self._stop_following = package.on_change(self._show)
        self._show()
        close_with_cell(self)

    def __repr__(self) -> str:
        return f'<RobotPicture: {self.node}>'

    @property
    def node(self) -> str:
        """The base."""
        return str(self._package.base.get_fully_qualified_name())

    def _show(self) -> None:
        with self._drawing:
            lines = [f'<p class="file-status{" file-error" if each.is_error else ""}">{with_code(each.words)}</p>'
                     for each in self._package.statuses]
            self._said.value = f'{_STYLE}<div class="file-front">{"".join(lines)}</div>'

    def _end(self) -> None:
        self._stop_following()
