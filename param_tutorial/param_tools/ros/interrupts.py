"""Ctrl+C, and a notebook's "interrupt" button; and how to end an endless loop. No ROS, no Jupyter."""

import contextlib
import ctypes
import signal
import threading
import time
from collections.abc import Iterator
from types import FrameType

_LOOK_SEC = 0.3
_set_async_exc = ctypes.pythonapi.PyThreadState_SetAsyncExc
_set_async_exc.argtypes = ctypes.c_ulong, ctypes.py_object


@contextlib.contextmanager
def held_back() -> Iterator[None]:
    """Raise KeyboardInterrupt not in this block but after it: for what is soon done, and of no use half done.

    Only the main thread is ever interrupted; in any other, this does nothing. Not for where rclpy handles SIGINT, as it
    does after a plain ``rclpy.init()``: Python could not give it back to a handler in C.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, _: came.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if came:
            signal.raise_signal(signal.SIGINT)


@contextlib.contextmanager
def time_limit(seconds: float, error: type[BaseException]) -> Iterator[None]:
    """Raise an exception in this block when a time is over: in the main thread, and not on Windows.

    Blocks may be nested: while an inner block runs, only its own limit counts.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, 'setitimer'):
        yield
        return

    def ring(_number: int, _frame: FrameType | None) -> None:
        raise error

    left_sec, period_sec = signal.setitimer(signal.ITIMER_REAL, 0)
    began = time.monotonic()
    before = signal.signal(signal.SIGALRM, ring)
    # Again after as long: code may catch everything, and what is raised while Python runs a __del__ is lost.
    signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
        if left_sec:  # of the block around this one
            left_sec -= time.monotonic() - began
            signal.setitimer(signal.ITIMER_REAL, left_sec if left_sec > 0.0 else period_sec, period_sec)
            if left_sec <= 0.0:
                signal.raise_signal(signal.SIGALRM)


def raise_in(thread: threading.Thread, error: type[BaseException]) -> bool:
    """Raise an exception in another thread if it runs Python code, and return whether it does.

    An exception that is raised in a thread that sleeps, in ``time.sleep`` or in C++, would come when it wakes, maybe
    never. Whether a thread sleeps is told by its processor time, which then stands still.
    """
    if thread.ident is None or not thread.is_alive():
        return False
    clock = time.pthread_getcpuclockid(thread.ident)
    before = time.clock_gettime(clock)
    time.sleep(_LOOK_SEC)
    if not thread.is_alive() or time.clock_gettime(clock) == before:
        return False
    _set_async_exc(thread.ident, error)
    return True
