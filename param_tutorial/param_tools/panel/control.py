"""One parameter on a panel: its value, what stands beside it, and what a person can do with it."""

import math
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.live import LiveParameters
from param_tools.node.live_state import ParameterState
from param_tools.node.locks import Condition, conditions_of, unmet
from param_tools.node.text import choices_in_prose, fit, format_items, format_value, parse_items, parse_value
from param_tools.panel.drawing import PanelRow, RowState
from param_tools.panel.editors import Scale, row_of, scale_of

_WAITING = 'Waiting for the node to answer…'


class Control:
    """One parameter on a panel: ``panel['max_speed_rpm']``."""

    def __init__(self, live: LiveParameters, parameter: ParameterState, take: Callable[..., None]):
        """
        :param parameter: What it shows, one of ``live``.
        :param take: ``ParameterPanel._take``, called with the control and a value that somebody wants.
        """
        self._live, self.parameter = live, parameter
        self._take = take
        self.first = parameter.value
        """What it had when its node was added to the stage, or for any other node, when the panel first saw it."""
        self._shape: Any = None
        self._row: PanelRow
        self._scale: Scale | None = None
        self._conditions: list[Condition] = []

    def __repr__(self) -> str:
        return f'<Control: {self.name} = {self.value!r}>'

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self.parameter.name

    @property
    def value(self) -> Any:
        """The value that the node confirmed last. Assigning to it asks the node for another one.

        If ``ParameterPanel.gather`` was called, the new value is gathered; if a person pressed *Gather*, what the code
        assigns is sent nevertheless.
        """
        return self.parameter.value

    @value.setter
    def value(self, value: Any) -> None:
        self._take(self, fit(self.descriptor, value), is_code=True)

    @property
    def message(self) -> str:
        """Why the node rejected the last change, in the node's words; empty if it did not."""
        return self.parameter.message

    @property
    def descriptor(self) -> Descriptor:
        """What the node says about the parameter."""
        return self.parameter.descriptor

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

    def enter(self, typed: str | Sequence[str]) -> None:
        """Type a text into the control, or the elements of an array into a box each, and press Enter.

        For a check box, the texts are 'true' and 'false'.
        """
        try:
            value = parse_value(self.descriptor, typed) if isinstance(typed, str) else parse_items(
                self.descriptor, typed)
        except ValueError as error:
            self._live.reject(self.parameter, str(error))
        else:
            self._take(self, value)

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
        parameter, descriptor = self.parameter, self.descriptor
        value, text = parameter.value, format_value(parameter.descriptor, parameter.value)
        if gathered is not ...:
            wanted = format_value(descriptor, gathered)
            return RowState(wanted, self._position(gathered), is_locked, is_gathered=True,
                            items=format_items(descriptor, gathered),
                            message=('gathering', f'Now {text}; not sent yet.'))
        message: tuple[str, str] | None = None
        if parameter.is_late(time.monotonic()):
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
        """True if it can be brought back to another value, its first one."""
        return not (self.descriptor.read_only or self.first is None or values.same(self.first, self.value))

    def _position(self, value: Any) -> int | None:
        scale = self.scale
        return scale.nearest(value) if scale is not None and math.isfinite(value) else None

    def _look(self) -> None:
        """Work out editor and scale anew where the node describes the parameter in another way."""
        descriptor, value = self.descriptor, self.value
        shape = (descriptor, value is None, isinstance(value, str) and ('\n' in value or '\r' in value),
                 choices_in_prose(descriptor, value))
        if shape != self._shape:
            self._shape = shape
            self._scale = scale_of(descriptor, value)
            self._row = row_of(descriptor, value, self._scale)
            self._conditions = conditions_of(descriptor)
