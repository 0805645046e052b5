"""What can be heard on a topic: the class of its messages, and a profile that hears everybody."""

import importlib
from typing import Any

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

_DEPTH = 100


def message_class(name: str) -> Any:
    """Return the class of a message type, such as ``std_msgs/msg/String``; None if it is not installed."""
    package, _, kind = name.partition('/')
    try:
        return getattr(importlib.import_module(f'{package}.msg'), kind.removeprefix('msg/'))
    except (ImportError, AttributeError, ValueError):
        return None


def matching_qos(node: Node, topic: str) -> QoSProfile:
    """Return the strictest profile with which all publishers are heard."""
    offered = [each.qos_profile for each in node.get_publishers_info_by_topic(topic)]
    is_reliable = all(each.reliability == ReliabilityPolicy.RELIABLE for each in offered)
    is_kept = bool(offered) and all(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offered)
    return QoSProfile(depth=_DEPTH,
                      reliability=ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
                      durability=DurabilityPolicy.TRANSIENT_LOCAL if is_kept else DurabilityPolicy.VOLATILE)
