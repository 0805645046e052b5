"""Ctrl+C, and a notebook's "interrupt" button: it must not be lost, and must leave nothing locked. No ROS, no Jupyter.

Python raises KeyboardInterrupt in the main thread, at the end of any call. A ``with lock:`` is one step. But
``Condition.__enter__`` is written in Python, and calls another function to take its lock: an interrupt between the two
leaves it locked, as nobody has come as far as the ``with`` that would let go of it. Event is built on Condition. So
code that the main thread may run enters the condition's lock, and has a Latch in place of an Event. What must not be
left half done is ``held_back``. And ``raise_in`` interrupts another thread.
"""

import _thread
import contextlib
import ctypes
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from types import CodeType
from typing import Any

_LOOK_PERIOD_SEC = 0.001
_set_async_exc = ctypes.pythonapi.PyThreadState_SetAsyncExc
_set_async_exc.argtypes = ctypes.c_ulong, ctypes.py_object


class Latch:
    """Something that happens once, and that threads wait for. Ctrl+C in one of them does no harm to the others."""

    def __init__(self) -> None:
        self._is_set = False
        self._news: queue.SimpleQueue[None] = queue.SimpleQueue()

    def is_set(self) -> bool:
        """True once it has happened."""
        return self._is_set

    def set(self) -> None:
        """It has happened."""
        self._is_set = True
        self._news.put(None)

    def wait(self, timeout_sec: float) -> bool:
        """Wait until it has happened, or the time has passed. Return whether it has."""
        try:
            if not self._is_set:
                self._news.get(timeout=timeout_sec)
                self._news.put(None)  # for the next who waits; an interrupted one has only to wait for longer
        except queue.Empty:
            pass
        return self._is_set


@contextlib.contextmanager
def held_back() -> Iterator[None]:
    """Raise no KeyboardInterrupt in this block, but behind it: for what nobody could use half done, and soon is done.

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


def raise_in(thread: threading.Thread, error: type[BaseException]) -> None:
    """Raise an exception in another thread as soon as that runs Python code again. Do nothing if it has ended.

    Until then, Python would make every thread look for the exception in each call, and CPython 3.11 never gets past
    that look in code that is debugged or profiled. So a helper thread announces the exception and raises another in
    itself at once, which ends the search. The search begins again when the target wakes (``take_gil`` of CPython), and
    goes on if a signal has woken it and it falls asleep again: a thread that may sleep should block signals.
    """
    is_announced = _thread.allocate_lock()
    is_announced.acquire()
    try:
        _thread.start_new_thread(_announce, (thread, error, is_announced))
        is_announced.acquire()
    except RuntimeError:  # the process is about to end, and Python 3.12 starts no more threads
        if thread.is_alive():
            _set_async_exc(thread.ident, error)


class _Heard(BaseException):
    """What a thread raises in itself."""


def _announce(thread: threading.Thread, error: type[BaseException], is_announced: _thread.LockType) -> None:
    there, here = thread.ident, threading.get_ident()
    try:
        # A thread that has ended may have left its number to this one.
        if thread.is_alive():
            # No function of Python may be called between these.
            _set_async_exc(there, error)
            _set_async_exc(here, _Heard)
            while True:
                pass
    except _Heard:
        pass
    finally:
        is_announced.release()


def raise_again() -> Callable[[], None]:
    """Raise a KeyboardInterrupt again that came up in a finalizer, where Python prints an exception and goes on.

    rclpy's futures have a finalizer, and spinning a node makes and drops them all the time: of 500 interrupts of a
    ``spin_once`` in a cell, one was lost that way (CPython 3.11).

    :return: Call it to leave Python's hook as it was.
    """
    before = sys.unraisablehook

    def hook(unraisable: Any) -> None:
        if unraisable.exc_type is KeyboardInterrupt and threading.current_thread() is threading.main_thread():
            # Not threading.Thread, which takes a lock that whatever this finalizer came in between may hold.
            _thread.start_new_thread(_press_again, (hook.__code__,))
        else:
            before(unraisable)

    def leave() -> None:
        if sys.unraisablehook is hook:
            sys.unraisablehook = before
    sys.unraisablehook = hook
    return leave


def _press_again(hook: CodeType) -> None:
    """Interrupt the main thread as soon as it has left the hook, in which the exception would be lost for good."""
    main = threading.main_thread().ident
    assert main is not None
    while _is_running(hook, main):
        time.sleep(_LOOK_PERIOD_SEC)
    signal.pthread_kill(main, signal.SIGINT)


def _is_running(code: CodeType, thread: int) -> bool:
    """True if a thread is in a function, or in one that it calls."""
    frame = sys._current_frames().get(thread)
    while frame is not None:
        if frame.f_code is code:
            return True
        frame = frame.f_back
    return False
