"""Calling the parameter services of any node, with a deadline and a clear word for every way to fail.

Knows the six services that every node offers, discovery, time limits, and nodes that leave or raise in
mid-call. What the requests mean is in ``client``.
"""

import contextlib
import math
import threading
import time
from collections import deque
from collections.abc import Callable, Coroutine, Generator
from dataclasses import dataclass
from typing import Any, Protocol

from rcl_interfaces.srv import SetParameters
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.exceptions import InvalidHandle, NameValidationException
from rclpy.node import Node
from rclpy.task import Future

from param_tools.errors import (
    CallbackError,
    ExecutorError,
    NoAnswerError,
    NodeError,
    NodeGoneError,
    NodeNotFoundError,
    NoServiceError,
    ParameterToolError,
)
from param_tools.ros import domain, graph, host, waiting
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.waiting import deadline

TIMEOUT_SEC = 3.0
_TURN_PERIOD_SEC = 0.005
# Requests that change nothing are sent again while no answer comes: see Services._carry. So is an empty set.
_QUESTIONS = ('describe_parameters', 'get_parameters', 'get_parameter_types', 'list_parameters', 'set_parameters')
_REPEAT_PERIOD_SEC = 0.7
# How long after its time limit the executor may take to end a call.
_GRACE_SEC = 1.5
# How long nodes may take to answer once a callback has been interrupted that kept them all waiting.
_TURN_SEC = 1.0


def full_name(node: str | Node) -> str:
    """Return a node's fully qualified name: ``talker`` is ``/talker``.

    :raises TypeError: it is neither a name nor a node.
    :raises ParameterToolError: it is a node that was destroyed.
    """
    if isinstance(node, Node):
        try:
            return node.get_fully_qualified_name()
        except InvalidHandle:
            raise ParameterToolError(f'this {type(node).__name__} was destroyed, and its name went with it: make it '
                                     f'again, or give the name of a node that runs') from None
    if not isinstance(node, str):
        raise TypeError(
            f'{node!r} is not a node: give its name, such as "/talker", or the node that ros.add() returned')
    return '/' + node.strip('/')


class Carrier(Protocol):
    """The executor that carries the calls."""

    tool_node: Node
    """Owns the clients."""

    def in_thread(self) -> bool:
        """True in the executor's thread."""

    def create_task(self, coroutine: Coroutine[Any, Any, object], /) -> None:
        """Run a coroutine in the executor's thread."""

    def free(self) -> bool:
        """End a callback that keeps the executor's thread for long; return True if there was one and it ended."""

    def culprit(self, since: float) -> str:
        """Say which callback keeps the thread for long, or was interrupted since a time; or nothing."""


@dataclass(eq=False)
class _PendingCall:
    node: str
    service: str
    client: Client
    timeout_sec: float
    began: float
    deadline: float


def _fail(future: Future, error: BaseException) -> None:
    future.set_exception(error)
    future.exception()  # if nobody waits any more, rclpy would print it where a learner reads


class _NextTurn:
    """Awaited in a coroutine, gives the executor a turn."""

    def __await__(self) -> Generator[None, None, None]:
        yield


