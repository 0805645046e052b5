"""Processes that this one starts: what they print, line by line, and none outlives it."""

import contextlib
import math
import os
import subprocess
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

# It reads the group, and then a second line, or learns that the process at the other end is gone. launch needs up to
# 10 s for nodes that ignore signals, and leaves them running if it is killed before.
_GUARD = """
read -r group || exit
read -r _ && exit
kill -s TERM -- "-$group" || exit
for _ in $(seq 200); do sleep 0.1; kill -s 0 -- "-$group" || exit; done
kill -s KILL -- "-$group"
"""


@dataclass(frozen=True)
class Output:
    """What is called with the output of a command, in one thread after the other or in two at the same time."""

    show: Callable[[str], object]
    """Takes a line from its standard output, with the end of the line if it has one."""
    show_err: Callable[[str], object] | None = None
    """Takes a line from its standard error. If there is none, they come among those of standard output, in order."""
    began: Callable[[int], object] = id
    """Called with the number of its process before the first line."""
    ended: Callable[[int], object] = id
    """Called with its exit status after the last line."""


class Guard:
    """Ends a group of processes if this process ends before, however it ends: SIGTERM, and SIGKILL 20 s later.

    Unlike Linux's "parent death signal", it also reaches what a command has started in its turn, and minds no thread.
    It is made before what it guards: a command that waits for it to start could be left alone by then.
    """

    def __init__(self) -> None:
        self.process = subprocess.Popen(['sh', '-c', _GUARD], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, start_new_session=True)

    def watch(self, group: int) -> None:
        """Guard from now on.

        :param group: The group's id, which is the process id of the one that was started in a new session.
        """
        assert self.process.stdin
        self.process.stdin.write(f'{group}\n'.encode())
        self.process.stdin.flush()

    def dismiss(self) -> None:
        """Guard no longer: the group has ended, and another may get its number; or there is none."""
        self.process.communicate(b'\n')

    def __enter__(self) -> 'Guard':
        return self

    def __exit__(self, *_: object) -> None:
        self.dismiss()


class Child:
    """A command in a process of its own; ``host.Command`` says what can be done with it."""

    def __init__(self, command: Sequence[str], output: Output | None = None, *,
                 environment: Mapping[str, str] | None = None, folder: Path | None = None,
                 is_interactive: bool = False):
        """Start it.

        :param output: Takes what it prints. Then it is in a session of its own, with nothing to read, and Ctrl+C
            reaches it through ``send`` only. Without it, it shares the terminal of this process.
        :param is_interactive: It is one that a person would type into a terminal. So its standard input is a terminal,
            although nobody types there: ``ros2 launch``, for one, ends programs otherwise without one. And it ends if
            this process ends before.
        :raises OSError: it cannot be started.
        """
        self._terminal, typed = os.openpty() if is_interactive else (-1, subprocess.DEVNULL)
        pipe = None if output is None else subprocess.PIPE
        # Nobody could end the command if this process were killed, and its nodes would answer for as long as it ran.
        self._guard = Guard() if is_interactive else None
        try:
            self.process = subprocess.Popen(
                command, stdin=None if output is None else typed, stdout=pipe,
                stderr=subprocess.STDOUT if output is not None and output.show_err is None else pipe, text=True,
                errors='replace', start_new_session=output is not None, cwd=folder, env=environment)
        except OSError:
            if self._guard is not None:
                self._guard.dismiss()
            self._close_terminal()
            raise
        finally:
            if is_interactive:
                os.close(typed)
        if self._guard is not None:
            self._guard.watch(self.process.pid)
        self._has_session = output is not None
        if output is not None:
            output.began(self.process.pid)
            threading.Thread(target=self._pass_on, args=[output], name=f'output of {command[0]}', daemon=True).start()

    def _pass_on(self, output: Output) -> None:
        pipes = [(self.process.stdout, output.show), (self.process.stderr, output.show_err)]
        readers = [threading.Thread(target=_copy, args=(lines, show), daemon=True) for lines, show in pipes
                   if lines and show]
        try:
            for reader in readers:
                reader.start()
            for reader in readers:
                reader.join()
            with contextlib.suppress(ChildProcessError):  # another thread has noticed the end
                os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOWAIT)
            if self._guard is not None:
                self._guard.dismiss()
        finally:
            status = self.process.wait()
            self._close_terminal()
            output.ended(status)

    def _close_terminal(self) -> None:
        if self._terminal >= 0:
            os.close(self._terminal)
            self._terminal = -1

    def poll(self) -> int | None:
        return self.process.poll()

    def send(self, number: int) -> None:
        if self.process.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                (os.killpg if self._has_session else os.kill)(self.process.pid, number)

    def wait(self, timeout_sec: float) -> bool:
        try:
            self.process.wait(None if timeout_sec == math.inf else timeout_sec)
        except subprocess.TimeoutExpired:
            return False
        return True


def _copy(lines: IO[str], show: Callable[[str], object]) -> None:
    with lines:
        for line in lines:
            show(line)
