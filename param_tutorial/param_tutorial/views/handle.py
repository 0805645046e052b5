"""What the lines below pictures have in common, from which a reader asks a node without a cell."""

from collections.abc import Callable
from typing import Any

import traitlets

from param_tools.errors import ParameterToolError, describe_error
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front


class Handle(Front):
    """Sends what a reader chooses to the kernel, which asks the node; the picture above shows what came of it."""

    _css = sheet('param_tutorial/views/handle.css')
    said = traitlets.Unicode().tag(sync=True)
    """Why the node could not be asked; empty if it was."""
    told = traitlets.Unicode().tag(sync=True)
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
        self.said = ''
        try:
            self.told = self._answer(content['chosen'])
        except ParameterToolError as error:
            self.said = f'{describe_error(error)}.'
        finally:
            self.answered += 1
