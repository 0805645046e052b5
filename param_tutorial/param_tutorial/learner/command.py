"""The command line of the learner and the teacher: ``make reset``, ``make reset-progress`` and ``make class``."""

import argparse
import os
import sys
from pathlib import Path
from typing import NoReturn

from param_tutorial.learner.classroom import format_csv, format_table, read_class
from param_tutorial.learner.copies import CHAPTERS, COPIES, LESSONS, Copies, CopiesError
from param_tutorial.learner.syllabus import read_syllabus

ROOT = Path(__file__).resolve().parents[3]


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and do what it says.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(
        prog='python -m param_tutorial.learner',
        description='Make your copy of one chapter fresh again, and keep what was there; or, with another word in the '
                    'place of the chapter, forget your progress, or show that of a class.')
    parser.add_argument('what', help='the number of a chapter, such as 06 or 5.2; or reset-progress; or class')
    parser.add_argument('folder', type=Path, nargs='?', help='with class: where the progress files are')
    parser.add_argument('--csv', action='store_true', help='with class: print comma-separated values')
    parser.add_argument('--course', type=Path, default=ROOT, help='the checkout of the course')
    options = parser.parse_args(arguments)
    if (options.what == 'class') != (options.folder is not None) or (options.csv and options.what != 'class'):
        parser.error('class takes a folder, and nothing else does' if not options.csv else '--csv belongs to class')
    if options.what == 'class':
        return _show_class(options.folder, options.course / CHAPTERS, as_csv=options.csv)
    copies = Copies.of_learner(options.course.resolve())
    try:
        print(_reset_progress(copies) if options.what == 'reset-progress' else copies.reset(options.what))
    except CopiesError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def open_lab(arguments: list[str]) -> NoReturn:
    """Become JupyterLab on the learner's copies of the chapters: in the checkout, or else in the current folder.

    :param arguments: For JupyterLab.
    """
    if not (ROOT / 'Makefile').exists():
        os.environ.setdefault(LESSONS, str(Path.cwd() / COPIES))
    os.execv(sys.executable, [sys.executable, str(ROOT / 'environment' / 'lab.py'), *arguments])


def _reset_progress(copies: Copies) -> str:
    try:
        kept = copies.progress.reset()
    except OSError as error:
        raise CopiesError(f'Your progress could not be reset: {error.strerror}: {error.filename}.') from error
    if kept is None:
        return 'No progress is remembered, so there is nothing to forget.'
    copies.tick()
    return f'Your progress is forgotten. What was remembered is kept in {kept}.'


def _show_class(folder: Path, chapters: Path, *, as_csv: bool) -> int:
    students, bad = read_class(folder)
    for each in bad:
        print(each, file=sys.stderr)
    if not students:
        print(f'There is no progress file in {folder}.', file=sys.stderr)
        return 1
    print((format_csv if as_csv else format_table)(students, read_syllabus(chapters)))
    return 0
