"""snapshot, diff and restore: the parameters of whole systems saved, compared and brought back.

The exit status of ``diff`` is that of the Unix command: 0 if nothing differs, 1 if something does, 2 after an error.
"""

import argparse
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from param_tools.cli import system_arguments
from param_tools.cli.changes import past
from param_tools.cli.session import CommandFailed, Commands, Session, add_graph_options
from param_tools.errors import ParameterToolError
from param_tools.files import parameter_files
from param_tools.systems.restoring import restore_all
from param_tools.systems.sets import compare_systems
from param_tools.systems.snapshot import FIRST_WORDS, Snapshot, all_parameters


def add_to(commands: Commands) -> None:
    parser = commands.add_parser('snapshot', help='save the parameters of many nodes')
    add_graph_options(parser)
    parser.add_argument('nodes', nargs='*', metavar='NODE', default=[system_arguments.ALL_NODES],
                        help='name of a node (default: all nodes)')
    parser.add_argument('--save', metavar='FILE', help='where to write it; by default to standard output')
    parser.set_defaults(verb=snapshot)
    parser = commands.add_parser('diff', help='compare nodes, files and snapshots')
    add_graph_options(parser)
    parser.add_argument('before', metavar='BEFORE', help=f'{system_arguments.HELP}: a snapshot, another parameter '
                                                         f'file, or a log and a time: changes.jsonl@14:05')
    parser.add_argument('after', metavar='AFTER', help='likewise')
    parser.set_defaults(verb=diff)
    parser = commands.add_parser('restore', help='bring saved parameters back')
    add_graph_options(parser)
    parser.add_argument('file', metavar='FILE',
                        help='a snapshot, another parameter file, or a log and a time: changes.jsonl@14:05')
    parser.add_argument('nodes', nargs='*', metavar='NODE',
                        help='only these nodes (default: those that the file names)')
    parser.add_argument('--dry-run', action='store_true', help='only say what would be set')
    parser.set_defaults(verb=restore)


# -- snapshot -----------------------------------------------------------------------------------------------


def snapshot(session: Session, args: argparse.Namespace) -> int:
    found = take(session, args.nodes, args)
    dump = found.dump()
    system_arguments.write(session, dump, args.save, nodes=len(found),
                           parameters=sum(map(len, found.values())) - len(dump.left_out))
    return 1 if found.unanswered else 0


def take(session: Session, words: list[str], args: argparse.Namespace) -> Snapshot:
    """Return the parameters of running nodes; say which did not answer."""
    nodes = [node for word in words for node in system_arguments.nodes_of(session, word, args)]
    found = all_parameters(nodes, timeout_sec=args.timeout, executor=session.executor)
    system_arguments.report_unanswered(session, found.unanswered)
    return found


# -- diff ---------------------------------------------------------------------------------------------------


@dataclass
class _Side:
    """One of two systems."""

    word: str
    nodes: Mapping[str, Mapping[str, Any]]
    partial: bool = False
    """True if the nodes may have more parameters."""
    is_snapshot: bool = False
    """True for a file that holds all parameters of its nodes, except those that no file can hold."""
    lacking: bool = False
    """True if a node did not answer."""


def diff(session: Session, args: argparse.Namespace) -> int:
    try:
        before, after = _sides(session, args)
        for snapshot_side, other in ((before, after), (after, before)):
            if snapshot_side.is_snapshot:
                # That it lacks what no snapshot can hold is no difference.
                other.nodes = {node: {name: value for name, value in parameters.items()
                                      if not parameter_files.why_not_expressible(name, value)}
                               for node, parameters in other.nodes.items()}
        if len(before.nodes) == len(after.nodes) == 1:
            # One node with another, whatever they are called.
            before.nodes = dict(zip(after.nodes, before.nodes.values()))
        found = compare_systems(before.nodes, after.nodes, labels=(before.word, after.word),
                                partial=before.partial or after.partial)
    except (ParameterToolError, CommandFailed) as error:
        session.complain(error)
        return 2
    session.print(found)
    return 2 if before.lacking or after.lacking else 1 if found else 0


def _sides(session: Session, args: argparse.Namespace) -> tuple[_Side, _Side]:
    words = (args.before, args.after)
    sides = [None if system_arguments.is_file(word) else _running(session, word, args) for word in words]
    names = [node for side in sides if side for node in side.nodes]
    # A block for many nodes in one file is read for the nodes that the other file names.
    names = names or [node for word in words for node in _in_file(word).nodes]
    before, after = (side or _in_file(word, names) for side, word in zip(sides, words))
    return before, after


def _running(session: Session, word: str, args: argparse.Namespace) -> _Side:
    found = take(session, [word], args)
    if not found:
        raise CommandFailed(f'no node of {word} has answered')
    return _Side(word, found, lacking=bool(found.unanswered))


def _in_file(path: str, names: Iterable[str] = ()) -> _Side:
    if (then := past(path)) is not None:
        return _Side(path, then)
    found = parameter_files.read_all(path, names)
    is_snapshot = parameter_files.read_bytes(path).startswith(FIRST_WORDS.encode())
    return _Side(path, found, partial=not is_snapshot, is_snapshot=is_snapshot)


# -- restore ------------------------------------------------------------------------------------------------


def restore(session: Session, args: argparse.Namespace) -> int:
    nodes = [node for word in args.nodes for node in system_arguments.nodes_of(session, word, args)]
    given = past(args.file)
    wanted: Mapping[str, Mapping[str, Any]] = parameter_files.read_all(args.file, nodes) if given is None else given
    if args.nodes:
        wanted = {node: wanted[node] for node in nodes if node in wanted}
    if not wanted:
        raise CommandFailed(f'{args.file} holds nothing for these nodes' if args.nodes else
                            f'{args.file} names no node: say for which nodes it is')
    session.wait_for_graph(args)
    result = restore_all(wanted, args.file, rehearse=args.dry_run, timeout_sec=args.timeout, executor=session.executor)
    if result.nodes or len(wanted) > 1:  # the error says all there is to say of one node
        session.print(result)
    system_arguments.report_unanswered(session, result.unanswered)
    return 0 if result.complete else 1
