"""MessageView: a message on /parameter_events, from the node that has changed to each that listens."""

from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node

from param_tools import values
from param_tools.node.client import ParameterClient
from param_tools.ros import stage
from param_tools.ros.waiting import wait_until
from param_tutorial.views.base import PictureView
from param_tutorial.views.drawing.messages import MessageTraffic
from param_tutorial.views.events import EventRow, changes_in
from param_tutorial.views.ros_graph import ends_of_parameter_events


class MessageView(PictureView):
    """A message on /parameter_events that travels from the node that has changed to each that listens.

    Show it as the last line of a cell.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any) -> None:
        """Ask a node for a value, and show the message that it publishes; a value that it rejects sends none.

        :param node: The node, or its name.
        :param name: The parameter.
        :raises NodeNotFoundError: there is no such node.
        """
        client, ros = node if isinstance(node, ParameterClient) else ParameterClient(node), stage.current()
        heard: list[list[EventRow]] = []

        def hear(event: ParameterEvent) -> None:
            changes = changes_in(event)
            if event.node == client.node and name in {each.name for each in changes}:
                heard.append(changes)

        stop_listening = ros.on_parameter_event(hear)
        try:
            self._result = client.set_parameter(name, value)
            if self._result.successful:
                wait_until(lambda: heard, 'the message on /parameter_events')
        finally:
            stop_listening()
        told = [f'{each.kind} {each.name}' + ('' if each.kind == 'deleted'
                                              else f' = {values.format_value(each.value, 40)}')
                for each in (heard[0] if heard else ())]
        super().__init__(MessageTraffic(*ends_of_parameter_events(ros.tool_node), client.node if told else '', told))

    def __repr__(self) -> str:
        return f'<MessageView: {self._result}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        """The fully qualified name of the node."""
        return self._result.node
