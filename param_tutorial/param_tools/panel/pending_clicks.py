"""What a person did on a page before a cell was run is done before the cell, although another thread does it.

No Jupyter: ``beside_cells`` tells of messages from the page, and the notebook extension waits before each cell.
"""

import threading

# A message is handled within milliseconds, and one to a thread or a widget that has gone never is.
_PATIENCE_SEC = 1.0


class Backlog:
    """Counts the messages that have come, and those that have been handled, in the order in which they came."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._came = self._handled = 0

    def add(self) -> None:
        """A message has come, and is about to be handed to the thread that handles it."""
        with self._changed:
            self._came += 1

    def take(self) -> None:
        """A message has been handled."""
        with self._changed:
            self._handled = min(self._handled + 1, self._came)
            self._changed.notify_all()

    def wait(self, timeout_sec: float = _PATIENCE_SEC) -> bool:
        """Wait until all messages have been handled that have come by now.

        :param timeout_sec: After that, they count as lost, and nobody waits for them again.
        :return: False if some were lost.
        """
        with self._changed:
            came = self._came
            if self._changed.wait_for(lambda: self._handled >= came, timeout_sec):
                return True
            self._handled = came
            return False


from_pages = Backlog()
"""The messages of this process's views that a thread beside the cells handles."""
