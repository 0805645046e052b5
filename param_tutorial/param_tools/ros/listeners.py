"""A list of functions to call when something happens. Safe to change from any thread, and while it is being called."""

from collections.abc import Callable
from typing import Generic, ParamSpec

P = ParamSpec('P')


class Listeners(Generic[P]):
    """Functions that want to hear of one kind of event."""

    def __init__(self) -> None:
        self._listeners: list[Callable[P, object]] = []

    def __len__(self) -> int:
        return len(self._listeners)

    def add(self, listener: Callable[P, object]) -> Callable[[], None]:
        """Add a function, to be called after those that are there.

        :return: Call it to stop listening; safe to call more than once.
        """
        self._listeners.append(listener)

        def remove() -> None:
            if listener in self._listeners:
                self._listeners.remove(listener)
        return remove

    def call(self, *args: P.args, **kwargs: P.kwargs) -> None:
        """Call every function, oldest first, in this thread."""
        for listener in list(self._listeners):
            listener(*args, **kwargs)
