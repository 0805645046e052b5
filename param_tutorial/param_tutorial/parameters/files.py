"""Parameter files: write them so that everything comes back, read them as rcl does. No ROS, no Jupyter.

Two programs read such a file, by different rules: rcl's own parser (``--params-file``, and ``read`` here),
and the YAML library of ``ros2 param load``. ``render`` writes what both understand alike, and leaves out, with
a reason, what rcl has no words for.

``read`` follows rcl's parser event by event, oddities included: of two blocks that match the node the one whose
name appeared later wins, however specific the other; a name given twice with two types keeps the first of
boolean, integer, double, string. It deviates from rcl on purpose in two points: an empty array is returned as
``[]`` where rcl makes a parameter without a type of it, and other names without a value are rejected.
"""

import contextlib
import json
import math
import os
import re
import sys
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import yaml

from param_tutorial.errors import InvalidValueError, ParameterFileError
from param_tutorial.parameters import values

_KEY = 'ros__parameters'
_LINE_LENGTH = 100
# The longest plain key that YAML takes without a leading question mark is 1024 bytes.
_LONG_KEY = 1000

# -- how rcl types a scalar (rcl_yaml_param_parser/src/parse.c, get_value) ---------------------------------

_TRUE = {'Y', 'y', 'yes', 'Yes', 'YES', 'true', 'True', 'TRUE', 'on', 'On', 'ON'}
_FALSE = {'N', 'n', 'no', 'No', 'NO', 'false', 'False', 'FALSE', 'off', 'Off', 'OFF'}
_SPECIAL = {'.nan', '.NaN', '.NAN', '.inf', '.Inf', '.INF', '+.inf', '+.Inf', '+.INF', '-.inf', '-.Inf', '-.INF'}
_BLANK = r'[ \t\n\v\f\r]*'
# What strtol with base 0 and strtod of the C library take as a whole.
_INTEGER = re.compile(_BLANK + r'([+-]?)(?:0[xX]([0-9a-fA-F]+)|(0[0-7]*)|([1-9][0-9]*))')
_REAL = re.compile(_BLANK + r'([+-]?)(?:(inf(?:inity)?)|(nan(?:\([0-9a-z_]*\))?)|'
                   r'(0x(?:[0-9a-f]+\.?[0-9a-f]*|\.[0-9a-f]+)(?:p[+-]?[0-9]+)?)|'
                   r'((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[+-]?[0-9]+)?))', re.IGNORECASE)


def _typed(text: str, quoted: bool) -> bool | int | float | str:
    """Return the value that rcl makes of a scalar."""
    if not quoted:
        if text in _TRUE:
            return True
        if text in _FALSE:
            return False
        for number in (_strtol(text), _strtod(text.replace('.', '', 1) if text in _SPECIAL else text)):
            if number is not None:
                return number
    return text


def _strtol(text: str) -> int | None:
    """Read a whole number as C does: 0x10 is 16 and 010 is 8. None if it is none, or exceeds 64 bits."""
    match = _INTEGER.fullmatch(text)
    if match is None:
        return None
    sign, hexadecimal, octal, decimal = match.groups()
    # A number of thousands of digits exceeds 64 bits anyway, and Python refuses to read it.
    digits = hexadecimal or octal or decimal
    if len(digits.lstrip('0')) > 22:
        return None
    number = int(digits, 16 if hexadecimal else 8 if octal else 10) * (-1 if sign == '-' else 1)
    return number if values.INT64_MIN <= number <= values.INT64_MAX else None


def _strtod(text: str) -> float | None:
    """Read a real number as C does. None if it is none, or does not fit: C then reports a range error."""
    match = _REAL.fullmatch(text)
    if match is None:
        return None
    sign, infinite, nan, hexadecimal, decimal = match.groups()
    if nan:
        return float('nan')
    if infinite:
        return float(f'{sign}inf')
    try:
        number = float.fromhex(hexadecimal) if hexadecimal else float(decimal)
    except OverflowError:
        return None
    if math.isinf(number):
        return None
    if number < sys.float_info.min and _is_inexact(number, hexadecimal, decimal):
        return None
    return -number if sign == '-' else number


