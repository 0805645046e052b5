"""What is known about the parameters of one node that is followed live, as a state machine.

It has no threads, no ROS and no clock: whatever happens is an event, a method of ``LiveState`` that takes the time as
an argument where time matters and returns what to do about it. ``live`` is the shell that calls these methods, one at
a time, and does what they return.

The rules that the machine keeps, whatever happens in whatever order:

- The truth is read from the node. A message on /parameter_events, or the answer to a set, says that something
  changed; what it changed to is asked. Events and answers travel separately and may overtake each other, so a value
  that an event carries may be older than the one on screen.
- For each parameter at most one request is under way. A value that is wanted meanwhile waits, the newest replacing
  older ones, and is sent when the answer arrives. So a fast slider cannot flood the node, and the last value always
  arrives.
- While a parameter is *busy* (requested and not yet answered), no reading of it is believed. It is read again when
  the request has ended.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from param_tools import values
from param_tools.descriptor import Descriptor
from param_tools.errors import (
    ExecutorError,
    NoAnswerError,
    NodeGoneError,
    NodeNotFoundError,
    ParameterNotDeclaredError,
    describe_error,
)
from param_tools.ros import domain
from param_tools.ros.waiting import PATIENCE

LATE_SEC = 0.25
RETRY_PERIOD_SEC = 1.0
# The executor fails late requests itself; a request that is even later than this shows that it cannot.
GRACE_SEC = 1.5
# How soon to look again whether a node that answers is still there, if the graph does not show it.
UNSEEN_PERIOD_SEC = 0.25


class ParameterState:
    """What is known about one parameter."""

    def __init__(self, descriptor: Descriptor, value: Any):
        self.descriptor = descriptor
        self.value = value
        """What the node confirmed last; None if it is declared without a value."""
        self.message = ''
        """Why the last value that was asked for did not become the parameter's; empty if it did."""
        self.unanswered: Any = ...
        """What was asked for last, if the node was not asked, or did not answer: it may do it late. Else ``...``."""
        self.asked_at = 0.0
        """On the clock of ``time.monotonic``."""
        self.request: Request | None = None
        """The request that is under way."""
        self.waiting: Request | None = None
        """The newest request that is to follow it."""
        self.accepted: Any = ...
        """What the node accepted last, until it has been read what it stored; ``...`` for nothing."""
        self.adjusted: Any = ...
        """What the node accepted last, if it then had another value; ``...`` if it did not."""

    @property
    def name(self) -> str:
        """The parameter's full name."""
        return self.descriptor.name

    @property
    def busy(self) -> bool:
        """True if the node has been asked for another value and has not answered yet."""
        return self.request is not None

    @property
    def is_unanswered(self) -> bool:
        """True if the message is that the node was not asked, or did not answer: it has rejected nothing."""
        return self.unanswered is not ...

    def is_late(self, now: float) -> bool:
        """True if the answer takes so long that a person should be told."""
        return self.busy and now - self.asked_at > LATE_SEC


@dataclass(eq=False, slots=True)
class Request:
    """One value that the node is asked for. Two requests are never the same one, even for the same value."""

    parameter: ParameterState
    value: Any


class Change(NamedTuple):
    """One changed parameter in a message on /parameter_events."""

    name: str
    type_number: int
    value: Any


@dataclass(frozen=True)
class Reading:
    """Something to ask the node for: everything, or the values of some parameters."""

    describe: bool
    names: list[str]
    """Which values to get, unless it is everything."""
    incarnations: frozenset[bytes] | None
    """Which nodes of the name the graph showed when the reading began."""


class Todo(NamedTuple):
    """What an event leaves to be done."""

    send: Request | None = None
    """Send this to the node; then report ``answered``, ``answer_failed`` or ``send_failed``."""
    read: bool = False
    """Call ``begin_reading`` soon, and do what it returns."""
    show: bool = False
    """Call ``begin_showing`` soon, and show the parameters."""
    watch: bool = False
    """Go on calling ``begin_showing`` now and then, to see what becomes late."""


NOTHING = Todo()


