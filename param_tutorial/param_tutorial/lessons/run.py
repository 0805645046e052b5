"""Runs a chapter in kernels of its own: its outputs are compared with the stored ones, and its widgets recorded.

One kernel runs the chapter to its end. For each widget that a cell shows, another one runs it up to that cell and
stops there, and the recorder asks the node behind the widget all that a reader may ask. So every answer comes from
the very state that the page shows, and no question can disturb the lesson.
"""

import ast
import contextlib
import copy
import difflib
import json
import os
import re
import subprocess
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
from ipykernel.kernelspec import get_kernel_dict
from jupyter_client.kernelspec import KernelSpec
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbval.plugin import coalesce_streams, find_comment_markers, find_metadata_tags

WIDGET = 'application/vnd.jupyter.widget-view+json'
_RECORDING = 'application/x-param-tutorial-recording+json'
_CELL_TIMEOUT_SEC = 120
# What nbval leaves out of its comparison; a model's id is random.
_NOT_COMPARED = ('metadata', 'traceback', 'output_type', 'name', 'execution_count', WIDGET, 'image/png', 'image/jpeg')
_DIFFERENT_LINES = 20
_LINE_LENGTH = 160


class ChapterError(Exception):
    """A chapter does not run, or does not do what is stored in it; the message names the notebook and the cell."""

    def __init__(self, path: Path, cell: int, source: str, what: str):
        """
        :param cell: Its number as a reader counts cells, from 1; 0 for the notebook as a whole.
        :param what: What is wrong, over several lines if need be.
        """
        super().__init__(path, cell, source, what)

    def __str__(self) -> str:
        path, cell, source, what = self.args
        first_line = source.strip().splitlines()[0] if source.strip() else ''
        return f'{path.name}, cell {cell} ({first_line}): {what}' if cell else f'{path.name}: {what}'


class OwnKernel(AsyncKernelManager):
    """The kernel of this very Python, whatever `python3` means to the Jupyter of this machine."""

    @property
    def kernel_spec(self) -> KernelSpec:
        """What starts it."""
        return KernelSpec(**get_kernel_dict())


def parts(path: Path) -> list[int | None]:
    """Give the parts of a chapter's work, each for a kernel of its own, and as many at once as one likes.

    :return: None for the run to the end, and the index of each cell whose widgets are to be recorded.
    :raises ChapterError: the notebook cannot be read.
    """
    return [None, *(index for index, _ in cells_with_widgets(read(path)))]


def run_part(path: Path, part: int | None) -> list[dict[str, Any]]:
    """Run a chapter to its end, or up to a cell whose widgets it records.

    :return: The recordings of that cell's widgets, in their order; none for the run to the end.
    :raises ChapterError: it fails, or an output is not the stored one.
    """
    stored = read(path)
    notebook = copy.deepcopy(stored)
    with _kernel(path, notebook) as client:
        _execute(path, client, stored, len(stored.cells) if part is None else part + 1)
        if part is None:
            return []
        shown = [output['data'][WIDGET]['model_id'] for output in notebook.cells[part].outputs
                 if WIDGET in output.get('data', {})]
        # A page that shows events wants those of its panels.
        options = {'events': any('EventView(' in cell.source for cell in stored.cells if cell.cell_type == 'code')}
        return [_ask_recorder(path, client, part, f'{model_id!r}, {literals_of(stored)!r}, **{options!r}')
                for model_id in shown]


def read(path: Path) -> nbformat.NotebookNode:
    """Read a notebook.

    :raises ChapterError: it is none.
    """
    try:
        return nbformat.read(path, as_version=4)
    except Exception as error:
        raise ChapterError(path, 0, '', f'it cannot be read: {error}') from None


def cells_with_widgets(notebook: nbformat.NotebookNode) -> Iterator[tuple[int, nbformat.NotebookNode]]:
    """Give the cells that show a widget, each with its index."""
    for index, cell in enumerate(notebook.cells):
        if any(WIDGET in output.get('data', {}) for output in cell.get('outputs', ())):
            yield index, cell


def literals_of(notebook: nbformat.NotebookNode) -> list[Any]:
    """Give the values that a chapter's code speaks of: its readers will try them."""
    found: dict[str, Any] = {}
    for cell in notebook.cells:
        if cell.cell_type != 'code':
            continue
        # Magics are no Python; the other cells are enough.
        with contextlib.suppress(SyntaxError):
            for each in ast.walk(ast.parse(cell.source)):
                with contextlib.suppress(ValueError):
                    if isinstance(each, (ast.Constant, ast.UnaryOp, ast.List)):
                        value = ast.literal_eval(each)
                        if isinstance(value, (bool, int, float, str, list)) and len(repr(value)) <= 60:
                            found[repr(value)] = value
    return list(found.values())


