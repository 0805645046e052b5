"""The parameters of one node, followed live: what the node confirmed, and what it is being asked. No Jupyter.

The rules that everything here serves:

- The truth is read from the node. A message on /parameter_events, or the answer to a set, says that something
  changed; what it changed to is asked. Events and answers travel apart and may overtake each other, so a value
  that an event carries may be older than the one on screen.
- For each parameter at most one request is under way. What is wanted meanwhile waits, the newest replacing
  older ones, and is sent as soon as the answer is there. So a fast hand cannot flood the node, and the last
  value always arrives.
- While a parameter is *busy* (asked and not yet answered) what is read about it is not believed.

Threads. ``LiveParameter.ask`` may be called in any; it sends at once and never waits. Answers, events and the
coming and going of nodes arrive in the executor's thread, which takes notes and nothing more. Whatever waits
for the node (``_read_step``) or takes time (``_show_step``) is done by worker threads of their own, so that a node
that hangs does not keep the panel from saying so; or by ``settle`` in the caller's. One lock guards all the notes;
it is never held while sending, waiting or drawing.
"""

import functools
import threading
import time
from collections.abc import Callable, Iterable
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import SetParameters

from param_tutorial.errors import (
    ExecutorError,
    NoAnswerError,
    NodeGoneError,
    NodeNotFoundError,
    ParameterNotDeclaredError,
    ParameterToolError,
    WaitTimeoutError,
)
from param_tutorial.parameters import values
from param_tutorial.parameters.client import Descriptor, ParameterClient, to_message
from param_tutorial.runtime import stage
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import TIMEOUT_SEC, full_name
from param_tutorial.runtime.worker import Worker

# Thirty times a second is as often as anybody can see.
_SHOW_PERIOD_SEC = 1 / 30
_READ_PERIOD_SEC = 1 / 60
_LATE_SEC = 0.25
_RETRY_PERIOD_SEC = 1.0
_GIVE_WAY_SEC = 0.002
# The executor fails late requests itself; a request that is even later than this shows that it cannot.
_GRACE_SEC = 1.5
_FIRST_LOOK_TIMEOUT_SEC = 10.0

_NOTHING = object()


class LiveParameter:
    """One parameter of a node. Its attributes may be read in any thread."""

    def __init__(self, live: 'LiveParameters', descriptor: Descriptor, value: Any):
        self._live = live
        self.descriptor = descriptor
        self.value = value
        """What the node confirmed last; None if it is declared without a value."""
        self.message = ''
        """Why the last value that was asked for did not become the parameter's; empty if it did."""
        self.asked_at = 0.0
        self.answered_at = 0.0
        """When the node's last answer came, on the clock of time.monotonic."""
        self._asked: Any = _NOTHING
        self._wanted: Any = _NOTHING
        self._turn = 0

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self.descriptor.name

    @property
    def busy(self) -> bool:
        """Has the node been asked for another value, and not answered yet?"""
        return self._asked is not _NOTHING

    @property
    def late(self) -> bool:
        """Is the node taking so long that one should say so?"""
        return self.busy and time.monotonic() - self.asked_at > _LATE_SEC

    def ask(self, value: Any) -> None:
        """Ask the node for a value; it must be normalized. Does not wait, never raises: see ``message``."""
        self._live._ask(self, value)

    def give_way(self) -> None:
        """Leave the processor to the node for the moment that its answer takes if it lives in this process."""
        with self._live._lock:
            self._live._answered.wait_for(lambda: not self.busy, _GIVE_WAY_SEC)

    def refuse(self, reason: str) -> None:
        """Turn down what was wanted before the node was asked."""
        self._live._refuse(self, reason)