def _is_inexact(number: float, hexadecimal: str | None, decimal: str | None) -> bool:
    """True if a number below the smallest normal double differs from its text: C calls that an underflow."""
    mantissa, _, exponent = (hexadecimal[2:].lower().partition('p') if hexadecimal
                             else (decimal or '').lower().partition('e'))
    if number == 0.0:  # decided without arithmetic: the exponent may have a million digits
        return any(digit not in '0.' for digit in mantissa)
    if decimal:
        return Fraction(Decimal(decimal)) != Fraction(number)
    whole, _, part = mantissa.partition('.')
    exact = Fraction(int(whole + part, 16)) * Fraction(2) ** (int(exponent or 0) - 4 * len(part))
    return exact != Fraction(number)


# -- reading --------------------------------------------------------------------------------------------------


def read(path: str | Path, node: str) -> dict[str, Any]:
    """Return the parameters that a file holds for a node, with the types that rcl would give them.

    :param path: The YAML file.
    :param node: Fully qualified name of the node.
    :return: Names and values, in the order of the file; an empty array is ``[]``.
    :raises ParameterFileError: the file cannot be read, rcl would reject it, or it holds nothing for the node.
    """
    try:
        content = Path(path).read_bytes()
    except OSError as error:
        raise ParameterFileError(f'cannot read {path}: {error.strerror or error}') from None
    try:
        blocks = _Parser().parse(content)
    except _Rejected as rejected:
        raise ParameterFileError(f'{path}, line {rejected.line}: {rejected}') from None
    matching = [block for name, block in blocks.items() if _matches(name, node)]
    if not matching:
        names = ', '.join(blocks) or 'no node at all'
        raise ParameterFileError(f'{path} holds nothing for {node}; it is for {names}. A block for this node starts '
                                 f'with "{node}:" or "/**:"')
    found = {entry.name: entry for block in matching for entry in block}
    for entry in found.values():
        if entry.value() is None:
            raise ParameterFileError(f'{path}, line {entry.line}: {entry.name} has no value; write one, or remove '
                                     f'the line')
    return {name: entry.value() for name, entry in found.items()}


def _matches(block: str, node: str) -> bool:
    """True if a block of this name is for the node: ``*`` is one name, ``**`` any number of them, also none."""
    pattern = re.sub(r'/\*\*|\*', lambda match: r'(/\w+)*' if len(match[0]) > 1 else r'\w+',
                     block if block.startswith('/') else '/' + block)
    return re.fullmatch(pattern, node, re.ASCII) is not None


class _Rejected(Exception):
    """rcl would reject the file at this line."""

    def __init__(self, line: int, reason: str):
        super().__init__(reason)
        self.line = line


class _Entry:
    """One parameter of a block. It may come to hold values of several types; rclpy takes the first."""

    def __init__(self, name: str, line: int):
        self.name = name
        self.line = line
        self.scalars: dict[type, Any] = {}
        self.arrays: dict[type, list[Any]] = {}
        self.is_empty_array = False

    def value(self) -> Any:
        for held in (self.scalars, self.arrays):
            for kind in (bool, int, float, str):
                if kind in held:
                    return held[kind]
        return [] if self.is_empty_array else None


