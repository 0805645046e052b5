"""Tables of parameters in Markdown, for a README: made from running nodes, saved descriptions and schemas."""

import re
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Reference:
    """A table of a node's parameters in Markdown; a notebook shows it as a table."""

    text: str

    def __repr__(self) -> str:
        return self.text

    def _repr_markdown_(self) -> str:
        return self.text


@dataclass(frozen=True)
class ReferenceRow:
    """What a table says of one parameter, as plain text."""

    name: str
    label: str
    """Its type, in the words of ``ros2``."""
    value: str
    """Its value, or its default, as text; empty if there is none."""
    rules: list[str]
    """What is enforced."""
    texts: Iterable[str]
    """What people have written about it; empty ones are left out."""


def reference_of(parameters: Iterable[ReferenceRow], value_heading: str = 'value') -> Reference:
    """Return a table with one row for each parameter.

    :param value_heading: What the column of values is called.
    """
    rows = [('parameter', 'type', value_heading, 'enforced', 'meaning'), ('---',) * 5]
    rows += [(_code(each.name), each.label, _code(each.value) if each.value else '', _cell(', '.join(each.rules)),
              _cell(' '.join(filter(None, each.texts)))) for each in parameters]
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
