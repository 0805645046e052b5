"""TrailView: what some places hold, moment by moment."""

from collections.abc import Sequence
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.trail import Trail


class TrailView(PictureView):
    """Places that hold values, moment by moment, and what travels between them. Show it as the last line of a cell."""

    def __init__(self, subject: str, places: Sequence[str]) -> None:
        """
        :param subject: What the picture is of, e.g. a node's name or a file's.
        :param places: Their names, from the left to the right; each stands in the heading of a column.
        """
        self._trail = Trail(subject, places)
        super().__init__(self._trail)

    def add(self, words: str, values: Sequence[Any], *moves: tuple[str, str] | tuple[str, str, Any, str],
            note: str = '') -> None:
        """Add a moment; the picture plays anew with it.

        :param words: What happens, e.g. ``'colcon build'``.
        :param values: What each place holds when it is over, as it was measured; ``...`` for nothing.
        :param moves: What travels: from which place ('' for from outside) and to which. For what the second place
            does not take, also the value, and why.
        :param note: What is worth seeing in this moment.
        """
        self._trail.add(words, values, *moves, note=note)
        self._draw()
