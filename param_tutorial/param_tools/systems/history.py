"""Undo and redo for the parameters of a node."""

from param_tools.systems.comparing import compare
from param_tools.systems.restoring import Restored, restore
from param_tools.systems.sets import NodeLike, ParameterSet, as_client


class ParameterHistory:
    """Snapshots of a node, to go back and forth: ``keep`` before you try something, then ``undo`` and ``redo``."""

    def __init__(self, node: NodeLike):
        """Take the first snapshot."""
        self._client = as_client(node)
        self._snapshots = [ParameterSet.of(self._client, 'snapshot 1')]
        self._at = 0

    def __repr__(self) -> str:
        return f'<ParameterHistory: {self._client.node}, snapshot {self._at + 1} of {len(self._snapshots)}>'

    def keep(self) -> ParameterSet:
        """Take a snapshot, if anything has changed since the last one; then nothing can be redone any more."""
        now = ParameterSet.of(self._client, f'snapshot {self._at + 2}')
        if now != self._snapshots[self._at]:
            self._snapshots[self._at + 1:] = [now]
            self._at += 1
        return self._snapshots[self._at]

    def undo(self) -> Restored:
        """Go back to the last snapshot that differs from the node's values; these are kept for ``redo``.

        :raises LookupError: there is no such snapshot.
        """
        return self._go(-1, 'undo')

    def redo(self) -> Restored:
        """Take the last undo back.

        :raises LookupError: nothing was undone, or something has changed since.
        """
        return self._go(+1, 'redo')

    def _go(self, step: int, word: str) -> Restored:
        here = self._snapshots[self._at]
        if compare(here, self._client, names=here):  # a parameter that was declared later could not be removed
            self.keep()
        goal = self._at + step
        if not 0 <= goal < len(self._snapshots):
            raise LookupError(f'there is nothing to {word} for {self._client.node}')
        restored = restore(self._client, self._snapshots[goal])
        if restored.complete:
            self._at = goal
        return restored
