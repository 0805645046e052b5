"""Check parameter files without a robot: what no node would get, and what a node would reject.

Most mistakes in a parameter file are silent: rcl ignores a block that matches no node, a node ignores a name that it
does not declare, and of two blocks the one that appeared last wins. ``check_files`` reads files as rcl does, compares
them with descriptions of the nodes, and returns each mistake with its line and column.
"""

import bisect
import difflib
import functools
import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from param_tools import values
from param_tools.descriptor import is_housekeeping
from param_tools.errors import nearest
from param_tools.files import rcl_parser
from param_tools.files.causes import LIST_BELOW, cause_of, looks_like_header, named_sign
from param_tools.files.descriptions import DescribedParameter, Descriptions
from param_tools.files.node_names import flaw_of_block_name
from param_tools.files.parameter_files import format_scalar, lines_of, read_bytes
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
    remedy_of_nested,
    typed,
)
from param_tools.values import ParameterType

# What a finding is about, and whether the file surely does something else than it says.
KINDS = {
    'unreadable': 'error', 'no header': 'error', 'unknown node': 'error', 'never matched': 'error',
    'unknown parameter': 'error', 'wrong type': 'error', 'out of range': 'error', 'off the step': 'error',
    'not filled in': 'error', 'likely mistake': 'warning', 'duplicate': 'warning', 'overridden': 'warning',
    'not declared': 'warning', 'in no file': 'notice',
}
# An array of more characters is not written out in a remedy.
_LONGEST_REMEDY = 100
# rcl's own parser takes a time with the square of the length, and is not asked about more bytes.
_MOST_FOR_RCL = 100_000
# A minus before a number, quotes around a text, and blanks that can't be seen, all as web pages have them.
_LOOKALIKE = re.compile('^[\u2010-\u2015\u2212](?=[\\d.])|^[\u2018-\u201f]|[\xa0\u200b-\u200d\u2060\ufeff]')
_PLAIN = str.maketrans({**dict.fromkeys('\u2010\u2011\u2012\u2013\u2014\u2015\u2212', '-'), '\xa0': ' ',
                        **dict.fromkeys('\u201c\u201d\u201e\u201f', '"'),
                        **dict.fromkeys('\u2018\u2019\u201a\u201b', "'"),
                        **dict.fromkeys('\u200b\u200c\u200d\u2060\ufeff')})
# A number, and what is no part of it: a comment without a blank before it, C's, a unit, a comma.
_GLUED = re.compile(r'([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(#.*|\s*//.*|\s*[,;]|[fF]|'
                    r'\s+(?:[cmk]?m|[mu]?s|sec|k?Hz|rad|deg|°|k?g|%|V|A|N|Nm|(?:m|rad|deg)/s(?:\^?2)?))')
# What neither rcl nor launch fills in.
_UNFILLED = re.compile(r'\$\{\w+\}|\$[A-Z_]+\b|\$\((?:find|arg|optenv)\s[^)]*\)|\{\{.*?\}\}')


@dataclass(frozen=True, order=True)
class FileFinding:
    """One mistake in a file."""

    file: str
    line: int
    """0 if only the file is known, and then so is the column."""
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
        """'error', 'warning', or 'notice' for what is no mistake."""
        return KINDS[self.kind]

    def __str__(self) -> str:
        place = f'{self.file}:{self.line}:{self.column}' if self.line else self.file
        return f'{place}: {self.kind}: {self.message}'


class Findings(tuple[FileFinding, ...]):
    """All mistakes in some files, in their order; empty if there are none."""

    passed_over: tuple[str, ...] = ()
    """The blocks that were not checked, because nothing is known of their nodes."""
    left_to_launch: tuple[str, ...] = ()
    """The lines with something that a launch file fills in, each as ``file:line``, where that was not checked."""
    substitutions: tuple[str, ...] = ()
    """All lines with such a thing, which other programs take as text."""
    no_parameter_files: tuple[str, ...] = ()
    """The files that were passed over, because nothing in them looks like a parameter file."""

    def text(self) -> str:
        """Return one line for each, as compilers write them."""
        return '\n'.join(map(str, self))

    def as_github(self) -> str:
        """Return commands that make GitHub Actions annotate the lines."""
        return '\n'.join(
            f'::{each.severity} file={_property(each.file)},line={each.line or 1},col={each.column or 1},'
            f'title={_property(each.kind)}::{_data(each.message)}' for each in self)

    def __repr__(self) -> str:
        return self.text() or '(nothing found)'


