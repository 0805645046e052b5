"""Compare and restore sets of parameters: node with node, with file, with defaults, now with then.

A ParameterSet holds names and values at one moment. ``compare`` tells how two of them differ, ``restore`` gives a node
the values of one, in a single request, and tells what became of each. ParameterHistory undoes and redoes. All goes
over the standard services (see ``client``), so a node may be anywhere and written in any language.

Values are compared as ROS stores them: 1, 1.0 and True are three different ones, nan is equal to nan. An empty array
tells no type, so it counts as one of the type that the other side has.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rclpy.node import Node

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import InvalidValueError
from param_tools.files import parameter_files
from param_tools.files.descriptions import DescribedParameter
from param_tools.markup.styles import style
from param_tools.markup.tables import table
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient
from param_tools.ros import stage

NodeLike = str | Node | ParameterClient
# What can be compared: a snapshot, any dictionary, or a node, which is then asked.
Comparable = Mapping[str, Any] | NodeLike

# Where a node for its defaults lives for a moment: another of the same name may be on the stage.
_CORNER = '/_defaults'

_STYLE = style('param_tools/systems/sets.css')

MAY_BE_TAKEN = 'the node has not declared it, and no service tells whether it would take it all the same'
"""What a preview says of such a parameter: a node may allow undeclared ones."""


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
        return isinstance(other, Mapping) and not compare(self, other)

    __hash__ = None  # type: ignore[assignment]  # every object has one, says object; a list in it could not be hashed

    def __repr__(self) -> str:
        return f'<ParameterSet: {self.label}, {format_count(len(self), "parameter")}>'


class WordTable:
    """Rows of words, as text and as HTML."""

    heading = ''
    columns: tuple[str, ...] = ()

    def rows(self) -> list[tuple[str, ...]]:
        """Return the words of each row."""
        raise NotImplementedError

    def __repr__(self) -> str:
        # A node's reason may have several lines, and a row has one.
        rows = [[' '.join(word.splitlines()) for word in row] for row in self.rows()]
        if not rows:
            return self.heading
        widths = [max(map(len, column)) for column in zip(self.columns, *rows)]
        lines = ['  '.join(f'{word:{width}}' for word, width in zip(row, widths)).rstrip()
                 for row in (self.columns, *rows)]
        return '\n'.join([self.heading, '', *lines])

    def _repr_html_(self) -> str:
        rows = self.rows()
        return _STYLE + table(self.columns if rows else (), rows, css_class='param-set', caption=self.heading,
                              row_headers=True)


@dataclass(frozen=True)
class Change:
    """How one parameter differs."""

    name: str
    kind: str
    """'added', 'removed', 'changed value' or 'changed type'."""
    before: Any = None
    """None if it was added, or had no value."""
    after: Any = None


class Difference(WordTable):
    """How one set of parameters differs from another: false if it does not. Shown as a table."""

    def __init__(self, before: ParameterSet, after: ParameterSet, changes: Iterable[Change], equal: int):
        """
        :param changes: What differs, in the order of the table.
        :param equal: How many parameters are the same in both.
        """
        self.changes = tuple(changes)
        self.equal = equal
        self.heading = (f'{before.label} → {after.label}: '
                        f'{format_count(len(self.changes), "difference")}, {equal} the same')
        self.columns = ('parameter', 'difference', before.label, after.label)

    def __len__(self) -> int:
        return len(self.changes)

    def __iter__(self) -> Iterator[Change]:
        return iter(self.changes)

    def __getitem__(self, name: str) -> Change:
        """Return the change of one parameter.

        :raises KeyError: it is the same in both, or in neither.
        """
        for change in self.changes:
            if change.name == name:
                return change
        raise KeyError(name)

    def rows(self) -> list[tuple[str, ...]]:
        rows: list[tuple[str, ...]] = []
        for change in self.changes:
            before, after = _format_pair(change.before, change.after, change.kind)
            rows.append((change.name, change.kind, '-' if change.kind == 'added' else before,
                         '-' if change.kind == 'removed' else after))
        return rows


def compare(before: Comparable, after: Comparable, *, names: Iterable[str] | None = None) -> Difference:
    """Return how the second set of parameters differs from the first.

    :param before: A ParameterSet, a dictionary, or a node or its name, which is then asked.
    :param after: Likewise.
    :param names: Look only at these; a file, for example, seldom holds everything: ``names=file``.
    :raises ParameterToolError: a node does not answer.
    """
    first, second = _as_set(before, 'before'), _as_set(after, 'after')
    wanted = dict.fromkeys((*first, *second) if names is None else names)
    changes = [change for name in wanted if (change := _change(name, first, second))]
    equal = sum(name in first and name in second for name in wanted) - sum(
        change.kind.startswith('changed') for change in changes)
    return Difference(first, second, changes, equal)


def _change(name: str, first: ParameterSet, second: ParameterSet) -> Change | None:
    if name not in first:
        return Change(name, 'added', after=second[name]) if name in second else None
    if name not in second:
        return Change(name, 'removed', before=first[name])
    before, after = first[name], second[name]
    if values.same(before, after):
        return None
    return Change(name, 'changed type' if _differ_in_type(before, after) else 'changed value', before, after)


def _differ_in_type(before: Any, after: Any) -> bool:
    if before is None or after is None:
        return False
    if values.is_empty_array(before) or values.is_empty_array(after):
        return isinstance(before, list) is not isinstance(after, list)
    return values.type_of(before) is not values.type_of(after)


# -- restoring ------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Outcome:
    """What became of one parameter that was to be restored."""

    name: str
    wanted: Any
    word: str
    """'set', 'left' (because others of the same request were rejected), or why not: 'read only', 'wrong type',
    'not declared', 'no value', 'rejected', or 'not kept' by the node, which accepted and stored something else."""
    reason: str = ''


def how_it_ended(outcomes: Sequence[Outcome], *, have_all_answered: bool = True) -> str:
    """Return what became of parameters that were to be restored, in a few words.

    :param have_all_answered: False if there are more of them, in nodes that have not answered.
    """
    words = [outcome.word for outcome in outcomes]
    done, total = words.count('set'), format_count(len(words), 'parameter')
    if have_all_answered and done == len(words):
        return f'complete, {total} set' if words else 'nothing to do, all values are there'
    if done or 'not kept' in words or not have_all_answered:
        return f'NOT COMPLETE, {done} of {total} set' if words else 'NOT COMPLETE'
    return 'NOT RESTORED, nothing was changed'


class Restored(WordTable):
    """What became of the parameters of a node that differed from a set. Shown as a table."""

    columns = ('parameter', 'wanted', 'outcome', 'reason')

    def __init__(self, node: str, wanted: ParameterSet, outcomes: Iterable[Outcome]):
        """
        :param node: Fully qualified name.
        :param outcomes: One for each parameter that differed.
        """
        self.outcomes = tuple(outcomes)
        self.complete = all(outcome.word == 'set' for outcome in self.outcomes)
        """True if the node now holds all the values of the set."""
        self.heading = f'{node} from {wanted.label}: {how_it_ended(self.outcomes)}'

    def __iter__(self) -> Iterator[Outcome]:
        return iter(self.outcomes)

    def __getitem__(self, name: str) -> Outcome:
        """Return the outcome for one parameter.

        :raises KeyError: it did not differ, so nothing was done.
        """
        for outcome in self.outcomes:
            if outcome.name == name:
                return outcome
        raise KeyError(name)

    def rows(self) -> list[tuple[str, ...]]:
        return [(each.name, _format(each.wanted), each.word, each.reason) for each in self.outcomes]


def restore(node: NodeLike, wanted: Mapping[str, Any], *, one_by_one: bool = False,
            skip_read_only: bool = False) -> Restored:
    """Give a node the values of a set, as far as they differ from what it has.

    What no service can change (read-only parameters, types, parameters that are not declared) is left out and
    reported. The rest is set in one request, atomically: if the node rejects one, none is changed. Parameters that
    only the node has are left alone.

    :param wanted: A ParameterSet or dictionary.
    :param one_by_one: If the node rejects the request, try each parameter for itself, again and again as long as that
        helps: rules across parameters may allow in one order what they reject in another.
    :param skip_read_only: Pass over read-only parameters without a word; the rest can then be complete.
    :raises ParameterToolError: the node does not answer; whether it was changed is then not known.
    """
    client = as_client(node)
    target = _as_set(wanted, 'given values')
    present = client.get_parameters()
    differing = [name for name in target if not (name in present and values.same(present[name], target[name]))]
    descriptors = client.describe_parameters([name for name in differing if name in present])
    if skip_read_only:
        differing = [name for name in differing if not (name in descriptors and descriptors[name].read_only)]
    obstacles = {name: _obstacle(name, target[name], descriptors.get(name)) for name in differing}
    new = {name: target[name] for name, obstacle in obstacles.items() if obstacle is None}
    outcomes: dict[str, Outcome] = {}
    if new:
        outcomes = _set(client, new, one_by_one)
        held = client.get_parameters()
        for name, outcome in outcomes.items():
            if outcome.word == 'set' and not values.same(held.get(name), target[name]):
                outcomes[name] = Outcome(name, target[name], 'not kept', f'the node holds {_format(held.get(name))}')
    return Restored(client.node, target, [obstacles[name] or outcomes[name] for name in differing])


@dataclass(frozen=True)
class Expectation:
    """What restoring would do to one parameter, as far as its descriptor tells."""

    name: str
    present: Any
    """None if the node has no such parameter, or it has no value."""
    wanted: Any
    word: str
    """'would be set', or why not: as in Outcome, or 'out of range' or 'off the step'."""
    reason: str = ''


class Preview(WordTable):
    """What restoring would do, before it is done. The node's own callbacks may still reject. Shown as a table."""

    columns = ('parameter', 'present', 'wanted', 'expected', 'reason')

    def __init__(self, node: str, wanted: ParameterSet, expectations: Iterable[Expectation]):
        """
        :param node: Fully qualified name.
        :param expectations: One for each parameter that differs.
        """
        self.expectations = tuple(expectations)
        self.settable = sum(each.word == 'would be set' for each in self.expectations)
        """How many would be set."""
        self.heading = (f'{node} from {wanted.label}: {format_count(len(self.expectations), "difference")}, '
                        f'{self.settable} would be set')

    def __iter__(self) -> Iterator[Expectation]:
        return iter(self.expectations)

    def __len__(self) -> int:
        return len(self.expectations)

    def rows(self) -> list[tuple[str, ...]]:
        return [(each.name, *_format_pair(each.present, each.wanted), each.word, each.reason)
                for each in self.expectations]


