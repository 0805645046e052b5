"""Parameter values as people type them: from text to a value of the parameter's type, and back.

Numbers are edited as text: JavaScript has no 64-bit integers, and no browser's number box knows nan or says what is
wrong with "1,5".
"""

import ast
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import yaml

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.rules import ONE_OF


@dataclass(frozen=True)
class Form:
    """How the values of a type are written into a text box."""

    format: Callable[[Any], str]
    parse: Callable[[str], Any]
    """Raises ValueError."""
    example: str
    """Completes "write it like ..."."""


def _parse_integer(text: str) -> int:
    try:
        return int(text)  # 010 is ten
    except ValueError:
        return int(text, 0)


def _parse_double(text: str) -> float:
    # YAML writes .nan and .inf, Python nan and inf.
    return float(re.sub(r'^([+-]?)\.(?=[a-z])', r'\1', text.strip().lower()))


def _parse_bool(text: str) -> bool:
    return {'true': True, 'false': False}[text.strip().lower()]


def _parse_byte(text: str) -> bytes:
    return bytes([_parse_integer(text)])


def _parse_string(text: str) -> str:
    text = text.strip()
    return yaml.safe_load(text) if text[:1] in ('"', "'") else text


def _quoted(text: str) -> str:
    return yaml.safe_dump(text, default_style='"', width=math.inf, allow_unicode=True).strip()


_PLAIN = re.compile(r'\w([\w ./-]*\w)?')


def _format_string(text: str) -> str:
    return text if _PLAIN.fullmatch(text) else _quoted(text)


def _format_any(value: Any) -> str:
    if isinstance(value, list):
        return '[' + ', '.join(_format_any_item(item) for item in value) + ']'
    if isinstance(value, str) and value.isprintable() and values.same(values.parse(value), value):
        return value
    return _format_any_item(value)


def _format_any_item(value: Any) -> str:
    if isinstance(value, str):
        # Asked inside brackets, where YAML's null is no text.
        plain = _PLAIN.fullmatch(value) and values.same(values.parse(f'[{value}]'), [value])
        return value if plain else _quoted(value)
    return yaml.safe_dump(value).removesuffix('...\n').strip()


def _array(format_item: Callable[[Any], str], parse_item: Callable[[str], Any], example: str) -> Form:
    """Return the form of an array, a YAML flow sequence, from that of its elements."""

    def parse_all(text: str) -> list[Any]:
        text = text.strip()
        inner = text[1:-1] if text.startswith('[') and text.endswith(']') else text
        return [parse_item(item) for item in _split(inner)]

    return Form(lambda items: '[' + ', '.join(map(format_item, items)) + ']', parse_all, example)


def _split(text: str) -> list[str]:
    """Return what stands between the commas outside quotes; a comma at the end is allowed."""
    item = r"""\s*(?:"(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^,'"\[\]{}][^,\[\]{}]*?)\s*"""
    if not text.strip():
        return []
    if not re.fullmatch(f'{item}(?:,{item})*,?\\s*', text, re.DOTALL):
        raise ValueError('the elements are not separated by commas, or a quote or bracket is not closed')
    return [each.strip() for each in re.findall(rf'{item}(?=,|\Z)', text.rstrip().rstrip(','), re.DOTALL)]


_FORMS = {
    values.NOT_SET: Form(_format_any, values.parse, 'a value in YAML'),
    values.BOOL: Form(lambda value: str(value).lower(), _parse_bool, 'true or false'),
    values.INTEGER: Form(str, _parse_integer, 'an integer, e.g. 42'),
    values.DOUBLE: Form(repr, _parse_double, 'a double, e.g. 0.5'),
    values.STRING: Form(str, str, 'text'),
    values.BYTE_ARRAY: _array(lambda byte: f'0x{byte[0]:02x}', _parse_byte, 'bytes, e.g. [0x00, 0xff]'),
    values.BOOL_ARRAY: _array(lambda value: str(value).lower(), _parse_bool, 'booleans, e.g. [true, false]'),
    values.INTEGER_ARRAY: _array(str, _parse_integer, 'integers, e.g. [1, 2, 3]'),
    values.DOUBLE_ARRAY: _array(repr, _parse_double, 'doubles, e.g. [0.5, 1.0]'),
    values.STRING_ARRAY: _array(_format_string, _parse_string, 'strings, e.g. [left, "right, far"]'),
}


