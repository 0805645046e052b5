"""Wait for something with a deadline, and never by sleeping for luck.

Everything in the tools and the course that waits for a node does it here. The node runs in another thread meanwhile;
where there are none, ``turns`` has changed what waits, and it gives the node its turn.
"""

import math
import os
import threading
import time
from collections.abc import Callable, Generator
from typing import TypeVar

from param_tools.errors import WaitTimeoutError

T = TypeVar('T')

# What goes on until somebody ends it, as a generator: it yields each condition that it waits for, and returns an exit
# status. Ctrl+C is raised where it waits.
Steps = Generator[Callable[[], object], None, int]

# A machine that is always busy sets this to more than 1, and all limits are so many times as long.
PATIENCE = float(os.environ.get('PARAM_TOOLS_PATIENCE') or 1)
_FIRST_PAUSE_SEC, _LONGEST_PAUSE_SEC = 0.001, 0.02


def deadline(seconds: float) -> float:
    """Return when a time limit that begins now ends, on the clock of ``time.monotonic``."""
    return time.monotonic() + seconds * PATIENCE


def wait_for(event: threading.Event, seconds: float) -> bool:
    """Wait for an event with a time limit, and return whether it is set."""
    return event.wait(seconds * PATIENCE)


def wait(condition: Callable[[], object], seconds: float) -> bool:
    """Wait until a condition is true or the time is over, and return whether it is true.

    :param condition: Called again and again; must not block.
    """
    return wait_before(deadline(seconds), condition)


def wait_before(end: float, condition: Callable[[], object]) -> bool:
    """Wait as ``wait`` does, until a time that ``deadline`` returned."""
    pause_sec = _FIRST_PAUSE_SEC
    while True:
        is_late = time.monotonic() > end  # asked first: the last look is after the deadline
        if condition():
            return True
        if is_late:
            return False
        time.sleep(pause_sec)
        pause_sec = min(2 * pause_sec, _LONGEST_PAUSE_SEC)


def wait_until(condition: Callable[[], T], what: str, timeout_sec: float = 5.0) -> T:
    """Wait until a condition is true, and return what it returned.

    :param condition: Called again and again; must not block.
    :param what: Completes "timed out after N s waiting for …" in the error.
    :raises WaitTimeoutError: the condition was still false at the deadline.
    """
    found: list[T] = []

    def is_true() -> T:
        found[:] = [condition()]
        return found[0]

    if not wait(is_true, timeout_sec):
        raise WaitTimeoutError(f'timed out after {timeout_sec:g} s waiting for {what}')
    return found[0]


def to_end(steps: Steps) -> int:
    """Do all the steps, wait between them, and return the exit status."""
    try:
        condition = next(steps)
        while True:
            try:
                wait(condition, math.inf)
            except KeyboardInterrupt as error:
                condition = steps.throw(error)
            else:
                condition = next(steps)
    except StopIteration as end:
        return int(end.value)
