"""Quality of service: the profiles that rclpy knows by name, and which publisher suits which subscription.

What an application leaves to the middleware is what Fast DDS makes of it, ROS's default.
"""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from param_tools.rcl_in_python.enums import QoSCompatibility, rmw_qos_policy_kind_t

DURATION_INFINITE = 2**63 - 1
BEST_AVAILABLE_DURATION = DURATION_INFINITE - 1

SYSTEM_DEFAULT, UNKNOWN = 0, 3
_OPEN = (SYSTEM_DEFAULT, UNKNOWN)
KEEP_LAST, KEEP_ALL = 1, 2
RELIABLE, BEST_EFFORT = 1, 2
TRANSIENT_LOCAL, VOLATILE = 1, 2
# Both of reliability and of durability.
BEST_AVAILABLE = 4
AUTOMATIC, MANUAL_BY_TOPIC, LIVELINESS_UNKNOWN, LIVELINESS_BEST_AVAILABLE = 1, 3, 4, 5
_OPEN_LIVELINESS = (SYSTEM_DEFAULT, LIVELINESS_UNKNOWN)
_DURATIONS = ('lifespan', 'deadline', 'liveliness_lease_duration')


class rcl_duration_t:
    """A number of nanoseconds."""

    def __init__(self, nanoseconds: int):
        self.nanoseconds = nanoseconds


@dataclass(frozen=True)
class Profile:
    """A profile; durations in ns, where 0 means that there is no limit."""

    history: int = KEEP_LAST
    depth: int = 10
    reliability: int = RELIABLE
    durability: int = VOLATILE
    lifespan: int = 0
    deadline: int = 0
    liveliness: int = SYSTEM_DEFAULT
    liveliness_lease_duration: int = 0
    avoid_ros_namespace_conventions: bool = False

    @property
    def limit(self) -> int | None:
        """How many samples are kept; None for all."""
        return None if self.history == KEEP_ALL else max(self.depth, 1)

    def discovered(self) -> 'Profile':
        """Return what others learn of it: DDS tells nobody how much an endpoint keeps."""
        return replace(self, history=UNKNOWN, depth=0)

    def to_dict(self) -> dict[str, Any]:
        """Return the arguments for a QoSProfile of rclpy."""
        from rclpy.duration import Duration

        durations = {name: Duration(nanoseconds=getattr(self, name)) for name in _DURATIONS}
        return {**vars(self), **durations}


DEFAULT = Profile()
ROSOUT = Profile(depth=1000, durability=TRANSIENT_LOCAL, lifespan=10 * 10**9)
_PREDEFINED = {
    'qos_profile_sensor_data': Profile(depth=5, reliability=BEST_EFFORT),
    'qos_profile_default': DEFAULT,
    'qos_profile_system_default': Profile(SYSTEM_DEFAULT, 0, SYSTEM_DEFAULT, SYSTEM_DEFAULT),
    'qos_profile_services_default': DEFAULT,
    'qos_profile_unknown': Profile(UNKNOWN, 0, UNKNOWN, UNKNOWN, liveliness=LIVELINESS_UNKNOWN),
    'qos_profile_parameters': Profile(depth=1000),
    'qos_profile_parameter_events': Profile(depth=1000),
    'qos_profile_best_available': Profile(
        reliability=BEST_AVAILABLE, durability=BEST_AVAILABLE, deadline=BEST_AVAILABLE_DURATION,
        liveliness=LIVELINESS_BEST_AVAILABLE, liveliness_lease_duration=BEST_AVAILABLE_DURATION),
}


class rmw_qos_profile_t:
    """A profile as rclpy hands it over."""

    def __init__(self, history: int, depth: int, reliability: int, durability: int, lifespan: rcl_duration_t,
                 deadline: rcl_duration_t, liveliness: int, liveliness_lease_duration: rcl_duration_t,
                 avoid_ros_namespace_conventions: bool):
        self.profile = Profile(int(history), depth, int(reliability), int(durability), lifespan.nanoseconds,
                               deadline.nanoseconds, int(liveliness), liveliness_lease_duration.nanoseconds,
                               avoid_ros_namespace_conventions)

    def to_dict(self) -> dict[str, Any]:
        return self.profile.to_dict()

    @staticmethod
    def predefined(name: str) -> Profile:
        if name not in _PREDEFINED:
            raise ValueError(f'Requested unknown rmw_qos_profile: {name}')
        return _PREDEFINED[name]


