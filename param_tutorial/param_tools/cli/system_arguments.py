"""What the commands about whole systems take as an argument, and the files that they write.

ROS is imported only for running nodes and programs: a file can be checked without it.
"""

import argparse
from collections import Counter
from pathlib import Path

from param_tools.cli.session import CommandFailed, Session
from param_tools.errors import NodeError, NodeNotFoundError
from param_tools.files import descriptions
from param_tools.files.descriptions import Descriptions
from param_tools.files.parameter_files import Dump
from param_tools.markup.wording import format_count

ALL_NODES = '/**'
HELP = f'a running node (/talker), all of them ({ALL_NODES}), or a file'


def is_file(word: str) -> bool:
    """True if a word is the path of a file, or can be nothing else."""
    return Path(word).is_file() or '.' in word or '@' in word


def full_name(word: str) -> str:
    """Return a node's name with the slash that one may leave out."""
    return '/' + word.strip('/')


def write(session: Session, dump: Dump, path: str | None, *, parameters: int, nodes: int) -> None:
    """Write a file and say how much it holds; without a path, write to standard output."""
    if path is None:
        session.stdout.write(dump.text)
    else:
        save(session, dump, path)
        session.print(f'Saved {format_count(parameters, "parameter")} of {format_count(nodes, "node")} to {path}')


def save(session: Session, dump: Dump, path: str) -> None:
    """Write a file, and say what it could not hold."""
    try:
        dump.save(path)
    except OSError as error:
        raise CommandFailed(f'cannot write {path}: {error.strerror}') from None
    for name, reason in dump.left_out.items():
        session.complain(f'left out: {name}: {reason}')


def nodes_of(session: Session, word: str, args: argparse.Namespace) -> list[str]:
    """Return the running nodes that a word names, once they are known.

    :param word: The name of a node, or ALL_NODES.
    :param args: Has the options of ``add_graph_options``.
    """
    if word != ALL_NODES:
        name = full_name(word)
        if not session.executor.services.find(name, at_least_sec=args.spin_time or 0.0):
            session.wait_for_graph(args)
            raise CommandFailed(str(NodeNotFoundError(name, session.executor.services.node_names())))
        _report_twins(session, [name], args)
        return [name]
    session.wait_for_graph(args)
    from param_tools.ros.executor import TOOL_NODE_NAME

    found = sorted({*session.executor.services.node_names(hidden=args.include_hidden_nodes)} - {f'/{TOOL_NODE_NAME}'})
    if not found:
        raise CommandFailed('no node is running')
    _report_twins(session, found, args)
    return found


def _report_twins(session: Session, nodes: list[str], args: argparse.Namespace) -> None:
    """Say which of the nodes share their name: ROS carries a call to any of them."""
    counts = Counter(each.full_name for each in session.node_names(hidden=args.include_hidden_nodes))
    for node in nodes:
        if counts[node] > 1:
            session.complain(f'WARNING: {counts[node]} nodes are called {node}. What is said or done here is about one '
                             f'of them, and ROS does not tell which.')


def describe(session: Session, word: str, args: argparse.Namespace) -> Descriptions:
    """Return the descriptions that a word names.

    :param word: As in HELP.
    :param args: Has the options of ``add_graph_options``.
    :raises ParameterFileError: the file cannot be read.
    """
    if is_file(word):
        return descriptions.read(word)
    from param_tools.systems.snapshot import describe as describe_nodes

    found = describe_nodes(nodes_of(session, word, args), timeout_sec=args.timeout, executor=session.executor)
    report_unanswered(session, found.unanswered)
    if word == ALL_NODES and not found.unanswered:
        found.complete = True
    return found


def report_unanswered(session: Session, unanswered: dict[str, NodeError]) -> None:
    """Say which nodes did not answer, and why."""
    for error in unanswered.values():
        session.complain(error)
