"""Record what becomes of each set of parameters on its way through a node.

What is recorded here is drawn by ``diagrams`` and ``ladder``.
"""

import contextlib
import weakref
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rcl_interfaces.msg import ParameterEvent, SetParametersResult
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import CallbackError, ExecutorError
from param_tools.node.client import ParameterClient, changes
from param_tools.ros import rclpy_private, stage
from param_tools.ros.executor import BackgroundExecutor, function_name
from param_tools.ros.listeners import Listeners
from param_tutorial.pictures.diagrams import Step, Timeline


@dataclass(frozen=True)
class RecordedSet:
    """One set of a parameter, from the request to the answer."""

    value: Any
    """What was asked for."""
    timeline: Timeline
    """What happened, with the names of node and parameter; of several parameters, those of the first."""
    stored: Any
    """What the node has when it is over; None if there is no such parameter."""
    objection: str
    """Why the node did not take the value, in the node's words; empty if it did."""


def record_change(node: Node, name: str, value: Any, *,
                  executor: BackgroundExecutor | None = None) -> Timeline:
    """Ask a node to set one parameter, and record what happens in it, in that order.

    The record holds the calls of the node's callbacks, the moment when the value is stored, and the message on
    /parameter_events; the node behaves as without a recorder. An exception in a callback is drawn too.

    :param node: Spun by the executor; what happens in another process cannot be looked into.
    :raises ExecutorError: the node is not spun by the executor.
    :raises InvalidValueError: no parameter can hold this value.
    """
    ros = executor or stage.current()
    records: list[RecordedSet] = []
    stop_following = follow_sets(node, records.append, executor=ros)
    try:
        with contextlib.suppress(CallbackError):
            ParameterClient(node, executor=ros).set_parameter(name, value)
    finally:
        stop_following()
    return next(record.timeline for record in reversed(records) if record.timeline.name == name)


def follow_sets(node: Node, listener: Callable[[RecordedSet], object], *,
                executor: BackgroundExecutor | None = None) -> Callable[[], None]:
    """Call a listener, in the node's thread, with a record of each set: by a service, or in the node's own code.

    Unlike a message on /parameter_events, a record also tells of values that the node rejects. The node behaves as
    without a recorder.

    :param node: Spun by the executor; what happens in another process cannot be looked into.
    :return: Call it to stop listening; safe to call when the executor has stopped.
    :raises ExecutorError: the node is not spun by the executor.
    """
    ros = executor or stage.current()
    if not any(node is each for each in ros.nodes):
        raise ExecutorError(f'{node!r} is not on this stage: only a node that came from ros.add() can be recorded')

    def begin() -> Callable[[], None]:
        if node not in _taps:
            _taps[node] = _Tap(node)
        return _taps[node].add(listener)

    remove = ros.run(begin, 'begin to record')

    def stop_following() -> None:
        with contextlib.suppress(ExecutorError):
            ros.run(remove, 'end recording')
    return stop_following


class _Tap:
    """Records what happens in one node, for all who follow it. Used in the node's thread only."""

    def __init__(self, node: Node):
        self._node = node
        self._listeners: Listeners[[RecordedSet]] = Listeners()
        # A callback may set parameters too.
        self._recorders: list[_Recorder] = []
        self._stop_observing = rclpy_private.observe_changes(node, self._call, self._publish, self._set)

    def add(self, listener: Callable[[RecordedSet], object]) -> Callable[[], None]:
        """Add a listener; with the last one goes the tap."""
        remove_listener = self._listeners.add(listener)

        def remove() -> None:
            remove_listener()
            if not self._listeners and _taps.get(self._node) is self:
                del _taps[self._node]
                self._stop_observing()
        return remove

    def _set(self, set_parameters: rclpy_private.SetParameters, parameters: list[Parameter]) -> SetParametersResult:
        if not parameters or not all(isinstance(each, Parameter) for each in parameters):
            return set_parameters(parameters)
        recorder = _Recorder(self._node, parameters)
        self._recorders.append(recorder)
        objection = ''
        try:
            result = set_parameters(parameters)
        except ParameterNotDeclaredException as error:
            # Who asks by a service gets it as the answer.
            objection = str(error)
            raise
        except BaseException as error:
            recorder.note('no answer', 'the caller would wait forever')
            objection = f'{type(error).__name__}: {error}'
            raise
        else:
            objection = '' if result.successful else result.reason or 'no reason given'
            if result.successful:
                recorder.note('answer', 'successful', goes_to='you')
            return result
        finally:
            self._recorders.pop()
            if objection and recorder.steps[-1].what != 'no answer':
                recorder.note('answer', f'rejected: {objection}', goes_to='you', objection=objection)
            self._listeners.call(RecordedSet(parameters[0].value, recorder.timeline, recorder.stored, objection))

    def _call(self, kind: str, callback: rclpy_private.ParameterCallback, parameters: list[Parameter]) -> Any:
        # A declaration calls the on-set callbacks too.
        return self._recorders[-1].call(kind, callback, parameters) if self._recorders else callback(parameters)

    def _publish(self, publish: Callable[[ParameterEvent], None], event: ParameterEvent) -> None:
        if self._recorders:
            self._recorders[-1].publish(publish, event)
        else:
            publish(event)


