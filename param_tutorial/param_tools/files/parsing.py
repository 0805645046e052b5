"""rcl's parser of parameter files, event by event, with the place of everything it reads. No ROS, no Jupyter.

What it makes of a file is what a node gets from ``--params-file``. It follows rcl, oddities included: of two blocks
that match the node the one whose name appeared later wins, however specific the other, and a second file adds to the
blocks of the first where they stand; a name given twice with two types keeps the first of boolean, integer, double,
string. A tolerant parser notes what rcl would reject and reads on, where that is possible, so that one look at a file
finds all that is wrong with it.
"""

import codecs
import ctypes
import functools
import re
import sys
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import yaml

from param_tools import values
from param_tools.files.node_names import flaw_of_block_name

KEY = 'ros__parameters'
# In a list of maps each map makes a name longer. A tolerant parser need not know the whole of a name of thousands.
_LONGEST_NAME = 5_000
# libyaml is what rcl uses; PyYAML's own parser differs from it in corners, but is always there.
LOADER = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)

# -- how rcl types a scalar (rcl_yaml_param_parser/src/parse.c, get_value) ---------------------------------

_TRUE = {'Y', 'y', 'yes', 'Yes', 'YES', 'true', 'True', 'TRUE', 'on', 'On', 'ON'}
_FALSE = {'N', 'n', 'no', 'No', 'NO', 'false', 'False', 'FALSE', 'off', 'Off', 'OFF'}
_SPECIAL = {'.nan', '.NaN', '.NAN', '.inf', '.Inf', '.INF', '+.inf', '+.Inf', '+.INF', '-.inf', '-.Inf', '-.INF'}
# Most scalars are a decimal number, of which C and Python make the same, or begin as no number does.
_INTEGER, _DOUBLE = re.compile('-?(?:0|[1-9][0-9]{0,17})'), re.compile('-?[0-9]{1,15}[.][0-9]{0,15}')
_NO_NUMBER = re.compile('[^-+.0-9iInN\\s]')
# The C library, whose functions rcl reads the others with.
_C = ctypes.CDLL('ucrtbase' if sys.platform == 'win32' else None, use_errno=True)
_C.strtoll.restype = ctypes.c_longlong
_C.strtod.restype = ctypes.c_double


def typed(text: str, quoted: bool) -> bool | int | float | str:
    """Return the value that rcl makes of a scalar."""
    if not quoted:
        if text in _TRUE:
            return True
        if text in _FALSE:
            return False
        if _INTEGER.fullmatch(text):
            return int(text)
        if _DOUBLE.fullmatch(text):
            return float(text)
        if _NO_NUMBER.match(text):
            return text
        number = _as_a_whole(text, _C.strtoll, 0)  # 0x10 is 16 and 010 is 8
        if number is None:
            number = _as_a_whole(text.replace('.', '', 1) if text in _SPECIAL else text, _C.strtod)
        if number is not None:
            return number
    return text


def _as_a_whole(text: str, function: Any, *base: int) -> int | float | None:
    """Return the number that a function of C reads; None if it reads only a part, or the number is out of its range."""
    content = ctypes.create_string_buffer(text.encode(errors='surrogatepass'))
    end = ctypes.c_void_p()
    ctypes.set_errno(0)
    number: int | float = function(content, ctypes.byref(end), *base)
    is_whole = end.value == ctypes.addressof(content) + len(content.value) and len(content.value) > 0
    return number if is_whole and ctypes.get_errno() == 0 else None


# -- what is read ---------------------------------------------------------------------------------------------


class Place(NamedTuple):
    """Where something stands in a file. Lines and columns count from 1."""

    line: int = 1
    column: int = 1
    start: int = 0
    """Characters before it, as YAML counts them."""
    end: int = 0
    """Characters before its end."""


class Scalar(NamedTuple):
    """One value as it is written."""

    text: str
    value: bool | int | float | str
    """What rcl makes of it."""
    place: Place


@dataclass(eq=False, slots=True)
class Assignment:
    """A name and a value in a file."""

    file: str
    block: str
    name: str
    """The full name, with dots."""
    name_place: Place
    place: Place
    """Where the value stands."""
    is_array: bool = False
    scalars: list[Scalar] = field(default_factory=list)
    is_damaged: bool = False
    """rcl rejects a part of it."""
    nested: str = ''
    """What stands in it as it is written, 'lists' or 'maps', though rcl makes one list of it; empty if nothing does."""

    @property
    def value(self) -> Any:
        """What rcl makes of it."""
        return [each.value for each in self.scalars] if self.is_array else self.scalars[0].value

    @property
    def kind(self) -> type | None:
        """The Python type of the value, or of the elements of an array; None if it has no elements."""
        return type(self.scalars[0].value) if self.scalars else None


