"""The ROS graph as one node sees it: which nodes there are, who talks to whom, and whether anything is still missing.

When is discovery finished, so that "there is no such node" is the truth? A process that has just joined learns of the
others one by one, in a tenth of a second on an idle machine and in seconds on a busy one. A fixed wait, as in the
genuine ``ros2``, is too long on most days and too short on some. But this machine knows how much there is to discover:

- Every DDS participant listens on a UDP port of its own, whose number follows from the domain. Linux lists all open
  ports and which process holds them, so it tells how many participants there are, and of which processes.
- Every participant of ROS announces its nodes on the topic ros_discovery_info, and every node publishes on
  /parameter_events or /rosout. The graph tells which of them have been heard, and whose nodes are known.

When the participant behind each port has been heard, and each has announced its nodes, nothing is missing, but of a
process that has lived long: names travel apart, and what its nodes offer may come a second or more after them.
Other machines remain unknown: unless discovery is limited to this one, it is given time as well.

The services of a node are announced apart from its name, and nothing says how many there are. But they are announced
in the order of their creation, and the last one of a node of rclpy or rclcpp is known by its name.
"""

import os
import time
import weakref
from collections import Counter
from collections.abc import Callable, Iterable

from rclpy.node import Node, NodeNameNonExistentError
from rclpy.topic_endpoint_info import TopicEndpointInfo

from param_tools.errors import WaitTimeoutError
from param_tools.ros import domain, udp_ports
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.udp_ports import UdpSocket
from param_tools.ros.waiting import machine_time

# A port may belong to a process that is suspended or to no ROS program at all: don't wait for it forever.
PATIENCE_SEC = 10.0
# What the genuine command gives discovery, which is enough for an idle network.
NETWORK_SEC = 0.5
# For so long a node may be known by name only. Measured: up to 1.8 s, once 2.7 s, for a process that had created 25,000
# publishers and subscribers; Fast DDS repeats what got lost after 3 s.
_UNHEARD_SEC = 5.0
# For so long a node of which not even the name is in the graph may be about to come.
_LEFT_SEC = 1.0
_UNKNOWN = '_NODE_NAME_UNKNOWN_'
_LOOK_PERIOD_SEC = 0.01


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


Incarnations = frozenset[tuple[str, bytes]]


def incarnations(observer: Node) -> Incarnations:
    """Return the fully qualified name of each node, with the DDS identity of its publisher on /parameter_events.

    A restarted node has the same name and another identity.
    """
    return frozenset((name_of(info), bytes(info.endpoint_gid))
                     for info in observer.get_publishers_info_by_topic('/parameter_events'))


def wait_for(condition: Callable[[], bool], observer: Node, at_least_sec: float) -> bool:
    """Wait until a condition is true, and give up when the graph is known completely and it still is not.

    :param observer: Whose view of the graph it is; an executor in another thread spins it.
    :param at_least_sec: Do not give up earlier than this.
    :return: Whether the condition is true. If not, it is false in a graph that is known completely.
    :raises WaitTimeoutError: it is still false, and the graph is still not known completely.
    """
    began = machine_time()
    while True:
        # In this order: what the graph is found to know completely holds for the look that follows.
        missing, is_unheard = _missing(observer), _has_unheard_nodes(observer)
        if condition():
            return True
        waited_sec, limit_sec = machine_time() - began, max(PATIENCE_SEC, at_least_sec)
        if waited_sec >= at_least_sec and not missing and not is_unheard:
            return False
        if waited_sec >= limit_sec and missing:
            raise WaitTimeoutError(
                f'timed out after {limit_sec:g} s waiting for {missing} to announce '
                f'{"its" if missing.startswith("1 ") else "their"} nodes: suspended, or in a debugger?')
        time.sleep(_LOOK_PERIOD_SEC)


def is_complete(observer: Node) -> bool:
    """True if every participant on this machine has been heard, and each has announced its nodes."""
    return not _missing(observer) and not _has_unheard_nodes(observer)


# When an observer joined; of one that has not said so, when it first looked.
_arrivals: weakref.WeakKeyDictionary[Node, float] = weakref.WeakKeyDictionary()


def note_arrival(observer: Node) -> None:
    """Take note that an observer has been created just now."""
    _arrivals[observer] = machine_time()


def _has_unheard_nodes(observer: Node) -> bool:
    """True if nothing is known of a node but its name, to an observer that is new.

    To one that has been there for longer, such a name is a ghost's.
    """
    now = machine_time()
    if now > _arrivals.setdefault(observer, now) + _UNHEARD_SEC:
        return False
    return not set(observer.get_node_names_and_namespaces()) <= set(nodes_in_graph(observer))


def _missing(observer: Node) -> str:
    """Name how many participants have yet to be heard, or to announce their nodes; empty if none."""
    heard, announced = _participants(observer)
    # In this order: a participant that has been heard had opened its port before.
    sockets = domain.participant_sockets(observer.context.get_domain_id())
    count = _count_missing(heard, announced, sockets)
    return f'{count} ROS process{"" if count == 1 else "es"}' if count else ''


def _participants(node: Node) -> tuple[set[bytes], set[bytes]]:
    """Return the participants that were heard, and those of them whose nodes are known by name."""
    heard = _participants_of(node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True))
    named: dict[bool, set[bytes]] = {True: set(), False: set()}
    for topic in ('/rosout', '/parameter_events'):
        for info in node.get_publishers_info_by_topic(topic):
            named[info.node_name != _UNKNOWN].add(bytes(info.endpoint_gid[:12]))
    return heard, named[True] - named[False]


