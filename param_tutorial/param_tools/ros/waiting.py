"""Wait for a condition with a deadline, and never by sleeping for luck.

A time limit tells "it is slow" from "it will never come". On a busy machine everything is slow: where ten processes
share two cores, each does in five seconds what it otherwise does in one; and so it is in a container that may use only
a part of a core. So limits are counted in the seconds of ``machine_time``, which pass more slowly there. As long as no
more than two threads share a core, they are seconds.
"""

import functools
import os
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from param_tools.errors import WaitTimeoutError
from param_tools.ros import cgroups

T = TypeVar('T')

# Limits have room for a machine that is half as fast.
_THREADS_PER_CORE = 2
# Its fourth field is "running/all", in threads: see proc_loadavg(5).
_LOAD = Path('/proc/loadavg')
_LOOK_PERIOD_SEC = 0.01
_SLICE_SEC, _LEAST_SLICE_SEC = 0.05, 0.002


class _MachineClock:
    """Adds up the time that passes, divided by how much less than half a core a thread gets."""

    def __init__(self) -> None:
        # A signal's handler may ask, too, while the thread that it interrupts is in here.
        self._lock = threading.RLock()
        self._throttle = cgroups.Throttle()
        self._slowness = 1.0
        self._looked = self._read = time.monotonic()
        self._seconds = 0.0

    def __call__(self) -> float:
        with self._lock:
            now = time.monotonic()
            if now - self._looked >= _LOOK_PERIOD_SEC:
                self._slowness, self._looked = max(1.0, _sharing() * self._throttle() / _THREADS_PER_CORE), now
            self._seconds += max(0.0, now - self._read) / self._slowness
            self._read = max(now, self._read)
            return self._seconds


def _sharing() -> float:
    """Return how many threads want to run on each core of this process, at least 1.0."""
    try:
        running = int(os.pread(_opened(_LOAD), 100, 0).split()[3].partition(b'/')[0])
        return max(1.0, running / len(os.sched_getaffinity(0)))
    except (OSError, ValueError, IndexError, AttributeError):  # not Linux
        return 1.0


@functools.cache
def _opened(path: Path) -> int:
    """Return the descriptor of a file that stays open: opening it takes six times as long as reading it."""
    return os.open(path, os.O_RDONLY | os.O_CLOEXEC)


machine_time = _MachineClock()
"""Return a number of seconds for measuring how much time the machine has had; look often, as waiting does."""


def within(seconds: float, wait: Callable[[float], bool]) -> bool:
    """Wait, in machine time, and return whether it was successful.

    :param wait: Waits for so many seconds at most and returns whether it was successful, as ``Event.wait`` does.
    """
    deadline = machine_time() + seconds
    while (left := deadline - machine_time()) > 0:
        # Where machine time is slow, the rest would be halved again and again.
        if wait(min(max(left, _LEAST_SLICE_SEC), _SLICE_SEC)):
            return True
    return wait(0.0)


def wait_until(condition: Callable[[], T], what: str, timeout_sec: float = 5.0) -> T:
    """Wait until a condition is true, and return what it returned.

    :param condition: Called again and again; must not block.
    :param what: Completes "timed out after N s waiting for …" in the error.
    :param timeout_sec: In machine time.
    :raises WaitTimeoutError: the condition was still false at the deadline.
    """
    deadline = machine_time() + timeout_sec
    pause_sec = 0.001
    while True:
        is_late = machine_time() > deadline  # asked first: the last look is after the deadline
        if value := condition():
            return value
        if is_late:
            raise WaitTimeoutError(f'timed out after {timeout_sec:g} s waiting for {what}')
        time.sleep(pause_sec)
        pause_sec = min(2 * pause_sec, 0.02)
