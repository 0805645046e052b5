"""MessageView: messages on /parameter_events, from the node that has changed to each that listens."""

from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient, node_name
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.waiting import wait_until
from param_tutorial.views.base import LivePictureView
from param_tutorial.views.drawing.messages import MessageTraffic
from param_tutorial.views.events import changes_in
from param_tutorial.views.ros_graph import ends_of_parameter_events


class MessageView(LivePictureView):
    """Messages on /parameter_events that travel from the node that has changed to each that listens.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient | None = None, name: str = '', value: Any = ..., *,
                 executor: BackgroundExecutor | None = None) -> None:
        """
        :param node: Only its messages; by default those of all nodes.
        :param name: With a value, the parameter.
        :param value: Ask the node for this value, and show the message that it publishes, and nothing after it; by
            default the view asks for nothing, and follows.
        :param executor: As for LadderView.
        """
        self._event: ParameterEvent | None = None
        self._shown: object = self
        self._node = None if node is None else node_name(node)
        super().__init__(self._node or 'all nodes', executor)
        if self._node is not None and value is not ...:
            result = ParameterClient(self._node, executor=self._executor).set_parameter(name, value)
            if result.successful:
                wait_until(lambda: self._event, 'the message on /parameter_events')
            self._job.call_now(1.0)
            self._hold(f'{result}')

    def _subscribe(self, executor: BackgroundExecutor) -> Callable[[], None]:
        stops = [executor.on_parameter_event(self._on_event), executor.on_graph_change(self._job.wake)]

        def stop() -> None:
            for each in stops:
                each()
        return stop

    def _on_event(self, event: ParameterEvent) -> None:
        # Of a node that starts, the graph tells; a message for each of its declarations would hide the rest.
        is_wanted = event.node == self._node or (self._node is None and '/_' not in event.node)
        if is_wanted and (event.changed_parameters or event.deleted_parameters):
            self._event = event
            self._job.wake()

    def _show(self) -> None:
        if self._executor is None or not self._executor.is_running:
            self._shown = None
            self._say('The stage is stopped.')
            return
        tells, listens = ends_of_parameter_events(self._executor.tool_node)
        event = self._event
        shown = tells, listens, event
        if shown == self._shown:
            return
        # The same message is not sent again because somebody came or went.
        is_new = event is not None and not (isinstance(self._shown, tuple) and self._shown[2] is event)
        self._shown = shown
        told = [] if event is None else [
            f'{each.kind} {each.name}' + ('' if each.kind == 'deleted' else f' = {values.format_value(each.value, 40)}')
            for each in changes_in(event)]
        self._play(MessageTraffic(tells, listens, event.node if event else '', told), is_still=not is_new)