_taps: weakref.WeakKeyDictionary[Node, _Tap] = weakref.WeakKeyDictionary()


class _Recorder:
    """Is called in place of each parameter callback of a node, calls it, and writes down what happens."""

    def __init__(self, node: Node, parameters: list[Parameter]):
        self._node, self._name = node, parameters[0].name
        self.steps: list[Step] = []
        value = values.format_value(parameters[0].value)
        self.note('asked', f'set {self._name} to {value}', comes_from='you', proposed=value)

    @property
    def timeline(self) -> Timeline:
        """What has happened so far."""
        return Timeline(self._node.get_fully_qualified_name(), self._name, self.steps)

    @property
    def stored(self) -> Any:
        """The value that the node has now; None if there is no such parameter, or it has no value."""
        return self._node.get_parameter_or(self._name).value if self._node.has_parameter(self._name) else None

    def note(self, what: str, told: str, **others: str) -> None:
        """Write down a step, and what is stored in this moment."""
        stored = values.format_value(self.stored) if self._node.has_parameter(self._name) else 'nothing'
        self.steps.append(Step(what, told, stored, **others))

    def call(self, kind: str, callback: rclpy_private.ParameterCallback, parameters: list[Parameter]) -> Any:
        """Call a callback, and write down what it sees and what comes of it."""
        index = len(self.steps)
        who = _name(callback)
        told = f'{who} sees {self._format_parameters(parameters)}'
        self.note(kind, told)
        proposed, objection = self._proposed(parameters), ''
        try:
            answer = callback(parameters)
        except BaseException as error:
            objection = f'raises {type(error).__name__}'
            told += f', {objection}'
            raise
        else:
            told += self._outcome(kind, answer)
            if kind == 'pre-set':
                proposed = self._proposed(answer)
                objection = 'gives nothing' if answer == [] else ''
            elif kind == 'on-set' and not getattr(answer, 'successful', False):
                objection = getattr(answer, 'reason', '') or 'no reason given'
            return answer
        finally:
            # What was stored when the callback began, and what came of it.
            begun = self.steps[index]
            self.steps[index] = Step(begun.what, told, begun.stored, who=who, proposed=proposed, objection=objection)

    def publish(self, publish: Callable[[ParameterEvent], None], event: ParameterEvent) -> None:
        """Publish an event; rclpy does so as soon as the value is stored."""
        told = ', '.join(f'{name} = {values.format_value(value)}' for name, value in changes(event).items())
        self.note('stored', 'the value is written')
        publish(event)
        self.note('event', told, goes_to='everybody')

    def _outcome(self, kind: str, answer: object) -> str:
        if kind == 'pre-set':
            return f', gives {self._format_parameters(answer)}'
        if kind == 'on-set':
            return ', accepts' if getattr(answer, 'successful', False) else ', rejects'
        return ''

    def _proposed(self, parameters: object) -> str:
        """Return the value of the parameter in a list as text; empty if it is not in there."""
        found = [each.value for each in parameters if isinstance(each, Parameter) and each.name == self._name] \
            if isinstance(parameters, list) else []
        return values.format_value(found[-1]) if found else ''

    def _format_parameters(self, parameters: object) -> str:
        """Return proposed parameters as a text: the value alone if it is the one that was asked for."""
        if not isinstance(parameters, list) or not all(isinstance(each, Parameter) for each in parameters):
            return f'{values.format_value(parameters)}, which is not a list of parameters'
        if [each.name for each in parameters] == [self._name]:
            return values.format_value(parameters[0].value)
        return ', '.join(f'{each.name} = {values.format_value(each.value)}' for each in parameters) or 'nothing'


def _name(callback: rclpy_private.ParameterCallback) -> str:
    """Return a callback's name as its author would say it; each node has one of rclpy's own, for use_sim_time."""
    owner = getattr(callback, '__self__', None)
    if type(owner).__module__.startswith('rclpy.'):
        return f"rclpy's {type(owner).__name__}"
    return function_name(callback)
