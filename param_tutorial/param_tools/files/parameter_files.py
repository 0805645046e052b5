"""Parameter files: write them so that everything comes back, read them as rcl does. No ROS, no Jupyter.

Two programs read such a file, by different rules: rcl's own parser (``--params-file``, and ``read`` here),
and the YAML library of ``ros2 param load``. ``render`` writes what both understand alike, and leaves out, with
a reason, what rcl has no words for.

``read`` follows rcl's parser (see ``parsing``), and deviates from it on purpose in two points: an empty array is
returned as ``[]`` where rcl makes a parameter without a type of it, and other names without a value are rejected.
"""

import codecs
import contextlib
import json
import math
import os
import re
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import yaml

from param_tools import values
from param_tools.errors import InvalidValueError, ParameterFileError
from param_tools.files.causes import cause_of
from param_tools.files.parsing import KEY, Entry, Parser, Rejected, effective, typed

_LINE_LENGTH = 100
# The longest plain key that YAML takes without a leading question mark is 1024 bytes.
_LONG_KEY = 1000

NO_TYPE = 'an empty array in a parameter file has no type'
"""Why an empty array is left out."""

# -- reading --------------------------------------------------------------------------------------------------


def read(path: str | Path, node: str) -> dict[str, Any]:
    """Return the parameters that a file holds for a node, with the types that rcl would give them.

    :param path: The YAML file.
    :param node: Fully qualified name of the node.
    :return: Names and values, in the order of the file; an empty array is ``[]``.
    :raises ParameterFileError: the file cannot be read, rcl would reject it, or it holds nothing for the node.
    """
    parser = parse(path)
    if not parser.blocks_for(node):
        names = ', '.join(parser.blocks) or 'no node at all'
        raise ParameterFileError(f'{path} holds nothing for {node}; it is for {names}. A block for this node starts '
                                 f'with "{node}:" or "/**:"')
    return values_of(path, effective(parser, node))


def read_all(path: str | Path, nodes: Iterable[str] = ()) -> dict[str, dict[str, Any]]:
    """Return the parameters that a file holds, by node: for those that it names, and for those that are given.

    :param nodes: Fully qualified names; a block like ``/**`` may be for them, too.
    :return: As ``read`` for each node for which there is something.
    :raises ParameterFileError: the file cannot be read, or rcl would reject it.
    """
    parser = parse(path)
    named = ('/' + name.strip('/') for name in parser.blocks if '*' not in name)
    return {node: values_of(path, effective(parser, node)) for node in dict.fromkeys((*named, *nodes))
            if parser.blocks_for(node)}


def parse(path: str | Path) -> Parser:
    """Return a parser that has read a file: its blocks, and what stands where.

    :raises ParameterFileError: the file cannot be read, or rcl would reject it.
    """
    parser = Parser()
    try:
        content = read_bytes(path)
        parser.parse(content)
    except Rejected as rejected:
        place, reason, _ = cause_of(rejected, parser.starts, lines_of(content))
        raise ParameterFileError(f'{path}, line {place.line}: {reason}') from None
    return parser


def read_bytes(path: str | Path) -> bytes:
    """Return what a file holds.

    :raises ParameterFileError: it cannot be read.
    """
    try:
        return as_path(path).read_bytes()
    except OSError as error:
        raise ParameterFileError(f'cannot read {path}: {error.strerror or error}') from None


def lines_of(content: bytes) -> list[str]:
    """Return the lines of a file, whatever its encoding."""
    is_wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    # Not str.splitlines, for which more characters end a line than for YAML.
    return re.split('\r\n?|\n', content.decode('utf-16' if is_wide else 'utf-8-sig', 'replace'))


def as_path(path: str | Path) -> Path:
    """Return a path that a file could have.

    :raises ParameterFileError: there is no such path.
    """
    if '\0' in str(path):
        raise ParameterFileError(f'{str(path)!r} is not a path: it has a null character')
    return Path(path)


