"""The command ``launch``: find the launch file, give it its arguments, and start its programs."""

import argparse
import os
import tempfile
from pathlib import Path

from param_tools.cli import index
from param_tools.cli.launch.actions import DeclareLaunchArgument, LaunchDescription
from param_tools.cli.launch.context import Context, LaunchFailed
from param_tools.cli.launch.processes import Launcher
from param_tools.cli.launch.reading import load_description
from param_tools.cli.launch.substitutions import describe
from param_tools.cli.session import CommandFailed, Commands, Session
from param_tools.ros.waiting import Steps


def add_to(commands: Commands) -> None:
    """Add the command ``launch``."""
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
    path, given = _path_and_arguments(args)
    arguments = dict(_argument(word) for word in given)
    if args.show_args:
        _show_arguments(session, load_description(path))
        return 0
    if session.in_notebook:
        words = [word for word in (args.package_name, args.launch_file_name, *args.launch_arguments) if word]
        raise CommandFailed(session.instead_of(['launch', *words]))
    launcher = Launcher(session.stdout)
    launcher.log('INFO', 'launch', 'Default logging verbosity is set to INFO')
    with tempfile.TemporaryDirectory(prefix='param_tools_') as folder:
        context = Context(
            arguments, Path(folder), lambda text: launcher.log('WARNING', 'launch_ros.actions.node', text),
            log_error=lambda text: launcher.log('ERROR', 'launch.actions.declare_launch_argument', text))
        try:
            yield from launcher.run(load_description(path).execute(context))
        except LaunchFailed as error:
            # To standard output, as all that launch logs.
            launcher.log('ERROR', 'launch', f'Caught exception in launch (see debug for traceback): {error}')
            return 1
    return 0


def _path_and_arguments(args: argparse.Namespace) -> tuple[Path, list[str]]:
    words = [word for word in (args.launch_file_name, *args.launch_arguments) if word]
    if Path(args.package_name).is_file():
        return Path(args.package_name).resolve(), words
    if not words or ':=' in words[0]:
        raise CommandFailed(f"{args.package_name!r} is not a launch file here; after a package's name comes the "
                            f'name of a launch file in it')
    name, *given = words
    try:
        share = index.share_folder_of(args.package_name)
    except index.PackageNotFound as error:
        raise CommandFailed(f"Package '{args.package_name}' not found: {error}") from None
    # In a checkout the folders in the share folder are links.
    found = sorted(Path(folder, name) for folder, _, files in os.walk(share, followlinks=True) if name in files)
    if not found:
        raise CommandFailed(f"file '{name}' was not found in the share directory of package '{args.package_name}' "
                            f"which is at '{share}'")
    if len(found) > 1:
        raise CommandFailed(f"file '{name}' was found more than once in the share directory of package "
                            f"'{args.package_name}': [{', '.join(repr(str(path)) for path in found)}]")
    return found[0], given


def _argument(word: str) -> tuple[str, str]:
    name, separator, value = word.partition(':=')
    if not separator or not name or not value:
        raise CommandFailed(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
    return name, value


def _show_arguments(session: Session, description: LaunchDescription) -> None:
    session.print("Arguments (pass arguments as '<name>:=<value>'):")
    declared: dict[str, DeclareLaunchArgument] = {}
    for argument in description.declared_arguments():
        declared.setdefault(argument.name, argument)
    for each in declared.values():
        session.print(f"\n    '{each.name}':\n        {each.description}")
        if each.default_value is not None:
            session.print(f'        (default: {describe(each.default_value)})')
    if not declared:
        session.print('\n  No arguments.')
