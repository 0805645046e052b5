"""Let pytest run the notebooks as tests, in order and in domains of their own; nothing for a learner to read."""

import os
from pathlib import Path

import pytest

SOLUTIONS = Path(__file__).parent / 'solutions'


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item):
    """Let a notebook's kernel claim a ROS domain of its own, also where other tests of this process have one."""
    # pytest calls this hook for the tests in other folders, too.
    domain = os.environ.pop('ROS_DOMAIN_ID', None) if hasattr(item, 'cell_num') else None
    yield
    if domain is not None:
        os.environ['ROS_DOMAIN_ID'] = domain


def pytest_itemcollected(item):
    """Leave the solutions to `make test-all`: tests/exercises tries answers that are made from them."""
    if hasattr(item, 'cell_num') and item.path.parent == SOLUTIONS:
        item.add_marker('thorough')


def pytest_collection_modifyitems(items):
    """Put each notebook's cells together again, in order, where pytest-randomly put the first of them.

    The tests run in another order each time. The cells of a lesson can't: each builds on the one before.
    """
    notebooks = {}
    for item in items:
        if hasattr(item, 'cell_num'):
            notebooks.setdefault(item.parent, []).append(item)
    ordered = []
    for item in items:
        if not hasattr(item, 'cell_num'):
            ordered.append(item)
        elif item.parent in notebooks:
            ordered += sorted(notebooks.pop(item.parent), key=lambda cell: cell.cell_num)
    items[:] = ordered
