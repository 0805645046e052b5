"""What runs beside a cell, and how a wait lets it run: the one place that knows of threads and of other processes.

``host`` is what the rest of the tools asks. In a kernel and in a plain process it is ``Threads``: each loop has a
thread of its own, a wait only sleeps, and a command runs in a process of its own. Where there are no threads, as in a
web page, it is ``turns.Turns``: whatever waits gives each loop its turn, and a program runs as one of these loops. No
ROS, no Jupyter.
"""

import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Protocol, TypeVar

from param_tools.ros import interrupts
from param_tools.ros.processes import Child, Output
from param_tools.ros.waiting import Steps

T = TypeVar('T')
R = TypeVar('R')


class Loop(Protocol):
    """A function that is called again and again beside the cells, once it has been started."""

    def start(self) -> None:
        """Begin to call the function."""

    @property
    def has_ended(self) -> bool:
        """True if it will not be called again."""

    def is_current(self) -> bool:
        """True if the caller is called by the loop."""

    def interrupt(self, error: type[BaseException]) -> bool:
        """End what keeps the loop, if that is possible, with an exception; return whether it is."""

    def join(self, timeout_sec: float) -> bool:
        """Wait until the loop has ended, and return whether it has."""


class Command(Protocol):
    """A command that was started, in a process of its own or as a program in this one."""

    def poll(self) -> int | None:
        """Return its exit status, negative if a signal ended it; None if it runs."""

    def send(self, number: int) -> None:
        """Send it a signal; in a session of its own, also to what it has started in its turn."""

    def wait(self, timeout_sec: float) -> bool:
        """Wait until it has ended, and return whether it has."""


class Host(Protocol):
    """Runs loops, jobs and commands."""

    has_processes: bool
    """True if any command can be started: a shell, a compiler, a genuine ``ros2``."""

    def loop(self, step: Callable[[float], bool], is_over: Callable[[], bool], name: str, period_sec: float) -> Loop:
        """Return a loop that calls a function again and again until it is over.

        :param step: Does something that is due, and returns whether it did. It takes how long it may wait for that, in
            seconds.
        :param period_sec: How long the step may wait where it has a thread of its own.
        """

    def run(self, job: Callable[[], object], name: str) -> None:
        """Do a job that may wait, and don't keep the caller waiting if that is possible."""

    def map(self, question: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Call a function that waits with each item, all at the same time if that is possible; return the results."""

    def start(self, command: Sequence[str], output: Output | None = None, *,
              environment: Mapping[str, str] | None = None, folder: Path | None = None, is_interactive: bool = False,
              instead: Callable[[], Steps] | None = None) -> Command:
        """Start a command; ``processes.Child`` says what the arguments mean.

        :param instead: Does the same in this process, where there are no others.
        :raises OSError: it cannot be started.
        :raises NoProcessError: it can't run without a process of its own, and there is none.
        """


class ThreadLoop:
    """A loop in a thread of its own."""

    def __init__(self, step: Callable[[float], bool], is_over: Callable[[], bool], name: str, period_sec: float):
        self._step, self._is_over, self._period_sec = step, is_over, period_sec
        # If Ctrl+C comes as Thread.is_alive() looks, it says for good that the thread has ended (CPython 3.11).
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        self._thread.start()

    def _run(self) -> None:
        try:
            while not self._is_over():
                self._step(self._period_sec)
        finally:
            self._ended.set()

    @property
    def has_ended(self) -> bool:
        return self._ended.is_set()

    def is_current(self) -> bool:
        return threading.current_thread() is self._thread

    def interrupt(self, error: type[BaseException]) -> bool:
        return interrupts.raise_in(self._thread, error)

    def join(self, timeout_sec: float) -> bool:
        self._thread.join(timeout_sec)
        return not self._thread.is_alive()


class Threads:
    """The host of a process that has threads, and can start others."""

    has_processes = True

    def loop(self, step: Callable[[float], bool], is_over: Callable[[], bool], name: str, period_sec: float) -> Loop:
        return ThreadLoop(step, is_over, name, period_sec)

    def run(self, job: Callable[[], object], name: str) -> None:
        threading.Thread(target=job, name=name, daemon=True).start()

    def map(self, question: Callable[[T], R], items: Sequence[T]) -> list[R]:
        with ThreadPoolExecutor(max(len(items), 1)) as threads:
            return list(threads.map(question, items))

    def start(self, command: Sequence[str], output: Output | None = None, *,
              environment: Mapping[str, str] | None = None, folder: Path | None = None, is_interactive: bool = False,
              instead: Callable[[], Steps] | None = None) -> Command:
        return Child(command, output, environment=environment, folder=folder, is_interactive=is_interactive)


host: Host = Threads()


def choose(chosen: Host) -> None:
    """Let another host run everything from now on; before anything is started."""
    global host
    host = chosen
