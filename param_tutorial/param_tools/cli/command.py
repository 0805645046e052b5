"""The embedded ``ros2`` as a function: read the words of one command, and run its verb."""

import functools
import importlib
import sys
from collections.abc import Sequence
from pathlib import Path

from param_tools.cli.session import MORE_ELSEWHERE, CommandFailed, CommandParser, Printed, Session, run_verb
from param_tools.errors import ParameterToolError
from param_tools.ros.waiting import Steps, to_end

# The commands of each module. Imported when used: a process that runs one command need not pay for the others.
_MODULES = {'node': ['node'], 'param': ['param'], 'pkg': ['pkg'], 'run': ['run'], 'launch.verb': ['launch'],
            'check': ['check', 'describe'], 'system': ['snapshot', 'diff', 'restore'],
            'changes': ['watch', 'history'], 'panel': ['panel']}

# The commands that the genuine one has not.
_OWN = ('check', 'describe', 'snapshot', 'diff', 'restore', 'watch', 'history', 'panel')

# As `python -m param_tools`, also where a workspace that holds a build of this package has been sourced, which puts the
# build in front: the folder of this package is named, and for this one process only.
_PROGRAM = ('import sys; sys.path.insert(0, sys.argv.pop(1)); '
            'from param_tools.__main__ import main; sys.exit(main())')

# What is missing where a command needs ROS and there is none.
_PACKAGES_OF_ROS = ('rclpy', 'rcl_interfaces', 'ament_index_python')


def process_words() -> list[str]:
    """Return what stands for ``ros2`` on the command line of a process of its own."""
    return [sys.executable, '-c', _PROGRAM, str(Path(__file__).parents[2])]


@functools.cache
def _parser(command: str, prog: str) -> CommandParser:
    """Return a parser for one command, or for all if it is none.

    :param prog: What a usage line begins with.
    """
    parser = CommandParser(prog=prog, description=MORE_ELSEWHERE)
    commands = parser.add_subparsers(metavar='command', title='commands')
    wanted = [module for module, names in _MODULES.items() if command in names] or _MODULES
    for module in wanted:
        importlib.import_module(f'param_tools.cli.{module}').add_to(commands)
    return parser


def main(argv: Sequence[str], session: Session) -> int:
    """Run the command that the words after ``ros2`` say, and return its exit status."""
    return to_end(steps(argv, session))


def steps(argv: Sequence[str], session: Session) -> Steps:
    """Run a command likewise, step by step if it goes on until somebody ends it."""
    try:
        command = argv[0] if argv else ''
        # `ros2 check` cannot be typed: it is this program's own.
        called = '%ros2' if session.in_notebook else 'python -m param_tools'
        parser = _parser(command, called if command in _OWN else 'ros2')
        args = parser.parse_args(argv)
        if not hasattr(args, 'verb'):
            getattr(args, 'help_of', parser).print_help()
        return (yield from run_verb(session, args))
    except Printed as printed:
        (session.stderr if printed.status else session.stdout).write(str(printed))
        return printed.status
    except (CommandFailed, ParameterToolError) as error:
        session.complain(error)
        return 1
    except ModuleNotFoundError as error:
        if error.name not in _PACKAGES_OF_ROS:
            raise
        session.complain(f'This needs ROS, and Python finds no {error.name}: source a ROS installation, or install '
                         f'the tools with their extra `ros`. `check` needs ROS only to ask running nodes and for '
                         f'`--launch`')
        return 2
