"""One parameter on a panel: its editor, its value, what stands beside it, and what a person can do with it.

``node.text`` formats and parses what is typed; ``drawing`` draws the controls.
"""

import math
import re
import time
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor, Range, is_housekeeping
from param_tools.node.live import LiveParameters
from param_tools.node.live_state import ParameterState
from param_tools.node.text import fit, format_value, parse_value

CHECK, TEXT, LINES = 'check', 'text', 'lines'

_WAITING = 'Waiting for the node to answer…'
# JavaScript's numbers are exact up to here.
_JS_SAFE = 2**53
# Positions of a slider whose range has no step: enough to feel smooth, few enough to land on round numbers.
_POSITIONS = 100
# A range whose ends are further apart than this factor has a logarithmic slider.
_FOUR_DECADES = 10**4
_DECADE = [Decimal(f'{10 ** (index / 20):.1f}') for index in range(20)]


@dataclass(frozen=True)
class PanelRow:
    """One parameter of a panel, but for what changes with its value."""

    name: str
    editor: str
    """CHECK for a check box, TEXT for one line, LINES for several."""
    kind: str
    """The name of its type, e.g. ``'double'``."""
    description: str = ''
    constraints: str = ''
    facts: tuple[str, ...] = ()
    """What its descriptor says beside the type, e.g. its range."""
    scale: 'Scale | None' = None
    """Where its slider can stand; None if it has none."""
    is_read_only: bool = False
    is_unset: bool = False
    is_quiet: bool = False
    """True for what every node has."""

    @property
    def is_number(self) -> bool:
        """True if a short box is wide enough for it."""
        return self.kind in ('integer', 'double')


@dataclass
class RowState:
    """What a panel shows of a parameter's value."""

    text: str
    position: float | None = None
    """Where its slider stands."""
    is_locked: bool = False
    is_busy: bool = False
    """True while the node has been asked for another value; the control shows what was entered until then."""
    message: tuple[str, str] | None = None
    """What to say beside the control: 'rejected', 'failed', 'waiting' or 'adjusted', and the words."""
    is_changed: bool = False
    """True if it had another value at first, or none."""
    first: str | None = None
    """What it can be brought back to, if it is changed and had a value at first."""

    def as_json(self) -> dict[str, Any]:
        """Return it as the script takes it: with what is other than usual."""
        usual = vars(RowState(self.text))
        return {'text': self.text} | {name: value for name, value in vars(self).items() if value != usual[name]}


class Scale:
    """The values at which a slider can stand, counted from 0; doubles are free of the noise of binary fractions.

    Where the range has no step of its own, a slider also stands at tenths of a position.
    """

    def __init__(self, limits: Range):
        self._limits, self._number = limits, type(limits.from_value)
        self._low, self._high = Decimal(str(limits.from_value)), Decimal(str(limits.to_value))
        width = self._high - self._low
        self.is_fine = self._number is float and not limits.step > 0
        if limits.step > 0:
            self._step = Decimal(str(limits.step))
        else:
            # Of doubles, one that gives round numbers. The hundredth part of the smallest double is 0.0, but not that
            # of the smallest Decimal.
            self._step = Decimal(1).scaleb((width / _POSITIONS).adjusted()) if self.is_fine else Decimal(1)
        self.is_logarithmic = self._low > 0 and self._high > _FOUR_DECADES * self._low
        self._stops = self._logarithmic_stops() if self.is_logarithmic else []
        self.last = len(self._stops) - 1 if self._stops else math.ceil(width / self._step)

    def _logarithmic_stops(self) -> list[Decimal]:
        """Return both ends and at most twenty round numbers for each decade."""
        stops = [each.scaleb(decade) for decade in range(self._low.adjusted(), self._high.adjusted() + 1)
                 for each in _DECADE]
        if not self.is_fine:
            stops = [self._low + round((each - self._low) / self._step) * self._step for each in stops]
        return sorted({self._low, *(each for each in stops if self._low < each < self._high), self._high})

    def _stop(self, index: int) -> Decimal:
        return self._stops[index] if self._stops else self._low + index * self._step

    def value(self, position: float) -> Any:
        """Return the value at a position. Both ends are valid even off the step, as the node sees it too."""
        if position >= self.last:
            return self._limits.to_value
        index, tenths = divmod(Decimal(str(position)), 1)
        stop = self._stop(int(index))
        if tenths:
            stop = min(self._high, stop + tenths * (self._stop(int(index) + 1) - stop))
        return self._number(stop)

    def nearest(self, value: float) -> float:
        """Return the position next to a value, which may be out of the range."""
        exact = min(max(self._low, Decimal(str(value))), self._high)
        index = (min(bisect_right(self._stops, exact), self.last) - 1 if self._stops
                 else math.floor((exact - self._low) / self._step))
        low = self._stop(index)
        parts = 10 if self.is_fine else 1
        below = index * parts + math.floor((exact - low) * parts / (self._stop(index + 1) - low))
        position = min((min(each, self.last * parts) / parts for each in (below, below + 1)),
                       key=lambda each: abs(self.value(each) - value))
        return int(position) if position == int(position) else position


