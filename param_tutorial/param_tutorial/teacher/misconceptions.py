"""Which wrong answers a class has given, and at which requirements of an exercise its students are stuck."""

from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

from param_tutorial.exercises import CHAPTERS
from param_tutorial.exercises.prediction import Choice, Prediction
from param_tutorial.teacher.classroom import Student


class Answered(NamedTuple):
    """A question that somebody in the class has answered wrongly."""

    question: Prediction
    by_choice: list[tuple[Choice, list[str]]]
    """The answers given, wrong ones first and the most frequent before others, and the names of who gave each."""
    wrong: int
    """How many students answered wrongly."""
    total: int
    """How many students answered."""


class Stuck(NamedTuple):
    """An exercise that students have tried and not solved."""

    number: str
    title: str
    by_requirement: list[tuple[str, dict[str, str]]]
    """The sentences of the requirements missed, the most frequent first; for each student what happened instead."""
    names: list[str]
    """Who tried, and has not solved it."""
    solved: int
    """How many students have solved it."""


def describe(students: list[Student]) -> Iterator[str]:
    """Yield what to talk about, as lines for a teacher; what concerns the most students comes first."""
    yield '\nQuestions that were answered wrongly'
    for asked in answers(students):
        yield f'\n{asked.question.number} · {asked.wrong} of {asked.total} wrong: {asked.question.question}'
        for choice, names in asked.by_choice:
            yield f'    {len(names)} {"✓" if choice.is_right else "✗"} {choice.text} ({", ".join(names)})'
            if not choice.is_right and choice.sentence:
                yield f'        {choice.sentence}'
    yield '\nExercises that hold somebody up'
    for exercise in stuck(students):
        yield (f'\n{exercise.number} · {exercise.title}: {len(exercise.names)} tried it and have not solved it; '
               f'{exercise.solved} solved it')
        for sentence, by_student in exercise.by_requirement:
            yield f'    {len(by_student)} ✗ {sentence}'
            for name, happened in by_student.items():
                yield f'        {name}: {happened or "not met"}'


def answers(students: list[Student]) -> list[Answered]:
    """Return the questions that were answered wrongly; those with the most wrong answers come first."""
    found = []
    for chapter in CHAPTERS.values():
        for question in (*chapter.recalls, *chapter.predictions):
            given: dict[Choice, list[str]] = defaultdict(list)
            for name, progress in students:
                if committed := progress.predicted.get(question.number):
                    choice = question.choice(committed.choice)
                    if choice.is_right != committed.right:  # which the course has judged otherwise since
                        choice = Choice(committed.choice, '', committed.right)
                    given[choice].append(name)
            wrong = sum(len(names) for choice, names in given.items() if not choice.is_right)
            if wrong:
                by_choice = sorted(given.items(), key=lambda each: (each[0].is_right, -len(each[1])))
                found.append(Answered(question, by_choice, wrong, sum(map(len, given.values()))))
    return sorted(found, key=lambda each: -each.wrong)


def stuck(students: list[Student]) -> list[Stuck]:
    """Return the exercises at which students are stuck; those that stop the most students come first.

    A blank that ran with all other cells has met nothing, and says the same each time. Who left it at that has not
    begun with the exercise.
    """
    found = []
    for chapter in CHAPTERS.values():
        for exercise in chapter.exercises:
            tried = {name: progress.tried[exercise.number] for name, progress in students
                     if exercise.number in progress.tried}
            begun = {name: each for name, each in tried.items() if each.met or each.times > 1}
            missed: dict[str, dict[str, str]] = defaultdict(dict)
            for name, each in begun.items():
                for sentence, happened in each.missed.items():
                    missed[sentence][name] = happened
            if begun:
                by_requirement = sorted(missed.items(), key=lambda each: -len(each[1]))
                solved = sum(exercise.number in progress.solved for _, progress in students)
                found.append(Stuck(exercise.number, exercise.title, by_requirement, list(begun), solved))
    return sorted(found, key=lambda each: -len(each.names))
