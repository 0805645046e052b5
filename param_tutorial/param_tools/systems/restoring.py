"""Give nodes the values of sets of parameters, in one request for each, and say what became of every value.

A set may come from a snapshot, a file or another node. ``preview`` says what ``restore`` would do, and changes nothing.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import NodeError, NodeGoneError, NodeNotFoundError
from param_tools.files.descriptions import DescribedParameter
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient, ParameterValues
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.sets import NodeLike, ParameterSet, as_client, as_set
from param_tools.systems.snapshot import ask_all
from param_tools.systems.word_table import NodesTable

MAY_BE_TAKEN = 'the node has not declared it, and no service tells whether it would take it all the same'
"""What a preview says of such a parameter: a node may allow undeclared ones."""


@dataclass(frozen=True)
class Outcome:
    """What became of one parameter that differed from a set, or would become of it."""

    name: str
    present: Any
    """What the node had. None if it had no such parameter, or it had no value."""
    wanted: Any
    word: str
    """'set' or, in a preview, 'would be set'; 'left' because others of the same request were rejected; or why not:
    'read only', 'wrong type', 'not declared', 'no value', 'rejected', in a preview 'out of range' or 'off the step',
    and 'not kept' by a node that accepted the value and stored something else."""
    reason: str = ''


class _Outcomes(NodesTable[Outcome]):
    """The parameters of one node or of several that differ from a set, with what becomes of them."""

    def __init__(self, label: str, nodes: Mapping[str, Iterable[Outcome]],
                 unanswered: Mapping[str, NodeError] | None = None):
        """:param nodes: The outcomes for each node that has answered; the others are in ``unanswered``."""
        self.unanswered = dict(unanswered or {})
        super().__init__(nodes, is_of_one=len(nodes) == 1 and not unanswered)
        whose = next(iter(nodes)) if self.is_of_one else format_count(len(nodes) + len(self.unanswered), 'node')
        missing = f', {len(self.unanswered)} without an answer' if unanswered else ''
        self.heading = f'{whose} from {label}: {self._summary()}{missing}'

    def count(self, word: str) -> int:
        """Return how many outcomes there are of a kind."""
        return sum(each.word == word for each in self)

    def rows(self) -> list[tuple[str, ...]]:
        blanks = [''] * (len(self.columns) - 3)
        return super().rows() + [(node, *blanks, _why_unanswered(error), '') for node, error in self.unanswered.items()]

    def _summary(self) -> str:
        raise NotImplementedError


class Restored(_Outcomes):
    """What became of the parameters that differed from a set. Shown as a table.

    Whether a node that has not answered was changed is not known.
    """

    columns = ('parameter', 'wanted', 'outcome', 'reason')

    @property
    def complete(self) -> bool:
        """True if all nodes now hold all their values of the set."""
        return not self.unanswered and self.count('set') == len(self)

    def words(self, record: Outcome) -> tuple[str, ...]:
        return record.name, _format(record.wanted), record.word, record.reason

    def _summary(self) -> str:
        done, total = self.count('set'), format_count(len(self), 'parameter')
        if self.complete:
            return f'complete, {total} set' if done else 'nothing to do, all values are there'
        if done or self.count('not kept') or self.unanswered:
            return f'NOT COMPLETE, {done} of {total} set' if self.records else 'NOT COMPLETE'
        return 'NOT RESTORED, nothing was changed'


class Preview(_Outcomes):
    """What restoring would do. The node's own callbacks may still reject. Shown as a table."""

    columns = ('parameter', 'present', 'wanted', 'expected', 'reason')

    def words(self, record: Outcome) -> tuple[str, ...]:
        return record.name, *values.format_change(record.present, record.wanted), record.word, record.reason

    def _summary(self) -> str:
        return f'{format_count(len(self), "difference")}, {self.count("would be set")} would be set'


def restore(node: NodeLike, wanted: Mapping[str, Any], *, one_by_one: bool = False,
            skip_read_only: bool = False) -> Restored:
    """Give a node the values of a set, as far as they differ from what it has.

    What no service can change (read-only parameters, types, parameters that are not declared) is left out and
    reported. The rest is set in one request, atomically: if the node rejects one, none is changed. Parameters that
    only the node has are left alone.

    :param one_by_one: If the node rejects the request, try each parameter for itself, again and again as long as that
        helps: rules across parameters may allow in one order what they reject in another.
    :param skip_read_only: Pass over read-only parameters without a word; the rest can then be complete.
    :raises ParameterToolError: the node does not answer; whether it was changed is then not known.
    """
    client, target = as_client(node), as_set(wanted, 'given values')
    present, differing = _differing(client, target)
    verdicts = {name: _obstacle(target[name], descriptor) for name, descriptor in differing.items()
                if not (skip_read_only and descriptor and descriptor.read_only)}
    new = {name: target[name] for name, obstacle in verdicts.items() if obstacle is None}
    if new:
        verdicts |= _set(client, new, one_by_one)
        held = client.get_parameters()
        for name, value in new.items():
            if verdicts[name] == _SET and not values.same(held.get(name), value):
                verdicts[name] = ('not kept', f'the node holds {_format(held.get(name))}')
    return Restored(target.label, {client.node: [
        Outcome(name, present.get(name), target[name], *verdict) for name, verdict in verdicts.items() if verdict]})


