"""The ladder that a value climbs down on its way into a node, and up again when the node rejects it.

Time runs from top to bottom, as in a table. Drawn from what was recorded (``set_recorder``), slower than it happened:
the node itself is done in less than a thousandth of a second.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from param_tutorial.views.drawing import svg
from param_tutorial.views.drawing.diagram import Diagram, Moving, Seen

_TOP, _ROW, _BOTTOM = 46, 44, 16
_NAME_X, _LADDER_X, _RAIL, _MARK_X, _WORDS_X, _STORED_X = 14, 206, 44, 272, 294, 700
_VALUE_LETTERS, _STORED_LETTERS, _WORDS_LETTERS = 9, 14, 44
_CLIMB_SEC, _STAY_SEC, _RETURN_SEC = 0.45, 0.55, 0.7

# From the top down: the word of the recorded step, and what stands beside the rung.
_RUNGS = (('asked', 'request'), ('pre-set', 'pre-set callbacks'), ('checks', "rclpy's own checks"),
          ('on-set', 'on-set callbacks'), ('stored', 'stored'), ('event', '/parameter_events'),
          ('post-set', 'post-set callbacks'), ('answer', 'answer'))
_CHECKS = 2
_STORED = 4


@dataclass(frozen=True)
class Step:
    """One moment of a change on its way through a node, as ``set_recorder`` has recorded it."""

    what: str
    """In a word or two, e.g. 'on-set'."""
    happened: str
    """As a sentence, e.g. 'validate: sees 300, accepts'."""
    stored: str
    """The value that the parameter had at this moment."""
    who: str = ''
    """The callback that was called; empty if none was."""
    proposed: str = ''
    """The value on its way when the moment is over; empty if it does not change."""
    objection: str = ''
    """Why the value gets no further, e.g. the callback's reason; empty if it does."""


@dataclass(frozen=True)
class _Rung:
    """What became of the value at one rung."""

    title: str
    words: str
    stored: str
    value: str
    """On its way beyond this rung."""
    mark: str
    """'passed', 'rejected', 'idle' if there was nothing to pass, 'unreached'."""


def draw_ladder(node: str, name: str, steps: Sequence[Step], objection: str = '') -> Diagram:
    """Draw one set of a parameter as a value on the ladder; at rest it is where it has got to, or back at the top.

    :param steps: What happened, as it was recorded.
    :param objection: Why the node did not take the value; empty if it did.
    """
    rungs = list(_rungs(name, steps, objection))
    reached = [rung for rung in rungs if rung.mark != 'unreached']
    is_answered = steps[-1].what != 'no answer'
    request = f'{name} = {svg.cut(rungs[0].value, 40)}'
    if not is_answered:
        sentence = f'{request}: an exception at {reached[-1].title}, and the caller gets no answer.'
    elif objection:
        sentence = f'{request} is rejected at {reached[-1].title}.'
    else:
        stored = reached[-1].stored
        sentence = f'{request} is accepted' + (f', and {stored} is stored.' if stored != rungs[0].value else '.')
    text = '. '.join(f'{number}, {rung.title}: {rung.words}; stored is {rung.stored}'
                     for number, rung in enumerate(reached, start=1))
    foot = _y(len(_RUNGS) - 1) + _ROW / 2
    diagram = Diagram(node, sentence, f'The ladder of {node}. {sentence} {text}.', foot + _BOTTOM)
    left, right = _LADDER_X - _RAIL, _LADDER_X + _RAIL
    # Below this line nobody can say no.
    border = _y(_STORED) - _ROW / 2
    diagram.add(
        svg.path(f'M{left} {foot + 4}V{_TOP - 16}M{right} {foot + 4}V{_TOP - 16}', 'thick'),
        svg.path(''.join(f'M{left} {_y(index) + 17}H{right}' for index in range(len(_RUNGS)))),
        svg.words(_NAME_X, 22, 'rung', 'bold', anchor='start'),
        svg.words(_WORDS_X, 22, 'what happens', 'bold', anchor='start'),
        svg.words(_STORED_X, 22, f'stored {svg.cut(name, 22)}', 'bold', anchor='end'),
        svg.path(f'M{right + 8} {border}H{_STORED_X}', 'dashed'),
        svg.words(_STORED_X - 60, border + 15, 'too late to reject', 'faint', anchor='end'))
    arrivals = [index * (_CLIMB_SEC + _STAY_SEC) for index in range(len(_RUNGS))]
    before = rungs[0].stored
    for index, rung in enumerate(rungs):
        kind = 'faint' if rung.mark in ('unreached', 'idle') else 'bold'
        diagram.add(svg.paragraph(_NAME_X, _y(index) + 4, svg.in_two_lines(rung.title, 17), kind, anchor='start'))
        if rung in reached:
            diagram.show(arrivals[index] + .3 * _STAY_SEC,
                         *_beside(_y(index), rung, is_new=index > 0 and rung.stored != before))
        before = rung.stored
    is_rejected = bool(objection) and not any(step.what == 'stored' for step in steps)
    diagram.add(_value(reached, arrivals, is_rejected=is_rejected, is_answered=is_answered))
    return diagram


