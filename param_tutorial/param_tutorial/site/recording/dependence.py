"""Whose answers depend on another parameter, or on the one that is asked for.

Each answer is recorded from the state in which the lesson shows the node. Samples of them are then asked for again
from other states. Where these differ the page is told so, and gives an answer only in the states in which it was
recorded: those in which one such parameter has a value that hands choose, and some in which several have.
"""

import itertools

from param_tutorial.site.recording.asking import Asker, State
from param_tutorial.site.recording.questions import accepted, is_value, natural, samples, spread
from param_tutorial.site.recording.recorded import RecordedAnswer, Row, key

_CONTEXTS = 2
# In how many states of the others the answers that depend on several are recorded.
_STATES_TOGETHER = 60
# How many values of a parameter are tried to make room for one of another.
_WAYS = 9


def find_dependence(asker: Asker, rows: list[Row]) -> None:
    """Find out which answers depend on which parameter, and record those again from other states.

    :param rows: Those that have answers; they are added to.
    """
    samples_of = {row['name']: samples(row) for row in rows}
    loud = [row for row in rows if not row['quiet']]
    for changed in loud:
        for text in spread(accepted(changed), _CONTEXTS):
            state = asker.enter({changed['name']: text})
            for row in loud:
                if changed['name'] not in row.get('depends', ()):
                    _compare(asker, row, samples_of[row['name']], state, changed['name'])
            asker.leave(state)
    for row in rows:
        others = [other for other in rows if other['name'] in row.get('depends', ())]
        if others:
            _record_dependent(asker, row, others)


def _compare(asker: Asker, row: Row, texts: list[str], state: State, changed: str) -> None:
    """Ask for samples from another state, and note whether that makes a difference."""
    asked = [(asker.ask(row['name'], text, state), row['answers'][text]) for text in texts]
    asker.flush()
    for answer, before in asked:
        if _gist(answer) != _gist(before):
            row.setdefault('depends', []).append(changed)
            return
        if answer['log'] != before['log']:
            row['log_depends'] = True


def _record_dependent(asker: Asker, row: Row, others: list[Row]) -> None:
    """Record the answers once more, from the states in which hands bring the others."""
    contexts = row.setdefault('contexts', {})
    texts = natural(row)
    values = {other['name']: _values(asker, other) for other in others}
    ways = [row['text'], *spread(_values(asker, row), _WAYS)]
    states = [{name: text} for name, taken in values.items() for text in taken]
    for count in range(2, len(others) + 1):
        each = max(2, int(_STATES_TOGETHER ** (1 / count)))
        for names in itertools.combinations(values, count):
            states += [dict(zip(names, taken)) for taken in
                       itertools.product(*(spread(values[name], each) for name in names))]
    for changed in states:
        # A value that needs room is there only together with another one of this parameter.
        if any(asker.show({**changed, row['name']: text}) for text in ways):
            state = asker.read()
            contexts[key(changed)] = {text: asker.ask(row['name'], text, state) for text in texts}
    asker.end_show()


def _values(asker: Asker, row: Row) -> list[str]:
    """Return other values that hands bring a parameter to, also those that the node would take only after others."""
    return [text for text in natural(row) if text != row['text'] and is_value(asker.descriptors[row['name']], text)]


def _gist(answer: RecordedAnswer) -> tuple[str | None, str | None, dict[str, str] | None]:
    return answer.get('value'), answer.get('reason'), answer.get('also')
