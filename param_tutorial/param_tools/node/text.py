"""Parameter values as people type them: from text to a value of the parameter's type, and back.

Numbers are edited as text: JavaScript has no 64-bit integers, and no browser's number box knows nan or says what is
wrong with "1,5".
"""

import functools
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import yaml

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.rules import ONE_OF, read_values


@dataclass(frozen=True)
class Form:
    """How people write the values of a type."""

    format: Callable[[Any], str]
    parse: Callable[[str], Any]
    """Raises ValueError or KeyError for a text that is no such value."""
    example: str
    """Completes "it takes ..."."""


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
        # Parsed inside brackets, because there YAML's null is a value and not a text.
        plain = _PLAIN.fullmatch(value) and values.same(values.parse(f'[{value}]'), [value])
        return value if plain else _quoted(value)
    return yaml.safe_dump(value).removesuffix('...\n').strip()


def _array_of(element: Form) -> Form:
    """Return the form of an array, a YAML flow sequence; the brackets may be left out."""

    def parse_all(text: str) -> list[Any]:
        text = text.strip()
        inner = text[1:-1] if text.startswith('[') and text.endswith(']') else text
        return list(map(element.parse, _split(inner)))

    return Form(lambda items: f'[{", ".join(map(element.format, items))}]', parse_all, element.example)


def _split(text: str) -> list[str]:
    """Return the texts between commas, except commas in quotes; a comma at the end is allowed."""
    item = r"""\s*(?:"(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^,'"\[\]{}][^,\[\]{}]*?)\s*"""
    if not text.strip():
        return []
    if not re.fullmatch(f'{item}(?:,{item})*,?\\s*', text, re.DOTALL):
        raise ValueError('the elements are not separated by commas, or a quote or bracket is not closed')
    return [each.strip() for each in re.findall(rf'{item}(?=,|\Z)', text.rstrip().rstrip(','), re.DOTALL)]


# The form of the elements of each type of array; the example is one of the whole array.
_ELEMENTS = {
    values.BYTE_ARRAY: Form(lambda byte: f'0x{byte[0]:02x}', _parse_byte, 'bytes, e.g. [0x00, 0xff]'),
    values.BOOL_ARRAY: Form(lambda value: str(value).lower(), _parse_bool, 'booleans, e.g. [true, false]'),
    values.INTEGER_ARRAY: Form(str, _parse_integer, 'integers, e.g. [1, 2, 3]'),
    values.DOUBLE_ARRAY: Form(repr, _parse_double, 'doubles, e.g. [0.5, 1.0]'),
    values.STRING_ARRAY: Form(_format_string, _parse_string, 'strings, e.g. [left, "right, far"]'),
}
_FORMS = {
    values.NOT_SET: Form(_format_any, values.parse, 'a value in YAML'),
    values.BOOL: Form(lambda value: str(value).lower(), _parse_bool, 'true or false'),
    values.INTEGER: Form(str, _parse_integer, 'an integer, e.g. 42'),
    values.DOUBLE: Form(repr, _parse_double, 'a double, e.g. 0.5'),
    values.STRING: Form(str, str, 'text'),
    **{array_type: _array_of(element) for array_type, element in _ELEMENTS.items()},
}
# With more elements than these, a list of boxes helps nobody.
_MOST_ITEMS = 100


def form_of(descriptor: Descriptor) -> Form:
    """Return the form in which people write a parameter: that of its type, or YAML if the type is dynamic."""
    # YAML has no bytes, so a byte array keeps its form even if its type is dynamic.
    if descriptor.dynamic_typing and descriptor.type is not values.BYTE_ARRAY:
        return _FORMS[values.NOT_SET]
    return _FORMS[descriptor.type]


