"""Whose answers depend on another parameter, or on the one that is asked for.

Each answer is recorded from the state in which the lesson shows the node. Samples of them are then asked for again
from other states. Where these differ the page is told so, and gives an answer only in the states in which it was
recorded, of which there are a few more then.
"""

from param_tutorial.lessons.recording.asking import Asker, State
from param_tutorial.lessons.recording.questions import accepted, samples, spread
from param_tutorial.lessons.recording.recorded import Answer, Row

_CONTEXTS = 2
_CONTEXTS_OF_DEPENDENT = 11
_SAMPLES_OF_DEPENDENT = 41


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
        for name in row.get('depends', ()):
            _record_dependent(asker, row, next(each for each in rows if each['name'] == name))


def _compare(asker: Asker, row: Row, texts: list[str], state: State, changed: str) -> None:
    """Ask for samples from another state, and note whether that makes a difference."""
    for text in texts:
        answer, before = asker.ask(row['name'], text, state), row['answers'][text]
        if _gist(answer) != _gist(before):
            row.setdefault('depends', []).append(changed)
            return
        if answer['log'] != before['log']:
            row['log_depends'] = True


def _record_dependent(asker: Asker, row: Row, other: Row) -> None:
    """Record the answers once more, from some of the states in which the other parameter may be."""
    contexts = row.setdefault('contexts', {}).setdefault(other['name'], {})
    # Where it stands, the stretch of the slider, and one of each kind of answer.
    texts = list(dict.fromkeys([row['text'], *spread(row.get('positions') or list(row['answers']),
                                                     _SAMPLES_OF_DEPENDENT), *samples(row)]))
    for text in spread(accepted(other), _CONTEXTS_OF_DEPENDENT):
        state = asker.enter({other['name']: text})
        contexts[other['answers'][text]['value']] = {each: asker.ask(row['name'], each, state) for each in texts}
        asker.leave(state)


def _gist(answer: Answer) -> tuple[str | None, str | None, dict[str, str] | None]:
    return answer.get('value'), answer.get('reason'), answer.get('also')
