"""Check parameter files without a robot: what no node would get, and what a node would reject.

Most mistakes in a parameter file are silent: rcl ignores a block that matches no node, a node ignores a name that it
does not declare, and of two blocks the one that appeared last wins. ``check_files`` reads files as rcl does, compares
them with descriptions of the nodes, and returns each mistake with its line and column.
"""

import difflib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from param_tools import values
from param_tools.descriptor import is_housekeeping
from param_tools.errors import nearest
from param_tools.files import common_parameters, rcl_parser
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.files.headers import misplaced, misspelled
from param_tools.files.node_names import flaw_of_block_name
from param_tools.files.parameter_files import format_scalar, read_bytes
from param_tools.files.parsing import (
    KEY,
    Assignment,
    BlockStart,
    Entry,
    Parser,
    Place,
    Rejected,
    Scalar,
    effective,
    matches,
    typed,
)
from param_tools.files.yaml_words import read_1_1, read_1_2
from param_tools.markup.tables import table
from param_tools.values import ParameterType

# What a finding is about, and whether the file surely does something else than it says.
KINDS = {
    'unreadable': 'error', 'no header': 'error', 'unknown node': 'error', 'never matched': 'error',
    'unknown parameter': 'error', 'wrong type': 'error', 'out of range': 'error', 'off the step': 'error',
    'invalid': 'error', 'read only': 'error', 'duplicate': 'warning', 'overridden': 'warning',
    'read otherwise': 'warning', 'missing': 'error',
}
# An array of more characters is not written out in a remedy.
_LONGEST_REMEDY = 100


@dataclass(frozen=True, order=True)
class FileFinding:
    """One mistake in a file."""

    file: str
    line: int
    column: int
    kind: str
    """One of KINDS."""
    message: str
    node: str = ''
    """The node that it matters to, or the name of the block; empty if it is about the file."""
    parameter: str = ''
    """The full name of the parameter; empty if it is about something else."""

    @property
    def severity(self) -> str:
        """'error' or 'warning'."""
        return KINDS[self.kind]

    def __str__(self) -> str:
        return f'{self.file}:{self.line}:{self.column}: {self.kind}: {self.message}'


class Findings(tuple[FileFinding, ...]):
    """All mistakes in some files, in their order; empty if there are none."""

    passed_over: tuple[str, ...] = ()
    """The blocks that were not checked, because nothing is known of their nodes."""
    left_to_launch: tuple[str, ...] = ()
    """Where names of blocks and values stand that a launch file fills in, each as ``file:line``: these were not
    checked."""

    def text(self) -> str:
        """Return one line for each, as compilers write them."""
        return '\n'.join(map(str, self))

    def as_json(self) -> str:
        """Return a list of objects with the fields of FileFinding and its severity."""
        return json.dumps([asdict(each) | {'severity': each.severity} for each in self], indent=2)

    def as_github(self) -> str:
        """Return commands that make GitHub Actions annotate the lines."""
        return '\n'.join(
            f'::{each.severity} file={_property(each.file)},line={each.line},col={each.column},'
            f'title={_property(each.kind)}::{_data(each.message)}' for each in self)

    def __repr__(self) -> str:
        return self.text() or '(nothing found)'

    def _repr_html_(self) -> str:
        if not self:
            return '<p>Nothing found.</p>'
        return table(('file', 'line', 'finding', 'message'),
                     [(each.file, f'{each.line}:{each.column}', each.kind, each.message) for each in self])


def _data(text: str) -> str:
    """Return a text as GitHub's workflow commands take it."""
    return text.replace('%', '%25').replace('\r', '%0D').replace('\n', '%0A')


def _property(text: str) -> str:
    return _data(text).replace(':', '%3A').replace(',', '%2C')


def check_files(paths: str | Path | Iterable[str | Path], against: Descriptions | None = None, *,
                loading: bool = False) -> Findings:
    """Find the mistakes in parameter files that a node gets together, in this order.

    :param paths: The files, as after ``--params-file``, or one.
    :param against: The nodes that the files are for. A block for another node is passed over, unless the description
        is complete or it looks like a typo. Without it, only what the files alone tell is checked.
    :param loading: The files are loaded into running nodes, where a read-only parameter cannot change, and by
        ``ros2 param load``, whose YAML library reads some values differently from rcl.
    :raises ParameterFileError: a file cannot be opened.
    """
    check = _Check(against or Descriptions(), loading)
    for path in [paths] if isinstance(paths, (str, Path)) else paths:
        check.read(path)
    return check.findings()


