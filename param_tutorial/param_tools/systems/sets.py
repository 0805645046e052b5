"""Sets of parameters: names and values at one moment, of a node, of a file, or the defaults of a class of nodes.

``compare`` says how two sets differ: a node and another node, a file, its defaults, or itself earlier. Values are
compared as ROS stores them: 1, 1.0 and True are three different ones, nan is equal to nan. All goes over the standard
services (see ``node.client``), so a node may be anywhere and written in any language.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.errors import InvalidValueError
from param_tools.files import parameter_files
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient
from param_tools.ros import stage
from param_tools.systems.word_table import NodesTable

NodeLike = str | Node | ParameterClient
# What can be compared: a snapshot, any dictionary, or a node, which is then asked.
Comparable = Mapping[str, Any] | NodeLike
# A Snapshot, or what a file holds.
System = Mapping[str, Mapping[str, Any]]

# Where a node for its defaults lives for a moment: another of the same name may be on the stage.
_CORNER = '/_defaults'


class ParameterSet(Mapping[str, Any]):
    """The parameters of a node at one moment, or of a file: names and values, which do not change any more."""

    def __init__(self, parameters: Mapping[str, Any], label: str = 'a set'):
        """
        :param parameters: Names and values; None for a parameter without a value.
        :param label: Says where they come from.
        :raises InvalidValueError: a name or a value can be none of a parameter.
        """
        self._parameters = {name: values.normalize(value) for name, value in parameters.items()}
        for name, value in self._parameters.items():
            if not isinstance(name, str) or not name:
                raise InvalidValueError(f'{label}: {name!r} is not a parameter name')
            try:
                values.type_of(value)
            except InvalidValueError as error:
                raise InvalidValueError(f'{label}: {name} cannot be a parameter: {error}') from None
        self.label = label

    @classmethod
    def of(cls, node: NodeLike, label: str = '') -> 'ParameterSet':
        """Take a snapshot of a node.

        :param label: By default the node's name.
        :raises ParameterToolError: as ParameterClient.get_parameters.
        """
        client = as_client(node)
        return cls(client.get_parameters(), label or client.node)

    @classmethod
    def from_file(cls, path: str | Path, node: NodeLike) -> 'ParameterSet':
        """Read what a parameter file holds for a node, by the rules of rcl's parser.

        :raises ParameterFileError: it cannot be read, or holds nothing for the node.
        """
        return cls(parameter_files.read(path, as_client(node).node), Path(path).name)

    @classmethod
    def defaults(cls, node_class: type[Node], *args: Any, **kwargs: Any) -> 'ParameterSet':
        """Find out what a node starts with when nobody overrides anything.

        No service tells it, so a fresh node is made for a moment, in a hidden namespace, and asked.

        :param node_class: Further arguments go to its constructor. What that does beside declaring is done, too.
        :raises ExecutorError: no executor is running in the background.
        """
        ros = stage.current()
        node = ros.add(node_class, *args, ros_args=['-r', f'__ns:={_CORNER}'], **kwargs)
        try:
            return cls(ParameterClient(node, executor=ros).get_parameters(), f'defaults of {node_class.__name__}')
        finally:
            ros.remove(node)

    def __getitem__(self, name: str) -> Any:
        value = self._parameters[name]
        return list(value) if isinstance(value, list) else value

    def __iter__(self) -> Iterator[str]:
        return iter(self._parameters)

    def __len__(self) -> int:
        return len(self._parameters)

    def __eq__(self, other: object) -> bool:
        """True if all names and values are the same, with their types."""
        return isinstance(other, Mapping) and self.keys() == other.keys() and all(
            values.same(value, values.normalize(other[name])) for name, value in self._parameters.items())

    __hash__ = None  # type: ignore[assignment]  # every object has one, says object; a list in it could not be hashed

    def __repr__(self) -> str:
        return f'<ParameterSet: {self.label}, {format_count(len(self), "parameter")}>'


def as_client(node: NodeLike) -> ParameterClient:
    """Return a client of a node."""
    return node if isinstance(node, ParameterClient) else ParameterClient(node)


def as_set(what: Mapping[str, Any] | NodeLike, label: str) -> ParameterSet:
    """Return a set of parameters as such; ask a node for its own.

    :param label: Of a mapping that has none.
    """
    if isinstance(what, ParameterSet):
        return what
    return ParameterSet(what, label) if isinstance(what, Mapping) else ParameterSet.of(what)


@dataclass(frozen=True)
class ChangedParameter:
    """One parameter that differs, and how."""

    name: str
    kind: str
    """'added', 'removed', 'changed value' or 'changed type'."""
    before: Any = None
    """None if it was added, or had no value."""
    after: Any = None


class Difference(NodesTable[ChangedParameter]):
    """How one node or system differs from another: false if it does not. Shown as a table."""

    def __init__(self, labels: tuple[str, str], nodes: Mapping[str, Iterable[ChangedParameter]], *, equal: int,
                 only_before: Sequence[str] = (), only_after: Sequence[str] = (), is_of_one: bool = True):
        """
        :param nodes: What differs, for each node that is in both.
        :param equal: How many parameters are the same in both.
        :param is_of_one: True if one node was compared with another.
        """
        self.columns = ('parameter', 'difference', *(labels if is_of_one else ('before', 'after')))
        super().__init__(nodes, is_of_one=is_of_one)
        self.equal = equal
        self._alone = (('removed', labels[0], only_before), ('added', labels[1], only_after))
        differing = sum(map(bool, self.nodes.values()))
        where, same = ('', f'{equal} the same') if is_of_one else (
            f' in {format_count(differing, "node")}', f'{format_count(len(self.nodes) - differing, "node")} the same')
        alone = ''.join(f', {format_count(len(names), "node")} only in {label}'
                        for _, label, names in self._alone if names)
        self.heading = (f'{labels[0]} → {labels[1]}: {format_count(len(self.records), "difference")}{where}, '
                        f'{same}{alone}')

    def __len__(self) -> int:
        return len(self.records) + sum(len(nodes) for _, _, nodes in self._alone)

    def words(self, record: ChangedParameter) -> tuple[str, ...]:
        before, after = values.format_change(record.before, record.after)
        if record.kind == 'changed type':
            before, after = (
                '[] (array)' if value == [] else f'{values.format_value(value)} ({values.type_of(value).label})'
                for value in (record.before, record.after))
        return (record.name, record.kind, '-' if record.kind == 'added' else before,
                '-' if record.kind == 'removed' else after)

    def rows(self) -> list[tuple[str, ...]]:
        return [(node, '', f'only in {label}', '', '') for _, label, nodes in self._alone for node in nodes
                ] + super().rows()


def compare(before: Comparable, after: Comparable, *, names: Iterable[str] | None = None) -> Difference:
    """Return how the second set of parameters differs from the first.

    :param before: A ParameterSet, a dictionary, or a node or its name, which is then asked.
    :param after: Likewise.
    :param names: Look only at these; a file, for example, seldom holds everything: ``names=file``.
    :raises ParameterToolError: a node does not answer.
    """
    first, second = as_set(before, 'before'), as_set(after, 'after')
    changed, equal = _changed(first, second, names)
    return Difference((first.label, second.label), {second.label: changed}, equal=equal)


def compare_systems(before: System, after: System, *, labels: tuple[str, str] = ('before', 'after'),
                    partial: bool = False) -> Difference:
    """Return how the second system differs from the first.

    :param labels: What the two are called.
    :param partial: One of them is a file that holds only some parameters: look at what is in both.
    """
    nodes, equal = {}, 0
    for node in before:
        if node in after:
            names = [name for name in before[node] if name in after[node]] if partial else None
            nodes[node], same = _changed(ParameterSet(before[node]), ParameterSet(after[node]), names)
            equal += same
    return Difference(labels, nodes, equal=equal, is_of_one=len(before) == len(nodes) == len(after) == 1,
                      only_before=() if partial else [node for node in before if node not in after],
                      only_after=() if partial else [node for node in after if node not in before])


def _changed(first: ParameterSet, second: ParameterSet, names: Iterable[str] | None
             ) -> tuple[list[ChangedParameter], int]:
    """Return what differs in two sets, and how many parameters are the same."""
    changed, equal = [], 0
    for name in dict.fromkeys((*first, *second) if names is None else names):
        before, after = first.get(name), second.get(name)
        if name not in first or name not in second:
            if name in first or name in second:
                changed.append(ChangedParameter(name, 'removed' if name in first else 'added', before, after))
        elif values.same(before, after):
            equal += 1
        else:
            kind = 'changed type' if _differ_in_type(before, after) else 'changed value'
            changed.append(ChangedParameter(name, kind, before, after))
    return changed, equal


def _differ_in_type(before: Any, after: Any) -> bool:
    if before is None or after is None:
        return False
    # An empty array tells no type, so it counts as one of the type that the other side has.
    if values.is_empty_array(before) or values.is_empty_array(after):
        return isinstance(before, list) is not isinstance(after, list)
    return values.type_of(before) is not values.type_of(after)
