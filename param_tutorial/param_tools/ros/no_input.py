"""No ``input()`` where nobody can type an answer: in a callback, every node would wait for it. No ROS, no Jupyter."""

import builtins
import contextlib
from collections.abc import Callable, Iterator

# Returns what input() raises, or None where it asks as usual; called in the thread that asks.
Objection = Callable[[], Exception | None]


class _Input:
    """Stands in for ``input``."""

    def __init__(self, ask: Callable[..., str], objection: Objection):
        self.ask, self.objection = ask, objection

    def __call__(self, *prompt: object) -> str:
        if error := self.objection():
            raise error
        return self.ask(*prompt)


def forbid(objection: Objection) -> None:
    """Let ``input()`` raise an exception. Jupyter puts its own ``input`` in place for each cell, so call this often."""
    if not (isinstance(builtins.input, _Input) and builtins.input.objection is objection):
        builtins.input = _Input(builtins.input, objection)


def allow(objection: Objection) -> None:
    """Undo ``forbid``."""
    if isinstance(builtins.input, _Input) and builtins.input.objection is objection:
        builtins.input = builtins.input.ask


@contextlib.contextmanager
def forbidden(objection: Objection) -> Iterator[None]:
    """Let ``input()`` raise an exception in this block."""
    ask, builtins.input = builtins.input, _Input(builtins.input, objection)
    try:
        yield
    finally:
        builtins.input = ask
