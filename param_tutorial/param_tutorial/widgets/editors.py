"""The controls of a panel: which editor a parameter gets, what it shows and what a hand can do with it.

``EDITORS`` says which editor a type gets; a range adds a slider. All editors have one shape: ``show`` a value
that the node confirmed, ``enable``, and call ``on_hand`` with what a hand entered, as a Python value, or
``on_error`` with the reason why it is no value. ``parameters.text`` formats and parses what is typed.

Threads. A widget is written to, or hears from the browser, with the panel's lock held; see ``panel``.
"""

import contextlib
import math
import re
import threading
from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import Any

import ipywidgets as widgets

from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor, Range
from param_tutorial.parameters.text import format_value, parse_value

# JavaScript's numbers are exact up to here.
_JS_SAFE = 2**53
# Positions of a slider whose range has no step: enough to feel smooth, few enough to land on round numbers.
_FINE_POSITIONS = 100


class _FromBrowser(widgets.ValueWidget):
    """Mixed into a widget: takes a value from the browser before ipywidgets begins to answer it.

    ipywidgets would send an echo and run its notifications first, which takes as long as the node's whole answer.
    """

    def __init__(self, editor: 'Editor', **traits: Any):
        self._editor = editor
        super().__init__(**traits)
        self.observe(self._on_value, 'value')

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Take what the browser sent; called by ipywidgets in the kernel's main thread."""
        if 'value' in sync_data and not self._editor.is_echo(self, sync_data['value']):
            self._editor.moved(self, sync_data['value'])
            self._editor.give_way()
        with self._editor.quietly():
            super().set_state(sync_data)

    def _on_value(self, change: dict[str, Any]) -> None:
        # Somebody's Python code, since neither the browser nor the panel gets here.
        with self._editor.lock:
            by_panel = self._editor.quiet
        if not by_panel:
            self._editor.moved(self, change['new'])


class _Text(_FromBrowser, widgets.Text):
    pass


class _Textarea(_FromBrowser, widgets.Textarea):
    pass


class _Checkbox(_FromBrowser, widgets.Checkbox):
    pass


class _IntSlider(_FromBrowser, widgets.IntSlider):
    pass


class Editor:
    """The control, or controls, of one parameter."""

    def __init__(self, descriptor: Descriptor, label: str, lock: threading.RLock,
                 on_hand: Callable[[Any], None], on_error: Callable[[str], None], give_way: Callable[[], None]):
        """
        :param label: The name as the panel shows it.
        :param lock: Held while a widget is written to.
        :param on_hand: Takes what a hand entered.
        :param on_error: Takes the reason why what a hand entered is no value.
        :param give_way: Called when the request is out and what remains to be done is less urgent.
        """
        self.descriptor = descriptor
        self.label = label
        self.quiet = False
        self.lock = lock
        self._on_hand = on_hand
        self._on_error = on_error
        self.give_way = give_way
        self.widgets = self._create()

    def _create(self) -> tuple[widgets.Widget, ...]:
        raise NotImplementedError

    def _parse(self, widget: widgets.Widget, raw: Any) -> Any:
        """Return what a widget holds as a Python value.

        :raises ValueError: it is no value of the parameter's type.
        """
        raise NotImplementedError

    def _display(self, value: Any) -> None:
        """Put a value into the widgets."""
        raise NotImplementedError

    def moved(self, widget: widgets.Widget, raw: Any) -> None:
        """Take what a hand, or Python code in its place, put into a widget."""
        try:
            value = self._parse(widget, raw)
        except ValueError as error:
            self._on_error(str(error))
        else:
            self._on_hand(value)

    def is_echo(self, widget: widgets.Widget, raw: Any) -> bool:
        """True if the browser sent the value that a widget has anyway, without a hand having moved it."""
        return False

    def show(self, value: Any) -> None:
        """Show a value that the node confirmed."""
        with self.quietly():
            self._display(value)

    def enable(self, enabled: bool) -> None:
        """Let a hand change it, or not."""
        with self.quietly():
            for widget in self.widgets:
                widget.disabled = not enabled

    @contextlib.contextmanager
    def quietly(self) -> Iterator[None]:
        """Write to widgets without taking that for a hand."""
        with self.lock:
            before, self.quiet = self.quiet, True
            try:
                yield
            finally:
                self.quiet = before

    @property
    def _common(self) -> dict[str, Any]:
        help_text = '\n'.join(filter(None, (self.descriptor.description, self.descriptor.additional_constraints)))
        return {'editor': self, 'description': self.label, 'tooltip': help_text or self.descriptor.name,
                'description_allow_html': False}


class CheckBoxEditor(Editor):
    """A check box."""

    def _create(self) -> tuple[widgets.Widget, ...]:
        return (_Checkbox(indent=False, **self._common),)

    def _parse(self, widget: widgets.Widget, raw: Any) -> bool:
        return bool(raw)

    def _display(self, value: bool) -> None:
        self.widgets[0].value = value


class TextEditor(Editor):
    """One line of text, taken when Enter is pressed or the box is left."""

    def _create(self) -> tuple[widgets.Widget, ...]:
        return (_Text(continuous_update=False, **self._common),)

    def _parse(self, widget: widgets.Widget, raw: Any) -> Any:
        return parse_value(self.descriptor, raw)

    def _display(self, value: Any) -> None:
        box = self.widgets[0]
        box.placeholder = 'not set' if value is None else ''
        box.value = format_value(self.descriptor, value)


