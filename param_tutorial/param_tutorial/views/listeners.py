"""The nodes on the stage that listen to /parameter_events: with which QoS, what arrives, and listening with another."""

import contextlib
import functools
from collections.abc import Iterator
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
"""What a listener may ask for: of each policy what offers less, or asks for more, comes last."""


def qos_words(profile: QoSProfile) -> dict[str, str]:
    """Return the two policies on which it depends whether messages arrive, in words."""
    return {policy: next((word for word, value in words.items() if value == getattr(profile, policy)),
                         getattr(profile, policy).name.lower()) for policy, words in POLICIES.items()}


def subscriptions(ros: BackgroundExecutor) -> dict[str, tuple[Node, Subscription]]:
    """Return who on the stage subscribes, by name, with the subscription; of several, a node's first."""
    found: dict[str, tuple[Node, Subscription]] = {}
    for node in ros.nodes:
        for each in node.subscriptions:
            if each.topic_name == TOPIC:
                found.setdefault(name_of(node), (node, each))
    return found


@contextlib.contextmanager
def arrivals(ros: BackgroundExecutor, sender: str) -> Iterator[set[str]]:
    """Collect the names of those on the stage whose callback gets a message of a node meanwhile."""
    arrived: set[str] = set()

    def watched(name: str, callback: Any) -> Any:
        @functools.wraps(callback)
        def hear(message: Any, *others: Any) -> Any:
            if getattr(message, 'node', '') == sender:
                arrived.add(name)
            return callback(message, *others)
        return hear

    found = [(name, each, each.callback) for name, (_, each) in subscriptions(ros).items()]

    def watch() -> None:
        for name, each, callback in found:
            each.callback = watched(name, callback)

    def leave() -> None:
        for _, each, callback in found:
            each.callback = callback

    ros.run(watch, 'watch the listeners')
    try:
        yield arrived
    finally:
        ros.run(leave, 'watch no more')


def subscribe_again(ros: BackgroundExecutor, node: Node, old: Subscription, policy: str, word: str) -> None:
    """Give a node a subscription like the one that it has, but for one policy, in the place of that one."""
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
