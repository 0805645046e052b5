"""The commands about files and whole systems as extensions of the genuine ``ros2``: ``ros2 param_diff`` and so on.

setup.py names these classes as entry points of ``ros2cli.command``. ros2cli makes an object of the one that is asked
for, lets it add its arguments to a parser, and calls ``main`` (ros2cli/command/__init__.py); it asks for no base class,
so nothing here needs an installed ROS.
"""

import argparse
import os
import sys
from collections.abc import Callable

from param_tools.cli import changes, check, system
from param_tools.cli.session import CommandFailed, Session, run_verb
from param_tools.errors import ParameterToolError
from param_tools.ros import stage
from param_tools.ros.waiting import to_end


class _Command:
    NAME: str | None = None
    EXTENSION_POINT_VERSION = '0.1'
    _add_arguments: Callable[[argparse.ArgumentParser], None]

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        type(self)._add_arguments(parser)

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int | str:
        """Run the command; return its exit status, or what to complain of."""
        # The domain in which everybody is, unless the user has said another: the tools would choose one of their own.
        if not os.environ.get('ROS_DOMAIN_ID'):
            os.environ['ROS_DOMAIN_ID'] = '0'
        try:
            return to_end(run_verb(Session(sys.stdout, sys.stderr, stage.start, in_notebook=False), args))
        except (CommandFailed, ParameterToolError) as error:
            return str(error)


def _extension(name: str) -> type[_Command]:
    explanation, add_arguments = {**check.COMMANDS, **system.COMMANDS, **changes.COMMANDS}[name]
    # ros2cli shows the first line of the docstring as help.
    return type(f'{name.capitalize()}Command', (_Command,), {
        '__doc__': f'{explanation[0].upper()}{explanation[1:]}.', '_add_arguments': staticmethod(add_arguments)})


CheckCommand = _extension('check')
DescribeCommand = _extension('describe')
SnapshotCommand = _extension('snapshot')
DiffCommand = _extension('diff')
RestoreCommand = _extension('restore')
WatchCommand = _extension('watch')
HistoryCommand = _extension('history')