class _Parser:
    """rcl's state machine over the events of the YAML library (parse.c, parse_file_events).

    It is not the obvious recursive reading of a tree: rcl tracks the namespace of the node and of the
    parameter in two strings, and what it accepts beyond the obvious follows from that.
    """

    def __init__(self) -> None:
        self.blocks: dict[str, list[_Entry]] = {}
        self.block: list[_Entry] = []
        # Where in each block the entries of a name are.
        self.places: dict[str, dict[str, set[int]]] = {}
        self.places_here: dict[str, set[int]] = {}
        self.entry = -1
        self.in_parameters = False
        self.depth = 0
        self.node_path, self.node_parts = '', 0
        self.parameter_path, self.parameter_parts = '', 0
        self.expects_key = True
        self.is_new_map = False
        self.in_sequence = False
        self.item_type: type | None = None

    def parse(self, content: bytes) -> dict[str, list[_Entry]]:
        """Return the blocks of a file by name, in the order in which the names first appear."""
        # libyaml is what rcl uses; PyYAML's own parser differs from it in corners, but is always there.
        loader = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)
        try:
            for event in yaml.parse(content, Loader=loader):
                # Each event of a parser has its place; only one that a program makes may lack it.
                self._handle(event, event.start_mark.line + 1 if event.start_mark else 1)
        except yaml.YAMLError as error:
            mark = getattr(error, 'problem_mark', None)
            what = getattr(error, 'problem', None) or str(error).splitlines()[0]
            raise _Rejected(mark.line + 1 if mark else 1, f'this is not YAML: {what}') from None
        except RecursionError:
            raise _Rejected(1, 'this is nested too deeply') from None
        return self.blocks

    def _handle(self, event: yaml.Event, line: int) -> None:
        if isinstance(event, yaml.AliasEvent):
            raise _Rejected(line, f'ROS reads no aliases: write the value itself instead of *{event.anchor}')
        if isinstance(event, yaml.ScalarEvent):
            if self.expects_key:
                self._key(event, line)
                self.expects_key = False
            else:
                self._value(event, line)
                self.expects_key = not self.in_sequence
        elif isinstance(event, yaml.SequenceStartEvent):
            if self.expects_key:
                raise _Rejected(line, 'a list cannot stand here; a parameter is a value or a list of values, '
                                     'never a list of lists')
            if not self.in_parameters:
                raise _Rejected(line, f'a list cannot stand before {_KEY}')
            self.in_sequence, self.item_type = True, None
            if self.block:
                self.block[self.entry].is_empty_array = True
        elif isinstance(event, yaml.SequenceEndEvent):
            self.in_sequence, self.expects_key = False, True
        elif isinstance(event, yaml.MappingStartEvent):
            self.depth += 1
            self.expects_key = True
            self.is_new_map = not (self.in_parameters and self.depth - self.node_parts == 3)
        elif isinstance(event, yaml.MappingEndEvent):
            self._leave_mapping()

    def _leave_mapping(self) -> None:
        if not self.in_parameters:
            if self.depth == self.node_parts + 1:
                self.node_path, self.node_parts = _shortened(self.node_path, self.node_parts, '/')
        elif self.parameter_parts:
            self.parameter_path, self.parameter_parts = _shortened(self.parameter_path, self.parameter_parts, '.')
        else:
            self.in_parameters = False
        self.depth -= 1

    def _key(self, event: yaml.ScalarEvent, line: int) -> None:
        if not event.value:
            raise _Rejected(line, 'there is a value without a name')
        name = _c_string(event.value)
        if not self.in_parameters:
            self._node_key(name, line)
            return
        if self.is_new_map:
            if not self.block or self.entry >= len(self.block):
                raise _Rejected(line, f'cannot tell which parameter {name} belongs to; an empty map before it may '
                                     f'be the cause')
            self.parameter_path = self.block[self.entry].name
            self.parameter_parts += 1
            self.is_new_map = False
        if not self.parameter_parts:
            self._select(name, line)
        else:
            self._select(self.parameter_path, line)
            self._rename(f'{self.parameter_path}.{name}')
            self.block[self.entry].line = line

    def _node_key(self, name: str, line: int) -> None:
        if not name.startswith(_KEY):
            if not name:
                raise _Rejected(line, 'there is a block without a name')
            separator = '/' if self.node_parts and not self.node_path.endswith('/') else ''
            self.node_path = (self.node_path if self.node_parts else '') + separator + name
            self.node_parts += 1
            return
        if not self.node_parts:
            raise _Rejected(line, f'there is no node name before {_KEY}; start with "/name_of_the_node:" or "/**:"')
        _check_block_name(self.node_path, line)
        self.block = self.blocks.setdefault(self.node_path, [])
        self.places_here = self.places.setdefault(self.node_path, {})
        self.node_path, self.node_parts = _shortened(self.node_path, self.node_parts, '/')
        self.in_parameters = True

    def _select(self, name: str, line: int) -> None:
        places = self.places_here.setdefault(name, set())
        if not places:
            places.add(len(self.block))
            self.block.append(_Entry(name, line))
        self.entry = min(places)

    def _rename(self, name: str) -> None:
        entry = self.block[self.entry]
        self.places_here[entry.name].remove(self.entry)
        self.places_here.setdefault(name, set()).add(self.entry)
        entry.name = name

    def _value(self, event: yaml.ScalarEvent, line: int) -> None:
        if not self.in_parameters or not self.block:
            raise _Rejected(line, f'there is a value before {_KEY}: it has to be node name, {_KEY}, then parameters')
        if self.entry >= len(self.block):
            raise _Rejected(line, 'there is a value without a name')
        quoted = event.style in ("'", '"')
        if not event.value and not quoted:
            raise _Rejected(line, f"{self.block[self.entry].name} has no value; for an empty string write ''")
        value = _typed(_c_string(event.value), quoted or event.tag == 'tag:yaml.org,2002:str')
        entry, kind = self.block[self.entry], type(value)
        if not self.in_sequence:
            entry.scalars[kind] = value
            return
        if self.item_type is None:
            self.item_type = kind
            entry.arrays[kind] = []
        elif self.item_type is not kind or kind not in entry.arrays:
            raise _Rejected(line, f'the elements of {entry.name} must all be of one type; {event.value!r} is not '
                                 f'like those before it')
        entry.arrays[kind].append(value)


