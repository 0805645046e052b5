"""What all tests of the course in a page need: what such a page loads."""

from pathlib import Path

import pytest

from param_tutorial.site.browser import page_python
from param_tutorial.site.live import python_files, running
from tests.support import missing
from tests.support.paths import NOTEBOOKS


@pytest.fixture(scope='session', autouse=True)
def _pyodide():
    """In CI a missing Pyodide is a failure; elsewhere the tests are skipped, and say why."""
    if not page_python.PYODIDE.exists():
        missing.skip('there is no Pyodide in environment/node_modules: `make lite` gets it')


@pytest.fixture(scope='session')
def run_in_a_page(tmp_path_factory):
    """Return a function that runs a notebook in the kernel of a page; see ``running.run_notebook``."""
    folder = tmp_path_factory.mktemp('page')
    page_python.gather(folder / 'pyodide')
    (folder / 'packages').write_bytes(python_files.packages(folder / 'pyodide', NOTEBOOKS))

    def run(notebook: Path) -> list[dict]:
        return running.run_notebook(notebook, folder / 'pyodide', folder / 'packages')

    return run
