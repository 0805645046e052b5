"""Compare sets of parameters: a node with another node, with a file, with its defaults, or with itself earlier.

Whole systems are compared, too. A system is a mapping from node names to sets of parameters: a ``Snapshot``, or what a
file holds.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from param_tools import values
from param_tools.markup.wording import format_count
from param_tools.systems.sets import NodeLike, ParameterSet, as_set
from param_tools.systems.word_table import NodesTable

# What can be compared: a snapshot, any dictionary, or a node, which is then asked.
Comparable = Mapping[str, Any] | NodeLike
System = Mapping[str, Mapping[str, Any]]


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
            before, after = (_format_with_type(value) for value in (record.before, record.after))
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


def _format_with_type(value: Any) -> str:
    return '[] (array)' if value == [] else f'{values.format_value(value)} ({values.type_of(value).label})'
