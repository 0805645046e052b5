"""``python -m param_tutorial.learner.finished``, which ``make robot`` runs: write the finished package of a reader."""

import argparse
import sys
from pathlib import Path

from param_tutorial.learner.package_files import NAME, ours, steps
from param_tutorial.learner.storage import write_whole


def main(arguments: list[str] | None = None) -> int:
    """Read the command line, and do what it says.

    :return: The exit status.
    """
    parser = argparse.ArgumentParser(prog='python -m param_tutorial.learner.finished',
                                     description=f'Write {NAME}, the package that a reader of the course ends with.')
    parser.add_argument('folder', type=Path, help='a new folder, such as ~/ros2_ws/src/my_robot')
    folder: Path = parser.parse_args(arguments).folder.expanduser()
    if folder.exists():
        print(f'{folder} exists already, and nothing of yours is overwritten. Name another folder.', file=sys.stderr)
        return 1
    try:
        for name, text in ours(steps()[-1]).items():
            write_whole(folder / name, text.encode())
    except OSError as error:
        print(f'{folder} cannot be written: {error.strerror}', file=sys.stderr)
        return 1
    print(f'{NAME} is in {folder}. Build it with colcon, in the folder above src.')
    return 0


if __name__ == '__main__':
    sys.exit(main())
