"""What was done in a panel, to be undone and done again."""

import contextlib
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from param_tools import values

# The values that a node has, by the parameters' names.
State = dict[str, Any]


@dataclass
class Edit:
    """One thing that was done, with all that the node changed when it was."""

    name: str
    grip: object
    before: State
    after: State


class Edits:
    """The edits of one panel, the last one on top.

    An edit begins when something is asked for and ends when the node has answered everything. What the node changes
    meanwhile belongs to it, also another parameter that a callback sets.
    """

    def __init__(self, state: Callable[[], State], bring: Callable[[State], dict[str, str]]):
        """
        :param state: Returns what the node has now.
        :param bring: Gives the node values, waits for it, and returns why it did not take some.
        """
        self._state, self._bring = state, bring
        self._lock = threading.Lock()
        self._done: list[Edit] = []
        self._undone: list[Edit] = []
        self._begun: tuple[str, object, State] | None = None
        self._held = 0

    @property
    def can_undo(self) -> bool:
        """True if there is something to undo."""
        return bool(self._done)

    @property
    def can_redo(self) -> bool:
        """True if there is something to do again."""
        return bool(self._undone)

    def begin(self, name: str, grip: object) -> None:
        """Take note that something is about to be asked for.

        :param grip: Edits of one parameter in a row with one grip are one; None for one by itself.
        """
        with self._lock:
            if self._begun is None:
                self._begun = name, grip, self._state()

    @contextlib.contextmanager
    def as_one(self) -> Iterator[None]:
        """Take all that is asked for meanwhile as one edit, also if the node has answered everything in between."""
        with self._lock:
            self._held += 1
        try:
            self.begin('', None)  # not before: somebody may end it at once
            yield
        finally:
            with self._lock:
                self._held -= 1
            self.end()

    def end(self) -> None:
        """Take note that the node has answered everything."""
        with self._lock:
            if self._begun is None or self._held:
                return
            (name, grip, before), self._begun, after = self._begun, None, self._state()
            changed = [each for each in before if each in after and not values.same(before[each], after[each])]
            if not changed:
                return
            self._undone.clear()
            edit = Edit(name, grip, {each: before[each] for each in changed}, {each: after[each] for each in changed})
            last = self._done[-1] if self._done else None
            if last is not None and grip is not None and (last.name, last.grip) == (name, grip):
                last.before = edit.before | last.before
                last.after |= edit.after
            else:
                self._done.append(edit)

    def undo(self) -> dict[str, str]:
        """Bring back what was there before the last edit, and return what could not be brought back, and why."""
        return self._move(self._done, self._undone, lambda edit: edit.before)

    def redo(self) -> dict[str, str]:
        """Bring back what was there after the edit that was undone last, and return what could not be, and why."""
        return self._move(self._undone, self._done, lambda edit: edit.after)

    def _move(self, source: list[Edit], target: list[Edit], wanted: Callable[[Edit], State]) -> dict[str, str]:
        with self._lock:
            if not source:
                return {}
            edit = source.pop()
            target.append(edit)
        # A parameter that was not set before can't be set back to that.
        reachable = {name: value for name, value in wanted(edit).items() if value is not None}
        unreachable = dict.fromkeys(wanted(edit).keys() - reachable.keys(), 'it had no value, and cannot lose one')
        return self._bring(reachable) | unreachable
