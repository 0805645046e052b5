"""Service calls: a request travels from the node that asks to the node that answers, and the answer comes back.

Time goes down the picture. At rest every message lies where it has arrived, or where its way has ended.
"""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from param_tutorial.pictures import motion

_WIDTH, _TOP, _BOTTOM, _GAP = 720, 12, 6, 16
_ASKER_X, _NODE_X, _BOX_WIDTH = 14, 536, 170
_LANE_X, _LANE_END = _ASKER_X + _BOX_WIDTH + 4, _NODE_X - 4
_HEAD, _LINE, _PAD, _BETWEEN, _NO_ANSWER, _PROBLEM_LINE = 24, 18, 6, 10, 20, 16
_NAME_LETTERS, _CARD_LETTERS, _PROBLEM_LETTERS = 20, 36, 46
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
        answer = '; '.join(each.words for each in self.answer)
        came = self.why or f'The answer carries {answer}.'
        return f'The request {self.service} to {self.node} carries {carried}. {self.sentence} {came}'


class Calls:
    """Calls of one node, one after the other."""

    def __init__(self, asker: str, calls: Sequence[Call] = ()) -> None:
        """
        :param asker: The node that asks, or what stands for it.
        :param calls: Those of the beginning.
        """
        self.subject = asker
        self._calls = list(calls)

    def add(self, call: Call) -> None:
        """Add a call."""
        self._calls.append(call)

    @property
    def sentence(self) -> str:
        """What came of the last call."""
        return self._calls[-1].sentence if self._calls else 'Nothing has been asked yet.'

    @property
    def text(self) -> str:
        """The picture in words, as a screen reader tells it."""
        return ' '.join([f'Service calls of {self.subject}.', *(call.text for call in self._calls)])

    def html(self, reel: motion.Reel) -> str:
        """Return the picture; at rest each message lies where its way has ended."""
        y, begin_sec = float(_TOP), _BEGIN_SEC
        parts: list[str] = []
        for call in self._calls:
            height = _height(call)
            parts += _row(call, y, height, begin_sec, reel)
            begin_sec += _READ_SEC + 2 * _TRAVEL_SEC + _WORK_SEC + _STAY_SEC
            y += height + _GAP
        end = max(y - _GAP, _TOP + 40)
        parts += [motion.box(_ASKER_X, _TOP, _BOX_WIDTH, end - _TOP, rounding=8),
                  *_named(_ASKER_X, (_TOP + end) / 2, self.subject, 'asks')]
        return motion.stage(self.subject, self.sentence, self.text, (_WIDTH, int(end + _TOP + _BOTTOM)), parts, reel)


def _height(call: Call) -> float:
    """Return how much room a call takes."""
    head = _HEAD + _card_height(call.request) + _BETWEEN
    if not call.problem:
        return head + _card_height(call.answer) + 4
    return head + (_NO_ANSWER if call.is_delivered else 0) + _PROBLEM_LINE * len(_wrapped(call))


def _row(call: Call, top: float, height: float, begin_sec: float, reel: motion.Reel) -> Iterator[str]:
    there_sec = begin_sec + _READ_SEC + _TRAVEL_SEC
    middle = (_LANE_X + _LANE_END) / 2
    yield motion.group(motion.label(middle, top + 14, call.service, css_class='motion-code'), reel.appear(begin_sec))
    node = [motion.box(_NODE_X, top, _BOX_WIDTH, height, 'motion-blank' if call.is_delivered else 'motion-dashed',
                       rounding=8),
            *_named(_NODE_X, top + height / 2, call.node, '' if call.is_delivered else 'not there')]
    yield motion.group(node, reel.appear(begin_sec))
    request = _shortened([Line(each) for each in call.request] or [Line('(nothing)')])
    y = top + _HEAD + _card_height(request) / 2
    yield from _request(call, request, y, begin_sec + _READ_SEC, reel)
    back_y = top + _HEAD + _card_height(request) + _BETWEEN
    if not call.problem:
        yield from _answer(_shortened(call.answer), back_y, there_sec + _WORK_SEC, reel)
        return
    look = reel.appear(there_sec + (_WORK_SEC if call.is_delivered else 0))
    if call.is_delivered:
        yield motion.group([*_cross(_LANE_X + 14, back_y + 4), motion.label(
            _LANE_X + 30, back_y + 9, 'no answer', anchor='start', css_class='motion-bold')], look)
    foot = back_y + (_NO_ANSWER if call.is_delivered else 0) + 10
    yield motion.group([motion.label(_LANE_X + 6, foot + _PROBLEM_LINE * number, line, anchor='start',
                                     css_class='motion-small') for number, line in enumerate(_wrapped(call))], look)


