"""Fixtures that more than one test file uses."""

import pytest

import param_tutorial


@pytest.fixture
def ros():
    """Give a BackgroundExecutor with an empty stage; it is cleared again afterwards."""
    executor = param_tutorial.start()
    yield executor
    executor.remove_all()