class Control:
    """One parameter on a panel: ``panel['max_speed_rpm']``."""

    def __init__(self, live: LiveParameters, parameter: ParameterState, ask: Callable[['Control', Any, object], None]):
        """
        :param parameter: What it shows, one of ``live``.
        :param ask: Called with the control, a value that a person entered or code assigns, and the grip of ``slide``.
        """
        self._live, self.parameter, self._ask = live, parameter, ask
        self.first = parameter.value
        """What it had when its node was added to the stage, or for any other node, when the panel first saw it."""
        self._shape: Any = None
        self._row: PanelRow
        self._scale: Scale | None = None

    def __repr__(self) -> str:
        return f'<Control: {self.name} = {self.value!r}>'

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self.parameter.name

    @property
    def value(self) -> Any:
        """The value that the node confirmed last.

        Assigning to it asks the node for another one.
        """
        return self.parameter.value

    @value.setter
    def value(self, value: Any) -> None:
        self._ask(self, fit(self.descriptor, value), None)

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
        self._fit_to_descriptor()
        return self._row

    @property
    def scale(self) -> Scale | None:
        """Where its slider can stand; None if it has none."""
        self._fit_to_descriptor()
        return self._scale

    def enter(self, text: str) -> None:
        """Type a text into the control and press Enter. For a check box, the texts are 'true' and 'false'."""
        try:
            value = parse_value(self.descriptor, text)
        except ValueError as error:
            self._live.reject(self.parameter, str(error))
        else:
            self._ask(self, value, None)

    def slide(self, position: float, grip: object = None) -> None:
        """Pull the slider to a position.

        :param position: Counted from 0; a tenth of one if the slider stands at those.
        :param grip: Says which pull it belongs to: what is done in one pull is undone at once.
        """
        if self.scale is not None:
            self._ask(self, self.scale.value(min(max(0, position), self.scale.last)), grip)

    def state(self, *, is_locked: bool) -> RowState:
        """Return what the panel shows of the parameter's value.

        :param is_locked: True if nothing can be changed now.
        """
        self._fit_to_descriptor()
        parameter, descriptor, value = self.parameter, self.descriptor, self.value
        text = format_value(descriptor, value)
        message: tuple[str, str] | None = None
        if parameter.is_late(time.monotonic()):
            message = 'waiting', _WAITING
        elif parameter.message:
            message = 'failed' if parameter.is_unanswered else 'rejected', parameter.message
        elif parameter.adjusted is not ...:
            asked = format_value(descriptor, parameter.adjusted)
            message = 'adjusted', f'You asked for {asked}, and the node has stored {text}.'
        scale = self._scale
        position = scale.nearest(value) if scale is not None and math.isfinite(value) else None
        is_changed = self.is_changed
        first = format_value(descriptor, self.first) if is_changed and self.first is not None else None
        return RowState(text, position, is_locked or descriptor.read_only, parameter.busy, message, is_changed, first)

    @property
    def is_changed(self) -> bool:
        """True if it can be set, and had another value at first, or none."""
        return not (self.descriptor.read_only or values.same(self.first, self.value))

    def _fit_to_descriptor(self) -> None:
        """Choose editor and scale anew if the node describes the parameter in another way."""
        descriptor, value = self.descriptor, self.value
        shape = descriptor, value is None, _has_lines(value)
        if shape != self._shape:
            self._shape = shape
            self._scale = scale_of(descriptor, value)
            self._row = row_of(descriptor, value, self._scale)


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
    if descriptor.dynamic_typing or value is None:
        editor = TEXT
    elif _has_lines(value):
        editor = LINES
    elif descriptor.type is values.BOOL:
        editor = CHECK
    else:
        editor = TEXT
    return PanelRow(
        name=descriptor.name, editor=editor, kind=descriptor.type.label, description=descriptor.description,
        constraints=descriptor.additional_constraints, facts=tuple(facts),
        scale=scale, is_read_only=descriptor.read_only,
        is_unset=value is None, is_quiet=is_housekeeping(descriptor.name))


def _has_lines(value: Any) -> bool:
    return isinstance(value, str) and bool(re.search(r'[\n\r]', value))


def _fits_slider(limits: Range) -> bool:
    """True if a browser's slider can express this range: it cannot stand still, be endless, or count beyond 2**53."""
    if not (limits.from_value < limits.to_value and math.isfinite(limits.to_value - limits.from_value)):
        return False
    if isinstance(limits.from_value, int):
        return max(abs(limits.from_value), abs(limits.to_value)) <= _JS_SAFE
    return not limits.step > 0 or (math.isfinite(limits.step)
                                   and (limits.to_value - limits.from_value) / limits.step <= _JS_SAFE)
