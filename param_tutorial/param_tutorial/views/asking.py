"""A line below a picture in which a reader types another value, and the node is asked for it."""

from collections.abc import Callable
from typing import Any

import traitlets

from param_tools import values
from param_tools.errors import ParameterToolError, describe_error
from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front


class Asking(Front):
    """The line."""

    _esm = bundle('param_tutorial/views/asking.js')
    _css = sheet('param_tutorial/views/asking.css')
    name = traitlets.Unicode().tag(sync=True)
    """The parameter's."""
    text = traitlets.Unicode().tag(sync=True)
    """What the line begins with."""
    said = traitlets.Unicode().tag(sync=True)
    """Why the node could not be asked; empty if it was."""

    def __init__(self, name: str, text: str, ask: Callable[[Any], None]):
        """:param ask: Asks the node for a value, which has the type that ``ros2 param set`` would give it."""
        super().__init__(name=name, text=text)
        self._ask = ask
        self.on_msg(self._on_message)

    def _on_message(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        try:
            self._ask(values.parse(content['text']))
            self.said = ''
        except ParameterToolError as error:
            self.said = f'{describe_error(error)}.'
