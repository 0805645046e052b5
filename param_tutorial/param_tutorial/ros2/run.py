"""ros2 run: start a program of a package, as a process of its own."""

import argparse
import contextlib
import os
import pkgutil
import shlex
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import NoReturn

from param_tutorial import nodes
from param_tutorial.ros2 import index
from param_tutorial.ros2.session import CommandFailed, Commands, Session

_OWN_WORDS = (sys.executable, '-m', nodes.__name__)
_SIGNALS = (signal.SIGINT, signal.SIGTERM)


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
    return sorted(module.name for module in pkgutil.iter_modules(nodes.__path__) if not module.name.startswith('_'))


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
        with signals_held(hears_of_it=is_our_node(command)):
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
    if package != index.PACKAGE or environment.get('PARAM_TUTORIAL_OWN_NODES') == '0':
        raise CommandFailed(f"Package '{package}' not found")
    if program not in node_programs():
        raise CommandFailed('No executable found')
    return [*_OWN_WORDS, program]


@contextlib.contextmanager
def signals_held(*, hears_of_it: bool) -> Iterator[None]:
    """Hold SIGINT and SIGTERM back in this thread while it starts or becomes a program that lets them through itself.

    A signal that comes before the first line of a Python program has run would end it as one that knows of no signals.

    :param hears_of_it: Whether the program does. Nothing is held back from any other program.
    """
    before = signal.pthread_sigmask(signal.SIG_BLOCK if hears_of_it else signal.SIG_UNBLOCK, _SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def is_our_node(command: Sequence[str]) -> bool:
    """True if these words start a node of the course in a Python of its own."""
    return tuple(command[:len(_OWN_WORDS)]) == _OWN_WORDS
