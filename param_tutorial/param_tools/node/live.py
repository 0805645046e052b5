"""The parameters of one node, followed live: what the node confirmed, and what it is being asked. No Jupyter.

What is known, and what follows from what happens, is a state machine: ``live_state``. Here are the threads around it.
Each thing that happens is handed to the machine with the lock held, and what the machine returns is done after the
lock has been released. So the lock is never held while sending, waiting or drawing.

Threads. ``LiveParameter.ask`` may be called in any; it sends at once and never waits. Answers, events and the coming
and going of nodes arrive in the executor's thread, which hands them over and sends what waits. Whatever waits for the
node (``_read_step``) or takes time (``_show_step``) is done by two worker threads, so that a node that hangs does not
keep the panel from saying so; or by ``settle``, in the caller's thread.
"""

import contextlib
import functools
import threading
from collections.abc import Callable, Iterable
from typing import Any, ParamSpec

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import SetParameters
from rclpy.task import Future

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import ExecutorError, NodeNotFoundError, WaitTimeoutError, describe_error
from param_tools.node.client import ParameterClient, to_message
from param_tools.node.live_state import LATE_SEC, Change, LiveState, ParameterState, Request, Todo
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.services import TIMEOUT_SEC, full_name
from param_tools.ros.waiting import machine_time
from param_tools.ros.worker import Worker

# Thirty times a second is as often as anybody can see.
_SHOW_PERIOD_SEC = 1 / 30
_READ_PERIOD_SEC = 1 / 60
_GIVE_WAY_SEC = 0.002
FIRST_LOOK_TIMEOUT_SEC = 10.0

P = ParamSpec('P')


class LiveParameter(ParameterState):
    """One parameter of a node. Its attributes may be read in any thread."""

    def __init__(self, live: 'LiveParameters', descriptor: Descriptor, value: Any):
        super().__init__(descriptor, value)
        self._live = live

    @property
    def late(self) -> bool:
        """True if the node takes so long to answer that a person should be told."""
        return self.is_late(machine_time())

    def ask(self, value: Any) -> None:
        """Ask the node for a (normalized) value. Does not wait and never raises: see ``message``."""
        self._live._ask(self, value)

    def give_way(self) -> None:
        """Leave the processor to the node for the moment that its answer takes if it lives in this process."""
        self._live._give_way(self)

    def reject(self, reason: str) -> None:
        """Reject what a hand entered, without asking the node."""
        self._live._reject(self, reason)


