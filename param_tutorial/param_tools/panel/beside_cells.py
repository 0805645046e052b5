"""Widgets that answer while a cell runs.

ipykernel handles one message after the other in its main thread, so a slider waits there until the cell has ended.
JupyterLab from 4.4 on avoids that: it asks the kernel for a subshell, which is a thread that handles messages too, and
addresses what a person does with a widget to it.

Only the course's own views are handled there. A learner's callbacks stay in the main thread, after the cell: they
share variables with it, print into its output, and may capture it in an ``Output``, none of which is safe in two
threads.
"""

from typing import Any

import ipywidgets as widgets

from param_tools.panel.pending_clicks import from_pages


def answer_beside_cells(widget: widgets.Widget) -> None:
    """Let the page choose the thread of the kernel that handles what a person does with a widget.

    ipykernel 7.4 overrules the page: it hands each message of a widget to the thread that sent something to that widget
    last, so that a cell that asks a page gets the answer itself. At first that is the main thread. Later it may be the
    subshell of a page that has been closed, and a message to a subshell that was deleted is lost. Kernels before 7.4
    and pages without subshells need no help.

    With 7.4, the next cell waits for what came before it: see ``runtime.backlog``.
    """
    comm, handle = widget.comm, widget._handle_msg
    if not hasattr(comm, '_reply_subshell_for'):
        return

    def route(_data: Any, subshell_id: str | None) -> str | None:
        # Called for each message in the order in which the page sent them and ran cells, before it is handed on.
        if subshell_id is not None:
            from_pages.add()
        return subshell_id

    def handle_and_tell(message: dict[str, Any]) -> None:
        try:
            handle(message)
        finally:
            if message['header'].get('subshell_id') is not None:
                from_pages.take()

    comm._reply_subshell_for = route
    comm.on_msg(handle_and_tell)
