"""A thread that exists only while there is work. No ROS, no Jupyter."""

import threading
import time
from collections.abc import Callable

_LOOK_PERIOD_SEC = 0.25
_IDLE_LOOKS = 4


class Worker:
    """Calls a function in a thread of its own, soon after ``wake()``, and never two calls at once.

    However often it is woken, calls are at least ``period_sec`` apart: that is what keeps a busy node from
    flooding a browser. The thread starts when it is first needed; it calls a few times more, to see what has
    become late, and ends when there is nothing left to wait for.
    """

    def __init__(self, step: Callable[[], bool], name: str, period_sec: float):
        """
        :param step: Does all that there is to do. Returns whether something is outstanding, so that it should be
            called again soon even if nobody wakes it. Must not raise.
        """
        self._step = step
        self._name = name
        self._period_sec = period_sec
        self._changed = threading.Condition()
        self._woken = False
        self._ended = False
        self._thread: threading.Thread | None = None
        self._one_at_a_time = threading.Lock()

    def wake(self) -> None:
        """See to it that the function is called after now. Cheap; from any thread."""
        with self._changed:
            if self._ended:
                return
            self._woken = True
            if self._thread is not None:
                self._changed.notify()
                return
            self._thread = threading.Thread(target=self._run, name=self._name, daemon=True)
        try:
            self._thread.start()
        except RuntimeError:  # the interpreter is ending: nobody will look any more
            self._thread = None

    def stay(self) -> None:
        """See to it that the thread is there and looks after what is outstanding. Cheaper than waking it."""
        if self._thread is None:
            self.wake()

    def call_now(self, timeout_sec: float) -> bool:
        """Call the function in the calling thread, without regard to the period.

        :return: False if a call that another thread made did not end in time.
        """
        if not self._one_at_a_time.acquire(timeout=max(0.0, timeout_sec)):
            return False
        try:
            outstanding = self._step()
        finally:
            self._one_at_a_time.release()
        if outstanding:
            self.stay()
        return True

    def end(self) -> None:
        """Call no more; the thread ends soon."""
        with self._changed:
            self._ended = True
            self._changed.notify()

    def _run(self) -> None:
        idle_looks = 0
        while True:
            with self._changed:
                woken = self._woken or self._ended or self._changed.wait(_LOOK_PERIOD_SEC)
                if self._ended or (not woken and idle_looks >= _IDLE_LOOKS):
                    self._thread = None
                    return
                self._woken = False
            with self._one_at_a_time:
                outstanding = self._step()
            idle_looks = 0 if woken or outstanding else idle_looks + 1
            time.sleep(self._period_sec)
