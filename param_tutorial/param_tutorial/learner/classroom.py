"""What a class has solved: all progress files below a folder, as one table."""

import csv
import io
from pathlib import Path
from typing import NamedTuple

from param_tutorial.learner.copies import COPIES
from param_tutorial.learner.progress import FILE, Progress, ProgressError, parse
from param_tutorial.learner.syllabus import Lesson


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
        except ProgressError as error:
            bad.append(f'Left out {path}: {error}.')
        except OSError as error:
            bad.append(f'Left out {path}: {error.strerror}.')
    return sorted(students, key=lambda each: each.name.casefold()), bad


def format_table(students: list[Student], lessons: list[Lesson]) -> str:
    """Return a table for people, in columns."""
    rows = _rows(students, lessons)
    widths = [max(map(len, column)) for column in zip(*rows)]
    return '\n'.join('  '.join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(
        row[1:], widths[1:]))]) for row in rows)


def format_csv(students: list[Student], lessons: list[Lesson]) -> str:
    """Return the table as comma-separated values, for a spreadsheet; counts only, which no program takes for dates."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator='\n')
    writer.writerows([name, *(cell.partition('/')[0] for cell in cells)] for name, *cells in _rows(students, lessons))
    return text.getvalue().rstrip('\n')


def _rows(students: list[Student], lessons: list[Lesson]) -> list[list[str]]:
    """Return the headings and a row for each student: exercises solved, by chapter and in all, and predictions made."""
    questions = {number for lesson in lessons for number in lesson.questions}
    rows = [['student', *(lesson.number for lesson in lessons), 'all', 'predicted', 'right']]
    for name, progress in students:
        solved = [sum(number in progress.solved for number in lesson.exercises) for lesson in lessons]
        totals = [len(lesson.exercises) for lesson in lessons]
        made = [each for number, each in progress.predicted.items() if number in questions]
        pairs = [*zip(solved, totals), (sum(solved), sum(totals)), (len(made), len(questions))]
        rows.append([name, *(f'{count}/{total}' for count, total in pairs), str(sum(each.right for each in made))])
    return rows


def _name_of(path: Path, folder: Path) -> str:
    parts = [part for part in path.relative_to(folder).with_suffix('').parts if part != COPIES]
    usual = Path(FILE).stem
    if parts[-1] == usual and len(parts) > 1:
        del parts[-1]
    return '/'.join(parts)
