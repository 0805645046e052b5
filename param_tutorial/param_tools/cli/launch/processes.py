"""The programs of a launch file while they run: their output, their end, and Ctrl+C."""

import contextlib
import itertools
import os
import queue
import signal
import subprocess
import threading
import time
from collections.abc import Iterable
from typing import IO, NamedTuple

from param_tools.cli.session import TextStream

# As in launch: so long for Ctrl+C, then so long for SIGTERM.
GRACE_SEC = 5.0
# Python doesn't end a wait for a signal that comes just before it.
_LOOK_PERIOD_SEC = 0.5
_SIGNALS = {signal.SIGINT: 'ctrl-c (SIGINT)', signal.SIGTERM: 'SIGTERM'}


class Program(NamedTuple):
    """What is to be started."""

    command: list[str]
    name: str
    """The executable's; its number is added on the screen."""
    show_stdout: bool
    show_stderr: bool
    """Nodes log there."""


class Launcher:
    """Starts programs, shows what they print, and stays until all have ended."""

    def __init__(self, stdout: TextStream):
        self._stdout = stdout
        self._lock = threading.Lock()
        self._numbers = itertools.count(1)
        self._running: dict[str, subprocess.Popen[str]] = {}
        # The names of programs that have ended, and the numbers of signals that have come.
        self._events: queue.SimpleQueue[str | int] = queue.SimpleQueue()

    def log(self, level: str, name: str, text: str) -> None:
        """Print a line of the launcher's own."""
        self._print(f'[{level}] [{name}]: {text}')

    def _print(self, line: str) -> None:
        # The reader may have been killed, and the programs have to be ended all the same.
        with self._lock, contextlib.suppress(BrokenPipeError):
            print(line, file=self._stdout, flush=True)

    def run(self, programs: Iterable[Program]) -> None:
        """Start programs, and wait until all have ended; Ctrl+C or SIGTERM ends them."""
        before = {number: signal.signal(number, lambda number, _frame: self._events.put(number)) for number in _SIGNALS}
        try:
            for program in programs:
                self._start(program)
            while self._running:
                try:
                    event = self._events.get(timeout=_LOOK_PERIOD_SEC)
                except queue.Empty:
                    continue
                if isinstance(event, str):
                    del self._running[event]
                else:
                    self.log('WARNING', 'launch', f'user interrupted with {_SIGNALS[signal.Signals(event)]}')
                    self._end_all()
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _start(self, program: Program) -> None:
        name = f'{program.name}-{next(self._numbers)}'
        try:
            # In a session of its own: Ctrl+C reaches it once, through this launcher.
            process = subprocess.Popen(
                program.command, stdin=subprocess.DEVNULL, text=True, errors='replace', start_new_session=True,
                stdout=subprocess.PIPE if program.show_stdout else subprocess.DEVNULL,
                stderr=subprocess.PIPE if program.show_stderr else subprocess.DEVNULL)
        except OSError as error:
            self.log('ERROR', name, f'exception occurred while executing process: {error.strerror}: '
                                   f'{program.command[0]}')
            return
        self._running[name] = process
        self.log('INFO', name, f'process started with pid [{process.pid}]')
        threading.Thread(target=self._watch, args=(name, program, process), daemon=True).start()

    def _watch(self, name: str, program: Program, process: subprocess.Popen[str]) -> None:
        readers = [threading.Thread(target=self._copy, args=(name, lines), daemon=True)
                   for lines in (process.stdout, process.stderr) if lines]
        for reader in readers:
            reader.start()
        for reader in readers:
            reader.join()
        status = process.wait()
        if status == 0:
            self.log('INFO', name, f'process has finished cleanly [pid {process.pid}]')
        else:
            command = ' '.join(word for word in program.command if word.strip())
            self.log('ERROR', name, f"process has died [pid {process.pid}, exit code {status}, cmd '{command}'].")
        self._events.put(name)

    def _copy(self, name: str, lines: IO[str]) -> None:
        with lines:
            for line in lines:
                self._print(f'[{name}] {line.rstrip(os.linesep)}')

    def _end_all(self) -> None:
        for number, escalation in ((signal.SIGINT, 'SIGTERM'), (signal.SIGTERM, 'SIGKILL'), (signal.SIGKILL, '')):
            for process in self._running.values():
                process.send_signal(number)
            deadline = time.monotonic() + GRACE_SEC
            while self._running and (left := deadline - time.monotonic()) > 0:
                with contextlib.suppress(queue.Empty):
                    event = self._events.get(timeout=left)
                    self._running.pop(str(event), None)  # a further Ctrl+C changes nothing
            for name in self._running if escalation else ():
                self.log('ERROR', name, f"process failed to terminate '{GRACE_SEC:g}' seconds after receiving "
                                        f"'{signal.Signals(number).name}', escalating to '{escalation}'")
