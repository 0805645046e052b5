"""A message on /parameter_events on its way: from the node that has changed, over the topic, to each that listens."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram, Moving

_BOX_WIDTH, _SENDER_BOX, _BOX, _ROW, _TOP, _BOTTOM = 212, 38, 56, 64, 58, 40
_SENDERS_X, _TOPIC_X, _TOPIC_WIDTH, _LISTENERS_X = 14, 296, 128, 494
_SENDERS_EDGE, _TOPIC_EDGE = _SENDERS_X + _BOX_WIDTH, _TOPIC_X + _TOPIC_WIDTH
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


def draw_messages(publishers: Sequence[str], subscribers: Mapping[str, Listener], sender: str = '',
                  changes: Sequence[str] = (), *, offers: str = '') -> Diagram:
    """Draw who publishes on /parameter_events and who subscribes to it; at rest each listener has the message.

    :param publishers: Nodes that publish.
    :param subscribers: Nodes that subscribe.
    :param sender: The node whose message travels; empty for none.
    :param changes: What the message says, e.g. ``['changed speed = 2']``.
    :param offers: The QoS that the publishers offer.
    """
    publishers, subscribers = sorted({*publishers, *([sender] if sender else [])}), dict(sorted(subscribers.items()))
    height = max(len(publishers), len(subscribers), 2) * _ROW
    sentence = _sentence(subscribers, sender)
    says = f' It says: {"; ".join(changes)}.' if sender else ''
    diagram = Diagram('/parameter_events', sentence, f'{_text(publishers, subscribers, offers)}. {sentence}{says}',
                      _TOP + height + _BOTTOM)
    topic_x, topic_y = _TOPIC_X + _TOPIC_WIDTH / 2, _TOP + height / 2
    diagram.add(svg.box(_TOPIC_X, _TOP, _TOPIC_WIDTH, height, rounding=22),
                svg.words(_SENDERS_X + _BOX_WIDTH / 2, 24, 'publish', 'bold'),
                svg.words(_SENDERS_X + _BOX_WIDTH / 2, 42, f'they offer: {offers}' if offers else '', 'small'),
                svg.words(_LISTENERS_X + _BOX_WIDTH / 2, 24, 'subscribe', 'bold'),
                svg.words(topic_x, topic_y - 26, '/parameter_events', 'small'),
                svg.words(topic_x, topic_y + 38, 'a topic', 'faint'))
    senders = _column(publishers, height)
    for name, y in senders.items():
        diagram.add(svg.arrow(_SENDERS_EDGE + 2, y, _TOPIC_X - 3, y, 'line' if name == sender else 'thin'),
                    svg.named_box(_SENDERS_X, y - _SENDER_BOX / 2, _BOX_WIDTH, _SENDER_BOX, name,
                                  kind='token' if name == sender else 'blank'))
    for name, y in _column(subscribers, height).items():
        _add_listener(diagram, name, subscribers[name], y, is_sent=bool(sender))
    if not sender:
        return diagram
    content = svg.cut('; '.join(changes), 92)
    y, there = senders[sender], (topic_x, topic_y)
    diagram.add(svg.words(14, diagram.height - 13, f'the message: {content}', 'bold', anchor='start'),
                Moving(_ENVELOPE, goes=True, stops=[
                    (_LEAVE_SEC, _SENDERS_EDGE, y), (_LEAVE_SEC + .7 * _TO_TOPIC_SEC, _TOPIC_X, y),
                    (_AT_SEC, *there), (_ON_SEC, *there)]))
    for name, y in _column(subscribers, height).items():
        if not subscribers[name].problem:
            diagram.add(Moving(_ENVELOPE, from_sec=_ON_SEC, stops=[
                (_ON_SEC, *there), (_ON_SEC + .4 * _TO_EARS_SEC, _TOPIC_EDGE, y),
                (_ON_SEC + _TO_EARS_SEC, _LISTENERS_X - 4, y)]))
    return diagram


def _sentence(subscribers: Mapping[str, Listener], sender: str) -> str:
    if not sender:
        return 'Nothing has changed yet.'
    got = sum(not each.problem for each in subscribers.values())
    return f'A message from {sender} goes to {got or "no"} listener{"" if got == 1 else "s"}.'


def _text(publishers: Iterable[str], subscribers: Mapping[str, Listener], offers: str) -> str:
    """Return in words who publishes and who subscribes."""
    offer = f' (they offer {offers})' if offers else ''
    asks = {name: f'{name} (asks for {each.asks})' for name, each in subscribers.items()}
    reached = [asks[name] for name, each in subscribers.items() if not each.problem]
    return '; '.join([
        f'Publish on /parameter_events{offer}: {", ".join(publishers) or "nobody"}',
        f'subscribe to it: {", ".join(reached) or "nobody"}',
        *(f'{asks[name]} subscribes and gets nothing: {each.problem}'
          for name, each in subscribers.items() if each.problem)])


def _add_listener(diagram: Diagram, name: str, listener: Listener, y: float, *, is_sent: bool) -> None:
    begin, end, middle = _TOPIC_EDGE + 3, _LISTENERS_X - 4, _LISTENERS_X + _BOX_WIDTH / 2
    if listener.problem:
        diagram.add(svg.path(f'M{begin} {y}H{end}', 'dashed'), svg.cross(begin + (end - begin) / 3, y))
    else:
        diagram.add(svg.arrow(begin, y, end, y, 'line' if is_sent else 'thin'))
    diagram.add(svg.box(_LISTENERS_X, y - _BOX / 2, _BOX_WIDTH, _BOX, 'blank'),
                svg.words(middle, y - 11, svg.cut(name, int((_BOX_WIDTH - 8) / svg.CODE_WIDTH)), 'code'),
                svg.words(middle, y + 5, f'asks for: {listener.asks}', 'small'))
    if listener.problem:
        diagram.add(svg.words(middle, y + 21, f'gets nothing: {listener.problem}', 'small'))
    elif is_sent:
        diagram.show(_ON_SEC + _TO_EARS_SEC, svg.check(middle - 23, y + 16, 4.5),
                     svg.words(middle - 12, y + 21, 'gets it', 'small', anchor='start'))


def _column(names: Iterable[str], height: float) -> dict[str, float]:
    """Return where the middle of each node's box is; fewer boxes than rows stand in the middle."""
    names = list(names)
    return {name: _TOP + height / 2 + (number + .5 - len(names) / 2) * _ROW for number, name in enumerate(names)}
