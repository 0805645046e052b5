"""LiftsView: lifts that rise beside each other."""

from collections.abc import Mapping, Sequence

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.lifts import Lifts


class LiftsView(PictureView):
    """Lifts that rise beside each other at the speeds of their nodes. Show it as the last line of a cell."""

    def __init__(self, heights: Mapping[str, Sequence[tuple[float, float]]],
                 marks: Mapping[float, str] | None = None) -> None:
        """
        :param heights: By lift, points in time in s and its height there in m; in between it rises evenly.
        :param marks: What happens, by the time in s.
        """
        super().__init__(Lifts(heights, marks))