def _data(text: str) -> str:
    """Return a text as GitHub's workflow commands take it."""
    return text.replace('%', '%25').replace('\r', '%0D').replace('\n', '%0A')


def _property(text: str) -> str:
    return _data(text).replace(':', '%3A').replace(',', '%2C')


def check_files(paths: str | Path | Iterable[str | Path], against: Descriptions | None = None, *,
                are_meant: bool = True) -> Findings:
    """Find the mistakes in parameter files that a node gets together, in this order.

    :param paths: The files, as after ``--params-file``, or one.
    :param against: The nodes that the files are for. A block for another node is passed over, unless the description
        is complete or it looks like a typo. Without it, only what the files alone tell is checked.
    :param are_meant: Each of them must be a parameter file. Otherwise they are what a folder has, and one without
        ``ros__parameters`` is passed over.
    :raises ParameterFileError: a file cannot be opened.
    """
    check = _Check(against or Descriptions(), are_meant)
    for path in [paths] if isinstance(paths, (str, Path)) else paths:
        check.read(path)
    return check.findings()


class _Check:
    def __init__(self, against: Descriptions, are_meant: bool):
        self._against = against
        self._are_meant = are_meant
        self._parser = Parser(tolerant=True)
        self._assignments: defaultdict[str, list[Assignment]] = defaultdict(list)
        """Those of each block."""
        self._files: list[str] = []
        self._accepted: list[str] = []
        self._reported: set[str] = set()
        self._found: dict[tuple[str, int, int, str, str], FileFinding] = {}
        self._judged: set[Assignment] = set()
        """Those that a described node would get."""
        self._for_launch: dict[tuple[str, int], None] = {}
        """The lines of which launch replaces a part: $(var robot), in a file that is given with allow_substs=True."""
        self._left_to_launch: set[tuple[str, int]] = set()
        self._no_parameter_files: list[str] = []

    def read(self, path: str | Path) -> None:
        """Read a file, and note what rcl rejects in it."""
        content, file = read_bytes(path), str(path)
        self._files.append(file)
        lines = lines_of(content)
        before, begun = len(self._parser.rejected), len(self._parser.starts)
        self._parser.parse(content, file)
        rejected = self._parser.rejected[before:]
        starts = self._parser.starts[begun:]
        if not starts and not _mentions_header(lines, rejected):
            if rejected and not self._are_meant:
                self._no_parameter_files.append(file)
                del self._parser.rejected[before:]
                return
            # One for each value would bury what is missing.
            first = next((each for each in rejected if each.keys), None)
            rejected = [each for each in rejected if not each.keys]
            if first:
                self._add(file, first.keys[0][1], 'no header',
                          f'the file has no {KEY}, so rcl rejects it: a block begins with "/name_of_the_node:" or '
                          f'"/**:", and below it, indented, {KEY}: and the parameters')
        self._for_launch |= {(file, number): None for number, line in enumerate(lines, 1)
                             if '$(' in line and re.search(r'\$\([a-z]', line)}
        ends = [start.end.start for start in starts]
        for each in rejected:
            place, reason, kind = cause_of(each, starts[:bisect.bisect_left(ends, each.place.start)][-1:], lines)
            self._add(file, place, kind, reason if kind == 'no header' else f'rcl rejects the file here: {reason}')
        if not self._parser.rejected:
            self._accepted.append(file)
        if len(self._parser.rejected) == before and not starts:
            self._add(file, Place(), 'never matched', 'the file holds parameters for no node at all')

    def findings(self) -> Findings:
        """Check what was read, and return all findings."""
        self._ask_rcl()
        for assignment in self._parser.assignments:
            self._assignments[assignment.block].append(assignment)
        self._check_duplicates()
        self._check_blocks()
        self._check_values()
        self._check_overridden()
        self._check_unlikely()
        order = {file: number for number, file in enumerate(self._files)}
        found = Findings(sorted(self._found.values(), key=lambda each: (order[each.file], each.line, each.column)))
        found.left_to_launch, found.substitutions = (
            tuple(f'{file}:{line}' for file, line in lines)
            for lines in (filter(self._left_to_launch.__contains__, self._for_launch), self._for_launch))
        found.no_parameter_files = tuple(self._no_parameter_files)
        if self._against:
            found.passed_over = tuple(name for name in self._parser.blocks if name not in self._reported
                                      and not any(matches(name, node) for node in self._against))
        return found

    def _ask_rcl(self) -> None:
        """Let rcl itself judge what was read without a rejection: its YAML library may be another one than Python's."""
        files = [file for file in self._accepted if Path(file).is_file()]
        if sum(Path(file).stat().st_size for file in files) > _MOST_FOR_RCL:
            return
        if rejection := rcl_parser.first_rejection(self._accepted):
            index, reason = rejection
            line = re.search(r'line(?:_num)? (\d+)', reason)
            lines = lines_of(read_bytes(self._accepted[index]))
            # For what is not YAML rcl often names another line.
            directives = (number for number, each in enumerate(lines, 1) if each.startswith('%'))
            place = Place(next(directives, int(line[1]) if line else 1))
            place, cause, kind = cause_of(Rejected(place, reason), (), lines)
            self._add(self._accepted[index], place, kind, f'rcl rejects the file: {cause}')

    def _add(self, file: str, place: Place, kind: str, message: str, node: str = '', parameter: str = '') -> None:
        if (file, place.line) in self._for_launch and kind != 'not filled in':
            self._left_to_launch.add((file, place.line))
            return
        key = (file, place.line, place.column, kind, parameter)
        if not message.isprintable():
            message = ''.join(char if char.isprintable() else ascii(char)[1:-1] for char in message)
        self._found.setdefault(key, FileFinding(file, place.line, place.column, kind, message, node, parameter))

    # -- blocks -----------------------------------------------------------------------------------------

    def _check_duplicates(self) -> None:
        starts: dict[tuple[str, str], BlockStart] = {}
        for start in self._parser.starts:
            first = starts.setdefault((start.file, start.name.strip('/')), start)
            if first is not start:
                self._add(start.file, start.place, 'duplicate',
                          f'there is a block for {first.name} in line {first.place.line} already: rcl reads both, and '
                          f'other programs may read only one', start.name)
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
            if elsewhere:
                kind, message = 'never matched', (
                    f'no node is called {name}, but there is {" and ".join(elsewhere)}: the block for it starts with '
                    f'"{elsewhere[0]}:" or "/**/{last}:"; rcl ignores this one')
            else:
                missing = 'no node matches' if '*' in name else 'there is no node'
                kind, message = 'unknown node', (f'{missing} {name}, so rcl ignores this block'
                                                 f'{nearest(name, similar or nodes, "")}')
            self._reported.add(start.name)
            self._add(start.file, start.place, kind, message, start.name)

    # -- values -----------------------------------------------------------------------------------------

    def _check_values(self) -> None:
        """Check all that a described node would get."""
        owners: dict[Assignment, list[str]] = {}
        for node, description in self._against.items():
            entries = effective(self._parser, node)
            for assignment in (each for name in self._parser.blocks_for(node) for each in self._assignments[name]):
                owners.setdefault(assignment, [])
                described = description.parameters.get(assignment.name)
                if described is not None or is_housekeeping(assignment.name):
                    owners[assignment].append(node)
                if described is not None and _winner(entries.get(assignment.name)) is assignment:
                    self._check_value(assignment, described, node)
        for assignment in (assignment for assignment, nodes in owners.items() if not nodes):
            nodes = [node for node in self._against if matches(assignment.block, node)]
            who = nodes[0] if len(nodes) == 1 else f'none of the {len(nodes)} nodes that match {assignment.block}'
            near = nearest(assignment.name, list(self._against[nodes[0]].parameters), 'It has no parameters at all')
            self._add(assignment.file, assignment.name_place, 'unknown parameter',
                      f'{who} {"has no" if len(nodes) == 1 else "has a"} parameter {assignment.name!r}{near}',
                      nodes[0], assignment.name)

    def _check_value(self, assignment: Assignment, described: DescribedParameter, node: str) -> None:
        value, name = assignment.value, assignment.name
        if assignment.is_damaged:
            return
        self._judged.add(assignment)
        if value == []:
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
            remedy = _remedy(assignment, described.descriptor.type) if objection.kind == 'wrong type' else ''
            self._add(assignment.file, assignment.place, objection.kind,
                      f'{name} of {node} cannot be {values.format_value(value, 60)}: {objection.reason}{remedy}', node,
                      name)

    # -- order ------------------------------------------------------------------------------------------

    def _check_overridden(self) -> None:
        exact = ['/' + name.strip('/') for name in self._parser.blocks if '*' not in name]
        order = {each: number for number, each in enumerate(self._parser.assignments)}
        # What is said once is left out: a file may name as many nodes as a block for all has parameters.
        often = Counter(each.name for each in self._parser.assignments)
        entries = {block: {entry.name: entry for entry in found} for block, found in self._parser.blocks.items()}
        contested = {block: [each for each in found if often[each.name] > 1 or each.name not in entries[block]]
                     for block, found in self._assignments.items()}
        winner_of = functools.cache(_winner)
        for node in dict.fromkeys((*self._against, *exact)):
            blocks = self._parser.blocks_for(node)
            for loser in (each for block in blocks for each in contested.get(block, ())):
                winner = winner_of(next((entries[block][loser.name] for block in reversed(blocks)
                                         if loser.name in entries[block]), None))
                if winner is None:
                    self._add(loser.file, loser.name_place, 'overridden',
                              f'rcl loses {loser.name} of {node}, because a map of the same name follows', node,
                              loser.name)
                elif loser is not winner and _is_surprising(loser, winner, order[loser] > order[winner]):
                    where = f'line {winner.place.line}' + (f' of {winner.file}' * (winner.file != loser.file))
                    self._add(loser.file, loser.place, 'overridden',
                              f'{node} gets {values.format_value(winner.value, 60)} for {loser.name}, from {where}: '
                              f'{_why(loser, winner)}', node, loser.name)

    # -- what rcl reads otherwise than it looks ----------------------------------------------------------

    def _check_unlikely(self) -> None:
        for start in self._parser.starts:
            if start.header != KEY:
                self._add(start.file, start.end, 'likely mistake',
                          f'{start.header} is still {KEY} for rcl, which compares no more than the beginning: write '
                          f'{KEY}, or a # before each line if {start.name} is not to get this', start.name)
            if start.list_place and not self._parser.rejected:
                self._add(start.file, start.list_place, 'likely mistake', LIST_BELOW, start.name)
        told = set()
        for each in self._parser.assignments:
            above, inner_header, _ = each.name.rpartition(f'{KEY}.')
            if inner_header and (each.file, each.block, above) not in told:
                told.add((each.file, each.block, above))
                self._add(each.file, each.name_place, 'likely mistake',
                          f'{KEY} stands below another {KEY}, so {each.block} gets a parameter {each.name}: '
                          f'{"begin the block of a node in the first column" if above else "write it once"}',
                          each.block, each.name)
            if each.nested and not self._parser.rejected:
                self._add(each.file, each.place, 'likely mistake',
                          f'ROS has no lists of {each.nested}, and rcl makes {_shortened(each.name)} = '
                          f'{values.format_value(each.value, 60)} of this: {remedy_of_nested(each.nested)}', each.block,
                          each.name)
            if each.is_array and not each.scalars and not each.is_damaged and each not in self._judged:
                self._add(each.file, each.place, 'likely mistake',
                          f'rcl gives the empty list {each.name} no type, so a node of rclpy has no value for it, and '
                          f'one of rclcpp does not start: leave the line out', each.block, each.name)
            if not each.name.isascii():
                self._check_sign(each, Scalar(each.name, each.name, each.name_place))
            for scalar in each.scalars:
                self._check_sign(each, scalar)
                if type(scalar.value) is str and each not in self._judged:
                    self._check_text(each, scalar)

    def _check_sign(self, assignment: Assignment, scalar: Scalar) -> None:
        """Find a sign that only looks like another. Quotes would say that it is meant."""
        text, place = scalar.text, scalar.place
        if not text.isascii() and place.end - place.start == len(text) and (sign := _LOOKALIKE.search(text)):
            what = 'name' if scalar.place is assignment.name_place else 'text'
            self._add(assignment.file, place, 'likely mistake',
                      f'{assignment.name}: {named_sign(sign[0])} is in it, as on web pages, so rcl reads the {what} '
                      f'{text!a}: write {text.translate(_PLAIN).strip()}', assignment.block, assignment.name)

    def _check_text(self, assignment: Assignment, scalar: Scalar) -> None:
        """Find a text that was meant to be a number, or to be filled in."""
        text, place, name = scalar.text, scalar.place, assignment.name
        if text[:1] in '+-.0123456789' and place.end - place.start == len(text) and (glued := _GLUED.fullmatch(text)):
            rest = re.sub(r'^(#|//)\s*|[,;fF]$', '', glued[2].strip())
            self._add(assignment.file, place, 'likely mistake',
                      f'{name}: rcl reads {text!r} as a text, not as a number: write {glued[1]}'
                      f'{f"  # {rest}" if rest else ""}', assignment.block, name)
        elif ('$' in text or '{' in text) and (unfilled := _UNFILLED.search(text)):
            is_ros1 = unfilled[0].startswith('$(')
            who = 'launch of ROS 2 knows no' if is_ros1 else 'neither rcl nor launch fills in'
            self._add(assignment.file, place, 'not filled in',
                      f'{name}: {who} {unfilled[0]}, so {assignment.block} gets this text: write the value'
                      f'{", or $(find-pkg-share …) or $(var …)" * is_ros1}', assignment.block, name)


