"""How smoothly pictures move in JupyterLab, and what that costs: `python -m tests.tools.picture_bench [CHAPTER ...]`.

A chapter is the beginning of its notebook's name, such as 06_2; by default all are measured. ``measure()`` gives the
figures of one notebook to the caller, who makes a table of them.
"""

import os
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import psutil
from playwright.sync_api import Locator, Page

from tests.support.lab import CourseLab, LabPage, chromium
from tests.support.paths import NOTEBOOKS

SECONDS = 5.0
_PICTURES = '.jp-OutputArea-output :is(.motion, .robot-view, .step-view)'
# Which cells have pictures, also those that are not on the screen.
_CELLS = '''css => window.jupyterapp.shell.currentWidget.content.widgets.flatMap(
    (cell, index) => cell.node.querySelector(css) ? [index] : [])'''
_SHOW = '''index => {
    const notebook = window.jupyterapp.shell.currentWidget.content;
    notebook.widgets[index].node.setAttribute('data-bench', index);
    return notebook.scrollToItem(index, 'center').catch(() => null);
}'''
# How many seconds of its present movement a picture has before it.
_REST = '''picture => Math.max(0, ...picture.getAnimations({subtree: true}).filter(each => each.playState === 'running')
    .map(each => (each.effect.getComputedTiming().endTime - each.currentTime) / 1000))'''
# The browser's frames; of a robot those in which it has moved.
_COUNT = '''(picture, seconds) => new Promise(done => {
    const seen = new Set(), begin = performance.now();
    const look = now => {
        const mover = picture.querySelector('.robot-mover');
        seen.add(mover ? getComputedStyle(mover).transform : now);
        now - begin < 1000 * seconds ? requestAnimationFrame(look) : done(seen.size / seconds);
    };
    requestAnimationFrame(look) })'''


class Figures(NamedTuple):
    """What a picture costs, in percent of one core; the browser is all its processes, which draw on the processor."""

    cell: int
    still_kernel: float
    still_browser: float
    moving_kernel: float = 0.0
    moving_browser: float = 0.0
    moving_sec: float = 0.0
    """How long it was measured while it moved; 0 if it does not move."""
    frames_per_sec: float = 0.0


def measure(notebook: Path) -> Iterator[Figures]:
    """Yield the figures of each picture of a notebook, while it rests, and while it moves for up to SECONDS."""
    with tempfile.TemporaryDirectory() as scratch, CourseLab(Path(scratch) / 'lab', [notebook]) as lab, \
            chromium() as browser:
        lab_page = LabPage(lab, browser, notebook.name)
        lab_page.run_all()
        kernel = [psutil.Process(int(lab.ask_kernel("__import__('os').getpid()")))]
        processes = [each for each in psutil.Process().children(recursive=True) if 'chrom' in each.name()]
        lab_page.page.wait_for_timeout(3000)  # whatever JupyterLab does after running a cell
        yield from _figures(lab_page, kernel, processes)


def _figures(lab_page: LabPage, kernel: list[psutil.Process], browser: list[psutil.Process]) -> Iterator[Figures]:
    page = lab_page.page
    for index in page.evaluate(_CELLS, _PICTURES):
        page.evaluate(_SHOW, index)
        for picture in page.locator(f'[data-bench="{index}"]').locator(_PICTURES).all():
            picture.scroll_into_view_if_needed()
            _wait_for_rest(picture)
            still = _loads(page, SECONDS, kernel, browser)
            if not (seconds := _move(picture)):
                yield Figures(index, *still)
                continue
            moving = _loads(page, seconds, kernel, browser)
            _wait_for_rest(picture)
            _move(picture)
            yield Figures(index, *still, *moving, seconds, picture.evaluate(_COUNT, seconds))


def _wait_for_rest(picture: Locator) -> None:
    while picture.evaluate(_REST):
        picture.page.wait_for_timeout(100)


def _move(picture: Locator) -> float:
    """Have a picture move as a hand does, and return for how many seconds of it, at most SECONDS; 0 if it can't."""
    button = picture.get_by_role('button', name=re.compile('Drive|Play again'))
    slider = picture.page.get_by_role('slider').first
    if button.count():
        button.click()
    elif slider.count():
        slider.press('ArrowRight')
    else:
        return 0.0
    deadline = time.monotonic() + SECONDS
    while not (seconds := picture.evaluate(_REST)) and time.monotonic() < deadline:
        picture.page.wait_for_timeout(20)
    return min(seconds, SECONDS)


def _loads(page: Page, seconds: float, *groups: list[psutil.Process]) -> list[float]:
    """Return the processor time of each group in percent of one core."""
    def used_sec() -> list[float]:
        return [sum(sum(each.cpu_times()[:2]) for each in group) for group in groups]

    used, begin = used_sec(), time.monotonic()
    page.wait_for_timeout(1000 * seconds)
    return [100 * (after - before) / (time.monotonic() - begin) for before, after in zip(used, used_sec())]


def main(chapters: list[str]) -> None:
    """Print a table of all pictures of the chapters named."""
    print('| picture | load | still: kernel % | browser % | moving: s | kernel % | browser % | frames/s |\n'
          '|---|---|---|---|---|---|---|---|')
    for notebook in sorted(NOTEBOOKS.glob('*.ipynb')):
        if not notebook.name.startswith(tuple(chapters or [''])):
            continue
        for each in measure(notebook):
            moving = ((f'{each.moving_sec:.1f}', f'{each.moving_kernel:.1f}', f'{each.moving_browser:.1f}',
                       f'{each.frames_per_sec:.0f}') if each.moving_sec else [''] * 4)
            row = (f'{notebook.name[:4]} cell {each.cell}', f'{os.getloadavg()[0]:.1f}', f'{each.still_kernel:.1f}',
                   f'{each.still_browser:.1f}', *moving)
            print(f'| {" | ".join(row)} |', flush=True)


if __name__ == '__main__':
    main(sys.argv[1:])
