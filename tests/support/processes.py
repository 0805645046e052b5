"""Processes that a test has started: how they stand still, and how they end."""

import contextlib
import signal
import subprocess
from collections.abc import Iterator
from typing import Any

from param_tools.ros.processes import ends
from param_tools.ros.waiting import within

# The first lines of a program that stands still when it is told to, before it has a second thread.
CAN_STAND_STILL = '''
import signal
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGUSR2])
signal.signal(signal.SIGUSR1, lambda *_: signal.sigwait([signal.SIGUSR2]))
'''


@contextlib.contextmanager
def standing_still(process: 'subprocess.Popen[Any]') -> Iterator[None]:
    """Have the Python of a process that begins with CAN_STAND_STILL do nothing in this block, as in a debugger.

    SIGSTOP would stop its DDS too. After 8 s, which on a starved machine pass before half a second of machine time, it
    would then take this process for dead, and this process it; and if only one of them forgets the other, because their
    profiles say so, Fast DDS 2.14 may never bring them together again (5 of 65 on a busy machine).
    """
    process.send_signal(signal.SIGUSR1)
    try:
        yield
    finally:
        process.send_signal(signal.SIGUSR2)


def wait_or_kill(process: 'subprocess.Popen[Any]', patience_sec: float = 30.0) -> None:
    """Wait until a process has ended; kill one that takes longer, in machine time."""
    if not within(patience_sec, ends(process)):
        process.kill()
        process.wait()