class LiveParameters:
    """Follows the parameters of one node through changes, restarts and absence, until it is closed."""

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
        self.parameters: dict[str, LiveParameter] = {}
        self.status = ''
        """Why the parameters cannot be changed now; empty if they can."""
        self.closed = False
        self._show = show
        self._chosen_executor = executor
        self._timeout_sec = timeout_sec
        self._executor: BackgroundExecutor | None = None
        self._incarnations: frozenset[bytes] = frozenset()
        self._lock = threading.RLock()
        self._answered = threading.Condition(self._lock)
        self._must_describe = True
        self._must_read: set[str] = set()
        self._must_show = True
        self._retry_at: float | None = None
        self._stop_listening: list[Callable[[], None]] = []
        self._reader = Worker(self._read_step, f'panel of {self.node}: read', _READ_PERIOD_SEC)
        self._shower = Worker(self._show_step, f'panel of {self.node}: show', _SHOW_PERIOD_SEC)
        self._stop_following = stage.on_change(self._on_executor_change)
        with self._lock:
            self._listen()

    @property
    def is_running(self) -> bool:
        """Is the node there, as far as is known?"""
        return not self.status

    def first_look(self) -> None:
        """Read everything from the node and show it; waits for a node that is just starting."""
        self._require_other_thread()
        self._reader.call_now(_FIRST_LOOK_TIMEOUT_SEC)
        self._shower.call_now(_FIRST_LOOK_TIMEOUT_SEC)

    def settle(self, timeout_sec: float) -> None:
        """Wait until all that was asked so far is answered, then read everything from the node and show it.

        :raises WaitTimeoutError: it took too long.
        :raises ExecutorError: called in a callback, where waiting would block the executor for ever.
        """
        deadline = time.monotonic() + timeout_sec
        self._require_other_thread()
        with self._lock:
            self._must_describe |= self._worth_describing()
        while not self.closed:
            with self._lock:
                while busy := [each.name for each in self.parameters.values() if each.busy]:
                    if not self._answered.wait(max(0.0, min(_LATE_SEC, deadline - time.monotonic()))):
                        self._give_up_late()
                        if time.monotonic() > deadline:
                            raise WaitTimeoutError(f'waited {timeout_sec:g} s for {self.node} to answer '
                                                   f'{", ".join(busy)}, in vain')
            done_in_time = (self._reader.call_now(deadline - time.monotonic())
                            and self._shower.call_now(deadline - time.monotonic()))
            with self._lock:
                if not (self._must_describe or self._must_read or self._must_show
                        or any(each.busy for each in self.parameters.values())):
                    return
            if not done_in_time or time.monotonic() > deadline:
                raise WaitTimeoutError(f'waited {timeout_sec:g} s to read the parameters of {self.node}, in vain')

    def close(self) -> None:
        """Stop following. Twice is as good as once."""
        with self._lock:
            self.closed = True
            self._stop_following()
            self._stop_all_listening()
            self._forget_requests('')
        self._reader.end()
        self._shower.end()

    def _require_other_thread(self) -> None:
        if self._executor is not None and self._executor.services.in_executor_thread():
            raise ExecutorError('a callback cannot wait for a panel: the answers would have to come through the '
                                'executor that the callback keeps busy')

    # -- asking: any thread -----------------------------------------------------------------------------

    def _ask(self, parameter: LiveParameter, value: Any) -> None:
        with self._lock:
            if parameter.busy:
                parameter._wanted = value
                return
            parameter._asked = value
            parameter._turn += 1
        self._send(parameter, value, parameter._turn)
        self._shower.stay()

    def _refuse(self, parameter: LiveParameter, reason: str) -> None:
        with self._lock:
            parameter._wanted = _NOTHING
            if not parameter.busy:
                parameter.message = reason
        self._show_soon()

    def _send(self, parameter: LiveParameter, value: Any, turn: int) -> None:
        parameter.asked_at = time.monotonic()
        try:
            message = to_message(parameter.name, value, parameter.descriptor.type)
            future = self._require_executor().services.call_async(
                self.node, 'set_parameters', SetParameters.Request(parameters=[message]),
                timeout_sec=self._timeout_sec)
        except Exception as error:  # whatever it is: it must become visible, and this may be any thread
            if isinstance(error, NodeNotFoundError) and not self.status:
                with self._lock:
                    self._must_describe = True  # which tells whether it is really gone
                self._reader.wake()
            self._take_answer(parameter, turn, words_of(error), believable=False)
            return
        future.add_done_callback(functools.partial(self._on_answer, parameter, turn))

    # -- notes: the executor's thread -------------------------------------------------------------------

    def _on_answer(self, parameter: LiveParameter, turn: int, future: Any) -> None:
        try:
            result = future.result().results[0]
        except Exception as error:
            # After an exception in a callback the node may have stored the value or not; it can be asked.
            gone = isinstance(error, (NoAnswerError, NodeGoneError))
            self._take_answer(parameter, turn, words_of(error), believable=not gone)
        else:
            reason = '' if result.successful else result.reason or 'The node gave no reason.'
            self._take_answer(parameter, turn, reason, believable=True)

    def _take_answer(self, parameter: LiveParameter, turn: int, reason: str, *, believable: bool) -> None:
        with self._lock:
            if parameter._turn != turn or not parameter.busy:
                return  # given up before it came
            parameter.answered_at = time.monotonic()
            if not reason:
                parameter.value = parameter._asked
            wanted, parameter._wanted = parameter._wanted, _NOTHING
            parameter._asked = wanted
            if wanted is _NOTHING:
                parameter.message = reason
                if believable:
                    self._must_read.add(parameter.name)
                self._must_show = True
                self._answered.notify_all()
            else:
                parameter._turn += 1
                turn = parameter._turn
        if wanted is not _NOTHING:
            self._send(parameter, wanted, turn)
        elif believable:
            self._reader.wake()  # and then it is shown, once and right
        else:
            self._shower.wake()

    def _on_event(self, event: ParameterEvent) -> None:
        if event.node != self.node:
            return
        with self._lock:
            if event.new_parameters or event.deleted_parameters:
                self._must_describe = True
            for each in event.changed_parameters:
                parameter = self.parameters.get(each.name)
                if parameter is None:
                    continue
                if each.value.type != parameter.descriptor.type.number:
                    self._must_describe = True
                elif not parameter.busy and not values.same(values.to_python(each.value), parameter.value):
                    self._must_read.add(each.name)
            if not (self._must_describe or self._must_read):
                return
        self._reader.wake()

    def _on_graph_change(self) -> None:
        with self._lock:
            if self._executor is None:
                return
            incarnations = self._executor.node_incarnations(self.node)
            if incarnations == self._incarnations:
                # A node may have no publisher of events; then only its services tell whether it is there.
                if not (self.status and self._executor.services.is_ready(self.node, 'list_parameters')):
                    return
                self._must_describe = True
            else:
                # News of a node may come later than its first answers; that is not a restart.
                restarted = bool(self._incarnations)
                self._incarnations = incarnations
                self._must_describe = bool(incarnations)
                if not incarnations:
                    self._lose(self._absence)
                elif restarted:
                    for parameter in self.parameters.values():
                        parameter.message = ''
        self._wake_both()

    # -- the executor: the thread that starts or stops it -----------------------------------------------

    def _on_executor_change(self) -> None:
        with self._lock:
            if self.closed or self._chosen_executor is not None:
                return
            self._listen()
        self._wake_both()

    def _listen(self) -> None:
        self._stop_all_listening()
        self._incarnations = frozenset()
        try:
            self._executor = self._chosen_executor or stage.current()
        except ExecutorError as error:
            self._executor = None
            self._must_describe = False
            self._lose(words_of(error))
            return
        self._stop_listening = [self._executor.on_parameter_event(self._on_event),
                                self._executor.on_graph_change(self._on_graph_change)]
        self._incarnations = self._executor.node_incarnations(self.node)
        self._must_describe = True

    def _stop_all_listening(self) -> None:
        for stop in self._stop_listening:
            stop()
        self._stop_listening = []

    def _require_executor(self) -> BackgroundExecutor:
        executor = self._executor or stage.current()
        if not executor.is_running:
            raise ExecutorError('the executor is stopped: call param_tutorial.start() first')
        return executor

    # -- reading and showing: the workers' threads, or that of settle() -----------------------------------

    def _read_step(self) -> bool:
        with self._lock:
            if self.closed:
                return False
            if self._retry_at is not None and time.monotonic() >= self._retry_at:
                self._must_describe = True
            describe, self._must_describe = self._must_describe, False
            names = sorted(self._must_read & self.parameters.keys())
            self._must_read.clear()
            if not (describe or names):
                self._miss_the_unseen()
                return self._is_outstanding()
        try:
            if describe:
                self._describe()
            else:
                self._read(names)
        except Exception as error:  # a thread has nobody to raise to, and the learner should see it
            with self._lock:
                if not isinstance(error, (NodeNotFoundError, NodeGoneError)):
                    self.status = words_of(error)
                    self._retry_at = time.monotonic() + _RETRY_PERIOD_SEC
                elif self._incarnations or self.parameters:
                    self._lose(self._absence)  # and the graph will tell when it comes back
                else:
                    self._lose(words_of(error))
        self._show_soon()
        with self._lock:
            return self._is_outstanding()

    def _show_step(self) -> bool:
        with self._lock:
            if self.closed:
                return False
            self._give_up_late()
            self._must_show = False
        self._show()
        return any(each.busy for each in list(self.parameters.values()))

    def _describe(self) -> None:
        """Ask the node which parameters it has now, of which kind, and for their values."""
        executor = self._require_executor()
        with self._lock:
            self._retry_at = None
            incarnations = self._incarnations
        executor.services.greet(self.node, timeout_sec=self._timeout_sec)
        client = ParameterClient(self.node, executor=executor, timeout_sec=self._timeout_sec)
        for attempts_left in (3, 2, 1, 0):
            existing = client.list_parameters()
            names = existing if self.names is None else [name for name in self.names if name in existing]
            try:
                descriptors, present = client.describe_parameters(names), client.get_parameters(names)
                break
            except ParameterNotDeclaredError:  # deleted between two of these questions
                if not attempts_left:
                    raise
        with self._lock:
            old, self.parameters = self.parameters, {}
            for name in names:
                parameter = old.get(name)
                if parameter is None:
                    parameter = LiveParameter(self, descriptors[name], present[name])
                elif not parameter.busy and name not in self._must_read:
                    parameter.value = present[name]
                parameter.descriptor = descriptors[name]
                self.parameters[name] = parameter
            if self.status:
                self.status = ''
                for parameter in self.parameters.values():
                    parameter.message = ''
            if self._incarnations != incarnations:  # restarted while it was being asked
                self._must_describe = bool(self._incarnations)

    def _read(self, names: list[str]) -> None:
        client = ParameterClient(self.node, executor=self._require_executor(), timeout_sec=self._timeout_sec)
        try:
            present = client.get_parameters(names)
        except ParameterNotDeclaredError:
            with self._lock:
                self._must_describe = True
            self._reader.wake()
            return
        except (NodeNotFoundError, NodeGoneError):
            return  # the graph tells of this too, with better words
        with self._lock:
            for name in names:
                parameter = self.parameters[name]
                # Changed or asked for meanwhile: then this is history, and another reading will come.
                if not parameter.busy and name not in self._must_read:
                    parameter.value = present[name]

    # -- small steps, with the lock held ----------------------------------------------------------------

    def _worth_describing(self) -> bool:
        """Would asking the node now get an answer, as far as can be known without asking?"""
        executor = self._executor
        if self.closed or executor is None or not executor.is_running:
            return False
        return (not self.status or executor.services.is_ready(self.node, 'list_parameters')
                or any(each.get_fully_qualified_name() == self.node for each in executor.nodes))

    @property
    def _absence(self) -> str:
        return f'{self.node} is not running. Its controls come back when it does.'

    def _is_outstanding(self) -> bool:
        return self._retry_at is not None or self._is_unseen()

    def _is_unseen(self) -> bool:
        """Does it answer though the graph shows no publisher of events? Not yet, perhaps; or it has none."""
        return not (self.status or self._incarnations or self._executor is None)

    def _miss_the_unseen(self) -> None:
        if self._is_unseen() and not self._executor.services.is_ready(self.node, 'list_parameters'):
            self._lose(self._absence)
            self._shower.wake()

    def _lose(self, status: str) -> None:
        self.status = status
        self._retry_at = None
        self._forget_requests(status)
        self._must_show = True

    def _forget_requests(self, reason: str) -> None:
        for parameter in self.parameters.values():
            if parameter.busy:
                parameter._asked = parameter._wanted = _NOTHING
                parameter._turn += 1
                parameter.message = reason
        self._answered.notify_all()

    def _give_up_late(self) -> None:
        for parameter in self.parameters.values():
            if parameter.busy and time.monotonic() - parameter.asked_at > self._timeout_sec + _GRACE_SEC:
                parameter._asked = parameter._wanted = _NOTHING
                parameter._turn += 1
                parameter.message = words_of(NoAnswerError(self.node, 'set_parameters', self._timeout_sec))
                self._answered.notify_all()

    def _wake_both(self) -> None:
        self._reader.wake()
        self._shower.wake()

    def _show_soon(self) -> None:
        with self._lock:
            self._must_show = True
        self._shower.wake()


def words_of(error: BaseException) -> str:
    """Tell an error to a learner; one that is not ours keeps its class, since its text may be terse."""
    return str(error) if isinstance(error, ParameterToolError) else f'{type(error).__name__}: {error}'
