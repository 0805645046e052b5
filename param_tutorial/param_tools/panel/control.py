"""One parameter on a panel: its value, what stands beside it, and what a person can do with it."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.live import LiveParameter
from param_tools.node.locks import Condition, conditions_of, unmet
from param_tools.node.text import fit, format_items, format_value, parse_items, parse_value
from param_tools.panel.drawing import PanelRow, RowState
from param_tools.panel.editors import row_of, scale_of
from param_tools.panel.recordable import Scale

_WAITING = 'Waiting for the node to answer…'


class Control:
    """One parameter on a panel: ``panel['max_speed_rpm']``."""

    def __init__(self, parameter: LiveParameter, take: 'Callable[[Control, Any, object], None]',
                 assign: 'Callable[[Control, Any], None]'):
        """
        :param take: Called with the control, a value that a person wants, and the grip: see ``slide``.
        :param assign: Called with the control and a value that code wants.
        """
        self._parameter = parameter
        self._take, self._assign = take, assign
        self.first = parameter.value
        """What it had when the panel first saw it."""
        self._shape: Any = None
        self._row: PanelRow
        self._scale: Scale | None = None
        self._conditions: list[Condition] = []

    def __repr__(self) -> str:
        return f'<Control: {self.name} = {self.value!r}>'

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self._parameter.name

    @property
    def value(self) -> Any:
        """The value that the node confirmed last. Assigning to it asks the node for another one.

        If ``ParameterPanel.gather`` was called, the new value is gathered; if a person pressed *Gather*, what the code
        assigns is sent nevertheless.
        """
        return self._parameter.value

    @value.setter
    def value(self, value: Any) -> None:
        self._assign(self, fit(self._parameter.descriptor, value))

    @property
    def message(self) -> str:
        """Why the node rejected the last change, in the node's words; empty if it did not."""
        return self._parameter.message

    @property
    def descriptor(self) -> Descriptor:
        """What the node says about the parameter."""
        return self._parameter.descriptor

    @property
    def row(self) -> PanelRow:
        """What the panel says of the parameter, but for its value."""
        self._look()
        return self._row

    @property
    def scale(self) -> Scale | None:
        """Where its slider can stand; None if it has none."""
        self._look()
        return self._scale

    def enter(self, text: str) -> None:
        """Type a text into the control, and press Enter. For a check box, the texts are 'true' and 'false'."""
        try:
            value = parse_value(self.descriptor, text)
        except ValueError as error:
            self._parameter.reject(str(error))
        else:
            self._take(self, value, None)

    def enter_items(self, texts: Sequence[str]) -> None:
        """Type the elements of an array, each into a box of its own."""
        try:
            value = parse_items(self.descriptor, texts)
        except ValueError as error:
            self._parameter.reject(str(error))
        else:
            self._take(self, value, None)

    def slide(self, position: int, grip: object = None) -> None:
        """Pull the slider to a position.

        :param position: Counted from 0.
        :param grip: Says which pull it belongs to: what is done in one pull is undone at once.
        """
        if self.scale is not None:
            self._take(self, self.scale.value(min(max(0, position), self.scale.last)), grip)

    def state(self, *, is_locked: bool, known: Mapping[str, Any] | None = None, gathered: Any = ...) -> RowState:
        """Return what the panel shows of the parameter's value.

        :param is_locked: True if nothing can be changed now.
        :param known: The values of the node's parameters, by name: the parameter may depend on one of them.
        :param gathered: The value that is wanted together with other changes; ``...`` for none.
        """
        self._look()
        parameter, descriptor = self._parameter, self.descriptor
        value, text = parameter.value, format_value(parameter.descriptor, parameter.value)
        if gathered is not ...:
            wanted = format_value(descriptor, gathered)
            return RowState(wanted, self._position(gathered), is_locked, is_gathered=True,
                            items=format_items(descriptor, gathered),
                            message=('gathering', f'Now {text}; not sent yet.'))
        message: tuple[str, str] | None = None
        if parameter.late:
            message = 'waiting', _WAITING
        elif parameter.message:
            message = 'failed' if parameter.is_unanswered else 'rejected', parameter.message
        elif parameter.adjusted is not ...:
            asked = format_value(descriptor, parameter.adjusted)
            message = 'adjusted', f'You asked for {asked}, and the node has stored {text}.'
        if lock := unmet(self._conditions, known or {}):
            is_locked, message = True, message or ('locked', lock)
        first = format_value(descriptor, self.first) if self.is_changed else None
        return RowState(text, self._position(value), is_locked or descriptor.read_only, parameter.busy, message, first,
                        items=None if descriptor.read_only else format_items(descriptor, value))

    @property
    def is_changed(self) -> bool:
        """True if it can be brought back to another value, which it had when the panel first saw it."""
        return not (self.descriptor.read_only or self.first is None or values.same(self.first, self.value))

    def ask(self, value: Any) -> None:
        """Ask the node for a value, whatever becomes of it."""
        self._parameter.ask(value)

    def _position(self, value: Any) -> int | None:
        scale = self.scale
        return scale.nearest(value) if scale is not None and math.isfinite(value) else None

    def _look(self) -> None:
        """Work out editor and scale anew where the node describes the parameter in another way."""
        descriptor, value = self.descriptor, self.value
        shape = descriptor, value is None, isinstance(value, str) and ('\n' in value or '\r' in value)
        if shape != self._shape:
            self._shape = shape
            self._scale = scale_of(descriptor, value)
            self._row = row_of(descriptor, value, self._scale)
            self._conditions = conditions_of(descriptor)

    @property
    def parameter(self) -> LiveParameter:
        """The parameter that it shows."""
        return self._parameter
