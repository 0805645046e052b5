"""Ctrl+C for the processes that a notebook starts, whatever this process does about it."""

import contextlib
import os
import signal
import threading
from collections.abc import Iterator


@contextlib.contextmanager
def interruptible() -> Iterator[None]:
    """Let Ctrl+C raise KeyboardInterrupt here, and end the processes that start here, even if this one ignores it.

    A process inherits "SIGINT ignored" and hands it on to all that it starts: from ``nohup``, from a shell's background
    job, and in ipykernel between two cells. A signal with a handler is back at its default in a new process. Python
    lets only the main thread set handlers; in any other this does nothing.
    """
    in_main_thread = threading.current_thread() is threading.main_thread()
    if not in_main_thread or signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        yield
        return
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextlib.contextmanager
def handed_to(group: int) -> Iterator[None]:
    """Hand each Ctrl+C to a group of processes, and raise no KeyboardInterrupt here, where it could come between
    reading a piece of output and keeping it.

    :param group: The group's id, which is the process id of the one that was started in a new session. If it has
        ended, nothing happens.

    As with ``interruptible``, in any thread but the main one this does nothing.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def hand_on(*_: object) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(group, signal.SIGINT)

    before = signal.signal(signal.SIGINT, hand_on)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
