"""What CopiesView and DeclarationsView share: places that hold values, moment by moment."""

from collections.abc import Sequence
from typing import Any

from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.trail import Moment, Move, draw_trail


class TrailView(PictureView):
    """Places that hold values, moment by moment, and what travels between them."""

    def __init__(self, subject: str, places: Sequence[str]) -> None:
        """
        :param subject: What the picture is of.
        :param places: Their names, from the left to the right.
        """
        self._places = places
        self._moments: list[Moment] = []
        super().__init__(draw_trail(subject, places, []))

    def _add(self, words: str, values: Sequence[Any], *moves: Move, note: str = '') -> None:
        """Add a moment; the picture plays anew with it.

        :param values: What each place holds when it is over, as it was measured; ``...`` for nothing.
        """
        held = {place: str(value) for place, value in zip(self._places, values, strict=True) if value is not ...}
        self._moments.append(Moment(words, note, held, moves))
        self._replace(draw_trail(self.node, self._places, self._moments))
