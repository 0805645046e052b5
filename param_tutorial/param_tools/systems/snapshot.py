"""Ask all nodes at once: for their parameters, which can be saved in one file, or for what they declare."""

import datetime
from collections.abc import Callable, Iterable
from typing import TypeVar

from rclpy.node import Node

from param_tools import values
from param_tools.errors import ExecutorError, NodeError, NodeNotFoundError
from param_tools.files import parameter_files
from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.markup.styles import style
from param_tools.markup.tables import Row, grouped_table
from param_tools.markup.wording import format_count
from param_tools.node.client import ParameterClient, ParameterValues
from param_tools.ros import host, stage
from param_tools.ros.executor import TOOL_NODE_NAME, BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC, full_name

_STYLE = style('param_tools/systems/snapshot.css')

T = TypeVar('T')

FIRST_WORDS = '# Snapshot of'
"""How a saved snapshot begins. It holds all parameters of its nodes, and other parameter files hold only some."""


class Snapshot(dict[str, ParameterValues]):
    """The ParameterValues of each node, by the nodes' names, sorted. A dictionary that is shown as a table."""

    def __init__(self, nodes: dict[str, ParameterValues], unanswered: dict[str, NodeError],
                 taken: datetime.datetime | None = None):
        super().__init__(nodes)
        self.unanswered = unanswered
        """The nodes that have not answered, each with an error of Services.call. They are not in the snapshot."""
        self.taken = taken or datetime.datetime.now().astimezone()
        """When the nodes had these values; by default now."""

    def __missing__(self, node: str) -> ParameterValues:
        raise self.unanswered.get(node) or NodeNotFoundError(node, list(self))

    def dump(self) -> parameter_files.Dump:
        """Return one parameter file for all nodes, which ``--params-file`` and ``restore`` can read."""
        dumps = {node: parameter_files.render(node, parameters) for node, parameters in self.items()}
        lines = [f'{FIRST_WORDS} {format_count(len(self), "node")}, {self.taken.isoformat(timespec="seconds")}\n']
        lines += [f'# {node} is missing: {" ".join(str(error).split())}\n' for node, error in self.unanswered.items()]
        left_out = {f'{node}: {name}': reason for node, dump in dumps.items() for name, reason in dump.left_out.items()}
        return parameter_files.Dump(''.join(lines) + '\n'.join(dump.text for dump in dumps.values()), left_out)

    def __repr__(self) -> str:
        lines = []
        for node, parameters in self.items():
            lines += [node, *(f'  {line}' for line in repr(parameters).splitlines())]
        lines += [f'{node}\n  no answer: {error}' for node, error in self.unanswered.items()]
        return '\n'.join(lines) or '(no nodes)'

    def _repr_html_(self) -> str:
        groups: dict[str, list[Row]] = {
            node: [(name, values.format_value(value)) for name, value in parameters.items()] or [('no parameters', '')]
            for node, parameters in self.items()}
        groups |= {node: [('no answer', str(error))] for node, error in self.unanswered.items()}
        if not groups:
            return '<p>There are no nodes.</p>'
        return f'{_STYLE}<div class="param-snapshot">{grouped_table(("node", "parameter", "value"), groups)}</div>'


def all_parameters(nodes: Iterable[str | Node] | str | Node | None = None, *, timeout_sec: float = TIMEOUT_SEC,
                   executor: BackgroundExecutor | None = None) -> Snapshot:
    """Read all parameters of all nodes, all nodes at the same time.

    The result isn't one moment in the life of the system: while one node is read, another may change.

    :param nodes: A node, or several; by default all in the graph except those whose name begins with an underscore. A
        node in another process is in the graph once it has been discovered.
    :param timeout_sec: How long a node may take for each answer. A node that takes longer, has no parameter services,
        or leaves meanwhile is in ``unanswered``, and doesn't delay the others.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    answers, unanswered = ask_all(nodes, ParameterClient.get_parameters, timeout_sec=timeout_sec, executor=executor)
    return Snapshot(answers, unanswered)


def describe(nodes: Iterable[str | Node] | str | Node | None = None, *, timeout_sec: float = TIMEOUT_SEC,
             executor: BackgroundExecutor | None = None) -> Descriptions:
    """Ask running nodes what they declare, all at the same time.

    :param nodes: Which; by default all in the graph. Only then the result is ``complete``, if all have answered.
    :param timeout_sec: How long a node may take for each answer; one that doesn't answer is in ``unanswered``.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    def ask(client: ParameterClient) -> NodeDescription:
        descriptors, present = client.describe_and_get()
        return NodeDescription(client.node, {
            name: DescribedParameter(each, present[name]) for name, each in descriptors.items()})

    answers, unanswered = ask_all(nodes, ask, timeout_sec=timeout_sec, executor=executor)
    return Descriptions(answers.values(), complete=nodes is None and not unanswered, unanswered=unanswered)


def ask_all(nodes: Iterable[str | Node] | str | Node | None, question: Callable[[ParameterClient], T], *,
            timeout_sec: float = TIMEOUT_SEC, executor: BackgroundExecutor | None = None
            ) -> tuple[dict[str, T], dict[str, NodeError]]:
    """Ask many nodes something, all at the same time.

    :param nodes: Which; by default all in the graph except hidden ones.
    :param question: Asks one node through its client.
    :return: The answers by node, sorted; and the nodes that did not answer, with the reason.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    ros = executor or stage.current()
    if ros.in_thread():
        raise ExecutorError('a callback cannot wait for the answers of nodes: the executor that would have to bring '
                            'them is busy with the callback. Ask in a cell')
    if isinstance(nodes, (str, Node)):
        nodes = [nodes]
    names = sorted(set(ros.services.node_names() if nodes is None else map(full_name, nodes))
                   - {f'/{TOOL_NODE_NAME}'})

    def ask(node: str) -> tuple[T | None, NodeError | None]:
        try:
            return question(ParameterClient(node, timeout_sec=timeout_sec, executor=ros)), None
        except NodeError as error:
            return None, error

    answers: dict[str, T] = {}
    unanswered: dict[str, NodeError] = {}
    for node, (answer, error) in zip(names, host.host.map(ask, names)):
        if error is None:
            answers[node] = answer  # type: ignore[assignment]
        else:
            unanswered[node] = error
    return answers, unanswered
