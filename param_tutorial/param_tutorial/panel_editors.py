"""The controls of a panel: which editor a parameter gets, what it shows and what a hand can do with it.

``EDITORS`` says which editor a type gets; a range adds a slider. All editors have one shape: ``show`` a value
that the node confirmed, ``enable``, and call ``on_hand`` with what a hand entered, as a Python value, or
``on_error`` with the reason why it is no value. Numbers are edited as text: JavaScript has no 64-bit integers,
and no browser's number box knows nan or says what is wrong with "1,5".

Threads. A widget is written to, or hears from the browser, with the panel's lock held; see ``panels``.
"""

import contextlib
import math
import re
import threading
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

import ipywidgets as widgets
import yaml

from param_tutorial import values
from param_tutorial.client import Descriptor, Range

# JavaScript's numbers are exact up to here.
_JS_SAFE = 2**53
# Positions of a slider whose range has no step: enough to feel smooth, few enough to land on round numbers.
_FINE_POSITIONS = 100


@dataclass(frozen=True)
class Form:
    """How the values of a type are written into a text box."""

    write: Callable[[Any], str]
    read: Callable[[str], Any]
    """Raises ValueError."""
    example: str
    """Completes "write it like ..."."""


def _read_integer(text: str) -> int:
    text = text.strip()
    return int(text, 10 if re.fullmatch(r'[+-]?[0-9_]+', text) else 0)


def _read_double(text: str) -> float:
    # YAML writes .nan and .inf, Python nan and inf.
    return float(re.sub(r'^([+-]?)\.(?=[a-z])', r'\1', text.strip().lower()))


def _read_bool(text: str) -> bool:
    return {'true': True, 'false': False}[text.strip().lower()]


def _read_byte(text: str) -> bytes:
    return bytes([_read_integer(text)])


def _read_string(text: str) -> str:
    text = text.strip()
    return yaml.safe_load(text) if text[:1] in ('"', "'") else text


def _quoted(text: str) -> str:
    return yaml.safe_dump(text, default_style='"', width=math.inf, allow_unicode=True).strip()


_PLAIN = re.compile(r'\w([\w ./-]*\w)?')


def _write_string(text: str) -> str:
    return text if _PLAIN.fullmatch(text) else _quoted(text)


def _write_any(value: Any) -> str:
    if isinstance(value, list):
        return '[' + ', '.join(_write_any_item(item) for item in value) + ']'
    if isinstance(value, str) and value.isprintable() and values.same(values.parse(value), value):
        return value
    return _write_any_item(value)


def _write_any_item(value: Any) -> str:
    if isinstance(value, str):
        # Asked inside brackets, where YAML's null is no text.
        plain = _PLAIN.fullmatch(value) and values.same(values.parse(f'[{value}]'), [value])
        return value if plain else _quoted(value)
    return yaml.safe_dump(value).removesuffix('...\n').strip()


def _array(write: Callable[[Any], str], read: Callable[[str], Any], example: str) -> Form:
    """Make the form of an array, a YAML flow sequence, from that of its elements."""

    def read_all(text: str) -> list:
        text = text.strip()
        inner = text[1:-1] if text.startswith('[') and text.endswith(']') else text
        return [read(item) for item in _split(inner)]

    return Form(lambda items: '[' + ', '.join(map(write, items)) + ']', read_all, example)


def _split(text: str) -> list[str]:
    """Split at commas outside quotes; a comma at the end is allowed."""
    item = r"""\s*(?:"(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^,'"\[\]{}][^,\[\]{}]*?)\s*"""
    if not text.strip():
        return []
    if not re.fullmatch(f'{item}(?:,{item})*,?\\s*', text, re.DOTALL):
        raise ValueError('the elements are not separated by commas, or a quote or bracket is not closed')
    return [each.strip() for each in re.findall(rf'{item}(?=,|\Z)', text.rstrip().rstrip(','), re.DOTALL)]


