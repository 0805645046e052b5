"""Tests that need what a machine may lack."""

import os
from typing import NoReturn

import pytest


def skip(why: str) -> NoReturn:
    """Skip this test, and say why; in CI, where `.ci/run` installs what a fresh machine lacks, fail."""
    (pytest.fail if os.environ.get('CI') else pytest.skip)(why)
