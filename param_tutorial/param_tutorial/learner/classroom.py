"""What a class has solved: all progress files below a folder, as one table."""

import csv
import io
from pathlib import Path
from typing import NamedTuple

from param_tutorial.exercises import CHAPTERS, EXERCISES, PREDICTIONS, RECALLS
from param_tutorial.learner.copies import COPIES
from param_tutorial.progress.record import FILE, Progress, ProgressError, parse


class Student(NamedTuple):
    """One learner of a class."""

    name: str
    progress: Progress

    def solved(self, chapter: str) -> str:
        """Return how many of a chapter's exercises are solved, as '2/3'."""
        exercises = CHAPTERS[chapter].exercises
        return f'{sum(each.number in self.progress.solved for each in exercises)}/{len(exercises)}'

    @property
    def row(self) -> list[str]:
        """What stands in the table: chapters, all exercises, predictions and recalls made and right."""
        made = [each for number, each in self.progress.predicted.items() if number in {**PREDICTIONS, **RECALLS}]
        return [*map(self.solved, CHAPTERS),
                f'{sum(number in EXERCISES for number in self.progress.solved)}/{len(EXERCISES)}',
                f'{len(made)}/{len(PREDICTIONS) + len(RECALLS)}', str(sum(each.right for each in made))]


_COLUMNS = ('student', *CHAPTERS, 'all', 'predicted', 'right')


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


def format_table(students: list[Student]) -> str:
    """Return a table for people, in columns."""
    rows = [list(_COLUMNS), *([each.name, *each.row] for each in students)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    return '\n'.join('  '.join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(
        row[1:], widths[1:]))]) for row in rows)


def format_csv(students: list[Student]) -> str:
    """Return the table as comma-separated values, for a spreadsheet; counts only, which no program takes for dates."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator='\n')
    writer.writerow(_COLUMNS)
    writer.writerows([each.name, *(cell.partition('/')[0] for cell in each.row)] for each in students)
    return text.getvalue().rstrip('\n')


def _name_of(path: Path, folder: Path) -> str:
    parts = [part for part in path.relative_to(folder).with_suffix('').parts if part != COPIES]
    usual = Path(FILE).stem
    if parts[-1] == usual and len(parts) > 1:
        del parts[-1]
    return '/'.join(parts)
