"""check and describe: check parameter files against what nodes declare, and save what they declare.

The exit status is made for scripts: 0 if nothing was found, 1 if something was, 2 if nothing could be checked.
"""

import argparse
import tempfile
from pathlib import Path

from param_tools.cli import system_arguments
from param_tools.cli.session import CommandFailed, Commands, Session, add_graph_options
from param_tools.errors import ParameterToolError
from param_tools.files.checking import Findings, check_files
from param_tools.files.descriptions import Descriptions
from param_tools.files.sources import compare_source

_FORMATS = {'text': Findings.text, 'github': Findings.as_github}


def add_to(commands: Commands) -> None:
    parser = commands.add_parser('check', help='find the mistakes in parameter files')
    add_graph_options(parser)
    parser.add_argument('files', nargs='*', metavar='FILE',
                        help='parameter files, in the order in which the nodes get them')
    parser.add_argument('--launch', action='store_true',
                        help='the words are those after `ros2 launch`: a launch file, or a package and a launch file, '
                             'and name:=value for its arguments. Show what each of its nodes would get, from where, '
                             'and check it. The launch file is carried out, but no program is started')
    parser.add_argument('--against', action='append', default=[], metavar='SOURCE',
                        help=f'what the files are for: {system_arguments.HELP} that `describe` has saved. May be given '
                             f'several times')
    parser.add_argument('--source', type=Path, metavar='FOLDER',
                        help='a package: say also which names in the files, by default all that it has, no '
                             'declare_parameter in the text of its Python or C++ names, and which are in no file')
    parser.add_argument('--format', choices=_FORMATS, default='text', help='default: text')
    parser.set_defaults(verb=check, error=parser.error)
    parser = commands.add_parser('describe', help='save what nodes declare, for checks without them')
    add_graph_options(parser)
    parser.add_argument('sources', nargs='+', metavar='SOURCE', help=system_arguments.HELP)
    parser.add_argument('--save', metavar='FILE', help='where to write it; by default to standard output')
    parser.set_defaults(verb=describe)


def check(session: Session, args: argparse.Namespace) -> int:
    if not args.files and args.source is None:
        args.error('give a FILE, or --source FOLDER')
    if args.launch and args.source:
        args.error('--source compares parameter files, and takes no launch file')
    try:
        compared, notes = compare_source(args.source, args.files) if args.source else ([], [])
        against = Descriptions()
        for word in args.against:
            found = system_arguments.describe(session, word, args)
            if not found:
                raise CommandFailed(f'nothing can be checked against {word}: no node of it was described')
            against.add(found)
        findings = _check_launch(session, args, against) if args.launch else check_files(
            args.files, against, are_meant=bool(against) or len(args.files) == 1)
    except (ParameterToolError, CommandFailed) as error:
        session.complain(error)
        return 2
    everything = Findings((*findings, *compared))
    if text := _FORMATS[args.format](everything):
        session.print(text)
    for note in notes:
        session.complain(note)
    if findings.passed_over:
        session.complain(f'Not checked, because nothing is known of these nodes: {", ".join(findings.passed_over)}')
    if left := findings.left_to_launch if args.launch else findings.substitutions:
        more = f' and {len(left) - 5} more' if len(left) > 5 else ''
        session.complain(f'Not checked, because only launch fills in $(…), and only where allow_substs says so; '
                         f'elsewhere the node gets the text: {", ".join(left[:5])}{more}')
    for file in findings.no_parameter_files:
        session.complain(f'{file}: not a parameter file, because it has no ros__parameters')
    return 1 if any(each.severity != 'notice' for each in everything) else 0


def _check_launch(session: Session, args: argparse.Namespace, against: Descriptions) -> Findings:
    """Print what the nodes of a launch file would get, and return what is wrong with it."""
    from param_tools.cli.launch.context import LaunchFailed
    from param_tools.cli.launch.rehearsal import RehearsedLaunch
    from param_tools.cli.launch.verb import path_and_arguments

    with tempfile.TemporaryDirectory(prefix='param_tools_') as folder:
        path, arguments = path_and_arguments(args.files)
        try:
            launch = RehearsedLaunch(path, arguments, Path(folder))
        except LaunchFailed as error:
            raise CommandFailed(f'{error.place()}{error}') from None
        if args.format == 'text':
            session.print('\n'.join(launch.lines()) or 'The launch file starts no node.')
        return launch.check(against)


def describe(session: Session, args: argparse.Namespace) -> int:
    found = Descriptions()
    for word in args.sources:
        found.add(system_arguments.describe(session, word, args))
    system_arguments.write(session, found.dump(), args.save, nodes=len(found),
                           parameters=sum(len(each.parameters) for each in found.values()))
    return 1 if found.unanswered else 0
