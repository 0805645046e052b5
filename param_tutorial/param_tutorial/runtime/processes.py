"""Wait for another process to end, with a deadline in machine time."""

import subprocess
from collections.abc import Callable
from typing import Any


def ends(process: 'subprocess.Popen[Any]') -> Callable[[float], bool]:
    """Return a function that waits for a process to end, for ``waiting.within``."""
    def wait(seconds: float) -> bool:
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        return True
    return wait
