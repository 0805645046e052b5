"""The end of a process that a test has started and has asked to end."""

import subprocess
from typing import Any

from param_tutorial.runtime.waiting import within


def wait_or_kill(process: 'subprocess.Popen[Any]', patience_sec: float = 30.0) -> None:
    """Wait until a process has ended; kill one that takes longer, in machine time."""
    def ends(seconds: float) -> bool:
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        return True

    if not within(patience_sec, ends):
        process.kill()
        process.wait()
