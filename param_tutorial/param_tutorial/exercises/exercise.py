"""What an exercise is: requirements, each a sentence and a function that tries it out, and how they are checked."""

import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from rclpy.node import Node

from param_tools import values
from param_tools.errors import ExecutorError, NoAnswerError
from param_tools.markup.tables import with_code
from param_tools.ros import no_input
from param_tutorial.exercises.results import Answer, Finding, Result
from param_tutorial.exercises.trial import (
    CORNER,
    STUCK,
    NotTried,
    NotYet,
    NoUse,
    Trial,
    borrowed_stage,
    cleared,
    describe_error,
    error_if_asked,
    expect,
)

Examine = Callable[[Trial], None]
FindOut = Callable[[Trial], Any]


class Kind(NamedTuple):
    """What a learner hands in."""

    name: str
    fits: Callable[[Any], bool]
    example: str
    """What it may be called."""
    open: Callable[[Any], Any] = lambda work: work
    """Returns what the requirements try out; raises NoUse if there is nothing."""


# What the course itself has derived from Node is not the learner's work.
NODE_CLASS = Kind('a class that you have derived from `Node`, by its name alone and without parentheses',
                  lambda work: inspect.isclass(work) and issubclass(work, Node) and not any(
                      each.__module__.startswith('param_tutorial.') for each in work.__mro__), 'MyNode')
FUNCTION = Kind('a function, by its name alone and without parentheses',
                lambda work: callable(work) and not inspect.isclass(work), 'my_function')
DICTIONARY = Kind('a dictionary, as in the cell above', lambda work: isinstance(work, dict),
                  'my_dictionary')
TEXT = Kind('a string, as in the cell above', lambda work: isinstance(work, str), 'my_text')
LIST = Kind('a list, as in the cell above', lambda work: isinstance(work, (list, tuple)), 'my_list')


# What Python says of a text that is not Python.
_NO_PYTHON = re.compile(r'\b(Syntax|Indentation|Tab)Error\b')
# What people write between the two halves of a word.
_SPACES = str.maketrans('-_', '  ')


class Requirement(NamedTuple):
    """One thing that the work has to do."""

    sentence: str
    see: str
    """The section of the chapter that shows it."""
    examine: Examine
    """Tries it out, and raises NotYet if it is not so."""


