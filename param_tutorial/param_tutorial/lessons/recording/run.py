"""Runs a chapter in kernels of its own: its outputs are compared with the stored ones, and its views recorded.

One kernel runs the chapter to its end, and says what views its page has. For each cell that shows widgets, another one
runs the chapter up to that cell and stops there, and the recorder asks the node behind the view all that a reader may
ask. So every answer comes from the very state that the page shows, and no question can disturb the lesson.
"""

import ast
import contextlib
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
from ipykernel.kernelspec import get_kernel_dict
from jupyter_client.kernelspec import KernelSpec
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbformat import NotebookNode

from param_tutorial.exercises import prediction
from param_tutorial.lessons.recording import comparison
from param_tutorial.lessons.recording.recorded import Page, Recording, ViewFacts
from param_tutorial.runtime import domain

WIDGET = 'application/vnd.jupyter.widget-view+json'
_ANSWER = 'application/x-param-tutorial-recording+json'
_CELL_TIMEOUT_SEC = 300
# What these cells name are numbers of predictions and chapters, which nobody types into a panel.
_ABOUT_LEARNER = re.compile(r'^exercises\.(predict|progress|certificate)\(', re.MULTILINE)


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


def run_chapter(path: Path) -> list[ViewFacts]:
    """Run a chapter to its end.

    :return: What the recordings have to know of the views that it shows.
    :raises ChapterError: it fails, or an output is not the stored one.
    """
    with _executed(path) as client:
        shown = [model_id for _, cell in cells_with_widgets(client.nb) for model_id, _ in _widgets_of(cell)]
        return _ask_recorder(path, client, len(client.nb.cells) - 1, 'describe', shown) if shown else []


def record_cell(path: Path, index: int, views: list[ViewFacts]) -> list[Recording]:
    """Run a chapter up to a cell that shows widgets, and record these.

    :param views: What ``run_chapter`` has returned.
    :return: The recordings of the widgets, in their order.
    :raises ChapterError: it fails, or an output is not the stored one.
    """
    with _executed(path, index + 1) as client:
        page: Page = {'literals': literals_of(client.nb), 'views': views}
        # Who has no view has the text that stands in its place.
        return [_ask_recorder(path, client, index, 'record', model_id, page) or
                {'kind': 'still', 'html': '', 'text': text} for model_id, text in _widgets_of(client.nb.cells[index])]


def read_notebook(path: Path) -> NotebookNode:
    """Return the notebook in a file.

    :raises ChapterError: there is none in it.
    """
    try:
        notebook: NotebookNode = nbformat.read(path, as_version=4)
    except Exception as error:
        raise ChapterError(path, 0, '', f'it cannot be read: {error}') from None
    return notebook


def cells_with_widgets(notebook: NotebookNode) -> Iterator[tuple[int, NotebookNode]]:
    """Yield the cells that show a widget to record, each with its index."""
    for index, cell in enumerate(notebook.cells):
        if _widgets_of(cell):
            yield index, cell


def literals_of(notebook: NotebookNode) -> list[Any]:
    """Return the values that a chapter's code speaks of: its readers will try them."""
    found: dict[str, Any] = {}
    for cell in notebook.cells:
        if cell.cell_type != 'code' or _ABOUT_LEARNER.search(cell.source):
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


def _widgets_of(cell: NotebookNode) -> list[tuple[str, str]]:
    """Return the model ids of the widgets that a cell shows, each with the text in its place.

    A prediction is not among them: it follows nothing, so there is nothing to record.
    """
    return [(output.data[WIDGET]['model_id'], output.data.get('text/plain', '')) for output in cell.get('outputs', ())
            if WIDGET in output.get('data', {}) and prediction.MIME_TYPE not in output.data]


@contextlib.contextmanager
def _executed(path: Path, end: int | None = None) -> Iterator[NotebookClient]:
    """Run the cells before one, compare what each puts out, and keep the kernel for a while."""
    with started(path) as client:
        for index, cell, stored in cells_to_run(client.nb, path):
            if (end is None or index < end) and not stored.is_skipped:
                _execute_and_compare(path, client, index, cell, stored)
        yield client


@contextlib.contextmanager
def started(path: Path, *, allow_errors: bool = False) -> Iterator[NotebookClient]:
    """Start a kernel for a chapter, in a ROS domain of its own, and end it.

    :param allow_errors: Whether a cell that ends in an error is one like any other.
    """
    client = NotebookClient(read_notebook(path), timeout=_CELL_TIMEOUT_SEC, kernel_manager_class=OwnKernel,
                            coalesce_streams=True, store_widget_state=False, allow_errors=allow_errors,
                            resources={'metadata': {'path': str(path.parent)}})
    # What a kernel says beside its messages is of the kernel and not of the lesson.
    with client.setup_kernel(env=domain.environment_without_domain(), stderr=subprocess.DEVNULL):
        yield client


def cells_to_run(notebook: NotebookNode, path: Path) -> list[tuple[int, NotebookNode, comparison.Cell]]:
    """Return the code cells of a chapter: their indices, themselves, and what is stored with them."""
    code_cells = [(index, cell) for index, cell in enumerate(notebook.cells) if cell.cell_type == 'code']
    return [(index, cell, stored) for (index, cell), stored in zip(code_cells, comparison.cells_of(path))]


def _execute_and_compare(path: Path, client: NotebookClient, index: int, cell: NotebookNode,
                         stored: comparison.Cell) -> None:
    if cell.execution_count is None:
        raise ChapterError(path, index + 1, cell.source, 'it was saved without being run.')
    cell.outputs = []
    _execute(path, client, cell, index)
    if difference := stored.difference(cell.outputs):
        raise ChapterError(path, index + 1, cell.source,
                           f'its output differs from the stored one.\n{difference}')


def _execute(path: Path, client: NotebookClient, cell: NotebookNode, index: int) -> None:
    try:
        client.execute_cell(cell, index)
    except CellExecutionError as error:
        raise ChapterError(path, index + 1, cell.source, f'it raises {error.ename}: {error.evalue}') from None
    except CellTimeoutError:
        raise ChapterError(path, index + 1, cell.source, f'it is still running after {_CELL_TIMEOUT_SEC} s.') from None
    except DeadKernelError:
        raise ChapterError(path, index + 1, cell.source, 'its kernel has died.') from None


def _ask_recorder(path: Path, client: NotebookClient, index: int, function: str, *arguments: Any) -> Any:
    """Call a function of the recorder in the kernel, and return what it returns."""
    question = nbformat.v4.new_code_cell(
        'import IPython.display\n'
        'from param_tutorial.lessons.recording import recorder\n'
        f'returned = recorder.{function}({", ".join(map(repr, arguments))})\n'
        f'IPython.display.display({{{_ANSWER!r}: {{"returned": returned}}}}, raw=True)')
    source = client.nb.cells[index].source
    client.nb.cells.append(question)
    _execute(path, client, question, index)
    for output in question.outputs:
        if _ANSWER in output.get('data', {}):
            return output['data'][_ANSWER]['returned']
    raise ChapterError(path, index + 1, source, f'its views cannot be recorded: {json.dumps(question.outputs)[:1000]}')
