"""MessageView: a message on /parameter_events, from the node that has changed to each that listens."""

from collections.abc import Iterable
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSCompatibility, QoSProfile, ReliabilityPolicy, qos_check_compatible
from rclpy.subscription import Subscription
from rclpy.topic_endpoint_info import TopicEndpointInfo

from param_tools import values
from param_tools.errors import NodeNotFoundError
from param_tools.node.client import ParameterClient
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor
from param_tools.ros.graph import name_of as name_of_endpoint
from param_tools.ros.waiting import wait_until
from param_tutorial.views.base import PictureView, name_of
from param_tutorial.views.drawing.diagram import Diagram
from param_tutorial.views.drawing.messages import Listener, draw_messages
from param_tutorial.views.events import EventRow, changes_in
from param_tutorial.views.handle import Choosing

_TOPIC = '/parameter_events'
_POLICIES: dict[str, dict[str, Any]] = {
    'reliability': {'reliable': ReliabilityPolicy.RELIABLE, 'best effort': ReliabilityPolicy.BEST_EFFORT},
    'durability': {'volatile': DurabilityPolicy.VOLATILE, 'transient local': DurabilityPolicy.TRANSIENT_LOCAL}}
"""What a listener may ask for, in words; the usual QoS comes first."""

_NOTEBOOK = 'this notebook'


class MessageView(PictureView):
    """A message on /parameter_events that travels from the node that has changed to each that listens.

    Show it as the last line of a cell. Below it, a reader chooses the QoS with which the nodes on the stage listen: a
    listener subscribes again with that, and the node is asked for the value once more.
    """

    def __init__(self, node: str | Node | ParameterClient, name: str, value: Any) -> None:
        """Ask a node for a value, and show the message that it publishes; a value that it rejects sends none.

        :param node: The node, or its name.
        :param name: The parameter.
        :raises NodeNotFoundError: there is no such node.
        """
        self._client = node if isinstance(node, ParameterClient) else ParameterClient(node)
        self._name, self._value = name, value
        self._choosing = Choosing(self._subscribe_again, caption='Choose what each listener asks for:',
                                  options={policy: list(words) for policy, words in _POLICIES.items()})
        super().__init__(self._ask_node(), self._choosing)

    def __repr__(self) -> str:
        return f'<MessageView: {self._result}{", closed" if self._closed else ""}>'

    @property
    def node(self) -> str:
        return self._result.node

    def _ask_node(self) -> Diagram:
        """Ask the node for the value, and return what becomes of its message."""
        ros, sender = stage.current(), self._client.node
        heard: list[list[EventRow]] = []

        def hear(event: ParameterEvent) -> None:
            changes = changes_in(event)
            # What the node declared a moment ago may come now, too.
            if event.node == sender and any(
                    each.name == self._name and (each.kind != 'new' or each.value == self._value) for each in changes):
                heard.append(changes)

        publishers, offers, subscribers = _ends_of_parameter_events(ros.tool_node)
        stop_listening = ros.on_parameter_event(hear)
        try:
            self._result = self._client.set_parameter(self._name, self._value)
            if self._result.successful:
                wait_until(lambda: heard, 'the message on /parameter_events')
        finally:
            stop_listening()
        content = [f'{each.kind} {each.name}' + ('' if each.kind == 'deleted'
                                                 else f' = {values.format_value(each.value, 40)}')
                   for each in (heard[0] if self._result.successful else ())]
        self._choosing.things = {name: _qos_words(each.qos_profile)
                                 for name, (_, each) in sorted(_subscriptions(ros).items())}
        return draw_messages(publishers, subscribers, sender if content else '', content, offers=offers)

    def _subscribe_again(self, chosen: tuple[str, str, str]) -> str:
        name, policy, word = chosen
        ros = stage.current()
        here = _subscriptions(ros)
        if name not in here:
            raise NodeNotFoundError(name, list(here))
        _subscribe_again(ros, *here[name], policy, word)
        return self._replace(self._ask_node())


def _subscriptions(ros: BackgroundExecutor) -> dict[str, tuple[Node, Subscription]]:
    """Return the nodes on the stage that subscribe, by name, each with its first subscription."""
    found: dict[str, tuple[Node, Subscription]] = {}
    for node in ros.nodes:
        for each in node.subscriptions:
            if each.topic_name == _TOPIC:
                found.setdefault(name_of(node), (node, each))
    return found


def _subscribe_again(ros: BackgroundExecutor, node: Node, old: Subscription, policy: str, word: str) -> None:
    """Replace a node's subscription by one that differs in a single policy."""
    def exchange() -> None:
        before = old.qos_profile
        profile = QoSProfile(**{'history': before.history, 'depth': before.depth, 'reliability': before.reliability,
                                'durability': before.durability, policy: _POLICIES[policy][word]})
        new = node.create_subscription(old.msg_type, _TOPIC, old.callback, profile, callback_group=old.callback_group,
                                       raw=old.raw)
        for name, value in list(vars(node).items()):
            if value is old:
                setattr(node, name, new)
        node.destroy_subscription(old)
    ros.run(exchange, f'subscribe to {_TOPIC}')


def _ends_of_parameter_events(observer: Node) -> tuple[list[str], str, dict[str, Listener]]:
    """Return who publishes on /parameter_events, the QoS that they offer, and who subscribes to it.

    :param observer: Whose view of the graph it is; it is called "this notebook".
    :return: Of the subscribers, one that asks for more than the publishers offer gets nothing.
    """
    publishers = observer.get_publishers_info_by_topic(_TOPIC)
    offers = dict.fromkeys(', '.join(_qos_words(each.qos_profile).values()) for each in publishers)
    listens: dict[str, Listener] = {}
    for subscription in observer.get_subscriptions_info_by_topic(_TOPIC):
        reached = any(qos_check_compatible(each.qos_profile, subscription.qos_profile)[0] != QoSCompatibility.ERROR
                      for each in publishers)
        asks = ', '.join(_qos_words(subscription.qos_profile).values())
        for name in _display_names([subscription], observer):
            if reached or name not in listens:
                listens[name] = Listener(asks, '' if reached else 'incompatible QoS')
    return sorted({*_display_names(publishers, observer)} - {_NOTEBOOK}), ' or '.join(offers), listens


def _qos_words(profile: QoSProfile) -> dict[str, str]:
    """Return, in words, the two policies that decide whether messages arrive."""
    return {policy: getattr(profile, policy).name.lower().replace('_', ' ') for policy in _POLICIES}


def _display_names(endpoints: Iterable[TopicEndpointInfo], observer: Node) -> list[str]:
    """Return the names under which the nodes of some endpoints are shown, without those that tools hide."""
    names = (name_of_endpoint(each) for each in endpoints)
    return [_NOTEBOOK if name == observer.get_fully_qualified_name() else name for name in names
            if name == observer.get_fully_qualified_name() or '/_' not in name]  # as _NODE_NAME_UNKNOWN_ has it
