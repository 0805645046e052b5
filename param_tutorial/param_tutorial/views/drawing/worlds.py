"""Two worlds beside each other: who keeps a parameter's values, and what is left of them when a node is killed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import WIDTH, Diagram, Moving

_TOP, _BOTTOM = 34, 28
_MARGIN, _MIDDLE_GAP, _BOX, _GAP, _NODE_WIDTH, _BESIDE = 14, 20, 62, 22, 158, 20
_WORLD_WIDTH = (WIDTH - 2 * _MARGIN - _MIDDLE_GAP) / 2
_LETTERS, _SERVER_LETTERS = 18, 38
_SET_SEC, _TRAVEL_SEC, _KILL_SEC, _NEW_SEC, _GET_SEC = 0.5, 0.9, 2.0, 3.2, 3.8
_GOT_SEC = _GET_SEC + _TRAVEL_SEC
_SERVER_FOOT = _TOP + _BOX


@dataclass(frozen=True)
class World:
    """Some nodes, one of which is killed and started again."""

    title: str
    values: Mapping[str, str]
    """What each node has set the parameter to."""
    killed: str
    """The node that is killed."""
    successor: str
    """What the new node of that name begins with."""
    server: str = ''
    """Who keeps the values of all nodes, which is then only one; empty if each node keeps its own."""

    def text(self, name: str) -> str:
        """Return in words what becomes of a parameter."""
        kept = [f'{self.server} keeps {node}/{name} = {value}' if self.server else f'{node} keeps {name} = {value}'
                for node, value in self.values.items()]
        came = f'{self.killed} is killed; a new {self.killed} starts with {name} = {self.successor}'
        return f'{self.title}: {"; ".join([*kept, came])}.'


def draw_worlds(name: str, worlds: Sequence[World]) -> Diagram:
    """Draw what becomes of one parameter when a node is killed and started again, in one world or two.

    At rest a killed node stands crossed out beside its successor.
    """
    left = [f'{world.title}: the new {world.killed} has {world.successor}' for world in worlds]
    rows = max((len(world.values) + bool(world.server) for world in worlds), default=1)
    diagram = Diagram(name, f'{"; ".join(left)}.' if left else 'There is no world yet.',
                      ' '.join([f'Who keeps {name}.', *(world.text(name) for world in worlds)]),
                      _TOP + rows * (_BOX + _GAP) - _GAP + _BOTTOM)
    for number, world in enumerate(worlds):
        x, top = _MARGIN + number * (_WORLD_WIDTH + _MIDDLE_GAP), float(_TOP)
        diagram.add(svg.words(x, 22, world.title, 'big', anchor='start'))
        if world.server:
            _add_server(diagram, world, x)
            top += _BOX + _GAP
        for node, value in world.values.items():
            _add_node(diagram, world, node, value, x, top)
            top += _BOX + _GAP
    if len(worlds) > 1:
        diagram.add(svg.path(f'M{WIDTH / 2} 8V{diagram.height - 8}', 'thin'))
    return diagram


def _add_server(diagram: Diagram, world: World, left: float) -> None:
    """Add the server, with the value that the node below it has set."""
    value = world.values[world.killed]
    stored = svg.cut(f'{world.killed}/{diagram.subject} = {value}', _SERVER_LETTERS)
    diagram.add(svg.box(left, _TOP, _WORLD_WIDTH, _BOX),
                svg.words(left + 12, _TOP + 22, f'{world.server}: keeps all values', 'bold', anchor='start'))
    diagram.show(_SET_SEC + _TRAVEL_SEC - .2, svg.words(left + 12, _TOP + 46, stored, 'code', anchor='start'))


def _add_node(diagram: Diagram, world: World, node: str, value: str, left: float, top: float) -> None:
    middle, beside = left + _NODE_WIDTH / 2, left + _NODE_WIDTH + _BESIDE
    diagram.add(svg.box(left, top, _NODE_WIDTH, _BOX, 'blank'))
    if node == world.killed:
        # Below the words, which stay legible.
        diagram.show(_KILL_SEC, svg.box(left, top, _NODE_WIDTH, _BOX, 'token-bad'), svg.cross(left + 18, top + 31, 8))
    diagram.add(svg.words(middle, top + 46, *(('keeps nothing', 'small') if world.server else (f'= {value}', 'code'))),
                svg.words(middle, top + 22, svg.cut(node, _LETTERS), 'code'))
    if world.server:
        diagram.add(svg.arrow(middle, top - 2, middle, _SERVER_FOOT + 2),
                    Moving(svg.token(svg.cut(value, 8)), goes=True, stops=[
                        (_SET_SEC, middle, top + _BOX / 2), (_SET_SEC + _TRAVEL_SEC, middle, _SERVER_FOOT - 16)]))
    if node == world.killed:
        gone = 'killed' if world.server else f'killed, and {value} with it'
        diagram.show(_KILL_SEC, svg.words(middle, top + _BOX + 15, gone, 'small'))
        _add_successor(diagram, world, beside, top)
    else:
        diagram.show(_KILL_SEC + .4, svg.words(beside, top + _BOX / 2 + 4.5, 'still there', 'small', anchor='start'))


def _add_successor(diagram: Diagram, world: World, left: float, top: float) -> None:
    width = _WORLD_WIDTH - _NODE_WIDTH - _BESIDE
    middle, got = left + width / 2, f'{"gets" if world.server else "="} {world.successor}'
    diagram.show(_NEW_SEC, svg.box(left, top, width, _BOX, 'token'),
                 svg.words(middle, top + 22, svg.cut(f'new {world.killed}', _LETTERS), 'code'))
    diagram.show(_GOT_SEC, svg.words(middle, top + 46, got, 'code'))
    if world.server:
        diagram.show(_GOT_SEC - .2, svg.arrow(middle, _SERVER_FOOT + 2, middle, top - 2))
        diagram.add(Moving(svg.token(svg.cut(world.successor, 8)), from_sec=_GET_SEC - .1, goes=True, stops=[
            (_GET_SEC, middle, _SERVER_FOOT - 16), (_GOT_SEC, middle, top + 40)]))
    else:
        diagram.show(_GOT_SEC, svg.words(middle, top + _BOX + 15, 'from its code', 'small'))
