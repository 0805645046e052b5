"""Outputs are compared by nbval: `make html` and `pytest --nbval` come to the same verdict on the same cells."""

import subprocess
import sys
from xml.etree import ElementTree

import nbformat
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook, new_output

from param_tutorial.site import comparison


def printed(text, name='stdout'):
    return new_output('stream', name=name, text=text)


def raised(evalue, traceback=()):
    return new_output('error', ename='ValueError', evalue=evalue, traceback=list(traceback))


SHOW = 'from IPython.display import display\ndisplay({%s}, raw=True)'
WIDGET = 'application/vnd.jupyter.widget-view+json'
# What is in the cell, what is stored with it, and whether nbval accepts that.
PAIRS = {
    'another text': ('print(1)', [printed('2\n')], False),
    'a text that is missing': ('x = 1', [printed('1\n')], False),
    'streams in another order': ('import sys\nprint(1)\nprint(2, file=sys.stderr)',
                                 [printed('2\n', 'stderr'), printed('1\n')], True),
    'a picture': (SHOW % '"image/png": "AAAA"', [new_output('display_data', {'image/png': 'BBBB'})], True),
    'other JSON': (SHOW % '"application/json": {"a": [1]}',
                   [new_output('display_data', {'application/json': {'a': [2]}})], False),
    'another widget': (SHOW % f'"{WIDGET}": {{"model_id": "a"}}, "text/plain": "x"',
                       [new_output('display_data', {WIDGET: {'model_id': 'b'}, 'text/plain': 'x'})], True),
    'another error': ('raise ValueError("a")', [raised('b')], False),
    'what is not to be compared': ('# NBVAL_IGNORE_OUTPUT\nprint(1)', [printed('2\n')], True),
}


@pytest.fixture(scope='module')
def notebook(tmp_path_factory):
    """Return a notebook with a cell for each pair, and how it comes out when it is run."""
    cells = [new_code_cell(source, outputs=stored, execution_count=1, metadata={'tags': ['raises-exception']})
             for source, stored, _ in PAIRS.values()]
    path = tmp_path_factory.mktemp('pairs') / 'pairs.ipynb'
    nbformat.write(new_notebook(cells=cells), path)
    executed = nbformat.read(path, as_version=4)
    NotebookClient(executed, kernel_name='python3', coalesce_streams=True, store_widget_state=False).execute()
    return path, executed


@pytest.mark.slow
@pytest.mark.thorough
def test_the_verdict_is_that_of_pytest(notebook):
    path, executed = notebook
    ours = {name: not cell.difference(new.outputs)
            for name, cell, new in zip(PAIRS, comparison.cells_of(path), executed.cells, strict=True)}
    report = path.with_suffix('.xml')
    subprocess.run([sys.executable, '-m', 'pytest', '--nbval', '--nbval-current-env', '--rootdir', path.parent,
                    '-c', '/dev/null', '-p', 'no:randomly', f'--junitxml={report}', path],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    theirs = {name: case.find('failure') is None
              for name, case in zip(PAIRS, ElementTree.parse(report).iter('testcase'), strict=True)}
    assert theirs == {name: accepted for name, (_, _, accepted) in PAIRS.items()}
    assert ours == theirs


@pytest.mark.slow
@pytest.mark.thorough
def test_a_difference_names_what_differs_and_shows_the_lines(notebook):
    path, executed = notebook
    told = {name: cell.difference(new.outputs)
            for name, cell, new in zip(PAIRS, comparison.cells_of(path), executed.cells, strict=True)}
    assert told['another text'] == '    --- stored stdout\n    +++ new stdout\n    @@ -1 +1 @@\n    -2\n    +1'
    assert told['other JSON'].splitlines()[-3:] == ['    -  2', '    +  1', '      ]']
    assert 'Missing output fields' in told['a text that is missing'] and 'stdout' in told['a text that is missing']
