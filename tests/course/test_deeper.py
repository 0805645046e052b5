"""What a notebook of deeper/ can only show as text is true all the same."""

import re
import subprocess
import sys

import nbformat

from tests.support.paths import ROOT


def test_a_lifecycle_node_prints_what_its_notebook_says():
    # A page's rcl has no lifecycle nodes, so the notebook has these lines and their output in a cell of text.
    cells = nbformat.read(ROOT / 'notebooks/deeper/lifecycle_nodes.ipynb', as_version=4).cells
    program, printed = re.search(r'```python\n(.+?)```\n\n```text\n(.+?)```', '\n'.join(cell.source for cell in cells),
                                 re.DOTALL).groups()
    done = subprocess.run([sys.executable, '-c', program], capture_output=True, text=True, timeout=60)
    assert (done.stdout, done.stderr) == (printed, '')
