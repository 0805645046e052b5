"""A launch file without its programs: what each node would get, from where, and whether the node would take it.

The launch file is carried out as ``ros2 launch`` does, but programs and packages need not be there, commands such as
``xacro`` are not run, and what only the genuine launch can start is read, too: components, and what events set off.
"""

import ast
import dataclasses
import functools
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from param_tools import values
from param_tools.cli.launch.actions import carry_out
from param_tools.cli.launch.context import Context, Origin
from param_tools.cli.launch.processes import Program
from param_tools.cli.launch.text import ROS_1
from param_tools.cli.launch.verb import include
from param_tools.files.checking import FileFinding, Findings, check_files
from param_tools.files.descriptions import Descriptions, NodeDescription
from param_tools.files.parameter_files import read_bytes
from param_tools.files.parsing import KEY, Assignment, Parser, effective, matches

# The beginning of a substitution of launch, and a variable of a shell.
_SUBSTITUTION = re.compile(r'\$\(([a-z][\w-]*)|^\$\{?([A-Z][A-Z0-9_]*)\b\}?')


@dataclass
class Rehearsal(Context):
    """A launch that starts nothing."""

    warnings: list[FileFinding] = field(default_factory=list)
    """What launch would warn of; without a file if it is not known where that is written."""

    def warn(self, text: str, origin: Origin | None, kind: str = 'unreadable') -> None:
        line = origin.line or 0 if origin else 0
        self.warnings.append(FileFinding(str(origin.file) if origin else '', line, int(line > 0), kind, text))

    def find_program(self, package: str, executable: str) -> list[str]:
        return [f'{package}/{executable}']

    def find_executable(self, name: str) -> str:
        return name

    def output_of(self, command: Sequence[str]) -> str:
        """Return a stand-in that a check takes for something that launch fills in."""
        return f'$(command {Path(command[0]).name})'

    def expect_launchable(self, what: str) -> None:
        """Accept what only the genuine launch can start."""


@dataclass(frozen=True)
class Given:
    """A value that a node gets."""

    name: str
    value: Any
    source: str
    """The file that holds it, with the line where that is known."""


@dataclass
class RehearsedNode:
    """A node that a launch file starts."""

    program: str
    """``package/executable``, or ``package/plugin`` of a component."""
    name: str
    """Its full name."""
    has_name: bool
    """False if the launch file leaves the name to the program, so that it is taken to be the program's."""
    files: list[Path] = field(default_factory=list)
    """The parameter files that it gets, in this order, with those that launch writes."""

    @functools.cached_property
    def winners(self) -> list[tuple[str, Assignment]]:
        """The names of the parameters that it gets, sorted, and where each value comes from."""
        parser = Parser(tolerant=True)
        for path in self.files:
            if path.is_file():
                parser.parse(read_bytes(path), str(path))
        return [(name, winner) for name, entry in sorted(effective(parser, self.name).items())
                if (winner := entry.winner()) is not None]

    def description(self, known: Descriptions) -> NodeDescription | None:
        """Return the description of a node of this name, or else the one that is named like its program."""
        executable = self.program.rpartition('/')[2]
        like = [each for each in known.values() if each.node.rpartition('/')[2] == executable]
        found = known.get(self.name) or (like[0] if len(like) == 1 else None)
        return None if found is None else dataclasses.replace(found, node=self.name)


