"""``python -m param_tutorial.learner``, which ``make reset`` runs: make one chapter fresh again."""

import argparse
import sys
from pathlib import Path

from param_tools.errors import ParameterToolError
from param_tutorial.learner.copies import Copies

ROOT = Path(__file__).resolve().parents[3]


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and do what it says.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(
        prog='python -m param_tutorial.learner',
        description='Make your copy of one chapter fresh again, and keep what was there.')
    parser.add_argument('chapter', help='its number, such as 06 or 5.2')
    parser.add_argument('--course', type=Path, default=ROOT, help='the checkout of the course')
    options = parser.parse_args(arguments)
    copies = Copies.of_learner(options.course.resolve())
    try:
        print(copies.reset(options.chapter))
    except ParameterToolError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
