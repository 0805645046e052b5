"""Widgets that answer while a cell runs.

ipykernel handles one message after the other in its main thread, so a slider waits there until the cell has ended.
JupyterLab from 4.4 on avoids that: it asks the kernel for a subshell, which is a thread that handles messages too, and
addresses what a person does with a widget to it.
"""

from typing import Any

import ipywidgets as widgets


def answer_beside_cells(widget: widgets.Widget) -> None:
    """Let the page choose the thread of the kernel that handles what a person does with a widget.

    ipykernel 7.4 overrules the page: it hands each message of a widget to the thread that sent something to that widget
    last, so that a cell that asks a page gets the answer itself. At first that is the main thread. Later it may be the
    subshell of a page that has been closed, and a message to a subshell that was deleted is lost. Kernels before 7.4
    and pages without subshells need no help.
    """
    if hasattr(widget.comm, '_reply_subshell_for'):
        widget.comm._reply_subshell_for = _as_addressed


def _as_addressed(_data: Any, subshell_id: str | None) -> str | None:
    return subshell_id
