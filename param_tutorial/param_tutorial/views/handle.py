"""The lines below pictures from which a reader asks a node without a cell: what all have in common, and the kinds."""

from collections.abc import Callable
from typing import Any

import traitlets

from param_tools import values
from param_tools.errors import ParameterToolError, describe_error
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front


class Handle(Front):
    """Sends what a reader chooses to the kernel, which asks the node; the picture above shows what came of it."""

    _css = sheet('param_tutorial/views/handle.css')
    problem = traitlets.Unicode().tag(sync=True)
    """Why the node could not be asked; empty if it was."""
    outcome = traitlets.Unicode().tag(sync=True)
    """What came of it, for screen readers: everybody else sees the picture."""

    answered = traitlets.Int().tag(sync=True)
    """How many choices have been answered, successfully or not."""

    def __init__(self, ask: Callable[[Any], str], **state: Any) -> None:
        """
        :param ask: Asks the node for what was chosen, and returns what came of it, in a sentence.
        :param state: What the other traits are at first.
        """
        super().__init__(**state)
        self._ask = ask
        self.on_msg(self._on_message)

    def _answer(self, chosen: Any) -> str:
        """Ask the node for what was chosen, and return what came of it."""
        return self._ask(chosen)

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        self.problem = ''
        try:
            self.outcome = self._answer(content['chosen'])
        except ParameterToolError as error:
            self.problem = f'{describe_error(error)}.'
        finally:
            self.answered += 1


class Asking(Handle):
    """A line for another value, which has the type that ``ros2 param set`` would give it."""

    _esm = bundle('param_tutorial/views/asking.js')
    name = traitlets.Unicode().tag(sync=True)
    """The parameter's."""
    text = traitlets.Unicode().tag(sync=True)
    """What the line begins with."""

    def _answer(self, chosen: str) -> str:
        return super()._answer(values.parse(chosen))


class Choosing(Handle):
    """A line for each of several things. A choice is a thing, one of its properties, and that property's new value."""

    _esm = bundle('param_tutorial/views/choosing.js')
    caption = traitlets.Unicode().tag(sync=True)
    """Stands above the lines."""
    options = traitlets.Dict().tag(sync=True)
    """For each property its possible values."""
    things = traitlets.Dict().tag(sync=True)
    """For each thing the value of each property."""
