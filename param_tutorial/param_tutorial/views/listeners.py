"""The nodes on the stage that subscribe to /parameter_events: their QoS, and another QoS for them."""

from typing import Any

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.subscription import Subscription

from param_tools.ros.executor import BackgroundExecutor
from param_tutorial.views.base import name_of

TOPIC = '/parameter_events'
POLICIES: dict[str, dict[str, Any]] = {
    'reliability': {'reliable': ReliabilityPolicy.RELIABLE, 'best effort': ReliabilityPolicy.BEST_EFFORT},
    'durability': {'volatile': DurabilityPolicy.VOLATILE, 'transient local': DurabilityPolicy.TRANSIENT_LOCAL}}
"""What a listener may ask for, in words; the usual QoS comes first."""


def qos_words(profile: QoSProfile) -> dict[str, str]:
    """Return, in words, the two policies that decide whether messages arrive."""
    return {policy: getattr(profile, policy).name.lower().replace('_', ' ') for policy in POLICIES}


def subscriptions(ros: BackgroundExecutor) -> dict[str, tuple[Node, Subscription]]:
    """Return the nodes on the stage that subscribe, by name, each with its first subscription."""
    found: dict[str, tuple[Node, Subscription]] = {}
    for node in ros.nodes:
        for each in node.subscriptions:
            if each.topic_name == TOPIC:
                found.setdefault(name_of(node), (node, each))
    return found


def subscribe_again(ros: BackgroundExecutor, node: Node, old: Subscription, policy: str, word: str) -> None:
    """Replace a node's subscription by one that differs in a single policy."""
    def exchange() -> None:
        before = old.qos_profile
        profile = QoSProfile(**{'history': before.history, 'depth': before.depth, 'reliability': before.reliability,
                                'durability': before.durability, policy: POLICIES[policy][word]})
        new = node.create_subscription(old.msg_type, TOPIC, old.callback, profile, callback_group=old.callback_group,
                                       raw=old.raw)
        for name, value in list(vars(node).items()):
            if value is old:
                setattr(node, name, new)
        node.destroy_subscription(old)
    ros.run(exchange, f'subscribe to {TOPIC}')