class _Check:
    def __init__(self, against: Descriptions, loading: bool):
        self._against = against
        self._loading = loading
        self._parser = Parser(tolerant=True)
        self._files: list[str] = []
        self._accepted: list[str] = []
        self._reported: set[str] = set()
        self._found: dict[tuple[str, int, int, str, str], FileFinding] = {}
        self._left_to_launch: set[tuple[str, int]] = set()

    def read(self, path: str | Path) -> None:
        """Read a file, and note what rcl rejects in it."""
        content, file = read_bytes(path), str(path)
        self._files.append(file)
        before = len(self._parser.rejected)
        self._parser.parse(content, file)
        headless: set[Place] = set()
        for_launch = self._places_for_launch(file, content.decode('utf-8-sig', 'replace'))
        all_rejected = self._parser.rejected[before:]
        causes = [cause for cause in (misplaced(content) if all_rejected else [])
                  if cause.is_certain or any(cause.explains(rejected.place) for rejected in all_rejected)]
        for cause in causes:
            self._add(file, cause.place, 'no header', cause.message)
        for rejected in all_rejected:
            if any(cause.explains(rejected.place) for cause in causes):
                continue
            left = [place for place, first, last in for_launch if first <= rejected.place.start <= last]
            if left and rejected.place.start:
                self._left_to_launch.add((file, left[0].line))
            elif not rejected.keys:
                self._add(file, rejected.place, 'unreadable', f'rcl rejects the file here: {rejected}')
            else:
                place, kind, message = self._headless(rejected)
                if place not in headless:
                    headless.add(place)
                    self._add(file, place, kind, message)
        if not self._parser.rejected:
            self._accepted.append(file)
        if not all_rejected and not any(start.file == file for start in self._parser.starts):
            self._add(file, Place(), 'never matched', 'the file holds parameters for no node at all')

    def _headless(self, rejected: Rejected) -> tuple[Place, str, str]:
        """Return place, kind and message for a value that stands before ros__parameters."""
        if found := misspelled(rejected.keys):
            place, message = found
            return place, 'no header', f'{message}: rcl rejects the file'
        # Where the first keys lead to other nodes, too, the header is missing below a later one.
        leading = 0
        while leading < len(rejected.keys) - 2 and self._leads_to_a_node(rejected.keys[:leading + 1]):
            leading += 1
        name, place = rejected.keys[leading]
        return place, 'no header', (f'there is no {KEY!r} between {name!r} and the values below it: rcl rejects the '
                                    f'file. It has to be node name, {KEY}, then parameters')

    def _leads_to_a_node(self, keys: Sequence[tuple[str, Place]]) -> bool:
        path = '/'.join(name.strip('/') for name, _ in keys) + '/'
        return any(start.name.lstrip('/').startswith(path) for start in self._parser.starts)

    def findings(self) -> Findings:
        """Check what was read, and return all findings."""
        self._ask_rcl()
        self._check_duplicates()
        self._check_blocks()
        judged = self._check_values()
        self._check_overridden()
        for assignment in self._parser.assignments:
            # What is for nodes that are not known here is passed over, unless none at all is known.
            is_ours = not self._against or any(matches(assignment.block, node) for node in self._against)
            if is_ours and assignment not in judged:
                self._check_undescribed(assignment)
        order = {file: number for number, file in enumerate(self._files)}
        found = Findings(sorted(self._found.values(), key=lambda each: (order[each.file], each.line, each.column)))
        found.left_to_launch = tuple(f'{file}:{line}' for file, line in sorted(
            self._left_to_launch, key=lambda each: (order[each[0]], each[1])))
        if self._against:
            found.passed_over = tuple(name for name in self._parser.blocks if name not in self._reported
                                      and not any(matches(name, node) for node in self._against))
        return found

    def _ask_rcl(self) -> None:
        """Let rcl itself judge what was read without a rejection: its YAML library may be another one than Python's."""
        if rejection := rcl_parser.first_rejection(self._accepted):
            index, reason = rejection
            line = re.search(r'line(?:_num)? (\d+)', reason)
            hint = (". Its YAML library is older than Python's: inside brackets, put quotes around texts with a colon "
                    'or a question mark' if reason.startswith('Error parsing a event') else '')
            self._add(self._accepted[index], Place(int(line[1]) if line else 1), 'unreadable',
                      f'rcl rejects the file: {reason}{hint}')

    def _add(self, file: str, place: Place, kind: str, message: str, node: str = '', parameter: str = '') -> None:
        key = (file, place.line, place.column, kind, parameter)
        in_one_line = ''.join(char if char.isprintable() else ascii(char)[1:-1] for char in message)
        self._found.setdefault(key, FileFinding(file, place.line, place.column, kind, in_one_line, node, parameter))

    def _places_for_launch(self, file: str, text: str) -> list[tuple[Place, int, int]]:
        """Return what launch fills in and rcl rejects as it stands, and from where to where rcl may say so."""
        blocks = [(start.place, start.end.start, start.end.end) for start in self._parser.starts
                  if start.file == file and _is_for_launch(start.name)]
        return blocks + [(each.place, each.place.start, each.place.end) for each in self._parser.assignments
                         if each.file == file and _is_for_launch(text[each.place.start:each.place.end])]

    # -- blocks -----------------------------------------------------------------------------------------

    def _check_duplicates(self) -> None:
        starts: dict[tuple[str, str], BlockStart] = {}
        for start in self._parser.starts:
            first = starts.setdefault((start.file, start.name.strip('/')), start)
            if first is not start:
                also = (' and `ros2 param load` only the last' if first.name == start.name else
                        f' because {first.name} and {start.name} are one node')
                self._add(start.file, start.place, 'duplicate',
                          f'there is a block for {first.name} in line {first.place.line} already: rcl reads '
                          f'both,{also}',
                          start.name)
        for repeated in self._parser.repeated:
            self._add(repeated.file, repeated.place, 'duplicate',
                      f'{repeated.name} stands in line {repeated.first.line} already: rcl reads what is below both, '
                      f'and `ros2 param load` only the last', repeated.block)
        assignments: dict[tuple[str, str, str], Assignment] = {}
        for each in self._parser.assignments:
            key = each.file, each.block.strip('/'), each.name
            before = assignments.get(key)
            assignments[key] = each
            if before is not None:
                self._add(each.file, each.name_place, 'duplicate',
                          f'{each.name} has a value in line {before.name_place.line} already', each.block, each.name)

    def _check_blocks(self) -> None:
        nodes = list(self._against)
        # A block for everybody, as many files have one, is not what the author wrote for a certain node.
        named = [name for name in self._parser.blocks if not name.endswith('*')]
        unmatched = [node for node in nodes if not any(matches(name, node) for name in named)]
        nothing_matches = not any(matches(name, node) for name in self._parser.blocks for node in nodes)
        for start in self._parser.starts if nodes else ():
            if any(matches(start.name, node) for node in nodes) or flaw_of_block_name(start.name):
                self._reported.add(start.name)
                continue
            name = '/' + start.name.strip('/')
            last = name.rpartition('/')[2]
            elsewhere = [node for node in unmatched if node.rpartition('/')[2] == last]
            similar = (elsewhere or difflib.get_close_matches(name, unmatched, n=3, cutoff=0.75)
                       or [node for node in nodes if _is_typo(name, node)])
            if not (self._against.complete or nothing_matches or similar):
                continue
            if '*' in start.name:
                kind, message = 'never matched', (f'no node matches {start.name}, so rcl ignores this block'
                                                  f'{nearest(name, nodes, "")}'
                                                  ' (* stands for one name, ** for any number of them)')
            elif elsewhere:
                kind, message = 'never matched', (
                    f'no node is called {name}, but there is {" and ".join(elsewhere)}: the block for it starts with '
                    f'"{elsewhere[0]}:" or "/**/{last}:"; rcl ignores this one')
            else:
                kind, message = 'unknown node', (f'there is no node {name}, so rcl ignores this block'
                                                 f'{nearest(name, similar or nodes, "")}')
            self._reported.add(start.name)
            self._add(start.file, start.place, kind, message, start.name)

    # -- values -----------------------------------------------------------------------------------------

    def _check_values(self) -> set[Assignment]:
        """Check all that a described node would get; return what was compared with a description."""
        judged: set[Assignment] = set()
        owners: dict[Assignment, list[str]] = {}
        types = {each.name: each.value for each in self._parser.assignments if each.name.endswith('.type')}
        for node, description in self._against.items():
            entries = effective(self._parser, node)
            known = {name: entry.value() for name, entry in entries.items()}
            for assignment in self._parser.assignments:
                if not matches(assignment.block, node):
                    continue
                owners.setdefault(assignment, [])
                described = (description.find(assignment.name, known)
                             or common_parameters.find(assignment.name, description, known, types))
                if described is None and not (description.allows_undeclared or is_housekeeping(assignment.name)):
                    continue
                owners[assignment].append(node)
                if described is not None and _winner(entries.get(assignment.name)) is assignment:
                    judged.add(assignment)
                    self._check_value(assignment, described, node)
            if not self._loading and not self._parser.rejected:
                self._check_missing(node, description, known)
        self._report_unknown(assignment for assignment, nodes in owners.items() if not nodes)
        return judged

    def _report_unknown(self, assignments: Iterable[Assignment]) -> None:
        names: dict[str, list[str]] = {}
        for assignment in assignments:
            nodes = [node for node in self._against if matches(assignment.block, node)]
            if nodes[0] not in names:
                entries = effective(self._parser, nodes[0])
                names[nodes[0]] = self._against[nodes[0]].names({name: each.value() for name, each in entries.items()})
            who = nodes[0] if len(nodes) == 1 else f'none of the {len(nodes)} nodes that match {assignment.block}'
            near = nearest(assignment.name, names[nodes[0]], 'It has no parameters at all')
            self._add(assignment.file, assignment.name_place, 'unknown parameter',
                      f'{who} {"has no" if len(nodes) == 1 else "has a"} parameter {assignment.name!r}{near}',
                      nodes[0], assignment.name)

    def _check_undescribed(self, assignment: Assignment) -> None:
        if described := common_parameters.OF_EVERY_NODE.get(assignment.name):
            self._check_value(assignment, described, assignment.block)
        else:
            self._check_words(assignment, None, '')

    def _check_missing(self, node: str, description: NodeDescription, given: Mapping[str, Any]) -> None:
        """Check that a node has a value of each parameter without which it does not start."""
        starts = [start for start in self._parser.starts if matches(start.name, node)]
        # In the block for this node alone, if there is one.
        for start in sorted(starts, key=lambda each: _generality(each.name))[:1]:
            for name, reason in description.missing(given):
                self._add(start.file, start.place, 'missing',
                          f'{node} does not start without a value of {name}: {reason}', node, name)

    def _check_value(self, assignment: Assignment, described: DescribedParameter, node: str) -> None:
        value, name = assignment.value, assignment.name
        if any(_is_for_launch(scalar.text) for scalar in assignment.scalars):
            self._left_to_launch.add((assignment.file, assignment.place.line))
            return
        if assignment.is_damaged:
            return
        if value == [] and not self._loading:
            self._add(assignment.file, assignment.place, 'wrong type',
                      f'{name} of {node}: an empty array has no type in a parameter file, so a node of rclpy does not '
                      f'start with it; leave the line out if the default is empty', node, name)
            return
        try:
            objection = described.objection(value)
        except ValueError as error:
            self._add(assignment.file, assignment.place, 'wrong type', f'{name} of {node}: {error}', node, name)
            return
        if objection is not None:
            hint = _hint(assignment, described) if objection.kind == 'wrong type' else ''
            self._add(assignment.file, assignment.place, objection.kind,
                      f'{name} of {node} cannot be {values.format_value(value, 60)}: {objection.reason}{hint}', node,
                      name)
        else:
            self._check_words(assignment, described, node)
        if self._loading and described.descriptor.read_only and not values.same(value, described.default):
            self._add(assignment.file, assignment.place, 'read only',
                      f'{name} of {node} is read-only: only an override at the start of the node can set it', node,
                      name)

    def _check_words(self, assignment: Assignment, described: DescribedParameter | None, node: str) -> None:
        """Check that people and other programs read a value as rcl does."""
        for scalar in assignment.scalars:
            if scalar.tag and not read_1_1(scalar.text, scalar.tag).is_same(scalar.value):
                tag = scalar.tag.replace('tag:yaml.org,2002:', '!!')
                self._add(assignment.file, scalar.place, 'read otherwise',
                          f'{assignment.name}: rcl ignores {tag} and reads {scalar.text} as {_named(scalar.value)}',
                          node or assignment.block, assignment.name)
                return
            if scalar.is_plain and (other := self._other_reading(scalar, described)):
                self._add(assignment.file, scalar.place, 'read otherwise',
                          f'{assignment.name}: rcl reads {scalar.text} as {_named(scalar.value)}, {other}: write '
                          f'{_unambiguous(scalar)}', node or assignment.block, assignment.name)
                return

    def _other_reading(self, scalar: Scalar, described: DescribedParameter | None) -> str:
        """Return how a value may be read otherwise; nothing if that does not matter to the parameter."""
        for version, read in (('YAML 1.1', read_1_1), ('YAML 1.2', read_1_2)):
            found = read(scalar.text)
            if found.is_same(scalar.value):
                continue
            if version == 'YAML 1.1' and self._loading:
                matters = True
            elif described is not None:
                matters = found.value is None or _could_hold(described, found.value)
            else:
                # PyYAML takes numbers like 1e-9 for texts. That alone misleads nobody but `ros2 param load`.
                matters = not (type(scalar.value) is float and type(found.value) is str and version == 'YAML 1.1')
            if matters:
                return f'and {version} as {found.words}'
        return ''

    # -- order ------------------------------------------------------------------------------------------

    def _check_overridden(self) -> None:
        exact = ['/' + name.strip('/') for name in self._parser.blocks if '*' not in name]
        for node in dict.fromkeys((*self._against, *exact)):
            entries = effective(self._parser, node)
            given: dict[str, list[Assignment]] = {}
            for each in self._parser.assignments:
                if matches(each.block, node):
                    given.setdefault(each.name, []).append(each)
            for name, assignments in given.items():
                winner = _winner(entries.get(name))
                for loser in assignments:
                    if winner is None:
                        self._add(loser.file, loser.name_place, 'overridden',
                                  f'rcl loses {name} of {node}, because a map of the same name follows', node, name)
                    elif loser is not winner and _surprising(loser, winner, self._parser.assignments):
                        where = f'line {winner.place.line}' + (f' of {winner.file}' * (winner.file != loser.file))
                        self._add(loser.file, loser.place, 'overridden',
                                  f'{node} gets {values.format_value(winner.value, 60)} for {name}, from {where}: '
                                  f'{_why(loser, winner)}', node, name)


