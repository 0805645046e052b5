"""The parameters of one node, followed live: what the node confirmed, and what it is being asked. No Jupyter.

What is known, and what follows from what happens, is a state machine: ``live_state``. Here is what drives it. Each
thing that happens is handed to the machine with the lock held, and what the machine returns is done after the lock has
been released. So the lock is never held while sending, waiting or drawing.

``LiveParameters.ask`` may be called in any thread; it sends at once and never waits. All else happens in the executor's
thread: answers, events, the coming and going of nodes, and reading, which is a coroutine there. Showing takes time, so
it is a job of ``schedule``, or of ``settle`` in the caller's thread.
"""

import contextlib
import functools
import threading
import time
from collections.abc import Awaitable, Callable, Iterable
from typing import Any, ParamSpec

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import SetParameters
from rclpy.task import Future

from param_tools import values
from param_tools.errors import ExecutorError, NodeNotFoundError, WaitTimeoutError, describe_error
from param_tools.node.client import Questions, to_message
from param_tools.node.live_state import LATE_SEC, Change, LiveState, ParameterState, Reading, Request, Todo
from param_tools.ros import stage, waiting
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.schedule import Job
from param_tools.ros.services import TIMEOUT_SEC, full_name

# Thirty times a second is as often as anybody can see.
_SHOW_PERIOD_SEC = 1 / 30
FIRST_LOOK_TIMEOUT_SEC = 10.0

P = ParamSpec('P')


