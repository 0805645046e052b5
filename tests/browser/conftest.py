"""What all browser tests need."""

import pytest

from tests.support import lab, missing


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
