"""Be a stranger who plays with the chapters in the real JupyterLab, and look whether they still say the truth.

`make stranger` (`make stranger ARGS="06 10_3 --seed 7"`). Everything goes through Chromium, by mouse and keyboard. For
each chapter, in a kernel and a page of its own, on the copy that `make lab` delivers:

1. All cells in order, with play before many of them: sliders are pulled, boxes typed into, buttons pressed, and the
   next cell runs while these changes are still on their way. Each output must be the stored one; cells with the tag
   `present-state` show what the node or the learner has now, so they may differ.
2. A mess: cells twice and out of order, some of them interrupted, play while they run, and the page reloaded. Cells may
   fail here; nothing may hang.
3. Run All, with play while it runs. Now each output must be the stored one again, and every panel must still answer to
   a hand, also after the page was reloaded. The browser must not complain.
"""

import argparse
import contextlib
import json
import random
import sys
import tempfile
import time
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from playwright.sync_api import Error as BrowserError
from playwright.sync_api import Locator

from param_tutorial.site.recording import comparison
from tests.support.lab import CourseLab, LabPage, chromium, wait_for
from tests.support.paths import NOTEBOOKS

PRESENT_STATE = 'present-state'
HANG_SEC = 150.0
REACT_SEC = 20.0
# A control may go while a hand reaches for it.
REACH_MS = 2_000
# A long cell of the mess is interrupted within this time.
PATIENCE_MS = 1_500
TEXTS = ('-5', '0', '1', '42', '150', '0.5', '1e+5', 'abc', '', 'true', '[1, 2]', "Rex <b>'s", '99999999999', 'nan')
# What a hand can take hold of. What every node has stands apart on a panel, and is left alone: with use_sim_time a
# node's clock waits for a simulator that is not there.
CONTROLS = ('.jp-OutputArea-output .jupyter-widgets :is(button, input, textarea, select)'
            ':enabled:visible:not([readonly], .param-quiet *)')
PANELS = '.jp-OutputArea-output .param-panel:visible'
STATES = """() => window.jupyterapp.shell.currentWidget.content.widgets.map(
    cell => cell.model.type === 'code' ? [cell.model.executionCount, cell.model.executionState] : [null, ''])"""
ACTIVATE = """index => {
    const notebook = window.jupyterapp.shell.currentWidget.content;
    notebook.deselectAll();
    notebook.activeCellIndex = index;
    notebook.mode = 'command';
    notebook.activate();
    return notebook.scrollToItem(index, 'center').catch(() => null);
}"""
CELL = """index => JSON.stringify(
    window.jupyterapp.shell.currentWidget.content.widgets[index].model.toJSON())"""
VALUES = "__import__('param_tutorial').ParameterClient({node!r}).get_parameters()"
HAS_FOCUS = 'each => each === document.activeElement'


