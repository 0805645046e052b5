"""A change on its way through a node, as ``set_recorder`` has recorded it, from top to bottom."""

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing.svg import BOLD, INK, PAPER, STROKE, arrow, cut, line, picture, plain_words


@dataclass(frozen=True)
class Step:
    """One moment of a change."""

    what: str
    """In a word or two, e.g. 'on-set'."""
    happened: str
    """As a sentence, e.g. 'validate: sees 300, accepts'."""
    stored: str
    """The value that the parameter had at this moment."""
    comes_from: str = ''
    """Who sent a message to the node; empty if nobody did."""
    goes_to: str = ''
    """To whom the node sent a message; empty if to nobody."""
    who: str = ''
    """The callback that was called; empty if none was."""
    proposed: str = ''
    """The value on its way when the moment is over; empty if it does not change."""
    objection: str = ''
    """Why the value gets no further, e.g. the callback's reason; empty if it does."""


class Timeline:
    """The steps of one change from top to bottom: what happened, and what was stored at that moment."""

    _WIDTH = 720
    _LINE_X, _WHAT_X, _HAPPENED_X, _STORED_X = 120, 142, 230, 704
    _TOP, _ROW, _LINE_HEIGHT = 44, 30, 17
    _LETTERS, _STORED_LETTERS = 54, 20
    """How many letters of a step fit in one line, and of a value; a longer value is cut off."""

    def __init__(self, node: str, name: str, steps: Iterable[Step]) -> None:
        """
        :param node: The node that was asked.
        :param name: The parameter that was to change.
        """
        self.node, self.name, self.steps = node, name, tuple(steps)

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return f'{self.name} of {self.node}, step by step. ' + '. '.join(
            f'{number}, {step.what}: {step.happened}; stored is {step.stored}'
            for number, step in enumerate(self.steps, start=1))

    def __repr__(self) -> str:
        what = max(len(step.what) for step in self.steps)
        happened = max(len(step.happened) for step in self.steps)
        heading = f'{self.node}: {self.name}'
        return '\n'.join([f'{heading:<{what + happened + 4}}  stored', *(
            f'  {step.what:<{what}}  {step.happened:<{happened}}  {step.stored}' for step in self.steps)])

    def _repr_html_(self) -> str:
        wrapped = [textwrap.wrap(step.happened, self._LETTERS) or [''] for step in self.steps]
        places = [self._TOP]
        for lines in wrapped:
            places.append(places[-1] + self._ROW + self._LINE_HEIGHT * (len(lines) - 1))
        height = places[-1] + 8
        parts = [plain_words(12, 18, self.node, 'start', BOLD),
                 plain_words(self._STORED_X, 18, f'stored {self.name}', 'end', BOLD),
                 line(self._LINE_X, 28, self._LINE_X, height - 8, f'stroke="{INK}" stroke-width="2"')]
        before = self.steps[0].stored
        for step, lines, top in zip(self.steps, wrapped, places):
            parts += self._step_parts(step, lines, top + 12, step.stored != before)
            before = step.stored
        return picture(self.text, self._WIDTH, height, parts)

    def _step_parts(self, step: Step, lines: Sequence[str], y: float, is_new: bool) -> Iterable[str]:
        begin, end = 12, self._LINE_X - 8
        if step.comes_from or step.goes_to:
            yield plain_words((begin + end) / 2 - 4, y - 5, step.comes_from or step.goes_to, 'middle')
            from_x, to_x = (begin, end) if step.comes_from else (end, begin)
            yield arrow(from_x, y, to_x, y, attributes=STROKE)
        # A ring for what may still fail, a disc for the moment from which the new value counts.
        yield (f'<circle cx="{self._LINE_X}" cy="{y:.1f}" r="6" stroke="{INK}" stroke-width="2" '
               f'fill="{INK if is_new else PAPER}"/>')
        yield plain_words(self._WHAT_X, y + 4, step.what, 'start', BOLD)
        for number, text in enumerate(lines):
            yield plain_words(self._HAPPENED_X, y + 4 + number * self._LINE_HEIGHT, text, 'start')
        yield plain_words(self._STORED_X, y + 4, cut(step.stored, self._STORED_LETTERS), 'end', BOLD if is_new else '')
