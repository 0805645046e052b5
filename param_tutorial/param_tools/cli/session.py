"""What the verbs of the embedded ``ros2`` share: arguments, streams, finding a node, calling its services.

ROS is imported where it is used: ``check`` reads files without it, and ``ros2 run`` starts a program, which imports it
once more.
"""

import argparse
import functools
import shlex
from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn, Protocol, TypeAlias

from param_tools.errors import NoServiceError
from param_tools.ros.waiting import Steps

if TYPE_CHECKING:
    from param_tools.ros.executor import BackgroundExecutor

# As rclpy.node has it.
HIDDEN_NODE_PREFIX = '_'
SERVICE_TIMEOUT_SEC = 5.0
MORE_ELSEWHERE = ('This is the embedded ros2, with a part of the commands and options. The genuine ros2 has more: '
                  'environment/README.md says how to get it.')
# What add_subparsers() returns; argparse has no public name for it.
Commands: TypeAlias = 'argparse._SubParsersAction[CommandParser]'


class NodeName(NamedTuple):
    """The name of a node; sorted as the genuine command sorts, by the last part first."""

    name: str
    namespace: str
    full_name: str

    @classmethod
    def parse(cls, full_name: str) -> 'NodeName':
        """Split a fully qualified name."""
        namespace, _, name = full_name.rpartition('/')
        return cls(name, namespace or '/', full_name)


class CommandFailed(Exception):
    """The command cannot be done; the message goes to standard error, and the exit status is 1."""


class TextStream(Protocol):
    """Where text can be written: a file, a notebook's cell, a StringIO."""

    def write(self, text: str, /) -> int:
        """Write a text, and return its length."""

    def flush(self) -> None:
        """Pass on what was written so far."""


def advise_terminal(words: Sequence[str]) -> str:
    """Return a sentence on what to do instead of a command that would not let a notebook's cell end."""
    return (f'This would keep the cell busy until you interrupt it. Type it in a terminal: '
            f'{shlex.join(["ros2", *words])}; or add its node to the executor in the notebook: ros.add(...)')


@dataclass
class Session:
    """Where a command writes, and what carries its calls."""

    stdout: TextStream
    stderr: TextStream
    get_executor: 'Callable[[], BackgroundExecutor]'
    """Called only by verbs that need an executor."""
    in_notebook: bool
    """True if the executor stays, and the command must not block forever."""
    advise_instead: Callable[[Sequence[str]], str] = advise_terminal
    """Returns a sentence for somebody who types such a command in a notebook."""

    @functools.cached_property
    def executor(self) -> 'BackgroundExecutor':
        return self.get_executor()

    def print(self, *words: Any, sep: str = ' ', end: str = '\n') -> None:
        print(*words, sep=sep, end=end, file=self.stdout)

    def complain(self, *words: Any) -> None:
        """Print to standard error."""
        print(*words, file=self.stderr)

    def node_names(self, *, hidden: bool) -> list[NodeName]:
        """Return the nodes in the graph as far as it is known; a name twice if two nodes have it."""
        from param_tools.ros.graph import nodes_in_graph

        names = (NodeName(name, namespace, f'{namespace.rstrip("/")}/{name}')
                 for name, namespace in nodes_in_graph(self.executor.tool_node))
        return [each for each in names if hidden or not each.name.startswith(HIDDEN_NODE_PREFIX)]

    def wait_for_graph(self, args: argparse.Namespace) -> None:
        """Wait until no node has come for a while."""
        from param_tools.ros import graph

        joining_sec = 0.0 if self.in_notebook else graph.JOINING_SEC
        graph.wait_until_quiet(self.executor.tool_node, joining_sec if args.spin_time is None else args.spin_time)

    def find(self, args: argparse.Namespace) -> str:
        """Return the fully qualified name of the node that was named, once it is there."""
        node = args.node_name if args.node_name.startswith('/') else f'/{args.node_name}'
        # A hidden node is not looked at without the option; nothing can be waited for then.
        hidden = node.rpartition('/')[2].startswith(HIDDEN_NODE_PREFIX)
        if (hidden and not args.include_hidden_nodes) or not self.executor.services.find(
                node, at_least_sec=max(args.spin_time or 0.0, getattr(args, 'timeout', None) or 0.0)):
            raise CommandFailed('Node not found')
        return node

    def call(self, node: str, service: str, request: Any) -> Any:
        """Call a parameter service of a node that has been found."""
        # Where a process starts on a busy machine, its services come seconds after its name.
        if not self.executor.services.find(node, service, SERVICE_TIMEOUT_SEC):
            raise CommandFailed(without_services(node))
        try:
            return self.executor.services.call(node, service, request, timeout_sec=SERVICE_TIMEOUT_SEC)
        except NoServiceError:
            raise CommandFailed(without_services(node)) from None


def run_verb(session: Session, args: argparse.Namespace) -> Steps:
    """Run the verb that the arguments name, step by step if it goes on until somebody ends it."""
    done = args.verb(session, args)
    if isinstance(done, Generator):
        done = yield from done
    return done or 0


def without_services(node: str | NodeName) -> str:
    """Return what the genuine command says of a node that has no parameter services."""
    return f'Wait for service timed out waiting for parameter services for node {node}'


class Printed(Exception):
    """argparse has something to say and no more to do."""

    def __init__(self, text: str, status: int):
        super().__init__(text)
        self.status = status


class CommandParser(argparse.ArgumentParser):
    """Raise what argparse would print: the streams of a command are not always those of the process."""

    def error(self, message: str) -> NoReturn:
        text = self.format_usage()
        # Somebody may know it from the genuine ros2.
        if message.startswith(('argument command: invalid choice', 'argument verb: invalid choice',
                               'unrecognized arguments: -')):
            text += f'{MORE_ELSEWHERE}\n'
        raise Printed(f'{text}{self.prog}: error: {message}\n', 2)

    def print_help(self, file: Any = None) -> NoReturn:
        raise Printed(self.format_help(), 0)


def add_verbs(commands: Commands, command: str, explanation: str) -> Commands:
    """Add a command that has verbs, and return what its verbs are added to."""
    parser = commands.add_parser(command, help=explanation)
    parser.set_defaults(help_of=parser)
    return parser.add_subparsers(metavar='verb', title='verbs')


def add_discovery_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that all verbs about nodes have."""
    parser.add_argument(
        '--spin-time', type=float, metavar='N',
        help='look for nodes for at least N seconds (default: until all on this machine are known)')
    parser.add_argument('-s', '--use-sim-time', action='store_true', help='accepted; makes no difference here')
    parser.add_argument('--no-daemon', action='store_true', help='accepted; there is no daemon here')


def add_parameter_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that all verbs about parameters have."""
    add_discovery_options(parser)
    parser.add_argument('--include-hidden-nodes', action='store_true', help='consider hidden nodes as well')


def add_graph_options(parser: argparse.ArgumentParser) -> None:
    """Add the options that all verbs about several nodes have."""
    add_parameter_options(parser)
    parser.add_argument('--timeout', type=float, metavar='N', default=SERVICE_TIMEOUT_SEC,
                        help=f'wait up to N seconds for each answer of a node (default: {SERVICE_TIMEOUT_SEC:g})')


def add_node_options(parser: argparse.ArgumentParser) -> None:
    """Add the options and the argument that all verbs about one node have."""
    add_parameter_options(parser)
    # The genuine one takes whole seconds, too.
    parser.add_argument('--timeout', type=int, metavar='N', help='wait up to N seconds for the node to appear')
    parser.add_argument('node_name', help='name of the node')
