"""A second terminal for a notebook: a command that runs in a process of its own beside the cells.

For commands that go on until Ctrl+C, such as ``ros2 run``. Those that end by themselves are better off with
``%ros2``, which needs no process at all.
"""

import atexit
import functools
import math
import os
import re
import shlex
import signal
import sys
import threading
import time
import weakref
from collections import deque
from collections.abc import Mapping, Sequence
from pathlib import Path

from param_tools.cli import command as embedded
from param_tools.cli.session import Session
from param_tools.errors import WaitTimeoutError
from param_tools.ros import domain, environment, host, stage
from param_tools.ros.processes import Output
from param_tools.ros.waiting import PATIENCE, Steps, deadline, wait
from param_tutorial.notebook.interrupts import interruptible
from param_tutorial.notebook.shell import Shell

# As in the console of a node, less the time stamp: what a lesson shows must be the same tomorrow.
_LOG_FORMAT = '[{severity}] [{name}]: {message}'
# The same holds for what `ros2 launch` says of processes, and of the folder of its log files.
_PROCESS_ID = re.compile(r'(?<=: process started) with pid \[\d+\]$|(?<=: process has finished cleanly) \[pid \d+\]$|'
                         r'(?<=: process has died \[)pid \d+, ')
_LOG_FOLDER = '[INFO] [launch]: All log files can be found below '
# A command that sleeps may be about to wake up, unless it does so at each of several looks.
_LOOKS = 8
_open: 'weakref.WeakSet[Terminal]' = weakref.WeakSet()