def _y(index: int) -> float:
    """Return where the middle of a rung is; the first is at the top."""
    return _TOP + _ROW * index + 10.0


def _beside(y: float, rung: _Rung, *, is_new: bool) -> Iterator[str]:
    """Yield what happens at a rung, and what is stored then."""
    yield {'passed': svg.check(_MARK_X, y), 'rejected': svg.cross(_MARK_X, y)}.get(
        rung.mark, svg.path(f'M{_MARK_X - 6} {y}h10', 'thin'))
    yield svg.paragraph(_WORDS_X, y + 4.5, svg.in_two_lines(rung.words, _WORDS_LETTERS),
                        'bold' * (rung.mark == 'rejected'), anchor='start')
    stored = svg.cut(rung.stored, _STORED_LETTERS)
    yield svg.words(_STORED_X, y + 4.5, stored, 'value' if is_new else 'faint', anchor='end')
    if is_new:
        width = svg.LETTER_WIDTH * len(stored) + 14
        yield svg.box(_STORED_X - width + 7, y - 13, width, 26, 'line')


def _value(reached: Sequence[_Rung], arrivals: Sequence[float], *, is_rejected: bool, is_answered: bool) -> Moving:
    """Return the value: it climbs down, may change on its way, and goes back from where it is rejected."""
    asked, last = reached[0].value, len(reached) - 1
    stops = [(0.0, _y(0))]
    for index in range(1, last + 1):
        stops += [(arrivals[index] - _CLIMB_SEC, _y(index - 1)), (arrivals[index], _y(index))]
    # The values that it has on its way, each with the moment from which it has it.
    faces = [(0.0, asked, 'token')]
    faces += [(arrivals[index] + .5 * _STAY_SEC, rung.value, 'token') for index, rung in enumerate(reached)
              if rung.value != reached[max(0, index - 1)].value]
    if is_rejected:
        leaves_sec = arrivals[last] + _STAY_SEC
        faces.append((leaves_sec - .2, asked, 'token-bad'))
        if is_answered:  # otherwise nothing comes back to the caller
            stops += [(leaves_sec, _y(last)), (leaves_sec + _RETURN_SEC, _y(0))]
    ends_sec = [*(from_sec for from_sec, _, _ in faces[1:]), None]
    return Moving([Seen(svg.token(svg.cut(value, _VALUE_LETTERS), kind), from_sec, to_sec)
                   for (from_sec, value, kind), to_sec in zip(faces, ends_sec)],
                  [(at_sec, _LADDER_X, y) for at_sec, y in stops])


def _rungs(name: str, steps: Sequence[Step], objection: str) -> Iterator[_Rung]:
    by_rung = {what: [step for step in steps if step.what == what] for what, _ in _RUNGS}
    last = len(_RUNGS) - 1
    if objection:
        stopped = [index for index, (what, _) in enumerate(_RUNGS[:-1])
                   if any(step.objection for step in by_rung[what])]
        # rclpy's own checks leave no trace but the answer.
        last = stopped[-1] if stopped else _CHECKS
    asked = value = steps[0].proposed
    stored = steps[0].stored
    for index, (what, title) in enumerate(_RUNGS):
        here = by_rung[what]
        value = next((step.proposed for step in reversed(here) if step.proposed), value)
        if index > last:
            yield _Rung(title, '', stored, value, 'unreached')
            continue
        stored = here[-1].stored if here else stored
        if objection and index == last:
            yield _Rung(title, _calls(here) if here else objection, stored, value, 'rejected')
            continue
        words = {'asked': f'set {name} to {svg.cut(asked, 24)}', 'checks': 'declared, not read-only, type, range, step',
                 'stored': f'{svg.cut(value, 24)} is written', 'event': 'a message tells everybody',
                 'answer': 'successful'}.get(what) or _calls(here)
        yield _Rung(title, words, stored, value, 'passed' if here or index == _CHECKS else 'idle')


def _calls(steps: Sequence[Step]) -> str:
    """Return in words what the callbacks of one rung said."""
    parts = []
    for step in steps:
        if step.objection.startswith('raises '):
            parts.append(f'{step.who} {step.objection}')
        elif step.objection:
            parts.append(f'{step.who} rejects: {step.objection}')
        elif step.what == 'on-set':
            parts.append(f'{step.who} accepts')
        elif step.what == 'pre-set':
            parts.append(f'{step.who} gives {svg.cut(step.proposed, 20)}' if step.proposed else step.happened)
        else:
            parts.append(f'{step.who} acts on {svg.cut(step.proposed, 20)}')
    return '; '.join(parts) or 'there is none'