class LiveState:
    """The parameters of one node, as far as they are known. Each public method is an event, or looks at the state."""

    def __init__(self, node: str, timeout_sec: float):
        """
        :param node: Fully qualified name.
        :param timeout_sec: How long the node may take for each answer.
        """
        self.parameters: dict[str, ParameterState] = {}
        """Replaced as a whole and never changed, so that any thread may iterate over it."""
        self.status = ''
        """Why the parameters cannot be changed now; empty if they can."""
        self.closed = False
        self._is_silent = False
        """True if the status is that the node does not answer."""
        self._node = node
        self._timeout_sec = timeout_sec
        self._incarnations: frozenset[bytes] | None = None
        """Which nodes of the name the graph shows; None as long as there is no executor."""
        self._must_describe = False
        self._must_read: set[str] = set()
        self._must_show = True
        self._retry_at: float | None = None
        self._reading: Reading | None = None
        """What is being asked at the moment; events that come meanwhile may be newer than its answer."""

    # -- looking ----------------------------------------------------------------------------------------

    @property
    def busy_names(self) -> list[str]:
        """The parameters with a request under way."""
        return [name for name, parameter in self.parameters.items() if parameter.busy]

    @property
    def has_unread_answers(self) -> bool:
        """True while a request is under way, or what the node has stored has not been read."""
        return bool(self.busy_names or self._must_read or self._reading)

    @property
    def is_settled(self) -> bool:
        """True if nothing remains to be answered, read or shown."""
        return not (self._must_describe or self._must_read or self._must_show or self.busy_names)

    @property
    def is_unseen(self) -> bool:
        """True if the node answers although the graph shows no publisher of events: not yet, or it has none."""
        return not self.status and self._incarnations == frozenset()

    def read_again_in(self, now: float) -> float | None:
        """Return in how many seconds to call ``begin_reading`` again even if nothing happens; None for never."""
        if self.closed:
            return None
        if self._retry_at is not None:
            return max(0.0, self._retry_at - now)
        return UNSEEN_PERIOD_SEC if self.is_unseen else None

    # -- events: what the user does ---------------------------------------------------------------------

    def ask(self, parameter: ParameterState, value: Any, now: float) -> Todo:
        """The user asks for a value."""
        request = Request(parameter, value)
        if parameter.busy:
            parameter.waiting = request
            return NOTHING
        return self._begin(request, now)

    def reject(self, parameter: ParameterState, reason: str) -> Todo:
        """The user entered something that is no value, so the node is not asked."""
        parameter.waiting = None
        if not parameter.busy:
            parameter.message, parameter.unanswered = reason, ...
        self._must_show = True
        return Todo(show=True)

    def refresh(self) -> Todo:
        """Somebody wants everything to be read again, and will see to it."""
        self._must_describe = True
        return NOTHING

    def close(self) -> Todo:
        """Nobody is interested any more."""
        self.closed = True
        self._end_all('')
        return NOTHING

    # -- events: what becomes of a request --------------------------------------------------------------

    def answered(self, request: Request, reason: str, now: float) -> Todo:
        """The node accepted a value, or rejected it for a reason."""
        return self._end(request, reason, now, doubtful=True)

    def answer_failed(self, request: Request, error: Exception, now: float) -> Todo:
        """An error arrived in place of the answer."""
        # After an exception in a callback the node may have stored the value or not; it can be asked.
        gone = isinstance(error, (NoAnswerError, NodeGoneError))
        is_new = request.parameter.request is request  # and was not given up before
        todo = self._end(request, describe_error(error), now, doubtful=not gone)
        if is_new and isinstance(error, NoAnswerError) and not self.status:
            self._fall_silent(error, now)
            return todo._replace(read=True, show=True)
        return todo

    def send_failed(self, request: Request, error: Exception, now: float) -> Todo:
        """The request could not be sent."""
        if isinstance(error, NodeNotFoundError) and not self.status:
            self._must_describe = True  # which finds out whether it is really gone
        return self._end(request, describe_error(error), now, doubtful=False)

    # -- events: what the node and the graph report -----------------------------------------------------

    def changed(self, changes: Iterable[Change], *, others: bool) -> Todo:
        """The node published changes on /parameter_events.

        :param others: True if parameters were also declared or deleted.
        """
        self._must_describe |= others
        read = others
        for change in changes:
            parameter = self.parameters.get(change.name)
            if parameter is None:
                if self._reading is not None and self._reading.describe:
                    self._must_read.add(change.name)  # it may be about to become known, with an older value
            elif change.type_number != parameter.descriptor.type.number:
                self._must_describe = read = True
            elif parameter.busy:
                self._must_read.add(change.name)
            elif self._reading is not None or not values.same(change.value, parameter.value):
                self._must_read.add(change.name)
                read = True
        return Todo(read=read)

    def graph_changed(self, incarnations: frozenset[bytes], *, is_ready: bool) -> Todo:
        """Nodes came or went.

        :param incarnations: The identities of the nodes that have the name now.
        :param is_ready: True if the node's services are there: it may have no publisher of events.
        """
        if self._incarnations is None:
            return NOTHING
        if incarnations == self._incarnations:
            if not (self.status and is_ready):
                return NOTHING
            self._must_describe = True
            return Todo(read=True)
        # News of a node may come later than its first answers; that is not a restart.
        restarted = bool(self._incarnations)
        self._incarnations = incarnations
        self._must_describe = bool(incarnations)
        if not incarnations:
            return self._lose(self._absence)
        if restarted:
            self._clear_messages()
        return Todo(read=True, show=True)

    def executor_found(self, incarnations: frozenset[bytes]) -> Todo:
        """There is an executor that can carry requests, or another one than before."""
        self._incarnations = incarnations
        self._must_describe = True
        return Todo(read=True)

    def executor_lost(self, reason: str) -> Todo:
        """There is no executor any more."""
        self._incarnations = None
        self._must_describe = False
        return self._lose(reason)

    def missed(self) -> Todo:
        """The services of a node that the graph does not show are gone."""
        return self._lose(self._absence) if self.is_unseen else NOTHING

    # -- events: reading --------------------------------------------------------------------------------

    def begin_reading(self, now: float) -> Reading | None:
        """Return what to ask the node for, if anything; then report ``described``, ``have_read`` or ``reading_failed``.

        One reading ends before the next begins.
        """
        if self.closed:
            return None
        if self._retry_at is not None and now >= self._retry_at:
            self._must_describe = True
        describe, self._must_describe = self._must_describe, False
        # A busy parameter is read when its request has ended, so that the reading can be believed.
        busy = {name for name in self._must_read if self._is_busy(name)}
        names = sorted((self._must_read & self.parameters.keys()) - busy)
        self._must_read = busy
        if describe:
            self._retry_at = None
        elif not names:
            return None
        self._reading = Reading(describe, names, self._incarnations)
        return self._reading

    def described(self, names: Sequence[str], descriptors: Mapping[str, Descriptor],
                  present: Mapping[str, Any]) -> Todo:
        """The node said which parameters it has, of which kind, and their values."""
        reading = self._end_reading()
        if self._incarnations is None or (reading.incarnations and not self._incarnations):
            return NOTHING  # gone meanwhile, and the status says so
        old, parameters = self.parameters, {}
        for name in names:
            parameter = old.get(name)
            if parameter is None:
                parameter = ParameterState(descriptors[name], present[name])
            else:
                parameter.descriptor = descriptors[name]
                self._believe(parameter, present[name])
            parameters[name] = parameter
        self.parameters = parameters
        self._must_read &= parameters.keys()
        if self.status:
            self.status = ''
            if not self._is_silent:  # then it is still the same node, and what it did not answer should be known
                self._clear_messages()
        return self._have_news()

    def have_read(self, present: Mapping[str, Any]) -> Todo:
        """The node said which values some parameters have."""
        self._end_reading()
        for name, value in present.items():
            self._believe(self.parameters[name], value)
        return self._have_news()

    def reading_failed(self, error: Exception, now: float) -> Todo:
        """The node could not be asked, or did not answer."""
        reading = self._end_reading()
        if self._incarnations is None:
            return NOTHING  # and the status says so
        if isinstance(error, (NodeNotFoundError, NodeGoneError)):
            if not reading.describe:
                self._must_describe |= not self.status  # which finds out whether it is really gone
                return self._have_news()
            todo = self._lose(self._absence if self._incarnations or self.parameters else describe_error(error))
            if self._incarnations:  # the graph will report that it is gone, or it is not
                self._retry_at = now + RETRY_PERIOD_SEC
            return todo
        if isinstance(error, ParameterNotDeclaredError) and not reading.describe:
            self._must_describe = True
        elif isinstance(error, ExecutorError):
            return self._lose(describe_error(error))
        else:
            self._fall_silent(error, now + RETRY_PERIOD_SEC)
        return self._have_news()

    # -- events: showing, and the passing of time -------------------------------------------------------

    def begin_showing(self, now: float) -> Todo:
        """The parameters are about to be shown as they are now."""
        todo = self.give_up_late(now)
        self._must_show = False
        return todo._replace(show=False)

    def give_up_late(self, now: float) -> Todo:
        """Time has passed: end the requests that even the executor has not ended."""
        late = [parameter for parameter in self.parameters.values()
                if parameter.busy and now - parameter.asked_at > (self._timeout_sec + GRACE_SEC) * PATIENCE]
        for parameter in late:
            self._give_up(parameter, describe_error(NoAnswerError(
                self._node, 'set_parameters', self._timeout_sec, on_network=domain.reaches_other_hosts())))
        return self._have_news() if late else NOTHING

    # -- small steps ------------------------------------------------------------------------------------

    @property
    def _absence(self) -> str:
        network = ', or the network to its machine is down' if domain.reaches_other_hosts() else ''
        return f'{self._node} is not running{network}. Its controls come back when it does.'

    @property
    def _has_to_read(self) -> bool:
        """True if ``begin_reading`` would find something to ask the node for."""
        return self._must_describe or any(not self._is_busy(name) for name in self._must_read)

    def _is_busy(self, name: str) -> bool:
        return name in self.parameters and self.parameters[name].busy

    def _begin(self, request: Request, now: float) -> Todo:
        request.parameter.request = request
        request.parameter.asked_at = now
        request.parameter.accepted = request.parameter.adjusted = ...
        return Todo(send=request, watch=True)

    def _end(self, request: Request, reason: str, now: float, *, doubtful: bool) -> Todo:
        """End a request and begin the one that waits, if any.

        :param reason: Why the value did not become the parameter's; empty if it did.
        :param doubtful: True if what the node has now should be read.
        """
        parameter = request.parameter
        if parameter.request is not request:
            return NOTHING  # given up before the answer came
        if not reason:
            parameter.value = request.value
            parameter.accepted = request.value
        following, parameter.request, parameter.waiting = parameter.waiting, None, None
        if following is not None:
            return self._begin(following, now)._replace(read=self._must_describe)
        parameter.message, parameter.unanswered = reason, request.value if reason and not doubtful else ...
        if doubtful and self.parameters.get(parameter.name) is parameter:  # and not deleted meanwhile
            self._must_read.add(parameter.name)
        self._must_show = True
        read = self._has_to_read
        return Todo(read=read, show=not read)  # if it is read, it is shown after that, once and right

    def _end_all(self, reason: str) -> None:
        for parameter in self.parameters.values():
            if parameter.busy:
                self._give_up(parameter, reason)

    def _give_up(self, parameter: ParameterState, reason: str) -> None:
        newest = parameter.waiting or parameter.request
        assert newest is not None, 'nothing has been asked for'
        parameter.request = parameter.waiting = None
        parameter.message, parameter.unanswered = reason, newest.value

    def _fall_silent(self, error: Exception, ask_again_at: float) -> None:
        """Take note that the node is there and does not answer; everything is read when it does."""
        if not self.status:  # a node that was lost and has no answer yet is another one
            self._is_silent = True
        self.status = describe_error(error)
        self._retry_at = ask_again_at

    def _lose(self, status: str) -> Todo:
        """Take note that the node cannot be reached; everything is read again when it can."""
        self.status = status
        self._is_silent = False
        self._retry_at = None
        self._must_read.clear()
        self._end_all(status)
        self._must_show = True
        return Todo(read=self._must_describe, show=True)

    def _end_reading(self) -> Reading:
        reading, self._reading = self._reading, None
        assert reading is not None, 'no reading has begun'
        return reading

    def _believe(self, parameter: ParameterState, value: Any) -> None:
        """Take over a value that was read, unless it may be history; then it is read again later."""
        if parameter.busy:
            self._must_read.add(parameter.name)
        elif parameter.name not in self._must_read:
            if parameter.accepted is not ...:
                is_other = not values.same(value, parameter.accepted)
                parameter.adjusted, parameter.accepted = parameter.accepted if is_other else ..., ...
            elif not values.same(value, parameter.value):
                parameter.adjusted = ...
            parameter.value = value
            if parameter.is_unanswered and values.same(value, parameter.unanswered):
                parameter.message, parameter.unanswered = '', ...  # it did what it was asked to, late

    def _have_news(self) -> Todo:
        self._must_show = True
        return Todo(read=self._has_to_read, show=True)

    def _clear_messages(self) -> None:
        for parameter in self.parameters.values():
            parameter.message, parameter.unanswered = '', ...
            parameter.accepted = parameter.adjusted = ...
