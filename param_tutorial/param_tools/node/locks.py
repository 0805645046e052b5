"""Which parameters can't be changed now: what their descriptors say, held against what the node has.

``Rules.only_while`` states a lock in words that every tool shows. Here they are read again, also those of a node in
another process or on another machine.
"""

import ast
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.node.client import ParameterClient
from param_tools.node.rules import IS, ONLY_WHILE


class Condition(NamedTuple):
    """What has to be so for a parameter to be changed."""

    name: str
    """Of another parameter."""
    value: Any

    def __str__(self) -> str:
        return f'{self.name}{IS}{self.value!r}'


def conditions_of(descriptor: Descriptor) -> list[Condition]:
    """Return the conditions that ``Rules.only_while`` has put on a parameter; none if its constraints name no such."""
    found = []
    for part in descriptor.additional_constraints.split(ONLY_WHILE.capitalize())[1:]:
        name, _, rest = part.partition(IS)
        # Another rule may follow, and the value may hold what stands between two of them.
        pieces = rest.split('; ')
        for end in range(1, len(pieces) + 1):
            try:
                found.append(Condition(name, ast.literal_eval('; '.join(pieces[:end]))))
            except (ValueError, SyntaxError):
                continue
            break
    return found


def unmet(conditions: Iterable[Condition], known: Mapping[str, Any]) -> str:
    """Return why a parameter can't be changed now, in words; empty if it can, or if nobody knows.

    :param known: The values of the node's parameters, by name, as far as they are known.
    """
    missed = [each for each in conditions if each.name in known and not values.same(known[each.name], each.value)]
    if not missed:
        return ''
    now = ', '.join(f'{each.name} = {values.format_value(known[each.name])}' for each in missed)
    return f'It {ONLY_WHILE}{" and ".join(map(str, missed))}; now {now}.'


def locks(client: ParameterClient) -> dict[str, str]:
    """Return the parameters of a node that can't be changed now, and why: by name, in words.

    What is not in it may still be rejected: a callback can have reasons of its own, and the node has the last word.

    :raises NodeError: the node does not answer.
    """
    descriptors, known = client.describe_and_get()
    found = {name: 'It is read-only.' if each.read_only else unmet(conditions_of(each), known)
             for name, each in descriptors.items()}
    return {name: reason for name, reason in found.items() if reason}