def _c_string(text: str) -> str:
    """Return a text cut where C would cut it: at the first NUL."""
    return text.partition('\0')[0]


def _shortened(path: str, parts: int, separator: str) -> tuple[str, int]:
    """Return a path without its last part, and how many parts remain."""
    if parts <= 1:
        return '', 0
    return path.rpartition(separator)[0] if separator in path else path, parts - 1


def _check_block_name(name: str, line: int) -> None:
    """Reject what can be neither the name of a node nor a pattern for such names."""
    for part in ('/' + name).replace('//', '/', 1).split('/')[1:]:
        if not re.fullmatch(r'\*\*?|[A-Za-z_][A-Za-z0-9_]*', part):
            raise _Rejected(line, f'{name!r} is not a node name: it takes letters, digits and underscores between '
                                 f'slashes, or * and ** for any')


# -- writing --------------------------------------------------------------------------------------------------


class Dump:
    """The text of a parameter file, and what could not be put into it. ``str(dump)`` is the text."""

    def __init__(self, text: str, left_out: dict[str, str]):
        self.text = text
        self.left_out = left_out
        """The parameters that are not in the text, and why; they stand there as comments, too."""

    def save(self, path: str | Path) -> None:
        """Write the file. What stood there is replaced as a whole, or not at all.

        :raises OSError: it cannot be written; then nothing has changed.
        """
        target = Path(os.path.realpath(path))
        draft = target.with_name(f'.{target.name[:100]}.{os.getpid()}.tmp')
        try:
            if target.exists() and not target.is_file():
                # A folder says so itself; a device or pipe (/dev/stdout) must not be replaced by a file.
                with target.open('w', encoding='utf-8') as file:
                    file.write(self.text)
                return
            try:
                with draft.open('w', encoding='utf-8') as file:
                    file.write(self.text)
                    file.flush()
                    os.fsync(file.fileno())
                if target.exists():
                    draft.chmod(target.stat().st_mode & 0o7777)
                draft.replace(target)
            finally:
                with contextlib.suppress(OSError):
                    draft.unlink()
        except OSError as error:
            raise type(error)(error.errno, f'{error.strerror}; the parameters were not written', str(path)) from None

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        if not self.left_out:
            return self.text.rstrip('\n')
        names = ', '.join(name if name.isprintable() and name else json.dumps(name) for name in self.left_out)
        return f'{self.text}(left out: {names}; dump.left_out says why)'


def render(node: str, parameters: Mapping[str, Any]) -> Dump:
    """Write the parameters of a node as a parameter file.

    :param node: Fully qualified name of the node.
    :param parameters: Names and values, as ``values.normalize`` gives them.
    :return: The text, sorted by name, and what it leaves out: what rcl's parser could not read back with the
        same type and value.
    """
    left_out: dict[str, str] = {}
    written: dict[str, tuple[str, list[str]]] = {}
    for name, value in sorted(parameters.items()):
        reason = _not_expressible(name, value)
        if reason:
            left_out[name] = reason
        else:
            written[name] = _format_list(value) if isinstance(value, list) else (_format_scalar(value), [])
    lines = [f'{_format_scalar(node)}:', f'  {_KEY}:' + ('' if written else ' {}')]
    _add_parameters(lines, written, '    ')
    lines += [f'    # left out: {json.dumps(name)}: {reason}' for name, reason in left_out.items()]
    return Dump('\n'.join(lines) + '\n', left_out)


