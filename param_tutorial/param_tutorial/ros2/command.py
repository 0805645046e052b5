"""The embedded ``ros2`` as a function: read the words of one command, and run its verb."""

import functools
from collections.abc import Callable, Sequence

from param_tutorial.errors import ParameterToolError
from param_tutorial.ros2 import changes, check, node, panel, param, pkg, run, system
from param_tutorial.ros2.launch import verb
from param_tutorial.ros2.session import CommandFailed, Parser, Printed, Session, TextStream
from param_tutorial.runtime.executor import BackgroundExecutor


@functools.cache
def _parser() -> Parser:
    parser = Parser(prog='ros2', description="The course's own ros2: the commands that the lessons use.", epilog=(
        'All other commands come with an installation of ROS 2; environment/README.md says how to get one.'))
    commands = parser.add_subparsers(metavar='command', title='commands')
    for module in (node, param, pkg, run, verb, check, system, changes, panel):
        module.add_to(commands)
    return parser


def main(argv: Sequence[str], *, stdout: TextStream, stderr: TextStream, get_executor: Callable[[], BackgroundExecutor],
         in_notebook: bool = False) -> int:
    """Run one command.

    :param argv: The words after ``ros2``.
    :param get_executor: Gives the executor that carries the calls; called only by verbs that need one.
    :param in_notebook: Reject what would keep the cell busy forever.
    :return: The exit status.
    """
    session = Session(stdout, stderr, get_executor, in_notebook)
    try:
        parser = _parser()
        args = parser.parse_args(argv)
        if not hasattr(args, 'verb'):
            getattr(args, 'help_of', parser).print_help()
        return args.verb(session, args) or 0
    except Printed as printed:
        (stderr if printed.status else stdout).write(str(printed))
        return printed.status
    except (CommandFailed, ParameterToolError) as error:
        session.complain(error)
        return 1
