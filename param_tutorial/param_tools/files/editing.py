"""Change values in a parameter file that somebody wrote by hand, and nothing else in it. No ROS, no Jupyter.

Only the characters of a value are replaced, where rcl's parser has found them; comments, order, quotes and blank lines
stay. What comes out is read again: if a node would then get anything but what was asked for, nothing is written.
"""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from param_tools import values
from param_tools.errors import ParameterFileError
from param_tools.files.parameter_files import Dump, format_scalar, read_bytes, why_not_expressible
from param_tools.files.parsing import KEY, Assignment, Parser, Place, Rejected, Scalar, effective, matches

_BOM = '\ufeff'


def update_file(path: str | Path, node: str, new: Mapping[str, Any]) -> list[str]:
    """Change parameters in a file, and keep all else that stands there.

    :param path: A parameter file. A value is changed where the node gets it from; if that is a block for several
        nodes, such as ``/**``, then for all of them. A parameter that the file does not hold is added.
    :param node: Fully qualified name.
    :param new: Names and values.
    :return: The names whose values have changed.
    :raises ParameterFileError: the file cannot be read, or cannot hold a value; it is then as it was.
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
        held, _ = _read(text, node)
        if values.holds(held, name, value):
            continue
        text = _with(text, node, name, value)
        changed.append(name)
    return mark + text, changed


def _parsed(text: str) -> Parser:
    parser = Parser()
    try:
        parser.parse(text.encode(errors='surrogatepass'))
    except Rejected as rejected:
        raise ParameterFileError(f'line {rejected.place.line}: {rejected}') from None
    return parser


def _read(text: str, node: str) -> tuple[dict[str, Any], list[tuple[str, str, Any]]]:
    """Return what a text holds for a node, and what its blocks for other nodes hold."""
    parser = _parsed(text)
    others = [(name, entry.name, entry.value()) for name, block in parser.blocks.items()
              if not matches(name, node) for entry in block]
    return {name: entry.value() for name, entry in effective(parser, node).items()}, others


def _with(text: str, node: str, name: str, value: Any) -> str:
    """Return a text with one value changed or added, in the first way that changes nothing else."""
    held, others = _read(text, node)
    wanted = {**held, name: value}
    for candidate in _candidates(text, node, name, value):
        try:
            now, rest = _read(candidate, node)
        except ParameterFileError:
            continue
        if now.keys() == wanted.keys() and all(values.same(now[each], wanted[each]) for each in now) and (
                len(rest) == len(others)
                and all(one[:2] == two[:2] and values.same(one[2], two[2]) for one, two in zip(rest, others))):
            return candidate
    what = 'changed to' if name in held else 'added with the value'
    raise ParameterFileError(f'{name} of {node} cannot be {what} {values.format_value(value, 60)} without changing the '
                             f'file otherwise: change it by hand')


def _candidates(text: str, node: str, name: str, value: Any) -> Iterator[str]:
    parser = _parsed(text)
    entry = effective(parser, node).get(name)
    assignment = entry.winner() if entry is not None else None
    if assignment is not None:
        yield from _replaced(text, assignment, value)
        return
    line = f'{format_scalar(name)}: {_inline(value)}'
    starts = [start for start in parser.starts if matches(start.name, node)]
    for start in sorted(starts, key=lambda each: '*' in each.name):
        own = [each for each in parser.assignments if each.block == start.name and each.place.start > start.end.start]
        if start.first is None or not own:
            yield from _in_empty_braces(text, start.end, line)
            continue
        indented = ' ' * (start.first.column - 1) + line
        # After the block's last value, after its header, or inside its braces.
        yield _with_line(text, max(each.place.end for each in own), indented)
        yield _with_line(text, start.end.end, indented)
        yield f'{text[:start.first.start]}{line}, {text[start.first.start:]}'
    if not starts:
        end = '' if not text or text.endswith('\n') else '\n'
        yield f'{text}{end}{format_scalar(node)}:\n  {KEY}:\n    {line}\n'


def _in_empty_braces(text: str, header: Place, line: str) -> Iterator[str]:
    """Yield the text with a line below a header, or inside its braces, where these hold nothing."""
    if braces := re.compile(r'\s*:(\s*\{)(\s*\})').match(text, header.end):
        emptied = text[:braces.start(1)] + text[braces.end():]
        yield _with_line(emptied, header.end, ' ' * (header.column + 1) + line)
        yield text[:braces.end(1)] + line + text[braces.start(2):]


def _with_line(text: str, position: int, line: str) -> str:
    """Return a text with a line after the one that holds a position."""
    # At the end of a text in a block, the position is that of the next line already.
    end = text.find('\n', max(position - 1, 0))
    newline = '\r\n' if '\r\n' in text else '\n'
    return f'{text}{newline}{line}{newline}' if end < 0 else f'{text[:end + 1]}{line}{newline}{text[end + 1:]}'


def _replaced(text: str, assignment: Assignment, value: Any) -> Iterator[str]:
    """Yield the text with another value in the place of one: item by item, where that leaves comments alone."""
    old = assignment.scalars
    if isinstance(value, list) and assignment.is_array and old:
        kept = min(len(value), len(old))
        result = text
        if len(value) > len(old):
            result = _longer(result, old[-1].place, [format_scalar(item) for item in value[kept:]])
        elif len(value) < len(old):
            result = _shorter(result, old, kept)
        for scalar, item in reversed(list(zip(old, value))):
            if not values.same(scalar.value, item):
                result = _spliced(result, scalar.place, _like(text, scalar, item))
        yield result
    if not assignment.is_array and not isinstance(value, list):
        yield _spliced(text, assignment.place, _like(text, old[0], value))
    new = _inline(value)
    if comments := _comments(text, assignment.place.start, assignment.place.end, old) if assignment.is_array else []:
        new = ' '.join((new, *comments))
        line, _, _ = text[assignment.place.end:].partition('\n')
        if line.strip() and not line.lstrip().startswith('#'):
            new += '\n' + ' ' * assignment.place.column
    yield _spliced(text, assignment.place, new)
    # Items of an array may begin in the column of its name, where no other value may.
    yield _spliced(text, assignment.place, '  ' + new)


def _is_in_brackets(text: str, place: Place) -> bool:
    return not text[text.rfind('\n', 0, place.start) + 1:place.start].lstrip().startswith('- ')


def _longer(text: str, last: Place, items: list[str]) -> str:
    if _is_in_brackets(text, last):
        # Below the last item's comment, where it has one in its line.
        if rest := re.compile(r'(?:[ \t]*,)?([ \t]*#.*)').match(text, last.end):
            return _with_line(f'{text[:last.end]},{text[rest.start(1):]}', last.end,
                              ' ' * (last.column - 1) + ', '.join(items))
        return text[:last.end] + ''.join(f', {item}' for item in items) + text[last.end:]
    before = text[text.rfind('\n', 0, last.start) + 1:last.start]
    for item in reversed(items):
        text = _with_line(text, last.end, before + item)
    return text


def _shorter(text: str, old: list[Scalar], kept: int) -> str:
    """Return a text in which an array has only its first items; all comments stay."""
    if _is_in_brackets(text, old[0].place):
        gaps = [text[one.place.end:two.place.start] for one, two in zip(old[kept - 1:], old[kept:])]
        comments = '' if '#' not in ''.join(gaps) else re.sub(
            r'[ \t]*\n\s*\n', '\n', ''.join(re.sub(r'(#.*)|,', lambda match: match[1] or '', gap) for gap in gaps))
        return text[:old[kept - 1].place.end] + comments + text[old[-1].place.end:]
    begin = text.rfind('\n', 0, old[kept].place.start) + 1
    end = text.find('\n', max(old[-1].place.end - 1, 0))
    end = len(text) if end < 0 else end + 1
    indent = text[begin:old[kept].place.start].partition('-')[0]
    newline = '\r\n' if '\r\n' in text else '\n'
    return text[:begin] + ''.join(f'{indent}{comment}{newline}' for comment in _comments(text, begin, end, old[kept:])
                                  ) + text[end:]


def _comments(text: str, begin: int, end: int, scalars: list[Scalar]) -> list[str]:
    """Return the comments in a part of a text, in which these scalars stand."""
    result = []
    for scalar in scalars:
        result += _COMMENT.findall(text, begin, scalar.place.start)
        result += filter(None, [_comment_of_block(text, scalar.place)])
        begin = scalar.place.end
    return [comment.rstrip() for comment in (*result, *_COMMENT.findall(text, begin, end))]


_COMMENT = re.compile(r'#.*')
_BLOCK_HEADER = re.compile(r'(?:[!&]\S*[ \t]+)*[|>][-+0-9]*(?:[ \t]+(#.*))?\r?\n')


def _comment_of_block(text: str, place: Place) -> str:
    """Return the comment in the first line of a text in a block; nothing if there is none."""
    header = _BLOCK_HEADER.match(text, place.start, place.end)
    return ((header and header[1]) or '').rstrip()


def _spliced(text: str, place: Place, new: str) -> str:
    comment = _comment_of_block(text, place)
    # A text in a block ends with its last line break.
    old = text[place.start:place.end]
    end = old[len(old.rstrip('\r\n')):] and ('\r\n' if old.endswith('\r\n') else '\n')
    return text[:place.start] + new + (f' {comment}' if comment else '') + end + text[place.end:]


def _like(text: str, old: Scalar, value: Any) -> str:
    """Return a value as text, in quotes like those of the value that was there."""
    if isinstance(value, str) and value.isprintable():
        quote = text[old.place.start:old.place.start + 1]
        if quote == "'" or (quote == '"' and not set(value) & {'"', '\\'}):
            return quote + value.replace("'", "''" if quote == "'" else "'") + quote
    return format_scalar(value)


def _inline(value: Any) -> str:
    return f'[{", ".join(map(format_scalar, value))}]' if isinstance(value, list) else format_scalar(value)
