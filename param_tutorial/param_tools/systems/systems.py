"""Compare whole systems: the parameters of many nodes with those of as many others, earlier, elsewhere or in a file.

A system is a mapping from node names to sets of parameters: a ``Snapshot``, what a file holds, the defaults of
descriptions, or a robot, whose nodes are in one namespace and are compared by the rest of their names.
"""

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from param_tools.errors import NodeError, NodeGoneError, NodeNotFoundError
from param_tools.files.descriptions import Descriptions
from param_tools.markup.styles import style
from param_tools.markup.tables import Row, grouped_table
from param_tools.markup.wording import format_count
from param_tools.systems.sets import (
    Change,
    Difference,
    ParameterSet,
    Preview,
    Restored,
    WordTable,
    compare,
    how_it_ended,
)

_STYLE = style('param_tools/systems/sets.css')
System = Mapping[str, Mapping[str, Any]]


@dataclass(frozen=True)
class NodeChange:
    """How one parameter of one node differs."""

    node: str
    change: Change


class SystemDifference(WordTable):
    """How one system differs from another: false if it does not. Shown as a table, grouped by node."""

    columns = ('node', 'parameter', 'difference', 'before', 'after')

    def __init__(self, before: str, after: str, differences: Mapping[str, Difference], *,
                 only_before: Iterable[str] = (), only_after: Iterable[str] = ()):
        """
        :param before: What the first system is called.
        :param after: What the second one is called.
        :param differences: For each node that is in both.
        """
        self.before, self.after = before, after
        self.only_before, self.only_after = tuple(only_before), tuple(only_after)
        """The nodes that are in one of them only."""
        self.differences = {node: each for node, each in differences.items() if each}
        """The nodes that differ."""
        self.same = tuple(node for node, each in differences.items() if not each)
        """The nodes that do not."""
        count = sum(map(len, self.differences.values()))
        self._count = count + len(self.only_before) + len(self.only_after)
        alone = ''.join(f', {format_count(len(nodes), "node")} only in {side}'
                        for nodes, side in ((self.only_before, before), (self.only_after, after)) if nodes)
        self.heading = (f'{before} → {after}: {format_count(count, "difference")} in '
                        f'{format_count(len(self.differences), "node")}, {len(self.same)} the same{alone}')

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[NodeChange]:
        return (NodeChange(node, change) for node, each in self.differences.items() for change in each)

    def __getitem__(self, node: str) -> Difference:
        """Return how one node differs.

        :raises KeyError: it does not, or is not in both.
        """
        return self.differences[node]

    def as_json(self) -> str:
        """Return a list of objects: node, parameter, kind, before, after."""
        alone = [{'node': node, 'kind': kind} for kind, nodes in (('removed', self.only_before),
                                                                  ('added', self.only_after)) for node in nodes]
        rows = [{'node': each.node, 'parameter': each.change.name, 'kind': each.change.kind,
                 'before': _plain(each.change.before), 'after': _plain(each.change.after)} for each in self]
        return json.dumps([*alone, *rows], indent=2)

    def _groups(self) -> dict[str, list[Row]]:
        groups: dict[str, list[Row]] = {node: [('', f'only in {self.before}', '', '')] for node in self.only_before}
        groups |= {node: [('', f'only in {self.after}', '', '')] for node in self.only_after}
        return groups | {node: list(each.rows()) for node, each in self.differences.items()}

    def rows(self) -> list[tuple[str, ...]]:
        return [(node, *row) for node, rows in self._groups().items() for row in rows]

    def _repr_html_(self) -> str:
        groups = self._groups()
        return _STYLE + grouped_table(self.columns if groups else (), groups, css_class='param-set',
                                      caption=self.heading)


