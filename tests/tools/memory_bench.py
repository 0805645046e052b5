"""How much memory a kernel keeps of each run of a chapter's cells. `make bench` uses it.

By itself, for any chapter: ``python -m tests.tools.memory_bench 06_1 --warm-up 200 --runs 1000``
"""

import argparse
from dataclasses import dataclass

from tests.support.growth import Chapter
from tests.support.kernels import Kernel
from tests.support.paths import NOTEBOOKS


@dataclass(frozen=True)
class Growth:
    """By how much a kernel grew with each run, in KiB."""

    in_all: float
    without_ipython: float
    """Without what cells showed and returned: IPython keeps all of it until the kernel ends."""


def measure(chapter: str, warm_up: int, runs: int) -> Growth:
    """Run a chapter's cells again and again.

    :param chapter: How the name of its file begins.
    :param warm_up: Runs before the first look: the memory of its many threads takes a hundred to find its size.
    :raises ValueError: there is no such chapter, or more than one.
    """
    paths = list(NOTEBOOKS.glob(f'{chapter}*.ipynb'))
    if len(paths) != 1:
        raise ValueError(f'{len(paths)} chapters begin with {chapter!r}; name one: 06_1, for example')
    kernel = Kernel()
    try:
        lesson = Chapter(paths[0], kernel)
        for _ in range(warm_up):
            lesson.run()
        lesson.forget()
        before = lesson.resident_bytes()
        for _ in range(runs):
            lesson.run()
        in_all = lesson.resident_bytes() - before
        lesson.forget()
        return Growth(in_all / runs / 1024, (lesson.resident_bytes() - before) / runs / 1024)
    finally:
        kernel.kill()


def main() -> None:
    """Measure as the arguments say."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('chapter', help='how the name of its file begins: 06_1')
    parser.add_argument('--warm-up', type=int, default=100, metavar='N', help='runs before (default: %(default)s)')
    parser.add_argument('--runs', type=int, default=100, metavar='N', help='default: %(default)s')
    chosen = parser.parse_args()
    growth = measure(chosen.chapter, chosen.warm_up, chosen.runs)
    print(f'{growth.in_all:.0f} KiB a run, {growth.without_ipython:.0f} KiB without what IPython keeps')


if __name__ == '__main__':
    main()