def _not_expressible(name: str, value: Any) -> str | None:
    """Return why rcl could not read this back, or None if it could."""
    if not name:
        return 'a parameter file has no place for an empty name'
    if '\0' in name:
        return 'a name in a parameter file ends at its first NUL character'
    if value is None:
        return 'it has no value'
    if values.is_empty_array(value):
        return 'an empty array in a parameter file has no type'
    try:
        parameter_type = values.type_of(value)
        name.encode()
    except (InvalidValueError, UnicodeEncodeError) as error:
        return str(error)
    if parameter_type is values.BYTE_ARRAY:
        return 'a parameter file has no byte arrays'
    for item in value if isinstance(value, list) else (value,):
        if isinstance(item, float) and 0 < abs(item) < sys.float_info.min:
            return f'{item!r} is so close to 0.0 that it would be read as a string'
    return None


def _format_list(value: list[Any]) -> tuple[str, list[str]]:
    """Return a list in one line if that is short, else its items, one for each line."""
    items = [_format_scalar(item) for item in value]
    inline = f'[{", ".join(items)}]'
    return (inline, []) if len(inline) <= _LINE_LENGTH else ('', items)


def _add_parameters(lines: list[str], parameters: dict[str, tuple[str, list[str]]], indent: str) -> None:
    """Add parameters, nesting ``a.b`` below ``a``.

    rcl loses a parameter ``a`` that has a map of the same name after it, and takes a map key with an empty part
    for none at all; so where ``a`` is a parameter itself, or a part is empty, the dotted name is written flat.
    """
    heads = {name: name.partition('.')[0] for name in parameters}
    flat = {name for name in parameters if name in (heads[name], f'{heads[name]}.') or heads[name] in parameters
            or '' in name.split('.')}
    done = set()
    for name, (inline, items) in parameters.items():
        head = heads[name]
        if name in flat:
            _add_key(lines, name, indent, inline)
            lines += [f'{indent}- {item}' for item in items]
        elif head not in done:
            done.add(head)
            _add_key(lines, head, indent, '')
            _add_parameters(lines, {other[len(head) + 1:]: parameters[other] for other in parameters
                           if heads[other] == head and other not in flat}, indent + '  ')


def _add_key(lines: list[str], name: str, indent: str, inline: str) -> None:
    key = _format_scalar(name)
    if len(key.encode()) > _LONG_KEY:
        lines.append(f'{indent}? {key}')
        key = ''
    lines.append(f'{indent}{key}:{" " if inline else ""}{inline}')


# A text that looks like a word or several, with nothing in it that means something in YAML.
_PLAIN = re.compile(r'[A-Za-z_/][A-Za-z0-9_./+-]*(?: [A-Za-z0-9_./+()-]+)*')
_YAML_TYPES = yaml.SafeLoader.yaml_implicit_resolvers


def _format_scalar(value: bool | int | float | str) -> str:
    """Return a scalar as rcl, YAML 1.1 and YAML 1.2 all read it: with the same type and value."""
    if isinstance(value, bool):
        return 'true' if value else 'false'
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if math.isnan(value):
            return '.nan'
        if math.isinf(value):
            return '.inf' if value > 0 else '-.inf'
        mantissa, e, exponent = repr(value).partition('e')
        return (mantissa if '.' in mantissa else f'{mantissa}.0') + e + exponent
    if _PLAIN.fullmatch(value) and _typed(value, False) == value and not any(
            pattern.match(value) for _, pattern in _YAML_TYPES.get(value[0], ())):
        return value
    if value.isprintable():
        return "'" + value.replace("'", "''") + "'"
    return '"' + ''.join(map(_escape, value)) + '"'


def _escape(char: str) -> str:
    short = {'\\': r'\\', '"': r'\"', '\n': r'\n', '\t': r'\t', '\r': r'\r'}.get(char)
    if short or char.isprintable():
        return short or char
    code = ord(char)
    return f'\\x{code:02x}' if code < 0x100 else f'\\u{code:04x}' if code < 0x10000 else f'\\U{code:08x}'
