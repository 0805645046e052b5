"""What all tests need: a clean start, the fixtures, a time limit, and the longest files first."""

import atexit
import collections
import io
import os
import shutil
import signal
import sys
import tempfile
from collections.abc import Iterator
from typing import TYPE_CHECKING

import hypothesis
import nbval.kernel
import pytest
from xdist.workermanage import WorkerController

import param_tutorial
from param_tools.ros import node_log, waiting
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.notebook import terminal
from tests.support.kernels import KernelManager

if TYPE_CHECKING:
    from IPython.core.interactiveshell import InteractiveShell

# Where stdin is closed, pytest fails an assertion as soon as it is asked for the encoding, and IPython asks when it is
# imported. So nothing above imports it.
if sys.__stdin__ is None:
    sys.__stdin__ = io.StringIO()

pytest_plugins = ['tests.support.time_limit']

# A shell starts a job in the background with Ctrl+C ignored, and every process in it inherits that. The tests press
# Ctrl+C, so they take back what a process has in the foreground.
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.pthread_sigmask(signal.SIG_SETMASK, [])

# No IPython start-up file of the user's runs in a kernel under test, and nothing needs the home folder, which may be
# full: a kernel starts only where it can write, and so does a node. Workers share the folders of their parent.
if 'PYTEST_XDIST_WORKER' not in os.environ:
    _folder = tempfile.mkdtemp(prefix='param_tutorial_tests_')
    atexit.register(shutil.rmtree, _folder, ignore_errors=True)
    os.environ |= {name: f'{_folder}/{name}' for name in ('IPYTHONDIR', 'JUPYTER_RUNTIME_DIR', 'ROS_LOG_DIR')}

nbval.kernel.KernelManager = KernelManager
# A user is told after 5 s that something has not come. A test has more patience: where much else runs, a thread may
# stand still for as long.
waiting.wait_until.__defaults__ = (60.0,)
node_log.NodeLog.read.__defaults__ = (None, 60.0)

# By default an example fails that takes more than 0.2 s, as any may on a machine that does much else beside.
hypothesis.settings.register_profile('no deadline', deadline=None)
hypothesis.settings.load_profile('no deadline')

_DURATIONS = 'param_tutorial/seconds_of_files'
_known = pytest.StashKey[dict[str, float]]()
_seconds: collections.Counter[str] = collections.Counter()


@pytest.fixture
def ros() -> Iterator[BackgroundExecutor]:
    """Yield a BackgroundExecutor with an empty stage; clear it and end all terminals afterwards."""
    executor = param_tutorial.start()
    # A process that an earlier test has ended may still be in the graph, for 8 s if it was killed.
    waiting.wait_until(lambda: not executor.services.node_names(), 'the nodes of earlier tests to leave the graph')
    yield executor
    terminal.end_all()
    executor.remove_all()


@pytest.fixture
def ipython() -> 'Iterator[InteractiveShell]':
    """Yield an IPython with the notebook extension; the next test gets another one."""
    from tests.support.ipython import ipython_with_extension

    with ipython_with_extension() as shell:
        yield shell


@pytest.fixture
def bare_ipython(monkeypatch: pytest.MonkeyPatch) -> 'Iterator[InteractiveShell]':
    """Yield an IPython of the test's own, without the extension, which widgets take for the one that they are in."""
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell()
    monkeypatch.setattr('IPython.get_ipython', lambda: shell)
    yield shell
    shell.history_manager.end_session()


def pytest_configure(config: pytest.Config) -> None:
    """Learn how long each file took in earlier runs: all workers from the process that starts them.

    The files must come in the same order in all, also in one that replaces another later on: pytest-xdist gives no
    tests to a worker with another order, and waits for it forever.
    """
    given = getattr(config, 'workerinput', {}).get(_DURATIONS)
    config.stash[_known] = _remembered(config) if given is None else given


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: WorkerController) -> None:
    """Tell a worker before it starts."""
    node.workerinput[_DURATIONS] = node.config.stash[_known]


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Let the longest files begin first; the others, and the tests in each, stay in pytest-randomly's order.

    A file stays on one worker, so a long one that begins late is waited for by all. How long each took is known from
    earlier runs; before the first one, a slow test or a cell counts for a second. In effect with
    --no-loadscope-reorder: otherwise pytest-xdist begins with the files that have most tests.
    """
    slow = (item for item in items if item.get_closest_marker('slow') or item.path.suffix == '.ipynb')
    seconds = dict(collections.Counter(map(_file, slow))) | config.stash[_known]
    items.sort(key=lambda item: -seconds.get(_file(item), 0.0))


def _remembered(config: pytest.Config) -> dict[str, float]:
    return config.cache.get(_DURATIONS, {}) if hasattr(config, 'cache') else {}  # not with -p no:cacheprovider


def _file(test: pytest.Item | pytest.TestReport) -> str:
    return test.nodeid.partition('::')[0]


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Add up how long each file takes."""
    _seconds[_file(report)] += report.duration


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Remember it for the next run, at its longest, since a run may be of some tests only."""
    # Not in pytest-xdist's workers, which leave it to the process that started them.
    if not hasattr(session.config, 'workerinput') and hasattr(session.config, 'cache'):
        known = collections.Counter(_remembered(session.config))
        session.config.cache.set(_DURATIONS, known | _seconds)
