"""The host of a process without threads, such as a web page: whatever waits gives each loop its turn.

``install()`` chooses it, before the stage is started, and makes ``time.sleep``, events and conditions give turns too:
there, nobody else could end such a wait. ``pump()`` gives turns between the cells. A command runs as a program in this
process (``programs``). Endless loops are ended by ``interrupts.time_limit``, in a web page with the timer of
``page_timer``. No ROS here, no Jupyter.

A loop is never called by itself, so a callback that waits for an answer that its own executor would have to bring waits
in vain, as in a thread.
"""

import asyncio
import contextlib
import signal
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from param_tools.ros import host, page_timer
from param_tools.ros.processes import Output
from param_tools.ros.waiting import Steps

if TYPE_CHECKING:
    from param_tools.ros.programs import Program

T = TypeVar('T')
R = TypeVar('R')

# How long the turn of a loop may take that always has something to do.
_TURN_SEC = 0.02
# How long to settle where something is due all the time.
_SETTLING_SEC = 0.1
_PAUSE_SEC = 0.0005
_PUMP_PERIOD_SEC = 0.02
_sleep = time.sleep


class TurnLoop:
    """A loop that gets turns."""

    def __init__(self, turns: 'Turns', step: Callable[[float], bool], is_over: Callable[[], bool],
                 program: 'Program | None' = None):
        self._turns, self._step, self._is_over, self._program = turns, step, is_over, program
        self._began = self._current = False

    def start(self) -> None:
        self._began = True

    def turn(self) -> bool:
        """Call the function until nothing is due, but not from within itself; return whether anything was due."""
        if self._current or not self._began:
            return False
        self._current = True
        was_due = found = False
        try:
            with self._turns.within(self._program):
                end = time.monotonic() + _TURN_SEC
                while not self._is_over() and time.monotonic() < end:
                    # A wait of no time finds nothing also after it has handed out all that was due. What came of that,
                    # such as a message that a timer has sent, must not wait for the next turn.
                    before, found = found, self._step(0.0)
                    if not (found or before):
                        break
                    was_due = True
        finally:
            self._current = False
        return was_due

    @property
    def has_ended(self) -> bool:
        return self._is_over()

    def is_current(self) -> bool:
        return self._current

    def interrupt(self, error: type[BaseException]) -> bool:
        return not self._current  # the caller runs, so a time limit has ended what kept the loop

    def join(self, timeout_sec: float) -> bool:
        return not self._current


class Turns:
    """Gives turns to loops, whenever somebody waits."""

    has_processes = False

    def __init__(self) -> None:
        self._loops: list[TurnLoop] = []
        self.program: Program | None = None

    def turn(self) -> bool:
        """Give each loop a turn, and return whether anything was due."""
        was_due = [loop.turn() for loop in list(self._loops)]
        self._loops = [loop for loop in self._loops if not loop.has_ended]
        return any(was_due)

    def settle(self) -> None:
        """Give turns until nothing is due any more: before a cell, as threads would have done by then."""
        end = time.monotonic() + _SETTLING_SEC
        while self.turn() and time.monotonic() < end:
            pass

    def loop(self, step: Callable[[float], bool], is_over: Callable[[], bool], name: str,
             period_sec: float) -> host.Loop:
        self._loops.append(TurnLoop(self, step, is_over))
        return self._loops[-1]

    def loop_within(self, program: 'Program', step: Callable[[float], bool], is_over: Callable[[], bool]) -> host.Loop:
        self._loops.append(TurnLoop(self, step, is_over, program))
        return self._loops[-1]

    @contextlib.contextmanager
    def within(self, program: 'Program | None') -> Iterator[None]:
        """Put a program's surroundings into place in this block; None for what runs in none."""
        before = self.program
        self._go_to(program)
        try:
            yield
        finally:
            self._go_to(before)

    def _go_to(self, program: 'Program | None') -> None:
        if program is not self.program:
            for each in (self.program, program):
                if each is not None:
                    each.swap()
            self.program = program

    def start(self, command: Sequence[str], output: Output | None = None, *,
              environment: Mapping[str, str] | None = None, folder: Path | None = None, is_interactive: bool = False,
              instead: Callable[[], Steps] | None = None) -> host.Command:
        from param_tools.ros import programs

        return programs.start(self, command, output, environment=environment, folder=folder, instead=instead)

    def run(self, job: Callable[[], object], name: str) -> None:
        job()

    def map(self, question: Callable[[T], R], items: Sequence[T]) -> list[R]:
        return list(map(question, items))

    def sleep(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while True:
            self.turn()
            if (left := end - time.monotonic()) <= 0.0:
                return
            _sleep(min(left, _PAUSE_SEC))

    async def pump(self) -> None:
        """Give turns for as long as there is a loop; between the cells, asyncio runs this."""
        while self._loops:
            began = time.monotonic()
            self.turn()
            await asyncio.sleep(max(0.0, began + _PUMP_PERIOD_SEC - time.monotonic()))


def install() -> Turns:
    """Let all loops get turns from now on, and return what gives them; before the stage is started."""
    turns = Turns()
    host.choose(turns)
    if not hasattr(signal, 'setitimer'):
        page_timer.install()

    def wait(condition: threading.Condition, timeout: float | None = None) -> bool:
        """Wait as ``threading.Condition.wait`` does, which ``Event``, ``Queue`` and ``Future`` call."""
        waiter = threading.Lock()
        waiter.acquire()
        condition._waiters.append(waiter)  # type: ignore[attr-defined]
        saved = condition._release_save()  # type: ignore[attr-defined]
        end = None if timeout is None else time.monotonic() + timeout
        try:
            while not (was_notified := waiter.acquire(blocking=False)):
                if end is not None and time.monotonic() >= end:
                    break
                turns.turn()
                _sleep(_PAUSE_SEC)
        finally:
            condition._acquire_restore(saved)  # type: ignore[attr-defined]
            with contextlib.suppress(ValueError):  # the one who notifies takes it out
                condition._waiters.remove(waiter)  # type: ignore[attr-defined]
        return was_notified

    time.sleep = turns.sleep  # type: ignore[assignment]
    threading.Condition.wait = wait  # type: ignore[assignment, method-assign]
    return turns
