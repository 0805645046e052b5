"""A message on /parameter_events on its way: from the node that has changed, over the topic, to each that listens."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_TOP, _ROW, _SENDER_BOX, _BOX, _BOTTOM = 58, 64, 38, 56, 40
_LEFT_X, _BOX_WIDTH, _TOPIC_X, _TOPIC_WIDTH, _RIGHT_X = 14, 212, 296, 128, 494
_TOPIC_MIDDLE, _TOPIC_END = _TOPIC_X + _TOPIC_WIDTH / 2, _TOPIC_X + _TOPIC_WIDTH
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


class MessageTraffic(svg.AnimatedPicture):
    """Who publishes on /parameter_events and who subscribes to it; at rest each listener has the message."""

    subject = '/parameter_events'

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
        self._rows = max(len(self._tells), len(self._listens), 2)

    @property
    def sentence(self) -> str:
        """What happens."""
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
        return _TOP + self._rows * _ROW + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        middle_y = _TOP + self._rows * _ROW / 2
        yield svg.words(_LEFT_X + _BOX_WIDTH / 2, 24, 'publish', 'bold')
        yield svg.words(_RIGHT_X + _BOX_WIDTH / 2, 24, 'subscribe', 'bold')
        if self._offers:
            yield svg.words(_LEFT_X + _BOX_WIDTH / 2, 42, f'they offer: {self._offers}', 'small')
        yield svg.box(_TOPIC_X, _TOP, _TOPIC_WIDTH, self._rows * _ROW, rounding=22)
        yield svg.words(_TOPIC_MIDDLE, middle_y - 26, '/parameter_events', 'small')
        yield svg.words(_TOPIC_MIDDLE, middle_y + 38, 'a topic', 'faint')
        for y, name in self._column(self._tells):
            sends = name == self._sender
            yield svg.arrow(_LEFT_X + _BOX_WIDTH + 4, y, _TOPIC_X - 3, y, 'line' if sends else 'thin')
            yield svg.named_box(_LEFT_X, y - _SENDER_BOX / 2, _BOX_WIDTH, _SENDER_BOX, name, kind='token' if sends else 'blank')
        for y, name in self._column(self._listens):
            yield from self._listener(y, name, self._listens[name], animation)
        if not self._sender:
            return
        told = svg.cut('; '.join(self._changes), 92)
        yield svg.words(_LEFT_X, self._height - 13, f'the message: {told}', 'bold', anchor='start')
        sender_y = next(y for y, name in self._column(self._tells) if name == self._sender)
        yield svg.group(_ENVELOPE, animation.travel(
            [(_LEAVE_SEC, _LEFT_X + _BOX_WIDTH, sender_y), (_LEAVE_SEC + .7 * _TO_TOPIC_SEC, _TOPIC_X, sender_y),
             (_AT_SEC, _TOPIC_MIDDLE, middle_y), (_ON_SEC, _TOPIC_MIDDLE, middle_y)], goes=True))
        for y, name in self._column(self._listens):
            if not self._listens[name].problem:
                yield svg.group(_ENVELOPE, animation.travel(
                    [(_ON_SEC, _TOPIC_MIDDLE, middle_y), (_ON_SEC + .4 * _TO_EARS_SEC, _TOPIC_END, y),
                     (_ON_SEC + _TO_EARS_SEC, _RIGHT_X - 4, y)], from_sec=_ON_SEC))

    def _column(self, names: Iterable[str]) -> list[tuple[float, str]]:
        """Return where the middle of each node's box is; fewer boxes than rows stand in the middle."""
        names = list(names)
        return [(_TOP + ((self._rows - len(names)) / 2 + number + .5) * _ROW, name)
                for number, name in enumerate(names)]

    def _listener(self, y: float, name: str, listener: Listener, animation: svg.Animation) -> Iterator[str]:
        begin, end, middle = _TOPIC_END + 3, _RIGHT_X - 4, _RIGHT_X + _BOX_WIDTH / 2
        if listener.problem:
            yield svg.path(f'M{begin} {y}H{end}', 'dashed') + svg.cross(begin + 22, y)
        else:
            yield svg.arrow(begin, y, end, y, 'line' if self._sender else 'thin')
        yield svg.box(_RIGHT_X, y - _BOX / 2, _BOX_WIDTH, _BOX, 'blank')
        yield svg.words(middle, y - 11, svg.cut(name, int((_BOX_WIDTH - 8) / svg.CODE_WIDTH)), 'code')
        yield svg.words(middle, y + 5, f'asks for: {listener.asks}', 'small')
        if listener.problem:
            yield svg.words(middle, y + 21, f'gets nothing: {listener.problem}', 'small bold')
        elif self._sender:
            yield svg.group([svg.check(middle - 23, y + 16, 4.5),
                             svg.words(middle - 12, y + 21, 'gets it', 'small', anchor='start')],
                            animation.appear(_ON_SEC + _TO_EARS_SEC))


def _joined(names: Iterable[str]) -> str:
    return ', '.join(names) or 'nobody'
