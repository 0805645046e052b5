"""check and describe: check parameter files against what nodes declare, and save what they declare.

The exit status is made for scripts: 0 if nothing was found, 1 if something was, 2 if nothing could be checked.
"""

import argparse
import tempfile
from pathlib import Path

from param_tools.cli import system_arguments
from param_tools.cli.session import CommandFailed, Commands, CommandTable, Session, add_commands, add_graph_options
from param_tools.errors import ParameterToolError
from param_tools.files.checking import Findings, check_files
from param_tools.files.descriptions import Descriptions
from param_tools.files.parameter_files import Dump

_FORMATS = {'text': Findings.text, 'json': Findings.as_json, 'github': Findings.as_github}


def add_to(commands: Commands) -> None:
    add_commands(commands, COMMANDS)


def add_check_arguments(parser: argparse.ArgumentParser) -> None:
    add_graph_options(parser)
    parser.add_argument('files', nargs='+', metavar='FILE',
                        help='parameter files, in the order in which the nodes get them')
    parser.add_argument('--launch', action='store_true',
                        help='the words are those after `ros2 launch`: a launch file, or a package and a launch file, '
                             'and name:=value for its arguments. Show what each of its nodes would get, from where, '
                             'and check it. The launch file is carried out, but no program is started')
    parser.add_argument('--against', action='append', default=[], metavar='[NODE=]SOURCE',
                        help=f'what the files are for: {system_arguments.HELP}: a description saved by `describe`, '
                             f'or a schema of generate_parameter_library. May be given several times, also '
                             f'for one node')
    parser.add_argument('--complete', action='store_true',
                        help='these are all nodes: a block for another one is a mistake')
    parser.add_argument('--separately', action='store_true',
                        help='judge each file alone: a node gets one of them, and not all')
    parser.add_argument('--load', action='store_true',
                        help='the files are for `ros2 param load`, and not for the start of the nodes')
    parser.add_argument('--format', choices=_FORMATS, default='text', help='default: text')
    parser.set_defaults(verb=check)


def check(session: Session, args: argparse.Namespace) -> int:
    try:
        against = Descriptions(complete=args.complete)
        for word in args.against:
            found = system_arguments.describe(session, word, args)
            if not found:
                raise CommandFailed(f'nothing can be checked against {word}: no node of it was described')
            against.add(found)
        if args.launch:
            results = [_check_launch(session, args, against)]
        else:
            sets = [[file] for file in args.files] if args.separately else [args.files]
            results = [check_files(files, against, loading=args.load) for files in sets]
    except (ParameterToolError, CommandFailed) as error:
        session.complain(error)
        return 2
    findings = Findings(each for result in results for each in result)
    if text := _FORMATS[args.format](findings):
        session.print(text)
    if passed_over := dict.fromkeys(name for result in results for name in result.passed_over):
        session.complain(f'Not checked, because nothing is known of these nodes: {", ".join(passed_over)}')
    if left := [place for result in results for place in result.left_to_launch]:
        session.complain(f'Not checked, because launch fills them in: {", ".join(left)}')
    return 1 if findings else 0


def _check_launch(session: Session, args: argparse.Namespace, against: Descriptions) -> Findings:
    """Print what the nodes of a launch file would get, and return what is wrong with it."""
    from param_tools.cli.launch.rehearsal import RehearsedLaunch
    from param_tools.cli.launch.verb import path_and_arguments

    if args.load or args.separately or args.complete:
        raise CommandFailed('--load, --separately and --complete are for parameter files, and not for --launch')
    with tempfile.TemporaryDirectory(prefix='param_tools_') as folder:
        launch = RehearsedLaunch(*path_and_arguments(args.files), Path(folder))
        if args.format == 'text':
            session.print('\n'.join(launch.lines()) or 'The launch file starts no node.')
        return launch.check(against)


def add_describe_arguments(parser: argparse.ArgumentParser) -> None:
    add_graph_options(parser)
    parser.add_argument('sources', nargs='+', metavar='SOURCE', help=system_arguments.HELP)
    parser.add_argument('--save', metavar='FILE', help='where to write it; by default to standard output')
    parser.add_argument('--format', choices=('yaml', 'markdown'), default='yaml',
                        help='markdown is a table for a README (default: yaml)')
    parser.set_defaults(verb=describe)


def describe(session: Session, args: argparse.Namespace) -> int:
    found = Descriptions()
    for word in args.sources:
        found.add(system_arguments.describe(session, word, args))
    dump = found.dump() if args.format == 'yaml' else Dump(found.reference().text, {})
    system_arguments.write(session, dump, args.save, nodes=len(found),
                           parameters=sum(len(each.parameters) for each in found.values()))
    return 1 if found.unanswered else 0


COMMANDS: CommandTable = {
    'check': ('find the mistakes in parameter files', add_check_arguments),
    'describe': ('save what nodes declare, to check files without them', add_describe_arguments)}
