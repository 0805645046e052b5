"""How much memory a kernel keeps of each run of a chapter's cells. `make bench` uses it.

By itself, for any chapter: ``python -m tests.tools.memory_bench 06_1 --warm-up 200 --runs 1000``
"""

import argparse

from tests.support.growth import Chapter
from tests.support.kernels import Kernel
from tests.support.paths import NOTEBOOKS


def measure(chapter: str, warm_up: int, runs: int) -> float:
    """Run a chapter's cells again and again, and return by how much the kernel grew with each run, in KiB.

    IPython forgets after each run what was typed, shown and returned: by itself it keeps all of it for good.

    :param chapter: How the name of its file begins.
    :param warm_up: Runs before the first look: the memory of its many threads takes 150 to find its size.
    :raises ValueError: there is no such chapter, or more than one.
    """
    paths = list(NOTEBOOKS.glob(f'{chapter}*.ipynb'))
    if len(paths) != 1:
        raise ValueError(f'{len(paths)} chapters begin with {chapter!r}; name one: 06_1, for example')
    kernel = Kernel()
    try:
        lesson = Chapter(paths[0], kernel)

        def resident_after(count: int) -> int:
            for _ in range(count):
                lesson.run()
                lesson.forget()
            return lesson.resident_bytes()

        before = resident_after(warm_up)
        return (resident_after(runs) - before) / runs / 1024
    finally:
        kernel.kill()


def main() -> None:
    """Measure as the arguments say."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('chapter', help='how the name of its file begins: 06_1')
    parser.add_argument('--warm-up', type=int, default=200, metavar='N', help='runs before (default: %(default)s)')
    parser.add_argument('--runs', type=int, default=100, metavar='N', help='default: %(default)s')
    chosen = parser.parse_args()
    print(f'{measure(chosen.chapter, chosen.warm_up, chosen.runs):.0f} KiB a run')


if __name__ == '__main__':
    main()