class Stranger:
    """Plays with one chapter on one page."""

    def __init__(self, lab: CourseLab, page: LabPage, path: Path, chance: random.Random, mess: int, is_verbose: bool):
        self._lab, self._lab_page, self._page, self._chance = lab, page, page.page, chance
        self._mess_steps, self._is_verbose = mess, is_verbose
        notebook = nbformat.read(path, as_version=4)
        code = [index for index, cell in enumerate(notebook.cells) if cell.cell_type == 'code']
        self._cells = {index: (notebook.cells[index], stored)
                       for index, stored in zip(code, comparison.cells_of(path))}
        self.actions = self.compared = 0
        self.found: list[str] = []
        """What is wrong: each makes the script fail."""

    def play_chapter(self) -> None:
        """Do all of it."""
        try:
            for index in self._cells:
                if self._chance.random() < 0.7:
                    self._play(self._chance.randint(1, 3))
                self._run(index)
                self._compare(index, 'in the pass with play')
            self._mess()
            self._run_all()
            self._use_panels('after Run All')
            self._lab_page.reload()
            self._use_panels('after Run All and a reload')
        except TimeoutError as error:
            self.found.append(f'HANGS: {error}; kernels: {self._lab.kernels()}')
        self.found += [f'the browser complains: {error[:500]}' for error in self._lab_page.strange_errors()]
        self.found += [f'a dialog is open: {text!r}' for text in self._page.locator('.jp-Dialog').all_inner_texts()]

    # -- cells ---------------------------------------------------------------------------------------------------

    def _mess(self) -> None:
        for number in range(self._mess_steps):
            index = self._chance.choice(list(self._cells))
            how = self._chance.choice(('once', 'twice', 'interrupted'))
            self._say(f'mess: cell {index} {how}')
            self._start(index)
            if how == 'interrupted':
                self._page.wait_for_timeout(self._chance.uniform(0, PATIENCE_MS))
                self._page.evaluate(ACTIVATE, index)
                self._page.keyboard.press('i')
                self._page.keyboard.press('i')
            else:
                self._play(1)
                if how == 'twice':
                    self._page.evaluate(ACTIVATE, index)
                    self._page.keyboard.press('Control+Enter')
            self._wait_for_end(index)
            if number == self._mess_steps // 2:
                self._lab_page.reload()

    def _run_all(self) -> None:
        last = [index for index, (cell, _) in self._cells.items() if cell.source.strip()][-1]
        before = self._page.evaluate(STATES)[last][0]
        self._lab_page.command('notebook:run-all-cells')
        self._play(3)
        wait_for(lambda: self._page.evaluate(STATES)[last][0] not in (None, before), 'Run All to end', 2 * HANG_SEC)
        self._wait_for_end(last)
        wait_for(lambda: self._lab.kernels()[0]['execution_state'] == 'idle', 'the kernel to be idle', HANG_SEC)
        for index in self._cells:
            self._compare(index, 'after Run All')

    def _run(self, index: int) -> None:
        self._start(index)
        self._wait_for_end(index)

    def _start(self, index: int) -> None:
        """Run a cell as a hand does, and wait until JupyterLab has taken the keys."""
        before, pressed_sec = self._page.evaluate(STATES)[index][0], 0.0

        def begun() -> bool:
            nonlocal pressed_sec
            count, state = self._page.evaluate(STATES)[index]
            if state == 'running' or count != before:
                return True
            # A control that is being drawn anew may take the keyboard away.
            if time.monotonic() > pressed_sec + REACT_SEC / 2:
                self._page.evaluate(ACTIVATE, index)
                self._page.keyboard.press('Control+Enter')
                pressed_sec = time.monotonic()
            return False

        wait_for(begun, f'cell {index} to begin', HANG_SEC)

    def _wait_for_end(self, index: int) -> None:
        wait_for(lambda: self._page.evaluate(STATES)[index][1] != 'running', f'cell {index} to end', HANG_SEC)

    def _compare(self, index: int, when: str) -> None:
        cell, stored = self._cells[index]
        if stored.is_skipped or PRESENT_STATE in cell.metadata.get('tags', []):
            return
        self.compared += 1
        now = self._cell(index)
        difference = ('    it did not run' if now.execution_count is None and cell.source.strip()
                      else stored.difference(now.outputs))
        if difference:
            self.found.append(f'cell {index}, {when}:\n{cell.source}\n--\n{difference}')

    def _cell(self, index: int) -> NotebookNode:
        cell = json.loads(self._page.evaluate(CELL, index))
        cell.get('metadata', {}).pop('execution', None)
        notebook = {'cells': [cell], 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5}
        return nbformat.reads(json.dumps(notebook), as_version=4).cells[0]

    # -- the hand ------------------------------------------------------------------------------------------------

    def _play(self, count: int) -> None:
        """Use some of the controls on the page, and don't wait for the results."""
        for _ in range(count):
            controls = self._page.locator(CONTROLS).all()
            # One that has gone meanwhile, or is covered, is left alone.
            with contextlib.suppress(BrowserError, IndexError):
                self._handle(self._chance.choice(controls))
                self.actions += 1

    def _handle(self, control: Locator) -> None:
        """Pull, type into or press a control."""
        mouse, keyboard, chance = self._page.mouse, self._page.keyboard, self._chance
        tag, kind, name = control.evaluate('each => [each.tagName, each.type, each.getAttribute("aria-label") || '
                                           'each.labels?.[0]?.textContent || each.textContent]', timeout=REACH_MS)
        self._say(f'{tag.lower()} {kind} {name!r}')
        if kind == 'range' and chance.random() < 0.7:
            control.hover(timeout=REACH_MS)
            box = control.bounding_box(timeout=REACH_MS)
            mouse.down()
            mouse.move(box['x'] + chance.uniform(0, box['width']), box['y'] + box['height'] / 2,
                       steps=chance.randint(2, 12))
            mouse.up()
            return
        control.click(timeout=REACH_MS, click_count=3 if kind in ('text', 'textarea') else 1)
        # Outside of a control, JupyterLab takes letters for shortcuts: "r" makes a cell raw, and "a" adds one.
        if kind == 'range' and control.evaluate(HAS_FOCUS, timeout=REACH_MS):
            for key in chance.choices(('ArrowLeft', 'ArrowRight', 'Home', 'End'), k=chance.randint(1, 4)):
                keyboard.press(key)
        elif kind in ('text', 'textarea') and control.evaluate(HAS_FOCUS, timeout=REACH_MS):
            keyboard.type(chance.choice(TEXTS))
            keyboard.press(chance.choice(('Enter', 'Tab')))

    def _use_panels(self, when: str) -> None:
        """Change something on every panel: its node takes that, or the panel says why not."""
        # Views come back one after another, once the kernel has reported them.
        wait_for(self._page.locator('.jp-OutputArea-output .jupyter-widgets').count, 'the views', HANG_SEC)
        if broken := self._page.get_by_text('Error displaying widget').count():
            self.found.append(f'{when}, {broken} views are not displayed')
        for panel in self._page.locator(PANELS).all():
            node = panel.locator('.param-node').inner_text()
            boxes = panel.locator('.param-box[type=text]:enabled:visible:not(.param-quiet *)')
            # A list of all nodes has no name, and a panel whose node is gone says so.
            is_usable = node.startswith('/') and boxes.count()
            if is_usable and not panel.locator('.param-status-bad:visible').count() and not any(
                    self._is_answered(panel, node, boxes.first, text) for text in ('1', '0')):
                self.found.append(f'{when}, the panel of {node} does not react')

    def _is_answered(self, panel: Locator, node: str, box: Locator, text: str) -> bool:
        """Enter a text, and return whether node or panel changes; both may be so already."""
        def look() -> tuple[str, str]:
            return self._lab.ask_kernel(VALUES.format(node=node)), panel.inner_text()

        before = look()
        box.fill(text)
        box.press('Enter')
        with contextlib.suppress(TimeoutError):
            return wait_for(lambda: look() != before, 'an answer', REACT_SEC)
        return False

    def _say(self, text: str) -> None:
        if self._is_verbose:
            print(f'    {time.strftime("%M:%S")} {text}', flush=True)


