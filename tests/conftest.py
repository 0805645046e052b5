"""What all tests need: a clean start, and the fixtures."""

import atexit
import contextlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import textwrap
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import hypothesis
import nbval.kernel
import pytest
from IPython.core.interactiveshell import InteractiveShell
from rclpy.node import Node

import param_tutorial
from param_tools.errors import StuckError
from param_tools.ros import node_log, waiting
from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.notebook import terminal
from tests.support.kernels import KernelManager
from tests.support.processes import CAN_STAND_STILL

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
    # A kernel that crashes in C++ is started anew, and only its empty page would tell.
    os.environ['PYTHONFAULTHANDLER'] = '1'

nbval.kernel.KernelManager = KernelManager
# A user learns after 5 s that something has not come. A test has more patience, since many of them share two cores.
waiting.wait_until.__defaults__ = (60.0,)
node_log.NodeLog.read.__defaults__ = (None, 60.0)

# By default an example fails that takes more than 0.2 s, as any may on a machine that does much else beside. And each
# example of a test has the folder and the stage that the ones before it had.
hypothesis.settings.register_profile(
    'ours', deadline=None, suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture])
hypothesis.settings.load_profile('ours')


REMOTE = CAN_STAND_STILL + textwrap.dedent('''
    import signal, sys, threading, rclpy
    from rclpy.node import Node
    rclpy.init()
    node = Node(sys.argv[1])
    node.declare_parameter('x', 1)
    print('ready', flush=True)
    reader = threading.Thread(target=sys.stdin.read)
    reader.start()
    while reader.is_alive():
        rclpy.spin_once(node, timeout_sec=0.05)
    node.destroy_node()
    # A process that ends while the news of its node is under way can leave a ghost in the graph.
    signal.pause()
''')


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the files that take longest, so that no worker is left alone with one at the end."""
    weights: Counter[Path] = Counter()
    for item in items:
        weights[item.path] += 100 if item.get_closest_marker('thorough') else 1
    items.sort(key=lambda item: -weights[item.path])


@pytest.fixture(scope='module')
def stage_of_the_file() -> Iterator[None]:
    """End the stage after the tests of a file. What a participant of DDS once had, each new process asks for in turn,
    also if it is gone: after a thousand nodes that takes seconds."""
    yield
    param_tutorial.stop()


@pytest.fixture
def ros(stage_of_the_file: None) -> Iterator[BackgroundExecutor]:
    """Yield a BackgroundExecutor with an empty stage; clear it and end all terminals afterwards."""
    executor = param_tutorial.start()
    # A process that an earlier test has ended may still be in the graph, for 8 s if it was killed.
    waiting.wait_until(lambda: not executor.services.node_names(), 'the nodes of earlier tests to leave the graph')
    yield executor
    terminal.end_all()
    with contextlib.suppress(StuckError):  # a callback that never returns; the next start begins anew
        executor.remove_all()


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Return a function that writes a file, of text or of bytes, and returns its path."""
    def write(content: str | bytes, name: str = 'robot.yaml') -> Path:
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode(errors='replace'))
        return path

    return write


@pytest.fixture
def remote(ros: BackgroundExecutor) -> Iterator[Callable[[str], 'subprocess.Popen[str]']]:
    """Yield a function that starts a node of a name in its own process, which can stand still."""
    started: list[subprocess.Popen[str]] = []

    def start(name: str) -> 'subprocess.Popen[str]':
        process = subprocess.Popen([sys.executable, '-c', REMOTE, name],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        started.append(process)
        assert process.stdout.readline() == 'ready\n'
        return process

    yield start
    for process in started:
        process.stdin.close()  # which ends the node
    # The next test may expect an empty stage.
    ros.remove_all()
    waiting.wait_until(lambda: not ros.services.node_names(), 'the nodes to leave the graph', 20)
    for process in started:
        process.kill()
        process.wait()
        process.stdout.close()


@pytest.fixture
def silent(ros: BackgroundExecutor) -> Iterator[Node]:
    """Yield a node that exists and answers nothing: nobody spins it."""
    node = Node('silent')
    yield node
    node.destroy_node()


@pytest.fixture
def ipython() -> Iterator[InteractiveShell]:
    """Yield the IPython of this process with the notebook extension; the next test gets another one."""
    shell = InteractiveShell.instance()
    shell.history_manager.enabled = False  # two test processes would share its database
    shell.run_line_magic('load_ext', 'param_tutorial')
    yield shell
    InteractiveShell.clear_instance()


@pytest.fixture
def bare_ipython(monkeypatch: pytest.MonkeyPatch) -> Iterator[InteractiveShell]:
    """Yield an IPython of the test's own, without the extension, which widgets take for the one that they are in."""
    shell = InteractiveShell()
    monkeypatch.setattr('IPython.get_ipython', lambda: shell)
    yield shell
    shell.history_manager.end_session()