def _is_for_launch(text: str) -> bool:
    """True if launch replaces a part of it: $(var robot), in a file that is given with ``allow_substs=True``."""
    return re.search(r'\$\([a-z]', text) is not None


def _winner(entry: Entry | None) -> Assignment | None:
    return entry.winner() if entry is not None else None


def _surprising(loser: Assignment, winner: Assignment, order: Sequence[Assignment]) -> bool:
    """True if the author of the loser could expect it to win: it comes later, or is more specific."""
    if (loser.file, loser.block, loser.name) == (winner.file, winner.block, winner.name):
        return False  # a duplicate, which is said elsewhere
    later = next(each for each in order if each is loser or each is winner) is winner
    if values.same(loser.value, winner.value):
        return False
    return later or (_generality(winner.block) > _generality(loser.block))


def _generality(block: str) -> tuple[int, int]:
    return block.count('**'), block.count('*')


def _why(loser: Assignment, winner: Assignment) -> str:
    if loser.block == winner.block:
        return 'of values of several types rcl keeps the first of boolean, integer, double, string'
    if loser.name != winner.name:
        return f'rcl mixes up {winner.name} and {loser.name}, a value and a map of the same name'
    return (f'of the blocks that match, the one whose name appeared last wins, here {winner.block}, however specific '
            f'the others are')


