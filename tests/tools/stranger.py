"""Be a stranger who plays with the chapters in the real JupyterLab, and look whether they still say the truth.

`make stranger` (`make stranger ARGS="06 10_3 --seed 7"`). `make play` moves controls in the kernel; here everything
goes through Chromium, by mouse and keyboard. For each chapter, in a kernel and a page of its own, on the copy that
`make lab` delivers:

1. All cells in order, with play before many of them: sliders are dragged, boxes typed into, buttons pressed, and the
   next cell runs while these changes are still on their way. Each output must be the stored one; cells with the tag
   `present-state` show what the node has now, so they may differ.
2. A mess: cells twice and out of order, some of them interrupted, play while they run, and the page reloaded. Cells may
   fail here; nothing may hang.
3. Run All, with play while it runs. Now each output must be the stored one. The kernel must be idle, every panel must
   still change its node, every list of nodes must find its parameters and every robot must drive, also after the page
   was reloaded. The browser must not complain.

It also says which cells kept the kernel busy, because the next one has to wait for them.
"""

import argparse
import ast
import collections
import json
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import nbformat
from nbformat import NotebookNode
from playwright.sync_api import Error as BrowserError

from param_tutorial.site.recording import comparison
from tests.support.lab import CourseLab, LabPage, chromium
from tests.support.paths import NOTEBOOKS
from tests.tools.play import PRESENT_STATE

_HANG_SEC = 150.0
_REACT_SEC = 20.0
_BUSY_SEC = 1.0
# How often it looks whether a cell has ended; the page has to answer each time.
_LOOK_MS = 100
# Between two cells of Run All a kernel is idle for less than so many looks.
_IDLE_LOOKS = 30
# A long cell of the mess is interrupted within this time.
_PATIENCE_SEC = 1.5
_TEXTS = ('-5', '0', '1', '7', '42', '120', '150', '0.5', '1.75', '1e3', '1e+5', 'abc', '', 'true', '[1, 2]',
          "Rex <b>'s", '99999999999', 'nan')

# For each message of the kernel, keep what shows how long a cell or a change by hand took.
_LISTEN = """() => {
    window.strangerLog = [];
    window.jupyterapp.shell.currentWidget.sessionContext.iopubMessage.connect((_, message) => {
        if (message.header.msg_type === 'status')
            window.strangerLog.push([message.parent_header.msg_type, message.parent_header.msg_id,
                                     message.content.execution_state, Date.parse(message.header.date)]);
    });
}"""
_CELLS = """() => window.jupyterapp.shell.currentWidget.content.widgets.map(
    cell => cell.model.type === 'code' ? [cell.model.executionCount, cell.model.executionState] : [null, ''])"""
_ACTIVATE = """index => {
    const notebook = window.jupyterapp.shell.currentWidget.content;
    notebook.deselectAll();
    notebook.activeCellIndex = index;
    notebook.mode = 'command';
    notebook.activate();
    return notebook.scrollToItem(index, 'center').catch(() => null);
}"""
_CELL = """index => JSON.stringify(
    window.jupyterapp.shell.currentWidget.content.widgets[index].model.toJSON())"""
_LIVE_CELLS = """() => window.jupyterapp.shell.currentWidget.content.widgets.flatMap((cell, index) =>
    cell.model.type === 'code' && cell.node.querySelector('.jp-OutputArea-output .jupyter-widgets') ? [index] : [])"""
# What a hand can take hold of in a cell's outputs. What every node has stands apart on a panel, and is left alone: with
# use_sim_time a node's clock waits for a simulator that is not there.
_CONTROLS = """index => {
    document.querySelectorAll('[data-stranger]').forEach(each => each.removeAttribute('data-stranger'));
    const cell = window.jupyterapp.shell.currentWidget.content.widgets[index].node;
    return [...cell.querySelectorAll('.jp-OutputArea-output .jupyter-widgets')].flatMap(view =>
        [...view.querySelectorAll('button, input, textarea, select, [role=slider], [role=radio]')])
        .filter((each, number, all) => all.indexOf(each) === number && each.getClientRects().length &&
            !each.disabled && !each.readOnly && !each.closest('[disabled], .param-quiet'))
        .map((each, number) => {
            each.setAttribute('data-stranger', number);
            const row = each.closest('.param-row'), label = row && row.querySelector('label');
            return {number, tag: each.tagName, type: each.type || each.getAttribute('role') || '',
                    name: (label || each).textContent.trim() || each.getAttribute('aria-label') || ''};
        });
}"""
_WHERE = """number => {
    const each = document.querySelector(`[data-stranger="${number}"]`);
    if (!each) return null;
    each.scrollIntoView({block: 'center'});
    const box = each.getBoundingClientRect(), x = box.x + box.width / 2, y = box.y + box.height / 2;
    const hit = document.elementFromPoint(x, y);
    return hit && (each === hit || each.contains(hit) || hit.contains(each)) ? [x, y] : null;
}"""
_HAS_FOCUS = """number => document.activeElement === document.querySelector(`[data-stranger="${number}"]`)"""
_PANELS = """index => [...window.jupyterapp.shell.currentWidget.content.widgets[index].node
    .querySelectorAll('.jp-OutputArea-output .param-panel')]
    .filter(panel => panel.querySelector('.param-node').textContent.startsWith('/'))  // a browser's list is none
    .map((panel, number) => {
        panel.setAttribute('data-stranger-panel', `${index}-${number}`);
        const bad = panel.querySelector('.param-status-bad');
        return [`${index}-${number}`, panel.querySelector('.param-node').textContent, bad ? bad.textContent : ''];
    })"""