def preview(node: NodeLike, wanted: Mapping[str, Any]) -> Preview:
    """Find out what ``restore`` would do, and change nothing.

    :param wanted: A ParameterSet or dictionary.
    :raises ParameterToolError: the node does not answer.
    """
    client = as_client(node)
    target = _as_set(wanted, 'given values')
    present = client.get_parameters()
    differing = [name for name in target if not (name in present and values.same(present[name], target[name]))]
    descriptors = client.describe_parameters([name for name in differing if name in present])

    def expected(name: str) -> Expectation:
        value = target[name]
        obstacle = _obstacle(name, value, descriptors.get(name))
        if obstacle is None and (objection := DescribedParameter(descriptors[name]).objection(value)):
            obstacle = Outcome(name, value, objection.kind, objection.reason)
        word, reason = (obstacle.word, obstacle.reason) if obstacle else ('would be set', '')
        if name not in descriptors:
            reason = MAY_BE_TAKEN
        return Expectation(name, present.get(name), value, word, reason)

    return Preview(client.node, target, map(expected, differing))


def _obstacle(name: str, value: Any, descriptor: Descriptor | None) -> Outcome | None:
    """Return why no request can set a parameter to a value; None if there is no such reason."""
    if descriptor is None:
        return Outcome(name, value, 'not declared', 'the node has no parameter of that name')
    if descriptor.read_only:
        return Outcome(name, value, 'read only', 'only an override at its start can set it')
    if value is None:
        return Outcome(name, value, 'no value', 'no request can take the value away and leave the parameter')
    if descriptor.dynamic_typing:
        return None
    fits = descriptor.type.is_array if values.is_empty_array(value) else descriptor.type.accepts(value)
    return None if fits else Outcome(name, value, 'wrong type',
                                     f'it is of type {descriptor.type.label}, not {values.type_of(value).label}')


