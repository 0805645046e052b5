"""Record what becomes of each set of parameters on its way through a node.

``record_set`` asks for one set and returns what came of it; NumberLineView follows one set after another.
"""

import contextlib
import weakref
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from rcl_interfaces.msg import ParameterEvent, SetParametersResult
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.errors import CallbackError, ExecutorError, NodeNotFoundError
from param_tools.node.client import ParameterClient, changes, node_name
from param_tools.ros import rclpy_private, stage
from param_tools.ros.executor import function_name
from param_tools.ros.listeners import Listeners
from param_tutorial.views.base import name_of
from param_tutorial.views.drawing.ladder import Step


@dataclass(frozen=True)
class RecordedSet:
    """One set of a parameter, from the request to the answer."""

    value: Any
    """What was asked for."""
    node: str
    """The full name of the node."""
    name: str
    """The parameter; of several, the first."""
    steps: tuple[Step, ...]
    """What happened, in this order: callbacks, the moment when the value is stored, the event, the answer."""
    stored: Any
    """What the node has when it is over; None if there is no such parameter."""
    objection: str
    """Why the node did not take the value, in the node's words; empty if it did."""


def record_set(node: str | Node | ParameterClient, name: str, value: Any) -> RecordedSet:
    """Ask a node to set one parameter, and return what came of it.

    :param node: The node, or its name.
    :raises NodeNotFoundError: no node of that name is on the stage.
    :raises ExecutorError: the node is not on the stage.
    :raises InvalidValueError: no parameter can hold this value.
    """
    nodes = {name_of(each): each for each in stage.current().nodes}
    here = node if isinstance(node, Node) else nodes.get(node_name(node))
    if here is None:
        raise NodeNotFoundError(node_name(node), list(nodes))
    records: list[RecordedSet] = []
    stop_following = follow_sets(here, records.append)
    try:
        with contextlib.suppress(CallbackError):
            ParameterClient(here).set_parameter(name, value)
    finally:
        stop_following()
    return next(record for record in reversed(records) if record.name == name)


def follow_sets(node: Node, listener: Callable[[RecordedSet], object]) -> Callable[[], None]:
    """Call a listener, in the node's thread, with a record of each set: by a service, or in the node's own code.

    Unlike a message on /parameter_events, a record also tells of values that the node rejects. The node behaves as
    without a record.

    :param node: On the stage; what happens in another process cannot be looked into.
    :return: Call it to stop listening; safe to call when the executor has stopped.
    :raises ExecutorError: the node is not on the stage.
    """
    ros = stage.current()
    if not any(node is each for each in ros.nodes):
        raise ExecutorError(f'{node!r} is not on this stage: only a node that came from ros.add() can be recorded')

    def begin() -> Callable[[], None]:
        if node not in _recorders:
            _recorders[node] = _SetRecorder(node)
        return _recorders[node].add(listener)

    remove = ros.run(begin, 'begin to record')

    def stop_following() -> None:
        with contextlib.suppress(ExecutorError):
            ros.run(remove, 'end recording')
    return stop_following