def main(arguments: list[str]) -> int:
    """Play with the chapters named; return 1 if one does not say the truth."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('chapters', nargs='*', help='beginnings of file names, such as 05_2; by default all')
    parser.add_argument('--seed', type=int, default=random.randrange(10**6), help='repeats what a hand did')
    parser.add_argument('--mess', type=int, default=10, help='how many cells run out of order')
    parser.add_argument('--verbose', action='store_true', help='tell of every action')
    options = parser.parse_args(arguments)
    beginnings = tuple(options.chapters or [''])
    notebooks = sorted(NOTEBOOKS.glob('*.ipynb'))
    print(f'seed {options.seed}', flush=True)
    status = 0
    with tempfile.TemporaryDirectory() as scratch, CourseLab(Path(scratch) / 'lab', notebooks) as lab, \
            chromium() as browser:
        for path in notebooks:
            if not path.name.startswith(beginnings):
                continue
            began = time.monotonic()
            page = LabPage(lab, browser, path.name)
            stranger = Stranger(lab, page, path, random.Random(f'{options.seed} {path.name}'), options.mess,
                                options.verbose)
            stranger.play_chapter()
            page.page.close()
            lab.end_kernels()
            print(f'{path.name}: {stranger.actions} actions, {stranger.compared} outputs compared, '
                  f'{len(stranger.found)} things wrong, {time.monotonic() - began:.0f} s', flush=True)
            print(*stranger.found, sep='\n\n', end='\n\n' if stranger.found else '', flush=True)
            status |= bool(stranger.found)
    return status


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
