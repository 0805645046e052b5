"""Record one change on its way through a node.

What is recorded here is drawn by ``diagrams``.
"""

from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial.errors import CallbackError, ExecutorError
from param_tutorial.parameters import values
from param_tutorial.parameters.client import ParameterClient, changes
from param_tutorial.pictures.diagrams import Step, Timeline
from param_tutorial.runtime import rclpy_private, stage
from param_tutorial.runtime.executor import BackgroundExecutor
from param_tutorial.runtime.managed import function_name


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
    if not any(node is each for each in ros.nodes):
        raise ExecutorError(f'{node!r} is not on this stage: only a node that came from ros.add() can be recorded')
    recorder = _Recorder(node, name)
    recorder.note('asked', f'set {name} to {values.format_value(value)}', comes_from='you')
    stop_observing = ros.run(
        lambda: rclpy_private.observe_changes(node, recorder.call, recorder.publish), 'begin to record')
    try:
        result = ParameterClient(node, executor=ros).set_parameter(name, value)
    except CallbackError:
        recorder.note('no answer', 'whoever asked would wait for ever')
    else:
        recorder.note('answer', 'successful' if result.successful else f'refused: {result.reason}', goes_to='you')
    finally:
        ros.run(stop_observing, 'end recording')
    return Timeline(node.get_fully_qualified_name(), name, recorder.steps)


class _Recorder:
    """Is called in place of each parameter callback of a node, calls it, and writes down what happens."""

    def __init__(self, node: Node, name: str):
        self._node, self._name = node, name
        self.steps: list[Step] = []

    def note(self, what: str, told: str, **ends: str) -> None:
        """Write down a step, and what is stored in this moment."""
        stored = 'nothing'
        if self._node.has_parameter(self._name):
            stored = values.format_value(self._node.get_parameter_or(self._name).value)
        self.steps.append(Step(what, told, stored, **ends))

    def call(self, kind: str, callback: rclpy_private.ParameterCallback, parameters: list[Parameter]) -> Any:
        """Call a callback, and write down what it sees and what comes of it."""
        index = len(self.steps)
        told = f'{_name(callback)} sees {self._format_parameters(parameters)}'
        self.note(kind, told)
        try:
            answer = callback(parameters)
        except BaseException as error:
            told += f', raises {type(error).__name__}'
            raise
        else:
            told += self._outcome(kind, answer)
            return answer
        finally:
            # What was stored when the callback began, and what came of it.
            begun = self.steps[index]
            self.steps[index] = Step(begun.what, told, begun.stored)

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
            return ', accepts' if getattr(answer, 'successful', False) else ', refuses'
        return ''

    def _format_parameters(self, parameters: object) -> str:
        """Return proposed parameters as a text: the value alone if it is the one that was asked for."""
        if not isinstance(parameters, list) or not all(isinstance(each, Parameter) for each in parameters):
            return f'{values.format_value(parameters)}, which is no list of parameters'
        if [each.name for each in parameters] == [self._name]:
            return values.format_value(parameters[0].value)
        return ', '.join(f'{each.name} = {values.format_value(each.value)}' for each in parameters) or 'nothing'


def _name(callback: rclpy_private.ParameterCallback) -> str:
    """Return a callback's name as its author would say it; each node has one of rclpy's own, for use_sim_time."""
    owner = getattr(callback, '__self__', None)
    if type(owner).__module__.startswith('rclpy.'):
        return f"rclpy's {type(owner).__name__}"
    return function_name(callback)
