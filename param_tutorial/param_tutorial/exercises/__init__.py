"""The exercises of the chapters: a check that runs a learner's code against a real node, and hints.

    exercises.check('3a', Rover)      what is done, what is not yet, and where to look
    exercises.hint('3a')              one hint; run it again for the next

One module for each chapter holds its exercises, each as a list of requirements: a sentence, and a small function
that tries it out. Stubs stand in the chapters, solutions in ``notebooks/solutions/``; neither is repeated here.

    ch03, ch04, …   the exercises
    exercise        what an exercise is, and how its check runs
    trial           a corner of the stage for the learner's nodes, cleared afterwards
    results         the answer, as text and as HTML
"""

from typing import Any

from param_tutorial.errors import nearest
from param_tutorial.exercises.chapters import (
    ch01,
    ch02,
    ch03,
    ch04,
    ch05_1,
    ch05_2,
    ch05_3,
    ch06,
    ch07_1,
    ch07_2,
    ch07_3,
    ch08,
    ch09,
    ch10_1,
    ch10_2,
    ch10_3,
    ch10_4,
    ch11,
)
from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.results import Answer, Hint, Result

CHAPTERS = (ch01, ch02, ch03, ch04, ch05_1, ch05_2, ch05_3, ch06, ch07_1, ch07_2, ch07_3, ch08, ch09, ch10_1, ch10_2,
            ch10_3, ch10_4, ch11)
EXERCISES: dict[str, Exercise] = {each.number: each for module in CHAPTERS for each in module.EXERCISES}

_FORGOTTEN = object()
_hints_given: dict[str, int] = {}


def check(number: str = '', work: Any = _FORGOTTEN) -> Answer:
    """Try out a learner's work on a real node, requirement by requirement.

    Never raises for what the work does: an exception, a callback that does not return, or something that is no work
    at all is told in the answer. The stage is afterwards as it was.

    :param number: Of the exercise, e.g. '3a' or '5.2b'.
    :param work: What the exercise asks for: a class, a function, a dictionary, a text.
    """
    exercise = EXERCISES.get(str(number))
    if exercise is None:
        return _unknown(number)
    return exercise.without_work() if work is _FORGOTTEN else exercise.check(work)


def hint(number: str = '') -> Answer:
    """Return the next hint for an exercise; after the last one, where its solution is."""
    exercise = EXERCISES.get(str(number))
    if exercise is None:
        return _unknown(number)
    given = _hints_given[number] = _hints_given.get(number, 0) + 1
    if given > len(exercise.hints):
        return Answer(f'There are no more hints for exercise {number}. A worked solution is in '
                      f'{exercise.solutions}.')
    return Hint(number, given, exercise.hints)


def _unknown(number: Any) -> Answer:
    return Answer(f'There is no exercise {number!r}{nearest(str(number), list(EXERCISES), "There are none")}')


__all__ = ['CHAPTERS', 'EXERCISES', 'Answer', 'Hint', 'Result', 'check', 'hint']
