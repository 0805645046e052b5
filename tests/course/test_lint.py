"""`make lint`, beside the other tests: mypy alone would keep one of two cores idle for a quarter of a minute."""

import subprocess

import pytest

from tests.support.paths import ROOT


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.timeout(600)  # mypy without its cache, on a busy machine
def test_the_lint_finds_nothing():
    done = subprocess.run(['make', 'lint'], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
