"""Service calls: a request travels from the node that asks to the node that answers, and the answer comes back.

Time goes down the picture. At rest every message lies where it has arrived, or where its way has ended.
"""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg

_TOP, _BOTTOM, _GAP = 12, 18, 16
_ASKER_X, _NODE_X, _BOX_WIDTH = 14, 536, 170
_LANE_X, _LANE_END = _ASKER_X + _BOX_WIDTH + 4, _NODE_X - 4
_HEAD, _LINE, _PAD, _BETWEEN, _NO_ANSWER, _PROBLEM_LINE = 24, 18, 6, 10, 20, 16
_CARD_LETTERS, _PROBLEM_LETTERS = 36, 46
_MOST_LINES = 4
# Where a message ends up that nobody takes, as a part of the lane that is left to it.
_LOST = .62
_BEGIN_SEC, _READ_SEC, _TRAVEL_SEC, _WORK_SEC, _STAY_SEC = 0.3, 0.5, 0.9, 0.4, 0.6


@dataclass(frozen=True)
class Line:
    """One line of an answer."""

    words: str
    accepted: bool | None = None
    """What the node decided; None where there was nothing to decide."""


@dataclass(frozen=True)
class Call:
    """One call of a service, and what came of it."""

    node: str
    """Whom the request is for."""
    service: str
    request: tuple[str, ...]
    """What the request carries, one thing to a line."""
    answer: tuple[Line, ...] = ()
    problem: str = ''
    """Why no answer came, in a sentence; empty if one did."""
    is_delivered: bool = True
    """False if there is nobody to take the request."""

    @property
    def sentence(self) -> str:
        """What came of it, in short."""
        if not self.is_delivered:
            return f'Nobody takes the request {self.service} for {self.node}.'
        if self.problem:
            return f'{self.node} gets the request {self.service}, and no answer comes.'
        rejected = sum(each.accepted is False for each in self.answer)
        told = f', {rejected} of {len(self.answer)} rejected' if rejected else ''
        return f'{self.node} answers {self.service}{told}.'

    @property
    def why(self) -> str:
        """The problem as a sentence with its beginning and its end."""
        return self.problem[:1].upper() + self.problem[1:] + ('.' if self.problem[-1:] not in '.?' else '')

    @property
    def text(self) -> str:
        """The whole of it in words."""
        carried = '; '.join(self.request) or 'nothing'
        came = self.why or f'The answer carries {"; ".join(each.words for each in self.answer)}.'
        return f'The request {self.service} to {self.node} carries {carried}. {self.sentence} {came}'

    @property
    def height(self) -> float:
        """How much room its row takes in the picture."""
        request = _HEAD + _card_height(self.request) + _BETWEEN
        if not self.problem:
            return request + _card_height(self.answer) + 4
        return request + _NO_ANSWER * self.is_delivered + _PROBLEM_LINE * len(textwrap.wrap(self.why, _PROBLEM_LETTERS))


class Calls(svg.AnimatedPicture):
    """Calls of one node, one after the other."""

    def __init__(self, asker: str, calls: Sequence[Call] = ()) -> None:
        """
        :param asker: The node that asks, or what stands for it.
        :param calls: Those of the beginning.
        """
        self.subject = asker
        self._calls = list(calls)

    def add(self, call: Call) -> None:
        self._calls.append(call)

    @property
    def sentence(self) -> str:
        return self._calls[-1].sentence if self._calls else 'Nothing has been asked yet.'

    @property
    def text(self) -> str:
        return ' '.join([f'Service calls of {self.subject}.', *(call.text for call in self._calls)])

    @property
    def _height(self) -> float:
        return _TOP + _BOTTOM + max(40, sum(call.height + _GAP for call in self._calls) - _GAP)

    def _parts(self, animation: svg.Animation) -> Iterator[str]:
        yield svg.named_box(_ASKER_X, _TOP, _BOX_WIDTH, self._height - _TOP - _BOTTOM, self.subject, 'asks', 'box',
                            rounding=8)
        top, begin_sec = float(_TOP), _BEGIN_SEC
        for call in self._calls:
            yield from _row(call, top, begin_sec, animation)
            top += call.height + _GAP
            begin_sec += _READ_SEC + 2 * _TRAVEL_SEC + _WORK_SEC + _STAY_SEC


