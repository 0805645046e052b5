"""Two worlds beside each other: who keeps a parameter's values, and what is left of them when a node is killed."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from param_tutorial.pictures import motion

_WIDTH, _TOP, _BOTTOM = 720, 34, 28
_MARGIN, _MIDDLE_GAP, _BOX, _GAP, _NODE_WIDTH, _BESIDE = 14, 20, 62, 22, 158, 20
_WORLD_WIDTH = (_WIDTH - 2 * _MARGIN - _MIDDLE_GAP) / 2
_MOST_WORLDS = 2
_LETTERS, _SERVER_LETTERS = 18, 38
_SET_SEC, _TRAVEL_SEC, _KILL_SEC, _NEW_SEC, _GET_SEC = 0.5, 0.9, 2.0, 3.2, 3.8


@dataclass(frozen=True)
class _World:
    title: str
    server: str
    values: dict[str, str]
    """By node."""
    killed: str
    successor: str

    def text(self, name: str) -> str:
        kept = [f'{self.server} keeps {node}/{name} = {value}' if self.server else f'{node} keeps {name} = {value}'
                for node, value in self.values.items()]
        came = f'{self.killed} is killed; a new {self.killed} starts with {name} = {self.successor}'
        return f'{self.title}: {"; ".join([*kept, came])}.'


class Worlds:
    """What becomes of one parameter when a node is killed and started again, in one world or two.

    WorldsView (``widgets.pictured``) explains the arguments.
    """

    def __init__(self, name: str) -> None:
        self.subject = name
        self._worlds: list[_World] = []

    def add(self, title: str, values: Mapping[str, Any], *, killed: str, successor: Any, server: str = '') -> None:
        """Add a world."""
        if len(self._worlds) == _MOST_WORLDS:
            raise ValueError(f'there is room for {_MOST_WORLDS} worlds')
        if killed not in values:
            raise ValueError(f'{killed!r} is not one of the nodes {list(values)}')
        if server and len(values) > 1:
            raise ValueError(f'below a server there is room for one node, not for {list(values)}')
        self._worlds.append(_World(title, server, {node: str(value) for node, value in values.items()}, killed,
                                   str(successor)))

    @property
    def sentence(self) -> str:
        """What is left in each world."""
        left = [f'{world.title}: the new {world.killed} has {world.successor}' for world in self._worlds]
        return f'{"; ".join(left)}.' if left else 'There is no world yet.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return ' '.join([f'Who keeps {self.subject}.', *(world.text(self.subject) for world in self._worlds)])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest a killed node stands crossed out beside its successor."""
        rows = max((len(world.values) + bool(world.server) for world in self._worlds), default=1)
        height = _TOP + rows * (_BOX + _GAP) - _GAP + _BOTTOM
        parts: list[str] = []
        for number, world in enumerate(self._worlds):
            parts += self._world(world, _MARGIN + number * (_WORLD_WIDTH + _MIDDLE_GAP), reel)
        if len(self._worlds) > 1:
            parts.append(motion.path(f'M{_WIDTH / 2} 8V{height - 8}', 'motion-thin'))
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    def _world(self, world: _World, left: float, reel: motion.Reel) -> Iterator[str]:
        yield motion.label(left, 22, world.title, anchor='start', css_class='motion-big')
        top = _TOP + 0.0
        if world.server:
            yield motion.box(left, top, _WORLD_WIDTH, _BOX)
            yield motion.label(left + 12, top + 22, f'{world.server}: keeps all values', anchor='start',
                               css_class='motion-bold')
            told = motion.cut(f'{world.killed}/{self.subject} = {world.values[world.killed]}', _SERVER_LETTERS)
            yield motion.group(motion.label(left + 12, top + 46, told, anchor='start', css_class='motion-code'),
                               reel.appear(_SET_SEC + _TRAVEL_SEC - .2))
            top += _BOX + _GAP
        for node, value in world.values.items():
            yield from self._node(world, node, value, left, top, reel)
            top += _BOX + _GAP

    def _node(self, world: _World, node: str, value: str, left: float, top: float, reel: motion.Reel) -> Iterator[str]:
        middle, is_killed = left + _NODE_WIDTH / 2, node == world.killed
        kept = motion.label(middle, top + 46, 'keeps nothing' if world.server else f'= {value}',
                            css_class='motion-small' if world.server else 'motion-code')
        yield motion.box(left, top, _NODE_WIDTH, _BOX, 'motion-blank')
        if is_killed:
            # Below the words, which stay legible.
            yield motion.group([motion.box(left, top, _NODE_WIDTH, _BOX, 'motion-token-bad'), motion.path(
                f'M{left + 10:.1f} {top + 23:.1f}l16 16M{left + 26:.1f} {top + 23:.1f}l-16 16', 'motion-cross')],
                reel.appear(_KILL_SEC))
        yield from (kept, motion.label(middle, top + 22, motion.cut(node, _LETTERS), css_class='motion-code'))
        if world.server:
            server_y = _TOP + _BOX
            yield motion.arrow(middle, top - 2, middle, server_y + 2)
            yield motion.group(motion.token(motion.cut(value, 8)), reel.travel_and_go(
                [(0, middle, top + _BOX / 2), (_SET_SEC, middle, top + _BOX / 2),
                 (_SET_SEC + _TRAVEL_SEC, middle, server_y - 16)]))
        if not is_killed:
            yield motion.group(motion.label(left + _NODE_WIDTH + _BESIDE, top + _BOX / 2 + 4.5, 'still there',
                                            anchor='start', css_class='motion-small'), reel.appear(_KILL_SEC + .4))
            return
        gone = 'killed' if world.server else f'killed, and {value} with it'
        yield motion.group(motion.label(middle, top + _BOX + 15, gone, css_class='motion-small'),
                           reel.appear(_KILL_SEC))
        yield from self._successor(world, left + _NODE_WIDTH + _BESIDE, top, reel)

    @staticmethod
    def _successor(world: _World, left: float, top: float, reel: motion.Reel) -> Iterator[str]:
        width = _WORLD_WIDTH - _NODE_WIDTH - _BESIDE
        middle, got_sec = left + width / 2, _GET_SEC + _TRAVEL_SEC
        yield motion.group([motion.box(left, top, width, _BOX, 'motion-token', rounding=4),
                            motion.label(middle, top + 22, motion.cut(f'new {world.killed}', _LETTERS),
                                         css_class='motion-code')], reel.appear(_NEW_SEC))
        yield motion.group(motion.label(middle, top + 46, f'gets {world.successor}' if world.server else
                                        f'= {world.successor}', css_class='motion-code'), reel.appear(got_sec))
        if world.server:
            server_y = _TOP + _BOX
            yield motion.group(motion.arrow(middle, server_y + 2, middle, top - 2), reel.appear(got_sec - .2))
            yield motion.group(motion.group(motion.token(motion.cut(world.successor, 8)), reel.travel_and_go(
                [(0, middle, server_y - 16), (_GET_SEC, middle, server_y - 16), (got_sec, middle, top + 40)])),
                reel.shown(_GET_SEC - .1))
        else:
            yield motion.group(motion.label(middle, top + _BOX + 15, 'from its code', css_class='motion-small'),
                               reel.appear(got_sec))
