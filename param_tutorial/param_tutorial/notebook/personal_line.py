"""A line that differs on each machine: a widget, because a notebook's test doesn't compare what is in a widget."""

import ipywidgets as widgets

from param_tools.panel.close_with_cell import close_looks, close_with_cell


class PersonalLine(widgets.HTML):
    """Some HTML that differs each time, with the same words in its place where no widget can be shown."""

    def __init__(self, markup: str, text: str) -> None:
        """
        :param markup: HTML.
        :param text: What stands in its place, the same each time.
        """
        super().__init__(markup)
        self._text = text
        close_with_cell(self)

    def __repr__(self) -> str:
        return self._text

    def close(self) -> None:
        """Remove it from the page. Safe to call more than once."""
        if self.comm is not None:
            close_looks(self)
            super().close()
