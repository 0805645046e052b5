"""A message on /parameter_events on its way: from the node that has changed, over the topic, to each that listens."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_BOX_WIDTH, _SENDER_BOX, _BOX, _ROW, _BOTTOM = 212, 38, 56, 64, 40
_LEAVE_SEC, _TO_TOPIC_SEC, _AT_TOPIC_SEC, _TO_EARS_SEC = 0.3, 0.9, 0.4, 0.9
_AT_SEC = _LEAVE_SEC + _TO_TOPIC_SEC
_ON_SEC = _AT_SEC + _AT_TOPIC_SEC
_ENVELOPE = svg.box(-15, -10, 30, 20, 'token', rounding=2) + svg.path('M-15 -9l15 11l15 -11')


@dataclass(frozen=True)
class Listener:
    """A node that subscribes."""

    asks: str
    """The QoS that its subscription asks for, e.g. ``'reliable, volatile'``."""
    problem: str = ''
    """Why it gets nothing; empty if messages reach it."""


@dataclass(frozen=True)
class _Layout:
    """Where everything is: the nodes on both sides of the topic, or all of them beside it on a narrow page."""

    senders: dict[str, float]
    """Where the middle of each box is."""
    listeners: dict[str, float]
    senders_x: float
    listeners_x: float
    sender_edge: float
    """Where messages leave a node."""
    topic_x: float
    topic_y: float
    topic_width: float
    topic_height: float
    is_narrow: bool

    @property
    def topic_in(self) -> float:
        """Where messages come into the topic."""
        return self.topic_x + (self.topic_width if self.is_narrow else 0)

    @property
    def topic_out(self) -> float:
        """Where messages leave the topic."""
        return self.topic_x + self.topic_width

    @property
    def middle(self) -> tuple[float, float]:
        return self.topic_x + self.topic_width / 2, self.topic_y + self.topic_height / 2


class MessageTraffic(svg.AnimatedPicture):
    """Who publishes on /parameter_events and who subscribes to it; at rest each listener has the message."""

    subject = '/parameter_events'
    _has_narrow = True

    def __init__(self, tells: Sequence[str], listens: Mapping[str, Listener], sender: str = '',
                 changes: Sequence[str] = (), *, offers: str = '') -> None:
        """
        :param tells: Nodes that publish.
        :param listens: Nodes that subscribe.
        :param sender: The node whose message travels; empty for none.
        :param changes: What the message says, e.g. ``['changed speed = 2']``.
        :param offers: The QoS that the publishers offer.
        """
        self._offers = offers
        self._sender, self._changes = sender, tuple(changes)
        self._tells = sorted({*tells, *([sender] if sender else [])})
        self._listens = dict(sorted(listens.items()))

    @property
    def sentence(self) -> str:
        if not self._sender:
            return 'Nothing has changed yet.'
        got = sum(not each.problem for each in self._listens.values())
        return f'A message from {self._sender} goes to {got or "no"} listener{"" if got == 1 else "s"}.'

    @property
    def text(self) -> str:
        offer = f' (they offer {self._offers})' if self._offers else ''
        asks = {name: f'{name} (asks for {each.asks})' for name, each in self._listens.items()}
        reached = [asks[name] for name, each in self._listens.items() if not each.problem]
        parts = [f'Publish on /parameter_events{offer}: {_joined(self._tells)}', f'subscribe to it: {_joined(reached)}']
        parts += [f'{asks[name]} subscribes and gets nothing: {each.problem}'
                  for name, each in self._listens.items() if each.problem]
        says = f' It says: {"; ".join(self._changes)}.' if self._sender else ''
        return f'{"; ".join(parts)}. {self.sentence}{says}'

    @property
    def _height(self) -> float:
        layout = self._layout
        return layout.topic_y + layout.topic_height + _BOTTOM

    @property
    def _layout(self) -> _Layout:
        if self._is_narrow:
            senders_y, row = 70, 46
            listeners_y = senders_y + len(self._tells) * row + 32
            foot = listeners_y + len(self._listens) * _ROW
            return _Layout({name: senders_y + (number + .5) * row for number, name in enumerate(self._tells)},
                           {name: listeners_y + (number + .5) * _ROW for number, name in enumerate(self._listens)},
                           78, 78, 74, 12, 32, 30, foot - 32, is_narrow=True)
        height = max(len(self._tells), len(self._listens), 2) * _ROW
        return _Layout(_column(self._tells, height), _column(self._listens, height),
                       14, 494, 14 + _BOX_WIDTH, 296, 58, 128, height, is_narrow=False)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        layout = self._layout
        yield from self._heads(layout)
        for name, y in layout.senders.items():
            sends, away = name == self._sender, -3 if not layout.is_narrow else 3
            yield svg.arrow(layout.sender_edge - away - 1, y, layout.topic_in + away, y, 'line' if sends else 'thin')
            yield svg.named_box(layout.senders_x, y - _SENDER_BOX / 2, _BOX_WIDTH, _SENDER_BOX, name,
                                kind='token' if sends else 'blank')
        for name, y in layout.listeners.items():
            yield from self._listener(layout, name, y, animation)
        if not self._sender:
            return
        told = svg.cut('; '.join(self._changes), 22 if layout.is_narrow else 92)
        yield svg.words(14, self._height - 13, f'the message: {told}', 'bold', anchor='start')
        sender_y, edge = layout.senders[self._sender], layout.sender_edge
        yield svg.group(_ENVELOPE, animation.travel(
            [(_LEAVE_SEC, edge, sender_y), (_LEAVE_SEC + .7 * _TO_TOPIC_SEC, layout.topic_in, sender_y),
             (_AT_SEC, *layout.middle), (_ON_SEC, *layout.middle)], goes=True))
        for name, y in layout.listeners.items():
            if not self._listens[name].problem:
                yield svg.group(_ENVELOPE, animation.travel(
                    [(_ON_SEC, *layout.middle), (_ON_SEC + .4 * _TO_EARS_SEC, layout.topic_out, y),
                     (_ON_SEC + _TO_EARS_SEC, layout.listeners_x - 4, y)], from_sec=_ON_SEC))

    def _heads(self, layout: _Layout) -> Iterator[str]:
        """Yield the topic, and the words above what is beside it."""
        middle_x, middle_y = layout.middle
        yield svg.box(layout.topic_x, layout.topic_y, layout.topic_width, layout.topic_height,
                      rounding=min(22, layout.topic_width / 2))
        offers = f'they offer: {self._offers}' if self._offers else ''
        if layout.is_narrow:
            yield svg.words(12, 20, 'the topic /parameter_events', 'small', anchor='start')
            yield svg.words(layout.senders_x, 46, 'publish', 'bold', anchor='start')
            yield svg.words(layout.senders_x, 62, offers, 'small', anchor='start')
            above = min(layout.listeners.values(), default=0) - _ROW / 2 - 8
            yield svg.words(layout.listeners_x, above, 'subscribe', 'bold', anchor='start')
        else:
            yield svg.words(layout.senders_x + _BOX_WIDTH / 2, 24, 'publish', 'bold')
            yield svg.words(layout.senders_x + _BOX_WIDTH / 2, 42, offers, 'small')
            yield svg.words(layout.listeners_x + _BOX_WIDTH / 2, 24, 'subscribe', 'bold')
            yield svg.words(middle_x, middle_y - 26, '/parameter_events', 'small')
            yield svg.words(middle_x, middle_y + 38, 'a topic', 'faint')

    def _listener(self, layout: _Layout, name: str, y: float, animation: svg.Animation) -> Iterator[str]:
        listener, left = self._listens[name], layout.listeners_x
        begin, end, middle = layout.topic_out + 3, left - 4, left + _BOX_WIDTH / 2
        if listener.problem:
            yield svg.path(f'M{begin} {y}H{end}', 'dashed') + svg.cross(begin + (end - begin) / 3, y)
        else:
            yield svg.arrow(begin, y, end, y, 'line' if self._sender else 'thin')
        yield svg.box(left, y - _BOX / 2, _BOX_WIDTH, _BOX, 'blank')
        yield svg.words(middle, y - 11, svg.cut(name, int((_BOX_WIDTH - 8) / svg.CODE_WIDTH)), 'code')
        yield svg.words(middle, y + 5, f'asks for: {listener.asks}', 'small')
        if listener.problem:
            yield svg.words(middle, y + 21, f'gets nothing: {listener.problem}', 'small')
        elif self._sender:
            yield svg.group([svg.check(middle - 23, y + 16, 4.5),
                             svg.words(middle - 12, y + 21, 'gets it', 'small', anchor='start')],
                            animation.appear(_ON_SEC + _TO_EARS_SEC))


def _column(names: Iterable[str], height: float) -> dict[str, float]:
    """Return where the middle of each node's box is; fewer boxes than rows stand in the middle."""
    names = list(names)
    return {name: 58 + height / 2 + (number + .5 - len(names) / 2) * _ROW for number, name in enumerate(names)}


def _joined(names: Iterable[str]) -> str:
    return ', '.join(names) or 'nobody'
