"""Calling the parameter services of any node, with a deadline and a clear word for every way to fail.

Knows the six services that every node offers, discovery, time limits, and nodes that leave or raise in
mid-call. What the requests mean is in ``client``.
"""

import threading
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rcl_interfaces.srv import SetParameters
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.exceptions import NameValidationException
from rclpy.node import Node
from rclpy.task import Future

from param_tools.errors import (
    CallbackError,
    DiscoveryTimeoutError,
    ExecutorError,
    NoAnswerError,
    NodeError,
    NodeGoneError,
    NodeNotFoundError,
    WaitTimeoutError,
)
from param_tools.ros import domain, graph
from param_tools.ros.interrupts import Latch
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.waiting import machine_time

# How long a node may take to come. A node in this process is found at once; a process that has just been started takes
# a second or two before it has one.
DISCOVERY_TIMEOUT_SEC = 3.0
TIMEOUT_SEC = 3.0
_LOOK_PERIOD_SEC = 0.1
# Requests that change nothing are sent again while no answer comes: see Services.greet.
_QUESTIONS = ('describe_parameters', 'get_parameters', 'get_parameter_types', 'list_parameters')
_REPEAT_PERIOD_SEC = 0.7
# How long to wait for an answer once more, when a callback had kept the executor's thread and no longer does.
_SECOND_CHANCE_SEC = 1.5
# Requests of a client that has outlived some two hundred servers reach the next one only with a heartbeat of Fast DDS
# 2.14, after up to three seconds; those of a new client at once. On a busy machine: 14 of 260 against 0 of 300.
_MOST_OUTLIVED = 50
# A thread may have got hold of a client just before nobody else was to use it.
_RETIREMENT_SEC = 5.0


def full_name(node: str | Node) -> str:
    """Return a node's fully qualified name: ``talker`` is ``/talker``.

    :raises TypeError: it is neither a name nor a node.
    """
    if isinstance(node, Node):
        return node.get_fully_qualified_name()
    if not isinstance(node, str):
        raise TypeError(
            f'{node!r} is not a node: give its name, such as "/talker", or the node that ros.add() returned')
    return '/' + node.strip('/')


@dataclass(eq=False)
class _PendingCall:
    node: str
    service: str
    request: Any
    client: Client
    timeout_sec: float | None
    """None if somebody waits for the answer, and looks after it."""
    sent: float
    """In machine time."""


@dataclass(eq=False)
class _RetiredClient:
    node: str
    client: Client
    since: float
    """In machine time."""


