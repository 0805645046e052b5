"""The controls of a panel: which editor a parameter gets, and the values at which its slider can stand.

``node.text`` formats and parses what is typed; ``drawing`` draws the controls.
"""

import math
import re
from decimal import Decimal
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor, Range, is_housekeeping
from param_tools.node.text import choices_in_prose, choices_of, format_value
from param_tools.node.units import unit_of
from param_tools.panel.drawing import CHECK, CHOICE, LINES, TEXT, PanelRow

# JavaScript's numbers are exact up to here.
_JS_SAFE = 2**53
# Positions of a slider whose range has no step: enough to feel smooth, few enough to land on round numbers.
_FINE_POSITIONS = 100


class Scale:
    """The values at which a slider can stand, counted from 0; doubles are free of the noise of binary fractions."""

    def __init__(self, limits: Range):
        self._limits, self._number = limits, type(limits.from_value)
        self._low = Decimal(str(limits.from_value))
        width = Decimal(str(limits.to_value)) - self._low
        if limits.step > 0:
            self._step = Decimal(str(limits.step))
        else:
            # Of doubles, one that gives round numbers. The hundredth part of the smallest double is 0.0, but not that
            # of the smallest Decimal.
            self._step = Decimal(1) if self._number is int else Decimal(1).scaleb((width / _FINE_POSITIONS).adjusted())
        self.last = math.ceil(width / self._step)

    def value(self, position: int) -> Any:
        """Return the value at a position. Both ends are valid even off the step, as the node sees it too."""
        return self._limits.to_value if position >= self.last else self._number(self._low + position * self._step)

    def nearest(self, value: float) -> int:
        """Return the position next to a value, which may be out of the range."""
        below = math.floor((Decimal(str(value)) - self._low) / self._step)
        return min((min(max(0, each), self.last) for each in (below, below + 1)),
                   key=lambda each: abs(self.value(each) - value))


def scale_of(descriptor: Descriptor, value: Any) -> Scale | None:
    """Return where the slider of a parameter can stand; None if the parameter has no slider."""
    if descriptor.dynamic_typing or value is None or descriptor.range is None or not _fits_slider(descriptor.range):
        return None
    return Scale(descriptor.range)


def row_of(descriptor: Descriptor, value: Any, scale: Scale | None) -> PanelRow:
    """Return what a panel's row says of a parameter, but for its value.

    :param value: What the parameter has, which decides about its editor.
    """
    facts = []
    if descriptor.range:
        facts.append(f'{descriptor.range.from_value} to {descriptor.range.to_value}'
                     + (f' in steps of {descriptor.range.step}' if descriptor.range.step else ''))
    facts += ['any type'] * descriptor.dynamic_typing
    choices = tuple(format_value(descriptor, each) for each in choices_of(descriptor))
    suggested = () if choices else choices_in_prose(descriptor, value)
    choices = choices or suggested
    return PanelRow(
        name=descriptor.name, editor=_editor_of(descriptor, value, choices), kind=descriptor.type.label,
        description=descriptor.description, constraints=descriptor.additional_constraints, facts=tuple(facts),
        choices=choices, takes_others=bool(suggested), last=scale.last if scale else None,
        is_read_only=descriptor.read_only, is_quiet=is_housekeeping(descriptor.name), unit=unit_of(descriptor))


def _editor_of(descriptor: Descriptor, value: Any, choices: tuple[str, ...]) -> str:
    if descriptor.dynamic_typing or value is None:
        return TEXT
    if isinstance(value, str) and re.search(r'[\n\r]', value):
        return LINES
    if descriptor.type is values.BOOL:
        return CHECK
    return CHOICE if choices else TEXT


def _fits_slider(limits: Range) -> bool:
    """True if a browser's slider can express this range: it cannot stand still, be endless, or count beyond 2**53."""
    if not (limits.from_value < limits.to_value and math.isfinite(limits.to_value - limits.from_value)):
        return False
    if isinstance(limits.from_value, int):
        return max(abs(limits.from_value), abs(limits.to_value)) <= _JS_SAFE
    return not limits.step > 0 or (math.isfinite(limits.step)
                                   and (limits.to_value - limits.from_value) / limits.step <= _JS_SAFE)