class RehearsedLaunch:
    """The nodes that a launch file starts, and the files that they get."""

    def __init__(self, path: Path, arguments: Mapping[str, str], folder: Path):
        """Carry out a launch file without starting anything.

        :param folder: Where parameter files are written.
        """
        self.path = path
        self._context = Rehearsal(folder=folder, log=self._note)
        self._given: dict[str, Any] = {}
        """For each file with one value, what that is in the launch file."""
        programs = carry_out([include(path, arguments)], self._context)
        # A spawner hands on each of these, and the node of a controller reads it with rcl.
        self._spawned = [Path(file) for each in programs if each.command[0] == 'controller_manager/spawner'
                         for word, file in zip(each.command, each.command[1:]) if word in ('-p', '--param-file')
                         and Path(file).is_file()]
        self.nodes = [node for program in programs if (node := self._node(program)) is not None]

    def _note(self, level: str, _name: str, text: str) -> None:
        if level == 'WARNING':
            self._context.warn(text, None)

    def _node(self, program: Program) -> RehearsedNode | None:
        words = program.command
        if '--ros-args' not in words:
            return None
        options = list(_ros_options(words))
        names = {rule.partition(':=')[0]: rule.partition(':=')[2] for option, rule in reversed(options)
                 if option == '-r'}
        # A plugin is a class in a namespace of C++, and a node's name is a word.
        executable = re.sub(r'\W', '_', words[0].rpartition('/')[2].removesuffix('.py').rpartition('::')[2])
        node = RehearsedNode(words[0], f'{names.get("__ns", "/").rstrip("/")}/{names.get("__node", executable)}',
                             '__node' in names)
        for option, text in options:
            if option == '--params-file':
                node.files.append(Path(text))
            elif option == '-p':
                name, _, value = text.partition(':=')
                path = self._context.write(f'/**:\n  {KEY}:\n    {name}: {value}\n', self._context.origins.get(text))
                node.files.append(path)
                self._given[str(path)] = self._context.given.get(text)
        return node

    def given(self, node: RehearsedNode) -> list[Given]:
        """Return what a node gets, by name."""
        return [Given(name, winner.value, _written(*self._place(winner.file, winner.place.line, name)))
                for name, winner in node.winners]

    def lines(self) -> Iterator[str]:
        """Return the lines that say what each node gets."""
        for node in self.nodes:
            yield f'{node.name}  ({node.program}{"" if node.has_name else ", whose node may have another name"})'
            given = self.given(node)
            lines = [f'  {each.name}: {values.format_value(each.value, 60)}' for each in given]
            width = max(map(len, lines), default=0)
            yield from (f'{line:{width}}  {each.source}' for line, each in zip(lines, given))
            if not given:
                yield '  no parameters'

    def check(self, known: Descriptions) -> Findings:
        """Find what no node would get, and what a node would reject."""
        found: dict[FileFinding, None] = {}
        for warning in self._context.warnings:
            found[dataclasses.replace(warning, file=warning.file or str(self.path))] = None
        found.update(dict.fromkeys(each for path in self._spawned for each in check_files(path)))
        left: dict[str, None] = {}
        for node in self.nodes:
            description = node.description(known)
            files = [path for path in node.files if path.is_file()]
            result = check_files(files, Descriptions([] if description is None else [description]))
            others = [each.name for each in self.nodes if each is not node]
            own = list(self._changed_on_the_way(node, description))
            told = {(each.file, each.parameter) for each in own}
            for each in (*own, *(each for each in result if (each.file, each.parameter) not in told),
                         *self._never_matched(node, files)):
                if each.kind != 'unknown node' or not any(matches(each.node, other) for other in others):
                    found[self._moved(each)] = None
            for place in result.left_to_launch:
                file, _, line = place.rpartition(':')
                if file in self._context.origins and self._context.origins[file].is_filled_in:
                    left[_written(*self._place(file, int(line), ''))] = None
        findings = Findings(found)
        findings.left_to_launch = tuple(left)
        if known:
            findings.passed_over = tuple(node.name for node in self.nodes if node.description(known) is None)
        return findings

    def _changed_on_the_way(self, node: RehearsedNode, description: NodeDescription | None) -> Iterator[FileFinding]:
        """Find the values that the node gets otherwise than the author of the launch file or of a file may expect."""
        for name, winner in node.winners:
            origin, given = self._context.origins.get(winner.file), self._given.get(winner.file)
            is_of_launch = origin is not None and origin.line is not None
            value = values.format_value(winner.value, 60)
            texts = [each.text for each in winner.scalars if not isinstance(each.value, str) and is_of_launch
                     and (isinstance(given, str) or isinstance(yaml.safe_load(each.text), str))]
            known = None if description is None else description.parameters.get(name)
            left = _SUBSTITUTION.search(str(winner.value)) if origin is None or not origin.is_filled_in else None
            kind = 'likely mistake'
            if texts and (known is None or isinstance(winner.value, list) or known.objection(winner.value)):
                what = (f'launch gives {node.name} the text {texts[0]!r} for {name} without its quotes, so that rcl '
                        f'reads {value}: write it with quotes in a parameter file')
            elif isinstance(given, tuple) and isinstance(winner.value, str):
                what = (f'SetParameter writes the list as Python does, so that {node.name} gets the text {value} for '
                        f'{name}: give the list in parameters= or in a file')
            elif is_of_launch and KEY in name.split('.'):
                what = (f'launch takes the whole dictionary for parameters, so that {node.name} gets a parameter '
                        f'{name}: give the path of the file, or only what is below {KEY}')
            elif left:
                kind, remedy = 'not filled in', ''
                if left[2]:
                    remedy = f' Neither launch nor rcl replaces {left[0]}: write $(env {left[2]}).'
                elif left[1] in ROS_1:
                    remedy = f' Launch has no {left[0]} …), which is of ROS 1: write $({ROS_1[left[1]]} …).'
                what = (f'{node.name} gets this text as it stands: launch replaces a part of a file only if it is '
                        f'given as ParameterFile(…, allow_substs=True).{remedy}')
            else:
                continue
            yield FileFinding(winner.file, winner.place.line, winner.place.column, kind, what.rstrip('.'), node.name,
                              name)

    def _never_matched(self, node: RehearsedNode, files: Sequence[Path]) -> Iterator[FileFinding]:
        """Find the files that a node is given and that hold nothing for it."""
        # What a container gets is for the components in it, too.
        if not node.has_name or 'component_container' in node.program:
            return
        for path in files:
            parser = Parser(tolerant=True)
            parser.parse(read_bytes(path), str(path))
            # One file for several nodes is usual.
            if parser.blocks and not parser.rejected and not any(parser.blocks_for(each.name) for each in self.nodes):
                start = parser.starts[0]
                yield FileFinding(str(path), start.place.line, start.place.column, 'never matched',
                                  f'the launch file gives {node.name} this file, and no block in it is for that node: '
                                  f'it has {", ".join(parser.blocks)}', node.name)

    def _moved(self, finding: FileFinding) -> FileFinding:
        """Return a finding where a person can mend it: not in a file that launch writes."""
        def written(match: re.Match[str]) -> str:
            return _written(*self._place(match[2], int(match[1]), finding.parameter))

        message = re.sub(rf'line (\d+) of ({re.escape(str(self._context.folder))}\S+?)(?=[,;:)]|$)', written,
                         finding.message)
        if finding.file in self._given:
            message = re.sub('^rcl rejects the file here: this is not YAML: ([^.]*).*',
                             r'rcl rejects this value, which is no YAML: \1', message)
        path, line = self._place(finding.file, finding.line, finding.parameter)
        origin = self._context.origins.get(finding.file)
        is_kept = path == finding.file if origin is None else origin.line is None and not origin.lines
        column = finding.column if is_kept else int(line > 0)
        return dataclasses.replace(finding, file=path, line=line, column=column, message=message)

    def _place(self, file: str, line: int, name: str) -> tuple[str, int]:
        """Return the file in which a person has written a value, and the line; 0 if that isn't known."""
        if Path(file).parent != self._context.folder:
            return file, line
        origin = self._context.origins.get(file)
        if origin is None:
            return str(self.path), 0
        if origin.lines or not origin.is_filled_in:
            return str(origin.file), origin.lines.get(name, 0)
        if origin.line is None:
            return str(origin.file), line
        return str(origin.file), _line_of_key(origin, name) or origin.line