_FORMS = {
    values.NOT_SET: Form(_write_any, values.parse, 'a value in YAML'),
    values.BOOL: Form(lambda value: str(value).lower(), _read_bool, 'true or false'),
    values.INTEGER: Form(str, _read_integer, 'a whole number, e.g. 42'),
    values.DOUBLE: Form(repr, _read_double, 'a number, e.g. 0.5'),
    values.STRING: Form(str, str, 'text'),
    values.BYTE_ARRAY: _array(lambda byte: f'0x{byte[0]:02x}', _read_byte, 'bytes, e.g. [0x00, 0xff]'),
    values.BOOL_ARRAY: _array(lambda value: str(value).lower(), _read_bool, 'booleans, e.g. [true, false]'),
    values.INTEGER_ARRAY: _array(str, _read_integer, 'whole numbers, e.g. [1, 2, 3]'),
    values.DOUBLE_ARRAY: _array(repr, _read_double, 'numbers, e.g. [0.5, 1.0]'),
    values.STRING_ARRAY: _array(_write_string, _read_string, 'texts, e.g. [left, "right, far"]'),
}


def form_of(descriptor: Descriptor, value: Any) -> Form:
    """Give the form in which a parameter is written: its type's, or YAML where any type goes."""
    # YAML has no word for single bytes: a byte array stays one until it is set to something else elsewhere.
    if descriptor.dynamic_typing and descriptor.type is not values.BYTE_ARRAY:
        return _FORMS[values.NOT_SET]
    return _FORMS[descriptor.type]


def written(descriptor: Descriptor, value: Any) -> str:
    """Write a value as its text box shows it; the text is empty if the parameter is not set."""
    return '' if value is None else form_of(descriptor, value).write(value)


def read(descriptor: Descriptor, text: str) -> Any:
    """Read what a hand typed into a parameter's text box.

    :raises ValueError: it is no value of the parameter's type; the message says what would be.
    """
    try:
        return form_of(descriptor, None).read(text)
    except (ValueError, KeyError, yaml.YAMLError):
        raise ValueError(f'{text!r} cannot be read: {descriptor.name} wants '
                         f'{form_of(descriptor, None).example}') from None


def fit(descriptor: Descriptor, value: Any) -> Any:
    """Turn a Python value into what a hand would have entered: a double's control has no whole numbers."""
    value = values.normalise(value)
    if not descriptor.dynamic_typing:
        if descriptor.type is values.DOUBLE and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if descriptor.type is values.DOUBLE_ARRAY and isinstance(value, list):
            return [float(item) if type(item) is int else item for item in value]
    return value


class _FromBrowser:
    """Mixed into a widget: takes a value from the browser before ipywidgets begins to answer it.

    ipywidgets would send an echo and run its notifications first, which takes as long as the node's whole answer.
    """

    def __init__(self, editor: 'Editor', **traits: Any):
        self._editor = editor
        super().__init__(**traits)
        self.observe(self._on_value, 'value')

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Take what the browser sent; called by ipywidgets in the kernel's main thread."""
        if 'value' in sync_data and not self._editor.stands(self, sync_data['value']):
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


