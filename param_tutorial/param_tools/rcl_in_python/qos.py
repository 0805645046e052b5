"""Quality of service: the profiles that rclpy knows by name, and which publisher suits which subscription.

What an application leaves to the middleware is what Fast DDS makes of it, ROS's default.
"""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from param_tools.rcl_in_python.enums import QoSCompatibility, rmw_qos_policy_kind_t

DURATION_INFINITE = 2**63 - 1
BEST_AVAILABLE_DURATION = DURATION_INFINITE - 1

SYSTEM_DEFAULT, UNKNOWN = 0, 3
KEEP_LAST, KEEP_ALL = 1, 2
RELIABLE, BEST_EFFORT = 1, 2
TRANSIENT_LOCAL, VOLATILE = 1, 2
# Both of reliability and of durability.
BEST_AVAILABLE = 4
AUTOMATIC, MANUAL_BY_TOPIC, LIVELINESS_UNKNOWN, LIVELINESS_BEST_AVAILABLE = 1, 3, 4, 5

_WORDS = {
    'reliability': {0: 'system_default', 1: 'reliable', 2: 'best_effort', 3: 'unknown', 4: 'best_available'},
    'durability': {0: 'system_default', 1: 'transient_local', 2: 'volatile', 3: 'unknown', 4: 'best_available'},
    'liveliness': {0: 'system_default', 1: 'automatic', 3: 'manual_by_topic', 4: 'unknown', 5: 'best_available'},
}


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

        durations = {name: Duration(nanoseconds=getattr(self, name))
                     for name in ('lifespan', 'deadline', 'liveliness_lease_duration')}
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


def settled(profile: Profile, others: list[Profile], *, is_writer: bool) -> Profile:
    """Return a profile with the middleware's choice wherever the application has left it to the middleware.

    :param others: The (settled) profiles of those on the other end of the topic.
    """
    if profile.reliability == BEST_AVAILABLE:
        is_reliable = is_writer or all(each.reliability == RELIABLE for each in others)
        profile = replace(profile, reliability=RELIABLE if is_reliable else BEST_EFFORT)
    if profile.durability == BEST_AVAILABLE:
        is_lasting = is_writer or all(each.durability == TRANSIENT_LOCAL for each in others)
        profile = replace(profile, durability=TRANSIENT_LOCAL if is_lasting else VOLATILE)
    if profile.liveliness == LIVELINESS_BEST_AVAILABLE:
        levels = [each.liveliness for each in others]
        best = (max if is_writer else min)(levels, default=AUTOMATIC)
        profile = replace(profile, liveliness=best)
    for name in ('deadline', 'liveliness_lease_duration'):
        if getattr(profile, name) == BEST_AVAILABLE_DURATION:
            given = [getattr(each, name) or DURATION_INFINITE for each in others]
            chosen: dict[str, Any] = {name: (min if is_writer else max)(given, default=DURATION_INFINITE)}
            profile = replace(profile, **chosen)
    return replace(
        profile,
        history=profile.history or KEEP_LAST,
        depth=profile.depth or 1,
        reliability=profile.reliability or (RELIABLE if is_writer else BEST_EFFORT),
        durability=profile.durability or (TRANSIENT_LOCAL if is_writer else VOLATILE),
        lifespan=profile.lifespan or DURATION_INFINITE,
        deadline=profile.deadline or DURATION_INFINITE,
        liveliness=profile.liveliness or AUTOMATIC,
        liveliness_lease_duration=profile.liveliness_lease_duration or DURATION_INFINITE)


def incompatible_policy(writer: Profile, reader: Profile) -> rmw_qos_policy_kind_t | None:
    """Return the policy that keeps two (settled) profiles apart; of several the one that Fast DDS names last."""
    kinds = rmw_qos_policy_kind_t
    if writer.reliability == BEST_EFFORT and reader.reliability == RELIABLE:
        return kinds.RMW_QOS_POLICY_RELIABILITY
    if writer.liveliness < reader.liveliness or writer.liveliness_lease_duration > reader.liveliness_lease_duration:
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
    """Return whether two profiles suit each other, and why not, in rmw_dds_common's words."""
    writer, reader = profile_of(publisher), profile_of(subscription)
    if errors := _errors(writer, reader):
        return QoSCheckCompatibleResult(QoSCompatibility.ERROR, ''.join(errors))
    if warnings := _warnings(writer, reader):
        return QoSCheckCompatibleResult(QoSCompatibility.WARNING, ''.join(warnings))
    return QoSCheckCompatibleResult()


def _errors(writer: Profile, reader: Profile) -> list[str]:
    found = []
    if writer.reliability == BEST_EFFORT and reader.reliability == RELIABLE:
        found.append('ERROR: Best effort publisher and reliable subscription;')
    if writer.durability == VOLATILE and reader.durability == TRANSIENT_LOCAL:
        found.append('ERROR: Volatile publisher and transient local subscription;')
    if reader.deadline and not writer.deadline:
        found.append('ERROR: Subscription has a deadline, but publisher does not;')
    elif reader.deadline and reader.deadline < writer.deadline:
        found.append('ERROR: Subscription deadline is less than publisher deadline;')
    if writer.liveliness == AUTOMATIC and reader.liveliness == MANUAL_BY_TOPIC:
        found.append("ERROR: Publisher's liveliness is automatic and subscription's is manual by topic;")
    if reader.liveliness_lease_duration and not writer.liveliness_lease_duration:
        found.append('ERROR: Subscription has a liveliness lease duration, but publisher does not;')
    elif reader.liveliness_lease_duration and reader.liveliness_lease_duration < writer.liveliness_lease_duration:
        found.append('ERROR: Subscription liveliness lease duration is less than publisher;')
    return found


# Of each policy: the values that leave it open, the one that the weakest writer offers, the one that the most demanding
# reader wants; and rmw_dds_common's words (its spelling, too) for both open, an open writer, and an open reader.
_OPEN_POLICIES = (
    ('reliability', (SYSTEM_DEFAULT, UNKNOWN), BEST_EFFORT, RELIABLE,
     'Publisher reliability is {writer} and subscription reliability is {reader}',
     'Reliable subscription, but publisher is {writer}',
     'Best effort publisher, but subscription is {reader}'),
    ('durability', (SYSTEM_DEFAULT, UNKNOWN), VOLATILE, TRANSIENT_LOCAL,
     'Publisher durabilty is {writer} and subscription durability is {reader}',
     'Transient local subscription, but publisher is {writer}',
     'Volatile publisher, but subscription is {reader}'),
    ('liveliness', (SYSTEM_DEFAULT, LIVELINESS_UNKNOWN), AUTOMATIC, MANUAL_BY_TOPIC,
     'Publisher liveliness is {writer} and subscription liveliness is {reader}',
     "Subscription's liveliness is manual by topic, but publisher's is {writer}",
     "Publisher's liveliness is automatic, but subscription's is {reader}"),
)


def _warnings(writer: Profile, reader: Profile) -> list[str]:
    found = []
    for name, unclear, weakest, most_wanted, both_open, writer_open, reader_open in _OPEN_POLICIES:
        offered, wanted = getattr(writer, name), getattr(reader, name)
        if offered in unclear and wanted in unclear:
            text = both_open
        elif offered in unclear and wanted == most_wanted:
            text = writer_open
        elif offered == weakest and wanted in unclear:
            text = reader_open
        else:
            continue
        words = _WORDS[name]
        found.append(f'WARNING: {text.format(writer=words.get(offered, ""), reader=words.get(wanted, ""))};')
    return found