def _count_missing(heard: set[bytes], announced: set[bytes], sockets: set[UdpSocket]) -> int:
    """Return how many participants have yet to be heard, or to announce their nodes.

    Comparing their number with the number of ports is not enough. A participant that was killed, or whose goodbye was
    lost, still counts as heard but has no port any more, so it would hide one that has a port and has not been heard.
    Therefore each is looked up among the sockets of its process. The identity of a participant of Fast DDS begins with
    the vendor, the host, and the lower half of the process's number (``GuidPrefix_t::create`` of Fast DDS 2.14).

    :param sockets: Those on which the domain's participants listen.
    """
    visible = udp_ports.processes()
    count, spare, found, portless = 0, 0, set[int](), set[bytes]()
    for half in set(map(_half, heard)):
        group = {each for each in heard if _half(each) == half}
        ports = udp_ports.held(sockets, (each for each in visible if each & 0xffff == half))
        count += max(len(ports) - len(group), 0)
        spare += max(len(group) - len(ports), 0)
        found |= ports
        if ports:
            count += len(group - announced)
        else:
            portless |= group
    left = {each for each in sockets if each.port not in found}
    ports_left = {each.port for each in left}
    # This process cannot inspect those of other users, and in another container a process has another number. Their
    # ports may belong to participants that have been heard.
    foreign = ports_left - udp_ports.held(left, filter(udp_ports.is_numbered_as_here, visible)) if spare else set()
    count += len(ports_left) - min(len(foreign), spare)
    # The other participants without a port are on another machine, or they were on this one and have left. Without
    # Linux's table of ports, they may all be here.
    may_be_here = bool(foreign) or not sockets
    ours = {each[:4] for each in heard if _half(each) == os.getpid() & 0xffff}
    return count + sum(may_be_here or each[:4] not in ours for each in portless - announced)


def _half(participant: bytes) -> int:
    return int.from_bytes(participant[4:6], 'little')


def wait_for_service(is_ready: Callable[[], bool], node: str, service: str, observer: Node,
                     patience_sec: float | None = None) -> bool:
    """Wait until a parameter service of a node is ready, and give up when it is known that the node has none.

    :param node: Fully qualified name of a node that is in the graph.
    :param service: One of SERVICE_TYPES.
    :param observer: Whose view of the graph it is.
    :param patience_sec: In machine time; by default PATIENCE_SEC.
    :return: Whether the service is ready. If not, the node has no such service, or has left.
    :raises WaitTimeoutError: it is not ready, and it is still not known whether the node has it.
    """
    patience_sec = PATIENCE_SEC if patience_sec is None else patience_sec
    began = machine_time()
    deadline = began + patience_sec
    while True:
        # In this order: what is found to be announced holds for the looks that follow.
        is_announced = _has_announced_services(node, observer)
        is_there = bool(observer.get_subscriptions_info_by_topic(f'rq{node}/{service}Request', no_mangle=True))
        if is_ready():
            return True
        if is_announced and not is_there:
            return False
        now = machine_time()
        if (now > began + _LEFT_SEC and has_left(node, observer)
                and (now > began + _UNHEARD_SEC or not _is_among(observer.get_node_names_and_namespaces(), node))):
            return False
        if now >= deadline:
            raise WaitTimeoutError(f'timed out after {patience_sec:g} s waiting for {service} of {node}: was the node '
                                   f'created with start_parameter_services=False?')
        time.sleep(_LOOK_PERIOD_SEC)


def has_left(node: str, observer: Node) -> bool:
    """True if nothing of a node that was there is in the graph any more.

    Its name alone says little: it comes in a message of its own, which Fast DDS repeats only after three seconds if it
    gets lost, and by then the node's services may have been known for long.

    :param node: Fully qualified.
    """
    return (not _is_among(nodes_in_graph(observer), node)
            and not any(observer.get_subscriptions_info_by_topic(f'rq{node}/{service}Request', no_mangle=True)
                        for service in SERVICE_TYPES))


def _has_announced_services(node: str, observer: Node) -> bool:
    """True if all parameter services that a node has are in the graph.

    rclpy 7.1 and rclcpp create a node's service get_type_description after its parameter services, if there are any.
    DDS announces the ends of a participant in the order of their creation, those that receive and those that send each.
    """
    nodes = _participants_of(observer.get_publishers_info_by_topic('/parameter_events'), node)
    if not nodes:
        return False
    service = f'{node}/get_type_description'
    return (nodes <= _participants_of(observer.get_subscriptions_info_by_topic(f'rq{service}Request', no_mangle=True))
            and nodes <= _participants_of(observer.get_publishers_info_by_topic(f'rr{service}Reply', no_mangle=True)))


def _participants_of(endpoints: list[TopicEndpointInfo], node: str | None = None) -> set[bytes]:
    """Return the participants that some endpoints belong to; of one node, or of all."""
    return {bytes(each.endpoint_gid[:12]) for each in endpoints if node in (None, name_of(each))}


def _joined(name: str, namespace: str) -> str:
    return f'{namespace.rstrip("/")}/{name}'


def _is_among(names: Iterable[tuple[str, str]], node: str) -> bool:
    """True if a node, by its fully qualified name, is one of those whose names and namespaces are given."""
    return any(_joined(*each) == node for each in names)


def name_of(endpoint: TopicEndpointInfo) -> str:
    """Return the fully qualified name of the node that an endpoint belongs to."""
    return _joined(endpoint.node_name, endpoint.node_namespace)