class _SetRecorder:
    """Records what happens in one node, for all who follow it. Used in the node's thread only."""

    def __init__(self, node: Node):
        self._node = node
        self._listeners: Listeners[[RecordedSet]] = Listeners()
        # A callback may set parameters too.
        self._records: list[_Record] = []
        self._stop_observing = rclpy_private.observe_changes(node, self._call, self._publish, self._set)

    def add(self, listener: Callable[[RecordedSet], object]) -> Callable[[], None]:
        """Add a listener; when the last one is removed, the node is as it was before."""
        remove_listener = self._listeners.add(listener)

        def remove() -> None:
            remove_listener()
            if not self._listeners and _recorders.get(self._node) is self:
                del _recorders[self._node]
                self._stop_observing()
        return remove

    def _set(self, set_parameters: rclpy_private.SetParameters, parameters: list[Parameter]) -> SetParametersResult:
        if not parameters or not all(isinstance(each, Parameter) for each in parameters):
            return set_parameters(parameters)
        record = _Record(self._node, parameters)
        self._records.append(record)
        objection = ''
        try:
            result = set_parameters(parameters)
        except ParameterNotDeclaredException as error:
            # Who asks by a service gets it as the answer.
            objection = str(error)
            raise
        except BaseException as error:
            record.note('no answer', 'the caller would wait forever')
            objection = f'{type(error).__name__}: {error}'
            raise
        else:
            objection = '' if result.successful else result.reason or 'no reason given'
            if result.successful:
                record.note('answer', 'successful')
            return result
        finally:
            self._records.pop()
            if objection and record.steps[-1].what != 'no answer':
                record.note('answer', f'rejected: {objection}', objection=objection)
            self._listeners.call(RecordedSet(
                parameters[0].value, self._node.get_fully_qualified_name(), parameters[0].name, tuple(record.steps),
                record.stored, objection))

    def _call(self, kind: str, callback: rclpy_private.ParameterCallback, parameters: list[Parameter]) -> Any:
        # A declaration calls the on-set callbacks too.
        return self._records[-1].call(kind, callback, parameters) if self._records else callback(parameters)

    def _publish(self, publish: Callable[[ParameterEvent], None], event: ParameterEvent) -> None:
        if self._records:
            self._records[-1].publish(publish, event)
        else:
            publish(event)


_recorders: weakref.WeakKeyDictionary[Node, _SetRecorder] = weakref.WeakKeyDictionary()


class _Record:
    """What happens during one set. It is called in place of each callback, calls it, and notes what comes of it."""

    def __init__(self, node: Node, parameters: list[Parameter]):
        self._node, self._name = node, parameters[0].name
        self.steps: list[Step] = []
        value = values.format_value(parameters[0].value)
        self.note('asked', f'set {self._name} to {value}', proposed=value)

    @property
    def stored(self) -> Any:
        """The value that the node has now; None if there is no such parameter, or it has no value."""
        return self._node.get_parameter_or(self._name).value if self._node.has_parameter(self._name) else None

    def note(self, what: str, happened: str, **others: str) -> None:
        """Write down a step, and what is stored in this moment."""
        stored = values.format_value(self.stored) if self._node.has_parameter(self._name) else 'nothing'
        self.steps.append(Step(what, happened, stored, **others))

    def call(self, kind: str, callback: rclpy_private.ParameterCallback, parameters: list[Parameter]) -> Any:
        """Call a callback, and write down what it sees and what comes of it."""
        index, who = len(self.steps), _name(callback)
        happened = f'{who} sees {self._format_parameters(parameters)}'
        proposed, objection = self._proposed(parameters), ''
        self.note(kind, happened, who=who)
        try:
            answer = callback(parameters)
        except BaseException as error:
            objection = f'raises {type(error).__name__}'
            happened += f', {objection}'
            raise
        else:
            if kind == 'pre-set':
                happened += f', gives {self._format_parameters(answer)}'
                proposed, objection = self._proposed(answer), 'gives nothing' if answer == [] else ''
            elif kind == 'on-set':
                accepts = getattr(answer, 'successful', False)
                happened += ', accepts' if accepts else ', rejects'
                objection = '' if accepts else getattr(answer, 'reason', '') or 'no reason given'
            return answer
        finally:
            # What is stored is that of the moment when the callback began.
            self.steps[index] = replace(self.steps[index], happened=happened, proposed=proposed, objection=objection)

    def publish(self, publish: Callable[[ParameterEvent], None], event: ParameterEvent) -> None:
        """Publish an event; rclpy does so as soon as the value is stored."""
        happened = ', '.join(f'{name} = {values.format_value(value)}' for name, value in changes(event).items())
        self.note('stored', 'the value is written')
        publish(event)
        self.note('event', happened)

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
