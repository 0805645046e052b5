"""A cell's outputs beside the stored ones: nbval's own verdict, so that `make html` never disagrees with `make test`.

nbval compares in a method of its pytest items. These are made here as pytest makes them, from a configuration with no
plugin but nbval and no settings from files; only how a difference is written is ours.
"""

import difflib
import functools
import json
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from nbformat import NotebookNode
from nbval.plugin import IPyNbCell, IPyNbFile, coalesce_streams

_DIFFERENT_LINES = 20
_LINE_LENGTH = 160
_ARGUMENTS = ('--disable-plugin-autoload', '-p', 'nbval.plugin', '--nbval', '--color=no', '--assert=plain',
              '--capture=no', '--noconftest', '-c', os.devnull, '--rootdir', os.sep)


class Cell(IPyNbCell):  # type: ignore[misc]  # nbval ships no annotations
    """A code cell as nbval sees it."""

    @property
    def is_skipped(self) -> bool:
        """True if the cell is marked so that nbval does not run it."""
        return bool(self.options['skip'])

    def difference(self, outputs: list[NotebookNode]) -> str:
        """Return how outputs differ from the stored ones, for people; an empty text if nbval accepts them.

        The pieces of a text become one in either.
        """
        if not self.options['check']:
            return ''
        if self.compare_outputs(coalesce_streams(outputs), coalesce_streams(self.cell.outputs)):
            return ''
        lines = '\n'.join(map(str, self.comparison_traceback)).splitlines()
        return '\n'.join(f'    {line[:_LINE_LENGTH]}' for line in lines[:_DIFFERENT_LINES])

    def format_output_compare(self, key: str, left: Any, right: Any) -> None:
        """Note in which lines two outputs differ; called by nbval where they do."""
        self.comparison_traceback.extend(difflib.unified_diff(
            _lines(left), _lines(right), f'stored {key}', f'new {key}', lineterm='', n=1))


def cells_of(path: Path) -> Iterator[Cell]:
    """Yield the code cells of a notebook as nbval sees them, with the outputs that are stored in it."""
    file = IPyNbFile.from_parent(_session(), path=path)
    for cell in file.collect():
        yield Cell.from_parent(file, name=cell.name, cell_num=cell.cell_num, cell=cell.cell, options=cell.options)


@functools.cache
def _session() -> pytest.Session:
    return pytest.Session.from_config(pytest.Config.fromdictargs({}, list(_ARGUMENTS)))


def _lines(output: Any) -> list[str]:
    text = output if isinstance(output, str) else json.dumps(output, indent=1, sort_keys=True)
    # HTML is often one long line; between two elements it may be broken.
    return re.sub(r'(?<=>)(?=<)', '\n', text).splitlines()
