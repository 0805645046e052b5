"""The module that takes the place of ``rclpy._rclpy_pybind11``: every name that rclpy uses of it."""

import types
from typing import Any

from param_tools.files import node_names
from param_tools.rcl_in_python import (
    arguments,
    clocks,
    contexts,
    enums,
    events,
    exceptions,
    logs,
    names,
    nodes,
    qos,
    serialization,
    services,
    topics,
    type_descriptions,
    waiting,
)

RMW_IDENTIFIER = 'rclpy_in_python_without_network'
# The public names of these modules that were defined there are those of the C layer, and more.
_SOURCES = (enums, exceptions, waiting, names, qos, arguments, logs, contexts, nodes, serialization, topics, services,
            clocks, events, type_descriptions)


def _not_here(name: str) -> type:
    """Return a class of the C layer that this one doesn't have: it says so when somebody makes an object of it."""
    def reject(*_: object) -> None:
        raise exceptions.NotImplementedError(
            f'{name} is not part of rclpy in Python, which has nodes, parameters, topics, services and timers')
    return type(name, (waiting.Destroyable,), {'__init__': reject, '__doc__': 'Not part of this layer.'})


def make(name: str) -> types.ModuleType:
    """Return the module.

    :param name: Its full name.
    """
    module = types.ModuleType(name, "rclpy's own code, without a network: the layer in Python.")
    members: dict[str, Any] = {}
    for source in _SOURCES:
        members |= {key: value for key, value in vars(source).items()
                    if not key.startswith('_') and getattr(value, '__module__', None) == source.__name__}
    members |= {
        'RCL_DEFAULT_DOMAIN_ID': contexts.DEFAULT_DOMAIN_ID,
        'RMW_DURATION_INFINITE': qos.DURATION_INFINITE,
        'RMW_QOS_DEADLINE_BEST_AVAILABLE': qos.BEST_AVAILABLE_DURATION,
        'RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE': qos.BEST_AVAILABLE_DURATION,
        'rclpy_get_rmw_implementation_identifier': lambda: RMW_IDENTIFIER,
        'rclpy_get_validation_error_for_topic_name': names.flaw_of_topic_name,
        'rclpy_get_validation_error_for_full_topic_name': names.flaw_of_full_topic_name,
        'rclpy_get_validation_error_for_namespace': node_names.flaw_of_namespace,
        'rclpy_get_validation_error_for_node_name': node_names.flaw_of_node_name,
        'rmw_matched_status_t': events.Matched,
        'rmw_requested_qos_incompatible_event_status_t': events.IncompatibleQos,
        'rmw_incompatible_type_status_t': events.Status,
        'rmw_requested_deadline_missed_status_t': events.Status,
        'rmw_offered_deadline_missed_status_t': events.Status,
        'rmw_liveliness_changed_status_t': events.LivelinessChanged,
        'rmw_liveliness_lost_status_t': events.Status,
        'rmw_message_lost_status_t': events.Status,
        'service_introspection': types.SimpleNamespace(ServiceIntrospectionState=enums.ServiceIntrospectionState),
    }
    members |= {each: _not_here(each) for each in (
        'ActionClient', 'ActionServer', 'ActionGoalHandle', 'LifecycleStateMachine', 'EventsExecutor')}
    vars(module).update(members)
    return module