_VIEWS = """([index, css]) => [...window.jupyterapp.shell.currentWidget.content.widgets[index].node
    .querySelectorAll(`.jp-OutputArea-output ${css}`)].map((view, number) => {
        view.setAttribute('data-stranger-view', `${index}-${number}`);
        return `${index}-${number}`;
    })"""
_VALUES = """(lambda c: {{n: repr(c.get_parameter(n)) for n in c.list_parameters()}})(
    __import__('param_tutorial').ParameterClient({node!r}))"""

# A hand may have left a robot where it may not drive: too cold, or at most 0 turns a minute.
_LET_DRIVE = """[__import__('param_tutorial').ParameterClient(node).set_parameters(
    {'simulation.ambient_temperature_c': 15, 'min_operating_temperature_c': -5, 'max_speed_rpm': 100})
    for node in __import__('param_tools.ros.stage').runtime.stage.current().nodes
    if hasattr(node, 'waiting_for')]"""


class Hang(Exception):
    """A cell, or Run All, has not ended in time."""


@dataclass
class Report:
    """What a stranger saw in one chapter."""

    chapter: str
    actions: int = 0
    missed: int = 0
    compared: int = 0
    found: list[str] = field(default_factory=list)
    """What is wrong: each makes the script fail."""
    busy: dict[int, float] = field(default_factory=dict)
    """How long a cell of the first pass kept the kernel, in s, by the cell's index."""
    failed: collections.Counter[str] = field(default_factory=collections.Counter)
    """The errors of cells that ran twice or out of order."""
    live: int = 0


