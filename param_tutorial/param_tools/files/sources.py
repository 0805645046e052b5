"""The parameters that the source of a package declares, compared with its parameter files. No ROS, no Jupyter.

Python and C++ are searched as text, and nothing is run: of a name that is put together, only the parts that stand there
are known, and a name counts as declared, too, if it or its end stands in quotes anywhere.
"""

import difflib
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from param_tools.descriptor import is_housekeeping
from param_tools.errors import ParameterFileError
from param_tools.files.checking import FileFinding
from param_tools.files.parameter_files import read_bytes
from param_tools.files.parsing import Parser

_LITERAL = r'''[fFrRbBuUL]*(?:"((?:\\.|[^"\\\n])*)"|'((?:\\.|[^'\\\n])*)')'''
_CALL = re.compile(r'\bdeclare\w*[pP]aram\w*\s*(?:<[^;{}()]*>)?\s*\(')
_SUFFIXES = {'.py', '.c', '.cc', '.cpp', '.cxx', '.h', '.hh', '.hpp', '.hxx'}
# Nothing below these is shipped, or is the source of a node.
_ASIDE = re.compile(r'tests?|build|install|log|.*\.launch\..*|.*_launch\.py|launch|\..*')
# The head of a function that declares for its callers.
_DEFINES = re.compile(r'\bdef \w*$|\bdef \w+\(|\((?:\s*|[^()]*,\s*)(?:const|std::|auto|rclcpp::|\w+::SharedPtr)\b')
# With these words in a package, nodes declare what no call names.
_ANY_NAME = re.compile(r'automatically_declare_parameters_from_overrides|allow_undeclared_parameters|'
                       r'generate_parameter_(?:library|module)')


@dataclass
class Source:
    """What the text of a package declares."""

    declared: dict[str, tuple[Path, int]] = field(default_factory=dict)
    """Names, with * for what is not known of one, each with its first file and line."""
    literals: set[str] = field(default_factory=set)
    """All texts in quotes."""
    nameless: str = ''
    """Where something is declared of which the text does not tell the name; empty if nothing is."""

    def names(self, parameter: str) -> bool:
        """True if a call declares a parameter, or its name or the end of it stands in quotes."""
        return (is_housekeeping(parameter) or any({end, f'.{end}'} & self.literals for end in _ends(parameter))
                or any('*' in name and re.fullmatch(re.escape(name).replace(r'\*', '.+'), parameter)
                       for name in self.declared))


def read_source(folder: Path) -> Source:
    """Search the text of a package.

    :raises ParameterFileError: there is no such folder.
    """
    if not folder.is_dir():
        raise ParameterFileError(f'{folder} is not a folder')
    found = Source()
    for path in _files(folder, _SUFFIXES | {'.txt', '.xml'}):
        text = read_bytes(path).decode(errors='replace')
        if words := _ANY_NAME.search(text):
            found.nameless = found.nameless or f'{path} has {words[0]}'
        if path.suffix not in _SUFFIXES:
            continue
        comment = r'#[^\n]*' if path.suffix == '.py' else r'//[^\n]*|/\*.*?\*/'
        text = re.sub(f'{_LITERAL}|({comment})', lambda each: '\n' * each[0].count('\n') if each[3] else each[0], text,
                      flags=re.DOTALL)
        found.literals.update(one or other for one, other in re.findall(_LITERAL, text))
        for call in _CALL.finditer(text):
            place = path, text.count('\n', 0, call.start()) + 1
            names = list(_names(call[0], text[max(0, call.start() - 1)], text[call.end():call.end() + 4000]))
            if not names and not _DEFINES.search(text[max(0, call.start() - 40):call.end() + 40]):
                found.nameless = found.nameless or f'{path}:{place[1]} declares a name that the text does not tell'
            for name in names:
                found.declared.setdefault(name, place)
    return found


