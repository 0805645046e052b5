"""The stage: the one BackgroundExecutor of this process, on which a notebook's nodes run.

``start()`` sets it up, and clears it when it is called again; ``stop()`` ends it. Live views ask for ``current()``
and listen with ``on_change``, so that they survive a stop and a new start.
"""

import atexit
import contextlib
import threading
from collections.abc import Callable, Iterator

from rclpy import utilities

from param_tools.errors import ExecutorError, StuckError
from param_tools.ros import environment, interrupts
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.listeners import Listeners

_current: BackgroundExecutor | None = None
_change_listeners: Listeners[[]] = Listeners()
_start_listeners: Listeners[[]] = Listeners()
_lifecycle_lock = threading.RLock()
_error_if_touched: Callable[[], Exception] | None = None


def start() -> BackgroundExecutor:
    """Return the process's BackgroundExecutor: running, without any node, and with an empty log.

    Safe to call again at any time: it destroys the nodes of an earlier run, and replaces an executor that has died or
    is stuck in a callback that never returns.

    :raises ExecutorError: other code has initialized rclpy in this process.
    """
    global _current
    _require_free()
    _start_listeners.call()
    with _lifecycle_lock:
        if _current is not None and _current.is_running:
            try:
                _current.clear()
                return _current
            except StuckError:  # the callback is left behind, in its thread
                pass
        if _current is not None:
            _current.stop()
        environment.drop_old_builds()
        if utilities.ok():
            raise ExecutorError('other code has initialized rclpy in this process: call rclpy.shutdown() first, then '
                                'start() again')
    with interrupts.held_back():  # half an executor would keep rclpy to itself, and nobody could stop it
        with _lifecycle_lock:
            if _current is None or not _current.is_running:  # no other thread was quicker
                _current = BackgroundExecutor()
            started = _current
        _change_listeners.call()
    return started


def current() -> BackgroundExecutor:
    """Return the running BackgroundExecutor of this process.

    :raises ExecutorError: there is none.
    """
    if _current is None or not _current.is_running:
        raise ExecutorError('no executor is running in the background: call start() first')
    return _current


def stop() -> None:
    """Stop the process's BackgroundExecutor, if there is one; safe to call more than once."""
    global _current
    _require_free()
    if _current is None:
        return
    with interrupts.held_back():
        with _lifecycle_lock:
            if _current is not None:  # no other thread was quicker
                _current.stop()
            _current = None
        _change_listeners.call()


@contextlib.contextmanager
def kept(error: Callable[[], Exception]) -> Iterator[None]:
    """Keep the stage as it is in this block: start() and stop() raise the exception that a function returns."""
    global _error_if_touched
    before, _error_if_touched = _error_if_touched, error
    try:
        yield
    finally:
        _error_if_touched = before


def _require_free() -> None:
    if _error_if_touched is not None:
        raise _error_if_touched()


def on_change(listener: Callable[[], None]) -> Callable[[], None]:
    """Call a listener after this process got another executor or lost the one it had; ``current()`` says which.

    It is called in the thread that called start() or stop().

    :return: Call it to stop listening.
    """
    return _change_listeners.add(listener)


def on_start(listener: Callable[[], None]) -> Callable[[], None]:
    """Call a listener whenever start() is called, before it does anything, in the thread that called it.

    :return: Call it to stop listening.
    """
    return _start_listeners.add(listener)


# An executor thread that is still spinning when the interpreter ends aborts the process (exit status 134).
atexit.register(stop)