class Stranger:
    """Plays with one chapter on one page."""

    def __init__(self, lab: CourseLab, page: LabPage, path: Path, chance: random.Random, *, mess: int,
                 verbose: bool):
        self._lab, self._lab_page, self._page, self._path = lab, page, page.page, path
        self._chance, self._mess_steps, self._verbose = chance, mess, verbose
        self.report = Report(path.name)
        notebook = nbformat.read(path, as_version=4)
        code = [index for index, cell in enumerate(notebook.cells) if cell.cell_type == 'code']
        self._cells = {index: (notebook.cells[index], stored)
                       for index, stored in zip(code, comparison.cells_of(path))}
        self._page.evaluate(_LISTEN)

    def play_chapter(self) -> None:
        """Do all of it; what is wrong is in the report."""
        try:
            self._pass_in_order()
            self._hear_browser('the pass with play')
            self._mess()
            self._hear_browser('the mess')
            self._run_all()
            self._look_at_views('after Run All')
            self._hear_browser('Run All')
            self._reload()
            self._look_at_views('after Run All and a reload')
        except Hang as error:
            self.report.found.append(str(error))
        self._hear_browser('a reload')
        dialogs = self._page.locator('.jp-Dialog').all_inner_texts()
        self.report.found += [f'a dialog is open: {text!r}' for text in dialogs]

    def _hear_browser(self, during: str) -> None:
        self.report.found += [f'the browser complains during {during}: {error[:500]}'
                              for error in self._lab_page.strange_errors()]
        self._lab_page.errors.clear()

    # -- the three parts ---------------------------------------------------------------------------------

    def _pass_in_order(self) -> None:
        for index in self._cells:
            if self._chance.random() < 0.7:
                self._play(self._chance.randint(1, 3))
            self._start(index)
            self._wait_for_end({index}, f'cell {index}')
            self._compare(index, 'in the pass with play')
        self.report.busy = self._busy()

    def _mess(self) -> None:
        indices = list(self._cells)
        for number in range(self._mess_steps):
            index = self._chance.choice(indices)
            how = self._chance.choice(('once', 'once', 'twice', 'interrupted', 'interrupted'))
            self._say(f'mess: cell {index} {how}')
            self._start(index)
            if how == 'interrupted':
                self._page.wait_for_timeout(self._chance.uniform(0, 1000 * _PATIENCE_SEC))
                self._page.evaluate(_ACTIVATE, index)
                self._page.keyboard.press('i')
                self._page.keyboard.press('i')
            else:
                self._play(1)
                if how == 'twice':
                    self._start(index, wait_for_start=False)
            self._wait_for_end({index}, f'cell {index}, out of order and {how}')
            self.report.failed.update(output.ename for output in self._cell(index).outputs
                                      if output.output_type == 'error')
            if number == self._mess_steps // 2:
                self._reload()
            self._play(1)

    def _run_all(self) -> None:
        before = self._counts()
        self._lab_page.command('notebook:run-all-cells')
        first = next(iter(self._cells))
        self._wait(lambda: self._counts()[first] != before[first], 'Run All to begin')
        self._play(3)
        self._wait(self._all_ran, 'Run All to end', 2 * _HANG_SEC)
        for index in self._cells:
            self._compare(index, 'after Run All')
        self._wait(lambda: self._lab.kernels()[0]['execution_state'] == 'idle', 'the kernel to be idle')

    def _look_at_views(self, when: str) -> None:
        """Use every live view on the page once."""
        broken = self._page.locator('.jp-OutputArea-output').filter(has_text='Error displaying widget').count()
        if broken:
            self.report.found.append(f'{when}, {broken} views are not displayed')
        for index in self._page.evaluate(_LIVE_CELLS):
            self._page.evaluate(_ACTIVATE, index)
            for key, node, bad in self._page.evaluate(_PANELS, index):
                if bad:
                    self._say(f'cell {index}: {node}: {bad}')
                elif not self._panel_reacts(index, key, node):
                    self.report.found.append(f'cell {index}: {when}, the panel of {node} does not react')
                self.report.live += not bad
            for key in self._page.evaluate(_VIEWS, [index, '.param-nodes']):
                self.report.live += 1
                if not self._nodes_react(key):
                    self.report.found.append(f'cell {index}: {when}, the list of nodes does not react')
            for key in self._page.evaluate(_VIEWS, [index, '.robot-view']):
                self.report.live += 1
                if not self._robot_reacts(key):
                    status = self._page.locator(f'[data-stranger-view="{key}"]').get_by_role('status').inner_text()
                    self.report.found.append(f'cell {index}: {when}, the robot does not drive, but says {status!r}')

    def _panel_reacts(self, index: int, key: str, node: str) -> bool:
        """Change something on a panel; its node takes it, or the panel says why not."""
        panel = self._page.locator(f'[data-stranger-panel="{key}"]')
        # Of changes that are gathered, a panel says how many there are, so one more value of one of them shows nowhere.
        discard = panel.get_by_role('button', name='Discard')
        if discard.is_visible():
            discard.click()
            if not self._becomes(discard.is_hidden):
                return False
        for control in self._page.evaluate(_CONTROLS, index):
            each = self._page.locator(f'[data-stranger="{control["number"]}"]')
            inside = panel.locator(f'[data-stranger="{control["number"]}"]')
            if inside.count() == 0 or control['tag'] != 'INPUT' or control['type'] == 'search':
                continue
            def look() -> object:
                return self._values(node), panel.inner_text()

            before = look()
            if control['type'] == 'checkbox':
                each.click()
                return self._changes(look, before)
            text = each.input_value()
            # A longer number may only be cut to the limit at which the value stands already. And the answer to one of
            # the two may stand there already.
            for new in ('0', '1') if text.strip('-0.').replace('.', '').isdigit() else (f'{text}1', f'{text}2'):
                each.fill(new)
                each.press('Enter')
                if self._changes(look, before):
                    return True
            return False
        return True

    def _nodes_react(self, key: str) -> bool:
        """Search a list of nodes for what none has, then for nothing: lines go, and come back."""
        nodes = self._page.locator(f'[data-stranger-view="{key}"]')
        for words in ('no such parameter', ''):
            before = nodes.inner_text()
            nodes.get_by_role('searchbox').fill(words)
            if not self._changes(nodes.inner_text, before):
                return False
        return True

    def _robot_reacts(self, key: str) -> bool:
        """Press a robot's Drive, if its node is there; what may not drive is allowed to."""
        robot = self._page.locator(f'[data-stranger-view="{key}"]')
        button = robot.get_by_role('button', name='Drive')
        if button.count() == 0 or button.is_disabled():
            return True
        word = robot.locator('.robot-word').inner_text()
        if word == 'WAITING':
            self._say(f'{robot.get_by_role("status").inner_text()} Now it may drive.')
            self._lab.ask_kernel(_LET_DRIVE)
            if not self._becomes(lambda: robot.locator('.robot-word').inner_text() != word):
                return False
        before = robot.inner_html()
        button.click()
        return self._changes(robot.inner_html, before)

    # -- the hand ----------------------------------------------------------------------------------------

    def _play(self, count: int) -> None:
        """Use some of the controls on the page, and don't wait for the results."""
        cells = self._page.evaluate(_LIVE_CELLS)
        for _ in range(count if cells else 0):
            index = self._chance.choice(cells)
            try:
                controls = self._page.evaluate(_CONTROLS, index)
                if not controls:
                    continue
                control = self._chance.choice(controls)
                place = self._page.evaluate(_WHERE, control['number'])
                if place is None:
                    self.report.missed += 1
                    continue
                if self._handle(index, control, *place):
                    self.report.actions += 1
                else:
                    self.report.missed += 1
            except BrowserError:  # the control has gone meanwhile
                self.report.missed += 1

    def _handle(self, index: int, control: dict[str, Any], x: float, y: float) -> bool:
        """Drag, type into or press a control; False if it has moved away under the hand."""
        mouse, keyboard, chance = self._page.mouse, self._page.keyboard, self._chance
        what = f'cell {index}: {control["tag"].lower()} {control["type"]} {control["name"]!r}'
        is_slider = control['type'] in ('slider', 'range')
        if is_slider and chance.random() < 0.7:
            distance = chance.randint(-150, 150)
            self._say(f'{what}, dragged by {distance}')
            mouse.move(x, y)
            mouse.down()
            mouse.move(x + distance, y, steps=chance.randint(2, 12))
            mouse.up()
        elif is_slider:
            keys = chance.choices(('ArrowLeft', 'ArrowRight', 'Home', 'End'), k=chance.randint(1, 4))
            self._say(f'{what}, {keys}')
            mouse.click(x, y)
            for key in keys:
                keyboard.press(key)
        elif control['tag'] == 'TEXTAREA' or control['type'] in ('text', 'number'):
            text, end = chance.choice(_TEXTS), chance.choice(('Enter', 'Tab', ''))
            self._say(f'{what}, {text!r} {end}')
            mouse.click(x, y, click_count=3)
            # Outside of a control, JupyterLab takes letters for shortcuts: "r" makes a cell raw, which can't be run,
            # and "a" adds one.
            if not self._page.evaluate(_HAS_FOCUS, control['number']):
                self._say('... which has moved away')
                return False
            keyboard.type(text)
            if end:
                keyboard.press(end)
        else:
            self._say(f'{what}, clicked')
            mouse.click(x, y)
        return True

    def _start(self, index: int, *, wait_for_start: bool = True) -> None:
        """Run a cell as a hand does, and wait until JupyterLab has taken the keys."""
        before = self._counts()[index]

        def begun() -> bool:
            count, state = self._page.evaluate(_CELLS)[index]
            return state == 'running' or count != before

        self._page.evaluate(_ACTIVATE, index)
        self._page.keyboard.press('Control+Enter')
        if wait_for_start and not self._is_soon(begun, _REACT_SEC / 2):
            self._say(f'cell {index} did not begin by keyboard')
            self._lab_page.command('notebook:enter-command-mode')
            self._page.evaluate(_ACTIVATE, index)
            self._page.keyboard.press('Control+Enter')
            self._wait(begun, f'cell {index} to begin')

    def _reload(self) -> None:
        self._lab_page.reload()
        self._page.evaluate(_LISTEN)
        # Views come back one after another, once the kernel has reported them.
        self._becomes(lambda: self._page.evaluate(_LIVE_CELLS))

    # -- the look ----------------------------------------------------------------------------------------

    def _compare(self, index: int, when: str) -> None:
        cell, stored = self._cells[index]
        if stored.is_skipped or PRESENT_STATE in cell.metadata.get('tags', []):
            return
        self.report.compared += 1
        now = self._cell(index)
        difference = ('    it did not run' if now.execution_count is None and cell.source.strip()
                      else stored.difference(now.outputs))
        if difference:
            errors = ''.join(f'\n    {output.ename}: {output.evalue}' for output in now.outputs
                             if output.output_type == 'error')
            self.report.found.append(f'cell {index}, {when}:\n{cell.source}\n--\n{difference}{errors}')

    def _cell(self, index: int) -> NotebookNode:
        cell = json.loads(self._page.evaluate(_CELL, index))
        cell.get('metadata', {}).pop('execution', None)
        notebook = {'cells': [cell], 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5}
        return nbformat.reads(json.dumps(notebook), as_version=4).cells[0]

    def _counts(self) -> list[int | None]:
        return [count for count, _ in self._page.evaluate(_CELLS)]

    def _values(self, node: str) -> dict[str, str]:
        values: dict[str, str] = ast.literal_eval(self._lab.ask_kernel(_VALUES.format(node=node)))
        return values

    def _busy(self) -> dict[int, float]:
        """Return how long each cell kept the kernel, of those that the page has run one after another, in s."""
        began: dict[str, float] = {}
        lengths = []
        for kind, identity, state, time_ms in self._page.evaluate('() => window.strangerLog'):
            if kind == 'execute_request' and state == 'busy':
                began[identity] = time_ms
            elif kind == 'execute_request' and identity in began:
                lengths.append((time_ms - began.pop(identity)) / 1000)
        return dict(zip(self._cells, lengths)) if len(lengths) == len(self._cells) else {-1: max(lengths, default=0.0)}

    def _all_ran(self) -> bool:
        """Return whether each cell has its number, or the kernel has been idle for a while.

        JupyterLab itself holds Run All for ended at the first error, also if it is one that is meant.
        """
        for _ in range(_IDLE_LOOKS):
            if all(self._counts()[index] is not None or not cell.source.strip()
                   for index, (cell, _) in self._cells.items()):
                return True
            if self._lab.kernels()[0]['execution_state'] != 'idle':
                return False
            self._page.wait_for_timeout(_LOOK_MS)
        return True

    def _wait_for_end(self, indices: set[int], what: str) -> None:
        def ended() -> bool:
            cells = self._page.evaluate(_CELLS)
            return not any(cells[index][1] == 'running' for index in indices)

        self._wait(ended, f'{what} to end')

    def _changes(self, look: Callable[[], object], before: object) -> bool:
        return self._becomes(lambda: look() != before)

    def _becomes(self, condition: Callable[[], object]) -> bool:
        return self._is_soon(condition, _REACT_SEC)

    def _is_soon(self, condition: Callable[[], object], timeout_sec: float) -> bool:
        deadline = time.monotonic() + timeout_sec
        while not condition():
            if time.monotonic() > deadline:
                return False
            self._page.wait_for_timeout(_LOOK_MS)
        return True

    def _wait(self, condition: Callable[[], object], what: str, timeout_sec: float = _HANG_SEC) -> None:
        if not self._is_soon(condition, timeout_sec):
            states = dict(enumerate(state for _, state in self._page.evaluate(_CELLS)))
            running = [index for index, state in states.items() if state == 'running']
            no_code = [index for index in self._cells if not states.get(index)]
            raise Hang(f'HANGS: waited {timeout_sec:g} s for {what}; running cells: {running}; no longer code: '
                       f'{no_code}; kernels: {self._lab.kernels()}\n{"".join(self._stacks())}')

    def _stacks(self) -> Iterator[str]:
        """Yield where the threads of the kernels are, if py-spy is on the PATH."""
        if py_spy := shutil.which('py-spy'):
            for kernel in self._lab.kernels():
                for process in Path('/proc').glob('[0-9]*'):
                    if f'kernel-{kernel["id"]}.json' in (process / 'cmdline').read_text():
                        yield subprocess.run([py_spy, 'dump', '--pid', process.name], capture_output=True,
                                             text=True).stdout

    def _say(self, text: str) -> None:
        if self._verbose:
            print(f'    {time.strftime("%M:%S")} {text}', flush=True)


def write(report: Report, seconds: float) -> None:
    """Print what was seen in a chapter."""
    print(f'{report.chapter}: {report.actions} actions ({report.missed} missed), {report.compared} outputs compared, '
          f'{report.live} views used, {len(report.found)} things wrong, {seconds:.0f} s')
    slow = {index: length for index, length in report.busy.items() if length > _BUSY_SEC}
    if slow:
        print('  busy:', ', '.join(f'cell {index} {length:.1f} s' for index, length in slow.items()))
    if report.failed:
        print('  errors out of order:', ', '.join(f'{name} {count}' for name, count in report.failed.items()))
    print(*report.found, sep='\n\n', end='\n\n' if report.found else '', flush=True)


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
            stranger = Stranger(lab, page, path, random.Random(f'{options.seed} {path.name}'),
                                mess=options.mess, verbose=options.verbose)
            stranger.play_chapter()
            page.page.close()
            lab.end_kernels()
            write(stranger.report, time.monotonic() - began)
            status |= bool(stranger.report.found)
    return status


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
