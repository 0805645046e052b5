"""The checks that a request goes through, one after another, and the first one that stops it."""

import textwrap
from collections.abc import Iterable

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram, Moving

_HEAD, _ROW, _BOTTOM = 48, 42, 8
_WORDS_X, _GATES_X, _PITCH, _STORED_X = 14, 212, 84, 708
_WORDS_LETTERS, _VALUE_LETTERS = 15, 6
_BEGIN_SEC, _READ_SEC, _GATE_SEC, _STAY_SEC = 0.3, 0.4, 0.25, 0.5

# In rclpy's order: what stands above a gate, and the kinds of answers that come from there.
_GATES = {'declared': ('undeclared',), 'read-only': ('read only',), 'type': ('wrong type', 'not deletable'),
          'range': ('out of range',), 'step': ('off the step',), 'on-set callbacks': ('rejected by the node',)}
# How many gates let a request through, by the kind of its answer.
_PASSED = {kind: number for number, kinds in enumerate([*_GATES.values(), ('accepted',)]) for kind in kinds}


def draw_checks(node: str, requests: Iterable[tuple[str, str, str]]) -> Diagram:
    """Draw requests on their way through the checks; at rest each stands before the gate that has stopped it.

    :param requests: Names, values as text, and kinds of answers (``SetResult.kind``).
    """
    requests = list(requests)
    stored = sum(_PASSED[kind] == len(_GATES) for _, _, kind in requests)
    outcomes = '. '.join(_outcome(*request) for request in requests)
    diagram = Diagram(node, f'{stored} of {len(requests)} get through all checks.',
                      f'Checks in their order: {", ".join(_GATES)}. {outcomes}.',
                      _HEAD + len(requests) * _ROW + _BOTTOM, width=748)
    for number, title in enumerate(_GATES):
        diagram.add(svg.paragraph(_gate_x(number), 27, textwrap.wrap(title, 9), 'bold'),
                    svg.path(f'M{_gate_x(number)} {_HEAD - 4}V{diagram.height - _BOTTOM}', 'thin'))
    diagram.add(svg.words(_STORED_X, 27, 'stored', 'bold'))
    begin_sec, y = _BEGIN_SEC, _HEAD + _ROW / 2
    for request in requests:
        begin_sec = _add_request(diagram, y, *request, begin_sec) + _STAY_SEC
        y += _ROW
    return diagram


def _outcome(name: str, value: str, kind: str) -> str:
    passed = list(_GATES)[:_PASSED[kind]]
    if len(passed) == len(_GATES):
        return f'{name} = {value} passes all checks and is stored'
    before = f'passes {", ".join(passed)}, and ' if passed else ''
    return f'{name} = {value} {before}is stopped at {list(_GATES)[len(passed)]}: {kind}'


def _add_request(diagram: Diagram, y: float, name: str, value: str, kind: str, begin_sec: float) -> float:
    """Add a request, and return when it is at the end of its way."""
    passed, leaves_sec = _PASSED[kind], begin_sec + _READ_SEC
    there_sec = leaves_sec + (passed + .2) * _GATE_SEC
    # The value travels; so the name alone will do where both are too long.
    request = f'{name} = {value}' if len(f'{name} = {value}') <= _WORDS_LETTERS else svg.cut(name, _WORDS_LETTERS)
    diagram.show(begin_sec, svg.words(_WORDS_X, y - 2, request, 'code', anchor='start'))
    diagram.show(there_sec, svg.words(_WORDS_X, y + 14, kind, 'small', anchor='start'))
    for number in range(passed):
        diagram.mark(True, _gate_x(number), y, leaves_sec + (number + .6) * _GATE_SEC)
    is_stored, before_gates_x = passed == len(_GATES), _GATES_X - _PITCH / 2 - 1
    if not is_stored:
        diagram.mark(False, _gate_x(passed), y, there_sec)
    end_x = _STORED_X if is_stored else before_gates_x + passed * _PITCH
    diagram.add(Moving(
        svg.token(svg.cut(value, _VALUE_LETTERS), 'token' if is_stored else 'token-bad'),
        [(leaves_sec, before_gates_x, y), (there_sec, end_x, y)], from_sec=begin_sec, easing='linear'))
    return there_sec


def _gate_x(number: int) -> int:
    return _GATES_X + number * _PITCH
