"""What the nodes logged, collected from /rosout: the "first terminal" of the lessons. No Jupyter.

Console output of a background node would land in whichever cell is running. The log keeps it apart, as
plain lines without time stamps, so that a cell can show it and a test can compare it.
"""

import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from param_tools.errors import WaitTimeoutError
from param_tools.ros.listeners import Listeners
from param_tools.ros.waiting import wait

if TYPE_CHECKING:
    from rcl_interfaces.msg import Log

LEVELS = {10: 'DEBUG', 20: 'INFO', 30: 'WARN', 40: 'ERROR', 50: 'FATAL'}
CAPACITY = 5000


@dataclass(frozen=True)
class LogLine:
    """One message on /rosout."""

    level: str
    logger: str
    """The node's name, without a leading slash and with dots for slashes, e.g. 'clawbot.arm_controller'."""
    text: str
    time_ns: int
    """When the node logged it, in ns since 1970. A line may arrive long after."""

    def __str__(self) -> str:
        return f'[{self.level}] [{self.logger}]: {self.text}'


class NodeLog:
    """Collects log lines; ``read`` returns those that have come since the last time, as a terminal would.

    In a notebook, a cell reads what was logged since it began: see ``mark``.
    """

    def __init__(self) -> None:
        self._lines: deque[LogLine] = deque(maxlen=CAPACITY)
        self._received = 0
        # How many lines had been received when a reader (of one node, or of all: None) read last.
        self._read: dict[str | None, int] = {}
        self._marked_ns = 0
        self._lock = threading.RLock()
        self._listeners: Listeners[[LogLine]] = Listeners()

    def receive(self, message: 'Log') -> None:
        """Take a message rcl_interfaces/msg/Log from /rosout; called in the executor's thread."""
        line = LogLine(LEVELS.get(message.level, str(message.level)), message.name, message.msg,
                       message.stamp.sec * 10**9 + message.stamp.nanosec)
        with self._lock:
            self._lines.append(line)
            self._received += 1
        self._listeners.call(line)

    def on_line(self, listener: Callable[[LogLine], object]) -> Callable[[], None]:
        """Call a listener, in the executor's thread, with each new LogLine.

        :return: Call it to stop listening.
        """
        return self._listeners.add(listener)

    def lines(self, node: str | None = None) -> list[str]:
        """Return all lines that are kept, oldest first.

        :param node: Only those of this node, e.g. '/simple_param_node'.
        """
        with self._lock:
            return [str(line) for _, line in self._since(0, node)]

    def recent(self, node: str | None, count: int) -> list[LogLine]:
        """Return the newest lines that are kept, oldest first, at most so many.

        :param node: Only those of this node; None for all.
        """
        with self._lock:
            return [line for _, line in self._since(0, node)][-count:]

    def mark(self) -> None:
        """Read only what nodes log from now on.

        What was logged before is left out even if it arrives later. The notebook extension marks the beginning of each
        cell, so that no cell shows what a hand did on a panel before it.
        """
        with self._lock:
            self._marked_ns = time.time_ns()

    def read(self, until: str, node: str | None = None, timeout_sec: float = 5.0, *, since: str = '') -> str:
        """Return what has come since the last read, up to and including the first line that contains a text.

        Log messages travel apart from service answers and may arrive after them, so a reader has to say
        what it waits for.

        :param until: A part of the last line to return.
        :param node: Read only what this node logged, e.g. '/simple_param_node'. Lines of two nodes may
            arrive in either order; those of one node keep theirs.
        :param since: A part of the first line to return; lines before it are left out.
        :raises WaitTimeoutError: no such line came in time; the message shows what came instead.
        """
        lines: list[str] = []

        def has_come() -> bool:
            """Keep the lines up to the wanted one, or all that are unread, and return whether it is there."""
            with self._lock:
                # What was read of all nodes has been read of each; not the other way round.
                unread = [(number, line) for number, line in self._since(
                    max(self._read.get(None, 0), self._read.get(node, 0)), node) if line.time_ns >= self._marked_ns]
                first = next((at for at, (_, line) in enumerate(unread) if since in line.text), len(unread))
                last = next((at for at, (_, line) in enumerate(unread) if at >= first and until in line.text), None)
                lines[:] = [str(line) for _, line in (unread if last is None else unread[first:last + 1])]
                if last is not None:
                    self._read[node] = unread[last][0]
                return last is not None

        if not wait(has_come, timeout_sec):
            came = '\n'.join(lines) or '(nothing)'
            raise WaitTimeoutError(
                f'timed out after {timeout_sec:g} s waiting for a log line with {until!r}; what came:\n{came}')
        return '\n'.join(lines)

    def _since(self, number: int, node: str | None) -> list[tuple[int, LogLine]]:
        """Return the lines after the numbered one, each with its number; the first ever received is 1."""
        logger = node.strip('/').replace('/', '.') if node else None
        first = self._received - len(self._lines) + 1
        return [(at, line) for at, line in enumerate(self._lines, first)
                if at > number and logger in (None, line.logger)]

    def clear(self) -> None:
        """Forget all lines, read or not."""
        with self._lock:
            self._lines.clear()
            self._read.clear()

    def __repr__(self) -> str:
        return f'<NodeLog: {len(self._lines)} lines>'
