"""What is drawn or asked again after a time: one loop for all jobs of a process. No ROS, no Jupyter."""

import atexit
import threading
import time
import traceback
from collections.abc import Callable

from param_tools.ros import host
from param_tools.ros.host import Loop

LOOP_NAME = 'schedule'
_LONGEST_WAIT_SEC = 3600.0
_END_TIMEOUT_SEC = 3.0

# Guards all below.
_changed = threading.Condition()
_due: 'dict[Job, float]' = {}
_loop: Loop | None = None
_is_ending = False


class Job:
    """Calls a function soon after ``wake()``, never twice at once, and not more often than once in a period.

    The function must not wait: the loop is shared. What keeps a busy node from flooding a browser is the period.
    """

    def __init__(self, step: Callable[[], float | None], period_sec: float, lock: 'threading.RLock | None' = None):
        """
        :param step: Does all that there is to do. Returns in how many seconds at the latest it should be called again;
            None if only ``wake`` calls it again.
        :param lock: Is held while the function runs; by default a lock of the job's own.
        """
        self._step, self._period_sec = step, period_sec
        self.rests_until = 0.0
        self._ended = False
        self._one_at_a_time = lock or threading.RLock()

    def wake(self, in_sec: float = 0.0) -> None:
        """Make sure that the function is called after now. Cheap; from any thread."""
        global _loop
        at = time.monotonic() + in_sec
        with _changed:
            if self._ended or _due.get(self, at + 1) <= at:
                return
            _due[self] = at
            if _loop is None and not _is_ending:
                _loop = host.host.loop(_run_next, lambda: _is_ending, LOOP_NAME, _LONGEST_WAIT_SEC)
                _loop.start()
            _changed.notify()

    def call_now(self, timeout_sec: float) -> bool:
        """Call the function in the calling thread, without regard to the period.

        :return: False if a call that another thread made did not end in time.
        """
        if not self._one_at_a_time.acquire(timeout=max(0.0, timeout_sec)):
            return False
        try:
            again_sec = self._step()
        finally:
            self.rests_until = time.monotonic() + self._period_sec
            self._one_at_a_time.release()
        if again_sec is not None:
            self.wake(again_sec)
        return True

    def end(self) -> None:
        """Call no more."""
        with _changed:
            self._ended = True
            _due.pop(self, None)
            _changed.notify()


def _run_next(wait_sec: float) -> bool:
    """Run the next job that is due within a time, and return whether there was one."""
    job = _next_job(time.monotonic() + wait_sec)
    if job is None:
        return False
    try:
        job.call_now(_END_TIMEOUT_SEC)
    except BaseException:  # of one job; the others go on
        traceback.print_exc()
    return True


def _due_at(job: Job) -> float:
    return max(_due[job], job.rests_until)


def _next_job(end: float) -> Job | None:
    """Wait for the next job that is due, and return it; None if there was none in time, and at the end."""
    with _changed:
        while not _is_ending:
            job = min(_due, key=_due_at, default=None)
            now = time.monotonic()
            if job is not None and _due_at(job) <= now:
                del _due[job]
                return job
            if now >= end:
                break
            _changed.wait((end if job is None else min(end, _due_at(job))) - now)
    return None


@atexit.register
def _end() -> None:
    """End the loop: one that still sends something to the browser as the interpreter ends may abort a kernel."""
    global _is_ending
    with _changed:
        _is_ending = True
        _changed.notify()
    if _loop is not None:
        _loop.join(_END_TIMEOUT_SEC)
