"""Ctrl+C for the processes that a notebook starts, whatever this process does about it."""

import contextlib
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