@dataclass(eq=False, slots=True)
class BlockStart:
    """The head of a block: a node's name, or a pattern for such names, and ``ros__parameters`` below it."""

    file: str
    name: str
    place: Place
    end: Place
    """Where ``ros__parameters`` stands."""
    header: str
    """How that is written: rcl compares no more than its beginning."""
    list_place: Place | None = None
    """Where a list stands below it in place of parameters."""


@dataclass(eq=False, slots=True)
class Entry:
    """One parameter of a block, with all that the files say about it."""

    name: str
    place: Place
    assignments: list[Assignment] = field(default_factory=list)
    """In the order of the files."""

    def last(self, is_array: bool, kind: type) -> Assignment | None:
        """Return the last assignment of a type."""
        return next((each for each in reversed(self.assignments)
                     if each.is_array is is_array and each.kind is kind), None)

    def winner(self) -> Assignment | None:
        """Return the assignment that the value comes from. Of several types rcl keeps a value each, and rclpy takes the
        first: of single values before arrays, of boolean, integer, double, string."""
        found = (self.last(is_array, kind) for is_array in (False, True) for kind in _KINDS)
        return next(filter(None, found), self.assignments[-1] if self.assignments else None)

    def value(self) -> Any:
        """Return what a node gets: ``[]`` for an empty array, None for nothing."""
        winner = self.winner()
        return winner and winner.value


_KINDS = (bool, int, float, str)


class Rejected(Exception):
    """rcl would reject the file at this place."""

    def __init__(self, place: Place, reason: str, keys: Sequence[tuple[str, Place]] = ()):
        super().__init__(reason)
        self.place = place
        self.keys = tuple(keys)
        """The keys above a value that stands before ``ros__parameters``, each with its place."""


def matches(block: str, node: str) -> bool:
    """True if a block of this name is for the node: ``*`` is one name, ``**`` any number of them, also none.

    :param block: May also be what somebody typed; what is no pattern matches nothing.
    """
    return _pattern(block).fullmatch(node) is not None


def _with_slash(block: str) -> str:
    return block if block.startswith('/') else '/' + block


@functools.lru_cache(10_000)
def _pattern(block: str) -> re.Pattern[str]:
    parts = re.split(r'(/\*\*|\*)', _with_slash(block))
    pattern = ''.join({'/**': r'(/\w+)*', '*': r'\w+'}.get(part) or re.escape(part) for part in parts)
    return re.compile(pattern, re.ASCII)


