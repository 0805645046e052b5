"""``python -m param_tutorial.teacher``, which ``make class`` runs: the table of a class, and what to talk about."""

import argparse
import sys
from pathlib import Path

from param_tutorial.teacher import misconceptions
from param_tutorial.teacher.classroom import format_table, read_class


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and print what a class has solved and what to talk about next.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(prog='python -m param_tutorial.teacher', description=(
        'Show what a class has solved, which wrong answers it gave, and where it is stuck.'))
    parser.add_argument('folder', type=Path, help='where the progress files are')
    folder = parser.parse_args(arguments).folder
    students, bad = read_class(folder)
    for each in bad:
        print(each, file=sys.stderr)
    if not students:
        print(f'There is no progress file in {folder}.', file=sys.stderr)
        return 1
    print(format_table(students), *misconceptions.describe(students), sep='\n')
    return 0


if __name__ == '__main__':
    sys.exit(main())