class SystemRestored(WordTable):
    """What became of the parameters of many nodes that differed from a set. Shown as one table."""

    columns = ('node', *Restored.columns)

    def __init__(self, label: str, nodes: Mapping[str, Restored], unanswered: Mapping[str, NodeError]):
        """
        :param label: Where the values come from.
        :param nodes: What became of each node that has answered.
        :param unanswered: The other nodes, and why; whether they were changed is not known.
        """
        self.nodes, self.unanswered = dict(nodes), dict(unanswered)
        self.complete = not unanswered and all(each.complete for each in nodes.values())
        """True if all nodes now hold their values of the set."""
        result = how_it_ended([outcome for each in nodes.values() for outcome in each],
                              have_all_answered=not unanswered)
        missing = f', {len(unanswered)} without an answer' if unanswered else ''
        self.heading = f'{format_count(len(nodes) + len(unanswered), "node")} from {label}: {result}{missing}'

    def rows(self) -> list[tuple[str, ...]]:
        changed = [(node, *row) for node, each in self.nodes.items() for row in each.rows()]
        return changed + [(node, '', '', _why_unanswered(error), '') for node, error in self.unanswered.items()]


class SystemPreview(WordTable):
    """What restoring many nodes would do, before it is done. Shown as one table."""

    columns = ('node', *Preview.columns)

    def __init__(self, label: str, nodes: Mapping[str, Preview], unanswered: Mapping[str, NodeError]):
        """
        :param label: Where the values come from.
        :param nodes: What would become of each node that has answered.
        :param unanswered: The other nodes, and why.
        """
        self.nodes, self.unanswered = dict(nodes), dict(unanswered)
        count = sum(map(len, self.nodes.values()))
        will = sum(each.settable for each in self.nodes.values())
        missing = f', {len(unanswered)} without an answer' if unanswered else ''
        self.heading = (f'{format_count(len(nodes) + len(unanswered), "node")} from {label}: '
                        f'{format_count(count, "difference")}, {will} would be set{missing}')

    def rows(self) -> list[tuple[str, ...]]:
        rows = [(node, *row) for node, each in self.nodes.items() for row in each.rows()]
        return rows + [(node, '', '', '', _why_unanswered(error), '') for node, error in self.unanswered.items()]


def _why_unanswered(error: NodeError) -> str:
    """Return why a node gave no answer, in two words."""
    return ('not there' if isinstance(error, NodeNotFoundError) else
            'gone' if isinstance(error, NodeGoneError) else 'no answer')


def _plain(value: Any) -> Any:
    if isinstance(value, list):
        return [_plain(item) for item in value]
    if isinstance(value, bytes):
        return value[0]
    # JSON has no words for these, and Python would write some that no other program reads.
    return repr(value) if isinstance(value, float) and not math.isfinite(value) else value


def compare_systems(before: System, after: System, *, labels: tuple[str, str] = ('before', 'after'),
                    partial: bool = False) -> SystemDifference:
    """Return how the second system differs from the first.

    :param labels: What the two are called.
    :param partial: One of them is a file or a schema that holds only some parameters: look at what is in both.
    """
    common = [node for node in before if node in after]
    names = {node: [name for name in before[node] if name in after[node]] if partial else None for node in common}
    differences = {
        node: compare(ParameterSet(before[node], labels[0]), ParameterSet(after[node], labels[1]), names=names[node])
        for node in common}
    return SystemDifference(*labels, differences,
                            only_before=() if partial else [node for node in before if node not in after],
                            only_after=() if partial else [node for node in after if node not in before])


def of_robot(system: System, namespace: str) -> dict[str, Mapping[str, Any]]:
    """Return the nodes of a robot by their names below its namespace, to compare it with another.

    :param namespace: As in ``/robot1``.
    """
    prefix = '/' + namespace.strip('/')
    return {node.removeprefix(prefix): parameters for node, parameters in system.items()
            if node.startswith(prefix + '/')}


def defaults_of(descriptions: Descriptions) -> dict[str, ParameterSet]:
    """Return the default values in descriptions, by node; a parameter without one is left out."""
    return {node: ParameterSet({name: each.default for name, each in description.parameters.items()
                                if each.default is not None}, description.defaults_from)
            for node, description in descriptions.items()}
