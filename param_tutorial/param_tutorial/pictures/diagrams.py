"""Two pictures of a running system: a change on its way through a node, and who talks to whom. No ROS, no Jupyter.

Both are made of what others observed (``parameters.recording``, ``runtime.graph``). Like the plots they come out the
same to the byte on every machine, and can be read in a light and a dark theme, without color, and without eyes.
"""

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from param_tutorial.pictures.svg import INK, PAPER, arrow, line, picture, words

_BOLD = ' font-weight="bold"'


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
        :raises ValueError: there is no step.
        """
        self.node, self.name, self.steps = node, name, tuple(steps)
        if not self.steps:
            raise ValueError('a Timeline takes one step at least')

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
        parts = [words(12, 18, self.node, 'start', _BOLD),
                 words(self._STORED_X, 18, f'stored {self.name}', 'end', _BOLD),
                 line(self._LINE_X, 28, self._LINE_X, height - 8, f'stroke="{INK}" stroke-width="2"')]
        before = self.steps[0].stored
        for step, lines, top in zip(self.steps, wrapped, places):
            parts += self._step_parts(step, lines, top + 12, step.stored != before)
            before = step.stored
        return picture(self.text, self._WIDTH, height, parts)

    def _step_parts(self, step: Step, lines: Sequence[str], y: float, is_new: bool) -> Iterable[str]:
        begin, end = 12, self._LINE_X - 8
        stroke = f'stroke="{INK}" stroke-width="1.5"'
        if step.comes_from or step.goes_to:
            yield words((begin + end) / 2 - 4, y - 5, step.comes_from or step.goes_to, 'middle')
            yield arrow(begin, y, end, y, stroke) if step.comes_from else arrow(end, y, begin, y, stroke)
        # A ring for what may still fail, a disc for the moment from which the new value counts.
        yield (f'<circle cx="{self._LINE_X}" cy="{y:.1f}" r="6" stroke="{INK}" stroke-width="2" '
               f'fill="{INK if is_new else PAPER}"/>')
        yield words(self._WHAT_X, y + 4, step.what, 'start', _BOLD)
        for number, text in enumerate(lines):
            yield words(self._HAPPENED_X, y + 4 + number * self._LINE_HEIGHT, text, 'start')
        yield words(self._STORED_X, y + 4, _cut(step.stored, self._STORED_LETTERS), 'end', _BOLD if is_new else '')


class NodeGraph:
    """Who asks for whose parameters, and who listens to their changes."""

    _WIDTH = 720
    _LEFT_X, _MIDDLE_X, _RIGHT_X = 8, 268, 528
    _BOX_WIDTH, _BOX_HEIGHT, _ROW, _TOP = 184, 30, 44, 36
    _INDENT = 28
    _LETTER_WIDTH = 7.5
    """An estimate, since only the browser knows it; a name that is too long for its box is cut off."""

    def __init__(self, *, serves: Iterable[str], asks: Iterable[tuple[str, str]], tells: Iterable[str],
                 listens: Iterable[str]) -> None:
        """
        :param serves: Nodes that offer parameter services.
        :param asks: Pairs of a node that has a client for such a service, and the node whose service it is.
        :param tells: Nodes that publish on /parameter_events.
        :param listens: Nodes that subscribe to it.
        """
        self.serves, self.tells, self.listens = sorted(set(serves)), sorted(set(tells)), sorted(set(listens))
        self.asks = sorted(set(asks))

    @property
    def askers(self) -> list[str]:
        """The nodes that have clients, sorted."""
        return sorted({asker for asker, _ in self.asks})

    @property
    def missing(self) -> list[str]:
        """Nodes that somebody wants to ask, but that offer no parameter services or do not exist."""
        return sorted({asked for _, asked in self.asks} - set(self.serves))

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return '. '.join(repr(self).splitlines())

    def __repr__(self) -> str:
        lines = [f'offer parameter services: {_joined(self.serves)}']
        for asker in self.askers:
            lines.append(f'{asker} asks: {_joined(asked for each, asked in self.asks if each == asker)}')
        lines += [f'asked for, and not there: {_joined(self.missing)}'] if self.missing else []
        return '\n'.join([*lines, f'publish on /parameter_events: {_joined(self.tells)}',
                          f'listen to /parameter_events: {_joined(self.listens)}'])

    def _repr_html_(self) -> str:
        middle = [*self.serves, *self.missing]
        rows = max(len(self.askers), len(middle), len(self.listens) + 1, 1)
        height = self._TOP + rows * self._ROW
        askers = self._column(self._LEFT_X, self.askers)
        nodes = self._column(self._MIDDLE_X, middle)
        topic, *rest = self._column(self._RIGHT_X, ['', *self.listens]).values()
        listeners = dict(zip(self.listens, rest))
        parts = [words(x + self._BOX_WIDTH / 2, 18, title, 'middle', _BOLD) for x, title in (
            (self._LEFT_X, 'asks'), (self._MIDDLE_X, 'has parameters'), (self._RIGHT_X, 'hears of changes'))]
        stroke = f'stroke="{INK}" stroke-width="1.5"'
        for asker, asked in self.asks:
            dashes = ' stroke-dasharray="5 4"' if asked in self.missing else ''
            parts.append(arrow(*self._right_of(askers[asker]), *self._left_of(nodes[asked]), stroke + dashes))
        for teller in self.tells:
            if teller in nodes:
                parts.append(arrow(*self._right_of(nodes[teller]), *self._left_of(topic), stroke))
        x, y = topic
        # The listeners stand below the topic, on a line that comes down from it.
        for _, listener_y in listeners.values():
            middle_y = listener_y + self._BOX_HEIGHT / 2
            parts.append(line(x + 14, y + self._BOX_HEIGHT, x + 14, middle_y, stroke)
                         + arrow(x + 14, middle_y, x + self._INDENT, middle_y, stroke))
        parts.append(self._box(x, y, '/parameter_events', rounded=True))
        parts += [self._box(left, top, name) for name, (left, top) in askers.items()]
        parts += [self._box(left, top, name, missing=name in self.missing) for name, (left, top) in nodes.items()]
        parts += [self._box(left + self._INDENT, top, name, width=self._BOX_WIDTH - self._INDENT)
                  for name, (left, top) in listeners.items()]
        return picture(self.text, self._WIDTH, height, parts)

    def _column(self, x: float, names: Sequence[str]) -> dict[str, tuple[float, float]]:
        return {name: (x, self._TOP + row * self._ROW) for row, name in enumerate(names)}

    def _left_of(self, corner: tuple[float, float]) -> tuple[float, float]:
        return corner[0], corner[1] + self._BOX_HEIGHT / 2

    def _right_of(self, corner: tuple[float, float]) -> tuple[float, float]:
        return corner[0] + self._BOX_WIDTH, corner[1] + self._BOX_HEIGHT / 2

    def _box(self, x: float, y: float, name: str, *, width: float = _BOX_WIDTH, rounded: bool = False,
             missing: bool = False) -> str:
        rounding = self._BOX_HEIGHT / 2 if rounded else 3
        dashes = ' stroke-dasharray="5 4"' if missing else ''
        return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{self._BOX_HEIGHT}" rx="{rounding:.1f}" '
                f'fill="{PAPER}" stroke="{INK}" stroke-width="1.5"{dashes}/>'
                + words(x + width / 2, y + 20, _cut(name, int(width / self._LETTER_WIDTH)), 'middle'))


def _joined(names: Iterable[str]) -> str:
    return ', '.join(names) or 'nobody'


def _cut(text: str, letters: int) -> str:
    return text if len(text) <= letters else f'{text[:letters - 1]}…'