def form_of(descriptor: Descriptor) -> Form:
    """Return the form in which people write a parameter: its type's, or YAML where the type is dynamic."""
    # YAML has no word for single bytes: a byte array stays one until it is set to something else elsewhere.
    if descriptor.dynamic_typing and descriptor.type is not values.BYTE_ARRAY:
        return _FORMS[values.NOT_SET]
    return _FORMS[descriptor.type]


def format_value(descriptor: Descriptor, value: Any) -> str:
    """Return a value as a person would type it; an empty text if the parameter is not set.

    :param value: Need not be of the parameter's type: a dynamic parameter, or a node that has been started again, had
        another type before.
    """
    if value is None:
        return ''
    form = form_of(descriptor)
    if form is not _FORMS[values.NOT_SET] and not descriptor.type.accepts(value):
        form = _FORMS[values.type_of(value)]
    return form.format(value)


def parse_value(descriptor: Descriptor, text: str) -> Any:
    """Return the value that a person typed for a parameter.

    :raises ValueError: the text is not a value of the parameter's type; the message says what would be.
    """
    form = form_of(descriptor)
    try:
        return form.parse(text)
    except (ValueError, KeyError, yaml.YAMLError):
        raise ValueError(f'{text!r} cannot be read: {descriptor.name} takes {form.example}') from None


_ITEMS: dict[values.ParameterType, tuple[Callable[[Any], str], Callable[[str], Any]]] = {
    values.BYTE_ARRAY: (lambda byte: f'0x{byte[0]:02x}', _parse_byte),
    values.BOOL_ARRAY: (lambda value: str(value).lower(), _parse_bool),
    values.INTEGER_ARRAY: (str, _parse_integer),
    values.DOUBLE_ARRAY: (repr, _parse_double),
    # In a box of its own, a string needs no quotes.
    values.STRING_ARRAY: (str, str),
}
# With more elements than these, a list of boxes helps nobody.
_MOST_ITEMS = 100


def format_items(descriptor: Descriptor, value: Any) -> list[str] | None:
    """Return the elements of an array as a person would type each into a box of its own.

    :return: None if it is not an array, has very many elements, or one has several lines, which no such box can hold.
    """
    if (descriptor.type not in _ITEMS or descriptor.dynamic_typing or not isinstance(value, list)
            or len(value) > _MOST_ITEMS):
        return None
    texts = [_ITEMS[descriptor.type][0](item) for item in value]
    return None if any(re.search(r'[\n\r]', text) for text in texts) else texts


def parse_items(descriptor: Descriptor, texts: Sequence[str]) -> list[Any]:
    """Return the array whose elements a person typed one by one.

    :raises ValueError: a text is no element of it; the message says which.
    """
    items = []
    for number, text in enumerate(texts, 1):
        try:
            items.append(_ITEMS[descriptor.type][1](text))
        except (ValueError, KeyError):
            raise ValueError(f'element {number}, {text!r}, cannot be read: {descriptor.name} takes '
                             f'{form_of(descriptor).example}') from None
    return items


def fit(descriptor: Descriptor, value: Any) -> Any:
    """Turn a Python value into what a hand would have entered: a double's control has no whole numbers."""
    value = values.normalize(value)
    if not descriptor.dynamic_typing:
        if descriptor.type is values.DOUBLE and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if descriptor.type is values.DOUBLE_ARRAY and isinstance(value, list):
            return [float(item) if type(item) is int else item for item in value]
    return value


def choices_of(descriptor: Descriptor) -> list[Any]:
    """Return the values that ``Rules.one_of`` leaves to a parameter; none if its constraints name no such rule.

    Of a node in another process, the words of a rule are all that one knows of it.
    """
    _, found, rest = descriptor.additional_constraints.partition(ONE_OF.capitalize())
    if not found or descriptor.type.is_array:
        return []
    # Other rules may follow, and a choice may hold what stands between two of them.
    parts = rest.split('; ')
    for end in range(1, len(parts) + 1):
        try:
            choices = ast.literal_eval(f'[{"; ".join(parts[:end])}]')
        except (ValueError, SyntaxError):
            continue
        return list(choices)
    return []
