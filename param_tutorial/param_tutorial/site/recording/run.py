"""Runs a chapter in kernels of its own: its outputs are compared with the stored ones, and its views recorded.

One kernel runs the chapter to its end. Views that stand still are recorded there as they appear. For each other cell
that shows widgets, another kernel runs the chapter up to that cell and stops there, and the recorder asks the node
behind the view all that a reader may ask. So every answer comes from the very state that the page shows, and no
question can disturb the lesson. One more kernel tries what a reader may answer to the chapter's exercises.
"""

import ast
import asyncio
import contextlib
import json
import re
import subprocess
from collections.abc import Callable, Coroutine, Iterator
from pathlib import Path
from typing import Any

import nbformat
from ipykernel.kernelspec import get_kernel_dict
from jupyter_client.kernelspec import KernelSpec
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbclient.util import run_sync
from nbformat import NotebookNode

from param_tools.ros import domain
from param_tutorial.exercises import EXERCISES, prediction
from param_tutorial.site.recording import comparison
from param_tutorial.site.recording.recorded import Page, Recording, Recordings, ViewFacts

WIDGET = 'application/vnd.jupyter.widget-view+json'
_ANSWER = 'application/x-param-tutorial-recording+json'
# When a cell has run, its outputs come through another socket, and the limit for those is nbclient's.
_CELL_TIMEOUT_SEC = 300
_OUTPUTS_TIMEOUT_SEC = 120
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


def record_chapter(path: Path) -> Recordings:
    """Run a chapter to its end, and record the views that it shows.

    :raises ChapterError: it fails, or an output is not the stored one.
    """
    recordings, views = _run_to_the_end(path)
    page: Page = {'literals': literals_of(read_notebook(path)), 'source': source_of(path), 'views': views, 'albums': []}
    for index, cell in cells_with_widgets(read_notebook(path)):
        if cell.id not in recordings:
            recordings[cell.id] = record_cell(path, index, page)
            page['albums'] += [name for each in recordings[cell.id] for part in each.get('parts', [each])
                               for name in part.get('albums', ())]
    return {cell.id: recordings[cell.id] for _, cell in cells_with_widgets(read_notebook(path))} | _record_answers(path)


def _run_to_the_end(path: Path) -> tuple[Recordings, list[ViewFacts]]:
    """Run a chapter to its end; return the recordings of what stands still, and what the others have to know."""
    recordings: Recordings = {}

    def record_still(client: NotebookClient, index: int) -> None:
        cell = client.nb.cells[index]
        page: Page = {'literals': [], 'source': '', 'views': [], 'albums': []}
        recorded = [_ask_recorder(path, client, index, 'recorder.record_still', model_id, page)
                    for model_id, _ in _widgets_of(cell)]
        if recorded and {} not in recorded:
            recordings[cell.id] = [each or _text_of(text) for each, (_, text) in zip(recorded, _widgets_of(cell))]

    with _executed(path, after=record_still) as client:
        shown = [model_id for _, cell in cells_with_widgets(client.nb) for model_id, _ in _widgets_of(cell)]
        views = _ask_recorder(path, client, len(client.nb.cells) - 1, 'recorder.describe', shown) if shown else []
    return recordings, views


def record_cell(path: Path, index: int, page: Page) -> list[Recording]:
    """Run a chapter up to a cell that shows widgets, and record these.

    :param page: What the recordings have to know of the page.
    :return: The recordings of the widgets, in their order.
    :raises ChapterError: it fails, or an output is not the stored one.
    """
    with _executed(path, index + 1) as client:
        return [_ask_recorder(path, client, index, 'recorder.record', model_id, page) or _text_of(text)
                for model_id, text in _widgets_of(client.nb.cells[index])]


def _record_answers(path: Path) -> Recordings:
    """Record the answers to the exercises that a page has a form for, by the ids of the cells with their checks."""
    cells = {cell.id: (index, cell.source) for index, cell in enumerate(read_notebook(path).cells)}
    numbers = {f'check-{number.replace(".", "-")}': number for number, exercise in EXERCISES.items() if exercise.form}
    recordings: Recordings = {}
    wanted = {name: number for name, number in numbers.items() if name in cells}
    solved = path.parent / 'solutions' / path.name
    if not wanted or not solved.exists():
        return recordings
    solutions = {cell.id: cell.source for cell in read_notebook(solved).cells}
    with started(path) as client:
        for name, number in wanted.items():
            part = name.removeprefix('check-')
            index, source = cells[f'exercise-{part}']
            recordings[name] = [_ask_recorder(path, client, index, 'answers.record', number, source,
                                              solutions[f'solution-{part}'])]
    return recordings


