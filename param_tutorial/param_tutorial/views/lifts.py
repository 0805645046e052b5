"""LiftsView: lifts that rise beside each other."""

from collections.abc import Mapping

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.lifts import Points, draw_lifts


class LiftsView(PictureView):
    """Lifts that rise beside each other at the speeds of their nodes. Show it as the last line of a cell."""

    def __init__(self, heights: Mapping[str, Points],
                 marks: Mapping[float, str] | None = None) -> None:
        """
        :param heights: By lift, points in time in s and its height there in m; in between it rises evenly.
        :param marks: What happens, by the time in s.
        """
        super().__init__(draw_lifts(heights, marks or {}))
