"""Wait for a condition with a deadline, and never by sleeping for luck."""

import time
from collections.abc import Callable
from typing import TypeVar

from param_tutorial.errors import WaitTimeoutError

T = TypeVar('T')


def wait_until(condition: Callable[[], T], what: str, timeout_sec: float = 5.0) -> T:
    """Wait until a condition is true, and return what it returned.

    :param condition: Called again and again; must not block.
    :param what: Completes "timed out after N s waiting for …" in the error.
    :raises WaitTimeoutError: the condition was still false at the deadline.
    """
    deadline = time.monotonic() + timeout_sec
    pause_sec = 0.001
    while not (value := condition()):
        if time.monotonic() > deadline:
            raise WaitTimeoutError(f'timed out after {timeout_sec:g} s waiting for {what}')
        time.sleep(pause_sec)
        pause_sec = min(2 * pause_sec, 0.02)
    return value
