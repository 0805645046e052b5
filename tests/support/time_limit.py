"""A time limit for each test: one that hangs is named, and ended with all that it has started.

pytest-timeout keeps the time. Its method `signal` would lose its alarm to the exercises, which set one themselves,
and cannot interrupt rclpy's C++. Its method `thread` ends the process and leaves kernels, browsers and terminals
running. So the timer is this one, and counts in machine time. With pytest-xdist only one worker ends; a new one runs
the tests that it had left.
"""

import contextlib
import faulthandler
import os
import sys
import threading

import psutil
import pytest
from pytest_timeout import Settings, is_debugging
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling
from xdist.workermanage import WorkerController

from param_tools.ros.waiting import within

_limit_sec = pytest.StashKey[float]()
# Set when this process is about to end.
_ending = threading.Event()


@pytest.hookimpl(tryfirst=True)
def pytest_timeout_set_timer(item: pytest.Item, settings: Settings) -> bool:
    """Start the timer in place of pytest-timeout's own, which cancels it when the test is over."""
    item.stash[_limit_sec] = settings.timeout
    _start(item)
    return True


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Give the teardown the same time; pytest-timeout would let it hang forever after a test that fails."""
    if _limit_sec in item.stash:
        item.cancel_timeout()
        _start(item)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_makereport() -> None:
    """Report nothing when this process ends: a test that waited for one of those that are killed may have come to its
    end by that, and would count as passed."""
    if _ending.is_set():
        threading.Event().wait()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadScopeScheduling | None:
    """Return the scheduler for --dist loadscope; others are up to pytest-xdist."""
    return _Scheduling(config, log) if config.getoption('dist') == 'loadscope' else None


class _Scheduling(LoadScopeScheduling):
    """Mends what pytest-xdist 3.8 does after a test that has ended its worker."""

    def remove_node(self, node: WorkerController) -> str | None:
        """Leave that test out. pytest-xdist would try it again, on four new workers."""
        for tests in self.assigned_work[node].values():
            for name, completed in tests.items():
                if not completed:
                    tests[name] = True
                    super().remove_node(node)
                    return name
        return super().remove_node(node)

    def _reschedule(self, node: WorkerController) -> None:
        """Give a worker at least two tests, since it starts one only when it knows the next.

        pytest-xdist gives a new worker one file of the old one, in which one test may be left to do, or none. Then both
        would wait for each other.
        """
        super()._reschedule(node)
        while self.workqueue and not node.shutting_down and self._pending_of(self.assigned_work[node]) < 2:
            self._assign_work_unit(node)


def _start(item: pytest.Item) -> None:
    over = threading.Event()

    def watch() -> None:
        if not within(item.stash[_limit_sec], over.wait):
            _end(item)

    threading.Thread(target=watch, name='time limit', daemon=True).start()
    item.cancel_timeout = over.set


def _end(item: pytest.Item) -> None:
    """Show where each thread is, then kill this process and its descendants."""
    if is_debugging():
        return
    _ending.set()
    try:
        capture = item.config.pluginmanager.getplugin('capturemanager')
        capture.suspend_global_capture(in_=True)
        output = ''.join(capture.read_global_capture())
        print(f'\n{item.nodeid} is still running after {item.stash[_limit_sec]:g} s, so its process ends here.\n'
              f'{output}', file=sys.__stderr__, flush=True)
        # Parents come before their children.
        children = psutil.Process().children(recursive=True)
        for process in children:
            with contextlib.suppress(psutil.NoSuchProcess):
                print(f'Killed with it: {" ".join(process.cmdline())[:120]}', file=sys.__stderr__, flush=True)
        # Whether a thread has waited, or worked without end.
        names = {thread.native_id: f'{thread.name} ({thread.ident or 0:#x})' for thread in threading.enumerate()}
        for thread in psutil.Process().threads():
            worked_sec = thread.user_time + thread.system_time
            print(f'{names.get(thread.id, "not of Python")}: {worked_sec:.1f} s of processor time',
                  file=sys.__stderr__, flush=True)
        # The main thread comes last, and CI shows the end.
        faulthandler.dump_traceback(sys.__stderr__)
        for process in children:
            with contextlib.suppress(psutil.NoSuchProcess):
                process.kill()
    finally:
        os._exit(1)
