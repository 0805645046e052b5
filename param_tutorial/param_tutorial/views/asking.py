"""The line below a picture from which a reader asks a node for another value, without a cell."""

from collections.abc import Callable
from typing import Any

import traitlets

from param_tools import values
from param_tools.errors import ParameterToolError, describe_error
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front


class Asking(Front):
    """A line for another value, which has the type that ``ros2 param set`` would give it.

    It sends the value to the kernel, which asks the node; the picture above shows what came of it.
    """

    _esm = bundle('param_tutorial/views/asking.js')
    _css = sheet('param_tutorial/views/asking.css')
    name = traitlets.Unicode().tag(sync=True)
    """The parameter's."""
    text = traitlets.Unicode().tag(sync=True)
    """What the line begins with."""
    problem = traitlets.Unicode().tag(sync=True)
    """Why the node could not be asked; empty if it was."""
    outcome = traitlets.Unicode().tag(sync=True)
    """What came of it, for screen readers: everybody else sees the picture."""

    answered = traitlets.Int().tag(sync=True)
    """How many values have been answered, successfully or not."""

    def __init__(self, ask: Callable[[Any], str], **state: Any) -> None:
        """
        :param ask: Asks the node for a value, and returns what came of it, in a sentence.
        :param state: What the other traits are at first.
        """
        super().__init__(**state)
        self._ask = ask
        self.on_msg(self._on_message)

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        self.problem = ''
        try:
            self.outcome = self._ask(values.parse(content['asked']))
        except ParameterToolError as error:
            self.problem = f'{describe_error(error)}.'
        finally:
            self.answered += 1
