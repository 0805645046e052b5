"""The same requests beside each other, sent in two ways or in two worlds: what is kept, and what comes back."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import TRAVEL_SEC, WIDTH, Diagram, Moving, Seen

_TITLE, _KEEPER_HEAD, _ROW, _NODE, _NOTE, _BOTTOM = 34, 30, 42, 62, 32, 12
_MARGIN, _MIDDLE_GAP, _ASKED, _MARK, _KEEPER = 14, 20, 168, 26, 142
_SIDE = _ASKED + _MARK + _KEEPER
_ASKED_LETTERS, _KEPT_LETTERS, _OBJECTION_LETTERS, _NOTE_LETTERS = 19, 16, 22, 44
_BEGIN_SEC, _STAY_SEC = 0.6, 0.6


@dataclass(frozen=True)
class SentValue:
    """A value for a parameter, and what came of it."""

    name: str
    value: str
    """What was asked for."""
    kept: str
    """What was there afterwards."""
    objection: str = ''
    """Why it was rejected; empty if it was accepted."""


@dataclass
class Side:
    """Requests that are sent in one way, or in one world."""

    title: str
    node: str
    before: Mapping[str, str]
    """What was kept at first, by name; also of what is not asked for on this side."""
    requests: Sequence[SentValue]
    server: str = ''
    """Who keeps the values for the node; empty if it keeps them itself."""
    is_one: bool = False
    """Whether all requests travel as one."""
    note: str = ''
    """What it comes to."""

    @property
    def keys(self) -> list[tuple[str, int]]:
        """For each request its name, and how many of that name were before it."""
        names = [each.name for each in self.requests]
        return [(name, names[:number].count(name)) for number, name in enumerate(names)]

    @property
    def keeper(self) -> str:
        """Who keeps the values."""
        return self.server or self.node

    @property
    def text(self) -> str:
        """The side in words."""
        outcomes = [f'{each.name} = {each.value} is '
                    + (f'rejected ({each.objection})' if each.objection else 'accepted')
                    + f', and {self.keeper} keeps {each.kept}' for each in self.requests]
        if self.server:
            outcomes.append(f'{self.node} gets {self.requests[-1].kept} from {self.server}')
        together = 'one request: ' if self.is_one else ''
        return f'{self.title}, {together}{"; ".join([*outcomes, *filter(None, [self.note])])}.'

    def arrival_sec(self, number: int) -> float:
        """Return when a request has come to its keeper."""
        before = 0 if self.is_one else number
        return _BEGIN_SEC + before * (TRAVEL_SEC + _STAY_SEC) + TRAVEL_SEC


def draw_requests(subject: str, sides: Sequence[Side]) -> Diagram:
    """Draw requests, sent in one way or two; at rest each row shows one, its answer, and what was kept afterwards.

    :param subject: What the picture is of; a parameter of that name is not named again in each request.
    """
    outcomes = [f'{side.title}: {sum(not each.objection for each in side.requests)} of {len(side.requests)} accepted'
                for side in sides]
    # A parameter has the same row on both sides.
    keys = dict.fromkeys(key for side in sides for key in side.keys)
    rows = {key: _TITLE + _KEEPER_HEAD + (number + .5) * _ROW for number, key in enumerate(keys)}
    foot = _TITLE + _KEEPER_HEAD + len(rows) * _ROW
    all_foot = foot + (_NODE if any(side.server for side in sides) else 0)
    diagram = Diagram(subject, f'{"; ".join(outcomes)}.' if outcomes else 'Nothing has been sent yet.',
                      ' '.join([f'{subject}.', *(side.text for side in sides)]),
                      all_foot + (_NOTE if any(side.note for side in sides) else _BOTTOM))
    for number, side in enumerate(sides):
        left = _MARGIN + number * (_SIDE + _MIDDLE_GAP)
        diagram.add(svg.words(left, 22, side.title, 'big', anchor='start'),
                    svg.box(left + _ASKED + _MARK, _TITLE, _KEEPER, (foot if side.server else all_foot) - _TITLE),
                    svg.words(left + _SIDE - _KEEPER / 2, _TITLE + 20,
                              f'{svg.cut(side.keeper, _KEPT_LETTERS - 2)} keeps', 'bold'))
        _add_requests(diagram, side, left, rows)
        end_sec = side.arrival_sec(len(side.requests) - 1) + _STAY_SEC
        if side.server:
            _add_node(diagram, side, left, foot, end_sec - _STAY_SEC / 2)
        if side.note:
            diagram.show(end_sec, svg.words(left, all_foot + 22, svg.cut(side.note, _NOTE_LETTERS), 'bold',
                                            anchor='start'))
    if len(sides) > 1:
        diagram.add(svg.path(f'M{WIDTH / 2} 8V{diagram.height - 8}', 'thin'))
    return diagram


def _add_node(diagram: Diagram, side: Side, left: float, foot: float, from_sec: float) -> None:
    """Add the node below its server, with what it gets from there."""
    middle = left + _SIDE - _KEEPER / 2
    diagram.show(from_sec, svg.arrow(middle, foot + 1, middle, foot + 19),
                 svg.box(middle - _KEEPER / 2, foot + 20, _KEEPER, _NODE - 22, 'blank'),
                 svg.words(middle, foot + 37, svg.cut(side.node, _KEPT_LETTERS), 'bold'),
                 svg.words(middle, foot + 53, f'gets {svg.cut(side.requests[-1].kept, _KEPT_LETTERS)}'))


def _add_requests(diagram: Diagram, side: Side, left: float, rows: Mapping[tuple[str, int], float]) -> None:
    """Add the requests of a side: where they stand, what travels to the keeper, and what is kept."""
    x, middle = left + _ASKED / 2, left + _SIDE - _KEEPER / 2
    heights = [rows[key] for key in side.keys]
    tokens = []
    for number, (request, y) in enumerate(zip(side.requests, heights, strict=True)):
        # The heading has the name already.
        words = request.value if request.name == diagram.subject else f'{request.name} = {request.value}'
        token, bad = (svg.token(svg.cut(words, _ASKED_LETTERS), kind) for kind in ('token', 'token-bad'))
        there_sec = side.arrival_sec(number)
        faces = [Seen(token, 0, there_sec), Seen(bad, there_sec)] if request.objection else token
        diagram.add(Moving(faces, [(0.0, x, y)]))
        diagram.mark(not request.objection, x + (_ASKED + _MARK) / 2, y, there_sec)
        _add_kept(diagram, side, number, middle, y)
        tokens.append(Moving(bad if request.objection else token, [(0.0, 0.0, y)]))
    for (name, repeats), y in rows.items():
        if (name, repeats) not in side.keys and not repeats and name in side.before:
            diagram.add(svg.words(middle, y + 1, svg.cut(side.before[name], _KEPT_LETTERS), 'faint'))
    if side.is_one:
        frame = f'{min(heights) - 19}h{_ASKED}V{max(heights) + 19}h{-_ASKED}z'
        diagram.add(svg.path(f'M{left} {frame}', 'dashed'))
        _add_journey(diagram, [svg.path(f'M{-_ASKED / 2} {frame}', 'dashed'), *tokens], x, side.arrival_sec(0),
                     is_rejected=any(each.objection for each in side.requests))
        return
    for number, request in enumerate(side.requests):
        _add_journey(diagram, [tokens[number]], x, side.arrival_sec(number), is_rejected=bool(request.objection))


def _add_kept(diagram: Diagram, side: Side, number: int, x: float, y: float) -> None:
    """Add what is kept before a request and after it."""
    request, there_sec = side.requests[number], side.arrival_sec(number)
    before = side.before.get(request.name, '') if side.keys[number][1] == 0 else ''
    kept, is_new = svg.cut(request.kept, _KEPT_LETTERS), before != request.kept
    if before and is_new:
        diagram.show(0, svg.words(x, y + 1, svg.cut(before, _KEPT_LETTERS), 'code'), to_sec=there_sec)
    diagram.show(there_sec if is_new else 0, svg.words(x, y + 1, kept, 'code'))
    if request.objection:
        diagram.show(there_sec, svg.words(x, y + 16, svg.cut(request.objection, _OBJECTION_LETTERS), 'small'))
    later = [other for other, each in enumerate(side.requests)
             if other > number and each.name == request.name and each.kept != request.kept]
    if later:
        # What was kept here is gone.
        diagram.show(side.arrival_sec(later[0]), svg.strike(x, y - 3.5, kept))


def _add_journey(diagram: Diagram, parts: Sequence[str | Moving], x: float, there_sec: float, *,
                 is_rejected: bool) -> None:
    """Add what travels to the keeper and goes into it, or comes back."""
    leaves_sec = there_sec - TRAVEL_SEC
    stops = [(there_sec, x + _ASKED / 2 + _MARK, 0.0)]
    if is_rejected:
        stops = [(leaves_sec + .6 * TRAVEL_SEC, x + _MARK, 0.0), (there_sec, x, 0.0)]
    diagram.add(Moving(parts, [(leaves_sec, x, 0.0), *stops], from_sec=leaves_sec - .05, goes=True))
