"""Inside a lesson's kernel: records what an exercise's check says to all that a page's form lets a reader answer.

Each answer is handed to the real check. Where blanks take Python values, the check says the same to any two values of a
type that are neither right nor a common mistake, and repeats the value; so one of each type stands for the others.
"""

import ast
import io
import itertools
import tokenize
from collections.abc import Sequence
from typing import Any

from param_tools.markup.tables import with_code
from param_tutorial.exercises import EXERCISES
from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.forms import Blanks, Combination, Order
from param_tutorial.exercises.results import markup
from param_tutorial.site.recording.recorded import Recording

# What nobody writes, and where it stands for others, the page puts theirs in its place.
_STRANGERS = (987654321, 98765.4321, 'qwertz', ['qwertz'])
_THEIRS = '{given}'
# What every type of few values has, and no value at all.
_COMMON: tuple[Any, ...] = (..., True, False, None, [])


class _Asked:
    """What the check has said."""

    def __init__(self, exercise: Exercise) -> None:
        self.exercise = exercise
        self.items: dict[tuple[str, str], int] = {}
        """What became of a requirement as a word and as HTML, and pictures; each with its number."""
        self.times = 0

    def ask(self, work: Any) -> list[int]:
        """Return the numbers of what is said to a work; of a picture at the end."""
        result = self.exercise.check(work)
        self.times += 1
        said = [(each.word, markup(each)) for each in result.findings]
        if result.picture:
            said.append(('picture', result.picture))
        return [self.number(*each) for each in said]

    def number(self, word: str, html: str) -> int:
        return self.items.setdefault((word, html), len(self.items))


def record(number: str, source: str, solution: str) -> Recording:
    """Record the answers to an exercise.

    :param number: Of an exercise that has a form.
    :param source: The exercise's cell, which assigns what is to be filled in.
    :param solution: That of its solution.
    """
    exercise = EXERCISES[number]
    asked = _Asked(exercise)
    if isinstance(exercise.form, Blanks):
        facts = _blanks(asked, exercise.form, source, solution)
    elif isinstance(exercise.form, Order):
        facts = _order(asked, exercise.form, source)
    elif isinstance(exercise.form, Combination):
        facts = _settings(asked, exercise.form)
    else:
        raise ValueError(f'exercise {number} has no form')
    return {'kind': 'answers', 'number': number, 'total': len(exercise.requirements), 'asked': asked.times,
            'items': list(asked.items), **facts}


def _blanks(asked: _Asked, form: Blanks, source: str, solution: str) -> Recording:
    right = assigned(solution)
    values = {name: _values(form, name, guesses, right.get(name, ...) if isinstance(right, dict) else ...)
              for name, guesses in form.guesses.items()}
    rounds = max(map(len, values.values()))
    answers: dict[str, dict[str, int]] = {name: {} for name in values}
    others: dict[str, dict[str, int]] = {name: {} for name in values}
    for at in range(rounds):
        given = {name: each[min(at, len(each) - 1)] for name, each in values.items()}
        for (name, value), said in zip(given.items(), asked.ask(form.make_work(given)), strict=True):
            if any(value is each for each in _STRANGERS):
                word, html = list(asked.items)[said]
                html = html.replace(with_code(f'`{value!r}`'), f'<code>{_THEIRS}</code>')
                others[name][type(value).__name__] = asked.number(word, html)
            else:
                answers[name][_key(form, value)] = said
    notes = notes_in(source)
    return {'form': 'blanks', 'choices': list(form.choices), 'word': form.word, 'is_text': form.is_text,
            'fields': [{'name': name, 'note': notes.get(name, ''), 'shown': form.shown.get(name, ''),
                        'answers': answers[name], 'others': others[name]} for name in form.guesses]}


def _values(form: Blanks, name: str, guesses: Sequence[Any], right: Any) -> list[Any]:
    """Return all values to try for a blank."""
    if form.choices:
        return [..., *form.choices]
    if form.is_text:
        return [form.shown.get(name, ''), *guesses]
    guesses = [list(each) if isinstance(each, tuple) else each for each in (right, *guesses)]
    return [*_COMMON, *guesses, *([form.word] if form.word else []), *_STRANGERS]


def _key(form: Blanks, value: Any) -> str:
    """Return a value as the page's script has it."""
    return '' if value is ... else str(value) if form.is_text or form.choices else repr(value)


def _order(asked: _Asked, form: Order, source: str) -> Recording:
    shown = assigned(source)
    lines = list(form.letters or (shown if isinstance(shown, list) else shown.strip('\n').splitlines()))

    def work(order: Sequence[int]) -> Any:
        chosen = [lines[each] for each in order]
        if form.letters:
            return ''.join(chosen)
        return chosen if isinstance(shown, list) else '\n' + '\n'.join(chosen) + '\n'

    return {'form': 'order', 'is_code': not form.letters,
            'lines': [f'{letter}: {text}' for letter, text in form.letters.items()] if form.letters else lines,
            'answers': {'.'.join(map(str, order)): asked.ask(work(order))
                        for order in itertools.permutations(range(len(lines)))}}


def _settings(asked: _Asked, form: Combination) -> Recording:
    answers = {}
    for numbers in itertools.product(*(range(len(values)) for values in form.choices.values())):
        chosen = {name: values[at] for (name, values), at in zip(form.choices.items(), numbers)}
        answers['.'.join(map(str, numbers))] = asked.ask(form.make_work(chosen))
    return {'form': 'settings', 'answers': answers,
            'fields': [{'name': name, 'choices': [_word(each) for each in values],
                        'start': list(values).index(form.start[name])} for name, values in form.choices.items()]}


def _word(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)


def assigned(source: str) -> Any:
    """Return the value that a cell assigns.

    :raises ValueError: it assigns none that is written out.
    """
    found = next((each.value for each in ast.parse(source).body if isinstance(each, ast.Assign)), None)
    if found is None:
        raise ValueError(f'no assignment in {source!r}')
    return ast.literal_eval(found)


def notes_in(source: str) -> dict[str, str]:
    """Return the comments of a cell by the string with which their line begins."""
    notes, name, line = {}, '', 0
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.STRING and token.start[0] != line:
            name, line = ast.literal_eval(token.string), token.start[0]
        elif token.type == tokenize.COMMENT and token.start[0] == line:
            notes[name] = token.string.lstrip('# ')
    return notes
