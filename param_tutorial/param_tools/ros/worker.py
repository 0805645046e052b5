"""A thread that exists only while there is work. No ROS, no Jupyter."""

import atexit
import contextlib
import threading
import time
import weakref
from collections.abc import Callable

from param_tools.ros.waiting import within

# What the name of every worker's thread begins with.
THREAD_NAME_PREFIX = 'worker: '
_LOOK_PERIOD_SEC = 0.25
_IDLE_LOOKS = 4
_END_TIMEOUT_SEC = 3.0


class Worker:
    """Calls a function in a thread of its own, soon after ``wake()``, and never two calls at once.

    However often it is woken, calls are at least ``period_sec`` apart: that is what keeps a busy node from
    flooding a browser. The thread starts when it is first needed; it calls a few times more, to see what has
    become late, and ends when there is nothing left to wait for.
    """

    def __init__(self, step: Callable[[], float | None], name: str, period_sec: float):
        """
        :param step: Does all that there is to do. Returns in how many seconds at the latest it should be called
            again even if nobody wakes it; None if nothing is outstanding. Should not raise: that ends the thread,
            until somebody wakes it again.
        """
        self._step = step
        self._name = name
        self._period_sec = period_sec
        self._lock = threading.RLock()
        self._changed = threading.Condition(self._lock)
        self._woken = False
        self._ended = False
        # How often the thread has looked since it was woken, or told to stay, and has found nothing.
        self._idle_looks = 0
        self._thread: threading.Thread | None = None
        self._one_at_a_time = threading.RLock()
        _workers.add(self)

    @property
    def is_idle(self) -> bool:
        """True if it has no thread, so that nothing is called until somebody wakes it."""
        return self._thread is None

    def wake(self) -> None:
        """Make sure that the function is called after now. Cheap; from any thread."""
        with self._lock:
            if self._ended:
                return
            self._woken = True
            if self._thread is not None:
                self._changed.notify()
                return
            thread = threading.Thread(target=self._run, name=f'{THREAD_NAME_PREFIX}{self._name}', daemon=True)
            with contextlib.suppress(RuntimeError):  # the interpreter is ending: nobody will look any more
                thread.start()
                self._thread = thread  # not before: one that Ctrl+C kept from starting would never look

    def stay(self) -> None:
        """Make sure that the thread is there and looks after what is outstanding. Cheaper than waking it."""
        with self._lock:
            self._idle_looks = 0
            is_there = self._thread is not None
        if not is_there:
            self.wake()

    def call_now(self, timeout_sec: float) -> bool:
        """Call the function in the calling thread, without regard to the period.

        :return: False if a call that another thread made did not end in time.
        """
        try:
            if not within(timeout_sec, lambda seconds: self._one_at_a_time.acquire(timeout=seconds)):
                return False
            again_sec = self._step()
        finally:
            # Only here is nothing left locked if Ctrl+C comes just as the lock is taken.
            try:  # noqa: SIM105 - suppress() is written in Python, and Ctrl+C may come in it
                self._one_at_a_time.release()
            except RuntimeError:  # another thread has it
                pass
        if again_sec is not None:
            self.stay()
        return True

    def end(self) -> None:
        """Call no more; the thread ends soon."""
        with self._lock:
            self._ended = True
            self._changed.notify()

    def _run(self) -> None:
        with self._lock:
            if self._thread is not threading.current_thread():  # Ctrl+C came while it was being started
                return
        try:
            self._work()
        finally:
            with self._lock:
                if self._thread is threading.current_thread():  # the function raised an exception
                    self._thread = None

    def _work(self) -> None:
        pause_sec = _LOOK_PERIOD_SEC
        while True:
            with self._lock:
                if not (self._woken or self._ended):
                    self._changed.wait(pause_sec)
                # Not what wait() returned: much may happen between the end of its time and this line.
                woken, self._woken = self._woken, False
                if self._ended or (not woken and self._idle_looks >= _IDLE_LOOKS):
                    self._thread = None
                    return
                self._idle_looks = 0 if woken else self._idle_looks + 1
            with self._one_at_a_time:
                again_sec = self._step()
            if again_sec is not None:
                self.stay()
            pause_sec = _LOOK_PERIOD_SEC if again_sec is None else min(again_sec, _LOOK_PERIOD_SEC)
            time.sleep(self._period_sec)
            pause_sec = max(0.0, pause_sec - self._period_sec)


_workers: 'weakref.WeakSet[Worker]' = weakref.WeakSet()


@atexit.register
def _end_all() -> None:
    """End all workers, and wait for their threads.

    A thread that still sends something to the browser while the interpreter ends may abort a Jupyter kernel, or keep it
    from ending at all.
    """
    deadline = time.monotonic() + _END_TIMEOUT_SEC
    for worker in list(_workers):
        worker.end()
    for thread in threading.enumerate():
        if thread.name.startswith(THREAD_NAME_PREFIX):
            with contextlib.suppress(RuntimeError):  # Ctrl+C kept it from starting
                thread.join(max(0.0, deadline - time.monotonic()))
