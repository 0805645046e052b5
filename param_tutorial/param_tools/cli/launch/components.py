"""What a component gets of its parameters: launch_ros reads the files itself, with PyYAML, and sends the values.

Three things differ from a node that reads its files with rcl: PyYAML's types (``1e-3`` is a text), a file without
``ros__parameters`` is taken as it is, and of the blocks launch_ros knows ``/**`` and the exact name, in this order.
A container's own files do not reach its components: rclcpp creates them without the global arguments.
"""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from param_tools.cli.launch.context import Context, LaunchFailed, Origin
from param_tools.cli.launch.parameters import flat
from param_tools.files.parsing import KEY, matches


class _Map(dict[Any, Any]):
    """A map of a file, with the line of each key."""

    lines: dict[Any, int]


class _Loader(yaml.SafeLoader):
    """Reads as ``yaml.safe_load`` does."""


def _map(loader: _Loader, node: yaml.MappingNode) -> Iterator[_Map]:
    found = _Map()
    yield found
    found.update(loader.construct_mapping(node))
    found.lines = {loader.construct_object(key): key.start_mark.line + 1 for key, _ in node.value}


_Loader.add_constructor('tag:yaml.org,2002:map', _map)


def words_of_values(values: Mapping[str, Any], origin: Origin | None, context: Context) -> list[str]:
    """Write values as a parameter file of which rcl makes the same, and return the words that give it to a node."""
    # True after an integer is one. All texts are in quotes.
    values = {name: [*map(type(found[0]), found)] if isinstance(found, (list, tuple)) else found
              for name, found in values.items()}
    text = json.dumps({'/**': {KEY: values}}, ensure_ascii=False, indent=1)
    return ['--params-file', str(context.write(text, origin))] if values else []


def words_of_file(path: Path, name: str | None, namespace: str | None, context: Context) -> list[str]:
    """Return the words that give a node what a component of this name gets of a file."""
    own = '/'.join((*(namespace or '').strip('/').split('/'), name or '')).lstrip('/')
    above = context.origins.get(str(path), Origin(path, None, is_filled_in=False))
    try:
        content = yaml.load(path.read_text(encoding='utf-8'), _Loader)
        blocks = {found: (line, below) for found, line, below in _blocks(content, (), 0)}
        if own in blocks and None in (blocks[own][1], blocks.get('**', blocks[own])[1]):
            raise ValueError(f'nothing is below {KEY}')
    except (ValueError, AttributeError, yaml.YAMLError) as error:
        mark = getattr(error, 'problem_mark', None)
        _warn(context, above, mark and mark.line + 1,
              f"launch reads a component's file with PyYAML, and ends: {getattr(error, 'problem', error)}")
        return []
    chosen = _Map()
    chosen.lines = {}
    for block in [blocks[each][1] for each in ('**', own) if each in blocks] if blocks else [content]:
        # Nothing is below the header.
        if block is not None:
            chosen.update(block)
            chosen.lines |= block.lines
    for block, (line, _) in blocks.items():
        if block not in ('**', own) and name is not None and matches(block, f'/{own}'):
            _warn(context, above, line, f'launch ignores this block for /{own}: of a file of a component it reads only '
                                        f'"/**" and the exact name; write "/{own}:"', 'never matched')
    if blocks and not chosen and name is None:
        _warn(context, above, None, 'launch gives a component without name= nothing of this file: without a name it '
                                    'reads only the block "/**"; give the component its name', 'never matched')
    values: dict[str, Any] = {}
    for key, value in chosen.items():
        try:
            values |= flat({key: value}, context)
        except LaunchFailed as error:
            _warn(context, above, chosen.lines[key], f"launch reads a component's file with PyYAML, and ends: {error}")
    return words_of_values(values, above._replace(lines=dict(_lines(chosen, ''))), context)


def _blocks(content: _Map, keys: tuple[str, ...], line: int) -> Iterator[tuple[str, int, _Map]]:
    """Return the blocks of a file: their names as launch_ros writes them, their lines and what is in them."""
    for key, value in content.items():
        if key == KEY:
            yield '/'.join(keys), line, value
            return
        if isinstance(value, _Map):
            yield from _blocks(value, (*keys, key.lstrip('/')), content.lines[key])


def _lines(content: _Map, prefix: str) -> Iterator[tuple[str, int]]:
    for key, value in content.items():
        if isinstance(value, _Map):
            yield from _lines(value, f'{prefix}{key}.')
        else:
            yield f'{prefix}{key}', content.lines[key]


def _warn(context: Context, origin: Origin, line: int | None, text: str, kind: str = 'unreadable') -> None:
    context.warn(text, origin._replace(line=line or 0), kind)