def rclpy_action_get_rmw_qos_profile(name: str) -> dict[str, Any]:
    if name != 'rcl_action_qos_profile_status_default':
        raise RuntimeError(f'Requested unknown rmw_qos_profile: {name}')
    return Profile(depth=1, durability=TRANSIENT_LOCAL).to_dict()


def profile_of(given: rmw_qos_profile_t | Profile | None) -> Profile:
    """Return the profile that a constructor was given."""
    if given is None:
        return DEFAULT
    return given if isinstance(given, Profile) else given.profile


# -- what a profile becomes when an endpoint is created -------------------------------------------------------


def settled(profile: Profile, *, is_writer: bool) -> Profile:
    """Return a profile with the middleware's choice wherever the application has left it to the middleware."""
    def chosen(value: int, default: int) -> int:
        return default if value in (SYSTEM_DEFAULT, BEST_AVAILABLE) else value

    return replace(
        _without_zeros(profile),
        history=profile.history or KEEP_LAST,
        depth=profile.depth or 1,
        reliability=chosen(profile.reliability, RELIABLE if is_writer else BEST_EFFORT),
        durability=chosen(profile.durability, TRANSIENT_LOCAL if is_writer else VOLATILE),
        liveliness=MANUAL_BY_TOPIC if profile.liveliness == MANUAL_BY_TOPIC else AUTOMATIC)


def _without_zeros(profile: Profile) -> Profile:
    """Return a profile that says in ns, too, that there is no limit."""
    endless: dict[str, Any] = {name: DURATION_INFINITE for name in _DURATIONS
                               if getattr(profile, name) in (0, BEST_AVAILABLE_DURATION)}
    return replace(profile, **endless)


def incompatible_policy(writer: Profile, reader: Profile) -> rmw_qos_policy_kind_t | None:
    """Return the policy that keeps two (settled) profiles apart; of several the one that Fast DDS names last."""
    kinds = rmw_qos_policy_kind_t
    if writer.reliability == BEST_EFFORT and reader.reliability == RELIABLE:
        return kinds.RMW_QOS_POLICY_RELIABILITY
    if ((writer.liveliness, reader.liveliness) == (AUTOMATIC, MANUAL_BY_TOPIC)
            or writer.liveliness_lease_duration > reader.liveliness_lease_duration):
        return kinds.RMW_QOS_POLICY_LIVELINESS
    if writer.deadline > reader.deadline:
        return kinds.RMW_QOS_POLICY_DEADLINE
    if writer.durability == VOLATILE and reader.durability == TRANSIENT_LOCAL:
        return kinds.RMW_QOS_POLICY_DURABILITY
    return None


# -- what rclpy.qos.qos_check_compatible answers --------------------------------------------------------------


class QoSCheckCompatibleResult(NamedTuple):
    compatibility: QoSCompatibility = QoSCompatibility.OK
    reason: str = ''


def rclpy_qos_check_compatible(publisher: rmw_qos_profile_t, subscription: rmw_qos_profile_t,
                               ) -> QoSCheckCompatibleResult:
    """Return whether two profiles suit each other, or may not, where one of them leaves it to the middleware."""
    writer, reader = _without_zeros(profile_of(publisher)), _without_zeros(profile_of(subscription))
    if policy := incompatible_policy(writer, reader):
        return QoSCheckCompatibleResult(QoSCompatibility.ERROR, f'ERROR: {policy.name} keeps them apart;')
    if policy := incompatible_policy(_at_worst(writer, BEST_EFFORT, VOLATILE, AUTOMATIC),
                                     _at_worst(reader, RELIABLE, TRANSIENT_LOCAL, MANUAL_BY_TOPIC)):
        return QoSCheckCompatibleResult(QoSCompatibility.WARNING, f'WARNING: {policy.name} may keep them apart;')
    return QoSCheckCompatibleResult()


def _at_worst(profile: Profile, reliability: int, durability: int, liveliness: int) -> Profile:
    """Return a profile with these values where it leaves them open."""
    return replace(profile,
                   reliability=reliability if profile.reliability in _OPEN else profile.reliability,
                   durability=durability if profile.durability in _OPEN else profile.durability,
                   liveliness=liveliness if profile.liveliness in _OPEN_LIVELINESS else profile.liveliness)
