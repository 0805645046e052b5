"""Parameter values as people type them: from text to a value of the parameter's type, and back.

Numbers are edited as text: JavaScript has no 64-bit integers, and no browser's number box knows nan or says what is
wrong with "1,5".
"""

import contextlib
import json
import math
import re
import shlex
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import yaml

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.files.parameter_files import quote


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


def _parse_string(text: str) -> str:
    text = text.strip()
    return yaml.safe_load(text) if text[:1] in ('"', "'") else text


def _needs_quotes(text: str) -> bool:
    """True if a part of a text cannot be seen, as U+202E, or if it would be read as another text."""
    return not text.replace('\n', '').isprintable() or _unquoted(text) != text


def _unquoted(text: str) -> str:
    """Return what stands in quotes if it needs them; any other text stays as it is, with its quotes."""
    if len(text) > 1 and text[0] == text[-1] == '"':
        with contextlib.suppress(yaml.YAMLError):
            inner = yaml.safe_load(text)
            if isinstance(inner, str) and _needs_quotes(inner):
                return inner
    return text


_PLAIN = re.compile(r'\w([\w ./-]*\w)?')


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
        return value if plain else quote(value)
    return yaml.safe_dump(value).removesuffix('...\n').strip()


def _array_of(element: Form) -> Form:
    """Return the form of an array, a YAML flow sequence; the brackets may be left out.

    :param element: Its example is one of the whole array.
    """

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


_FORMS = {
    values.NOT_SET: Form(_format_any, values.parse, 'a value in YAML'),
    values.BOOL: Form(lambda value: str(value).lower(), _parse_bool, 'true or false'),
    values.INTEGER: Form(str, _parse_integer, 'an integer, e.g. 42'),
    values.DOUBLE: Form(repr, _parse_double, 'a double, e.g. 0.5'),
    values.STRING: Form(lambda text: quote(text) if _needs_quotes(text) else text, _unquoted, 'text'),
    values.BYTE_ARRAY: _array_of(Form(lambda byte: f'0x{byte[0]:02x}', lambda text: bytes([_parse_integer(text)]),
                                      'bytes, e.g. [0x00, 0xff]')),
    values.BOOL_ARRAY: _array_of(Form(lambda value: str(value).lower(), _parse_bool, 'booleans, e.g. [true, false]')),
    values.INTEGER_ARRAY: _array_of(Form(str, _parse_integer, 'integers, e.g. [1, 2, 3]')),
    values.DOUBLE_ARRAY: _array_of(Form(repr, _parse_double, 'doubles, e.g. [0.5, 1.0]')),
    values.STRING_ARRAY: _array_of(Form(lambda text: text if _PLAIN.fullmatch(text) else quote(text), _parse_string,
                                        'strings, e.g. [left, "right, far"]')),
}


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


def format_commands(node: str, parameters: Mapping[str, Any]) -> str:
    """Return lines for a shell that set parameters to values; a comment for each value that ROS's command can't write.

    :param node: Fully qualified name of the node.
    """
    lines = []
    for name, value in sorted(parameters.items()):
        if values.type_of(value) is values.BYTE_ARRAY:  # an empty array counts as one, too
            lines.append(f'# left out: {json.dumps(name)}: ros2 param set has no words for its value')
            continue
        text = _format_any(value)
        # A blank, which YAML passes over, keeps the command from taking a text for an option.
        if text.startswith('-') and not re.fullmatch(r'-\d+|-\d*\.\d+', text):
            text = f' {text}'
        lines.append(f'ros2 param set {shlex.join([node, name, text])}')
    return ''.join(f'{line}\n' for line in lines)


def parse_value(descriptor: Descriptor, text: str) -> Any:
    """Return the value that a person typed for a parameter.

    :raises ValueError: the text is not a value of the parameter's type; the message says what would be.
    """
    form = form_of(descriptor)
    try:
        value = form.parse(text)
    except (ValueError, KeyError, yaml.YAMLError):
        raise ValueError(f'{text!r} cannot be read: {descriptor.name} takes {form.example}') from None
    values.type_of(value)  # raises an exception for what the message of ROS cannot carry
    items = value if isinstance(value, list) else [value]
    infinite = sum(isinstance(item, float) and math.isinf(item) for item in items)
    if infinite > len(re.findall('inf', text, re.IGNORECASE)):
        raise ValueError(f'{text!r} holds a number beyond the largest double, about 1.8e308, and would be infinity: do '
                         f'you mean inf? Then type that')
    return value


def fit(descriptor: Descriptor, value: Any) -> Any:
    """Return a Python value as if it had been entered in the parameter's control: a double, not a whole number."""
    value = values.normalize(value)
    if not descriptor.dynamic_typing:
        if descriptor.type is values.DOUBLE and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if descriptor.type is values.DOUBLE_ARRAY and isinstance(value, list):
            return [float(item) if type(item) is int else item for item in value]
    return value
