"""Cells that run again keep nothing of the runs before, but for what IPython keeps of any cell."""

import pytest

from param_tutorial import wait_until
from tests.support.growth import Chapter
from tests.support.kernels import Kernel
from tests.support.paths import NOTEBOOKS


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.parametrize('path', sorted(NOTEBOOKS.glob('*.ipynb')), ids=lambda path: path.stem)
def test_cells_that_run_again_leave_nothing_behind(path):
    kernel = Kernel()
    try:
        chapter = Chapter(path, kernel)
        chapter.run()
        # What is made once and for all is there after the second run at the latest.
        chapter.run()
        second = chapter.objects()
        chapter.run()
        third = chapter.objects()
        chapter.run()

        def more_with_each_run():
            fourth = chapter.objects()
            return {name: (second[name], third[name], count) for name, count in fourth.items()
                    if second[name] < third[name] < count}

        # Some things end a few seconds later.
        wait_until(lambda: not more_with_each_run(), f'an end of {more_with_each_run()}', 30)
    finally:
        kernel.kill()
