"""The exercises of the chapters: a check that runs a learner's code against a real node, and hints.

    exercises.check('3b', Rover)      what is done, what is not yet, and where to look
    exercises.hint('3b')              one hint; run it again for the next
    exercises.predict('3-1')          a question, before the cell that answers it
    exercises.recall('4-r1')          a question about an earlier chapter
    exercises.progress('3')           what you have solved of the chapter

One module for each chapter holds its exercises, each as a list of requirements: a sentence, and a small function
that tries it out. Stubs stand in the chapters, solutions in ``notebooks/solutions/``; neither is repeated here.

    chapters        the exercises
    exercise        what an exercise is, and how its check runs
    trial           a corner of the stage for the learner's nodes, cleared afterwards
    steps           the reader's own package as an answer: its driver, and what that tells the robot's base
    programs        a whole program as an answer: a process that is asked, and ended by signals
    results         the answer, as text and as HTML
    questions       the predictions and recalls, as data
    prediction      what a prediction is
    predicting      the widget that asks for one, and what it says afterwards
    chapter_progress  what is solved of a chapter

How an answer gets its verdict. ``check`` finds the exercise by its number. ``Exercise.check`` borrows the stage, and
tries one requirement after the other: each is a function of ``chapters`` that is given a ``Trial``. With that it puts
the learner's nodes into a namespace of their own, asks them through a ``ParameterClient``, and raises ``NotYet`` with
what was expected and what happened; ``NoUse`` ends the check, as nothing else could be tried. The stage is cleared, the
findings become a ``Result``, and ``learner.progress`` keeps what is solved.
"""

import pkgutil
from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import Any

from IPython.display import DisplayHandle

from param_tools.errors import nearest
from param_tools.panel.close_with_cell import this_cell
from param_tutorial.exercises import chapters
from param_tutorial.exercises.chapter_progress import Chapter, ChapterProgress
from param_tutorial.exercises.exercise import Exercise
from param_tutorial.exercises.predicting import PredictionView
from param_tutorial.exercises.prediction import Prediction
from param_tutorial.exercises.results import Answer, Result
from param_tutorial.learner import ticks
from param_tutorial.learner.package_files import passed
from param_tutorial.learner.progress import own_progress


def _chapters() -> Iterator[Chapter]:
    """Yield the chapters in order. Each is a module in ``chapters`` and one of the same name in ``questions``."""
    for name in sorted(module.name for module in pkgutil.iter_modules(chapters.__path__)):
        work, asked = (import_module(f'{__name__}.{folder}.{name}') for folder in ('chapters', 'questions'))
        yield Chapter(work.EXERCISES[0].number.rstrip('abcdefg'), work.CHAPTER, work.EXERCISES, asked.RECALLS,
                      asked.PREDICTIONS, asked.SOLVED)


CHAPTERS = {each.number: each for each in _chapters()}
EXERCISES: dict[str, Exercise] = {each.number: each for chapter in CHAPTERS.values() for each in chapter.exercises}
PREDICTIONS: dict[str, Prediction] = {each.number: each for chapter in CHAPTERS.values()
                                      for each in chapter.predictions}
RECALLS: dict[str, Prediction] = {each.number: each for chapter in CHAPTERS.values() for each in chapter.recalls}

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
    if work is _FORGOTTEN:
        return exercise.without_work()
    file = own_progress()
    place = DisplayHandle()
    has_place = file and this_cell()[0] is not None  # a console would print each that is shown
    try:
        if has_place:
            place.display({}, raw=True)
        result = exercise.check(work, place.update if has_place else lambda _: None)
    finally:
        if has_place:  # not cleared: what callbacks have printed stays
            place.update({}, raw=True)
    if result.done:
        passed.add(exercise.number)
    if file is None:
        return result
    missed = {each.sentence: each.happened for each in result.findings if each.done is False}
    note = (file.add_solved(exercise.number) if result.done
            else file.add_tried(exercise.number, result.count, missed))
    result.help = exercise.help_after(result)
    result.text = f'{result.text} {note}'.strip()
    if result.done:
        remembered, _ = file.read()
        ticks.tick(file.path.parent, {chapter.name: [each.number for each in chapter.exercises]
                                      for chapter in CHAPTERS.values()}, remembered.solved)
    return result


def hint(number: str = '') -> Answer:
    """Return the next hint for an exercise; after the last one, where its solution is."""
    exercise = EXERCISES.get(str(number))
    if exercise is None:
        return _unknown(number)
    given = _hints_given[number] = _hints_given.get(number, 0) + 1
    return Answer(exercise.hint(given))


def predict(number: str = '') -> PredictionView | Answer:
    """Ask what the next cell will show; the widget says what became of the prediction once that cell has run.

    :param number: Of the prediction, e.g. '3-1' or '5.2-4'.
    """
    return _ask(number, 'prediction', PREDICTIONS)


def recall(number: str = '') -> PredictionView | Answer:
    """Ask about an earlier chapter; the widget says at once whether the answer is right, and where it was learned.

    :param number: Of the chapter, and its own, e.g. '4-r1'.
    """
    return _ask(number, 'question', RECALLS)


def progress(number: str = '') -> Answer:
    """Return what there is to solve in a chapter, with a tick at what the learner has solved.

    :param number: Of the chapter, e.g. '3' or '5.2'.
    """
    chapter = CHAPTERS.get(str(number))
    if chapter is None:
        return _unknown(number, 'chapter', CHAPTERS)
    return ChapterProgress(chapter, own_progress())


def _ask(number: Any, what: str, questions: Mapping[str, Prediction]) -> PredictionView | Answer:
    question = questions.get(str(number))
    return _unknown(number, what, questions) if question is None else PredictionView(question, _remember_prediction)


def _remember_prediction(number: str, choice: str, is_right: bool) -> str:
    file = own_progress()
    return '' if file is None else file.add_prediction(number, choice, right=is_right)


def _unknown(number: Any, what: str = 'exercise', existing: Mapping[str, object] = EXERCISES) -> Answer:
    return Answer(f'There is no {what} {number!r}{nearest(str(number), list(existing), "There are none")}')


__all__ = ['CHAPTERS', 'EXERCISES', 'PREDICTIONS', 'RECALLS', 'Answer', 'Result', 'check', 'hint', 'predict',
           'progress', 'recall']
