"""Two worlds beside each other: who keeps a parameter's values, and what is left of them when a node is killed."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from param_tutorial.views.drawing import svg

_TOP, _BOTTOM = 34, 28
_MARGIN, _MIDDLE_GAP, _BOX, _GAP, _NODE_WIDTH, _BESIDE = 14, 20, 62, 22, 158, 20
_MOST_WORLDS = 2
_LETTERS, _SERVER_LETTERS = 18, 38
_SET_SEC, _TRAVEL_SEC, _KILL_SEC, _NEW_SEC, _GET_SEC = 0.5, 0.9, 2.0, 3.2, 3.8
_GOT_SEC = _GET_SEC + _TRAVEL_SEC


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


class Worlds(svg.AnimatedPicture):
    """What becomes of one parameter when a node is killed and started again, in one world or two.

    At rest a killed node stands crossed out beside its successor. WorldsView explains the arguments.
    """

    _world_width = (svg.AnimatedPicture._width - 2 * _MARGIN - _MIDDLE_GAP) / 2

    def __init__(self, name: str) -> None:
        self.subject = name
        self._worlds: list[_World] = []

    def add(self, title: str, values: Mapping[str, Any], *, killed: str, successor: Any, server: str = '') -> None:
        if len(self._worlds) == _MOST_WORLDS:
            raise ValueError(f'there is room for {_MOST_WORLDS} worlds')
        self._worlds.append(_World(title, server, {node: str(value) for node, value in values.items()}, killed,
                                   str(successor)))

    @property
    def sentence(self) -> str:
        left = [f'{world.title}: the new {world.killed} has {world.successor}' for world in self._worlds]
        return f'{"; ".join(left)}.' if left else 'There is no world yet.'

    @property
    def text(self) -> str:
        return ' '.join([f'Who keeps {self.subject}.', *(world.text(self.subject) for world in self._worlds)])

    @property
    def _height(self) -> float:
        rows = max((len(world.values) + bool(world.server) for world in self._worlds), default=1)
        return _TOP + rows * (_BOX + _GAP) - _GAP + _BOTTOM

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, world in enumerate(self._worlds):
            left, top = _MARGIN + number * (self._world_width + _MIDDLE_GAP), float(_TOP)
            yield svg.words(left, 22, world.title, 'big', anchor='start')
            if world.server:
                yield from self._server(world, left, top, animation)
                top += _BOX + _GAP
            for node in world.values:
                yield from self._node(world, node, left, top, animation)
                top += _BOX + _GAP
        if len(self._worlds) > 1:
            yield svg.path(f'M{self._width / 2} 8V{self._height - 8}', 'thin')

    def _server(self, world: _World, left: float, top: float, animation: svg.Animation) -> Iterator[str]:
        """Yield the server, with the value that the node below it has set."""
        yield svg.box(left, top, self._world_width, _BOX)
        yield svg.words(left + 12, top + 22, f'{world.server}: keeps all values', 'bold', anchor='start')
        value = world.values[world.killed]
        told = svg.cut(f'{world.killed}/{self.subject} = {value}', _SERVER_LETTERS)
        yield svg.words(left + 12, top + 46, told, 'code', anchor='start',
                        style=animation.appear(_SET_SEC + _TRAVEL_SEC - .2))

    def _node(self, world: _World, node: str, left: float, top: float, animation: svg.Animation) -> Iterator[str]:
        middle, beside, value = left + _NODE_WIDTH / 2, left + _NODE_WIDTH + _BESIDE, world.values[node]
        killed = animation.appear(_KILL_SEC)
        yield svg.box(left, top, _NODE_WIDTH, _BOX, 'blank')
        if node == world.killed:
            # Below the words, which stay legible.
            yield svg.group([svg.box(left, top, _NODE_WIDTH, _BOX, 'token-bad'),
                             svg.cross(left + 18, top + 31, 8)], killed)
        yield svg.words(middle, top + 46, *(('keeps nothing', 'small') if world.server else (f'= {value}', 'code')))
        yield svg.words(middle, top + 22, svg.cut(node, _LETTERS), 'code')
        if world.server:
            yield svg.arrow(middle, top - 2, middle, _TOP + _BOX + 2)
            yield svg.group(svg.token(svg.cut(value, 8)), animation.travel(
                [(_SET_SEC, middle, top + _BOX / 2), (_SET_SEC + _TRAVEL_SEC, middle, _TOP + _BOX - 16)], goes=True))
        if node == world.killed:
            gone = 'killed' if world.server else f'killed, and {value} with it'
            yield svg.words(middle, top + _BOX + 15, gone, 'small', style=killed)
            yield from self._successor(world, beside, top, animation)
        else:
            yield svg.words(beside, top + _BOX / 2 + 4.5, 'still there', 'small', anchor='start',
                            style=animation.appear(_KILL_SEC + .4))

    def _successor(self, world: _World, left: float, top: float, animation: svg.Animation) -> Iterator[str]:
        width = self._world_width - _NODE_WIDTH - _BESIDE
        middle, got = left + width / 2, animation.appear(_GOT_SEC)
        yield svg.group([svg.box(left, top, width, _BOX, 'token'),
                         svg.words(middle, top + 22, svg.cut(f'new {world.killed}', _LETTERS), 'code')],
                        animation.appear(_NEW_SEC))
        yield svg.words(middle, top + 46, f'{"gets" if world.server else "="} {world.successor}', 'code', style=got)
        if not world.server:
            yield svg.words(middle, top + _BOX + 15, 'from its code', 'small', style=got)
            return
        server_y = _TOP + _BOX
        yield svg.group(svg.arrow(middle, server_y + 2, middle, top - 2), animation.appear(_GOT_SEC - .2))
        yield svg.group(svg.token(svg.cut(world.successor, 8)), animation.travel(
            [(_GET_SEC, middle, server_y - 16), (_GOT_SEC, middle, top + 40)], from_sec=_GET_SEC - .1, goes=True))
