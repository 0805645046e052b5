"""The commands about files and whole systems as extensions of the genuine ``ros2``: ``ros2 param_diff`` and so on.

setup.py names these classes as entry points of ``ros2cli.command``. ros2cli makes an object of the one that is asked
for, lets it add its arguments to a parser, and calls ``main`` (ros2cli/command/__init__.py); it asks for no base class,
so nothing here needs an installed ROS.
"""

import argparse
import os
import sys

from param_tools.cli import changes, check, system
from param_tools.cli.session import CommandFailed, Session
from param_tools.errors import ParameterToolError
from param_tools.ros import stage


class _Command:
    NAME: str | None = None
    EXTENSION_POINT_VERSION = '0.1'

    @staticmethod
    def add(parser: argparse.ArgumentParser) -> None:
        """Add what the command takes, in the embedded ros2 too."""
        raise NotImplementedError

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add what the command takes."""
        self.add(parser)

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int | str:
        """Run the command; return its exit status, or what to complain of."""
        # The domain in which everybody is, unless the user has said another: the tools would choose one of their own.
        if not os.environ.get('ROS_DOMAIN_ID'):
            os.environ['ROS_DOMAIN_ID'] = '0'
        try:
            return args.verb(Session(sys.stdout, sys.stderr, stage.start, in_notebook=False), args) or 0
        except (CommandFailed, ParameterToolError) as error:
            return str(error)


class CheckCommand(_Command):
    """Find the mistakes in parameter files."""

    add = staticmethod(check.add_check_arguments)


class DescribeCommand(_Command):
    """Save what nodes declare, to check files without them."""

    add = staticmethod(check.add_describe_arguments)


class SnapshotCommand(_Command):
    """Save the parameters of many nodes."""

    add = staticmethod(system.add_snapshot_arguments)


class DiffCommand(_Command):
    """Compare nodes, files, defaults and robots."""

    add = staticmethod(system.add_diff_arguments)


class RestoreCommand(_Command):
    """Bring saved parameters back."""

    add = staticmethod(system.add_restore_arguments)


class WatchCommand(_Command):
    """Print every change of parameters, and keep a log of them."""

    add = staticmethod(changes.add_watch_arguments)


class HistoryCommand(_Command):
    """Print what a log holds, or the values at a time."""

    add = staticmethod(changes.add_history_arguments)
