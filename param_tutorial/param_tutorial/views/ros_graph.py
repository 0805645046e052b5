"""Who talks to whom about parameters: what the ROS graph says, for ``NodeGraph`` and for the picture of messages."""

import re
from collections.abc import Iterator
from typing import Any

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSCompatibility, QoSProfile, ReliabilityPolicy, qos_check_compatible
from rclpy.topic_endpoint_info import TopicEndpointInfo

from param_tools.ros import stage
from param_tools.ros.graph import name_of
from param_tools.ros.service_types import SERVICE_TYPES
from param_tutorial.views.drawing.messages import Listener
from param_tutorial.views.drawing.ros_graph import NodeGraph

TOPIC = '/parameter_events'
POLICIES: dict[str, dict[str, Any]] = {
    'reliability': {'reliable': ReliabilityPolicy.RELIABLE, 'best effort': ReliabilityPolicy.BEST_EFFORT},
    'durability': {'volatile': DurabilityPolicy.VOLATILE, 'transient local': DurabilityPolicy.TRANSIENT_LOCAL}}
"""What a listener may ask for, in words; the usual QoS comes first."""

_NOTEBOOK = 'this notebook'
# The DDS topic on which the requests for a parameter service travel (https://design.ros2.org/articles/
# topic_and_service_names.html): a client publishes on it, the server subscribes to it.
_REQUESTS = re.compile(rf'rq(/.+)/(?:{"|".join(SERVICE_TYPES)})Request')


def node_graph() -> NodeGraph:
    """Find out who offers parameter services, who has clients for them, and who reports and hears of changes.

    Nodes whose name begins with an underscore are left out, as ``ros2 node list`` leaves them out, except the one
    through which this notebook asks and listens.

    :raises ExecutorError: no executor is running.
    """
    observer = stage.current().tool_node
    serves: list[str] = []
    asks: list[tuple[str, str]] = []
    for topic, types in observer.get_topic_names_and_types(no_demangle=True):
        requests = _REQUESTS.fullmatch(topic)
        if requests is None or not types[0].startswith('rcl_interfaces::srv::'):
            continue
        # By topic, and not by node: rmw would look for the node by its name, and may find one that has ended.
        serves += _display_names(observer.get_subscriptions_info_by_topic(topic, no_mangle=True), observer)
        if '/_' not in requests[1]:
            askers = _display_names(observer.get_publishers_info_by_topic(topic, no_mangle=True), observer)
            asks += [(asker, requests[1]) for asker in askers]
    return NodeGraph(serves=serves, asks=asks,
                     tells=_display_names(observer.get_publishers_info_by_topic(TOPIC), observer),
                     listens=_display_names(observer.get_subscriptions_info_by_topic(TOPIC), observer))


def ends_of_parameter_events(observer: Node) -> tuple[list[str], str, dict[str, Listener]]:
    """Return who publishes on /parameter_events, the QoS that they offer, and who subscribes to it.

    :param observer: Whose view of the graph it is; it is called "this notebook".
    :return: Of the subscribers, one that asks for more than the publishers offer gets nothing.
    """
    publishers = observer.get_publishers_info_by_topic(TOPIC)
    offers = dict.fromkeys(', '.join(qos_words(each.qos_profile).values()) for each in publishers)
    listens: dict[str, Listener] = {}
    for subscription in observer.get_subscriptions_info_by_topic(TOPIC):
        reached = any(qos_check_compatible(each.qos_profile, subscription.qos_profile)[0] != QoSCompatibility.ERROR
                      for each in publishers)
        asks = ', '.join(qos_words(subscription.qos_profile).values())
        for name in _display_names([subscription], observer):
            if reached or name not in listens:
                listens[name] = Listener(asks, '' if reached else 'incompatible QoS')
    return sorted({*_display_names(publishers, observer)} - {_NOTEBOOK}), ' or '.join(offers), listens


def qos_words(profile: QoSProfile) -> dict[str, str]:
    """Return, in words, the two policies that decide whether messages arrive."""
    return {policy: getattr(profile, policy).name.lower().replace('_', ' ') for policy in POLICIES}


def _display_names(endpoints: list[TopicEndpointInfo], observer: Node) -> Iterator[str]:
    """Yield the names under which the nodes of some endpoints are shown."""
    for endpoint in endpoints:
        name = name_of(endpoint)
        if name == observer.get_fully_qualified_name():
            yield _NOTEBOOK
        elif '/_' not in name:  # as _NODE_NAME_UNKNOWN_ has it
            yield name