class LinesEditor(TextEditor):
    """Several lines of text, taken when the box is left: a line of text would lose the breaks."""

    def _create(self) -> tuple[widgets.Widget, ...]:
        return (_Textarea(continuous_update=False, rows=3, **self._common),)


class IntegerSliderEditor(TextEditor):
    """A number box, and a slider beside it."""

    def _create(self) -> tuple[widgets.Widget, ...]:
        return (*super()._create(), self._slider(*whole_positions(range_of(self.descriptor))))

    def _slider(self, first: int, last: int, step: int) -> _IntSlider:
        return _IntSlider(editor=self, min=first, max=last, value=first, step=step, readout=False,
                          tooltip=self.descriptor.name)

    def _parse(self, widget: widgets.Widget, raw: Any) -> Any:
        return super()._parse(widget, raw) if widget is self.widgets[0] else self._value(raw)

    def _value(self, position: int) -> float:
        return position

    def _position(self, value: Any) -> int:
        first, last, _ = whole_positions(range_of(self.descriptor))
        return min(max(int(value), first), last)

    def is_echo(self, widget: widgets.Widget, raw: Any) -> bool:
        """True if a slider reports the position at which it is drawn."""
        return widget is self.widgets[1] and raw == widget.value

    def _display(self, value: Any) -> None:
        super()._display(value)
        if value is not None and math.isfinite(value):
            self.widgets[1].value = self._position(value)


class DoubleSliderEditor(IntegerSliderEditor):
    """A number box, which holds the exact value, and a slider beside it, which counts steps.

    A slider of doubles stands at 0.49999999999999994 when it is told 0.5, and reports that as if a hand had moved
    it. If the hand has meanwhile gone on, the report undoes what it did last. Whole numbers have no such noise.
    """

    def _create(self) -> tuple[widgets.Widget, ...]:
        self._positions = Positions(range_of(self.descriptor))
        return (*TextEditor._create(self), self._slider(0, self._positions.last, 1))

    def _value(self, position: int) -> float:
        return self._positions.value(position)

    def _position(self, value: float) -> int:
        return self._positions.nearest(value)


def range_of(descriptor: Descriptor) -> Range:
    """Return the range of a parameter that has a slider, which no other parameter gets."""
    assert descriptor.range is not None, f'{descriptor.name} has no range'
    return descriptor.range


def whole_positions(limits: Range) -> tuple[int, int, int]:
    """Return the first and the last position of a slider of integers, and the step between positions."""
    first, last = int(limits.from_value), int(limits.to_value)
    # A step that is wider than the range leaves its two ends; and it may be more than the browser can count.
    return first, last, min(max(1, int(limits.step)), last - first)


class Positions:
    """The values at which a slider of doubles can stand, counted from 0, free of the noise of binary fractions."""

    def __init__(self, limits: Range):
        self._limits = limits
        self._low, self._high = Decimal(str(limits.from_value)), Decimal(str(limits.to_value))
        # Without a step in the range, one that gives round numbers. The hundredth part of the smallest double is 0.0,
        # but not that of the smallest Decimal.
        self._step = Decimal(str(limits.step)) if limits.step > 0 else Decimal(1).scaleb(
            ((self._high - self._low) / _FINE_POSITIONS).adjusted())
        self.last = math.ceil((self._high - self._low) / self._step)

    def value(self, position: int) -> float:
        """Return the value at a position. Both ends are valid even off the step, as the node sees it too."""
        if position >= self.last:
            return self._limits.to_value
        return float(self._low + position * self._step)

    def nearest(self, value: float) -> int:
        """Return the position next to a value."""
        position = math.floor((Decimal(str(value)) - self._low) / self._step)
        return min(range(max(0, position), min(self.last, position + 1) + 1),
                   key=lambda each: abs(self.value(each) - value), default=0 if position < 0 else self.last)


EDITORS: dict[values.ParameterType, type[Editor]] = {
    values.NOT_SET: TextEditor,
    values.BOOL: CheckBoxEditor,
    values.INTEGER: TextEditor,
    values.DOUBLE: TextEditor,
    values.STRING: TextEditor,
    values.BYTE_ARRAY: TextEditor,
    values.BOOL_ARRAY: TextEditor,
    values.INTEGER_ARRAY: TextEditor,
    values.DOUBLE_ARRAY: TextEditor,
    values.STRING_ARRAY: TextEditor,
}
SLIDERS: dict[values.ParameterType, type[Editor]] = {
    values.INTEGER: IntegerSliderEditor,
    values.DOUBLE: DoubleSliderEditor,
}


def editor_class(descriptor: Descriptor, value: Any) -> type[Editor]:
    """Choose the editor that fits a parameter and the value that it has now."""
    if isinstance(value, str) and re.search(r'[\n\r]', value) and not descriptor.dynamic_typing:
        return LinesEditor
    if descriptor.dynamic_typing or value is None:
        return TextEditor
    if descriptor.range is not None and _fits_slider(descriptor.range):
        return SLIDERS[descriptor.type]
    return EDITORS[descriptor.type]


def _fits_slider(limits: Range) -> bool:
    """True if a browser's slider can express this range: it cannot stand still, be endless, or count beyond 2**53."""
    if not (limits.from_value < limits.to_value and math.isfinite(limits.to_value - limits.from_value)):
        return False
    if isinstance(limits.from_value, int):
        return max(abs(limits.from_value), abs(limits.to_value)) <= _JS_SAFE
    return not limits.step > 0 or (math.isfinite(limits.step)
                                   and (limits.to_value - limits.from_value) / limits.step <= _JS_SAFE)