def _is_typo(name: str, node: str) -> bool:
    """True if a name differs from a node's in one word, by a letter or so: ``left`` is no typo of ``right``."""
    words, others = re.split('[/_]', name), re.split('[/_]', node)
    if len(words) != len(others):
        return False
    differing = [(word, other) for word, other in zip(words, others) if word != other]
    return (len(differing) == 1 and not any(map(str.isdigit, ''.join(differing[0])))
            and difflib.SequenceMatcher(None, *differing[0]).ratio() >= 0.75)


def _could_hold(described: DescribedParameter, value: Any) -> bool:
    """True if a value has the type of a parameter, or of its elements."""
    wanted = described.descriptor.type
    if wanted is values.NOT_SET or described.descriptor.dynamic_typing:
        return True
    return wanted.item(value)


def _named(value: Any) -> str:
    label = values.type_of(value).label
    return f'the {label} {values.format_value(value, 60)}'


def _unambiguous(scalar: Scalar) -> str:
    text = f"'{scalar.text}'" if "'" not in scalar.text else json.dumps(scalar.text)
    if isinstance(scalar.value, str):
        return f'{text} for the text, or what you mean'
    return f'{format_scalar(scalar.value)}, or {text} for the text'


def _hint(assignment: Assignment, described: DescribedParameter) -> str:
    """Return what to write instead of a value of the wrong type."""
    wanted = described.descriptor.type
    if wanted is values.BYTE_ARRAY:
        return '; a parameter file has no byte arrays: leave the line out, and let the program set it'
    if assignment.is_array != wanted.is_array:
        return _hint_of_list(assignment, described)
    for scalar in assignment.scalars:
        value = scalar.value
        if wanted.item(value):
            continue
        meant = _converted(scalar.text, wanted)
        whole = _all_converted(assignment, wanted) or (None if meant is None else format_scalar(meant))
        if wanted in (values.STRING, values.STRING_ARRAY):
            return f'; rcl reads {scalar.text} without quotes as {_named(value)}: write {whole}'
        comma = re.fullmatch(r'([+-]?[0-9]+),([0-9]+)', scalar.text.strip())
        if comma and wanted is values.DOUBLE:
            return f'; write {comma[1]}.{comma[2]}, with a point'
        if whole is None:
            return f'; rcl reads {scalar.text} as {_named(value)}' if scalar.is_plain else ''
        is_in_quotes = not scalar.is_plain and isinstance(value, str) and '\n' not in scalar.text
        return ('; leave the quotes out' if is_in_quotes and values.same(typed(scalar.text, False), meant) else
                f'; write {whole}')
    return ''