class LiveParameters:
    """Follows the parameters of one node through changes, restarts and absence, from ``first_look`` to ``close``."""

    def __init__(self, node: str, show: Callable[[], None], *, names: Iterable[str] | None = None,
                 executor: BackgroundExecutor | None = None, timeout_sec: float = TIMEOUT_SEC):
        """
        :param node: Name of the node.
        :param show: Called after anything changed, in the worker's thread or in that of ``settle``, never twice
            at once.
        :param names: Only these parameters, in this order; by default all, in the node's order.
        :param executor: By default whichever runs in the background, also after a stop and a new start.
        """
        self.node = full_name(node)
        self.names = None if names is None else list(names)
        self._show = show
        self._chosen_executor = executor
        self._timeout_sec = timeout_sec
        self._executor: BackgroundExecutor | None = None
        self._lock = threading.RLock()
        self._ended = threading.Condition(self._lock)
        self._state = LiveState(self.node, functools.partial(LiveParameter, self), timeout_sec)
        self._stop_listening: list[Callable[[], None]] = []
        self._reader = Worker(self._read_step, f'panel of {self.node}: read', _READ_PERIOD_SEC)
        self._shower = Worker(self._show_step, f'panel of {self.node}: show', _SHOW_PERIOD_SEC)
        self._stop_following: Callable[[], None] = lambda: None

    @property
    def parameters(self) -> dict[str, LiveParameter]:
        """The parameters that the node has, as far as is known."""
        return self._state.parameters

    @property
    def status(self) -> str:
        """Why the parameters cannot be changed now; empty if they can."""
        return self._state.status

    @property
    def is_busy(self) -> bool:
        """True while something that was asked for is unanswered, or what came of it is not yet read."""
        with self._lock:
            return self._state.has_unread_answers

    def client(self) -> ParameterClient:
        """Return a client of the node, which waits for each answer.

        :raises ExecutorError: the executor is stopped, or none is running.
        """
        return ParameterClient(self.node, executor=self._require_executor(), timeout_sec=self._timeout_sec)

    def first_look(self, timeout_sec: float = FIRST_LOOK_TIMEOUT_SEC) -> None:
        """Begin to follow: read everything from the node and show it. Waits for a node that is just starting.

        If that fails, or Ctrl+C ends it, the node is not followed: the view that it was for has left its constructor.

        :param timeout_sec: How long to wait for each of the two; 0 to go on at once, and show what comes.
        :raises ExecutorError: called in a callback, where waiting would block the executor forever.
        """
        try:
            self._stop_following = stage.on_change(self._on_executor_change)
            with self._lock:
                self._listen()  # what remains to be done is done below
            if not timeout_sec:
                self._reader.wake()
                self._shower.wake()
                return
            self._require_other_thread()
            self._reader.call_now(timeout_sec)
            self._shower.call_now(timeout_sec)
        except BaseException:
            self.close()
            raise

    def settle(self, timeout_sec: float) -> None:
        """Wait until all that was asked so far is answered, then read everything from the node and show it.

        :raises WaitTimeoutError: it took too long.
        :raises ExecutorError: called in a callback, where waiting would block the executor forever.
        """
        deadline = machine_time() + timeout_sec
        self._require_other_thread()
        # Before everything is asked for: the reader would ask while the answers are still coming.
        self._wait_for_answers(deadline, timeout_sec)
        if self._is_reachable():
            self._hand_over(self._state.refresh)
        while not self._state.closed:
            self._wait_for_answers(deadline, timeout_sec)
            done_in_time = (self._reader.call_now(deadline - machine_time())
                            and self._shower.call_now(deadline - machine_time()))
            with self._lock:
                if self._state.is_settled:
                    return
            if not done_in_time or machine_time() > deadline:
                raise WaitTimeoutError(f'timed out after {timeout_sec:g} s reading the parameters of {self.node}')

    def close(self) -> None:
        """Stop following. Safe to call more than once."""
        self._hand_over(self._close)
        self._reader.end()
        self._shower.end()

    def _hand_over(self, event: Callable[P, Todo], *args: P.args, **kwargs: P.kwargs) -> None:
        """Hand an event to the state machine with the lock held; then, without it, do what is to be done."""
        with self._lock:
            todo = event(*args, **kwargs)
            if todo.ended:
                self._ended.notify_all()
        if todo.send is not None:
            self._send(todo.send)
        if todo.read:
            self._reader.wake()
        if todo.show:
            self._shower.wake()
        if todo.watch:
            self._shower.stay()

    def _close(self) -> Todo:
        self._stop_following()
        self._stop_all_listening()
        return self._state.close()

    # -- asking: any thread -----------------------------------------------------------------------------

    def _ask(self, parameter: LiveParameter, value: Any) -> None:
        self._hand_over(self._state.ask, parameter, value, machine_time())

    def _reject(self, parameter: LiveParameter, reason: str) -> None:
        self._hand_over(self._state.reject, parameter, reason)

    def _send(self, request: Request) -> None:
        try:
            executor = self._executor or stage.current()
            message = to_message(request.parameter.name, request.value, request.parameter.descriptor.type)
            executor.services.call_async(
                self.node, 'set_parameters', SetParameters.Request(parameters=[message]),
                functools.partial(self._on_answer, request), timeout_sec=self._timeout_sec)
        except Exception as error:  # whatever it is: it must become visible, and this may be any thread
            self._hand_over(self._state.send_failed, request, self._reason(error), machine_time())

    # -- what happens: the executor's thread, or the one that starts or stops it --------------------------

    def _on_answer(self, request: Request, future: Future) -> None:
        try:
            result = future.result().results[0]
        except Exception as error:
            self._hand_over(self._state.answer_failed, request, error, machine_time())
        else:
            reason = '' if result.successful else result.reason or 'The node gave no reason.'
            self._hand_over(self._state.answered, request, reason, machine_time())

    def _on_event(self, event: ParameterEvent) -> None:
        if event.node != self.node:
            return
        changes = [Change(each.name, each.value.type, values.to_python_or_none(each.value))
                   for each in event.changed_parameters]
        self._hand_over(self._state.changed, changes, others=bool(event.new_parameters or event.deleted_parameters))

    def _on_graph_change(self) -> None:
        executor = self._executor
        if executor is not None:
            self._hand_over(self._state.graph_changed, executor.node_incarnations(self.node), is_ready=self._is_ready())

    def _on_executor_change(self) -> None:
        if self._chosen_executor is None:
            self._hand_over(self._listen)

    def _listen(self) -> Todo:
        """Listen to the executor that carries the requests from now on, if there is one; with the lock held."""
        self._stop_all_listening()
        try:
            self._executor = self._chosen_executor or stage.current()
        except ExecutorError as error:
            self._executor = None
            return self._state.executor_lost(describe_error(error))
        self._stop_listening = [self._executor.on_parameter_event(self._on_event),
                                self._executor.on_graph_change(self._on_graph_change)]
        return self._state.executor_found(self._executor.node_incarnations(self.node))

    def _stop_all_listening(self) -> None:
        for stop in self._stop_listening:
            stop()
        self._stop_listening = []

    # -- reading and showing: the workers' threads, or that of settle -------------------------------------

    def _read_step(self) -> float | None:
        with self._lock:
            reading = self._state.begin_reading(machine_time())
        if reading is not None:
            try:
                outcome = self._describe() if reading.describe else self._read(reading.names)
            except Exception as error:  # a thread has nobody to raise to, and the learner should see it
                outcome = functools.partial(self._state.reading_failed, error, machine_time())
            self._hand_over(outcome)
        elif self._state.is_unseen and not self._is_ready():
            self._hand_over(self._state.missed)
        with self._lock:
            return self._state.read_again_in(machine_time())

    def _describe(self) -> Callable[[], Todo]:
        """Ask the node which parameters it has now, of which kind, and for their values; return that as an event."""
        executor = self._require_executor()
        executor.services.greet(self.node, timeout_sec=self._timeout_sec)
        descriptors, present = self.client().describe_and_get(self.names)
        return functools.partial(self._state.described, list(descriptors), descriptors, present)

    def _read(self, names: list[str]) -> Callable[[], Todo]:
        """Ask the node for some values; return them as an event."""
        return functools.partial(self._state.have_read, self.client().get_parameters(names))

    def _show_step(self) -> float | None:
        if self._state.closed:
            return None
        self._hand_over(self._state.begin_showing, machine_time())
        self._show()
        return LATE_SEC if self._state.busy_names else None

    # -- waiting: the caller's thread -------------------------------------------------------------------

    def _give_way(self, parameter: LiveParameter) -> None:
        with self._lock:
            if parameter.busy:
                self._ended.wait(_GIVE_WAY_SEC)

    def _wait_for_answers(self, deadline: float, timeout_sec: float) -> None:
        while True:
            with self._lock:
                busy = self._state.busy_names
                if not busy:
                    return
                if machine_time() > deadline:
                    raise WaitTimeoutError(f'timed out after {timeout_sec:g} s waiting for {self.node} '
                                           f'to answer {", ".join(busy)}')
                self._ended.wait(max(0.0, min(LATE_SEC, deadline - machine_time())))
            self._hand_over(self._state.give_up_late, machine_time())

    def _require_other_thread(self) -> None:
        if self._executor is not None and self._executor.services.in_executor_thread():
            raise ExecutorError('a callback cannot wait for a panel: the answers would have to come through the '
                                'executor that the callback keeps busy')

    # -- the executor -----------------------------------------------------------------------------------

    def _reason(self, error: Exception) -> Exception:
        """Return why nothing could be sent. Asked only now: it would take as long as all else before each request."""
        try:
            self._require_executor()
        except ExecutorError as stopped:
            return stopped
        return error

    def _require_executor(self) -> BackgroundExecutor:
        executor = self._executor or stage.current()
        if not executor.is_running:
            raise ExecutorError('the executor is stopped: call param_tutorial.start() first')
        return executor

    def _is_ready(self) -> bool:
        """True if the node's services are there now."""
        with contextlib.suppress(NodeNotFoundError):  # no node can have such a name
            return self._executor is not None and self._executor.services.is_ready(self.node, 'list_parameters')
        return False

    def _is_reachable(self) -> bool:
        """True if the node would answer now, as far as can be known without asking it."""
        executor = self._executor
        return executor is not None and executor.is_running and (
            not self.status or self._is_ready()
            or any(each.get_fully_qualified_name() == self.node for each in executor.nodes))