def _row(call: Call, top: float, begin_sec: float, animation: svg.Animation) -> Iterator[str]:
    note, kind = ('', 'blank') if call.is_delivered else ('not there', 'dashed')
    yield svg.group([svg.words((_LANE_X + _LANE_END) / 2, top + 14, call.service, 'code'),
                     svg.named_box(_NODE_X, top, _BOX_WIDTH, call.height, call.node, note, kind, rounding=8)],
                    animation.appear(begin_sec))
    leaves_sec, there_sec = begin_sec + _READ_SEC, begin_sec + _READ_SEC + _TRAVEL_SEC
    request = [Line(each) for each in call.request] or [Line('(nothing)')]
    yield from _journey(_Card(request), top + _HEAD, leaves_sec, animation, is_lost=not call.is_delivered)
    y = top + _HEAD + _card_height(request) + _BETWEEN
    if not call.problem:
        yield from _journey(_Card(call.answer), y, there_sec + _WORK_SEC, animation, is_back=True)
        return
    problem = []
    if call.is_delivered:
        problem += [svg.cross(_LANE_X + 14, y + 4), svg.words(_LANE_X + 30, y + 9, 'no answer', 'bold', anchor='start')]
        y += _NO_ANSWER
    problem += [svg.words(_LANE_X + 6, y + 10 + _PROBLEM_LINE * number, line, 'small', anchor='start')
                for number, line in enumerate(textwrap.wrap(call.why, _PROBLEM_LETTERS))]
    yield svg.group(problem, animation.appear(there_sec + _WORK_SEC * call.is_delivered))


class _Card:
    """A card with some lines; the last one says how much does not fit on it."""

    def __init__(self, lines: Sequence[Line]) -> None:
        kept = lines if len(lines) <= _MOST_LINES else lines[:_MOST_LINES - 1]
        self._lines = [Line(svg.cut(line.words, _CARD_LETTERS), line.accepted) for line in kept]
        if len(kept) < len(lines):
            self._lines.append(Line(f'… and {len(lines) - len(kept)} more'))
        self.is_bad = all(line.accepted is False for line in self._lines)
        self.width = max(44.0, *(1.06 * svg.LETTER_WIDTH * len(line.words) + (20 if line.accepted is None else 38)
                                 for line in self._lines))
        self.height = _card_height(self._lines)

    def drawn(self, kind: str) -> Iterator[str]:
        """Yield the card, around 0, 0."""
        yield svg.box(-self.width / 2, -self.height / 2, self.width, self.height, kind, rounding=8)
        x = 10 - self.width / 2
        for number, line in enumerate(self._lines):
            y = _PAD + _LINE * (number + .5) - self.height / 2
            if line.accepted is not None:
                yield svg.check(x + 5, y, 5) if line.accepted else svg.cross(x + 5, y, 4.5)
            yield svg.words(x if line.accepted is None else x + 18, y + 4.5, line.words, 'value', anchor='start')


def _journey(card: _Card, top: float, leaves_sec: float, animation: svg.Animation, *, is_back: bool = False,
             is_lost: bool = False) -> Iterator[str]:
    """Yield a card that travels, and the road that it leaves behind.

    :param is_back: Whether it travels to the left, to the node that has asked.
    :param is_lost: Whether it stops before it has arrived.
    """
    half, y, there_sec = card.width / 2, top + card.height / 2, leaves_sec + _TRAVEL_SEC
    ahead, begin, end = (-1, _LANE_END, _LANE_X) if is_back else (1, _LANE_X, _LANE_END)
    from_x, to_x = begin + ahead * half, end - ahead * (half + 6)
    if is_lost:
        to_x = from_x + (to_x - from_x) * _LOST
        yield svg.group(svg.cross((to_x + half + end) / 2, y), animation.appear(there_sec))
    if ahead * (to_x - begin) > half + 12:
        yield svg.group(svg.arrow(begin, y, to_x - ahead * (half + 1), y), animation.appear(there_sec - .2))
    yield svg.group(card.drawn('token-bad' if card.is_bad or is_lost else 'token'), animation.travel(
        [(leaves_sec, from_x, y), (there_sec, to_x, y)], from_sec=leaves_sec - .1))


def _card_height(lines: Sequence[object]) -> float:
    return _LINE * min(max(1, len(lines)), _MOST_LINES) + 2 * _PAD
