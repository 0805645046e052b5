"""The same requests beside each other, sent in two ways or in two worlds: what is kept, and what comes back."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from param_tutorial.pictures import motion

_WIDTH, _TITLE, _KEEPER_HEAD, _ROW, _NODE, _NOTE = 720, 34, 30, 42, 62, 32
_MARGIN, _MIDDLE_GAP, _ASKED_WIDTH, _MARK_WIDTH = 14, 20, 168, 26
_SIDE_WIDTH = (_WIDTH - 2 * _MARGIN - _MIDDLE_GAP) / 2
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


@dataclass
class _Side:
    title: str
    node: str
    before: Mapping[str, str]
    requests: Sequence[Request]
    server: str
    is_one: bool
    note: str = ''
    keys: list[tuple[str, int]] = field(default_factory=list)
    """For each request its name, and how many of that name were before it."""

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


class Requests:
    """Requests, sent in one way or two. RequestsView (``widgets.pictured``) explains the arguments."""

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
        names = [each.name for each in requests]
        keys = [(name, names[:number].count(name)) for number, name in enumerate(names)]
        self._sides.append(_Side(title, node, before, requests, server, is_one, keys=keys))

    def require_room(self) -> None:
        """Raise ValueError if there is no room for another side."""
        if len(self._sides) == _MOST_SIDES:
            raise ValueError(f'there is room for {_MOST_SIDES} sides')

    def conclude(self, note: str) -> None:
        """Say below the last side what it comes to.

        :raises ValueError: there is no side yet.
        """
        if not self._sides:
            raise ValueError('there is no side yet that one could conclude')
        self._sides[-1].note = note

    @property
    def sentence(self) -> str:
        """How many were accepted on each side."""
        told = [f'{side.title}: {sum(not each.objection for each in side.requests)} of {len(side.requests)} accepted'
                for side in self._sides]
        return f'{"; ".join(told)}.' if told else 'Nothing has been sent yet.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return ' '.join([f'{self.subject}.', *(side.text for side in self._sides)])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each row shows a request, its answer, and what was kept afterwards."""
        rows = {key: number for number, key in enumerate(dict.fromkeys(key for side in self._sides
                                                                       for key in side.keys))}
        keeper_height = _KEEPER_HEAD + len(rows) * _ROW
        foot = _NODE if any(side.server for side in self._sides) else 0
        height = _TITLE + keeper_height + foot + (_NOTE if any(side.note for side in self._sides) else 12)
        parts: list[str] = []
        for number, side in enumerate(self._sides):
            left = _MARGIN + number * (_SIDE_WIDTH + _MIDDLE_GAP)
            parts += self._side(side, left, rows, keeper_height, foot, reel)
        if len(self._sides) > 1:
            parts.append(motion.path(f'M{_WIDTH / 2} 8V{height - 8}', 'motion-thin'))
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, height), parts, reel)

    def _side(self, side: _Side, left: float, rows: Mapping[tuple[str, int], int], keeper_height: float, foot: float,
              reel: motion.Reel) -> Iterator[str]:
        x, middle = left + _ASKED_WIDTH + _MARK_WIDTH, left + _SIDE_WIDTH - _KEEPER_WIDTH / 2
        bottom = _TITLE + keeper_height
        end_sec = _arrival(side, len(side.requests) - 1) + _STAY_SEC
        yield motion.label(left, 22, side.title, anchor='start', css_class='motion-big')
        yield motion.box(x, _TITLE, _KEEPER_WIDTH, keeper_height + (0 if side.server else foot))
        yield motion.label(middle, _TITLE + 20, f'{motion.cut(side.keeper, 14)} keeps', css_class='motion-bold')
        heights = [_TITLE + _KEEPER_HEAD + (rows[key] + .5) * _ROW for key in side.keys]
        for number, y in enumerate(heights):
            yield from self._row(side, number, left, y, reel)
        yield from self._journeys(side, left, heights, reel)
        for (name, turn), row in rows.items():
            if (name, turn) not in side.keys and not turn and name in side.before:
                yield motion.label(middle, _TITLE + _KEEPER_HEAD + (row + .5) * _ROW + 1, motion.cut(
                    side.before[name], _KEPT_LETTERS), css_class='motion-faint')
        if side.server:
            yield motion.group([
                motion.arrow(middle, bottom + 1, middle, bottom + 19),
                motion.box(x, bottom + 20, _KEEPER_WIDTH, foot - 22, 'motion-blank'),
                motion.label(middle, bottom + 37, motion.cut(side.node, 16), css_class='motion-bold'),
                motion.label(middle, bottom + 53, f'gets {motion.cut(side.requests[-1].kept, _KEPT_LETTERS)}')],
                reel.appear(end_sec - _STAY_SEC / 2))
        if side.note:
            yield motion.group(motion.label(left, bottom + foot + 22, motion.cut(side.note, _NOTE_LETTERS),
                                            anchor='start', css_class='motion-bold'), reel.appear(end_sec))

    def _row(self, side: _Side, number: int, left: float, y: float, reel: motion.Reel) -> Iterator[str]:
        request, there_sec = side.requests[number], _arrival(side, number)
        x = left + _ASKED_WIDTH
        here = reel.travel([(0.0, left + _ASKED_WIDTH / 2, y)])
        yield motion.group(motion.group(self._token(request, is_bad=False), reel.shown(
            0, there_sec if request.objection else None)), here)
        if request.objection:
            yield motion.group(motion.group(self._token(request, is_bad=True), reel.shown(there_sec)), here)
            mark = motion.path(f'M{x + 7:.1f} {y - 6}l12 12M{x + 19:.1f} {y - 6}l-12 12', 'motion-cross')
        else:
            mark = motion.path(f'M{x + 6:.1f} {y}l5 6l9 -12', 'motion-check')
        yield motion.group(mark, reel.appear(there_sec))
        middle = left + _SIDE_WIDTH - _KEEPER_WIDTH / 2
        before = side.before.get(request.name, '') if side.keys[number][1] == 0 else ''
        kept = motion.cut(request.kept, _KEPT_LETTERS)
        if before == request.kept:
            yield motion.label(middle, y + 1, kept, css_class='motion-code')
        else:
            if before:
                yield motion.group(motion.label(middle, y + 1, motion.cut(before, _KEPT_LETTERS),
                                                css_class='motion-code'), reel.shown(0, there_sec))
            yield motion.group(motion.label(middle, y + 1, kept, css_class='motion-code'), reel.shown(there_sec))
        if request.objection:
            yield motion.group(motion.label(middle, y + 16, motion.cut(request.objection, _OBJECTION_LETTERS),
                                            css_class='motion-small'), reel.appear(there_sec))
        later = [other for other, each in enumerate(side.requests)
                 if other > number and each.name == request.name and each.kept != request.kept]
        if later:
            # What was kept here is gone.
            half = motion.LETTER_WIDTH * .55 * len(kept) + 5
            yield motion.group(motion.path(f'M{middle - half:.1f} {y - 3.5}h{2 * half:.1f}', 'motion-thick'),
                               reel.appear(_arrival(side, later[0])))

    def _journeys(self, side: _Side, left: float, heights: Sequence[float], reel: motion.Reel) -> Iterator[str]:
        """Yield what travels to the keeper: each request by itself, or all of them in one frame."""
        whole = list(range(len(heights)))
        for numbers in ([whole] if side.is_one else [[number] for number in whole]):
            tokens = [motion.group(self._token(side.requests[number], is_bad=bool(side.requests[number].objection)),
                                   reel.travel([(0.0, 0.0, heights[number])])) for number in numbers]
            if side.is_one:
                top, end = min(heights) - 19, max(heights) + 19
                tokens.insert(0, motion.path(f'M{-_ASKED_WIDTH / 2} {top}h{_ASKED_WIDTH}V{end}h{-_ASKED_WIDTH}z',
                                             'motion-dashed'))
                yield motion.path(f'M{left} {top}h{_ASKED_WIDTH}V{end}h{-_ASKED_WIDTH}z', 'motion-dashed')
            from_x, there_sec = left + _ASKED_WIDTH / 2, _arrival(side, numbers[-1])
            leaves_sec = there_sec - _TRAVEL_SEC
            if any(side.requests[number].objection for number in numbers):
                stops = [(leaves_sec + .6 * _TRAVEL_SEC, from_x + _MARK_WIDTH, 0.0), (there_sec, from_x, 0.0)]
            else:
                stops = [(there_sec, from_x + _ASKED_WIDTH / 2 + _MARK_WIDTH, 0.0)]
            yield motion.group(motion.group(tokens, reel.shown(leaves_sec - .05)), reel.travel_and_go(
                [(0.0, from_x, 0.0), (leaves_sec, from_x, 0.0), *stops]))

    def _token(self, request: Request, *, is_bad: bool) -> str:
        # The heading has the name already.
        words = request.value if request.name == self.subject else f'{request.name} = {request.value}'
        return motion.token(motion.cut(words, _ASKED_LETTERS),
                            css_class='motion-token-bad' if is_bad else 'motion-token')


def _arrival(side: _Side, number: int) -> float:
    """Return when a request has come to its keeper."""
    turn = 0 if side.is_one else number
    return _BEGIN_SEC + turn * (_TRAVEL_SEC + _STAY_SEC) + _TRAVEL_SEC