class Services:
    """Calls parameter services through the tool node of an executor."""

    def __init__(self, executor: Carrier):
        """:param executor: Must be spinning its tool node when something is called."""
        self._executor, self._tool_node = executor, executor.tool_node
        self._newcomer_until = deadline(graph.NEWCOMER_SEC)
        self._clients: dict[tuple[str, str], Client] = {}
        self._pending: dict[Future, _PendingCall] = {}
        # The node and service of each client that has had an answer since the graph changed.
        self._answered: set[tuple[str, str]] = set()
        # Calls not sent yet, by node, first in first out.
        self._queues: dict[str, deque[Future]] = {}
        self._lock = threading.RLock()
        # Gives coroutines their turns while they wait for something that doesn't wake the executor.
        self._clock = self._tool_node.create_timer(_TURN_PERIOD_SEC, lambda: None, autostart=False)
        self._waiting_coroutines = 0

    def node_names(self, *, hidden: bool = False) -> list[str]:
        """Return the fully qualified names of the nodes in the graph, as ``graph.node_names`` does."""
        return graph.node_names(self._tool_node, hidden=hidden)

    def call(self, node: str, service: str, request: Any, *, timeout_sec: float = TIMEOUT_SEC) -> Any:
        """Call a parameter service of a node and wait for its answer.

        :param node: Fully qualified name.
        :param service: One of SERVICE_TYPES.
        :param timeout_sec: How long the node may take to answer; and to come, if that is more than graph.NEWCOMER_SEC.
        :raises NodeNotFoundError: there is no such node.
        :raises NoServiceError: it has no such service.
        :raises NoAnswerError: it did not answer in time.
        :raises NodeGoneError: it left before it answered.
        :raises CallbackError: a callback of the node, which lives in this process, raised an exception.
        :raises ExecutorError: called from a callback, where waiting would block the executor forever.
        """
        if self._executor.in_thread():
            raise ExecutorError('a callback cannot wait for a service: the answer would have to come through the '
                                'executor that the callback keeps busy. Use call_async of an rclpy client')
        if not self.find(node, service, timeout_sec if timeout_sec > graph.NEWCOMER_SEC else 0.0):
            raise self._absence(node, service)
        finished, began = threading.Event(), time.monotonic()
        future = self.call_async(node, service, request, timeout_sec=timeout_sec)
        future.add_done_callback(lambda _: finished.set())
        # The executor ends a call that is late, as long as no callback keeps it busy.
        if not waiting.wait_for(finished, timeout_sec):
            self._executor.free()
            if not waiting.wait_for(finished, timeout_sec + _GRACE_SEC):
                self._forget(future)
                raise self._no_answer(node, service, timeout_sec, began)
        return future.result()

    def call_async(self, node: str, service: str, request: Any, *, timeout_sec: float = TIMEOUT_SEC) -> Future:
        """Call a parameter service of a node, without waiting.

        :return: Holds the answer, or one of the errors of ``call``; a coroutine in the executor may await it, and what
            is added with ``add_done_callback`` is called in the executor's thread.
        :raises NodeNotFoundError: the name cannot be that of any node.
        """
        with self._lock:
            if (node, service) in self._answered and not self._queues.get(node) and self.is_ready(node, service):
                return self._send(node, service, request, timeout_sec)
            self._client(node, service)
            future = Future()
            self._queues.setdefault(node, deque()).append(future)
        self._executor.create_task(self._carry(node, service, request, timeout_sec, future))
        return future

    async def _carry(self, node: str, service: str, request: Any, timeout_sec: float, future: Future) -> None:
        """Call a service of a node that may be just coming."""
        self._waiting_coroutines += 1
        self._clock.reset()
        queue = self._queues[node]
        try:
            # Requests are sent in the order of the calls; rclpy's executor runs the newest task first.
            while queue[0] is not future:
                await _NextTurn()
            end = deadline(graph.DISCOVERY_SEC)
            while not self.is_ready(node, service):
                if self._gives_up(node, end):
                    raise self._absence(node, service)
                await _NextTurn()
            # A server that has just been discovered may know the client's request and not yet where to answer; rmw
            # then waits a tenth of a second and drops the answer. Questions can simply be repeated. A set should not
            # be, so it is preceded by an empty one, which no callback hears of.
            is_set = service == 'set_parameters' and bool(request.parameters)
            if is_set and (node, service) not in self._answered:
                await self._request(node, service, SetParameters.Request(), timeout_sec, repeat=True)
            answer = await self._request(node, service, request, timeout_sec,
                                         repeat=service in _QUESTIONS and not is_set, on_sent=queue.popleft)
        except Exception as error:
            _fail(future, error)
        else:
            future.set_result(answer)
        finally:
            with contextlib.suppress(ValueError):  # it was sent
                queue.remove(future)
            self._waiting_coroutines -= 1
            if not self._waiting_coroutines:
                with contextlib.suppress(InvalidHandle):  # the stage ends
                    self._clock.cancel()

    async def _request(self, node: str, service: str, request: Any, timeout_sec: float, *, repeat: bool,
                       on_sent: Callable[[], object] = lambda: None) -> Any:
        """Send a request, again and again if it may be repeated, and wait for the answer."""
        sent = [self._send(node, service, request, timeout_sec)]
        on_sent()
        repeat_at = deadline(_REPEAT_PERIOD_SEC)
        try:
            while not any(future.done() for future in sent):
                if repeat and time.monotonic() > repeat_at:
                    sent.append(self._send(node, service, request, timeout_sec))
                    repeat_at = deadline(_REPEAT_PERIOD_SEC)
                await _NextTurn()
            return next(future for future in sent if future.done()).result()
        finally:
            for future in sent:
                self._forget(future)

    def is_ready(self, node: str, service: str = 'set_parameters') -> bool:
        """True if the node is there, so that a call now would reach it."""
        return self._client(node, service).service_is_ready()

    def find(self, node: str, service: str = '', at_least_sec: float = 0.0) -> bool:
        """Wait until a node, or one of its parameter services, is in the graph, and return whether it is.

        A node that is missing is waited for until discovery must have finished: see ``graph``.

        :param node: Fully qualified name.
        :param service: One of SERVICE_TYPES; without it, a node that has none is found by its name.
        :param at_least_sec: Where a node may take longer to come, as on a network.
        """
        def is_known() -> bool:
            if service:
                return self.is_ready(node, service)
            # A node's services may be known before its name.
            return self.is_ready(node) or node in self.node_names(hidden=True)

        end = deadline(max(graph.DISCOVERY_SEC, at_least_sec))
        try:
            waiting.wait(lambda: is_known() or self._gives_up(node, end), math.inf)
            return is_known()
        except NodeNotFoundError:  # this cannot be the name of any node
            return False

    def _gives_up(self, node: str, end: float) -> bool:
        """True if a search for a node, or for a service of it, has taken long enough.

        :param end: Until when it goes on in any case.
        """
        now = time.monotonic()
        # Where there are no other processes, all nodes are known at once.
        return now > end and (now > self._newcomer_until or not host.host.has_processes
                              or node in self.node_names(hidden=True))

    def _absence(self, node: str, service: str) -> NodeError:
        if node in self.node_names(hidden=True):
            return NoServiceError(node, service)
        return NodeNotFoundError(node, self.node_names(), on_network=not domain.is_limited_to_this_host())

    def graph_changed(self, before: graph.Incarnations, now: graph.Incarnations) -> None:
        """Take note that nodes came, went or were replaced; the executor's thread calls this.

        A node that comes again gets new clients: requests of one that has outlived many servers reach the next one only
        after up to three seconds (Fast DDS 2.14).
        """
        self._answered.clear()
        left = {name for name, _ in before - now}
        self._end_clients(lambda node: node in left)

    def forget(self, namespace: str) -> None:
        """Destroy the clients for the nodes in a namespace; in the executor's thread.

        Every node that is created later pays for a client that is left behind: DDS holds it against each new service,
        and a hundred of them make it five times as long.
        """
        self._end_clients(lambda node: node.startswith(f'{namespace}/'))

    def _end_clients(self, choose: Callable[[str], bool]) -> None:
        with self._lock:
            waiting_clients = [call.client for call in self._pending.values()]
            ended = [key for key, client in self._clients.items() if choose(key[0]) and client not in waiting_clients]
            for client in [self._clients.pop(key) for key in ended]:
                self._tool_node.destroy_client(client)

    def expire(self) -> None:
        """Fail the calls whose node is gone or late; the executor's thread calls this now and then."""
        with self._lock:
            pending = list(self._pending.items())
        for future, call in pending:
            if time.monotonic() > call.deadline:
                self._finish(future, self._no_answer(call.node, call.service, call.timeout_sec, call.began))
            # On a busy machine a service alone may seem gone for a moment.
            elif not call.client.service_is_ready() and graph.has_left(call.node, self._tool_node):
                self._finish(future, NodeGoneError(call.node, call.service))

    def give_a_turn(self, interrupted: tuple[str, str]) -> None:
        """Leave nodes time to answer calls that were late because of a callback, which has now been interrupted.

        :param interrupted: The node and the parameter service that the callback was serving, if any: that call gets no
            answer.
        """
        with self._lock:
            for call in self._pending.values():
                if (call.node, call.service) != interrupted:
                    call.deadline = max(call.deadline, deadline(_TURN_SEC))

    def fail(self, node: str, service: str, error: BaseException) -> bool:
        """Hand an exception that ended a service's callback to the oldest call from this process that waits for it.

        :return: True if there was such a call.
        """
        with self._lock:
            unanswered = next((future for future, call in self._pending.items()
                               if (call.node, call.service) == (node, service)), None)
        if unanswered is None:
            return False
        self._finish(unanswered, CallbackError(node, service, error))
        return True

    def _no_answer(self, node: str, service: str, timeout_sec: float, began: float) -> NoAnswerError:
        return NoAnswerError(node, service, timeout_sec, on_network=domain.reaches_other_hosts(),
                             culprit=self._executor.culprit(began))

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

    def _send(self, node: str, service: str, request: Any, timeout_sec: float) -> Future:
        # The lock is held over both steps: the answer, or the error of a callback, may come in between.
        with self._lock:
            client = self._client(node, service)
            future = client.call_async(request)
            self._pending[future] = _PendingCall(node, service, client, timeout_sec, time.monotonic(),
                                                 deadline(timeout_sec))
        future.add_done_callback(self._forget)
        return future

    def _forget(self, future: Future) -> None:
        with self._lock:
            call = self._pending.pop(future, None)
            if call is None:
                return
            if not future.done():  # otherwise rclpy has done so
                call.client.remove_pending_request(future)
            elif future.exception() is None:
                self._answered.add((call.node, call.service))

    def _finish(self, future: Future, error: BaseException) -> None:
        with self._lock:
            call = self._pending.pop(future, None)
        if call is not None and not future.done():
            call.client.remove_pending_request(future)
            _fail(future, error)