def _written(file: str, line: int) -> str:
    return f'{file}:{line}' if line else file


@functools.lru_cache(16)
def _calls(source: bytes) -> list[ast.Call]:
    """Return the calls in Python code, inner ones first. Each value of a launch file asks about the same code."""
    found = [each for each in ast.walk(ast.parse(source)) if isinstance(each, ast.Call)]
    return sorted(found, key=lambda each: (each.end_lineno or 0) - each.lineno)


def _line_of_key(origin: Origin, name: str) -> int:
    """Return where the dictionary that a call is given writes out the name of a parameter; 0 if it does not."""
    if origin.file.suffix != '.py':
        return 0
    for call in _calls(origin.file.read_bytes()):
        if call.lineno == origin.line:
            given = next((each.value for each in call.keywords if each.arg == 'parameters'), None)
            if isinstance(given, ast.List) and not any(isinstance(each, ast.Starred) for each in given.elts):
                return dict(_keys(given.elts[origin.number], '')).get(name, 0)
    return 0


def _keys(found: ast.expr, prefix: str) -> Iterator[tuple[str, int]]:
    """Return the names that a dictionary writes out, each with its line."""
    # What is unpacked into it may have any names.
    if isinstance(found, ast.Dict) and None not in found.keys:
        for key, value in zip(found.keys, found.values):
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                yield f'{prefix}{key.value}', key.lineno
                yield from _keys(value, f'{prefix}{key.value}.')


def _ros_options(words: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Return the options of a command line that are for ROS, each with the word after it."""
    is_ros = False
    for word, after in zip(words, (*words[1:], '')):
        if word in ('--ros-args', '--'):
            is_ros = word == '--ros-args'
        elif is_ros and word in ('-p', '-r', '--params-file', '--param', '--remap'):
            yield {'--param': '-p', '--remap': '-r'}.get(word, word), after
