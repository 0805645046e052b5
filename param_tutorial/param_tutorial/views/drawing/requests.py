"""The same requests beside each other, sent in two ways or in two worlds: what is kept, and what comes back."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_TITLE, _KEEPER_HEAD, _ROW, _NODE, _NOTE, _BOTTOM = 34, 30, 42, 62, 32, 12
_MARGIN, _MIDDLE_GAP, _ASKED_WIDTH, _MARK_WIDTH = 14, 20, 168, 26
_SIDE_WIDTH = (svg.AnimatedPicture._width - 2 * _MARGIN - _MIDDLE_GAP) / 2
_KEEPER_WIDTH = _SIDE_WIDTH - _ASKED_WIDTH - _MARK_WIDTH
_MOST_SIDES = 2
_ASKED_LETTERS, _KEPT_LETTERS, _OBJECTION_LETTERS, _NOTE_LETTERS = 19, 16, 22, 44
_BEGIN_SEC, _TRAVEL_SEC, _STAY_SEC = 0.6, 0.8, 0.6


@dataclass(frozen=True)
class Request:
    """A value for a parameter, and what came of it."""

    name: str
    value: str
    """What was asked for."""
    kept: str
    """What was there afterwards."""
    objection: str = ''
    """Why it was rejected; empty if it was accepted."""

    @property
    def kind(self) -> str:
        """What its token looks like after the answer."""
        return 'token-bad' if self.objection else 'token'


@dataclass
class _Side:
    title: str
    node: str
    before: Mapping[str, str]
    requests: Sequence[Request]
    server: str
    is_one: bool
    note: str = ''

    @property
    def keys(self) -> list[tuple[str, int]]:
        """For each request its name, and how many of that name were before it."""
        names = [each.name for each in self.requests]
        return [(name, names[:number].count(name)) for number, name in enumerate(names)]

    @property
    def keeper(self) -> str:
        return self.server or self.node

    @property
    def text(self) -> str:
        told = [f'{each.name} = {each.value} is ' + (f'rejected ({each.objection})' if each.objection else 'accepted')
                + f', and {self.keeper} keeps {each.kept}' for each in self.requests]
        if self.server:
            told.append(f'{self.node} gets {self.requests[-1].kept} from {self.server}')
        together = 'one request: ' if self.is_one else ''
        return f'{self.title}, {together}{"; ".join([*told, *filter(None, [self.note])])}.'

    def arrival_sec(self, number: int) -> float:
        """Return when a request has come to its keeper."""
        before = 0 if self.is_one else number
        return _BEGIN_SEC + before * (_TRAVEL_SEC + _STAY_SEC) + _TRAVEL_SEC


class Requests(svg.AnimatedPicture):
    """Requests, sent in one way or two; at rest each row shows a request, its answer, and what was kept afterwards.

    RequestsView explains the arguments.
    """

    def __init__(self, subject: str) -> None:
        self.subject = subject
        self._sides: list[_Side] = []

    def add(self, title: str, node: str, before: Mapping[str, str], requests: Sequence[Request], *, server: str = '',
            is_one: bool = False) -> None:
        """Add a side.

        :param before: What was kept at first, by name; also of what is not asked for on this side.
        :raises ValueError: there are two sides already, or there is no request.
        """
        self.require_room()
        if not requests:
            raise ValueError('a side of Requests takes one request at least')
        self._sides.append(_Side(title, node, before, requests, server, is_one))

    def require_room(self) -> None:
        """Raise ValueError if there is no room for another side."""
        if len(self._sides) == _MOST_SIDES:
            raise ValueError(f'there is room for {_MOST_SIDES} sides')

    def conclude(self, note: str) -> None:
        """Say below the last side what it comes to.

        :raises ValueError: there is no side yet.
        """
        if not self._sides:
            raise ValueError('add a side before you conclude it')
        self._sides[-1].note = note

    @property
    def sentence(self) -> str:
        """How many were accepted on each side."""
        told = [f'{side.title}: {sum(not each.objection for each in side.requests)} of {len(side.requests)} accepted'
                for side in self._sides]
        return f'{"; ".join(told)}.' if told else 'Nothing has been sent yet.'

    @property
    def text(self) -> str:
        return ' '.join([f'{self.subject}.', *(side.text for side in self._sides)])

    @property
    def _rows(self) -> dict[tuple[str, int], float]:
        """Where the middle of each row is, which is the same on both sides."""
        keys = dict.fromkeys(key for side in self._sides for key in side.keys)
        return {key: _TITLE + _KEEPER_HEAD + (number + .5) * _ROW for number, key in enumerate(keys)}

    @property
    def _keeper_foot(self) -> float:
        return _TITLE + _KEEPER_HEAD + len(self._rows) * _ROW

    @property
    def _foot(self) -> float:
        """Where the boxes end, also that of a node below its server."""
        return self._keeper_foot + (_NODE if any(side.server for side in self._sides) else 0)

    @property
    def _height(self) -> float:
        return self._foot + (_NOTE if any(side.note for side in self._sides) else _BOTTOM)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        for number, side in enumerate(self._sides):
            yield from self._side(side, _MARGIN + number * (_SIDE_WIDTH + _MIDDLE_GAP), animation)
        if len(self._sides) > 1:
            yield svg.path(f'M{self._width / 2} 8V{self._height - 8}', 'thin')

    def _side(self, side: _Side, left: float, animation: svg.Animation) -> Iterator[str]:
        x, middle, foot = left + _ASKED_WIDTH + _MARK_WIDTH, left + _SIDE_WIDTH - _KEEPER_WIDTH / 2, self._keeper_foot
        end_sec = side.arrival_sec(len(side.requests) - 1) + _STAY_SEC
        yield svg.words(left, 22, side.title, 'big', anchor='start')
        yield svg.box(x, _TITLE, _KEEPER_WIDTH, (foot if side.server else self._foot) - _TITLE)
        yield svg.words(middle, _TITLE + 20, f'{svg.cut(side.keeper, 14)} keeps', 'bold')
        for number in range(len(side.requests)):
            yield from self._row(side, number, left, middle, animation)
        yield from self._journeys(side, left, animation)
        for (name, repeats), y in self._rows.items():
            if (name, repeats) not in side.keys and not repeats and name in side.before:
                yield svg.words(middle, y + 1, svg.cut(side.before[name], _KEPT_LETTERS), 'faint')
        if side.server:
            gets = f'gets {svg.cut(side.requests[-1].kept, _KEPT_LETTERS)}'
            yield svg.group([svg.arrow(middle, foot + 1, middle, foot + 19),
                             svg.box(x, foot + 20, _KEEPER_WIDTH, _NODE - 22, 'blank'),
                             svg.words(middle, foot + 37, svg.cut(side.node, 16), 'bold'),
                             svg.words(middle, foot + 53, gets)], animation.appear(end_sec - _STAY_SEC / 2))
        if side.note:
            yield svg.words(left, self._foot + 22, svg.cut(side.note, _NOTE_LETTERS), 'bold', anchor='start',
                            style=animation.appear(end_sec))

    def _row(self, side: _Side, number: int, left: float, middle: float, animation: svg.Animation) -> Iterator[str]:
        request, y, there_sec = side.requests[number], self._rows[side.keys[number]], side.arrival_sec(number)
        answered, here = animation.appear(there_sec), animation.travel([(0.0, left + _ASKED_WIDTH / 2, y)])
        asked = svg.group(self._token(request, 'token'), animation.shown(0, there_sec if request.objection else None))
        if request.objection:
            asked += svg.group(self._token(request, 'token-bad'), animation.shown(there_sec))
        yield svg.group(asked, here)
        x = left + _ASKED_WIDTH + _MARK_WIDTH / 2
        yield svg.group(svg.cross(x, y) if request.objection else svg.check(x, y, 7), answered)
        before = side.before.get(request.name, '') if side.keys[number][1] == 0 else ''
        kept = svg.cut(request.kept, _KEPT_LETTERS)
        is_new = before != request.kept
        if before and is_new:
            yield svg.words(middle, y + 1, svg.cut(before, _KEPT_LETTERS), 'code', style=animation.shown(0, there_sec))
        yield svg.words(middle, y + 1, kept, 'code', style=animation.shown(there_sec if is_new else 0))
        if request.objection:
            yield svg.words(middle, y + 16, svg.cut(request.objection, _OBJECTION_LETTERS), 'small', style=answered)
        later = [other for other, each in enumerate(side.requests)
                 if other > number and each.name == request.name and each.kept != request.kept]
        if later:
            # What was kept here is gone.
            yield svg.strike(middle, y - 3.5, kept, animation.appear(side.arrival_sec(later[0])))

    def _journeys(self, side: _Side, left: float, animation: svg.Animation) -> Iterator[str]:
        """Yield what travels to the keeper: each request by itself, or all of them in one frame."""
        numbers = range(len(side.requests))
        for together in ([numbers] if side.is_one else [[number] for number in numbers]):
            heights = [self._rows[side.keys[number]] for number in together]
            tokens = [svg.group(self._token(side.requests[number], side.requests[number].kind),
                                animation.travel([(0.0, 0.0, y)])) for number, y in zip(together, heights)]
            if side.is_one:
                frame = f'{min(heights) - 19}h{_ASKED_WIDTH}V{max(heights) + 19}h{-_ASKED_WIDTH}z'
                tokens.insert(0, svg.path(f'M{-_ASKED_WIDTH / 2} {frame}', 'dashed'))
                yield svg.path(f'M{left} {frame}', 'dashed')
            from_x, there_sec = left + _ASKED_WIDTH / 2, side.arrival_sec(together[-1])
            leaves_sec = there_sec - _TRAVEL_SEC
            if any(side.requests[number].objection for number in together):
                stops = [(leaves_sec + .6 * _TRAVEL_SEC, from_x + _MARK_WIDTH, 0.0), (there_sec, from_x, 0.0)]
            else:
                stops = [(there_sec, from_x + _ASKED_WIDTH / 2 + _MARK_WIDTH, 0.0)]
            yield svg.group(tokens, animation.travel([(leaves_sec, from_x, 0.0), *stops], from_sec=leaves_sec - .05,
                                                     goes=True))

    def _token(self, request: Request, kind: str) -> str:
        # The heading has the name already.
        words = request.value if request.name == self.subject else f'{request.name} = {request.value}'
        return svg.token(svg.cut(words, _ASKED_LETTERS), kind)
