"""The end of a process that a test has started and has asked to end."""

import subprocess
from typing import Any

from param_tutorial.runtime.processes import ends
from param_tutorial.runtime.waiting import within


def wait_or_kill(process: 'subprocess.Popen[Any]', patience_sec: float = 30.0) -> None:
    """Wait until a process has ended; kill one that takes longer, in machine time."""
    if not within(patience_sec, ends(process)):
        process.kill()
        process.wait()
