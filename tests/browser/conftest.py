"""What all browser tests need."""

import pytest

from tests.support import lab, lesson, missing


@pytest.fixture(scope='session', autouse=True)
def _chromium():
    """In CI a missing Chromium is a failure; elsewhere the tests are skipped, and say why."""
    if lab.CHROMIUM is None:
        missing.skip('there is no Chromium on the PATH: apt-get install chromium-headless-shell')


@pytest.fixture(scope='module')
def browser():
    """A Chromium without windows, one for all tests of a file."""
    with lab.chromium() as browser:
        yield browser


@pytest.fixture(scope='module')
def opened(request, browser, tmp_path_factory):
    """Return a server on a notebook of the file's CELLS, and a page with it, on which none has run."""
    folder = tmp_path_factory.mktemp('opened')
    notebook = lesson.write(folder / 'lesson.ipynb', request.module.CELLS)
    with lab.Lab(folder / 'lab', [notebook]) as server:
        page = lab.LabPage(server, browser, notebook.name)
        yield server, page
        assert page.strange_errors() == []