class Terminal:
    """A running command; what it prints is kept.

    Some things are left out, because they differ each time: the times of a node's log lines, and, of what ``ros2
    launch`` says, process IDs and the folder of the log files.

    >>> terminal = Terminal('ros2 run param_tutorial simple_param_node')  # doctest: +SKIP
    >>> print(terminal.read(until='declared'))                            # doctest: +SKIP
    >>> terminal.interrupt()                                              # doctest: +SKIP
    0
    """

    def __init__(self, command: str, shell: Shell | None = None, variables: Mapping[str, str] | None = None):
        """Start a command, in the ROS domain of this process.

        The same command, if it still runs in an earlier terminal, is interrupted first: that is a cell that runs again,
        and nobody could interrupt it later.

        :param command: As typed into a shell, without pipes and variables. A leading ``ros2`` is the
            course's own. Without a shell, a leading ``python3`` is the Python of this process, since another one may
            know nothing of rclpy.
        :param shell: Start it in the folder and with the environment that this shell has now.
        :param variables: What its environment has besides.
        :raises FileNotFoundError: there is no such command.
        :raises NoProcessError: it needs a process of its own, and there can be none.
        """
        domain.choose()
        environment.drop_old_builds()
        self.command = command
        for earlier in list(_open):
            if earlier.command == command and earlier.is_running:
                earlier.interrupt()
        self._text = ''
        self._read = 0
        self._lock = threading.RLock()
        self._changed = threading.Condition(self._lock)
        self._all_read = threading.Event()
        arguments = shlex.split(command)
        outer, folder, instead = dict(os.environ), None, None
        if shell is not None:
            outer, folder = shell.environment(), shell.folder()
        elif arguments[0] == 'python3':
            arguments[0] = sys.executable or 'python3'
        if arguments[0] == 'ros2':
            instead = functools.partial(_embedded, arguments[1:])
            arguments[:1] = embedded.process_words()
        with interruptible():
            self._process = host.host.start(
                arguments, Output(self._take, began=self._begin, ended=self._end), folder=folder, is_interactive=True,
                instead=instead,
                environment={**{name: value for name, value in outer.items() if not name.startswith('RCUTILS_')},
                             **(variables or {}), 'RCUTILS_CONSOLE_OUTPUT_FORMAT': _LOG_FORMAT, 'PYTHONUNBUFFERED': '1',
                             'PYTHON_COLORS': '0'})  # ipykernel asks for colors, and from 3.13 on a traceback has them
        _open.add(self)

    def __repr__(self) -> str:
        status = self._process.poll()
        return f'<Terminal: {self.command} ({"running" if status is None else f"ended with status {status}"})>'

    @property
    def is_running(self) -> bool:
        """True until the command ends."""
        return self._process.poll() is None

    @property
    def text(self) -> str:
        """Everything printed so far."""
        with self._lock:
            return self._text

    def read(self, until: str, timeout_sec: float = 20.0) -> str:
        """Return what has been printed since the last read, up to and including the first line that contains a text.

        :raises WaitTimeoutError: no such line came in time, or the command ended without it.
        """
        end_of_time = deadline(timeout_sec)
        with self._lock:
            while True:
                at = self._text.find(until, self._read)
                end = self._text.find('\n', at)
                if at >= 0 and end >= 0:
                    lines, self._read = self._text[self._read:end], end + 1
                    return lines
                ended = self._all_read.is_set()
                if ended or time.monotonic() > end_of_time:
                    why = 'the command ended' if ended else f'{timeout_sec:g} s passed'
                    raise WaitTimeoutError(f'{why} before a line with {until!r} came from {self.command!r}; '
                                           f'what came:\n{self._text[self._read:] or "(nothing)"}')
                self._changed.wait(0.2)

    def wait_until_idle(self, timeout_sec: float) -> bool:
        """Wait until the command, and all that it has started, waits too, and return whether it does.

        Only Linux tells. In a page, a command always waits while a cell runs.
        """
        looks = deque([False], maxlen=_LOOKS)

        def is_idle() -> bool:
            looks.append(not host.host.has_processes or _sleeps(self._process_id))
            return len(looks) == _LOOKS and all(looks)

        return wait(is_idle, timeout_sec)

    def interrupt(self, timeout_sec: float = 20.0, number: int = signal.SIGINT, *, times: int = 1) -> int:
        """Press Ctrl+C and wait for the end; a command that does not end is killed.

        :param timeout_sec: How long it may take. ``ros2 launch`` needs up to 10 s for nodes that ignore Ctrl+C, and
            killed before, it would leave them running.
        :param number: The signal to send, if not that of Ctrl+C.
        :param times: How often to send it, while the command goes on, within this time.
        :return: Its exit status; negative if a signal ended it.
        """
        for _ in range(times):
            self._process.send(number)
            if self._process.wait(timeout_sec * PATIENCE / times):
                break
        else:
            self._process.send(signal.SIGKILL)
            self._process.wait(math.inf)
        self._all_read.wait(timeout_sec)
        status = self._process.poll()
        assert status is not None  # it has ended
        return status

    def _take(self, line: str) -> None:
        if not line.startswith(_LOG_FOLDER):
            with self._lock:
                self._text += _PROCESS_ID.sub('', line)
                self._changed.notify_all()

    def _begin(self, process_id: int) -> None:
        self._process_id = process_id

    def _end(self, _status: int) -> None:
        with self._lock:
            self._all_read.set()
            self._changed.notify_all()


def _sleeps(process_id: int) -> bool:
    """True if the main threads of a process and of those below it sleep, or there are none any more."""
    folder = Path('/proc', str(process_id))
    try:
        state = (folder / 'stat').read_text().rpartition(')')[2].split()[0]
        children = (folder / 'task' / str(process_id) / 'children').read_text().split()
    except OSError:
        return True
    return state == 'S' and all(_sleeps(int(each)) for each in children)


def _embedded(words: Sequence[str]) -> Steps:
    """Do what ``ros2`` does with these words, in this process."""
    return embedded.steps(words, Session(sys.stdout, sys.stderr, stage.current, in_notebook=False))


@atexit.register
def end_all() -> None:
    for terminal in list(_open):
        terminal.interrupt(8.0)


# A cell that ran twice has lost the first of its terminals, and an interrupted one never came to its Ctrl+C. When the
# notebook then runs from the top, their nodes would answer in place of its new ones of the same name.
stage.on_start(end_all)