def _set(client: ParameterClient, new: Mapping[str, Any], one_by_one: bool) -> dict[str, Outcome]:
    results = client.set_parameters_atomically(new)
    if results.successful:
        return {name: Outcome(name, value, 'set') for name, value in new.items()}
    reason = results[0].reason
    if not one_by_one:
        if len(new) == 1:
            return {name: Outcome(name, value, 'rejected', reason) for name, value in new.items()}
        # The one reason of an atomic request names the culprit, or it does not; all are in the same boat.
        return {name: Outcome(name, value, 'left', f'the node rejected them together: {reason}')
                for name, value in new.items()}
    outcomes: dict[str, Outcome] = {}
    missing = dict(new)
    while missing:
        answers = client.set_parameters(missing)
        outcomes |= {each.name: Outcome(each.name, each.value, 'set') if each.successful else
                     Outcome(each.name, each.value, 'rejected', each.reason) for each in answers}
        if not any(each.successful for each in answers):
            break
        missing = {each.name: each.value for each in answers if not each.successful}
    return outcomes


def as_client(node: NodeLike) -> ParameterClient:
    return node if isinstance(node, ParameterClient) else ParameterClient(node)


def _as_set(what: Comparable, label: str) -> ParameterSet:
    if isinstance(what, ParameterSet):
        return what
    return ParameterSet(what, label) if isinstance(what, Mapping) else ParameterSet.of(what)


def _format(value: Any) -> str:
    return 'not set' if value is None else values.format_value(value)


def _format_pair(before: Any, after: Any, kind: str = '') -> tuple[str, str]:
    """Return two values as text, with their types where that matters."""
    if kind == 'changed type':
        first, second = ('[] (array)' if value == [] else f'{_format(value)} ({values.type_of(value).label})'
                         for value in (before, after))
        return first, second
    return values.format_change(before, after)