@contextlib.contextmanager
def _kernel(path: Path, notebook: nbformat.NotebookNode) -> Iterator[NotebookClient]:
    client = NotebookClient(notebook, timeout=_CELL_TIMEOUT_SEC, kernel_manager_class=OwnKernel,
                            coalesce_streams=True, store_widget_state=False,
                            resources={'metadata': {'path': str(path.parent)}})
    # Each kernel claims a ROS domain of its own.
    environment = {name: value for name, value in os.environ.items() if name != 'ROS_DOMAIN_ID'}
    # What a kernel says beside its messages is of the kernel and not of the lesson.
    with client.setup_kernel(env=environment, stderr=subprocess.DEVNULL):
        yield client


def _execute(path: Path, client: NotebookClient, stored: nbformat.NotebookNode, end: int) -> None:
    """Run the cells before one, and compare what each puts out."""
    for index, cell in enumerate(client.nb.cells[:end]):
        if cell.cell_type != 'code':
            continue
        if stored.cells[index].execution_count is None:
            raise ChapterError(path, index + 1, cell.source, 'it was saved without being run.')
        cell.outputs = []
        _execute_one(path, client, cell, index)
        options = dict([*find_comment_markers(cell.source), *find_metadata_tags(cell.metadata)])
        if options.get('skip') or options.get('check') is False:
            continue
        if difference := compare(stored.cells[index].outputs, cell.outputs):
            raise ChapterError(path, index + 1, cell.source,
                               f'what it puts out is not what is stored with it.\n{difference}')


def _execute_one(path: Path, client: NotebookClient, cell: nbformat.NotebookNode, index: int) -> None:
    try:
        client.execute_cell(cell, index)
    except CellExecutionError as error:
        raise ChapterError(path, index + 1, cell.source, f'it ends in {error.ename}: {error.evalue}') from None
    except CellTimeoutError:
        raise ChapterError(path, index + 1, cell.source, f'it has not ended after {_CELL_TIMEOUT_SEC} s.') from None
    except DeadKernelError:
        raise ChapterError(path, index + 1, cell.source, 'its kernel has died.') from None


def _ask_recorder(path: Path, client: NotebookClient, index: int, arguments: str) -> dict[str, Any]:
    question = nbformat.v4.new_code_cell(
        'import IPython.display\n'
        'from param_tutorial.lessons import recorder\n'
        f'IPython.display.display({{{_RECORDING!r}: recorder.record({arguments})}}, raw=True)')
    client.nb.cells.append(question)
    _execute_one(path, client, question, index)
    for output in question.outputs:
        if _RECORDING in output.get('data', {}):
            return output['data'][_RECORDING]
    raise ChapterError(path, index + 1, client.nb.cells[index].source,
                       f'its widget cannot be recorded: {json.dumps(question.outputs)[:1000]}')


def compare(stored: list[Any], new: list[Any]) -> str:
    """Compare the outputs of a cell as nbval does.

    :return: What differs, for people; empty if nothing does.
    """
    before, after = _flat(stored), _flat(new)
    for key in [*before, *(key for key in after if key not in before)]:
        if before.get(key) != after.get(key):
            lines = difflib.unified_diff(_lines(before.get(key, [])), _lines(after.get(key, [])),
                                         f'stored {key}', f'new {key}', lineterm='', n=1)
            return '\n'.join(f'    {line[:_LINE_LENGTH]}' for line in list(lines)[:_DIFFERENT_LINES])
    return ''


def _lines(texts: list[str]) -> list[str]:
    # HTML is often one long line; between two elements it may be broken.
    return re.sub(r'(?<=>)(?=<)', '\n', '\n'.join(texts)).splitlines()


def _flat(outputs: list[Any]) -> dict[str, list[str]]:
    flat = defaultdict(list)
    for output in coalesce_streams(copy.deepcopy(outputs)):
        if output.output_type == 'stream':
            flat[output.name].append(output.text)
            continue
        for key, value in [*output.items(), *output.get('data', {}).items()]:
            if key not in _NOT_COMPARED and key != 'data':
                flat[key].append(value if isinstance(value, str) else json.dumps(value, sort_keys=True))
    return dict(flat)
