"""Change values in a parameter file that somebody wrote by hand, and nothing else in it. No ROS, no Jupyter.

Only the characters of a value are replaced, where rcl's parser has found them; comments, order, quotes and blank lines
stay. What comes out is read again: if a node would then get anything but what was asked for, nothing is written. Values
of several lines are left to their author.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from param_tools import values
from param_tools.errors import ParameterFileError
from param_tools.files.parameter_files import Dump, format_scalar, read_bytes, why_not_expressible
from param_tools.files.parsing import Assignment, Parser, Rejected, effective, matches

_BOM = '\ufeff'


def update_file(path: str | Path, node: str, new: Mapping[str, Any]) -> list[str]:
    """Change parameters in a file, and keep all else that stands there.

    :param path: A parameter file. A value is changed where the node gets it from; if that is a block for several
        nodes, such as ``/**``, then for all of them.
    :param node: Fully qualified name.
    :param new: Names and values; the file holds a value for each name already, in one line.
    :return: The names whose values have changed.
    :raises ParameterFileError: the file cannot be read, or cannot be changed like this; it is then as it was.
    :raises OSError: it cannot be written; it is then as it was.
    """
    try:
        text = read_bytes(path).decode()
    except UnicodeDecodeError as error:
        raise ParameterFileError(f'{path} is not UTF-8: {error.reason} at byte {error.start}') from None
    try:
        edited, changed = edit(text, node, new)
    except ParameterFileError as error:
        raise ParameterFileError(f'{path}: {error}') from None
    if changed:
        Dump(edited, {}).save(path)
    return changed


def edit(text: str, node: str, new: Mapping[str, Any]) -> tuple[str, list[str]]:
    """Change parameters in the text of a file; as ``update_file``.

    :return: The text, and the names whose values have changed.
    :raises ParameterFileError: it cannot be done.
    """
    mark, text = (_BOM, text[1:]) if text.startswith(_BOM) else ('', text)
    changed = []
    for name, value in ((name, values.normalize(value)) for name, value in new.items()):
        if reason := why_not_expressible(name, value):
            raise ParameterFileError(f'{name} of {node}: {reason}')
        parser = _parsed(text)
        entry = effective(parser, node).get(name)
        assignment = entry.winner() if entry is not None else None
        if assignment is None:
            raise ParameterFileError(f'it holds no {name} for {node}: add it by hand')
        if values.same(assignment.value, value):
            continue
        edited = _with(text, assignment, value)
        expected, others = _held(parser, node)
        held, now = _held(_parsed(edited), node)
        if not (_same(held, {**expected, name: value}) and _same(now, others)):
            raise ParameterFileError(f'{name} of {node} cannot be changed to {values.format_value(value, 60)} without '
                                     f'changing the file otherwise: change it by hand')
        text = edited
        changed.append(name)
    return mark + text, changed


def _parsed(text: str) -> Parser:
    parser = Parser()
    try:
        parser.parse(text.encode(errors='surrogatepass'))
    except Rejected as rejected:
        raise ParameterFileError(f'line {rejected.place.line}: {rejected}') from None
    return parser


def _held(parser: Parser, node: str) -> tuple[dict[str, Any], dict[tuple[str, str], Any]]:
    """Return what a text holds for a node, and what its blocks for other nodes hold."""
    others = {(name, entry.name): entry.value() for name, block in parser.blocks.items()
              if not matches(name, node) for entry in block}
    return {name: entry.value() for name, entry in effective(parser, node).items()}, others


def _same(left: Mapping[Any, Any], right: Mapping[Any, Any]) -> bool:
    return left.keys() == right.keys() and all(values.same(left[each], right[each]) for each in left)


def _with(text: str, assignment: Assignment, value: Any) -> str:
    """Return a text with another value in the place of one."""
    place = assignment.place
    old = text[place.start:place.end]
    if '\n' in old or (assignment.is_array and not old.startswith('[')):
        raise ParameterFileError(f'the value of {assignment.name} in line {place.line} is one of several lines: change '
                                 f'it by hand')
    new = (f'[{", ".join(map(format_scalar, value))}]' if isinstance(value, list) else
           _in_quotes_like(old, value) or format_scalar(value))
    return text[:place.start] + new + text[place.end:]


def _in_quotes_like(old: str, value: Any) -> str:
    """Return a text in quotes like those of the value that was there; empty if it had none, or they won't do."""
    if isinstance(value, str) and value.isprintable():
        if old.startswith("'"):
            return "'" + value.replace("'", "''") + "'"
        if old.startswith('"') and not set(value) & {'"', '\\'}:
            return f'"{value}"'
    return ''
