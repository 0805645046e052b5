"""What stands beside ``ros__parameters`` instead of below it, which is why rcl rejects a file. No ROS, no Jupyter.

rcl notices such a line later, and for another reason than its author would name. Here the file is read as the tree
that its indentation makes of it.
"""

import difflib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby

import yaml

from param_tools.files.parsing import KEY, LOADER, Place

_SHOWN = 3

Pair = tuple[yaml.Node, yaml.Node]


@dataclass
class _Seen:
    """What was read so far of a file."""

    maps: set[int] = field(default_factory=set)
    """With an alias, a map can hold itself."""
    empty: list[tuple[int, int]] = field(default_factory=list)
    """The headers with nothing below them: rcl takes the empty value for one without a name."""


@dataclass(frozen=True)
class Misplaced:
    """Some keys, one after the other, that stand in the wrong place."""

    place: Place
    message: str
    spans: tuple[tuple[int, int], ...]
    """From where to where, in characters, rcl's rejections have their cause here."""
    is_certain: bool = True
    """rcl rejects it anywhere, and not only with what stands there after it."""

    def explains(self, place: Place) -> bool:
        """True if rcl rejects what stands at a place because of this."""
        return any(first <= place.start <= last for first, last in self.spans)


def misplaced(content: bytes) -> list[Misplaced]:
    """Return what stands in the wrong place, in the order of the file; nothing for what is not YAML."""
    try:
        root = yaml.compose(content, Loader=LOADER)
        return list(_in_map(root, '', _Seen()))
    except (yaml.YAMLError, RecursionError):
        return []


def misspelled(keys: Iterable[tuple[str, Place]]) -> tuple[Place, str] | None:
    """Return where a key was probably meant to be ``ros__parameters``, and what to say of it."""
    return next(((place, f'{name!r} should be {KEY!r}') for name, place in keys if _is_like_header(name)), None)


def _is_like_header(name: str) -> bool:
    return name != KEY and difflib.SequenceMatcher(None, name.lower(), KEY).ratio() > 0.75


def _in_map(tree: yaml.Node | None, node: str, seen: _Seen) -> Iterator[Misplaced]:
    """Yield what stands in the wrong place in a map above the parameters.

    :param node: The keys that lead to the map, with slashes.
    """
    if not isinstance(tree, yaml.MappingNode) or id(tree) in seen.maps:
        return
    seen.maps.add(id(tree))
    headers = [pair for pair in tree.value if _name(pair[0]).startswith(KEY)]
    seen.empty += [_span((value, value)) for _, value in headers
                   if isinstance(value, yaml.ScalarNode) and not value.value]
    for _, parameters in headers:
        yield from _empty_maps(parameters, parameters.end_mark.index, seen)
    if len(headers) > 1:
        yield Misplaced(_place(headers[1]), f'{KEY!r} stands in line {_place(headers[0]).line} already: rcl rejects a '
                                            f'second one. Put its parameters below the first',
                        tuple(map(_span, headers[1:])))
    is_after = False
    for kind, group in groupby(tree.value, lambda pair: _kind(pair, has_header=bool(headers))):
        pairs: list[Pair] = list(group)
        if kind == 'header':
            is_after = True
        elif kind == 'node' and headers and is_after:
            yield _nested(pairs, node)
        elif kind == 'node':
            for key, value in pairs:
                yield from _in_map(value, f'{node}/{_name(key).strip("/")}', seen)
            is_after = is_after or not headers
        elif kind == 'parameter' and (headers or is_after):
            yield _beside(pairs, seen, is_beside=bool(headers), is_after=is_after)


def _empty_maps(parameters: yaml.Node, end: int, seen: _Seen) -> Iterator[Misplaced]:
    """Yield the parameters that are an empty map: rcl takes its end for that of the map around it."""
    if not isinstance(parameters, yaml.MappingNode) or id(parameters) in seen.maps:
        return
    seen.maps.add(id(parameters))
    for key, value in parameters.value:
        if isinstance(value, yaml.MappingNode) and not value.value:
            message = (f'{_name(key)} is an empty map, and rcl takes its end for that of the parameters around it: rcl '
                       f'rejects the file. Remove this line')
            yield Misplaced(_place((key, value)), message, ((key.start_mark.index, end),), is_certain=False)
        else:
            yield from _empty_maps(value, end, seen)


def _kind(pair: Pair, *, has_header: bool) -> str:
    """Return what a key above the parameters is: 'header', 'node', 'parameter', or 'unclear'.

    :param has_header: ``ros__parameters`` is in the same map. Elsewhere, a map without it is rather a node that lacks
        it.
    """
    name = _name(pair[0])
    if name.startswith(KEY):
        return 'header'
    if _holds_header(pair[1], set()):
        return 'node'
    is_map = isinstance(pair[1], yaml.MappingNode)
    is_clear = (has_header or not is_map) and not _is_like_header(name) and not (
        is_map and any(_is_like_header(_name(key)) for key, _ in pair[1].value))
    return 'parameter' if is_clear else 'unclear'


def _holds_header(tree: yaml.Node, seen: set[int]) -> bool:
    if not isinstance(tree, yaml.MappingNode) or id(tree) in seen:
        return False
    seen.add(id(tree))
    return any(_name(key).startswith(KEY) or _holds_header(value, seen) for key, value in tree.value)


def _beside(pairs: Sequence[Pair], seen: _Seen, *, is_beside: bool, is_after: bool) -> Misplaced:
    one = len(pairs) == 1
    remedy = f'Indent {"this line" if one else "these lines"}'
    if not is_after:
        remedy = f'Move {"it" if one else "them"} below {KEY}, and indent {"it" if one else "them"}'
    where = 'beside' if is_beside else 'left of'
    return Misplaced(_place(pairs[0]), f'{_listed(pairs)} {"stands" if one else "stand"} {where} {KEY!r}, not below '
                                       f'it: rcl rejects the file. {remedy}', (*map(_span, pairs), *seen.empty))


def _nested(pairs: Sequence[Pair], node: str) -> Misplaced:
    one = len(pairs) == 1
    name = f'{node}/{_name(pairs[0][0]).strip("/")}'
    return Misplaced(_place(pairs[0]), f'{_listed(pairs)} {"is a node" if one else "are nodes"} inside {node}, and rcl '
                                       f'rejects a node after the {KEY!r} of the block that it is in. Put it before '
                                       f'that, or write "{name}:" at the left edge', tuple(map(_span, pairs)))


def _listed(pairs: Sequence[Pair]) -> str:
    names = [_name(key) for key, _ in pairs]
    if len(names) > _SHOWN:
        return f'{", ".join(names[:_SHOWN])} and {len(names) - _SHOWN} more'
    return ' and '.join(filter(None, (', '.join(names[:-1]), names[-1])))


def _name(key: yaml.Node) -> str:
    return key.value if isinstance(key, yaml.ScalarNode) else ''


def _place(pair: Pair) -> Place:
    mark = pair[0].start_mark
    return Place(mark.line + 1, mark.column + 1, mark.index, pair[0].end_mark.index)


def _span(pair: Pair) -> tuple[int, int]:
    return pair[0].start_mark.index, pair[1].end_mark.index
