"""The progress files of a class, and what each student has solved, as one table."""

from pathlib import Path
from typing import NamedTuple

from param_tools.errors import ParameterToolError
from param_tutorial.exercises import CHAPTERS, EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.learner.copies import COPIES
from param_tutorial.learner.progress import FILE, Progress, parse


class Student(NamedTuple):
    """One learner of a class."""

    name: str
    progress: Progress


def read_class(folder: Path) -> tuple[list[Student], list[str]]:
    """Read all progress files below a folder.

    A student is named by the file, or by its folder if the file has its usual name.

    :return: The students by name, and a sentence for each file that can't be read.
    """
    students, bad = [], []
    for path in sorted(folder.rglob('*.json')):
        parts = path.relative_to(folder).parts
        if any(part.startswith('.') for part in parts):
            continue
        try:
            students.append(Student(_name_of(path, folder), parse(path.read_bytes())))
        except ParameterToolError as error:
            bad.append(f'Left out {path}: {error}.')
        except OSError as error:
            bad.append(f'Left out {path}: {error.strerror}.')
    return sorted(students, key=lambda each: each.name.casefold()), bad


def format_table(students: list[Student]) -> str:
    """Return a row for each student, in columns: exercises solved, by chapter and in all, and predictions made."""
    questions = {**PREDICTIONS, **RECALLS}
    table = [['student', *CHAPTERS, 'all', 'predicted', 'right']]
    for name, progress in students:
        solved = [sum(each.number in progress.solved for each in chapter.exercises) for chapter in CHAPTERS.values()]
        totals = [len(chapter.exercises) for chapter in CHAPTERS.values()]
        made = [each for number, each in progress.predicted.items() if number in questions]
        pairs = [*zip(solved, totals), (sum(solved), len(EXERCISES)), (len(made), len(questions))]
        table.append([name, *(f'{count}/{total}' for count, total in pairs), str(sum(each.right for each in made))])
    widths = [max(map(len, column)) for column in zip(*table)]
    return '\n'.join('  '.join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(
        row[1:], widths[1:]))]) for row in table)


def _name_of(path: Path, folder: Path) -> str:
    parts = [part for part in path.relative_to(folder).with_suffix('').parts if part != COPIES]
    usual = Path(FILE).stem
    if parts[-1] == usual and len(parts) > 1:
        del parts[-1]
    return '/'.join(parts)