class Parser:
    """rcl's state machine over the events of the YAML library (parse.c, parse_file_events).

    It is not the obvious recursive reading of a tree: rcl tracks the namespace of the node and of the
    parameter in two strings, and what it accepts beyond the obvious follows from that.
    """

    def __init__(self, *, tolerant: bool = False):
        """:param tolerant: Note what rcl would reject in ``rejected``, and read on as far as that is possible."""
        self.blocks: dict[str, list[Entry]] = {}
        """What was read so far, by the names of the blocks, in the order in which the names first appeared."""
        # The blocks for one node each, and those with wildcards: their numbers and names. A file may have thousands.
        self._exact: defaultdict[str, list[tuple[int, str]]] = defaultdict(list)
        # The latter by the last word, or by '*' if that is none.
        self._wild: defaultdict[str, list[tuple[int, str]]] = defaultdict(list)
        # Where in each block the entries of a name are: a file may hold ten thousand.
        self._places: defaultdict[tuple[str, str], set[int]] = defaultdict(set)
        self.starts: list[BlockStart] = []
        self.assignments: list[Assignment] = []
        self.rejected: list[Rejected] = []
        self._tolerant = tolerant
        self._begin('')

    def _begin(self, file: str) -> None:
        self.file = file
        self.block: list[Entry] = []
        self.block_name = ''
        self.entry = 0
        self.in_parameters = False
        self.depth = 0
        self.node_path = ''
        self.node_keys: list[tuple[str, Place]] = []
        self.parameter_path, self.parameter_parts = '', 0
        self.name_place = Place()
        self.expects_key = True
        self.is_new_map = False
        self.in_sequence = False
        self.assignment: Assignment | None = None
        self.item_type: type | None = None

    def parse(self, content: bytes, file: str = '') -> dict[str, list[Entry]]:
        """Read a file, in addition to those that were read before; return the blocks of all.

        :param file: Its name, for the assignments.
        :raises Rejected: rcl would reject it here; a tolerant parser notes that, and returns what it has read.
        """
        self._begin(file)
        try:
            self._parse(content)
        except Rejected as rejected:
            if not self._tolerant:
                raise
            self.rejected.append(rejected)
        return self.blocks

    def blocks_for(self, node: str) -> list[str]:
        """Return the names of the blocks for a node, in the order in which they first appeared.

        :param node: Fully qualified name.
        """
        wild = [*self._wild.get(node.rpartition('/')[2], ()), *self._wild.get('*', ())]
        return [name for _, name in sorted([*self._exact.get(node, ()),
                                            *(each for each in wild if matches(each[1], node))])]

    def _parse(self, content: bytes) -> None:
        held: yaml.Event | None = None
        try:
            for event in yaml.parse(content, Loader=LOADER):
                if held is not None:
                    self._handle(held, _place(held))
                # A scalar before the place where the file ceases to be YAML has often swallowed the next line.
                held = event if self._tolerant and isinstance(event, yaml.ScalarEvent) else None
                if held is None:
                    self._handle(event, _place(event))
        except yaml.YAMLError as error:
            raise not_yaml(error, content) from None
        except RecursionError:
            raise Rejected(Place(), 'this is nested too deeply') from None

    def _object(self, place: Place, reason: str, keys: Sequence[tuple[str, Place]] = ()) -> None:
        """Reject what stands here, unless the parser is tolerant and can leave it out."""
        rejected = Rejected(place, reason, keys)
        if not self._tolerant:
            raise rejected
        self.rejected.append(rejected)

    def _handle(self, event: yaml.Event, place: Place) -> None:
        if isinstance(event, yaml.ScalarEvent):
            if self.expects_key:
                self._key(event, place)
                self.expects_key = False
            else:
                self._value(event, place)
                self.expects_key = not self.in_sequence
        elif isinstance(event, yaml.MappingStartEvent):
            self.depth += 1
            self.expects_key = True
            self.is_new_map = not (self.in_parameters and self.depth - len(self.node_keys) == 3)
        elif isinstance(event, yaml.MappingEndEvent):
            self._leave_mapping()
        elif isinstance(event, yaml.SequenceStartEvent):
            self._begin_sequence(place)
        elif isinstance(event, yaml.SequenceEndEvent):
            self.in_sequence, self.expects_key = False, True
            if not self.in_parameters:
                self._leave_node_key()
            else:
                self.assignment = None
        elif isinstance(event, yaml.AliasEvent):
            reason = f'ROS reads no aliases: write the value itself instead of *{event.anchor}'
            if self.expects_key:
                raise Rejected(place, reason)
            self._object(place, reason)
            self.expects_key = not self.in_sequence

    def _begin_sequence(self, place: Place) -> None:
        if self.expects_key:
            raise Rejected(place, 'a list cannot stand here; a parameter is a value or a list of values, never a list '
                                  'of lists: write one list')
        is_inner, self.in_sequence = self.in_sequence, True
        if not self.in_parameters:
            self._object(place, f'a list cannot stand before {KEY}', self.node_keys)
            return
        if not is_inner and self.depth == len(self.node_keys) + 2:
            self.starts[-1].list_place = place
        self.item_type = None
        # A list in a list is read as if the outer one began anew.
        if is_inner and self.assignment:
            self.assignment.nested = 'lists'
        elif self.entry < len(self.block):
            self._assign(place, is_array=True)

    def _leave_mapping(self) -> None:
        if not self.in_parameters:
            if self.depth == len(self.node_keys) + 1:
                self._leave_node_key()
        elif self.parameter_parts:
            self.parameter_path = _shortened(self.parameter_path, self.parameter_parts, '.')
            self.parameter_parts -= 1
        else:
            self.in_parameters = False
        self.depth -= 1

    def _leave_node_key(self) -> None:
        self.node_path = _shortened(self.node_path, len(self.node_keys), '/')
        del self.node_keys[-1:]

    def _key(self, event: yaml.ScalarEvent, place: Place) -> None:
        if not event.value:
            raise Rejected(place, 'there is a value without a name')
        name = _c_string(event.value)
        if not self.in_parameters:
            self._node_key(name, place)
            return
        if self.is_new_map:
            if self.entry >= len(self.block):
                raise Rejected(place, f'cannot tell which parameter {name} belongs to; an empty map before it may '
                                      f'be the cause')
            self.parameter_path = self.block[self.entry].name
            self.parameter_parts += 1
            self.is_new_map = False
        self.name_place = place
        if not self.parameter_parts:
            self._select(name, place)
        else:
            self._select(self.parameter_path, place)
            entry = self.block[self.entry]
            if self._tolerant and len(entry.name) > _LONGEST_NAME:
                return
            self._places[self.block_name, entry.name].remove(self.entry)
            entry.name, entry.place = f'{self.parameter_path}.{name}', place
            self._places[self.block_name, entry.name].add(self.entry)
            if self.in_sequence and self.assignment in entry.assignments:
                # A map in a list: rcl gives the list the longer name.
                self.assignment.name, self.assignment.name_place = entry.name, place
                self.assignment.nested = 'maps'

    def _node_key(self, name: str, place: Place) -> None:
        if not name.startswith(KEY):
            if not name:
                raise Rejected(place, 'there is a block without a name')
            separator = '/' if self.node_keys and not self.node_path.endswith('/') else ''
            self.node_path += separator + name
            self.node_keys.append((name, place))
            return
        if not self.node_keys:
            raise Rejected(place, f'there is no node name before {KEY}; start with "/name_of_the_node:" or "/**:"')
        if flaw := flaw_of_block_name(self.node_path):
            self._object(self.node_keys[-1][1],
                         f'{values.format_value(self.node_path, 60)} is not a node name: {flaw}. A name has letters, '
                         f'digits and underscores between slashes, or * and ** for any')
        self.block_name = self.node_path
        self._enter(self.node_path)
        self.starts.append(BlockStart(self.file, self.node_path, self.node_keys[-1][1], place, name))
        self._leave_node_key()
        self.in_parameters = True

    def _enter(self, name: str) -> None:
        """Go on in the block of a name, which may be a new one."""
        if name not in self.blocks:
            last = name.rpartition('/')[2]
            (self._exact[_with_slash(name)] if '*' not in name else self._wild['*' if '*' in last else last]).append(
                (len(self.blocks), name))
        self.block = self.blocks.setdefault(name, [])

    def _select(self, name: str, place: Place) -> None:
        places = self._places[self.block_name, name]
        if not places:
            places.add(len(self.block))
            self.block.append(Entry(name, place))
        self.entry = min(places)

    def _value(self, event: yaml.ScalarEvent, place: Place) -> None:
        if not self.in_parameters or not self.block:
            glued = re.match(r'[\w.]+:\S+', event.value)
            if self.in_parameters and not self.in_sequence and not event.value:
                reason = f'{KEY} has no parameters below it: indent them, or write {KEY}: {{}} for none'
            else:
                reason = (f'a space must follow the colon in {glued[0]}' if glued else
                          f'there is a value before {KEY}: it has to be node name, {KEY}, then parameters')
            self._object(place, reason, self.node_keys)
            if not self.in_sequence:
                self._leave_node_key()
            return
        if self.entry >= len(self.block):
            raise Rejected(place, 'there is a value without a name')
        quoted = event.style in ("'", '"')
        entry = self.block[self.entry]
        if not event.value and not quoted:
            self._object(place, f"{entry.name} has no value; for an empty string write ''")
            return
        is_text = quoted or event.tag == 'tag:yaml.org,2002:str'
        text = _c_string(event.value)
        scalar = Scalar(text, typed(text, is_text), place)
        kind = type(scalar.value)
        if not self.in_sequence:
            self._assign(place, is_array=False).scalars.append(scalar)
            return
        # It is not that of the entry if a map in the list has begun another one.
        array = self.assignment if self.assignment in entry.assignments else None
        if self.item_type is None:
            self.item_type = kind
            if array is None or array.kind not in (None, kind):
                array = self._assign(place, is_array=True)
            array.scalars.clear()
        array = array or entry.last(True, kind)
        if self.item_type is not kind or array is None:
            before = self.assignment
            if before is None or not (before.is_damaged and before.nested):
                self._object(place, f'the elements of {entry.name} must all be of one type; {event.value!r} is '
                                    f'{values.describe_type(scalar.value)}{_why_mixed(scalar, before)}')
            if before is not None:
                before.is_damaged = True
            return
        array.scalars.append(scalar)

    def _assign(self, place: Place, *, is_array: bool) -> Assignment:
        entry = self.block[self.entry]
        assignment = Assignment(self.file, self.block_name, entry.name, self.name_place, place, is_array)
        entry.assignments.append(assignment)
        self.assignments.append(assignment)
        self.assignment = assignment if is_array else None
        return assignment