def _request(call: Call, lines: Sequence[Line], y: float, leaves_sec: float, reel: motion.Reel) -> Iterator[str]:
    """Yield a card that travels to the right, and the road that it leaves behind."""
    half, there_sec = _card_width(lines) / 2, leaves_sec + _TRAVEL_SEC
    start, end = _LANE_X + half, _LANE_END - half - 6
    if not call.is_delivered:
        end = start + (end - start) * _LOST
        yield motion.group(_cross((end + half + _LANE_END) / 2, y), reel.appear(there_sec))
    if end - half > _LANE_X + 12:
        yield motion.group(motion.arrow(_LANE_X, y, end - half - 1, y), reel.appear(there_sec - .2))
    card = _card(lines, 'motion-token' if call.is_delivered else 'motion-token-bad')
    yield motion.group(motion.group(card, reel.shown(leaves_sec - .1)),
                       reel.travel([(0, start, y), (leaves_sec, start, y), (there_sec, end, y)]))


def _answer(lines: Sequence[Line], top: float, leaves_sec: float, reel: motion.Reel) -> Iterator[str]:
    """Yield a card that travels to the left, and the road that it leaves behind."""
    half, y, there_sec = _card_width(lines) / 2, top + _card_height(lines) / 2, leaves_sec + _TRAVEL_SEC
    start, end = _LANE_END - half, _LANE_X + half + 6
    if end + half < _LANE_END - 12:
        yield motion.group(motion.arrow(_LANE_END, y, end + half + 1, y), reel.appear(there_sec - .2))
    all_rejected = all(line.accepted is False for line in lines)
    yield motion.group(motion.group(_card(lines, 'motion-token-bad' if all_rejected else 'motion-token'),
                                    reel.shown(leaves_sec)),
                       reel.travel([(0, start, y), (leaves_sec, start, y), (there_sec, end, y)]))


def _card(lines: Sequence[Line], css_class: str) -> Iterator[str]:
    """Yield a card with some lines, whose middle is at 0, 0."""
    width, height = _card_width(lines), _card_height(lines)
    yield motion.box(-width / 2, -height / 2, width, height, css_class, rounding=8)
    left = -width / 2 + 10
    for number, line in enumerate(lines):
        y = -height / 2 + _PAD + _LINE * (number + .5)
        if line.accepted is not None:
            yield from _check(left + 5, y) if line.accepted else _cross(left + 5, y, 4.5)
        x = left if line.accepted is None else left + 18
        yield motion.label(x, y + 4.5, line.words, anchor='start', css_class='motion-value')


def _check(x: float, y: float) -> Iterator[str]:
    yield motion.path(f'M{x - 5:.1f} {y:.1f}l3.5 4l6 -8', 'motion-check')


def _cross(x: float, y: float, reach: float = 6) -> Iterator[str]:
    yield motion.path(f'M{x - reach:.1f} {y - reach:.1f}l{2 * reach} {2 * reach}'
                      f'M{x + reach:.1f} {y - reach:.1f}l{-2 * reach} {2 * reach}', 'motion-cross')


def _named(x: float, y: float, name: str, note: str) -> Iterator[str]:
    middle = x + _BOX_WIDTH / 2
    yield motion.label(middle, y - 2 if note else y + 4.5, motion.cut(name, _NAME_LETTERS), css_class='motion-code')
    if note:
        yield motion.label(middle, y + 15, note, css_class='motion-small')


def _shortened(lines: Sequence[Line]) -> list[Line]:
    """Return what fits on a card; the last line says how much does not."""
    kept = lines if len(lines) <= _MOST_LINES else lines[:_MOST_LINES - 1]
    rest = [Line(f'… and {len(lines) - len(kept)} more')] if len(kept) < len(lines) else []
    return [*(Line(motion.cut(line.words, _CARD_LETTERS), line.accepted) for line in kept), *rest]


def _card_width(lines: Sequence[Line]) -> float:
    return max(44.0, *(motion.LETTER_WIDTH * 1.06 * len(line.words) + (20 if line.accepted is None else 38)
                       for line in lines))


def _card_height(lines: Sequence[object]) -> float:
    return _LINE * min(max(1, len(lines)), _MOST_LINES) + 2 * _PAD


def _wrapped(call: Call) -> list[str]:
    return textwrap.wrap(call.why, _PROBLEM_LETTERS)