def preview(node: NodeLike, wanted: Mapping[str, Any]) -> Preview:
    """Find out what ``restore`` would do, and change nothing.

    :raises ParameterToolError: the node does not answer.
    """
    client, target = as_client(node), as_set(wanted, 'given values')
    present, differing = _differing(client, target)

    def expected(name: str, descriptor: Descriptor | None) -> Outcome:
        value = target[name]
        obstacle = _obstacle(value, descriptor)
        if descriptor is None:
            obstacle = ('not declared', MAY_BE_TAKEN)
        elif obstacle is None and (objection := DescribedParameter(descriptor).objection(value)):
            obstacle = (objection.kind, objection.reason)
        return Outcome(name, present.get(name), value, *(obstacle or ('would be set', '')))

    return Preview(target.label, {client.node: [expected(*each) for each in differing.items()]})


def preview_all(wanted: Mapping[str, Mapping[str, Any]], label: str, *, timeout_sec: float = TIMEOUT_SEC,
                executor: BackgroundExecutor | None = None) -> Preview:
    """Find out what ``restore_all`` would do, and change nothing."""
    outcomes, unanswered = ask_all(wanted, lambda client: preview(client, ParameterSet(wanted[client.node], label)),
                                   timeout_sec=timeout_sec, executor=executor)
    return Preview(label, _joined(outcomes), unanswered)


def restore_all(wanted: Mapping[str, Mapping[str, Any]], label: str, *, one_by_one: bool = False,
                skip_read_only: bool = False, timeout_sec: float = TIMEOUT_SEC,
                executor: BackgroundExecutor | None = None) -> Restored:
    """Give many nodes values, all nodes at the same time, and each as ``restore`` does.

    :param wanted: The values for each node, such as a Snapshot.
    :param label: Says where the values come from.
    :param timeout_sec: How long a node may take for each answer. A node that takes longer is in ``unanswered``.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    outcomes, unanswered = ask_all(
        wanted, lambda client: restore(client, ParameterSet(wanted[client.node], label), one_by_one=one_by_one,
                                       skip_read_only=skip_read_only), timeout_sec=timeout_sec, executor=executor)
    return Restored(label, _joined(outcomes), unanswered)


def _joined(outcomes: Mapping[str, _Outcomes]) -> dict[str, tuple[Outcome, ...]]:
    return {node: each.records for node, each in outcomes.items()}


# A word of an Outcome, and its reason.
_Verdict = tuple[str, str]
_SET: _Verdict = ('set', '')


def _differing(client: ParameterClient, target: ParameterSet) -> tuple[ParameterValues, dict[str, Descriptor | None]]:
    """Return what a node holds, and each parameter that differs from a set, with its descriptor if it is declared."""
    present = client.get_parameters()
    names = [name for name in target if not values.holds(present, name, target[name])]
    descriptors = client.describe_parameters([name for name in names if name in present])
    return present, {name: descriptors.get(name) for name in names}


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


def _set(client: ParameterClient, new: Mapping[str, Any], one_by_one: bool) -> dict[str, _Verdict]:
    results = client.set_parameters_atomically(new)
    if results.successful:
        return dict.fromkeys(new, _SET)
    reason = results[0].reason
    if not one_by_one:
        # The one reason of an atomic request names the culprit, or it does not; all are in the same boat.
        return dict.fromkeys(new, ('rejected', reason) if len(new) == 1 else
                             ('left', f'the node rejected them together: {reason}'))
    verdicts: dict[str, _Verdict] = {}
    missing = dict(new)
    while missing:
        answers = client.set_parameters(missing)
        verdicts |= {each.name: _SET if each.successful else ('rejected', each.reason) for each in answers}
        if not any(each.successful for each in answers):
            break
        missing = {each.name: each.value for each in answers if not each.successful}
    return verdicts


def _why_unanswered(error: NodeError) -> str:
    """Return why a node gave no answer, in two words."""
    return ('not there' if isinstance(error, NodeNotFoundError) else
            'gone' if isinstance(error, NodeGoneError) else 'no answer')


def _format(value: Any) -> str:
    return 'not set' if value is None else values.format_value(value)
