"""Which parameters can't be changed now: the conditions in their descriptors, compared with the node's values.

``Rules.only_while`` writes such a condition into the descriptor, in words that every tool shows. Here these words are
read back, also from a node in another process or on another machine.
"""

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.client import ParameterClient
from param_tools.node.rules import IS, ONLY_WHILE, read_values


class Condition(NamedTuple):
    """The value that another parameter must have for a parameter to be changed."""

    name: str
    """The other parameter."""
    value: Any

    def __str__(self) -> str:
        return f'{self.name}{IS}{self.value!r}'


def conditions_of(descriptor: Descriptor) -> list[Condition]:
    """Return the conditions that ``Rules.only_while`` has written into a descriptor."""
    parts = (part.partition(IS) for part in descriptor.additional_constraints.split(ONLY_WHILE.capitalize())[1:])
    return [Condition(name, value) for name, _, rest in parts for value in read_values(rest)[:1]]


def unmet(conditions: Iterable[Condition], known: Mapping[str, Any]) -> str:
    """Return why a parameter can't be changed now, in words; empty if it can, or if that is not known.

    :param known: The values of the node's parameters, by name, as far as they are known.
    """
    missed = [each for each in conditions if each.name in known and not values.same(known[each.name], each.value)]
    if not missed:
        return ''
    now = ', '.join(f'{each.name} = {values.format_value(known[each.name])}' for each in missed)
    return f'It {ONLY_WHILE}{" and ".join(map(str, missed))}; now {now}.'


def locks(client: ParameterClient) -> dict[str, str]:
    """Return the parameters of a node that can't be changed now, and why: by name, in words.

    The node may still reject a change of any other parameter: its callbacks can have reasons of their own.

    :raises NodeError: the node does not answer.
    """
    descriptors, known = client.describe_and_get()
    found = {name: 'It is read-only.' if each.read_only else unmet(conditions_of(each), known)
             for name, each in descriptors.items()}
    return {name: reason for name, reason in found.items() if reason}
