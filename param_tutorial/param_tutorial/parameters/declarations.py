"""Record what a node declares when it starts."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.parameters.client import is_housekeeping
from param_tutorial.runtime import stage
from param_tutorial.runtime.executor import BackgroundExecutor


@dataclass(frozen=True)
class Declaration:
    """One parameter, as it was declared."""

    name: str
    default: Any
    """None if there is a type in the place of a default."""
    value: Any
    """What the node has afterwards; None if nothing."""


def record_declarations(node_class: type[Node], overrides: Mapping[str, Any] | None = None, *,
                        executor: BackgroundExecutor | None = None) -> tuple[Node, list[Declaration]]:
    """Start a node on the stage, and record each of its declarations, in their order.

    :param node_class: As for ``ros.add()``; its constructor takes no arguments.
    :param overrides: Values from outside, by name, as after ``-p``.
    :return: The node, and its declarations without those that every node has.
    :raises ExecutorError: no executor is running, or node_class is not a class of nodes.
    """
    declared: list[Declaration] = []

    class Recorded(node_class):  # type: ignore[misc, valid-type]
        def declare_parameters(self, namespace: str, parameters: Any, *args: Any, **others: Any) -> list[Parameter]:
            # declare_parameter() comes here too.
            entries = list(parameters)
            answers: list[Parameter] = super().declare_parameters(namespace, entries, *args, **others)
            for (_, *rest), answer in zip(entries, answers, strict=True):
                default = rest[0] if rest and not isinstance(rest[0], (Parameter.Type, type(None))) else None
                declared.append(Declaration(answer.name, default, answer.value))
            return answers

    Recorded.__name__ = Recorded.__qualname__ = node_class.__name__
    arguments = [part for name, value in (overrides or {}).items() for part in ('-p', f'{name}:={json.dumps(value)}')]
    node = (executor or stage.current()).add(Recorded, ros_args=arguments)
    return node, [each for each in declared if not is_housekeeping(each.name)]
