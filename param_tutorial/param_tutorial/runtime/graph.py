"""The ROS graph as one node sees it: which nodes there are, who talks to whom, and whether anything is still missing.

When is discovery finished, so that "there is no such node" is the truth? A process that has just joined learns of the
others one by one, in a tenth of a second on an idle machine and in seconds on a busy one. A fixed wait, as in the
genuine ``ros2``, is too long on most days and too short on some. But this machine knows how much there is to discover:

- Every DDS participant listens on a UDP port of its own, whose number follows from the domain. Linux lists all open
  ports, so it tells how many participants there are.
- Every participant of ROS announces its nodes on the topic ros_discovery_info, and every node publishes on
  /parameter_events or /rosout. The graph tells which of them have been heard, and whose nodes are known.

When as many participants have been heard as there are ports, and each has announced its nodes, nothing is missing.
Other machines remain unknown: unless discovery is limited to this one, it is given time as well.
"""

import re
import time
from collections import Counter
from collections.abc import Callable, Iterator

from rclpy.node import Node, NodeNameNonExistentError
from rclpy.qos import QoSCompatibility, qos_check_compatible
from rclpy.topic_endpoint_info import TopicEndpointInfo

from param_tutorial.pictures.diagrams import NodeGraph
from param_tutorial.runtime import domain
from param_tutorial.runtime.service_types import SERVICE_TYPES

# A port may belong to a process that is suspended or to no ROS program at all: don't wait for it forever.
PATIENCE_SEC = 10.0
# What the genuine command gives discovery, which is enough for an idle network.
NETWORK_SEC = 0.5
# How long after its name the services of a node may come: Fast DDS repeats lost news of them every 3 s.
SERVICES_SEC = 4.0
_UNKNOWN = '_NODE_NAME_UNKNOWN_'
_LOOK_PERIOD_SEC = 0.01
_NOTEBOOK = 'this notebook'
# The DDS topic on which the requests for a parameter service travel (https://design.ros2.org/articles/
# topic_and_service_names.html): a client publishes on it, the server subscribes to it.
_REQUESTS = re.compile(rf'rq(/.+)/(?:{"|".join(SERVICE_TYPES)})Request')


def nodes_in_graph(observer: Node) -> list[tuple[str, str]]:
    """Return the name and the namespace of each node in the graph, sorted; twice if two nodes have both.

    rmw keeps the names of a process that ended while its last message on ros_discovery_info was under way: that
    message comes after the participant's leave, and puts the names into the list again, for good (rmw_dds_common's
    GraphCache). Such a ghost has no publisher or service any more. Every node of rclpy, and usually of rclcpp, has a
    publisher on /parameter_events; a node that has none must have something else.

    :param observer: Whose view of the graph it is.
    """
    listed = Counter(observer.get_node_names_and_namespaces())
    publishing = Counter((info.node_name, info.node_namespace)
                         for info in observer.get_publishers_info_by_topic('/parameter_events'))
    return [node for node, count in sorted(listed.items()) if publishing[node] or _has_endpoints(observer, *node)
            for _ in range(min(count, publishing[node] or count))]


def _has_endpoints(observer: Node, name: str, namespace: str) -> bool:
    try:
        return any(endpoints_of(name, namespace) for endpoints_of in (
            observer.get_publisher_names_and_types_by_node, observer.get_subscriber_names_and_types_by_node,
            observer.get_service_names_and_types_by_node, observer.get_client_names_and_types_by_node))
    except NodeNameNonExistentError:  # it has left meanwhile
        return False


def incarnations(observer: Node) -> frozenset[tuple[str, bytes]]:
    """Return the fully qualified name of each node, with the DDS identity of its publisher on /parameter_events.

    A restarted node has the same name and another identity.
    """
    return frozenset((_full_name(info), bytes(info.endpoint_gid))
                     for info in observer.get_publishers_info_by_topic('/parameter_events'))


def wait_for(condition: Callable[[], bool], observer: Node, at_least_sec: float) -> bool:
    """Wait until a condition is true, and give up when the graph is known completely and it still is not.

    :param observer: Whose view of the graph it is; an executor in another thread spins it.
    :param at_least_sec: Do not give up earlier than this.
    """
    began = time.monotonic()
    while True:
        # In this order: what the graph is found to know completely holds for the look that follows.
        complete = is_complete(observer)
        if condition():
            return True
        waited = time.monotonic() - began
        if waited >= at_least_sec and (complete or waited >= max(PATIENCE_SEC, at_least_sec)):
            return False
        time.sleep(_LOOK_PERIOD_SEC)


def is_complete(observer: Node) -> bool:
    """True if every participant on this machine has been heard, and each has announced its nodes."""
    heard, announced = _participants(observer)
    return len(heard) >= len(domain.participant_ports(observer.context.get_domain_id())) and heard <= announced


def _participants(node: Node) -> tuple[set[bytes], set[bytes]]:
    """Return the participants that were heard, and those of them whose nodes are known by name."""
    heard = {bytes(info.endpoint_gid[:12])
             for info in node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True)}
    named: dict[bool, set[bytes]] = {True: set(), False: set()}
    for topic in ('/rosout', '/parameter_events'):
        for info in node.get_publishers_info_by_topic(topic):
            named[info.node_name != _UNKNOWN].add(bytes(info.endpoint_gid[:12]))
    return heard, named[True] - named[False]


def who_talks_to_whom(observer: Node) -> NodeGraph:
    """Find out who offers parameter services, who has clients for them, and who reports and hears of changes.

    :param observer: Whose view of the graph it is; it stands in the picture as "this notebook".
    """
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
                     tells=_display_names(observer.get_publishers_info_by_topic('/parameter_events'), observer),
                     listens=_display_names(observer.get_subscriptions_info_by_topic('/parameter_events'), observer))


def ends_of_parameter_events(observer: Node) -> tuple[list[str], dict[str, bool]]:
    """Return who publishes on /parameter_events, and who subscribes to it.

    :param observer: Whose view of the graph it is; it is called "this notebook".
    :return: The publishers, and for each subscriber whether the messages reach it: they do not if its subscription
        asks for more than the publishers offer.
    """
    publishers = observer.get_publishers_info_by_topic('/parameter_events')
    listens: dict[str, bool] = {}
    for subscription in observer.get_subscriptions_info_by_topic('/parameter_events'):
        reached = any(qos_check_compatible(each.qos_profile, subscription.qos_profile)[0] != QoSCompatibility.ERROR
                      for each in publishers)
        for name in _display_names([subscription], observer):
            listens[name] = listens.get(name, False) or reached
    return sorted({*_display_names(publishers, observer)} - {_NOTEBOOK}), listens


def _display_names(endpoints: list[TopicEndpointInfo], observer: Node) -> Iterator[str]:
    """Yield the names under which the nodes of some endpoints are shown."""
    for endpoint in endpoints:
        name = _full_name(endpoint)
        if name == observer.get_fully_qualified_name():
            yield _NOTEBOOK
        elif '/_' not in name:  # as _NODE_NAME_UNKNOWN_ has it
            yield name


def _full_name(endpoint: TopicEndpointInfo) -> str:
    """Return the fully qualified name of the node that an endpoint belongs to."""
    return f'{endpoint.node_namespace.rstrip("/")}/{endpoint.node_name}'