def remedy_of_nested(nested: str) -> str:
    """Return what to write in place of a list of 'lists' or of 'maps'."""
    return 'write one list' if nested == 'lists' else 'give each map a name in place of its dash'


def _why_mixed(scalar: Scalar, before: Assignment | None) -> str:
    """Return of which type the elements before another are, and what to write."""
    if before is None or not before.scalars:
        return ', and those before it are not'
    first = before.scalars[0]
    reason = f', and {first.text!r} is {values.describe_type(first.value)}: '
    if before.nested:
        return f'{reason}ROS has no lists of {before.nested}, so {remedy_of_nested(before.nested)}'
    if any(re.match(r'[-+]?0\d', each.text) for each in (*before.scalars, scalar)):
        return f'{reason}leave out the zeros before them, or put each of them into quotes if they are texts'
    if {type(scalar.value), before.kind} == {int, float}:
        return f'{reason}write each of them with a dot, as in {float(first.value)}'
    return f"{reason}put each of them into quotes if they are texts, as in '{scalar.text}'"


def effective(parser: Parser, node: str) -> dict[str, Entry]:
    """Return the parameters that what was read holds for a node, in the order of the files.

    :param node: Fully qualified name.
    """
    return {entry.name: entry for name in parser.blocks_for(node) for entry in parser.blocks[name]}


