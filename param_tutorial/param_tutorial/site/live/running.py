"""Runs a chapter in the kernel of its page, when the site is built: Pyodide in Node.js, with the page's own script.

What the cells put out is compared with what is stored in the notebook; a page of which the node says something else is
not made. The states of the widgets after each cell are the page's first pictures.
"""

import hashlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import nbformat

from param_tools.markup.styles import sheet
from param_tutorial.exercises.prediction import MIME_TYPE
from param_tutorial.notebook.stored import DOES_NOT_RUN, WIDGET
from param_tutorial.site.comparison import Cell, cells_of

_RUN = Path(__file__).with_name('run.mjs')
# By a chapter's name: the first line of a cell whose output differs in a page, and why.
EXPLAINED = {
    '02_workspace': {"exercises.check('2d', package)": 'no shell has changed the greeting'},
    '05_1_from_the_command_line': {'%ros2_terminal': 'no terminal finds the nodes of a page'},
    '09_from_ros1': {"ros.add(Gripper, ros_args=['--params-file', 'old.yaml'])": "rcl's error names its own C files"},
}
_KEPT = {'_dom_classes', '_model_name', '_esm', '_css'}
_DROPPED = {'layout', 'style', 'tabbable', 'tooltip', 'box_style', 'description_allow_html', 'placeholder',
            'own_id'}
_SHARED = ('_esm', '_css')


class ChapterError(Exception):
    """A chapter does not run, or does not do what is stored in it; the message names the notebook and the cell."""


class LiveCell(NamedTuple):
    """What a page has to know of a code cell."""

    id: str
    source: str
    digest: str
    """Of its outputs in the page's kernel."""
    roots: list[str]
    """The names of the widgets that it shows, in order."""
    states: dict[str, Any]
    """Of these widgets and all within them, when the cell had run and what moves had come to rest."""


class LiveChapter(NamedTuple):
    """A chapter as its page's kernel ran it."""

    cells: list[LiveCell]
    shared: dict[str, str]
    """Scripts and styles of the widgets, by the names that stand for them in the states."""


def run_chapter(path: Path, pyodide: Path, packages: Path) -> LiveChapter:
    """Run a chapter to its end.

    :param pyodide: The folder that ``browser.page_python`` has filled.
    :param packages: The file with what ``python_files.packages`` returns.
    :raises ChapterError: an output is not the stored one, for no known reason.
    """
    ran = run_notebook(path, pyodide, packages, to_rest=True)
    for cell, difference in differing_cells(path, ran):
        if not cell.cell.source.startswith(tuple(EXPLAINED.get(path.stem, ()))):
            number = 1 + [each.id for each in nbformat.read(path, as_version=4).cells].index(cell.cell.id)
            first_line = cell.cell.source.strip().splitlines()[0]
            raise ChapterError(f"{path.name}, cell {number} ({first_line}): its page's node says something else than "
                               f'is stored with it\n{difference}')
    return _chapter(path, ran)


def run_notebook(path: Path, pyodide: Path, packages: Path, *, to_rest: bool = False) -> list[dict[str, Any]]:
    """Return what each code cell of a notebook puts out in a page, as ``run.mjs`` says it.

    :param pyodide: As for ``run_chapter``.
    :param packages: The same.
    :param to_rest: After each cell wait until what moves has come to rest.
    :raises ChapterError: the kernel does not start, or ends.
    """
    with tempfile.TemporaryDirectory() as folder:
        kernel = Path(folder, 'kernel.mjs')
        kernel.write_text(sheet('param_tutorial/site/live/kernel.js'), encoding='utf-8')
        with Path(folder, 'said').open('w+', encoding='utf-8') as said, subprocess.Popen(
                [Path(sys.executable).with_name('node'), _RUN, pyodide, packages, kernel, path, *['rest'] * to_rest],
                # It ends with its input, and so with this process, however that ends.
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said, text=True) as process:
            assert process.stdout
            ran = process.stdout.read()
            if process.wait():
                said.seek(0)
                raise ChapterError(f'{path.name}: its page has no kernel: {said.read()[-2000:]}')
    return list(json.loads(ran))


def differing_cells(path: Path, ran: list[dict[str, Any]]) -> list[tuple[Cell, str]]:
    """Compare what ``run_notebook`` has returned with what is stored in the notebook, as nbval does.

    :return: Cells with other outputs, each with the difference in words.
    """
    different = []
    for cell, result in zip(cells_of(path), ran, strict=True):
        outputs = [nbformat.from_dict(_as_stored(each)) for each in result['outputs']]
        if not (cell.is_skipped or says_why_not(result)) and (difference := cell.difference(outputs)):
            different.append((cell, difference))
    return different


def says_why_not(result: Mapping[str, Any]) -> bool:
    """True if a cell says that there is no shell, and shows what is stored."""
    return any(each.get('text', '').startswith(DOES_NOT_RUN) for each in result['outputs'][:1])


def _as_stored(output: dict[str, Any]) -> dict[str, Any]:
    kept = {key: value for key, value in output.items() if key != 'display'}
    if 'data' in kept:
        kept['metadata'] = {}
    if kept['output_type'] == 'execute_result':
        kept['execution_count'] = None
    return kept


def _chapter(path: Path, ran: list[dict[str, Any]]) -> LiveChapter:
    sources = {cell.id: cell.source for cell in nbformat.read(path, as_version=4).cells}
    states: dict[str, dict[str, Any]] = {}
    shared: dict[str, str] = {}
    cells = []
    for result in ran:
        for said in result['said']:
            if said['is'] == 'widget' and said['does'] in ('open', 'update'):
                states.setdefault(said['name'], {}).update(said['state'])
        roots = [each['data'][WIDGET]['model_id'] for each in result['outputs']
                 if WIDGET in each.get('data', {}) and MIME_TYPE not in each['data']]
        within = {name: _lean(states[name], shared) for root in roots for name in _within(root, states)}
        cells.append(LiveCell(result['cell'], sources[result['cell']], result['digest'], roots, within))
    return LiveChapter(cells, shared)


def children(state: Mapping[str, Any]) -> list[str]:
    """Return the names of the widgets in a box."""
    return [each.removeprefix('IPY_MODEL_') for each in state.get('children', ())]


def _within(root: str, states: Mapping[str, Mapping[str, Any]]) -> Iterable[str]:
    yield root
    for name in children(states[root]):
        yield from _within(name, states)


def _lean(state: Mapping[str, Any], shared: dict[str, str]) -> dict[str, Any]:
    """Return what a front end needs of a state; what all widgets of a kind have in common is replaced by its name."""
    lean = {key: value for key, value in state.items()
            if key in _KEPT or not (key.startswith('_') or key in _DROPPED or value is None)}
    for key in _SHARED:
        if lean.get(key):
            name = hashlib.sha256(lean[key].encode()).hexdigest()[:12]
            shared[name] = lean[key]
            lean[key] = name
    return lean
