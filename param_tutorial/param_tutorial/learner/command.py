"""The command line of the learner: ``make reset`` and ``make reset-progress``."""

import argparse
import sys
from pathlib import Path

from param_tutorial.learner.copies import Copies, CopiesError

ROOT = Path(__file__).resolve().parents[3]


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and do what it says.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(
        prog='python -m param_tutorial.learner',
        description='Make your copy of one chapter fresh again, and keep what was there; or forget your progress.')
    parser.add_argument('what', help='the number of a chapter, such as 06 or 5.2; or reset-progress')
    parser.add_argument('--course', type=Path, default=ROOT, help='the checkout of the course')
    options = parser.parse_args(arguments)
    copies = Copies.of_learner(options.course.resolve())
    try:
        print(_reset_progress(copies) if options.what == 'reset-progress' else copies.reset(options.what))
    except CopiesError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def _reset_progress(copies: Copies) -> str:
    try:
        kept = copies.progress.reset()
    except OSError as error:
        raise CopiesError(f'Your progress could not be reset: {error.strerror}: {error.filename}.') from error
    if kept is None:
        return 'No progress is remembered, so there is nothing to forget.'
    copies.tick()
    return f'Your progress is forgotten. What was remembered is kept in {kept}.'

