"""The command line of a teacher: ``make class`` and ``make plans``."""

import argparse
import sys
from pathlib import Path

from param_tutorial.learner.copies import CHAPTERS
from param_tutorial.learner.storage import write_whole
from param_tutorial.teacher.classroom import format_csv, format_table, read_class
from param_tutorial.teacher.page import class_page
from param_tutorial.teacher.plan import plans_page

ROOT = Path(__file__).resolve().parents[3]
PAGE, PLANS = 'class.html', 'plans.html'


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and do what it says.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(prog='python -m param_tutorial.teacher', description=(
        'Show what a class has solved and what to talk about next, or write a plan for each lesson.'))
    what = parser.add_subparsers(dest='what', required=True)
    of_class = what.add_parser('class', help=f'print a table of a class, and write {PAGE} into its folder')
    of_class.add_argument('folder', type=Path, help='where the progress files are')
    of_class.add_argument('--csv', action='store_true', help='only print the table, as comma-separated values')
    plans = what.add_parser('plans', help='write the plans of all lessons, as one page')
    plans.add_argument('folder', type=Path, help=f'where {PLANS} is to be')
    plans.add_argument('--course', type=Path, default=ROOT, help='the checkout of the course')
    options = parser.parse_args(arguments)
    if options.what == 'plans':
        return _write(options.folder / PLANS, plans_page(options.course / CHAPTERS), 'A plan for each lesson')
    students, bad = read_class(options.folder)
    for each in bad:
        print(each, file=sys.stderr)
    if not students:
        print(f'There is no progress file in {options.folder}.', file=sys.stderr)
        return 1
    print((format_csv if options.csv else format_table)(students))
    return 0 if options.csv else _write(options.folder / PAGE, class_page(students), 'What to talk about next')


def _write(path: Path, page: str, what: str) -> int:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, page.encode())
    except OSError as error:
        print(f'{path} could not be written: {error.strerror}.', file=sys.stderr)
        return 1
    print(f'\n{what}: {path}')
    return 0
