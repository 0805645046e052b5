"""The parameters of all nodes in one call, with a word on each node that did not answer. No Jupyter."""

from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

from rclpy.node import Node

from param_tutorial.errors import ExecutorError, NodeError, NodeNotFoundError
from param_tutorial.parameters import values
from param_tutorial.parameters.client import ParameterClient, ParameterValues
from param_tutorial.pictures.styles import style
from param_tutorial.pictures.tables import Row, grouped_table
from param_tutorial.runtime import stage
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import TIMEOUT_SEC, full_name

_STYLE = style('parameters/snapshot.css')


class Snapshot(dict[str, ParameterValues]):
    """Node names, sorted, and for each its ParameterValues. A plain dictionary, but for how it is shown."""

    def __init__(self, nodes: dict[str, ParameterValues], unanswered: dict[str, NodeError]):
        super().__init__(nodes)
        self.unanswered = unanswered
        """The nodes that are not in it, and why: each an error of Services.call."""

    def __missing__(self, node: str) -> ParameterValues:
        raise self.unanswered.get(node) or NodeNotFoundError(node, list(self))

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
    """Read all parameters of all nodes, each at the same time as the others.

    Not one moment in the life of the system: while one node is read, another may change.

    :param nodes: Only these, or this one; by default all in the graph but those whose name begins with an underscore.
        A node in another process is in the graph when it has been discovered.
    :param timeout_sec: How long a node may take for each answer. One that takes longer, has no parameter services,
        or leaves meanwhile is in ``unanswered``; it does not keep the others.
    :raises ExecutorError: no executor is running, or this is called from a callback.
    """
    ros = executor or stage.current()
    if ros.services.in_executor_thread():
        raise ExecutorError('a callback cannot wait for the answers of nodes: the executor that would have to bring '
                            'them is busy with the callback. Call all_parameters() in a cell')
    if isinstance(nodes, (str, Node)):
        nodes = [nodes]
    names = sorted(set(ros.services.node_names() if nodes is None else map(full_name, nodes)))

    def read(node: str) -> ParameterValues | NodeError:
        try:
            return ParameterClient(node, timeout_sec=timeout_sec, executor=ros).get_parameters()
        except NodeError as error:
            return error

    with ThreadPoolExecutor(max(len(names), 1), 'all_parameters') as threads:
        answers = dict(zip(names, threads.map(read, names)))
    return Snapshot({node: answer for node, answer in answers.items() if isinstance(answer, dict)},
                    {node: answer for node, answer in answers.items() if isinstance(answer, NodeError)})
