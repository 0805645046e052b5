"""A message on /parameter_events on its way: from the node that has changed, over the topic, to each that listens."""

from collections.abc import Iterator, Mapping, Sequence

from param_tutorial.pictures import motion

_WIDTH, _TOP, _ROW, _BOX, _BOTTOM = 720, 48, 52, 38, 40
_LEFT_X, _BOX_WIDTH, _TOPIC_X, _TOPIC_WIDTH, _RIGHT_X = 14, 212, 296, 128, 494
_LEAVE_SEC, _TO_TOPIC_SEC, _AT_TOPIC_SEC, _TO_EARS_SEC = 0.3, 0.9, 0.4, 0.9
_LETTERS = 23
_MOST_ROWS = 8


class MessageTraffic:
    """Who publishes on /parameter_events and who subscribes to it, and one message between them."""

    def __init__(self, tells: Sequence[str], listens: Mapping[str, bool], sender: str = '',
                 changes: Sequence[str] = ()) -> None:
        """
        :param tells: Nodes that publish.
        :param listens: Nodes that subscribe; False for one that asks for more than the publishers offer, so that it
            gets nothing.
        :param sender: The node whose message travels; empty for none.
        :param changes: What the message says, e.g. ``['changed speed = 2']``.
        """
        self._sender, self._changes = sender, tuple(changes)
        tells = sorted({*tells, *([sender] if sender else [])})
        # A node that sends something is never left out.
        self._tells = sorted(sorted(tells, key=lambda each: each != sender)[:_MOST_ROWS])
        self._listens = dict(sorted(listens.items())[:_MOST_ROWS])

    @property
    def sentence(self) -> str:
        """What happens."""
        if not self._sender:
            return 'Nothing has changed yet.'
        got = sum(self._listens.values())
        return f'A message from {self._sender} goes to {got or "no"} listener{"" if got == 1 else "s"}.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        deaf = [name for name, hears in self._listens.items() if not hears]
        parts = [f'Publish on /parameter_events: {_joined(self._tells)}',
                 f'subscribe to it: {_joined(name for name, hears in self._listens.items() if hears)}']
        parts += [f'subscribe to it and get nothing, since their QoS is incompatible: {_joined(deaf)}'] if deaf else []
        says = f' It says: {"; ".join(self._changes)}.' if self._sender else ''
        return f'{"; ".join(parts)}. {self.sentence}{says}'

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each listener has the message."""
        rows = max(len(self._tells), len(self._listens), 2)
        height = _TOP + rows * _ROW + _BOTTOM
        middle_y = _TOP + rows * _ROW / 2
        left = {name: self._y(number, len(self._tells), rows) for number, name in enumerate(self._tells)}
        right = {name: self._y(number, len(self._listens), rows) for number, name in enumerate(self._listens)}
        parts = [*self._heads(), *self._roads(left, right),
                 motion.box(_TOPIC_X, _TOP, _TOPIC_WIDTH, rows * _ROW, rounding=22),
                 motion.label(_TOPIC_X + _TOPIC_WIDTH / 2, middle_y - 26, '/parameter_events',
                              css_class='motion-small'),
                 motion.label(_TOPIC_X + _TOPIC_WIDTH / 2, middle_y + 38, 'a topic', css_class='motion-faint')]
        for name, y in left.items():
            parts += self._node(_LEFT_X, y, name)
        arrived_sec = _LEAVE_SEC + _TO_TOPIC_SEC + _AT_TOPIC_SEC + _TO_EARS_SEC
        for name, y in right.items():
            parts += self._listener(y, name, arrived_sec, reel)
        if self._sender:
            parts += self._messages(left[self._sender], middle_y, right, reel)
            words = motion.cut('; '.join(self._changes), 92)
            parts.append(motion.label(_LEFT_X, height - 13, f'the message: {words}', anchor='start',
                                      css_class='motion-bold'))
        return motion.stage('/parameter_events', self.sentence, self.text, (_WIDTH, height), parts, reel)

    @staticmethod
    def _y(number: int, count: int, rows: int) -> float:
        """Return where the middle of a box is; fewer boxes than rows stand in the middle."""
        return _TOP + ((rows - count) / 2 + number + .5) * _ROW

    @staticmethod
    def _heads() -> Iterator[str]:
        for x, title in ((_LEFT_X + _BOX_WIDTH / 2, 'publish'), (_RIGHT_X + _BOX_WIDTH / 2, 'subscribe')):
            yield motion.label(x, 24, title, css_class='motion-bold')

    def _roads(self, left: Mapping[str, float], right: Mapping[str, float]) -> Iterator[str]:
        for name, y in left.items():
            css_class = 'motion-line' if name == self._sender else 'motion-thin'
            yield motion.arrow(_LEFT_X + _BOX_WIDTH + 4, y, _TOPIC_X - 3, y, css_class)
        for name, y in right.items():
            begin, end = _TOPIC_X + _TOPIC_WIDTH + 3, _RIGHT_X - 4
            if self._listens[name]:
                yield motion.arrow(begin, y, end, y, 'motion-line' if self._sender else 'motion-thin')
            else:
                x = begin + 22
                yield motion.path(f'M{begin} {y}H{end}', 'motion-dashed')
                yield motion.path(f'M{x - 6} {y - 6}l12 12M{x + 6} {y - 6}l-12 12', 'motion-cross')

    def _node(self, x: float, y: float, name: str) -> Iterator[str]:
        yield motion.box(x, y - _BOX / 2, _BOX_WIDTH, _BOX,
                         'motion-token' if name == self._sender else 'motion-blank')
        yield motion.label(x + _BOX_WIDTH / 2, y + 4.5, motion.cut(name, _LETTERS), css_class='motion-code')

    def _listener(self, y: float, name: str, arrived_sec: float, reel: motion.Reel) -> Iterator[str]:
        hears = self._listens[name]
        yield motion.box(_RIGHT_X, y - _BOX / 2, _BOX_WIDTH, _BOX, 'motion-blank')
        told = not hears or bool(self._sender)
        yield motion.label(_RIGHT_X + _BOX_WIDTH / 2, y - 3 if told else y + 4.5, motion.cut(name, _LETTERS),
                           css_class='motion-code')
        if not hears:
            yield motion.label(_RIGHT_X + _BOX_WIDTH / 2, y + 13, 'gets nothing: incompatible QoS',
                               css_class='motion-small')
        elif self._sender:
            x = _RIGHT_X + _BOX_WIDTH / 2 - 20
            yield motion.group([motion.path(f'M{x - 8} {y + 8}l3.5 4l6 -8', 'motion-check'),
                                motion.label(x + 8, y + 13, 'gets it', anchor='start', css_class='motion-small')],
                               reel.appear(arrived_sec))

    def _messages(self, from_y: float, middle_y: float, right: Mapping[str, float],
                  reel: motion.Reel) -> Iterator[str]:
        topic_x = _TOPIC_X + _TOPIC_WIDTH / 2
        there_sec = _LEAVE_SEC + _TO_TOPIC_SEC
        leaves_sec = there_sec + _AT_TOPIC_SEC
        yield motion.group(_envelope(), reel.travel_and_go(
            [(0, _LEFT_X + _BOX_WIDTH, from_y), (_LEAVE_SEC, _LEFT_X + _BOX_WIDTH, from_y),
             (_LEAVE_SEC + .7 * _TO_TOPIC_SEC, _TOPIC_X, from_y), (there_sec, topic_x, middle_y),
             (leaves_sec, topic_x, middle_y)]))
        for name, y in right.items():
            if not self._listens[name]:
                continue
            stops = [(leaves_sec, topic_x, middle_y), (leaves_sec + .4 * _TO_EARS_SEC, _TOPIC_X + _TOPIC_WIDTH, y),
                     (leaves_sec + _TO_EARS_SEC, _RIGHT_X - 4, y)]
            frames = [(0.0, 'opacity:0;' + motion.place(*stops[0][1:])), (leaves_sec - .01, 'opacity:0;'
                      + motion.place(*stops[0][1:]))]
            frames += [(at_sec, 'opacity:1;' + motion.place(x, at_y)) for at_sec, x, at_y in stops]
            yield motion.group(_envelope(), reel.track(frames))


def _envelope() -> str:
    """Return a letter whose middle is at 0, 0."""
    return motion.box(-15, -10, 30, 20, 'motion-token', rounding=2) + motion.path('M-15 -9l15 11l15 -11', 'motion-line')


def _joined(names: Iterator[str] | Sequence[str]) -> str:
    return ', '.join(names) or 'nobody'

