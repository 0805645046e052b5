"""Fixtures that more than one test file uses, and which files begin first."""

from pathlib import Path

import hypothesis
import pytest

import param_tutorial
from param_tutorial.notebook import terminal

# By default an example fails that takes more than 0.2 s, as any may on a machine that does much else beside.
hypothesis.settings.register_profile('no deadline', deadline=None)
hypothesis.settings.load_profile('no deadline')

# The files that take longest, from 80 s down to 10 s on two idle cores. A file stays on one worker, so a long one that
# begins late is waited for by all: these begin first.
LONG_FILES = (
    'tests/exercises/test_exercises.py', 'tests/browser/test_lab.py', 'notebooks/07_2_launch_files.ipynb',
    'tests/browser/test_robot_moves.py', 'notebooks/02_workspace.ipynb', 'tests/environment/test_colcon.py',
    'tests/widgets/test_panel.py', 'tests/runtime/test_executor.py', 'tests/runtime/test_kernel.py',
    'tests/nodes/test_nodes.py', 'tests/ros2/test_ros2.py', 'notebooks/01_what_are_parameters.ipynb',
    'notebooks/05_3_from_another_node.ipynb', 'tests/ros2/test_launch.py', 'tests/parameters/test_client.py',
    'tests/ros1/test_ros1.py')


@pytest.fixture
def ros():
    """Give a BackgroundExecutor with an empty stage; it is cleared again afterwards, and all terminals are ended."""
    executor = param_tutorial.start()
    yield executor
    terminal.end_all()
    executor.remove_all()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """Let the longest files begin first; the others, and the tests in each, stay in pytest-randomly's order.

    In effect with --no-loadscope-reorder: otherwise pytest-xdist begins with the files that have most tests.
    """
    places = {config.rootpath / name: place for place, name in enumerate(LONG_FILES)}
    assert all(path.exists() for path in places), 'a file in LONG_FILES is gone: take it out'
    items.sort(key=lambda item: places.get(Path(item.path), len(places)))