class _FloatSlider(_FromBrowser, widgets.FloatSlider):
    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Take what the browser sent, unless it is only the echo of what it was told to draw."""
        # On drawing, the browser counts in steps and sends its 12.500000000000002 back for our 12.5. Nobody has
        # moved anything then, and whoever merely looks at a panel must not set a parameter.
        sent = sync_data.get('value')
        if sent is not None and math.isclose(sent, self.value, rel_tol=1e-12, abs_tol=self.step * 1e-9):
            sync_data = {name: value for name, value in sync_data.items() if name != 'value'}
        super().set_state(sync_data)


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

    def _read(self, widget: widgets.Widget, raw: Any) -> Any:
        """Turn what a widget holds into a Python value, or raise ValueError."""
        raise NotImplementedError

    def _write(self, value: Any) -> None:
        raise NotImplementedError

    def moved(self, widget: widgets.Widget, raw: Any) -> None:
        """Take what a hand, or Python code in its place, put into a widget."""
        try:
            value = self._read(widget, raw)
        except ValueError as error:
            self._on_error(str(error))
        else:
            self._on_hand(value)

    def stands(self, widget: widgets.Widget, raw: Any) -> bool:
        """Did the browser send where a widget stands anyway, without a hand having moved it?"""
        return False

    def show(self, value: Any) -> None:
        """Show a value that the node confirmed."""
        with self.quietly():
            self._write(value)

    def enable(self, enabled: bool) -> None:
        """Let a hand change it, or not."""
        with self.quietly():
            for widget in self.widgets:
                widget.disabled = not enabled

    @contextlib.contextmanager
    def quietly(self):
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

    def _create(self):
        return (_Checkbox(indent=False, **self._common),)

    def _read(self, widget, raw):
        return bool(raw)

    def _write(self, value):
        self.widgets[0].value = value


class TextEditor(Editor):
    """One line of text, taken when Enter is pressed or the box is left."""

    def _create(self):
        return (_Text(continuous_update=False, **self._common),)

    def _read(self, widget, raw):
        return read(self.descriptor, raw)

    def _write(self, value):
        box = self.widgets[0]
        box.placeholder = 'not set' if value is None else ''
        box.value = written(self.descriptor, value)


class LinesEditor(TextEditor):
    """Several lines of text, taken when the box is left: a line of text would lose the breaks."""

    def _create(self):
        return (_Textarea(continuous_update=False, rows=3, **self._common),)


class IntegerSliderEditor(TextEditor):
    """A number box, and a slider beside it."""

    def _create(self):
        limits = self.descriptor.range
        return (*super()._create(), self._slider(limits.from_value, limits.to_value, max(1, limits.step)))

    def _slider(self, first, last, step):
        return _IntSlider(editor=self, min=first, max=last, value=first, step=step, readout=False,
                          tooltip=self.descriptor.name)

    def _read(self, widget, raw):
        return super()._read(widget, raw) if widget is self.widgets[0] else self._value(raw)

    def _value(self, position):
        return position

    def _position(self, value):
        limits = self.descriptor.range
        return min(max(value, limits.from_value), limits.to_value)

    def stands(self, widget, raw):
        """A slider may report its position when it is drawn."""
        return widget is self.widgets[1] and raw == widget.value

    def _write(self, value):
        super()._write(value)
        if value is not None and math.isfinite(value):
            self.widgets[1].value = self._position(value)


class DoubleSliderEditor(IntegerSliderEditor):
    """A number box, which holds the exact value, and a slider beside it, which counts steps.

    A slider of doubles stands at 0.49999999999999994 when it is told 0.5, and reports that as if a hand had moved
    it. If the hand has meanwhile gone on, the report undoes what it did last. Whole numbers have no such noise.
    """

    def _create(self):
        self._positions = Positions(self.descriptor.range)
        return (*TextEditor._create(self), self._slider(0, self._positions.last, 1))

    def _value(self, position):
        return self._positions.value(position)

    def _position(self, value):
        return self._positions.nearest(value)


class Positions:
    """The values at which a slider of doubles can stand, counted from 0, free of the noise of binary fractions."""

    def __init__(self, limits: Range):
        self._limits = limits
        self._low, self._high = Decimal(str(limits.from_value)), Decimal(str(limits.to_value))
        # Without a step in the range, one that gives round numbers.
        self._step = Decimal(str(limits.step)) if limits.step > 0 else Decimal(1).scaleb(
            math.floor(math.log10((limits.to_value - limits.from_value) / _FINE_POSITIONS)))
        self.last = math.ceil((self._high - self._low) / self._step)

    def value(self, position: int) -> float:
        """Give the value at a position. Both ends are valid even off the step, as the node sees it too."""
        if position >= self.last:
            return self._limits.to_value
        return float(self._low + position * self._step)

    def nearest(self, value: float) -> int:
        """Give the position next to a value."""
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
    """Can a browser's slider express this range? It cannot stand still, be endless, or count beyond 2**53."""
    if not (limits.from_value < limits.to_value and math.isfinite(limits.to_value - limits.from_value)):
        return False
    if isinstance(limits.from_value, int):
        return max(abs(limits.from_value), abs(limits.to_value)) <= _JS_SAFE
    return not limits.step > 0 or (limits.to_value - limits.from_value) / limits.step <= _JS_SAFE