def compare_source(folder: Path, paths: Iterable[str | Path] = ()) -> tuple[list[FileFinding], list[str]]:
    """Compare what the source of a package declares with its parameter files.

    :param paths: The files; without any, all that the folder has.
    :return: What is in a file and nowhere declared, and what is declared and in no file; and what was not compared, in
        sentences: blocks of which the source declares nothing are for nodes of other packages.
    :raises ParameterFileError: the folder or a file cannot be read.
    """
    source, parser, notes = read_source(folder), Parser(tolerant=True), []
    for path in paths or _files(folder, {'.yaml', '.yml'}):
        parser.parse(read_bytes(path), str(path))
        if parser.rejected and any(start.file == str(path) for start in parser.starts):
            notes.append(f'{path}: compared as far as it can be read, because rcl rejects it; `check {path}` says why')
        parser.rejected.clear()
    by_block: dict[str, list[str]] = {name: [] for name in parser.blocks}
    for each in parser.assignments:
        by_block[each.block].append(each.name)
    # A file may configure nodes of other packages, too, of which a name or two may occur here.
    ours = {block for block, names in by_block.items() if block.rpartition('/')[2] in source.literals
            or 2 * sum(map(source.names, names)) >= len(names)}
    if others := [block for block in parser.blocks if block not in ours]:
        notes.append(f'Not compared, because {folder} declares few of their parameters or none: {", ".join(others)}')
    exact = [name for name in source.declared if '*' not in name]
    unknown = [each for each in parser.assignments if each.block in ours and not source.names(each.name)]
    if source.nameless and unknown:
        names = ', '.join(dict.fromkeys(each.name for each in unknown))
        notes.append(f'{source.nameless}, so these may be declared, though no declare_parameter names them: {names}')
        unknown = []
    found = [FileFinding(each.file, each.name_place.line, each.name_place.column, 'not declared', (
        f'no declare_parameter in the text of {folder} names {each.name}, so probably no node reads it: remove the line'
        + ''.join(f', or write {near}' for near in difflib.get_close_matches(each.name, exact, n=1, cutoff=0.75))),
        each.block, each.name) for each in unknown]
    ends = {end for names in by_block.values() for name in names for end in _ends(name)}
    found += [FileFinding(str(source.declared[name][0]), source.declared[name][1], 1, 'in no file', (
        f'{name} is declared here and in no parameter file: nodes get its default'), '', name)
        for name in exact if parser.blocks and name not in ends and not is_housekeeping(name)]
    return found, notes


def _ends(name: str) -> Iterator[str]:
    """Return ``a.b.c``, ``b.c`` and ``c``: what stands before may be put together in the source."""
    parts = name.split('.')
    return ('.'.join(parts[start:]) for start in range(len(parts)))


def _files(folder: Path, suffixes: set[str]) -> Iterator[Path]:
    for path in sorted(folder.rglob('*')):
        parts = path.relative_to(folder).parts
        if (path.suffix in suffixes and path.is_file()
                and not any(map(_ASIDE.fullmatch, parts))):
            yield path


def _names(call: str, before: str, rest: str) -> Iterator[str]:
    """Return the names that a call declares, with * for what is not known of one.

    :param before: The character before the call: without a dot or arrow, the first argument may be the node.
    :param rest: What follows the opening parenthesis.
    """
    arguments = _arguments(rest)
    if 'declare_parameters' in call and len(arguments) > 1:
        space = _name(arguments[0])
        inner = [one or other for one, other in re.findall(rf'[({{]\s*{_LITERAL}\s*,', arguments[1])]
        for name in inner or ['*']:
            yield name if space == '' else f'{space or "*"}.{name}'
        return
    for argument in arguments[:1 if before in '.>' else 2]:
        if name := _name(argument):
            yield name
            return


def _arguments(text: str) -> list[str]:
    """Return the arguments of a call, which end at the parenthesis that closes it."""
    found, depth = [''], 0
    for token in re.finditer(rf'{_LITERAL}|.', text, re.DOTALL):
        if token[0] in '([{':
            depth += 1
        elif token[0] in ')]}':
            depth -= 1
            if depth < 0:
                break
        if token[0] == ',' and not depth:
            found.append('')
        else:
            found[-1] += token[0]
    return found


def _name(argument: str) -> str | None:
    """Return the name that an argument puts together; None if no part of it stands there."""
    parts, end = [], 0
    for each in re.finditer(_LITERAL, argument):
        if re.search(r'\w', argument[end:each.start()].replace('std::string', '')):
            parts.append('*')
        text = each[1] if each[1] is not None else each[2]
        parts.append(re.sub(r'\{[^}]*\}|%s', '*', text))
        end = each.end()
    if not parts:
        return None
    if re.search(r'\w', argument[end:]):
        parts.append('*')
    name = ''.join(parts)
    return name if not name or (re.fullmatch(r'[\w.*/-]*', name) and name.strip('*.')) else None
