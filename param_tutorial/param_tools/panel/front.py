"""How a view and its script in the browser reach each other, also on a slow machine and while a cell runs.

ipykernel handles one message after the other in its main thread, so a slider waits there until the cell has ended.
JupyterLab from 4.4 on avoids that: it asks the kernel for a subshell, which is a thread that handles messages too, and
addresses what a person does with a widget to it.

Only the course's own views are handled there. A learner's callbacks stay in the main thread, after the cell: they
share variables with it, print into its output, and may capture it in an ``Output``, none of which is safe in two
threads.
"""

import contextlib
import threading
import time
import uuid
from typing import Any

import anywidget
import ipywidgets as widgets
import traitlets

# A message is handled within milliseconds, and one to a thread or a widget that has gone never is.
_PATIENCE_SEC = 1.0


class Front(anywidget.AnyWidget):
    """A view in the browser. ``front.js`` says what it adds to an anywidget."""

    own_id = traitlets.Unicode().tag(sync=True)

    def __init__(self, **state: Any) -> None:
        """:param state: What its traits are at first."""
        own_id = uuid.uuid4().hex
        # Held by the thread that writes to it; a View puts its own lock here.
        self.drawing = threading.RLock()
        super().__init__(model_id=own_id, own_id=own_id, **state)

    def _handle_custom_msg(self, content: dict[str, Any], buffers: Any) -> None:
        if content != {'do': 'tell again'}:
            super()._handle_custom_msg(content, buffers)
            return
        with self.drawing:  # or what is written meanwhile would arrive before this, which is older
            self.send_state([name for name in self.keys if not name.startswith('_')])


class PendingMessages:
    """The messages from pages that have come and have not been handled: a cell waits for those before it.

    Lists are changed by single operations, which no other thread can interrupt, so there is no lock.
    """

    def __init__(self) -> None:
        self._pending: list[object] = []

    def add(self) -> None:
        """A message has come, and is about to be handed to the thread that handles it."""
        self._pending.append(object())

    def remove(self) -> None:
        """A message has been handled."""
        with contextlib.suppress(IndexError):  # it was late, and nobody waits for it any more
            self._pending.pop(0)

    def wait(self, timeout_sec: float = _PATIENCE_SEC) -> bool:
        """Wait until all messages have been handled that have come by now.

        :param timeout_sec: After that, they count as lost, and nobody waits for them again.
        :return: False if some were lost.
        """
        end = time.monotonic() + timeout_sec
        newest = self._pending[-1:]
        while newest and newest[0] in self._pending:
            if time.monotonic() >= end:
                self._pending.clear()
                return False
            time.sleep(0.001)
        return True


from_pages = PendingMessages()
"""The messages to this process's views that a thread beside the cells handles."""


def answer_beside_cells(widget: widgets.Widget) -> None:
    """Let the page choose the thread of the kernel that handles what a person does with a widget.

    ipykernel 7.4 overrules the page: it hands each message of a widget to the thread that sent something to that widget
    last, so that a cell that asks a page gets the answer itself. At first that is the main thread. Later it may be the
    subshell of a page that has been closed, and a message to a subshell that was deleted is lost. Kernels before 7.4
    and pages without subshells need no help.
    """
    comm, handle = widget.comm, widget._handle_msg
    if not hasattr(comm, '_reply_subshell_for'):
        return

    def route(_data: Any, subshell_id: str | None) -> str | None:
        # Called for each message in the order in which the page sent them and ran cells, before it is handed on.
        if subshell_id is not None:
            from_pages.add()
        return subshell_id

    def handle_and_count(message: dict[str, Any]) -> None:
        try:
            handle(message)
        finally:
            if message['header'].get('subshell_id') is not None:
                from_pages.remove()

    comm._reply_subshell_for = route
    comm.on_msg(handle_and_count)