class Services:
    """Calls parameter services through one node that an executor spins in another thread."""

    def __init__(self, tool_node: Node, in_executor_thread: Callable[[], bool], free_thread: Callable[[], bool]):
        """
        :param tool_node: Owns the service clients; its executor must be spinning.
        :param in_executor_thread: Returns True in the thread that spins it.
        :param free_thread: Called when an answer did not come in time: a callback may keep that thread from bringing
            any. Returns True if one did, and no longer does.
        """
        self._tool_node = tool_node
        self.in_executor_thread = in_executor_thread
        self._free_thread = free_thread
        self._clients: dict[tuple[str, str], Client] = {}
        self._pending: dict[Future, _PendingCall] = {}
        self._generation = 0
        self._greeted: dict[str, int] = {}
        self._outlived: Counter[str] = Counter()
        self._retired: list[_RetiredClient] = []
        self._lock = threading.RLock()

    def node_names(self, *, hidden: bool = False) -> list[str]:
        """Return the fully qualified names of the nodes in the graph, sorted, a name twice if two nodes have it.

        :param hidden: Also those with a part that starts with an underscore.
        """
        names = (f'{namespace.rstrip("/")}/{name}' for name, namespace in graph.nodes_in_graph(self._tool_node))
        return sorted(name for name in names if hidden or '/_' not in name)

    def call(self, node: str, service: str, request: Any, *, timeout_sec: float = TIMEOUT_SEC,
             discovery_timeout_sec: float = DISCOVERY_TIMEOUT_SEC) -> Any:
        """Call a parameter service of a node and wait for its answer.

        :param node: Fully qualified name.
        :param service: One of SERVICE_TYPES.
        :param timeout_sec: How long the node may take to answer, in machine time.
        :param discovery_timeout_sec: How long the node may take to come if it is not there yet, in machine time.
        :raises NodeNotFoundError: there is no such node.
        :raises DiscoveryTimeoutError: it is not known whether there is.
        :raises NodeError: it has no such service.
        :raises NoAnswerError: it did not answer in time.
        :raises NodeGoneError: it left before it answered.
        :raises CallbackError: a callback of the node, which lives in this process, raised an exception.
        :raises ExecutorError: called from a callback, where waiting would block the executor forever.
        """
        if self.in_executor_thread():
            raise ExecutorError('a callback cannot wait for a service: the answer would have to come through the '
                                'executor that the callback keeps busy. Use call_async of an rclpy client')
        client = self._found(node, service, discovery_timeout_sec)
        if service == 'set_parameters':
            self.greet(node, timeout_sec=timeout_sec)
        return self._wait_for_answer(client, node, service, request, timeout_sec, repeat=service in _QUESTIONS)

    def _wait_for_answer(self, client: Client, node: str, service: str, request: Any, timeout_sec: float, *,
                         repeat: bool) -> Any:
        finished = Latch()
        sent: list[Future] = []
        began = machine_time()
        deadline, is_second_chance = began + timeout_sec, False
        try:
            while True:
                if not sent or (repeat and machine_time() > began + len(sent) * _REPEAT_PERIOD_SEC):
                    self._send(client, node, service, request, sent).add_done_callback(lambda _: finished.set())
                if finished.wait(_LOOK_PERIOD_SEC):
                    break
                gone = self._is_gone(node, client)
                if finished.wait(_LOOK_PERIOD_SEC):  # an answer may have been on its way
                    break
                if gone and is_second_chance:  # its callback could not be interrupted, so it was removed
                    raise self._no_answer(node, service, timeout_sec)
                if gone:
                    raise NodeGoneError(node, service)
                if machine_time() > deadline:
                    if is_second_chance or not self._free_thread():
                        raise self._no_answer(node, service, timeout_sec)
                    deadline, is_second_chance = machine_time() + _SECOND_CHANCE_SEC, True
        finally:
            for future in sent:
                self._forget(future, client)
        return next(future for future in sent if future.done()).result()

    def greet(self, node: str, *, timeout_sec: float = TIMEOUT_SEC) -> None:
        """Make sure that a node's answers to set_parameters arrive, before anything is set.

        A server that has just been discovered may know the client's request and not yet where to answer; rmw then
        waits a tenth of a second and drops the answer. Questions can simply be repeated. A set should not be, so
        once after each change in the graph it is preceded by an empty one, which no callback hears of.

        :raises ParameterToolError: as ``call``.
        """
        generation = self._generation
        if self._greeted.get(node) == generation:
            return
        client = self._found(node, 'set_parameters', DISCOVERY_TIMEOUT_SEC)
        self._wait_for_answer(client, node, 'set_parameters', SetParameters.Request(), timeout_sec, repeat=True)
        self._greeted[node] = generation

    def graph_changed(self, before: graph.Incarnations, now: graph.Incarnations) -> None:
        """Take note that nodes came, went or were replaced; the executor's thread calls this."""
        self._generation += 1
        present = {name for name, _ in now}
        for name in {name for name, _ in before - now}:
            self._outlived[name] += 1
            if name not in present or self._outlived[name] >= _MOST_OUTLIVED:
                self._retire(name)

    def _retire(self, node: str) -> None:
        """Let the next calls of a node have new clients."""
        with self._lock:
            self._retired += [_RetiredClient(node, self._clients.pop(key), machine_time())
                              for key in list(self._clients) if key[0] == node]
            self._greeted.pop(node, None)
            del self._outlived[node]

    def call_async(self, node: str, service: str, request: Any, on_answer: Callable[[Future], object], *,
                   timeout_sec: float = TIMEOUT_SEC) -> None:
        """Call a parameter service of a node that is known to be there, without waiting.

        :param on_answer: Called in the executor's thread, with a future that holds the answer or one of the errors of
            ``call``.
        :raises NodeNotFoundError: the node is not there now.
        """
        client = self._client(node, service)
        if not client.service_is_ready():
            raise NodeNotFoundError(node, self.node_names())

        def finish(future: Future) -> None:
            try:
                on_answer(future)  # first, as somebody waits for it
            finally:
                self._forget(future, client)

        self._send(client, node, service, request, [], timeout_sec).add_done_callback(finish)

    def is_ready(self, node: str, service: str = 'set_parameters') -> bool:
        """True if the node is there, so that a call now would reach it."""
        return self._client(node, service).service_is_ready()

    def forget(self, namespace: str) -> None:
        """Destroy the clients for the nodes in a namespace, unless they wait for an answer; in the executor's thread.

        Every node that is created later pays for a client that is left behind: DDS holds it against each new service,
        and a hundred of them make it five times as long.
        """
        with self._lock:
            for node in {node for node, _ in self._clients if node.startswith(f'{namespace}/')}:
                self._retire(node)
        self._end_retired(lambda each: each.node.startswith(f'{namespace}/'))

    def _end_retired(self, choose: Callable[[_RetiredClient], bool]) -> None:
        with self._lock:
            waiting = [call.client for call in self._pending.values()]
            ended = [each for each in self._retired
                     if choose(each) and not any(each.client is client for client in waiting)]
            self._retired = [each for each in self._retired if each not in ended]
        for each in ended:
            self._tool_node.destroy_client(each.client)

    def expire(self) -> None:
        """Fail the calls whose node is gone or late, and end clients without use; the executor's thread calls this."""
        with self._lock:
            pending = list(self._pending.items())
        self._end_retired(lambda each: machine_time() > each.since + _RETIREMENT_SEC)
        for future, call in pending:
            if call.timeout_sec is None:
                continue
            if machine_time() > call.sent + call.timeout_sec:
                self._fail(future, self._no_answer(call.node, call.service, call.timeout_sec))
            elif self._is_gone(call.node, call.client):
                self._fail(future, NodeGoneError(call.node, call.service))

    def take(self, error: BaseException, node: str, service: str, request: Any) -> bool:
        """Hand an exception that ended a service callback to the call from this process that it leaves unanswered.

        :param node: Fully qualified name of the node that raised it while it served this request.
        :return: True if there was such a call.
        """
        with self._lock:
            unanswered = next((future for future, call in self._pending.items()
                               if (call.node, call.service, call.request) == (node, service, request)), None)
        if unanswered is None:
            return False
        self._fail(unanswered, CallbackError(node, service, error))
        return True

    @staticmethod
    def _no_answer(node: str, service: str, timeout_sec: float) -> NoAnswerError:
        return NoAnswerError(node, service, timeout_sec, on_network=domain.reaches_other_hosts())

    def _client(self, node: str, service: str) -> Client:
        with self._lock:
            client = self._clients.get((node, service))
            if client is None:
                try:
                    # A group of its own: rclpy's callback groups never forget a client, and the node's lasts.
                    client = self._tool_node.create_client(SERVICE_TYPES[service], f'{node}/{service}',
                                                           callback_group=ReentrantCallbackGroup())
                except NameValidationException:
                    raise NodeNotFoundError(node, self.node_names()) from None
                self._clients[node, service] = client
            return client

    def _is_gone(self, node: str, client: Client) -> bool:
        """True if a node that was there has left. On a busy machine a service alone may seem gone for a moment."""
        return not client.service_is_ready() and graph.has_left(node, self._tool_node)

    def _found(self, node: str, service: str, discovery_timeout_sec: float) -> Client:
        client = self._client(node, service)
        if client.service_is_ready():
            return client

        def is_there() -> bool:
            # A node's services may be known before its name.
            return client.service_is_ready() or node in self.node_names(hidden=True)

        try:
            if not graph.wait_for(is_there, self._tool_node, discovery_timeout_sec):
                network_sec = None if domain.is_limited_to_this_host() else discovery_timeout_sec
                raise NodeNotFoundError(node, self.node_names(), network_sec)
            if not graph.wait_for_service(client.service_is_ready, node, service, self._tool_node):
                if graph.has_left(node, self._tool_node):
                    raise NodeNotFoundError(node, self.node_names())
                raise NodeError(node, f'{node} is running but offers no {service} service: it was created '
                                      f'with start_parameter_services=False, or is just leaving')
        except WaitTimeoutError as error:
            raise DiscoveryTimeoutError(node, error) from None
        return client

    def _send(self, client: Client, node: str, service: str, request: Any, sent: list[Future],
              timeout_sec: float | None = None) -> Future:
        """Send a request, and add its future to ``sent``: a caller that is interrupted in here must forget it."""
        # The lock is held over all steps: the answer, or the error of a callback, may come in between.
        with self._lock:
            future = client.call_async(request)
            sent.append(future)  # before it is pending
            self._pending[future] = _PendingCall(node, service, request, client, timeout_sec, machine_time())
        return future

    def _forget(self, future: Future, client: Client) -> None:
        with self._lock:
            self._pending.pop(future, None)
        if not future.done():  # otherwise rclpy has done so
            client.remove_pending_request(future)

    def _fail(self, future: Future, error: BaseException) -> None:
        with self._lock:
            if self._pending.pop(future, None) is None or future.done():
                return
        future.set_exception(error)

