"""Ask running nodes what they declare. ``files.descriptions`` defines the answer, and saves it."""

from collections.abc import Iterable

from rclpy.node import Node

from param_tools.files.descriptions import DescribedParameter, Descriptions, NodeDescription
from param_tools.node.client import ParameterClient
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC
from param_tools.systems.snapshot import ask_all


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
