"""Service calls: a request travels from the node that asks to the node that answers, and the answer comes back.

Time goes down the picture. At rest every message lies where it has arrived, or where its way has ended.
"""

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram

_TOP, _BOTTOM, _GAP = 12, 18, 16
_ASKER_X, _NODE_X, _BOX_WIDTH = 14, 536, 170
_LANE_X, _LANE_END = _ASKER_X + _BOX_WIDTH + 4, _NODE_X - 4
_HEAD, _LINE, _PAD, _BETWEEN, _NO_ANSWER, _PROBLEM_LINE = 24, 18, 6, 10, 20, 16
_CARD_LETTERS, _PROBLEM_LETTERS = 36, 46
# Where a message ends up that nobody takes, as a part of the lane that is left to it.
_LOST = .62
_BEGIN_SEC, _READ_SEC, _WORK_SEC, _STAY_SEC = 0.3, 0.5, 0.4, 0.6


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
        rejections = f', {rejected} of {len(self.answer)} rejected' if rejected else ''
        return f'{self.node} answers {self.service}{rejections}.'

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


def draw_calls(asker: str, calls: Sequence[Call]) -> Diagram:
    """Draw calls of one node, one after the other.

    :param asker: The node that asks, or what stands for it.
    """
    diagram = Diagram(asker, calls[-1].sentence if calls else 'Nothing has been asked yet.',
                      ' '.join([f'Service calls of {asker}.', *(call.text for call in calls)]),
                      _TOP + _BOTTOM + max(40, sum(map(_height, calls)) + _GAP * (len(calls) - 1)))
    diagram.add(svg.named_box(_ASKER_X, _TOP, _BOX_WIDTH, diagram.height - _TOP - _BOTTOM, asker, 'asks', 'box',
                              rounding=8))
    top, begin_sec = float(_TOP), _BEGIN_SEC
    for call in calls:
        begin_sec = _add_call(diagram, call, top, begin_sec) + _STAY_SEC
        top += _height(call) + _GAP
    return diagram


def _add_call(diagram: Diagram, call: Call, top: float, begin_sec: float) -> float:
    """Add a call, and return when its answer has come."""
    note, kind = ('', 'blank') if call.is_delivered else ('not there', 'dashed')
    diagram.show(begin_sec, svg.words((_LANE_X + _LANE_END) / 2, top + 14, call.service, 'code'),
                 svg.named_box(_NODE_X, top, _BOX_WIDTH, _height(call), call.node, note, kind, rounding=8))
    request = [Line(each) for each in call.request] or [Line('(nothing)')]
    there_sec = _add_card(diagram, request, top + _HEAD, begin_sec + _READ_SEC, is_lost=not call.is_delivered)
    y, answers_sec = top + _HEAD + _card_height(request) + _BETWEEN, there_sec + _WORK_SEC
    if not call.problem:
        return _add_card(diagram, call.answer, y, answers_sec, is_back=True)
    if call.is_delivered:
        diagram.show(answers_sec, svg.cross(_LANE_X + 14, y + 4),
                     svg.words(_LANE_X + 30, y + 9, 'no answer', 'bold', anchor='start'))
        y += _NO_ANSWER
    diagram.show(answers_sec, *(svg.words(_LANE_X + 6, y + 10 + _PROBLEM_LINE * number, line, 'small', anchor='start')
                                for number, line in enumerate(textwrap.wrap(call.why, _PROBLEM_LETTERS))))
    return answers_sec


def _add_card(diagram: Diagram, lines: Sequence[Line], top: float, leaves_sec: float, *, is_back: bool = False,
              is_lost: bool = False) -> float:
    """Add a card with some lines that travels, and return when it arrives.

    :param is_back: Whether it travels to the left, to the node that has asked.
    :param is_lost: Whether it stops before it has arrived.
    """
    shown = [Line(svg.cut(line.words, _CARD_LETTERS), line.accepted) for line in lines]
    is_bad = is_lost or all(line.accepted is False for line in shown)
    half = max(44.0, *(1.06 * svg.LETTER_WIDTH * len(line.words) + (20 if line.accepted is None else 38)
                       for line in shown)) / 2
    height = _card_height(lines)
    card = [svg.box(-half, -height / 2, 2 * half, height, 'token-bad' if is_bad else 'token', rounding=8)]
    for number, line in enumerate(shown):
        x, y = 10 - half, _PAD + _LINE * (number + .5) - height / 2
        if line.accepted is not None:
            card.append(svg.check(x + 5, y, 5) if line.accepted else svg.cross(x + 5, y, 4.5))
            x += 18
        card.append(svg.words(x, y + 4.5, line.words, 'value', anchor='start'))
    y, ahead, begin, end = top + height / 2, 1, _LANE_X, _LANE_END
    if is_back:
        ahead, begin, end = -1, end, begin
    from_x, to_x = begin + ahead * half, end - ahead * (half + 6)
    if is_lost:
        to_x = from_x + (to_x - from_x) * _LOST
    there_sec = diagram.journey(''.join(card), half, begin, from_x, to_x, y, leaves_sec)
    if is_lost:
        diagram.show(there_sec, svg.cross((to_x + half + end) / 2, y))
    return there_sec


def _height(call: Call) -> float:
    """Return how much room a call takes in the picture."""
    height = _HEAD + _card_height(call.request) + _BETWEEN
    if not call.problem:
        return height + _card_height(call.answer) + 4
    return height + _NO_ANSWER * call.is_delivered + _PROBLEM_LINE * len(textwrap.wrap(call.why, _PROBLEM_LETTERS))


def _card_height(lines: Sequence[object]) -> float:
    return _LINE * max(1, len(lines)) + 2 * _PAD
