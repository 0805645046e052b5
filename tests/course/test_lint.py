"""`make lint`, beside the other tests: mypy alone would keep one of two cores idle for a quarter of a minute."""

import subprocess

import nbformat
import pytest

from tests.support.paths import NOTEBOOKS, ROOT
from tests.tools import notebook_lint


@pytest.mark.thorough
@pytest.mark.timeout(600)  # mypy without its cache, on a busy machine
def test_the_lint_finds_nothing():
    done = subprocess.run(['make', 'lint'], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def strip(cell):
    cell.outputs, cell.execution_count = [], None


def skip(cell):
    cell.metadata['tags'] = ['nbval-skip']


def fail(cell):
    cell.outputs = [nbformat.v4.new_output('error', ename='ValueError', evalue='no', traceback=[])]


def reach_inside(cell):
    cell.source = 'from param_tools.ros.executor import BackgroundExecutor'


@pytest.mark.parametrize(('change', 'words'), [
    (strip, 'was not run'), (skip, 'says no reason'), (fail, 'ends in ValueError'), (reach_inside, 'imports from')])
def test_a_notebook_that_would_compare_nothing_or_reaches_inside_is_named(tmp_path, change, words):
    notebook = nbformat.read(NOTEBOOKS / '01_what_are_parameters.ipynb', as_version=4)
    change(next(cell for cell in notebook.cells if cell.cell_type == 'code'))
    path = tmp_path / '01_what_are_parameters.ipynb'
    nbformat.write(notebook, path)
    assert any(words in problem.text for problem in notebook_lint.check_file(path))
