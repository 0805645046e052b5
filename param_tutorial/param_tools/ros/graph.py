"""The ROS graph as one node sees it: which nodes there are, and how long to wait for one.

Discovery takes time: a process that has just joined learns of the others one by one, in a tenth of a second on an idle
machine. Nothing tells when it is finished. So a search goes on until it has found something or DISCOVERY_SEC have
passed, and in a process that has just joined NEWCOMER_SEC; and a list of nodes waits until nothing new has come for
QUIET_SEC.
"""

import time
from collections import Counter

from rclpy.node import Node, NodeNameNonExistentError
from rclpy.topic_endpoint_info import TopicEndpointInfo

from param_tools.ros import waiting
from param_tools.ros.service_types import SERVICE_TYPES

DISCOVERY_SEC = 1.0
# What the genuine command gives discovery in a process that has just joined.
JOINING_SEC = 0.5
# For so long after it has joined, a process may still learn of a node that was there before: Fast DDS answers a
# newcomer once, and announces itself again every 3 s. Our profile (fastdds.xml) cures that; the user may have another.
NEWCOMER_SEC = 5.0
QUIET_SEC = 0.2

Incarnations = frozenset[tuple[str, bytes]]


def nodes_in_graph(observer: Node) -> list[tuple[str, str]]:
    """Return the name and the namespace of each node in the graph, sorted; twice if two nodes have both.

    rmw keeps the names of a process that ended while its last message on ros_discovery_info was under way: that
    message comes after the participant's leave, and puts the names into the list again, for good (rmw_dds_common's
    GraphCache). Such a node has no publisher or service any more. Every node of rclpy, and usually of rclcpp, has a
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


def node_names(observer: Node, *, hidden: bool = False) -> list[str]:
    """Return the fully qualified names of the nodes in the graph, sorted, a name twice if two nodes have it.

    :param hidden: Also those with a part that starts with an underscore.
    """
    names = (f'{namespace.rstrip("/")}/{name}' for name, namespace in nodes_in_graph(observer))
    return sorted(name for name in names if hidden or '/_' not in name)


def incarnations(observer: Node) -> Incarnations:
    """Return the fully qualified name of each node, with the DDS identity of its publisher on /parameter_events.

    A restarted node has the same name and another identity.
    """
    return frozenset((name_of(info), bytes(info.endpoint_gid))
                     for info in observer.get_publishers_info_by_topic('/parameter_events'))


def wait_until_quiet(observer: Node, at_least_sec: float = 0.0) -> None:
    """Wait until no node has come or gone for a while, or DISCOVERY_SEC have passed.

    :param at_least_sec: Wait for so long in any case: the observer has just joined. If it is still alone then, it waits
        on, for up to NEWCOMER_SEC.
    """
    began = time.monotonic()
    quiet_sec, joining_sec = QUIET_SEC * waiting.PATIENCE, at_least_sec * waiting.PATIENCE
    known, since = nodes_in_graph(observer), began

    def is_quiet() -> bool:
        nonlocal known, since
        now = time.monotonic()
        if (found := nodes_in_graph(observer)) != known:
            known, since = found, now
        # A node whose publishers and services are not known yet is there by name alone.
        is_whole = len(observer.get_node_names()) == len(found)
        is_alone = bool(at_least_sec) and len(found) == 1
        return now - since >= quiet_sec and now - began >= joining_sec and is_whole and not is_alone

    waiting.wait(is_quiet, max(at_least_sec, NEWCOMER_SEC if at_least_sec else DISCOVERY_SEC))


def has_left(node: str, observer: Node) -> bool:
    """True if nothing of a node that was there is in the graph any more.

    Its name alone says little: it comes in a message of its own, which Fast DDS repeats only after three seconds if it
    gets lost, and by then the node's services may have been known for long.

    :param node: Fully qualified.
    """
    return (node not in node_names(observer, hidden=True)
            and not any(observer.get_subscriptions_info_by_topic(f'rq{node}/{service}Request', no_mangle=True)
                        for service in SERVICE_TYPES))


def name_of(endpoint: TopicEndpointInfo) -> str:
    """Return the fully qualified name of the node that an endpoint belongs to."""
    return f'{endpoint.node_namespace.rstrip("/")}/{endpoint.node_name}'
