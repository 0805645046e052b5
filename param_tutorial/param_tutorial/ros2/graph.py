"""When is discovery finished, so that "there is no such node" is the truth?

A process that has just joined learns of the others one by one, in a tenth of a second on an idle machine and in
seconds on a busy one. To wait a fixed time, as the genuine ``ros2`` does, is too long on most days and too
short on some. But how much there is to discover on this machine can be known:

- Every DDS participant listens on a UDP port of its own, whose number follows from the domain. Linux lists all open
  ports, so it tells how many participants there are.
- Every participant of ROS announces its nodes on the topic ros_discovery_info, and every node publishes on
  /parameter_events or /rosout. The graph tells which of them have been heard, and whose nodes are known.

When as many participants have been heard as there are ports, and each has told its nodes, nothing is missing.
What this cannot know is other machines: unless discovery is limited to this one, it is given time besides.
"""

import time
from collections.abc import Callable

from rclpy.node import Node

from param_tutorial import domain
from param_tutorial.background import BackgroundExecutor

# A port may belong to a process that is suspended or to no ROS program at all: don't wait for it for ever.
PATIENCE_SEC = 10.0
# What the genuine command gives discovery, which is enough for an idle network.
NETWORK_SEC = 0.5
# How long after its name the services of a node may come: Fast DDS repeats lost news of them every 3 s.
SERVICES_SEC = 4.0
_UNKNOWN = '_NODE_NAME_UNKNOWN_'
_LOOK_PERIOD_SEC = 0.01


def wait_for(condition: Callable[[], bool], executor: BackgroundExecutor, at_least_sec: float) -> bool:
    """Wait until a condition is true, and give up when the graph is known completely and it still is not.

    :param at_least_sec: Do not give up earlier than this.
    """
    began = time.monotonic()
    while True:
        # In this order: what the graph is found to know completely holds for the look that follows.
        complete = is_complete(executor)
        if condition():
            return True
        waited = time.monotonic() - began
        if waited >= at_least_sec and (complete or waited >= max(PATIENCE_SEC, at_least_sec)):
            return False
        time.sleep(_LOOK_PERIOD_SEC)


def is_complete(executor: BackgroundExecutor) -> bool:
    """Have all participants on this machine been heard, and has each told its nodes?"""
    heard, told = _participants(executor.tool_node)
    return len(heard) >= len(domain.participant_ports(executor.domain_id)) and heard <= told


def _participants(node: Node) -> tuple[set[bytes], set[bytes]]:
    """Give the participants that were heard, and those of them whose nodes are known by name."""
    heard = {bytes(info.endpoint_gid[:12])
             for info in node.get_publishers_info_by_topic('ros_discovery_info', no_mangle=True)}
    named: dict[bool, set[bytes]] = {True: set(), False: set()}
    for topic in ('/rosout', '/parameter_events'):
        for info in node.get_publishers_info_by_topic(topic):
            named[info.node_name != _UNKNOWN].add(bytes(info.endpoint_gid[:12]))
    return heard, named[True] - named[False]
