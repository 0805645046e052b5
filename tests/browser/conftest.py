"""What all browser tests need."""

import os

import pytest

from tests.support import lab


@pytest.fixture(scope='session', autouse=True)
def _chromium():
    """In CI a missing Chromium is a failure; elsewhere the tests are skipped, and say why."""
    if lab.CHROMIUM is None:
        missing = 'there is no Chromium on the PATH: apt-get install chromium-headless-shell'
        if os.environ.get('CI'):
            pytest.fail(missing)
        pytest.skip(missing)


@pytest.fixture(scope='module')
def browser():
    """A Chromium without windows, one for all tests of a file."""
    with lab.chromium() as browser:
        yield browser
