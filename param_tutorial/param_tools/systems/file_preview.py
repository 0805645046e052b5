"""What loading a parameter file into a running node would do: a table to read before the file is loaded."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import ParameterFileError, nearest
from param_tools.files import parameter_files
from param_tools.files.checking import check_files
from param_tools.files.descriptions import DescribedParameter
from param_tools.files.parsing import effective, matches
from param_tools.markup.wording import format_count
from param_tools.systems.restoring import MAY_BE_TAKEN
from param_tools.systems.word_table import WordTable

CHANGES, SAME, READ_ONLY, NOT_DECLARED, NOT_SHOWN = 'changes', 'same', 'read-only', 'not declared', 'not shown'
OTHER_NODE = 'not for this node'

# The kinds of findings that are about the file itself. Findings about a value are in the value's row.
_ABOUT_THE_FILE = ('unknown node', 'never matched', 'duplicate', 'overridden', 'read otherwise')


@dataclass(frozen=True)
class PreviewRow:
    """What loading would do to one parameter."""

    name: str
    now: Any
    """The node's value; None if it has no value, or no such parameter."""
    wanted: Any
    """The value in the file."""
    verdict: str
    """'changes', 'same', or why loading leaves the value out: 'read-only', 'not declared', 'not shown' here, 'wrong
    type', 'out of range', 'off the step' or 'not for this node'."""
    reason: str = ''
    """The reason for the verdict, as a sentence without a full stop; may be empty."""
    block: str = ''
    """The name of the block that the value is in, if the block is for other nodes."""


class FilePreview(WordTable[PreviewRow]):
    """What loading a file would do. The node's own callbacks may still reject a value. Shown as a table."""

    columns = ('parameter', 'now', 'in the file', 'verdict', 'reason')

    def __init__(self, path: str | Path, node: str, rows: Iterable[PreviewRow], notes: Iterable[str] = ()):
        """
        :param rows: One for each parameter in the file, in the file's order; those for other nodes last.
        :param notes: Findings about the file itself, as sentences.
        """
        super().__init__(rows)
        self.notes = tuple(notes)
        counts = {verdict: sum(row.verdict == verdict for row in self) for verdict in (CHANGES, SAME, OTHER_NODE)}
        left = len(self) - sum(counts.values())
        parts = [f'{format_count(counts[CHANGES], "value")} will change', f'{counts[SAME]} the same']
        parts += [f'{left} will not be loaded'] * (left > 0)
        parts += [f'{counts[OTHER_NODE]} for other nodes'] * (counts[OTHER_NODE] > 0)
        self.summary = ', '.join(parts)
        """How many rows there are of each kind, in words."""
        self.heading = f'{path} → {node}: {self.summary}'

    @property
    def accepted(self) -> dict[str, Any]:
        """The values that loading would set, by the parameters' names."""
        return {row.name: row.wanted for row in self if row.verdict == CHANGES}

    @property
    def left_out(self) -> dict[str, str]:
        """Why loading leaves values for this node out, by the parameters' names. Equal values are not in it."""
        return {row.name: f'{row.verdict}: {row.reason}' for row in self
                if row.verdict not in (CHANGES, SAME, OTHER_NODE)}

    def words(self, record: PreviewRow) -> tuple[str, ...]:
        return (record.name, *values.format_change(record.now, record.wanted, nothing='-'), record.verdict,
                record.reason)


class Loaded(dict[str, str]):
    """Why loading a file left values out, by the parameters' names. Values that the node had already are not in it.

    :param names: The parameters that loading has set to the file's values.
    :param is_gathered: True if they are not set yet: the values wait with other changes.
    """

    def __init__(self, left: Mapping[str, str], names: Iterable[str], *, is_gathered: bool = False):
        super().__init__(left)
        self.names = tuple(names)
        self.is_gathered = is_gathered


def preview_file(path: str | Path, node: str, descriptors: Mapping[str, Descriptor], present: Mapping[str, Any], *,
                 is_partial: bool = False) -> FilePreview:
    """Find out what loading a file into a node would do. The file is read as rcl reads it.

    :param is_partial: True if the node has more parameters: a panel may show only some.
    :raises ParameterFileError: the file cannot be read, or rcl would reject it.
    """
    # A pipe or a device could keep the reader forever.
    if not parameter_files.as_path(path).is_file():
        raise ParameterFileError(f'there is no file {path}')
    parser = parameter_files.parse(path)
    entries = effective(parser, node)
    wanted = parameter_files.values_of(path, entries)
    rows = [_row(name, value, descriptors, present, is_partial) for name, value in wanted.items()]
    rows += [PreviewRow(each.name, None, each.value, OTHER_NODE, f'it is for {each.block}', each.block)
             for each in parser.assignments if not matches(each.block, node)]
    notes = [f'line {each.line}: {each.message}' for each in check_files(path) if each.kind in _ABOUT_THE_FILE]
    return FilePreview(path, node, rows, notes)


def _row(name: str, value: Any, descriptors: Mapping[str, Descriptor], present: Mapping[str, Any],
         is_partial: bool) -> PreviewRow:
    if name not in descriptors:
        near = nearest(name, list(descriptors), 'It has no parameters at all')
        verdict, reason = ((NOT_SHOWN, 'this panel shows no such parameter') if is_partial
                           else (NOT_DECLARED, MAY_BE_TAKEN))
        return PreviewRow(name, None, value, verdict, f'{reason}{near}')
    descriptor, now = descriptors[name], present.get(name)
    if values.same(now, value):
        return PreviewRow(name, now, value, SAME)
    if descriptor.read_only:
        return PreviewRow(name, now, value, READ_ONLY, 'only an override at the start of the node can set it')
    if objection := DescribedParameter(descriptor).objection(value):
        return PreviewRow(name, now, value, objection.kind, objection.reason)
    return PreviewRow(name, now, value, CHANGES)
