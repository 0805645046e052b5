"""Watch a running system: one change on its way through a node, and who talks to whom.

What is observed here is drawn by ``diagrams``.
"""

import re
from collections.abc import Callable
from typing import Any

from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.errors import CallbackError, ExecutorError
from param_tutorial.parameters import values
from param_tutorial.parameters.client import ParameterClient, changes
from param_tutorial.pictures.diagrams import Step, Timeline
from param_tutorial.runtime import stage
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.services import SERVICE_TYPES

# Where rclpy 7.1 keeps what is called when parameters are set; for what is on the way there is no public place.
_CALLBACKS = {
    'pre-set': '_pre_set_parameters_callbacks',
    'on-set': '_on_set_parameters_callbacks',
    'post-set': '_post_set_parameters_callbacks',
}
_PUBLISHER = '_parameter_event_publisher'
_NOTEBOOK = 'this notebook'
# The DDS topic on which the requests for a parameter service travel (https://design.ros2.org/articles/
# topic_and_service_names.html): a client publishes on it, the server subscribes to it.
_REQUESTS = re.compile(rf'rq(/.+)/(?:{"|".join(SERVICE_TYPES)})Request')


def record_change(node: Node, name: str, value: Any, *,
                  executor: BackgroundExecutor | None = None) -> Timeline:
    """Ask a node to set one parameter, and write down what happens in it, in the order in which it does.

    Seen are the callbacks of the node, the moment in which the value is stored, and the message on
    /parameter_events; the node behaves as without a recorder. That a callback raises is drawn too.

    :param node: Spun by the executor; what happens in another process cannot be looked into.
    :raises ExecutorError: the node is not spun by the executor.
    :raises InvalidValueError: no parameter can hold this value.
    """
    ros = executor or stage.current()
    if not any(node is each for each in ros.nodes):
        raise ExecutorError(f'{node!r} is not on this stage: only a node that came from ros.add() can be recorded')
    recorder = _Recorder(node, name)
    recorder.note('asked', f'set {name} to {values.format_value(value)}', comes_from='you')
    ros.run(recorder.put_on, 'begin to record')
    try:
        result = ParameterClient(node, executor=ros).set_parameter(name, value)
    except CallbackError:
        recorder.note('no answer', 'whoever asked would wait for ever')
    else:
        recorder.note('answer', 'successful' if result.successful else f'refused: {result.reason}', goes_to='you')
    finally:
        ros.run(recorder.take_off, 'end recording')
    return Timeline(node.get_fully_qualified_name(), name, recorder.steps)


class _Recorder:
    """Stands before each callback of a node, and before its publisher of events."""

    def __init__(self, node: Node, name: str):
        self._node, self._name = node, name
        self.steps: list[Step] = []

    def note(self, what: str, told: str, **ends: str) -> None:
        stored = self._node._parameters.get(self._name)
        self.steps.append(Step(what, told, 'nothing' if stored is None else values.format_value(stored.value), **ends))

    def put_on(self) -> None:
        for kind, attribute in _CALLBACKS.items():
            callbacks = getattr(self._node, attribute)
            callbacks[:] = [_Recorded(self, kind, callback) for callback in callbacks]
        setattr(self._node, _PUBLISHER, _RecordedPublisher(self, getattr(self._node, _PUBLISHER)))

    def take_off(self) -> None:
        for attribute in _CALLBACKS.values():
            callbacks = getattr(self._node, attribute)
            # A callback may have added or removed others meanwhile: those are left as they are.
            callbacks[:] = [getattr(callback, 'recorded', callback) for callback in callbacks]
        publisher = getattr(self._node, _PUBLISHER)  # none if the node was destroyed meanwhile
        setattr(self._node, _PUBLISHER, getattr(publisher, 'recorded', publisher))

    def told(self, parameters: Any) -> str:
        """Tell proposed parameters: the value alone where it is the one that was asked for."""
        if not isinstance(parameters, list) or not all(isinstance(each, Parameter) for each in parameters):
            return f'{values.format_value(parameters)}, which is no list of parameters'
        if [each.name for each in parameters] == [self._name]:
            return values.format_value(parameters[0].value)
        return ', '.join(f'{each.name} = {values.format_value(each.value)}' for each in parameters) or 'nothing'


class _Recorded:
    def __init__(self, recorder: _Recorder, kind: str, recorded: Callable):
        self._recorder, self._kind, self.recorded = recorder, kind, recorded

    def __call__(self, parameters: list[Parameter]) -> Any:
        recorder, index = self._recorder, len(self._recorder.steps)
        told = f'{_name(self.recorded)} sees {recorder.told(parameters)}'
        recorder.note(self._kind, told)
        try:
            answer = self.recorded(parameters)
        except BaseException as error:
            told += f', raises {type(error).__name__}'
            raise
        else:
            told += self._outcome(answer)
            return answer
        finally:
            # What was stored when the callback began, and what came of it.
            begun = recorder.steps[index]
            recorder.steps[index] = Step(begun.what, told, begun.stored)

    def _outcome(self, answer: Any) -> str:
        if self._kind == 'pre-set':
            return f', gives {self._recorder.told(answer)}'
        if self._kind == 'on-set':
            return ', accepts' if getattr(answer, 'successful', False) else ', refuses'
        return ''

    def __eq__(self, other: object) -> bool:
        # So that a callback can remove itself, as it may without a recorder.
        return self.recorded == getattr(other, 'recorded', other)

    __hash__ = None


def _name(callback: Callable) -> str:
    """Name a callback as its author would; each node has one that is rclpy's own, for use_sim_time."""
    owner = getattr(callback, '__self__', None)
    if type(owner).__module__.startswith('rclpy.'):
        return f"rclpy's {type(owner).__name__}"
    return getattr(callback, '__name__', type(callback).__name__)


class _RecordedPublisher:
    def __init__(self, recorder: _Recorder, recorded: Any):
        self._recorder, self.recorded = recorder, recorded

    def publish(self, event: Any) -> None:
        told = ', '.join(f'{name} = {values.format_value(value)}' for name, value in changes(event).items())
        self._recorder.note('stored', 'the value is written')
        self.recorded.publish(event)
        self._recorder.note('event', told, goes_to='everybody')

    def __getattr__(self, name: str) -> Any:
        return getattr(self.recorded, name)
