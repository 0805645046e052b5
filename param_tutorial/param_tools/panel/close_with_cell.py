"""What a notebook's cell made last time goes when the cell runs again."""

from typing import Any

# For each cell, which of its runs made the widgets, and these.
_made: dict[str, tuple[str, list[Any]]] = {}


def close_with_cell(widget: Any) -> None:
    """Close a widget when the cell that is running now runs again.

    Running a cell again replaces its output, so nobody can see the old widget; but ipywidgets keeps it, and it
    would go on following its node. Front ends tell a cell's identity with each run; where none does (a console,
    nbval) nothing is closed.
    """
    cell, run = this_cell()
    if cell is None:
        return
    earlier_run, widgets = _made.get(cell, ('', []))
    if earlier_run != run:
        for earlier in widgets:
            earlier.close()
        widgets = []
    _made[cell] = run, [*widgets, widget]


def close_looks(widget: Any) -> None:
    """Close a widget's layout and style, which ipywidgets keeps, here and in the browser, when the widget is closed."""
    for look in (widget.layout, getattr(widget, 'style', None)):
        if look is not None:
            look.close()


def this_cell() -> tuple[str | None, str]:
    """Return the id of the cell that runs, if it is known, and of its run."""
    from IPython import get_ipython

    kernel = getattr(get_ipython(), 'kernel', None)
    if kernel is None:
        return None, ''
    parent = kernel.get_parent()
    return parent.get('metadata', {}).get('cellId'), parent.get('header', {}).get('msg_id', '')
