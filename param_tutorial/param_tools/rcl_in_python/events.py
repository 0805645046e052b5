"""What a publisher or subscription is told about the other end: matched, incompatible, gone.

A status counts since the endpoint was made, and what has changed since somebody took it. An event is ready if something
has changed. A missed deadline and a loss of liveliness are never reported, though a publisher may stop: nobody watches
the time. Nor is a lost message: none gets lost on its way.
"""

import copy
from dataclasses import dataclass
from typing import Any

from param_tools.rcl_in_python.enums import (
    rcl_publisher_event_type_t,
    rcl_subscription_event_type_t,
    rmw_qos_policy_kind_t,
)
from param_tools.rcl_in_python.waiting import Destroyable, changed


class _Taken:
    """Counts, of which some tell what has changed since they were taken: their names end with ``_change``."""

    def take(self) -> Any:
        """Return a copy, and count changes from now on."""
        taken = copy.copy(self)
        self.__dict__.update({name: 0 for name in self.__dict__ if name.endswith('_change')})
        return taken


@dataclass
class Status(_Taken):
    """How often something has happened: every ``rmw_*_status_t`` that counts nothing else."""

    total_count: int = 0
    total_count_change: int = 0

    def add(self, count: int) -> None:
        self.total_count += count
        self.total_count_change += count

    def has_changed(self) -> bool:
        return self.total_count_change != 0


@dataclass
class Matched(Status):
    """rmw_matched_status_t: how many there are on the other end."""

    current_count: int = 0
    current_count_change: int = 0

    def add(self, count: int) -> None:
        if count > 0:
            super().add(count)
        self.current_count += count
        self.current_count_change += count

    def has_changed(self) -> bool:
        return bool(self.total_count_change or self.current_count_change)


@dataclass
class IncompatibleQos(Status):
    """rmw_requested_qos_incompatible_event_status_t."""

    last_policy_kind: rmw_qos_policy_kind_t = rmw_qos_policy_kind_t.RMW_QOS_POLICY_INVALID

    def add(self, count: int, policy: rmw_qos_policy_kind_t | None = None) -> None:
        super().add(count)
        if policy is not None:
            self.last_policy_kind = policy


@dataclass
class LivelinessChanged(_Taken):
    """rmw_liveliness_changed_status_t: how many publishers are alive; one that has gone is not counted."""

    alive_count: int = 0
    not_alive_count: int = 0
    alive_count_change: int = 0
    not_alive_count_change: int = 0

    def add(self, count: int) -> None:
        self.alive_count += count
        self.alive_count_change += count

    def has_changed(self) -> bool:
        return self.alive_count_change != 0


_PUBLISHER, _SUBSCRIPTION = rcl_publisher_event_type_t, rcl_subscription_event_type_t
_STATUSES = {
    (_PUBLISHER, _PUBLISHER.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED): 'deadline_missed',
    (_PUBLISHER, _PUBLISHER.RCL_PUBLISHER_LIVELINESS_LOST): 'liveliness',
    (_PUBLISHER, _PUBLISHER.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS): 'incompatible_qos',
    (_PUBLISHER, _PUBLISHER.RCL_PUBLISHER_INCOMPATIBLE_TYPE): 'incompatible_type',
    (_PUBLISHER, _PUBLISHER.RCL_PUBLISHER_MATCHED): 'matches',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED): 'deadline_missed',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_LIVELINESS_CHANGED): 'liveliness',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS): 'incompatible_qos',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_MESSAGE_LOST): 'message_lost',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE): 'incompatible_type',
    (_SUBSCRIPTION, _SUBSCRIPTION.RCL_SUBSCRIPTION_MATCHED): 'matches',
}


class EventHandle(Destroyable):
    """Events of one kind, of a publisher or a subscription."""

    def __init__(self, parent: Any, kind: Any):
        super().__init__()
        self._status = getattr(parent.endpoint, _STATUSES[type(kind), kind])

    def is_ready(self) -> bool:
        return bool(self._status.has_changed())

    def due_ns(self) -> None:
        """Return when it will be ready by itself: never."""

    def take_event(self) -> Any:
        with changed:
            return self._status.take()