def values_of(path: str | Path, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Return the values of parameters that a file holds.

    :param path: The file, for the message of an error.
    :raises ParameterFileError: one of them has no value.
    """
    for entry in entries.values():
        if entry.value() is None:
            raise ParameterFileError(f'{path}, line {entry.place.line}: {entry.name} has no value; write one, or '
                                     f'remove the line')
    return {name: entry.value() for name, entry in entries.items()}


# -- writing --------------------------------------------------------------------------------------------------


class Dump:
    """The text of a parameter file, and what could not be put into it. ``str(dump)`` is the text."""

    def __init__(self, text: str, left_out: dict[str, str]):
        self.text = text
        self.left_out = left_out
        """The parameters that are not in the text, and why; they stand there as comments, too."""

    def save(self, path: str | Path) -> None:
        """Write the file. What stood there is replaced as a whole, or not at all.

        :raises ParameterFileError: there is no such path.
        :raises OSError: it cannot be written; then nothing has changed.
        """
        target = Path(os.path.realpath(as_path(path)))
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
        if reason := why_not_expressible(name, value):
            left_out[name] = reason
        else:
            written[name] = _format_list(value) if isinstance(value, list) else (format_scalar(value), [])
    lines = [f'{format_scalar(node)}:', f'  {KEY}:' + ('' if written else ' {}')]
    _add_parameters(lines, written, '    ')
    lines += [f'    # left out: {json.dumps(name)}: {reason}' for name, reason in left_out.items()]
    return Dump('\n'.join(lines) + '\n', left_out)


def why_not_expressible(name: str, value: Any) -> str | None:
    """Return why rcl could not read this back, or None if it could."""
    if not name:
        return 'a parameter file has no place for an empty name'
    if '\0' in name:
        return 'a name in a parameter file ends at its first NUL character'
    if value is None:
        return 'it has no value'
    if values.is_empty_array(value):
        return NO_TYPE
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
    items = [format_scalar(item) for item in value]
    inline = f'[{", ".join(items)}]'
    return (inline, []) if len(inline) <= _LINE_LENGTH else ('', items)


def _add_parameters(lines: list[str], parameters: dict[str, tuple[str, list[str]]], indent: str) -> None:
    """Add parameters, nesting ``a.b`` below ``a``.

    rcl loses a parameter ``a`` that has a map of the same name after it, and takes a map key with an empty part
    for none at all; so where ``a`` is a parameter itself, or a part is empty, the dotted name is written flat.
    """
    heads = {name: name.partition('.')[0] for name in parameters}
    flat = {name for name, head in heads.items() if name == head or head in parameters or '..' in f'.{name}.'}
    below: dict[str, dict[str, tuple[str, list[str]]]] = {}
    for name, written in parameters.items():
        if name not in flat:
            below.setdefault(heads[name], {})[name[len(heads[name]) + 1:]] = written
    for name, (inline, items) in parameters.items():
        if name in flat:
            _add_key(lines, name, indent, inline)
            lines += [f'{indent}- {item}' for item in items]
        elif nested := below.pop(heads[name], None):  # with the first of its names
            _add_key(lines, heads[name], indent, '')
            _add_parameters(lines, nested, indent + '  ')


def _add_key(lines: list[str], name: str, indent: str, inline: str) -> None:
    key = format_scalar(name)
    if len(key.encode()) > _LONG_KEY:
        lines.append(f'{indent}? {key}')
        key = ''
    lines.append(f'{indent}{key}:{" " if inline else ""}{inline}')


# A text that looks like a word or several, with nothing in it that means something in YAML.
_PLAIN = re.compile(r'[A-Za-z_/][A-Za-z0-9_./+-]*(?: [A-Za-z0-9_./+()-]+)*')
_YAML_TYPES = yaml.SafeLoader.yaml_implicit_resolvers


def format_scalar(value: bool | int | float | str) -> str:
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
    if _PLAIN.fullmatch(value) and typed(value, False) == value and not any(
            pattern.match(value) for _, pattern in _YAML_TYPES.get(value[0], ())):
        return value
    if value.isprintable():
        return "'" + value.replace("'", "''") + "'"
    return quote(value)


def quote(text: str) -> str:
    """Return a text in double quotes, with escapes for what cannot be seen, as YAML reads it."""
    return '"' + ''.join(map(_escape, text)) + '"'


def _escape(char: str) -> str:
    short = {'\\': r'\\', '"': r'\"', '\n': r'\n', '\t': r'\t', '\r': r'\r'}.get(char)
    if short or char.isprintable():
        return short or char
    code = ord(char)
    return f'\\x{code:02x}' if code < 0x100 else f'\\u{code:04x}' if code < 0x10000 else f'\\U{code:08x}'
