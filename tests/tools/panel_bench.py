"""How long a large panel takes to be seen, and how smoothly it scrolls, in the real JupyterLab and Chromium."""

import statistics
import tempfile
import time
from pathlib import Path

from playwright.sync_api import expect

from tests.support import lesson
from tests.support.lab import Lab, LabPage, chromium

CELLS = (
    '# Large\nMany parameters:',
    '''import param_tutorial
from param_tutorial import ParameterPanel
from rclpy.node import Node


class Large(Node):
    def __init__(self, name, groups, each):
        super().__init__(name)
        for group in range(groups):
            for number in range(each):
                self.declare_parameter(f'layers.plugin_{group}.weight_{number}', 0.5 * number)


ros = param_tutorial.start()
ros.add(Large, 'large', 10, 50)
ros.add(Large, 'small', 1, 1)''',
    'ParameterPanel("/small")',
    'ParameterPanel("/large")',
    '''ros.remove_all()
for index in range(50):
    ros.add(Large, f'node_{index}', 4, 10)''',
    'ParameterPanel()',
)
# What a cell shows: the seconds from its start until the browser has drawn it.
SHOWN = '''async ([index, css, count]) => {
    const notebook = window.jupyterapp.shell.currentWidget.content;
    notebook.activeCellIndex = index;
    const start = performance.now();
    window.jupyterapp.commands.execute('notebook:run-cell');
    while (notebook.widgets[index].node.querySelectorAll(css).length < count) {
        await new Promise(requestAnimationFrame);
        if (performance.now() - start > 100000) throw new Error(`no ${count} of ${css}`);
    }
    await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    return (performance.now() - start) / 1000;
}'''
ROUNDS = 5
# Notes how long the browser went without drawing anything, until it is asked.
LONGEST_FRAME = '''() => {
    let last = performance.now();
    window.longestFrame = 0;
    const look = now => {
        window.longestFrame = Math.max(window.longestFrame, now - last);
        last = now;
        requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
}'''
WORDS = 'node_49 weight_9'
# As fast as a good typist.
KEY_MSEC = 80
# Scrolls 10,000 pixels in two seconds, which is as fast as a hand goes through a list, or stands still, and counts the
# frames.
SCROLL = '''async ([index, isMoving]) => {
    const notebook = window.jupyterapp.shell.currentWidget.content;
    const panel = notebook.widgets[index].node.querySelector('.param-panel');
    let box = panel;
    while (box && !(box.scrollHeight > box.clientHeight + 100 && /auto|scroll/.test(getComputedStyle(box).overflowY))) {
        box = box.parentElement;
    }
    panel.scrollIntoView({block: 'start'});
    await new Promise(requestAnimationFrame);
    const first = box.scrollTop;
    const start = performance.now();
    let frames = 0;
    while (performance.now() - start < 2000) {
        if (isMoving) box.scrollTop = first + 5 * (performance.now() - start);
        await new Promise(requestAnimationFrame);
        frames += 1;
    }
    return [1000 * frames / (performance.now() - start), box.scrollTop - first];
}'''


def measure() -> dict[str, float]:
    """Return the seconds until a panel is shown, and frames a second: scrolling, and at rest on the same machine."""
    with tempfile.TemporaryDirectory() as scratch:
        notebook = lesson.write(Path(scratch) / 'large.ipynb', CELLS)
        with Lab(Path(scratch) / 'lab', [notebook]) as lab, chromium() as browser:
            page = LabPage(lab, browser, notebook.name)
            _run(page, 1)
            # The first widget of a page brings the code of all widgets.
            page.page.evaluate(SHOWN, [2, '.param-row', 3])
            large = page.page.evaluate(SHOWN, [3, '.param-row', 502])
            frames: dict[bool, list[float]] = {True: [], False: []}
            for is_moving in [True, False] * ROUNDS:
                count, scrolled = page.page.evaluate(SCROLL, [3, is_moving])
                assert (scrolled > 9_000) == is_moving, f'the panel was scrolled by {scrolled} px'
                frames[is_moving].append(count)
            _run(page, 4)
            nodes = page.page.evaluate(SHOWN, [5, '.node-line', 50])
            search = page.page.get_by_role('searchbox', name='Search nodes and parameters')
            page.page.evaluate(LONGEST_FRAME)
            search.press_sequentially(WORDS, delay=KEY_MSEC)
            start = time.monotonic()
            expect(page.page.locator('.node-hit')).to_have_count(4)
            found = time.monotonic() - start
            longest = page.page.evaluate('window.longestFrame')
    return {'large': large, 'frames': statistics.median(frames[True]), 'at rest': statistics.median(frames[False]),
            'nodes': nodes, 'found': found, 'longest frame': longest}


def _run(page: LabPage, index: int) -> None:
    page.select_cell(index)
    page.command('notebook:run-cell')
    page.page.wait_for_function(
        """index => { const cell = window.jupyterapp.shell.currentWidget.content.widgets[index];
            return cell.model.executionCount !== null && cell.model.executionState !== 'running' }""", arg=index)


if __name__ == '__main__':
    print(measure())
