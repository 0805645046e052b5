"""The programs of a launch file while they run."""

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

from param_tools.cli.run import is_our_node, signals_held
from param_tools.cli.session import TextStream

# As launch: so long for Ctrl+C, then so long for SIGTERM.
GRACE_SEC = 5.0
_LOOK_PERIOD_SEC = 0.1


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
        # A signal is one more event in the queue, so none comes between a program's start and its place in the list.
        before = {number: signal.signal(number, lambda number, _frame: self._events.put(number))
                  for number in (signal.SIGINT, signal.SIGTERM)}
        interrupted = False
        try:
            for program in programs:
                self._start(program)
            while self._running:
                event = self._events.get()
                if isinstance(event, str):
                    del self._running[event]
                else:
                    which = 'ctrl-c (SIGINT)' if event == signal.SIGINT else 'SIGTERM'
                    self.log('WARNING', 'launch', f'user interrupted with {which}')
                    interrupted = True
                    self._end_all()
        finally:
            # After a first Ctrl+C this process is about to end: a second must not keep it from tidying up.
            if not interrupted:
                for number, handler in before.items():
                    signal.signal(number, handler)

    def _start(self, program: Program) -> None:
        name = f'{program.name}-{next(self._numbers)}'
        try:
            # In a session of its own: Ctrl+C reaches it once, through this launcher.
            with signals_held(hears_of_it=is_our_node(program.command)):
                process = subprocess.Popen(
                    program.command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                    text=True, errors='replace', start_new_session=True)
        except OSError as error:
            self.log('ERROR', name, f'exception occurred while executing process: {error.strerror}: '
                                   f'{program.command[0]}')
            return
        self._running[name] = process
        self.log('INFO', name, f'process started with pid [{process.pid}]')
        threading.Thread(target=self._watch, args=(name, program, process), daemon=True).start()

    def _watch(self, name: str, program: Program, process: subprocess.Popen[str]) -> None:
        readers = [threading.Thread(target=self._copy, args=(name, process.stdout, program.show_stdout), daemon=True),
                   threading.Thread(target=self._copy, args=(name, process.stderr, program.show_stderr), daemon=True)]
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

    def _copy(self, name: str, lines: IO[str], show: bool) -> None:
        with lines:
            for line in lines:
                if show:
                    self._print(f'[{name}] {line.rstrip(os.linesep)}')

    def _end_all(self) -> None:
        for number, escalation in ((signal.SIGINT, 'SIGTERM'), (signal.SIGTERM, 'SIGKILL'), (signal.SIGKILL, '')):
            for process in self._running.values():
                with contextlib.suppress(ProcessLookupError):
                    process.send_signal(number)
            deadline = time.monotonic() + GRACE_SEC
            while self._running:
                try:
                    event = self._events.get(timeout=_LOOK_PERIOD_SEC)
                except queue.Empty:
                    if time.monotonic() < deadline:
                        continue
                    break
                if isinstance(event, str):  # another Ctrl+C changes nothing
                    del self._running[event]
            for name in self._running:
                if escalation:
                    self.log('ERROR', name, f"process failed to terminate '{GRACE_SEC:g}' seconds after receiving "
                                            f"'{signal.Signals(number).name}', escalating to '{escalation}'")
