"""What can be heard on a topic: the class of its messages, the numbers in them, and a profile that hears everybody."""

import importlib
import operator
import re
from collections.abc import Callable, Iterator
from typing import Any

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

_DEPTH = 100
# A type as rosidl writes it: what one element is, and what follows if there are several, e.g. double[36].
_TYPE = re.compile(r'(?:sequence<)?(?P<one>[\w/]+)(?:<\d+>)?(?P<many>\[\d+\]|, \d+>|>)?')
_NUMBER = re.compile(r'boolean|octet|float|double|long double|u?int\d+')
_STEP = re.compile(r'\.?(\w+)|\[(\d+)\]')


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


def numeric_fields(message: Any) -> Iterator[str]:
    """Yield the fields of a message's class that hold a number or a truth value, as in ``pose.position.x``.

    Of an array, all elements are one field: ``ranges[]``.
    """
    for name, kind in message.get_fields_and_field_types().items():
        found = _TYPE.fullmatch(kind)
        if found is None:
            continue
        field = f'{name}[]' if found['many'] else name
        if _NUMBER.fullmatch(found['one']):
            yield field
        elif '/' in found['one'] and (inner := message_class(found['one'])):
            yield from (f'{field}.{each}' for each in numeric_fields(inner))


def getter(field: str) -> Callable[[Any], Any]:
    """Return a function that takes a field out of a message; an element of an array is named as in ``ranges[5]``.

    The function raises an IndexError if the array is shorter, and an AttributeError if there is no such field.
    """
    steps = [operator.attrgetter(name) if name else operator.itemgetter(int(index))
             for name, index in _STEP.findall(field)]

    def get(message: Any) -> Any:
        for step in steps:
            message = step(message)
        return message
    return get
