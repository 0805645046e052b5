"""The table of a node's parameters in Markdown, for a README. No ROS, no Jupyter."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor


@dataclass(frozen=True)
class Reference:
    """A table of a node's parameters in Markdown; a notebook shows it as a table."""

    text: str

    def __repr__(self) -> str:
        return self.text

    def _repr_markdown_(self) -> str:
        return self.text


def reference_of(descriptors: Mapping[str, Descriptor], present: Mapping[str, Any]) -> Reference:
    """Return a table with one row for each parameter.

    :param present: The parameters' values.
    """
    rows = [('parameter', 'type', 'value', 'enforced', 'meaning'), ('---',) * 5]
    rows += [(_code(name), each.type.label, _code(values.format_value(present[name])), _cell(', '.join(each.rules)),
              _cell(f'{each.description} {each.additional_constraints}')) for name, each in descriptors.items()]
    return Reference(''.join(f'| {" | ".join(row)} |\n' for row in rows))


def _cell(text: str) -> str:
    """Return a text made fit for a cell of a table in Markdown."""
    for char, escaped in (('\\', '\\\\'), ('&', '&amp;'), ('<', '&lt;'), ('`', '\\`'), ('|', '\\|')):
        text = text.replace(char, escaped)
    return ' '.join(text.split())


def _code(text: str) -> str:
    """Return a cell of code, in which only a bar and a line break would still end the cell."""
    text = ' '.join(text.splitlines())
    fence = '`' * (1 + max(map(len, re.findall('`+', text)), default=0))
    blank = ' ' if '`' in text else ''
    return f'{fence}{blank}{text}{blank}{fence}'.replace('|', '\\|')
