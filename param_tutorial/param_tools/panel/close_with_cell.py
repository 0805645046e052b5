"""Close a cell's widgets when the cell runs again, unless another cell still displays them."""

from typing import Any

# For each cell, which of its runs made or showed the widgets, and these.
_made: dict[str, tuple[str, list[Any]]] = {}


def close_with_cell(widget: Any) -> None:
    """Close a widget when the cell that is running now runs again, unless another cell still shows it.

    Running a cell again replaces its output, so nobody can see the old widget there; but ipywidgets keeps it, and it
    would go on following its node. Front ends tell a cell's identity with each run; where none does (a console,
    nbval) nothing is closed.
    """
    cell, run = this_cell()
    if cell is None:
        return
    earlier_run, widgets = _made.get(cell, ('', []))
    if earlier_run == run:
        _made[cell] = run, [*(each for each in widgets if each is not widget), widget]
        return
    _made[cell] = run, [widget]
    for earlier in widgets:
        _close_unless_shown(earlier)


def _close_unless_shown(widget: Any) -> None:
    """Close a widget, and the views in it, but for what is shown elsewhere."""
    shown = [part for _, widgets in _made.values() for each in widgets for part in (each, *getattr(each, 'parts', ()))]
    if not any(each is widget for each in shown):
        widget.close()
        for part in getattr(widget, 'parts', ()):
            _close_unless_shown(part)


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