def _all_converted(assignment: Assignment, wanted: ParameterType) -> str | None:
    """Return a short array as its author can have meant it; None for a long or unclear one, and for a single value."""
    items = [_converted(scalar.text, wanted) for scalar in assignment.scalars]
    text = f'[{", ".join(map(format_scalar, items))}]' if assignment.is_array and None not in items else ''
    return text if 0 < len(text) <= _LONGEST_REMEDY else None


def _converted(text: str, wanted: ParameterType) -> Any:
    """Return what the author of a text can have meant for a parameter, or for one of its elements; None if that is
    not clear."""
    if wanted in (values.STRING, values.STRING_ARRAY):
        return text
    value = typed(text.strip(), False)
    if type(value) is int and wanted in (values.DOUBLE, values.DOUBLE_ARRAY):
        return float(value)
    if type(value) is float and value.is_integer() and wanted in (values.INTEGER, values.INTEGER_ARRAY):
        return int(value)
    return value if wanted.item(value) else None


def _hint_of_list(assignment: Assignment, described: DescribedParameter) -> str:
    """Return what to write instead of a list, or of a single value where a list should be."""
    wanted = described.descriptor.type
    if not wanted.is_array:
        meant = _converted(assignment.scalars[0].text, wanted) if len(assignment.scalars) == 1 else None
        return '' if meant is None else f'; write {format_scalar(meant)}'
    scalar = assignment.scalars[0]
    items = [] if scalar.is_plain and read_1_1(scalar.text).words == 'null' else [
        _converted(word, wanted) for word in _words_of_list(scalar.text, wanted)]
    if not items or None in items or len({type(item) for item in items}) > 1:
        return '; write a list in brackets, or leave the line out'
    return f'; write [{", ".join(map(format_scalar, items))}]'


def _words_of_list(text: str, wanted: ParameterType) -> list[str]:
    """Return the elements of a list that somebody wrote as a text: in brackets, in lines, with commas, or with spaces
    where it is one of numbers."""
    inner = text.strip().removeprefix('[').removesuffix(']')
    separator = r'[,\n]' if wanted is values.STRING_ARRAY else r'[,\s]'
    words = (re.sub(r'^- +', '', word.strip()).strip('\'"') for word in re.split(separator, inner))
    return [word for word in words if word not in ('', '-')]