def _mentions_header(lines: Iterable[str], rejected: Iterable[Rejected]) -> bool:
    """True if something in a file without blocks is like ``ros__parameters``."""
    return (any('ros_' in line and re.match(r"""[^#]*\bros__?param\w*['"]?\s*:""", line) for line in lines)
            or any(name[:1] in 'rR' and looks_like_header(name) for each in rejected for name, _ in each.keys))


def _shortened(name: str) -> str:
    return name if len(name) <= 60 else f'{name[:60]}…'


def _winner(entry: Entry | None) -> Assignment | None:
    return entry.winner() if entry is not None else None


def _is_surprising(loser: Assignment, winner: Assignment, is_later: bool) -> bool:
    """True if the author of the loser could expect it to win: it comes later, or is more specific."""
    if (loser.file, loser.block, loser.name) == (winner.file, winner.block, winner.name):
        return False  # a duplicate, which is said elsewhere
    if values.same(loser.value, winner.value):
        return False
    return is_later or (_generality(winner.block) > _generality(loser.block))


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


def _remedy(assignment: Assignment, wanted: ParameterType) -> str:
    """Return how to write a value so that it has another type; empty if that is not clear, or long."""
    items = [_converted(scalar.text, wanted) for scalar in assignment.scalars]
    if None in items or (len(items) != 1 and not wanted.is_array):
        return ''
    text = ', '.join(map(format_scalar, items))
    text = f'[{text}]' if wanted.is_array else text
    return f'; write {text}' if len(text) <= _LONGEST_REMEDY else ''


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
    return value if wanted.fits(value) else None