def _text_of(text: str) -> Recording:
    """Return what stands in the place of a widget that is no view."""
    return {'kind': 'still', 'html': '', 'text': text}


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


def source_of(path: Path) -> str:
    """Return the code of a chapter and of its solutions, which set parameters to what readers will try."""
    paths = [path, *[each for each in [path.parent / 'solutions' / path.name] if each.exists()]]
    return '\n'.join(cell.source for each in paths for cell in read_notebook(each).cells if cell.cell_type == 'code')


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
def _executed(path: Path, end: int | None = None, *,
              after: Callable[[NotebookClient, int], None] | None = None) -> Iterator[NotebookClient]:
    """Run the cells before one, compare what each puts out, and keep the kernel for a while.

    :param after: Called with the index of each cell that has run.
    """
    with started(path) as client:
        for index, cell, stored in cells_to_run(client.nb, path):
            if (end is None or index < end) and not stored.is_skipped:
                _execute_and_compare(path, client, index, cell, stored)
                if after:
                    after(client, index)
        yield client


@contextlib.contextmanager
def started(path: Path) -> Iterator[NotebookClient]:
    """Start a kernel for a chapter, in a ROS domain of its own, and end it."""
    client = NotebookClient(
        read_notebook(path), timeout=None, iopub_timeout=_OUTPUTS_TIMEOUT_SEC, raise_on_iopub_timeout=True,
        kernel_manager_class=OwnKernel, coalesce_streams=True, store_widget_state=False,
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


def _execute(path: Path, client: NotebookClient, cell: NotebookNode, index: int, *,
             position: int | None = None) -> None:
    """Execute a cell.

    :param index: Of the cell to name if that fails.
    :param position: Where it stands, if that is elsewhere.
    """
    try:
        run_sync(_in_time)(client.async_execute_cell(cell, index if position is None else position))
    except CellExecutionError as error:
        raise ChapterError(path, index + 1, cell.source, f'it raises {error.ename}: {error.evalue}') from None
    except CellTimeoutError:
        raise ChapterError(path, index + 1, cell.source,
                           f'its outputs have not come within {_OUTPUTS_TIMEOUT_SEC} s.') from None
    except TimeoutError:
        raise ChapterError(path, index + 1, cell.source, f'it is still running after {_CELL_TIMEOUT_SEC} s.') from None
    except DeadKernelError:
        raise ChapterError(path, index + 1, cell.source, 'its kernel has died.') from None


async def _in_time(work: Coroutine[Any, Any, Any]) -> None:
    """Wait for what runs a cell.

    :raises TimeoutError: it takes too long.
    """
    running = asyncio.ensure_future(work)
    if not (await asyncio.wait([running], timeout=_CELL_TIMEOUT_SEC))[0]:
        running.cancel()
        with contextlib.suppress(DeadKernelError):  # as nbclient calls it
            await running
        raise TimeoutError
    running.result()


def _ask_recorder(path: Path, client: NotebookClient, index: int, function: str, *arguments: Any) -> Any:
    """Call a function in the kernel, and return what it returns.

    :param function: 'recorder.…' or 'answers.…'.
    """
    question = nbformat.v4.new_code_cell(
        'import IPython.display\n'
        'from param_tutorial.site.recording import answers, recorder\n'
        f'returned = {function}({", ".join(map(repr, arguments))})\n'
        f'IPython.display.display({{{_ANSWER!r}: {{"returned": returned}}}}, raw=True)')
    source = client.nb.cells[index].source
    # nbclient puts it at its index, so that has to be its own.
    client.nb.cells.append(question)
    try:
        _execute(path, client, question, index, position=len(client.nb.cells) - 1)
    finally:
        client.nb.cells.pop()
    for output in question.outputs:
        if _ANSWER in output.get('data', {}):
            return output['data'][_ANSWER]['returned']
    raise ChapterError(path, index + 1, source, f'its views cannot be recorded: {json.dumps(question.outputs)[:1000]}')
