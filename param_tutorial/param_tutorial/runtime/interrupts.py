"""Ctrl+C, and a notebook's "interrupt" button, which must not be lost. No ROS, no Jupyter."""

import _thread
import signal
import sys
import threading
import time
from collections.abc import Callable
from types import CodeType
from typing import Any

_LOOK_PERIOD_SEC = 0.001


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
