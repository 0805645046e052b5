"""What all tests of the course in a page need: what such a page loads."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from param_tutorial.learner.storage import only_one
from param_tutorial.site.browser import lite, page_python
from tests.support import missing
from tests.support.paths import ROOT

PAGE_KERNEL = ROOT / 'tests' / 'support' / 'page_kernel.mjs'


@pytest.fixture(scope='session', autouse=True)
def _pyodide():
    """In CI a missing Pyodide is a failure; elsewhere the tests are skipped, and say why."""
    if not page_python.PYODIDE.exists():
        missing.skip('there is no Pyodide in node_modules: `make lite` gets it')


@pytest.fixture(scope='session')
def python_of_a_page(tmp_path_factory):
    """Yield a folder with what a page loads to run Python."""
    folder = tmp_path_factory.mktemp('page') / 'pyodide'
    lite.WORK.mkdir(parents=True, exist_ok=True)
    with only_one(lite.WORK):  # the first one compiles, and the others have it from there
        page_python.gather(folder, lite.WORK)
    return folder


@pytest.fixture
def outputs_in_a_page(python_of_a_page):
    """Return a function that runs a notebook in the kernel of a page and returns the outputs of its code cells."""
    def run(notebook: Path) -> list[list[dict]]:
        done = subprocess.run([Path(sys.executable).with_name('node'), PAGE_KERNEL, python_of_a_page, notebook],
                              capture_output=True, text=True, check=False, timeout=150)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    return run