class LiveParameters:
    """Follows the parameters of one node through changes, restarts and absence, from ``first_look`` to ``close``."""

    def __init__(self, node: str, show: Callable[[], None], *, names: Iterable[str] | None = None,
                 timeout_sec: float = TIMEOUT_SEC, showing: 'threading.RLock | None' = None):
        """
        :param node: Name of the node.
        :param show: Called after anything changed, in the thread of ``schedule`` or in that of ``settle``, never twice
            at once.
        :param names: Only these parameters, in this order; by default all, in the node's order.
        :param showing: Is held while ``show`` is called; by default a lock of its own.
        """
        self.node = full_name(node)
        self.names = None if names is None else list(names)
        self._show = show
        self._timeout_sec = timeout_sec
        self._executor: BackgroundExecutor | None = None
        self._lock = threading.RLock()
        self._state = LiveState(self.node, timeout_sec)
        self._stop_listening: list[Callable[[], None]] = []
        self._reading_in: BackgroundExecutor | None = None
        self._read_job = Job(self._wake_reader, _SHOW_PERIOD_SEC)
        self._show_job = Job(self._show_step, _SHOW_PERIOD_SEC, showing)
        self._stop_following: Callable[[], None] = lambda: None

    @property
    def parameters(self) -> dict[str, ParameterState]:
        """The parameters that the node has, as far as is known. Their attributes may be read in any thread."""
        return self._state.parameters

    @property
    def status(self) -> str:
        """Why the parameters cannot be changed now; empty if they can."""
        return self._state.status

    @property
    def is_busy(self) -> bool:
        """True while something that was asked for is unanswered, or what the node has stored is not yet read."""
        with self._lock:
            return self._state.has_unread_answers

    def first_look(self, timeout_sec: float = FIRST_LOOK_TIMEOUT_SEC) -> None:
        """Begin to follow: read everything from the node and show it. Waits for a node that is just starting.

        If that fails, or Ctrl+C ends it, the node is not followed: the view that it was for has left its constructor.

        :param timeout_sec: How long to wait for each of the two; 0 to go on at once, and show what comes.
        :raises ExecutorError: called in a callback, where waiting would block the executor forever.
        """
        try:
            self._stop_following = stage.on_change(lambda: self._hand_over(self._listen))
            with self._lock:
                self._listen()  # what remains to be done is done below
            self._wake_reader()
            if not timeout_sec:
                self._show_job.wake()
                return
            self._require_other_thread()
            self._wait(lambda: not self._is_reading, waiting.deadline(timeout_sec))
            self._show_job.call_now(timeout_sec)
        except BaseException:
            self.close()
            raise

    def settle(self, timeout_sec: float) -> None:
        """Wait until all that was asked so far is answered, then read everything from the node and show it.

        :raises WaitTimeoutError: it took too long.
        :raises ExecutorError: called in a callback, where waiting would block the executor forever.
        """
        end = waiting.deadline(timeout_sec)
        self._require_other_thread()
        # Before everything is asked for: it would be asked for while the answers are still coming.
        self._wait_for_answers(end, timeout_sec)
        if self._is_reachable():
            self._hand_over(self._state.refresh)
            self._wake_reader()
        while not self._state.closed:
            self._wait_for_answers(end, timeout_sec)
            self._show_job.call_now(end - time.monotonic())
            with self._lock:
                if self._state.is_settled:
                    return
            if time.monotonic() > end:
                raise WaitTimeoutError(f'timed out after {timeout_sec:g} s reading the parameters of {self.node}')

    def close(self) -> None:
        """Stop following. Safe to call more than once."""
        self._hand_over(self._close)
        self._read_job.end()
        self._show_job.end()

    def _hand_over(self, event: Callable[P, Todo], *args: P.args, **kwargs: P.kwargs) -> None:
        """Hand an event to the state machine with the lock held; then, without it, do what is to be done."""
        with self._lock:
            todo = event(*args, **kwargs)
        if todo.send is not None:
            self._send(todo.send)
        if todo.read:
            self._wake_reader()
        if todo.show:
            self._show_job.wake()
        if todo.watch:
            self._show_job.wake(LATE_SEC)

    def _close(self) -> Todo:
        self._stop_following()
        self._stop_all_listening()
        return self._state.close()

    # -- asking: any thread -----------------------------------------------------------------------------

    def ask(self, parameter: ParameterState, value: Any) -> None:
        """Ask the node for a (normalized) value. Does not wait and never raises: see the parameter's ``message``."""
        self._hand_over(self._state.ask, parameter, value, time.monotonic())

    def reject(self, parameter: ParameterState, reason: str) -> None:
        """Reject what the user entered, without asking the node."""
        self._hand_over(self._state.reject, parameter, reason)

    def _send(self, request: Request) -> None:
        try:
            executor = self._executor or stage.current()
            message = to_message(request.parameter.name, request.value, request.parameter.descriptor.type)
            executor.services.call_async(
                self.node, 'set_parameters', SetParameters.Request(parameters=[message]),
                timeout_sec=self._timeout_sec).add_done_callback(functools.partial(self._on_answer, request))
        except Exception as error:  # whatever it is: it must become visible, and this may be any thread
            self._hand_over(self._state.send_failed, request, self._reason(error), time.monotonic())

    # -- what happens: the executor's thread, or the one that starts or stops it --------------------------

    def _on_answer(self, request: Request, future: Future) -> None:
        try:
            result = future.result().results[0]
        except Exception as error:
            failed = self._state.send_failed if isinstance(error, NodeNotFoundError) else self._state.answer_failed
            self._hand_over(failed, request, error, time.monotonic())
        else:
            reason = '' if result.successful else result.reason or 'The node gave no reason.'
            self._hand_over(self._state.answered, request, reason, time.monotonic())

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

    def _listen(self) -> Todo:
        """Listen to the executor that runs in the background from now on, if there is one; with the lock held."""
        self._stop_all_listening()
        try:
            self._executor = stage.current()
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

    # -- reading: the executor's thread -----------------------------------------------------------------

    def _wake_reader(self) -> None:
        """Begin to read what the state machine wants, unless that is going on."""
        with self._lock:
            executor = self._executor
            if self._state.closed or executor is None or self._reading_in is executor:
                return
            self._reading_in = executor
        try:
            executor.create_task(self._read(executor))
        except ExecutorError as error:
            self._reading_in = None
            self._hand_over(self._state.executor_lost, describe_error(error))

    async def _read(self, executor: BackgroundExecutor) -> None:
        """Ask the node for whatever the state machine wants, until it wants nothing more."""
        async def call(service: str, request: Any) -> Any:
            return await executor.services.call_async(self.node, service, request, timeout_sec=self._timeout_sec)

        while True:
            with self._lock:
                reading = self._state.begin_reading(time.monotonic()) if executor is self._executor else None
                if reading is None:
                    if self._reading_in is executor:
                        self._reading_in = None
                    break
            try:
                outcome = await self._outcome(reading, call)
            except Exception as error:  # nobody is there to raise to, and the learner should see it
                outcome = functools.partial(self._state.reading_failed, error, time.monotonic())
            if executor is self._executor:
                self._hand_over(outcome)
        if self._state.is_unseen and not self._is_ready():
            self._hand_over(self._state.missed)
        with self._lock:
            again_sec = self._state.read_again_in(time.monotonic())
        if again_sec is not None:
            self._read_job.wake(again_sec)

    async def _outcome(self, reading: Reading, call: Callable[[str, Any], Awaitable[Any]]) -> Callable[[], Todo]:
        """Ask the node what a reading is about, and return the answer as an event."""
        questions = Questions(self.node, call)
        if reading.describe:
            await call('set_parameters', SetParameters.Request())  # so that the first set can be sent at once
            descriptors, present = await questions.describe_and_get(self.names)
            return functools.partial(self._state.described, list(descriptors), descriptors, present)
        return functools.partial(self._state.have_read, await questions.get_parameters(reading.names))

    # -- showing: the thread of the schedule, or that of settle -------------------------------------------

    def _show_step(self) -> float | None:
        if self._state.closed:
            return None
        self._hand_over(self._state.begin_showing, time.monotonic())
        self._show()
        if self._state.busy_names and self._executor is not None:
            self._executor.free()
        return LATE_SEC if self._state.busy_names else None

    # -- waiting: the caller's thread -------------------------------------------------------------------

    @property
    def _is_reading(self) -> bool:
        return self._reading_in is not None and self._reading_in is self._executor and self._reading_in.is_running

    def _wait_for_answers(self, end: float, timeout_sec: float) -> None:
        """Wait until no value is asked for any more, and what the node has stored is read."""
        self._wait(lambda: not (self._state.busy_names or self._is_reading), end)
        if busy := self._state.busy_names:
            raise WaitTimeoutError(f'timed out after {timeout_sec:g} s waiting for {self.node} '
                                   f'to answer {", ".join(busy)}')

    def _wait(self, condition: Callable[[], object], end: float) -> None:
        def is_over() -> object:
            self._hand_over(self._state.give_up_late, time.monotonic())
            return self._state.closed or condition()

        waiting.wait_before(end, is_over)

    def _require_other_thread(self) -> None:
        if self._executor is not None and self._executor.in_thread():
            raise ExecutorError('a callback cannot wait for a panel: the answers would have to come through the '
                                'executor that the callback keeps busy')

    # -- the executor -----------------------------------------------------------------------------------

    def _reason(self, error: Exception) -> Exception:
        """Return why nothing could be sent. Asked only now: it would take as long as all else before each request."""
        try:
            executor = self._executor or stage.current()
        except ExecutorError as none_is_running:
            return none_is_running
        return error if executor.is_running else ExecutorError('the executor is stopped: call start() first')

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