def _place(event: yaml.Event) -> Place:
    start, end = event.start_mark, event.end_mark
    assert start and end  # only an event that a program makes may lack them
    return Place(start.line + 1, start.column + 1, start.index, end.index)


def not_yaml(error: yaml.YAMLError, content: bytes) -> Rejected:
    """Return where a file is not YAML, and why, with the usual cause where there is one."""
    if isinstance(error, yaml.reader.ReaderError):
        return _not_text(error, content)
    mark, begun = getattr(error, 'problem_mark', None), getattr(error, 'context_mark', None)
    if mark is None:
        return Rejected(Place(), f'this is not YAML: {str(error).splitlines()[0]}')
    what, context = getattr(error, 'problem', ''), getattr(error, 'context', '')
    if begun is not None and context in ('while scanning a simple key', 'while scanning a quoted scalar'):
        mark = begun  # libyaml notices only later that something is missing
    elif begun is not None and begun.line != mark.line:
        what += f', in what begins in line {begun.line + 1}'
    lines = content.decode('utf-8-sig', 'replace').splitlines()
    line = lines[mark.line] if mark.line < len(lines) else ''
    cause = _likely_cause(what, line[:mark.column], line[mark.column:])
    return Rejected(Place(mark.line + 1, mark.column + 1), f'this is not YAML: {what}{cause and ". "}{cause}')


def _not_text(error: yaml.reader.ReaderError, content: bytes) -> Rejected:
    """Return which bytes of a file are no text, or none that YAML allows."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return Rejected(Place(), f'this is not UTF-16, as its first bytes say: {error.reason}')
    try:
        before, reason = content.decode().partition(chr(error.character))[0], f'this is not YAML: {error.reason}'
    except UnicodeDecodeError as wrong:
        byte = content[wrong.start:wrong.start + 1]
        before = content[:wrong.start].decode()
        reason = f'this is not UTF-8: the byte 0x{byte.hex()}'
        if meant := byte.decode('cp1252', 'ignore'):
            reason += f' would be {meant!r} in Windows-1252'
    before = before.removeprefix('\ufeff')
    return Rejected(Place(before.count('\n') + 1, len(before) - before.rfind('\n')), reason)


def _likely_cause(what: str, before: str, after: str) -> str:
    """Return what is probably wrong where libyaml stopped; nothing if that cannot be told.

    :param before: What stands before the place in its line.
    """
    if before.strip(' ').startswith('\t') or (not before.strip(' ') and after.startswith('\t')):
        return 'Indent with spaces: YAML allows no tab there'
    if what.startswith('found character that cannot start') and after:
        return f'A text that begins with {after[0]} needs quotes'
    if what.startswith(("could not find expected ':'", 'mapping values')):
        return ('A name ends with a colon and a space, the names of one block begin in the same column, and a text '
                "with ': ' in it needs quotes")
    if what.startswith('did not find expected key'):
        return 'The names of one block begin in the same column, and a quote inside quotes is written twice'
    return ''


def _c_string(text: str) -> str:
    """Return a text cut where C would cut it: at the first NUL."""
    return text.partition('\0')[0]


def _shortened(path: str, parts: int, separator: str) -> str:
    """Return a path without its last part."""
    if parts <= 1:
        return ''
    return path.rpartition(separator)[0] if separator in path else path
