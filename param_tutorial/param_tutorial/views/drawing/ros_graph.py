"""Who asks for whose parameters, and who hears of their changes: boxes in three columns, and arrows between them."""

from collections.abc import Iterable, Sequence

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.svg import BOLD, DASHES, PAPER, STROKE


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
        parts = [svg.plain_words(x + self._BOX_WIDTH / 2, 18, title, 'middle', BOLD) for x, title in (
            (self._LEFT_X, 'asks'), (self._MIDDLE_X, 'has parameters'), (self._RIGHT_X, 'hears of changes'))]
        for asker, asked in self.asks:
            parts.append(svg.arrow(*self._right_of(askers[asker]), *self._left_of(nodes[asked]),
                               attributes=STROKE + DASHES * (asked in self.missing)))
        for teller in self.tells:
            if teller in nodes:
                parts.append(svg.arrow(*self._right_of(nodes[teller]), *self._left_of(topic), attributes=STROKE))
        x, y = topic
        # The listeners stand below the topic, on a line that comes down from it.
        for _, listener_y in listeners.values():
            middle_y = listener_y + self._BOX_HEIGHT / 2
            parts.append(svg.line(x + 14, y + self._BOX_HEIGHT, x + 14, middle_y, STROKE)
                         + svg.arrow(x + 14, middle_y, x + self._INDENT, middle_y, attributes=STROKE))
        parts.append(self._box(x, y, '/parameter_events', rounded=True))
        parts += [self._box(left, top, name) for name, (left, top) in askers.items()]
        parts += [self._box(left, top, name, missing=name in self.missing) for name, (left, top) in nodes.items()]
        parts += [self._box(left + self._INDENT, top, name, width=self._BOX_WIDTH - self._INDENT)
                  for name, (left, top) in listeners.items()]
        return svg.picture(self.text, self._WIDTH, height, parts)

    def _column(self, x: float, names: Sequence[str]) -> dict[str, tuple[float, float]]:
        return {name: (x, self._TOP + row * self._ROW) for row, name in enumerate(names)}

    def _left_of(self, corner: tuple[float, float]) -> tuple[float, float]:
        return corner[0], corner[1] + self._BOX_HEIGHT / 2

    def _right_of(self, corner: tuple[float, float]) -> tuple[float, float]:
        return corner[0] + self._BOX_WIDTH, corner[1] + self._BOX_HEIGHT / 2

    def _box(self, x: float, y: float, name: str, *, width: float = _BOX_WIDTH, rounded: bool = False,
             missing: bool = False) -> str:
        rounding = self._BOX_HEIGHT / 2 if rounded else 3
        return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{self._BOX_HEIGHT}" rx="{rounding:.1f}" '
                f'fill="{PAPER}" {STROKE}{DASHES * missing}/>'
                + svg.plain_words(x + width / 2, y + 20, svg.cut(name, int(width / self._LETTER_WIDTH)), 'middle'))


def _joined(names: Iterable[str]) -> str:
    return ', '.join(names) or 'nobody'
