"""The keyboard and the screen for code that runs where nobody can type an answer, or read all that it prints.

A callback that asks with ``input()`` would keep every node on the stage waiting, and one that prints 100,000 lines
would keep the browser busy for a minute. No ROS, no Jupyter.
"""

import builtins
import contextlib
import sys
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any, TextIO

# From one callback, and each second from the thread that spins all nodes.
STAGE_LINES = 200
_PERIOD_SEC = 1.0
# From a learner's code, for each check.
CHECK_LINES = 40
_CHARS_PER_LINE = 100


class Allowance:
    """How much may be printed; what is beyond it is counted."""

    def __init__(self, lines: int):
        """:param lines: So many, of 100 characters on average."""
        self._lines = lines
        self._left_out = 0
        self._lock = threading.Lock()
        self.renew()

    def renew(self) -> None:
        """Let so many lines pass again."""
        with self._lock:
            self._lines_left, self._chars_left = self._lines, self._lines * _CHARS_PER_LINE

    def take(self, text: str) -> str:
        """Return what may be printed of a text."""
        with self._lock:
            if self._chars_left <= 0:  # a flood comes this way hundreds of thousands of times
                self._left_out += text.count('\n')
                return ''
            part = text[:self._chars_left]
            lines = part.split('\n', self._lines_left)
            if len(lines) > self._lines_left:
                part = part[:len(part) - len(lines[-1])]
            self._lines_left -= part.count('\n')
            self._chars_left -= len(part)
            if part != text:
                # Nothing more until it is renewed: the end of a line would stand there without its beginning.
                self._lines_left = self._chars_left = 0
                self._left_out += text.count('\n', len(part))
            return part

    def left_out(self) -> int:
        """Return how many lines were left out, and count from 0 again."""
        with self._lock:
            count, self._left_out = self._left_out, 0
            return count


class _Output:
    """Stands in for sys.stdout or sys.stderr, and does not let everything through."""

    def __init__(self, stream: TextIO, applies_here: Callable[[], bool], allowance: Allowance):
        self._stream = stream
        self._applies_here = applies_here
        self._allowance = allowance

    def write(self, text: str) -> int:
        if not self._applies_here():
            return self._stream.write(text)
        if part := self._allowance.take(text):
            self._stream.write(part)
        return len(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


class _Input:
    """Stands in for input()."""

    def __init__(self, ask: Callable[..., str], forbidden_here: Callable[[], Exception | None]):
        self.ask = ask
        self._forbidden_here = forbidden_here

    def __call__(self, *prompt: object) -> str:
        if error := self._forbidden_here():
            raise error
        return self.ask(*prompt)


class Guard:
    """Watches over what code in one thread prints, and keeps it from asking.

    Code that captures output replaces sys.stdout, and Jupyter replaces input() for each cell. So the guard looks after
    its post each time before such code runs.
    """

    def __init__(self, applies_here: Callable[[], bool], forbidden_here: Callable[[], Exception | None]):
        """
        :param applies_here: True in the thread whose output is limited.
        :param forbidden_here: Returns what input() raises, None where it may ask.
        """
        self._applies_here = applies_here
        self._forbidden_here = forbidden_here
        self._allowance = Allowance(STAGE_LINES)
        self._renewed = self._told = time.monotonic()

    def look(self) -> None:
        """Be in place: a callback is about to begin. Within one, however long it prints, nothing is renewed."""
        if time.monotonic() >= self._renewed + _PERIOD_SEC:
            self.renew()
        for name in ('stdout', 'stderr'):
            stream = getattr(sys, name)
            if not isinstance(stream, _Output):
                setattr(sys, name, _Output(stream, self._applies_here, self._allowance))
        if not isinstance(builtins.input, _Input):
            builtins.input = _Input(builtins.input, self._forbidden_here)

    def renew(self) -> None:
        """Begin anew to count what is printed."""
        self._renewed = time.monotonic()
        self._allowance.renew()

    def left_out(self) -> int:
        """Return how many lines were left out and not told of yet; at most once a second more than 0."""
        if time.monotonic() < self._told + _PERIOD_SEC:
            return 0
        if count := self._allowance.left_out():
            self._told = time.monotonic()
        return count

    @staticmethod
    def say(text: str) -> None:
        """Print a line on sys.stderr that counts for nobody and is never left out."""
        stream = sys.stderr
        print(text, file=stream._stream if isinstance(stream, _Output) else stream)

    def leave(self) -> None:
        """Leave everything as it was."""
        for name in ('stdout', 'stderr'):
            stream = getattr(sys, name)
            if isinstance(stream, _Output) and stream._allowance is self._allowance:
                setattr(sys, name, stream._stream)
        if isinstance(builtins.input, _Input) and builtins.input._forbidden_here == self._forbidden_here:
            builtins.input = builtins.input.ask


@contextlib.contextmanager
def guarded(forbidden: Callable[[], Exception]) -> Iterator[None]:
    """Let the block print its first lines only, say how many were left out, and make input() raise an exception."""
    allowance = Allowance(CHECK_LINES)
    streams, ask = (sys.stdout, sys.stderr), builtins.input
    sys.stdout, sys.stderr = (_Output(stream, lambda: True, allowance) for stream in streams)
    builtins.input = _Input(ask, forbidden)
    try:
        yield
    finally:
        (sys.stdout, sys.stderr), builtins.input = streams, ask
        if count := allowance.left_out():
            print(f'… and {count:,} more lines, which are left out here.')
