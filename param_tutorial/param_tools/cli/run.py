"""ros2 run: start a program of a package, as a process of its own."""

import argparse
import importlib.util
import os
import pkgutil
import signal
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from param_tools.cli import index
from param_tools.cli.session import CommandFailed, Commands, Session
from param_tools.ros import host
from param_tools.ros.environment import package_in_work, provided_packages
from param_tools.ros.waiting import Steps


class ProgramNotFound(CommandFailed):
    """The package has no program of that name; the message is the genuine command's own."""

    def __init__(self, names: Sequence[str]):
        """:param names: The programs that it has."""
        super().__init__('No executable found')
        self.names = names


def add_to(commands: Commands) -> None:
    run = commands.add_parser('run', help='run a program of a package')
    run.add_argument('package_name', help='name of the package')
    run.add_argument('executable_name', help='name of the program')
    run.add_argument('argv', nargs=argparse.REMAINDER, help='everything after it is passed to the program')
    run.set_defaults(verb=run_program)


def node_programs(package: str) -> list[str]:
    """Return the names of a provided package's nodes: one for each module of its Python package of nodes."""
    found = importlib.util.find_spec(provided_packages()[package])
    folders = found.submodule_search_locations if found else None
    return sorted(module.name for module in pkgutil.iter_modules(folders or ()) if not module.name.startswith('_'))


def run_program(session: Session, args: argparse.Namespace) -> Steps:
    """Run the program, say if it failed, and return its exit status; negative if a signal ended it."""
    command = find_program(args.package_name, args.executable_name)
    if session.in_notebook:
        raise CommandFailed(session.advise_instead(['run', args.package_name, args.executable_name, *args.argv]))
    command = [*command, *args.argv]
    session.stdout.flush()
    session.stderr.flush()
    try:
        status = yield from _wait_for_end(command)
    except OSError as error:
        raise CommandFailed(f'cannot run {command[0]}: {error.strerror}') from None
    if status:
        session.print('[ros2run]:', signal.strsignal(-status) if -status in signal.valid_signals()
                      else f'Process exited with failure {status}')
    return status


def _wait_for_end(command: Sequence[str]) -> Steps:
    """Run a command, and return its exit status, as ``subprocess`` has it.

    Ctrl+C reaches this process and the program alike, and the program decides what comes of it. SIGTERM is passed on;
    the genuine command ends and leaves the program running.
    """
    program = host.host.start(command)
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.signal(signal.SIGTERM, lambda *_: program.send(signal.SIGTERM))
    while (status := program.poll()) is None:
        yield lambda: program.poll() is not None
    return status


def find_program(package: str, program: str, environment: Mapping[str, str] = os.environ) -> list[str]:
    """Find a program: in the install spaces that have been sourced, else among the nodes of provided packages.

    A package in work, which a notebook follows, counts as installed: its programs are the files of its nodes.

    :param environment: Tells what has been sourced.
    :return: The words that start it.
    :raises index.PackageNotFound: there is no such package.
    :raises ProgramNotFound: there is no such program in it.
    """
    try:
        installed = _installed_programs(package, environment)
    except index.PackageNotFound:
        source = package_in_work(environment)
        if source is not None and source.name == package:
            return [sys.executable, str(_file_of(source, program))]
        return _provided_program(package, program, environment)
    paths = [path for path in installed if path.name == program]
    if not paths:
        raise ProgramNotFound([path.name for path in installed])
    if len(paths) > 1:
        raise CommandFailed('\n- '.join(['Multiple executables found:', *map(str, paths)]))
    return [str(paths[0])]


def _installed_programs(package: str, environment: Mapping[str, str] = os.environ) -> list[Path]:
    """Return the programs that a package has in the install spaces that have been sourced.

    :param environment: Tells what has been sourced.
    :raises index.PackageNotFound: none of them holds the package.
    """
    found = []
    prefix = index.prefix_of(package, environment.get('AMENT_PREFIX_PATH', ''))
    for folder, below, names in os.walk(prefix / 'lib' / package):
        below[:] = sorted(name for name in below if not name.startswith('.'))
        found += [Path(folder, name) for name in sorted(names) if os.access(Path(folder, name), os.X_OK)]
    return found


def _file_of(source: Path, program: str) -> Path:
    files = {each.stem: each for each in sorted((source / source.name).glob('*_node.py'))}
    if program not in files:
        raise ProgramNotFound([*files])
    return files[program]


def _provided_program(package: str, program: str, environment: Mapping[str, str]) -> list[str]:
    nodes = index.provided(environment).get(package)
    if nodes is None:
        raise index.PackageNotFound(f"Package '{package}' not found")
    if program not in (names := node_programs(package)):
        raise ProgramNotFound(names)
    return [sys.executable, '-m', nodes, program]
