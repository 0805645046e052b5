"""Give nodes the values of sets of parameters, in one request for each, and say what became of every value.

A set may come from a snapshot, a file or another node.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import NodeError, NodeGoneError, NodeNotFoundError
from param_tools.files.descriptions import DescribedParameter
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.sets import NodeLike, ParameterSet, as_client, as_set
from param_tools.systems.snapshot import ask_all
from param_tools.systems.word_table import NodesTable


@dataclass(frozen=True)
class Outcome:
    """What became of one parameter that differed from a set."""

    name: str
    wanted: Any
    word: str
    """'set'; 'left' because others of the same request were rejected; or why not: 'read only', 'wrong type',
    'not declared', 'no value', 'rejected', and 'not kept' by a node that accepted the value and stored something else.
    Of a rehearsal: 'would be set', 'out of range' or 'off the step'."""
    reason: str = ''


class Restored(NodesTable[Outcome]):
    """What became of the parameters, of one node or of several, that differed from a set. Shown as a table.

    Whether a node that has not answered was changed is not known.
    """

    columns = ('parameter', 'wanted', 'outcome', 'reason')

    def __init__(self, label: str, nodes: Mapping[str, tuple[Outcome, ...]],
                 unanswered: Mapping[str, NodeError] | None = None, *, is_rehearsal: bool = False):
        """
        :param nodes: The outcomes for each node that has answered; the others are in ``unanswered``.
        :param is_rehearsal: Nothing was set.
        """
        self.unanswered = dict(unanswered or {})
        super().__init__(nodes, is_of_one=len(nodes) == 1 and not unanswered)
        self._is_rehearsal = is_rehearsal
        whose = next(iter(nodes)) if self.is_of_one else format_count(len(nodes) + len(self.unanswered), 'node')
        missing = f', {len(self.unanswered)} without an answer' if unanswered else ''
        self.heading = f'{whose} from {label}: {self._summary()}{missing}'

    @property
    def complete(self) -> bool:
        """True if all nodes now hold all their values of the set, or would after a rehearsal."""
        word = 'would be set' if self._is_rehearsal else 'set'
        return not self.unanswered and all(each.word == word for each in self)

    def words(self, record: Outcome) -> tuple[str, ...]:
        return record.name, _format(record.wanted), record.word, record.reason

    def rows(self) -> list[tuple[str, ...]]:
        return super().rows() + [(node, '', '', _why_unanswered(error), '') for node, error in self.unanswered.items()]

    def _summary(self) -> str:
        total = format_count(len(self), 'parameter')
        if self._is_rehearsal:
            return f'{sum(each.word == "would be set" for each in self)} of {total} would be set'
        done = sum(each.word == 'set' for each in self)
        if self.complete:
            return f'complete, {total} set' if done else 'nothing to do, all values are there'
        if done or any(each.word == 'not kept' for each in self) or self.unanswered:
            return f'NOT COMPLETE, {done} of {total} set' if self.records else 'NOT COMPLETE'
        return 'NOT RESTORED, nothing was changed'


def restore(node: NodeLike, wanted: Mapping[str, Any], *, rehearse: bool = False) -> Restored:
    """Give a node the values of a set, as far as they differ from what it has.

    What no service can change (read-only parameters, types, parameters that are not declared) is left out and
    reported. The rest is set in one request, atomically: if the node rejects one, none is changed. Parameters that
    only the node has are left alone.

    :param rehearse: Only say what would be set. The node's own callbacks may still reject it.
    :raises ParameterToolError: the node does not answer; whether it was changed is then not known.
    """
    client, target = as_client(node), as_set(wanted, 'given values')
    present = client.get_parameters()
    differing = [name for name in target if not values.holds(present, name, target[name])]
    descriptors = client.describe_parameters([name for name in differing if name in present])
    verdicts = {name: _obstacle(target[name], descriptors.get(name)) for name in differing}
    new = {name: target[name] for name, obstacle in verdicts.items() if obstacle is None}
    if rehearse:
        verdicts |= {name: _expected(value, descriptors[name]) for name, value in new.items()}
    elif new:
        verdicts |= _set(client, new)
        held = client.get_parameters()
        for name, value in new.items():
            if verdicts[name] == _SET and not values.same(held.get(name), value):
                verdicts[name] = ('not kept', f'the node holds {_format(held.get(name))}')
    return Restored(target.label, {client.node: tuple(
        Outcome(name, target[name], *verdict) for name, verdict in verdicts.items() if verdict)}, is_rehearsal=rehearse)


def restore_all(wanted: Mapping[str, Mapping[str, Any]], label: str, *, rehearse: bool = False,
                timeout_sec: float = TIMEOUT_SEC, executor: BackgroundExecutor | None = None) -> Restored:
    """Give many nodes values, all nodes at the same time, and each as ``restore`` does.

    :param wanted: The values for each node, such as a Snapshot.
    :param label: Says where the values come from.
    :param timeout_sec: How long a node may take for each answer. A node that takes longer is in ``unanswered``.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    outcomes, unanswered = ask_all(
        wanted, lambda client: restore(client, ParameterSet(wanted[client.node], label), rehearse=rehearse),
        timeout_sec=timeout_sec, executor=executor)
    return Restored(label, {node: each.records for node, each in outcomes.items()}, unanswered, is_rehearsal=rehearse)


# A word of an Outcome, and its reason.
_Verdict = tuple[str, str]
_SET: _Verdict = ('set', '')


def _obstacle(value: Any, descriptor: Descriptor | None) -> _Verdict | None:
    """Return why no request can set a parameter to a value; None if there is no such reason."""
    if descriptor is None:
        return 'not declared', 'the node has no parameter of that name'
    if descriptor.read_only:
        return 'read only', 'only an override at its start can set it'
    if value is None:
        return 'no value', 'no request can take the value away and leave the parameter'
    if descriptor.dynamic_typing:
        return None
    fits = descriptor.type.is_array if values.is_empty_array(value) else descriptor.type.accepts(value)
    return None if fits else ('wrong type',
                              f'it is of type {descriptor.type.label}, not {values.type_of(value).label}')


def _expected(value: Any, descriptor: Descriptor) -> _Verdict:
    objection = DescribedParameter(descriptor).objection(value)
    return ('would be set', '') if objection is None else (objection.kind, objection.reason)


def _set(client: ParameterClient, new: Mapping[str, Any]) -> dict[str, _Verdict]:
    results = client.set_parameters_atomically(new)
    if results.successful:
        return dict.fromkeys(new, _SET)
    reason = results[0].reason
    # The one reason of an atomic request names the culprit, or it does not; all are in the same boat.
    return dict.fromkeys(new, ('rejected', reason) if len(new) == 1 else
                         ('left', f'the node rejected them together: {reason}'))


def _why_unanswered(error: NodeError) -> str:
    """Return why a node gave no answer, in two words."""
    return ('not there' if isinstance(error, NodeNotFoundError) else
            'gone' if isinstance(error, NodeGoneError) else 'no answer')


def _format(value: Any) -> str:
    return 'not set' if value is None else values.format_value(value)
