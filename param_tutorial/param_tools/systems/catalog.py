"""What the nodes of the graph have: which nodes there are, their parameters and values, as they come, go and change.

All of it happens in the executor's thread: nodes come and go, values change, and each node is asked by a coroutine, so
a node that hangs keeps no other one waiting.
"""

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from rcl_interfaces.msg import ParameterEvent

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import NoAnswerError, ParameterToolError, describe_error
from param_tools.node.client import Questions
from param_tools.node.text import format_value
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC

# How soon a node that has not answered is asked again.
_RETRY_PERIOD_SEC = 2.0


@dataclass
class CatalogNode:
    """One node, as far as it is known."""

    name: str
    """Fully qualified."""
    incarnations: frozenset[bytes]
    is_read: bool = False
    problem: str = ''
    """Why its parameters are not known; empty if they are, or are still being asked for."""
    descriptors: dict[str, Descriptor] = field(default_factory=dict)
    values: dict[str, Any] = field(default_factory=dict)
    ask_again_at: float | None = None
    """On the clock of ``time.monotonic``; None if it is being asked, or need not be."""


class Catalog:
    """Follows all nodes of the graph until it is closed."""

    def __init__(self, executor: BackgroundExecutor, on_change: Callable[[], None], *,
                 timeout_sec: float = TIMEOUT_SEC):
        """:param on_change: Called whenever something is new, in any thread. It must not wait."""
        self._executor, self._on_change, self._timeout_sec = executor, on_change, timeout_sec
        self._lock = threading.Lock()
        self._nodes: dict[str, CatalogNode] = {}
        self._closed = False
        self._stop_listening = [executor.on_graph_change(self._look), executor.on_parameter_event(self._on_event),
                                executor.on_tick(self._ask_again)]
        self._look()

    @property
    def nodes(self) -> dict[str, CatalogNode]:
        """The nodes that are there, by name, in the order of the alphabet, each as it is known now."""
        with self._lock:
            return {name: replace(node) for name, node in sorted(self._nodes.items())}

    def find(self, text: str, nodes: Mapping[str, CatalogNode] | None = None) -> dict[str, list[str]]:
        """Find parameters in whose node, name, description or value all words of a text stand.

        :param nodes: Where to look, if not in all that are there now: what goes with the answer is read from the same.
        :return: The parameters' names by node. A node that is found by its own name is there in any case.
        """
        words = text.lower().split()
        found: dict[str, list[str]] = {}
        for name, node in (self.nodes if nodes is None else nodes).items():
            hits = [each for each, descriptor in node.descriptors.items()
                    if _has_all(words, f'{name} {each} {descriptor.description} '
                                       f'{format_value(descriptor, node.values.get(each))}')]
            if hits or _has_all(words, name):
                found[name] = hits
        return found

    def close(self) -> None:
        """Stop following. Safe to call more than once."""
        self._closed = True
        for stop in self._stop_listening:
            stop()
        self._stop_listening = []

    def _look(self) -> None:
        """See which nodes there are, and ask those that are new."""
        present = {name: self._executor.node_incarnations(name) for name in self._executor.services.node_names()}
        new = []
        with self._lock:
            for name in self._nodes.keys() - present.keys():
                del self._nodes[name]
            for name, incarnations in present.items():
                known = self._nodes.get(name)
                if known is None or known.incarnations != incarnations:
                    self._nodes[name] = CatalogNode(name, incarnations)
                    new.append(self._nodes[name])
        for node in new:
            self._ask(node)
        self._on_change()

    def _ask(self, node: CatalogNode) -> None:
        node.ask_again_at = None
        if not self._closed:
            self._executor.create_task(self._read(node))

    def _ask_again(self) -> None:
        """Ask the nodes again that have not answered."""
        with self._lock:
            late = [node for node in self._nodes.values() if node.ask_again_at and node.ask_again_at < time.monotonic()]
        for node in late:
            self._ask(node)

    async def _read(self, node: CatalogNode) -> None:
        async def ask(service: str, request: Any) -> Any:
            return await self._executor.services.call_async(node.name, service, request, timeout_sec=self._timeout_sec)

        try:
            descriptors, present = await Questions(node.name, ask).describe_and_get()
        except ParameterToolError as error:
            with self._lock:
                node.problem, node.is_read = describe_error(error), True
                if isinstance(error, NoAnswerError):
                    node.ask_again_at = time.monotonic() + _RETRY_PERIOD_SEC
        else:
            with self._lock:
                node.descriptors, node.values = dict(descriptors), dict(present)
                node.problem, node.is_read = '', True
        if not self._closed:
            self._on_change()

    def _on_event(self, event: ParameterEvent) -> None:
        with self._lock:
            node = self._nodes.get(event.node)
        if node is None:
            return
        if event.new_parameters or event.deleted_parameters:
            self._ask(node)
        with self._lock:
            for each in event.changed_parameters:
                if each.name in node.values and each.value.type < len(values.TYPES):
                    node.values[each.name] = values.to_python(each.value)
        self._on_change()


def _has_all(words: list[str], text: str) -> bool:
    lower = text.lower()
    return all(word in lower for word in words)
