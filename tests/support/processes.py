"""Processes that a test has started: how they stand still, and how they end."""

import contextlib
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

# The first lines of a program that stands still when it is told to, before it has a second thread.
CAN_STAND_STILL = '''
import signal
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGUSR2])
signal.signal(signal.SIGUSR1, lambda *_: signal.sigwait([signal.SIGUSR2]))
'''


@contextlib.contextmanager
def standing_still(process: 'subprocess.Popen[Any]') -> Iterator[None]:
    """Let the Python of a process that begins with CAN_STAND_STILL do nothing in this block, as in a debugger.

    SIGSTOP would also stop its DDS, which other processes take for dead after 8 s, and may then never find again.
    """
    process.send_signal(signal.SIGUSR1)
    try:
        yield
    finally:
        process.send_signal(signal.SIGUSR2)


def environment_without_domain() -> dict[str, str]:
    """Return the environment of this process for one that is to choose a ROS domain of its own."""
    return {name: value for name, value in os.environ.items() if name != 'ROS_DOMAIN_ID'}


def output_of(program: str, folder: Path | None = None) -> str:
    """Run a program of Python in a folder, and return what it prints; it must not fail, or complain."""
    done = subprocess.run([sys.executable, '-c', program], capture_output=True, text=True, cwd=folder)
    assert (done.returncode, done.stderr) == (0, '')
    return done.stdout


def wait_or_kill(process: 'subprocess.Popen[Any]', patience_sec: float = 30.0) -> None:
    """Wait until a process has ended; kill one that takes longer."""
    try:
        process.wait(patience_sec)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