def format_value(descriptor: Descriptor, value: Any) -> str:
    """Return a value as a person would type it; an empty text if the parameter is not set.

    :param value: May be of another type than the parameter's, which changes if its type is dynamic, or if the node is
        started again.
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
        value = form.parse(text)
    except (ValueError, KeyError, yaml.YAMLError):
        raise ValueError(f'{text!r} cannot be read: {descriptor.name} takes {form.example}') from None
    return _no_hidden_infinity(text, value)


def _no_hidden_infinity(text: str, value: Any) -> Any:
    """Return a value that a person typed.

    :raises ValueError: a number in it is so large that it has become infinity.
    """
    items = value if isinstance(value, list) else [value]
    infinite = sum(isinstance(item, float) and math.isinf(item) for item in items)
    if infinite > len(re.findall('inf', text, re.IGNORECASE)):
        raise ValueError(f'{text!r} holds a number beyond the largest double, about 1.8e308, and would be infinity: do '
                         f'you mean inf? Then type that')
    return value


def format_items(descriptor: Descriptor, value: Any) -> list[str] | None:
    """Return the elements of an array as a person would type each into a box of its own.

    :return: None if it is not an array, if it has very many elements, or if an element has several lines, which no such
        box can hold.
    """
    if (descriptor.type not in _ELEMENTS or descriptor.dynamic_typing or not isinstance(value, list)
            or len(value) > _MOST_ITEMS):
        return None
    texts = list(map(_element_of(descriptor).format, value))
    return None if any(re.search(r'[\n\r]', text) for text in texts) else texts


def parse_items(descriptor: Descriptor, texts: Sequence[str]) -> list[Any]:
    """Return the array whose elements a person typed one by one.

    :raises ValueError: a text is not an element of such an array; the message says which.
    """
    element, items = _element_of(descriptor), []
    for number, text in enumerate(texts, 1):
        try:
            item = element.parse(text)
        except (ValueError, KeyError):
            raise ValueError(f'element {number}, {text!r}, cannot be read: {descriptor.name} takes '
                             f'{element.example}') from None
        items.append(_no_hidden_infinity(text, item))
    return items


def _element_of(descriptor: Descriptor) -> Form:
    element = _ELEMENTS[descriptor.type]
    # In a box of its own, a string needs no quotes.
    return replace(element, format=str, parse=str) if descriptor.type is values.STRING_ARRAY else element


def fit(descriptor: Descriptor, value: Any) -> Any:
    """Return a Python value as if it had been entered in the parameter's control: a double, not a whole number."""
    value = values.normalize(value)
    if not descriptor.dynamic_typing:
        if descriptor.type is values.DOUBLE and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if descriptor.type is values.DOUBLE_ARRAY and isinstance(value, list):
            return [float(item) if type(item) is int else item for item in value]
    return value


def choices_of(descriptor: Descriptor) -> list[Any]:
    """Return the values that ``Rules.one_of`` allows for a parameter; none if its descriptor has no such rule.

    The rule itself may be in another process, so its words in the descriptor are read.
    """
    _, _, rest = descriptor.additional_constraints.partition(ONE_OF.capitalize())
    return [] if descriptor.type.is_array else read_values(rest)


# A list in prose, as in "Options: 'legacy', 'none'." and "one of fast, slow": what stands after a colon or "one of", up
# to the end of the sentence, the line or the brackets.
_LIST_IN_PROSE = re.compile(r'(?::|\bone of)\s*[\[({]?([^:;()\[\]{}\n]+?)\s*(?:[;)\]}\n]|\.(?=\s|$)|$)')
_BETWEEN_NAMES = re.compile(r',?\s+(?:or|and)\s+|\s*[,|]\s*')
_NAME = re.compile(r'\w+(?:[-./]\w+)*')


def choices_in_prose(descriptor: Descriptor, value: Any) -> tuple[str, ...]:
    """Return the texts that a parameter's description lists, as far as that can be told. No rule says so: the node may
    accept others.

    :param value: What the parameter has. A list without it is a list of something else.
    """
    if descriptor.type is not values.STRING or descriptor.dynamic_typing:
        return ()
    lists = _lists_in_prose(f'{descriptor.additional_constraints}\n{descriptor.description}')
    return next((names for names in lists if value in names), ())


@functools.lru_cache(maxsize=1000)  # a panel asks whenever it draws
def _lists_in_prose(text: str) -> list[tuple[str, ...]]:
    lists = (tuple(name.strip('\'"`') for name in _BETWEEN_NAMES.split(found[1].strip()))
             for found in _LIST_IN_PROSE.finditer(text))
    return [names for names in lists if len(names) > 1 and all(map(_NAME.fullmatch, names))]
