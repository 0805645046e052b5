"""The command ``launch``: find the launch file, give it its arguments, and start its programs."""

import argparse
import os
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from param_tools.cli import index
from param_tools.cli.launch.actions import (
    DeclaredArgument,
    IncludeLaunchDescription,
    LaunchDescription,
    LaunchFileSource,
    carry_out,
)
from param_tools.cli.launch.context import Context, LaunchFailed, Origin
from param_tools.cli.launch.processes import Launcher
from param_tools.cli.launch.reading import load_description
from param_tools.cli.launch.substitutions import describe
from param_tools.cli.session import CommandFailed, Commands, Session
from param_tools.ros.waiting import Steps


def add_to(commands: Commands) -> None:
    launch = commands.add_parser('launch', help='start what a launch file describes')
    launch.add_argument('-s', '--show-args', '--show-arguments', action='store_true',
                        help='only show the arguments of the launch file')
    launch.add_argument('package_name', help='name of the package, or the path of a launch file')
    launch.add_argument('launch_file_name', nargs='?', help='name of the launch file in that package')
    launch.add_argument('launch_arguments', nargs='*', help='arguments of the launch file, as name:=value')
    launch.set_defaults(verb=launch_file)


def launch_file(session: Session, args: argparse.Namespace) -> Steps:
    """Start what a launch file describes, and stay until all of it has ended.

    :return: The exit status: 1 if the file cannot be carried out. A program that dies makes no difference.
    """
    words = [word for word in (args.package_name, args.launch_file_name, *args.launch_arguments) if word]
    path, arguments = path_and_arguments(words)
    if args.show_args:
        _show_arguments(session, load_description(path))
        return 0
    if session.in_notebook:
        raise CommandFailed(session.advise_instead(['launch', *words]))
    launcher = Launcher(session.stdout)
    launcher.log('INFO', 'launch', 'Default logging verbosity is set to INFO')
    with tempfile.TemporaryDirectory(prefix='param_tools_') as folder:
        try:
            programs = carry_out([include(path, arguments)], Context(folder=Path(folder), log=launcher.log))
            yield from launcher.run(programs)
        except LaunchFailed as error:
            # To standard output, as all that launch logs.
            launcher.log('ERROR', 'launch', f'Caught exception in launch (see debug for traceback): {error}')
            return 1
    return 0


def include(path: Path, arguments: Mapping[str, str]) -> IncludeLaunchDescription:
    """Return the action that carries out a launch file with arguments, as `ros2 launch` does."""
    found = IncludeLaunchDescription(LaunchFileSource(path), launch_arguments=arguments.items())
    found.origin = Origin(path, None)
    return found


def path_and_arguments(words: Sequence[str]) -> tuple[Path, dict[str, str]]:
    """Return the launch file that the words after ``ros2 launch`` name, and the arguments for it."""
    first, *others = words
    if Path(first).is_file():
        return Path(first).resolve(), dict(map(_argument, others))
    if not others or ':=' in others[0]:
        raise CommandFailed(f"{first!r} is not a launch file here; after a package's name comes the name of a launch "
                            f'file in it')
    name, *given = others
    try:
        share = index.share_folder_of(first)
    except index.PackageNotFound as error:
        raise CommandFailed(f"Package '{first}' not found: {error}") from None
    # In a checkout the folders in the share folder are links.
    found = sorted(Path(folder, name) for folder, _, files in os.walk(share, followlinks=True) if name in files)
    if not found:
        raise CommandFailed(f"file '{name}' was not found in the share directory of package '{first}' "
                            f"which is at '{share}'")
    if len(found) > 1:
        raise CommandFailed(f"file '{name}' was found more than once in the share directory of package "
                            f"'{first}': [{', '.join(repr(str(path)) for path in found)}]")
    return found[0], dict(map(_argument, given))


def _argument(word: str) -> tuple[str, str]:
    name, separator, value = word.partition(':=')
    if not separator or not name or not value:
        raise CommandFailed(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
    return name, value


def _show_arguments(session: Session, description: LaunchDescription) -> None:
    session.print("Arguments (pass arguments as '<name>:=<value>'):")
    declared: dict[str, DeclaredArgument] = {}
    for each in description.declared_arguments():
        declared.setdefault(each.declaration.name, each)
    for name, (declaration, is_conditional, _) in declared.items():
        session.print(f"\n    '{name}':{'*' * is_conditional}\n        {declaration.description}")
        if declaration.default_value is not None:
            session.print(f'        (default: {describe(declaration.default_value)})')
    if not declared:
        session.print('\n  No arguments.')
    elif any(each.is_conditional for each in declared.values()):
        session.print('\n* argument(s) which are only used if specific conditions occur')
