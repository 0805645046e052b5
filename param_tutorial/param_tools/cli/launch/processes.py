"""The programs of a launch file while they run: their output, their end, and Ctrl+C."""

import contextlib
import os
import queue
import signal
import threading
import time
from collections.abc import Callable, Generator, Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from param_tools.cli.session import TextStream
from param_tools.ros import host
from param_tools.ros.host import Command
from param_tools.ros.processes import Output
from param_tools.ros.waiting import Steps

# As in launch: so long for Ctrl+C, then so long for SIGTERM.
GRACE_SEC = 5.0
_SIGNALS = {signal.SIGINT: 'ctrl-c (SIGINT)', signal.SIGTERM: 'SIGTERM'}


class Program(NamedTuple):
    """What is to be started."""

    command: list[str]
    name: str
    """The executable's; its number is added on the screen."""
    show_stdout: bool
    show_stderr: bool
    """Nodes log there."""
    environment: Mapping[str, str] | None = None
    """Its environment variables; by default those of this process."""
    folder: Path | None = None
    """Where it runs; by default where this process does."""
    ends_all: bool = False
    """True if its end ends all."""


def _hide(_line: str) -> None:
    """Show nothing of a line."""


class Launcher:
    """Starts programs, shows what they print, and stays until all have ended."""

    def __init__(self, stdout: TextStream):
        self._stdout = stdout
        self._lock = threading.Lock()
        self._running: dict[str, Command] = {}
        # The names of programs that have ended, and the numbers of signals that have come.
        self._events: queue.SimpleQueue[str | int] = queue.SimpleQueue()

    def log(self, level: str, name: str, text: str) -> None:
        """Print a line of the launcher's own."""
        self.print(f'[{level}] [{name}]: {text}')

    def print(self, line: str) -> None:
        """Print a line, whole."""
        # The reader may have been killed, and the programs have to be ended all the same.
        with self._lock, contextlib.suppress(BrokenPipeError):
            print(line, file=self._stdout, flush=True)

    def run(self, programs: Iterable[Program]) -> Steps:
        """Start programs, and wait until all have ended; Ctrl+C or SIGTERM ends them."""
        before = {number: signal.signal(number, lambda number, _frame: self._events.put(number)) for number in _SIGNALS}
        try:
            named = {f'{program.name}-{number}': program for number, program in enumerate(programs, 1)}
            for name, program in named.items():
                self._start(name, program)
            while self._running:
                yield lambda: not self._events.empty()
                event = self._events.get()
                if not isinstance(event, str):
                    self.log('WARNING', 'launch', f'user interrupted with {_SIGNALS[signal.Signals(event)]}')
                    yield from self._end_all()
                    continue
                del self._running[event]
                if named[event].ends_all:
                    self.log('INFO', 'launch', f'process[{event}] was required: shutting down launched system')
                    yield from self._end_all()
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)
        return 0

    def _start(self, name: str, program: Program) -> None:
        # In a session of its own: Ctrl+C reaches it once, through this launcher.
        output = _ProgramOutput(self, name, program)
        try:
            self._running[name] = host.host.start(program.command, Output(
                output.show if program.show_stdout else _hide, output.show if program.show_stderr else _hide,
                output.begin, output.end), environment=program.environment, folder=program.folder)
        except OSError as error:
            self.log('ERROR', name, f'exception occurred while executing process: {error.strerror}: '
                                   f'{program.command[0]}')

    def has_ended(self, name: str) -> None:
        """Note that a program has ended."""
        self._events.put(name)

    def _end_all(self) -> Generator[Callable[[], object], None, None]:
        for number, escalation in ((signal.SIGINT, 'SIGTERM'), (signal.SIGTERM, 'SIGKILL'), (signal.SIGKILL, '')):
            for process in self._running.values():
                process.send(number)
            yield from self._wait_for_ends(time.monotonic() + GRACE_SEC)
            for name in self._running if escalation else ():
                self.log('ERROR', name, f"process failed to terminate '{GRACE_SEC:g}' seconds after receiving "
                                        f"'{signal.Signals(number).name}', escalating to '{escalation}'")

    def _wait_for_ends(self, deadline: float) -> Generator[Callable[[], object], None, None]:
        """Wait until all programs have ended, or the time is over."""
        while self._running and time.monotonic() < deadline:
            yield lambda: not self._events.empty() or time.monotonic() >= deadline
            while not self._events.empty():
                self._running.pop(str(self._events.get()), None)  # a further Ctrl+C changes nothing


class _ProgramOutput:
    """What is printed of a program: its lines, its beginning and its end."""

    def __init__(self, launcher: Launcher, name: str, program: Program):
        self._launcher, self._name, self._command = launcher, name, program.command
        self._number = 0

    def begin(self, number: int) -> None:
        self._number = number
        self._launcher.log('INFO', self._name, f'process started with pid [{number}]')

    def show(self, line: str) -> None:
        self._launcher.print(f'[{self._name}] {line.rstrip(os.linesep)}')

    def end(self, status: int) -> None:
        if status == 0:
            self._launcher.log('INFO', self._name, f'process has finished cleanly [pid {self._number}]')
        else:
            command = ' '.join(word for word in self._command if word.strip())
            self._launcher.log('ERROR', self._name, f'process has died [pid {self._number}, exit code {status}, '
                                                    f"cmd '{command}'].")
        self._launcher.has_ended(self._name)
