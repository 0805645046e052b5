"""ros2 run: start a program of a package, as a process of its own."""

import argparse
import os
import pkgutil
import shlex
import sys
from collections.abc import Mapping, Sequence
from typing import NoReturn

from param_tutorial import nodes
from param_tutorial.ros2 import index
from param_tutorial.ros2.session import CommandFailed, Commands, Session
from param_tutorial.runtime.surroundings import PACKAGE


def add_to(commands: Commands) -> None:
    """Add the command ``run``."""
    run = commands.add_parser('run', help='run a program of a package')
    run.add_argument('--prefix', help="what goes before the program, e.g. --prefix 'gdb -ex run --args'")
    run.add_argument('package_name', help='name of the package')
    run.add_argument('executable_name', help='name of the program')
    run.add_argument('argv', nargs=argparse.REMAINDER, help='everything after it is passed to the program')
    run.set_defaults(verb=run_program)


def node_programs() -> list[str]:
    """Return the names of the course's own nodes: one for each file in ``nodes``."""
    return sorted(module.name for module in pkgutil.iter_modules(nodes.__path__))


def keeps_busy(words: Sequence[str]) -> str:
    """Return a sentence on what to do instead of a command that would not let the cell end."""
    # Not param_tutorial.start(), which would first remove the nodes that are there.
    return (f'This would keep the cell busy until you interrupt it. Run it beside the notebook: '
            f'terminal = param_tutorial.Terminal({shlex.join(["ros2", *words])!r}); or add its node to the executor '
            f'in the notebook: ros.add(...)')


def run_program(session: Session, args: argparse.Namespace) -> NoReturn:
    """Become the program: Ctrl+C, the exit status and all else are then its own affair."""
    command = find_program(args.package_name, args.executable_name)
    if session.in_notebook:
        raise CommandFailed(keeps_busy(['run', args.package_name, args.executable_name, *args.argv]))
    command = [*shlex.split(args.prefix or ''), *command, *args.argv]
    session.stdout.flush()
    session.stderr.flush()
    try:
        os.execvp(command[0], command)
    except OSError as error:
        raise CommandFailed(f'cannot run {command[0]}: {error.strerror}') from None


def find_program(package: str, program: str, environment: Mapping[str, str] = os.environ) -> list[str]:
    """Find a program: in the install spaces that have been sourced, else among the course's own nodes.

    :param environment: Tells what has been sourced.
    :return: The words that start it.
    :raises CommandFailed: there is no such package, or no such program in it.
    """
    try:
        path = index.prefix_of(package, environment.get('AMENT_PREFIX_PATH', '')) / 'lib' / package / program
    except index.PackageNotFound:
        return _own_program(package, program, environment)
    if path.is_file() and os.access(path, os.X_OK):
        return [str(path)]
    raise CommandFailed('No executable found')


def _own_program(package: str, program: str, environment: Mapping[str, str]) -> list[str]:
    if package != PACKAGE or environment.get('PARAM_TUTORIAL_OWN_NODES') == '0':
        raise CommandFailed(f"Package '{package}' not found")
    if program not in node_programs():
        raise CommandFailed('No executable found')
    return [sys.executable, '-m', f'{nodes.__name__}.{program}']
