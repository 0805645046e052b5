"""watch and history: print every change of parameters as it happens, or as a log has kept it."""

import argparse
import contextlib
import math
import queue
import time
from pathlib import Path

from param_tools.cli.session import CommandFailed, Commands, Session, add_graph_options
from param_tools.cli.system_arguments import full_name
from param_tools.errors import ParameterToolError
from param_tools.markup.wording import format_count
from param_tools.ros.waiting import Steps
from param_tools.systems.change_log import ChangeFollower, ChangeLog, ChangeLogWriter, LoggedChange
from param_tools.systems.snapshot import Snapshot

# A log begins with the values that are there.
_NO_CHANGES = 'begin', 'seen'


def add_to(commands: Commands) -> None:
    parser = commands.add_parser('watch', help='print every change of parameters, and keep a log of them')
    add_graph_options(parser)
    parser.add_argument('nodes', nargs='*', metavar='NODE', help='name of a node (default: all nodes)')
    parser.add_argument('--log', metavar='FILE', help='append every change to this file, one JSON object in each line')
    parser.add_argument('--duration', type=float, metavar='N', help='end after N seconds (default: with Ctrl+C)')
    parser.set_defaults(verb=watch)
    parser = commands.add_parser('history', help='print the changes that a log holds')
    parser.add_argument('log', metavar='FILE', help='a log that `watch --log` has written')
    parser.set_defaults(verb=history)


def watch(session: Session, args: argparse.Namespace) -> Steps:
    """Print changes until somebody ends it."""
    if session.in_notebook and args.duration is None:
        raise CommandFailed(session.advise_instead(['watch', *args.nodes]) + ' Or say how long: --duration 10')
    session.wait_for_graph(args)
    happened: queue.SimpleQueue[list[LoggedChange] | ParameterToolError] = queue.SimpleQueue()
    end = math.inf if args.duration is None else time.monotonic() + args.duration
    # Ctrl+C ends the command at any moment, without an error.
    with contextlib.suppress(KeyboardInterrupt), _writer(args.log) as writer:
        with contextlib.suppress(KeyboardInterrupt), ChangeFollower(
                happened.put, nodes=map(full_name, args.nodes), trouble=happened.put, timeout_sec=args.timeout,
                executor=session.executor):
            while time.monotonic() < end:
                yield lambda: not happened.empty() or time.monotonic() >= end
                while not happened.empty():
                    _print(session, happened.get(), writer)
        while not happened.empty():  # what the follower heard before the end
            _print(session, happened.get(), writer)
    return 0


def _writer(path: str | None) -> 'contextlib.AbstractContextManager[ChangeLogWriter | None]':
    try:
        return contextlib.nullcontext() if path is None else ChangeLogWriter(path)
    except OSError as error:
        raise CommandFailed(f'cannot write {path}: {error.strerror}') from None


def _print(session: Session, what: list[LoggedChange] | ParameterToolError, writer: ChangeLogWriter | None) -> None:
    if isinstance(what, ParameterToolError):
        session.complain(what)
        return
    if writer is not None:
        try:
            writer.write(what)
        except OSError as error:
            raise CommandFailed(f'the log cannot be continued: {error.strerror}') from None
    if what and what[0].kind == 'begin':
        nodes = len({each.node for each in what[1:]})
        session.print(f'Watching {format_count(len(what) - 1, "parameter")} of {format_count(nodes, "node")}')
    for each in what:
        if each.kind not in _NO_CHANGES:
            session.print(each)
    session.stdout.flush()


def history(session: Session, args: argparse.Namespace) -> None:
    """Print the changes of the past."""
    session.print(ChangeLog.read(args.log).without(*_NO_CHANGES))


def past(word: str) -> Snapshot | None:
    """Return the values that a word like ``changes.jsonl@14:05`` names; None if the word names no log and time.

    :raises ParameterFileError: the file is no log.
    :raises InvalidValueError: there is no time in the word.
    """
    path, at, text = word.rpartition('@')
    if not at or not Path(path).is_file():
        return None
    log = ChangeLog.read(path)
    when = log.parse_time(text)
    if not log or when < log.records[0].time:
        raise CommandFailed(f'{path} does not reach back to {text}'
                            + (f': it begins at {log.records[0].time:%Y-%m-%d %H:%M:%S}' if log else ''))
    return log.at(when)
