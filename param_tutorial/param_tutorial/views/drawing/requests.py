"""The same requests beside each other, sent in two ways or in two worlds: what is kept, and what comes back."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_TITLE, _KEEPER_HEAD, _ROW, _NODE, _NOTE, _BOTTOM = 34, 30, 42, 62, 32, 12
_MARGIN, _MIDDLE_GAP = 14, 20
_MOST_SIDES = 2
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


@dataclass(frozen=True)
class _Widths:
    """How wide the parts of a side are, and how many letters go into them."""

    asked: float
    mark: float
    keeper: float
    asked_letters: int
    kept_letters: int
    objection_letters: int
    note_letters: int

    @property
    def side(self) -> float:
        return self.asked + self.mark + self.keeper


_WIDE, _NARROW = _Widths(168, 26, 142, 19, 16, 22, 44), _Widths(140, 24, 108, 15, 12, 17, 34)


class Requests(svg.AnimatedPicture):
    """Requests, sent in one way or two; at rest each row shows a request, its answer, and what was kept afterwards.

    RequestsView explains the arguments.
    """

    _has_narrow = True

    def __init__(self, subject: str) -> None:
        self.subject = subject
        self._sides: list[_Side] = []

    def add(self, title: str, node: str, before: Mapping[str, str], requests: Sequence[Request], *, server: str = '',
            is_one: bool = False) -> None:
        """Add a side.

        :param before: What was kept at first, by name; also of what is not asked for on this side.
        :raises ValueError: there are two sides already.
        """
        self.require_room()
        self._sides.append(_Side(title, node, before, requests, server, is_one))

    def require_room(self) -> None:
        """Raise ValueError if there is no room for another side."""
        if len(self._sides) == _MOST_SIDES:
            raise ValueError(f'there is room for {_MOST_SIDES} sides')

    def conclude(self, note: str) -> None:
        """Say below the last side what it comes to."""
        self._sides[-1].note = note

    @property
    def sentence(self) -> str:
        told = [f'{side.title}: {sum(not each.objection for each in side.requests)} of {len(side.requests)} accepted'
                for side in self._sides]
        return f'{"; ".join(told)}.' if told else 'Nothing has been sent yet.'

    @property
    def text(self) -> str:
        return ' '.join([f'{self.subject}.', *(side.text for side in self._sides)])

    @property
    def _widths(self) -> _Widths:
        return _NARROW if self._is_narrow else _WIDE

    def _beside(self, side: _Side) -> list[_Side]:
        """Return the sides whose rows stand beside those of a side: on a narrow page, sides are below each other."""
        return [side] if self._is_narrow else self._sides

    def _rows(self, side: _Side) -> dict[tuple[str, int], float]:
        """Return where the middle of each row is, which is the same on both sides."""
        keys = dict.fromkeys(key for each in self._beside(side) for key in each.keys)
        return {key: _TITLE + _KEEPER_HEAD + (number + .5) * _ROW for number, key in enumerate(keys)}

    def _keeper_foot(self, side: _Side) -> float:
        return _TITLE + _KEEPER_HEAD + len(self._rows(side)) * _ROW

    def _foot(self, side: _Side) -> float:
        """Return where the boxes end, also that of a node below its server."""
        return self._keeper_foot(side) + (_NODE if any(each.server for each in self._beside(side)) else 0)

    def _side_height(self, side: _Side) -> float:
        return self._foot(side) + (_NOTE if any(each.note for each in self._beside(side)) else _BOTTOM)

    @property
    def _height(self) -> float:
        heights = [self._side_height(side) for side in self._sides] or [_TITLE + _KEEPER_HEAD + _BOTTOM]
        return sum(heights) if self._is_narrow else max(heights)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        x = y = 0.0
        for number, side in enumerate(self._sides):
            if number:
                yield svg.path(f'M8 {y}H{self._width - 8}' if self._is_narrow else
                               f'M{self._width / 2} 8V{self._height - 8}', 'thin')
            yield svg.group(self._side(side, _MARGIN + x, animation), f' transform="translate(0 {y})"' if y else '')
            if self._is_narrow:
                y += self._side_height(side)
            else:
                x += self._widths.side + _MIDDLE_GAP

    def _side(self, side: _Side, left: float, animation: svg.Animation) -> Iterator[str]:
        widths, foot = self._widths, self._keeper_foot(side)
        x, middle = left + widths.asked + widths.mark, left + widths.side - widths.keeper / 2
        end_sec = side.arrival_sec(len(side.requests) - 1) + _STAY_SEC
        yield svg.words(left, 22, side.title, 'big', anchor='start')
        yield svg.box(x, _TITLE, widths.keeper, (foot if side.server else self._foot(side)) - _TITLE)
        yield svg.words(middle, _TITLE + 20, f'{svg.cut(side.keeper, widths.kept_letters - 2)} keeps', 'bold')
        for number in range(len(side.requests)):
            yield from self._row(side, number, left, middle, animation)
        yield from self._journeys(side, left, animation)
        for (name, repeats), y in self._rows(side).items():
            if (name, repeats) not in side.keys and not repeats and name in side.before:
                yield svg.words(middle, y + 1, svg.cut(side.before[name], widths.kept_letters), 'faint')
        if side.server:
            gets = f'gets {svg.cut(side.requests[-1].kept, widths.kept_letters)}'
            yield svg.group([svg.arrow(middle, foot + 1, middle, foot + 19),
                             svg.box(x, foot + 20, widths.keeper, _NODE - 22, 'blank'),
                             svg.words(middle, foot + 37, svg.cut(side.node, widths.kept_letters), 'bold'),
                             svg.words(middle, foot + 53, gets)], animation.appear(end_sec - _STAY_SEC / 2))
        if side.note:
            yield svg.words(left, self._foot(side) + 22, svg.cut(side.note, widths.note_letters), 'bold',
                            anchor='start', style=animation.appear(end_sec))

    def _row(self, side: _Side, number: int, left: float, middle: float, animation: svg.Animation) -> Iterator[str]:
        widths = self._widths
        request, y, there_sec = side.requests[number], self._rows(side)[side.keys[number]], side.arrival_sec(number)
        answered, here = animation.appear(there_sec), animation.travel([(0.0, left + widths.asked / 2, y)])
        asked = svg.group(self._token(request, 'token'), animation.shown(0, there_sec if request.objection else None))
        if request.objection:
            asked += svg.group(self._token(request, 'token-bad'), animation.shown(there_sec))
        yield svg.group(asked, here)
        x = left + widths.asked + widths.mark / 2
        yield svg.group(svg.cross(x, y) if request.objection else svg.check(x, y, 7), answered)
        before = side.before.get(request.name, '') if side.keys[number][1] == 0 else ''
        kept = svg.cut(request.kept, widths.kept_letters)
        is_new = before != request.kept
        if before and is_new:
            yield svg.words(middle, y + 1, svg.cut(before, widths.kept_letters), 'code',
                            style=animation.shown(0, there_sec))
        yield svg.words(middle, y + 1, kept, 'code', style=animation.shown(there_sec if is_new else 0))
        if request.objection:
            yield svg.words(middle, y + 16, svg.cut(request.objection, widths.objection_letters), 'small',
                            style=answered)
        later = [other for other, each in enumerate(side.requests)
                 if other > number and each.name == request.name and each.kept != request.kept]
        if later:
            # What was kept here is gone.
            yield svg.strike(middle, y - 3.5, kept, animation.appear(side.arrival_sec(later[0])))

    def _journeys(self, side: _Side, left: float, animation: svg.Animation) -> Iterator[str]:
        """Yield what travels to the keeper: each request by itself, or all of them in one frame."""
        widths, numbers = self._widths, range(len(side.requests))
        for together in ([numbers] if side.is_one else [[number] for number in numbers]):
            heights = [self._rows(side)[side.keys[number]] for number in together]
            tokens = [svg.group(self._token(side.requests[number], side.requests[number].kind),
                                animation.travel([(0.0, 0.0, y)])) for number, y in zip(together, heights)]
            if side.is_one:
                frame = f'{min(heights) - 19}h{widths.asked}V{max(heights) + 19}h{-widths.asked}z'
                tokens.insert(0, svg.path(f'M{-widths.asked / 2} {frame}', 'dashed'))
                yield svg.path(f'M{left} {frame}', 'dashed')
            from_x, there_sec = left + widths.asked / 2, side.arrival_sec(together[-1])
            leaves_sec = there_sec - _TRAVEL_SEC
            if any(side.requests[number].objection for number in together):
                stops = [(leaves_sec + .6 * _TRAVEL_SEC, from_x + widths.mark, 0.0), (there_sec, from_x, 0.0)]
            else:
                stops = [(there_sec, from_x + widths.asked / 2 + widths.mark, 0.0)]
            yield svg.group(tokens, animation.travel([(leaves_sec, from_x, 0.0), *stops], from_sec=leaves_sec - .05,
                                                     goes=True))

    def _token(self, request: Request, kind: str) -> str:
        # The heading has the name already.
        words = request.value if request.name == self.subject else f'{request.name} = {request.value}'
        return svg.token(svg.cut(words, self._widths.asked_letters), kind)
