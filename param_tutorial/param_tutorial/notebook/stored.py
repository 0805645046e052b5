"""What a cell prints that can't run where there are no processes, as it is stored in the notebook.

Such a cell is typed into a shell, or uses one, or uses what another such cell would have made: ``robot =
Terminal(…, shell=runner)``, and then every cell with ``robot``. ``install`` puts a sentence in its place, and below it
the outputs that the notebook has stored for exactly this text. The build of a page gets them with ``collect``, and the
page hands them to ``offer`` when it starts.
"""

import ast
import contextlib
import functools
import shlex
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypedDict

from IPython.core.error import UsageError
from IPython.core.inputtransformer2 import TransformerManager
from IPython.core.interactiveshell import InteractiveShell
from IPython.display import publish_display_data

from param_tools.errors import NoProcessError
from param_tools.panel.close_with_cell import this_cell
from param_tutorial.notebook.shell import NO_SHELL, Shell

WIDGET = 'application/vnd.jupyter.widget-view+json'
"""In an output of a cell: the widget that it shows."""
DOES_NOT_RUN = f'{NO_SHELL[0].upper()}{NO_SHELL[1:]}, so this cell does not run here.'
"""What a cell without a shell says first."""
_MAGIC = 'stored_output'


class Cell(TypedDict):
    """A cell that can't run without processes."""

    id: str
    source: str
    outputs: list[dict[str, Any]]
    """As nbformat has them."""


_offered: list[Cell] = []


def offer(cells: Iterable[Cell]) -> None:
    """Give cells whose outputs can be shown."""
    _offered.extend(cells)


def collect(notebook: Mapping[str, Any]) -> list[Cell]:
    """Return those cells of a notebook that can't run without processes.

    :param notebook: As JSON has it.
    """
    found: list[Cell] = []
    missing: set[str] = set()
    for cell in notebook['cells']:
        source = ''.join(cell['source'])
        if cell['cell_type'] != 'code':
            continue
        if depends_on(source, missing):
            found.append({'id': cell['id'], 'source': source, 'outputs': cell['outputs']})
            missing |= _assigned(_parsed(source))
        else:
            missing -= _assigned(_parsed(source))
            missing |= _shells_in(_parsed(source))
    return found


def _outputs_of(source: str) -> list[dict[str, Any]]:
    """Return the stored outputs of the cell that runs, if it is as it was stored."""
    found = [each for each in _offered if each['source'].rstrip() == source.rstrip()]
    if len(found) > 1:  # the same command, typed again after something has changed
        found = [each for each in found if each['id'] == this_cell()[0]]
    return found[0]['outputs'] if found else []


def _show(outputs: list[dict[str, Any]]) -> None:
    for output in outputs:
        if output['output_type'] == 'stream':
            print(_text(output['text']), end='', file=sys.stderr if output['name'] == 'stderr' else sys.stdout)
        elif output['output_type'] == 'error':
            print(f'{output["ename"]}: {output["evalue"]}', file=sys.stderr)
        else:
            publish_display_data({kind: _text(data) for kind, data in output['data'].items() if kind != WIDGET})


def _text(lines: Any) -> Any:
    return ''.join(lines) if isinstance(lines, list) else lines


class Missing:
    """Stands for what a cell would have made that can't run here."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith('__'):
            raise AttributeError(name)
        raise NoProcessError(f'{NO_SHELL}, so the cell that makes this has not run')

    def __repr__(self) -> str:
        return f'<missing: {NO_SHELL}>'


def install(ipython: InteractiveShell) -> None:
    """Have each cell that can't run replaced by what is stored of it; safe to call more than once."""
    if _MAGIC in ipython.magics_manager.magics['cell']:
        return
    ipython.magics_manager.magics['cell'][_MAGIC] = functools.partial(_stand_in, ipython)
    ipython.magics_manager.magics['line']['mkdir'] = _make_folders
    ipython.input_transformers_cleanup.insert(0, functools.partial(_replaced, ipython))


def _replaced(ipython: InteractiveShell, lines: list[str]) -> list[str]:
    """Return the lines of a cell, or if it can't run, those that show what is stored of it."""
    source = ''.join(lines)
    missing = {name for name, value in ipython.user_ns.items()
               if isinstance(value, Missing) or (isinstance(value, Shell) and not value.can_run)}
    if not missing or not depends_on(source, missing):
        return lines
    return [f'get_ipython().run_cell_magic({_MAGIC!r}, "", {source!r})\n']


def _stand_in(ipython: InteractiveShell, _line: str, source: str) -> None:
    """Show the sentence and the stored outputs; what the cell would have made is missing from now on."""
    outputs = _outputs_of(source)
    print(f'{DOES_NOT_RUN} This is what it printed where there is one:' if outputs else DOES_NOT_RUN)
    _show(outputs)
    ipython.user_ns.update({name: Missing() for name in _assigned(_parsed(source))})


def _make_folders(line: str) -> None:
    """Make folders: ``%mkdir -p config``, which IPython leaves to a shell."""
    words = shlex.split(line)
    makes_parents = '-p' in words
    for folder in words:
        if folder != '-p':
            try:
                Path(folder).mkdir(parents=makes_parents, exist_ok=makes_parents)
            except OSError as error:
                raise UsageError(f'cannot create directory {folder!r}: {error.strerror}') from None


# -- reading cells --------------------------------------------------------------------------------------------------

def depends_on(source: str, missing: set[str]) -> bool:
    """True if a cell is typed into one of these, or uses one before it gives the name to something else."""
    first, _, _ = source.lstrip().partition('\n')
    if first.startswith('%%'):
        return first.startswith('%%shell') and not missing.isdisjoint(first.split()[1:])
    own: set[str] = set()
    for statement in _parsed(source).body:
        if not missing.isdisjoint(_names(statement, ast.Load) - own):
            return True
        own |= _names(statement, ast.Store)
    return False


def _parsed(source: str) -> ast.Module:
    """Return a cell as Python sees it; an empty one if it is a mistake, which Python should name itself."""
    with contextlib.suppress(SyntaxError):
        return ast.parse(TransformerManager().transform_cell(source))
    return ast.Module([], [])


def _names(tree: ast.AST, how: type[ast.expr_context]) -> set[str]:
    return {each.id for each in ast.walk(tree) if isinstance(each, ast.Name) and isinstance(each.ctx, how)}


def _assigned(tree: ast.AST) -> set[str]:
    return _names(tree, ast.Store)


def _shells_in(tree: ast.AST) -> set[str]:
    """Return the names that a cell gives to new shells."""
    return {name for each in ast.walk(tree) if isinstance(each, ast.Assign) and isinstance(each.value, ast.Call)
            and isinstance(each.value.func, ast.Name) and each.value.func.id == 'Shell'
            for name in _assigned(each)}
