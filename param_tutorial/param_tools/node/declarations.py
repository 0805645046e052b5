"""Record the declarations of a node while it starts, and find the descriptors that contradict them."""

import copy
import json
from collections.abc import Mapping
from dataclasses import dataclass
from textwrap import shorten
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import values
from param_tools.descriptor import is_housekeeping
from param_tools.errors import DeclarationError
from param_tools.ros import stage
from param_tools.ros.executor import BackgroundExecutor


@dataclass(frozen=True)
class Declaration:
    """One parameter, as it was declared."""

    name: str
    default: Any
    """None if it was declared with a type instead of a default."""
    value: Any
    """The value after the declaration; None if it has none."""
    contradictions: tuple[str, ...] = ()
    """What rclpy ignores in the descriptor, in words, each with the remedy."""


def record_declarations(node_class: type[Node], overrides: Mapping[str, Any] | None = None, *,
                        executor: BackgroundExecutor | None = None) -> tuple[Node, list[Declaration]]:
    """Start a node on the stage, and record each of its declarations, in their order.

    :param node_class: As for ``ros.add()``; its constructor takes no arguments.
    :param overrides: Values from outside, by name, as after ``-p``.
    :return: The node, and its declarations, except those that every node has.
    :raises ExecutorError: no executor is running, or node_class is not a class of nodes.
    """
    declared: list[Declaration] = []
    used: list[tuple[ParameterDescriptor, str]] = []

    class Recorded(node_class):  # type: ignore[misc, valid-type]
        def declare_parameters(self, namespace: str, parameters: Any, *args: Any, **others: Any) -> list[Parameter]:
            # declare_parameter() comes here too.
            entries = [tuple(each) for each in parameters]
            # Copies, because rclpy writes into the descriptors.
            meant = [copy.copy(entry[2]) if len(entry) > 2 else None for entry in entries]
            answers: list[Parameter] = super().declare_parameters(namespace, entries, *args, **others)
            for (_, *rest), descriptor, answer in zip(entries, meant, answers, strict=True):
                default = rest[0] if rest and not isinstance(rest[0], (Parameter.Type, type(None))) else None
                found: list[str] = []
                if descriptor is not None:
                    first = next((name for each, name in used if each is rest[1]), None)
                    used.append((rest[1], answer.name))
                    found = _contradictions(answer.name, self.describe_parameter(answer.name), descriptor, first)
                declared.append(Declaration(answer.name, default, answer.value, tuple(found)))
            return answers

    Recorded.__name__ = Recorded.__qualname__ = node_class.__name__
    arguments = [part for name, value in (overrides or {}).items() for part in ('-p', f'{name}:={json.dumps(value)}')]
    node = (executor or stage.current()).add(Recorded, ros_args=arguments)
    return node, [each for each in declared if not is_housekeeping(each.name)]


def check_declarations(node_class: type[Node], overrides: Mapping[str, Any] | None = None, *,
                       executor: BackgroundExecutor | None = None) -> None:
    """Start a node on the stage, stop it, and raise an error if rclpy ignores part of a descriptor.

    rclpy 7.1 keeps the descriptor object that it is given, writes the parameter's name and the type of its value into
    it, and looks at a range only if it has the type of the value. It never complains (ros2/rclpy#879).

    :param node_class: Like the other arguments, as for ``record_declarations``.
    :raises DeclarationError: a descriptor contradicts its declaration.
    :raises ExecutorError: no executor is running, or node_class is not a class of nodes.
    """
    ros = executor or stage.current()
    node, declared = record_declarations(node_class, overrides, executor=ros)
    ros.remove(node)
    found = [f'{each.name}: {words}' for each in declared for words in each.contradictions]
    if found:
        raise DeclarationError('\n'.join([f'{node_class.__name__} declares what rclpy ignores:', *found]))


def describe_wrong_field(message: Any) -> str:
    """Return which field of a message, or of a message in it, has a value of the wrong type; empty if none has.

    rclpy checks the fields of a message only if it is made with ``check_fields=True``. Without the check, an integer in
    place of a double is sent as another number, which depends on the version of Python, and most other wrong values
    are not sent at all.
    """
    for name in message.get_fields_and_field_types():
        value = getattr(message, name)
        for each in value if isinstance(value, (list, tuple)) else ():
            if hasattr(each, 'get_fields_and_field_types') and (found := describe_wrong_field(each)):
                return found
        try:
            type(message)(**{name: value}, check_fields=True)
        except AssertionError as error:
            return f'{error}, and it is `{shorten(repr(value), 100)}`'
    return ''


def _contradictions(name: str, kept: ParameterDescriptor, meant: ParameterDescriptor, first: str | None) -> list[str]:
    """Return what rclpy ignores in a descriptor, in words, each with the remedy.

    :param kept: The descriptor after the declaration.
    :param meant: The descriptor before.
    :param first: The parameter that was declared with the same descriptor object before; None if there is none.
    """
    if first is not None:
        return [f'its descriptor is the object of {first}, which now describes {name} too. Make one for each']
    found = []
    kind = values.TYPES[kept.type]
    if wrong := describe_wrong_field(meant):
        found.append(f'its descriptor holds what its message has no room for: {wrong}')
    if meant.type not in (ParameterType.PARAMETER_NOT_SET, kept.type):
        said = values.TYPES[meant.type].label if meant.type < len(values.TYPES) else meant.type
        found.append(f'its descriptor says type {said}, and it is declared as {kind.label}. Leave `type` out: '
                     'the value decides')
    if meant.name not in ('', name):
        found.append(f'its descriptor says name {meant.name}. Leave `name` out')
    for ranges, own, words in ((meant.integer_range, values.INTEGER, 'an integer_range'),
                               (meant.floating_point_range, values.DOUBLE, 'a floating_point_range')):
        if ranges and kind is not own and not meant.dynamic_typing:
            is_number = kind in (values.INTEGER, values.DOUBLE)
            remedy = ('Judge the elements in an on-set callback' if kind.is_array else
                      'Give it the range of its own type' if is_number else 'Leave it out')
            found.append(f'it has {words} and is declared as {kind.label}, so it has no limits. {remedy}')
    return found