class Exercise:
    """One exercise of a chapter."""

    def __init__(self, number: str, title: str, chapter: str, takes: Kind, hints: tuple[str, ...], *,
                 node_name: str = ''):
        """
        :param number: Of the chapter, and a letter: '5.2b'.
        :param title: As in the chapter's heading.
        :param chapter: The name of its notebook, without the ending.
        :param hints: From a nudge to nearly the answer.
        :param node_name: How the learner's node has to be called.
        """
        self.number = number
        self.title = title
        self.chapter = chapter
        # JupyterLab's tabs show the beginning of a name alone: it can't be the chapter's.
        self.solutions = f'solutions/{re.sub(r"(?<=[0-9]_)[a-z].*", "solutions", chapter)}.ipynb'
        self.takes = takes
        self.hints = hints
        self.node_name = node_name
        self.requirements: list[Requirement] = []

    def require(self, sentence: str, *, see: str) -> Callable[[Examine], Examine]:
        """Add the decorated function as a requirement.

        :param sentence: What has to be so, for the learner to read.
        :param see: The section of the chapter that shows it.
        """
        def add(examine: Examine) -> Examine:
            self.requirements.append(Requirement(sentence, see, examine))
            return examine
        return add

    def require_prediction(self, question: str, *, see: str,
                           because: Mapping[Any, str], words: Sequence[str] = (),
                           word: str = '') -> Callable[[FindOut], FindOut]:
        """Add a requirement for a dictionary: that it holds, for a question, what the decorated function finds out.

        It is found out once: what a node of ours says does not depend on the learner's work.

        :param because: For wrong answers that one may well give, what to think of; a tuple stands for a list.
        :param words: Those that the answer is one of, if it is a word; capitals and hyphens do not count.
        :param word: The one that may stand in place of a value; capitals and spaces around it do not count.
        """
        def add(find_out: FindOut) -> FindOut:
            truth: list[Any] = []

            @self.require(f'`{question}`', see=see)
            def examine(trial: Trial) -> None:
                given = trial.work.get(question, ...)
                expect(given is not ..., '', 'there is no prediction yet')
                if isinstance(given, tuple):
                    given = list(given)
                if words:
                    given = str(given).strip(' .').casefold().translate(_SPACES)
                    expect(given in words, ', '.join(f'`{each!r}`' for each in words[:-1]) + f' or `{words[-1]!r}`',
                           f'`{trial.work[question]!r}` is none of these words')
                elif word and isinstance(given, str) and given.strip(' .').casefold() == word:
                    given = word
                # The node's answer is not given away: to look at it is the next step, and the learner's.
                remark = next((f'. {text}' for wrong, text in because.items()
                               if values.same(list(wrong) if isinstance(wrong, tuple) else wrong, given)), '')
                if not truth:
                    truth.append(find_out(trial))
                expect(values.same(truth[0], given), 'what the node says when the check asks it',
                       f'it does not say `{given!r}`{remark or _of_another_type(given, truth[0])}')
            return find_out
        return add

    def without_work(self) -> Answer:
        """Say what a check needs beside the number."""
        return Answer(f'The check of exercise {self.number} needs your work too. Give it {self.takes.name}, like this: '
                      f'`exercises.check({self.number!r}, {self.takes.example})`. The cell below the exercise does.')

    def hint(self, position: int) -> str:
        """Return one of the hints as a sentence, the first for 1; after the last one, where the solution is."""
        count = len(self.hints)
        if position > count:
            return f'There are no more hints for exercise {self.number}. A worked solution is in {self.solutions}.'
        after = f'the next: `exercises.hint({self.number!r})`' if position < count else 'the last'
        return f'Hint {position} of {count} ({after}). {self.hints[position - 1]}'

    def check(self, work: Any, tell: Callable[[Result], object] = lambda _: None) -> Result:
        """Try out a learner's work, and tell before each requirement what was found so far; see ``exercises.check``."""
        if not self.takes.fits(work):
            return self._result([self._nothing_to_try(work)])
        findings: list[Finding] = []

        def untried() -> list[Finding]:
            return [Finding(each.sentence, None) for each in self.requirements[len(findings):]]

        names: set[str] = set()
        picture = ''
        try:
            with no_input.forbidden(error_if_asked), borrowed_stage() as ros:
                trial: Trial | None = None
                for number, requirement in enumerate(self.requirements, 1):
                    tell(Result(self.number, [*findings, *untried()], len(self.requirements),
                                f'Trying {number} of {len(self.requirements)}: {requirement.sentence}'))
                    try:
                        trial = trial or Trial(ros, self.takes.open(work))
                        findings.append(_try_out(requirement, trial))
                        trial.met[requirement.examine] = bool(findings[-1].done)
                    except NoUse as error:
                        findings.append(_finding(requirement, error))
                        break
                    names = set(trial.names)
                picture = trial.picture if trial else ''
        except ExecutorError as error:  # no executor can be had, or a callback of the learner's keeps it for good
            sentences = [*(each.sentence for each in untried()), 'the stage is clear afterwards']
            findings.append(Finding(sentences[0], False, happened=str(error)))
        findings += untried()
        wrong = sorted(names - {self.node_name}) if self.node_name else []
        if wrong:
            findings.insert(0, Finding(f'the node is called `{self.node_name}`', False, f'`{self.node_name}`',
                                       f'it is called `{wrong[0]}`'))
        return self._result(findings, picture)

    def _nothing_to_try(self, work: Any) -> Finding:
        if isinstance(work, (type(None), bool, int, float, str)):
            shown = f'`{work!r:.60}`'
        else:
            shown = f'the class `{work.__name__}`' if inspect.isclass(work) else f'a `{type(work).__name__}`'
        return Finding('there is something to try out', False, self.takes.name, f'the check was given {shown}')

    def _result(self, findings: list[Finding], picture: str = '') -> Result:
        result = Result(self.number, findings, len(self.requirements),
                        f'A worked solution, to compare: {self.solutions}', picture)
        if not result.done:
            begun = any(finding.done for finding in findings)
            result.text = f'For a hint: `exercises.hint({self.number!r})`' if begun else self.hint(1)
        return result

    def help_after(self, result: Result) -> str:
        """Return the hints that a result doesn't hold, each a button within the one before, and a link, as HTML."""
        link, after = f'<a href="{self.solutions}">Open {Path(self.solutions).name}</a>', ''
        if result.done:
            return link
        steps = [(f'Hint {number} of {len(self.hints)}', with_code(each)) for number, each in enumerate(self.hints, 1)]
        for name, inside in reversed([*steps[result.text == self.hint(1):], ('A worked solution', link)]):
            after = f'<details><summary>{name}</summary><p>{inside}</p>{after}</details>'
        return after


def _of_another_type(given: Any, truth: Any) -> str:
    """Say what a prediction is, if that is not the kind of value that the node holds."""
    if isinstance(given, str) and not isinstance(truth, str):
        return '. In quotes it is a string'
    kinds = {bool: 'a boolean', int: 'an integer', float: 'a double'}
    if type(given) in kinds and type(truth) in kinds and type(given) is not type(truth):
        return f'. Written like this, it is {kinds[type(given)]}'
    return ''


def _try_out(requirement: Requirement, trial: Trial) -> Finding:
    """Try out one requirement, with a stage that is then as before.

    :raises NoUse: none of the others can be tried out either.
    """
    trial.begin()
    try:
        with cleared(trial.ros):
            try:
                requirement.examine(trial)
            except NotYet as error:
                if isinstance(error, NoUse) or not (raised := trial.raised()):
                    raise
                # That explains more than what came of it, and the other requirements would raise it, too.
                raise NoUse(error.expected, raised) from None
    except NoUse:
        raise
    except NotTried:
        return Finding(requirement.sentence, None)
    except NotYet as error:
        return _finding(requirement, error)
    except NoAnswerError as error:
        raise NoUse('an answer', trial.raised() or f'{error}. {STUCK}') from None
    except ExecutorError:
        raise
    except (Exception, SystemExit) as error:  # whatever a learner's object may do when it is looked at
        return _finding(requirement, NotYet('', describe_error(error)))
    return Finding(requirement.sentence, True)


def _finding(requirement: Requirement, error: NotYet) -> Finding:
    # No section of a chapter tells of a colon that is missing.
    see = '' if _NO_PYTHON.search(error.happened) else requirement.see
    return Finding(requirement.sentence, False, _without_corner(error.expected), _without_corner(error.happened), see)


def _without_corner(text: str) -> str:
    return text.replace(f'{CORNER}/', '/')
