"""Who publishes what, and who hears it: the nodes and endpoints of a ROS domain, and their queues.

Topics have the names that DDS knows them by (``rt/chatter``), and a service is a pair of them (``rq/…Request`` and
``rr/…Reply``), so that what is asked of the graph is answered as the real one does it.
"""

import itertools
import time
from collections import deque
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from param_tools.rcl_in_python import messages, qos
from param_tools.rcl_in_python.events import IncompatibleQos, LivelinessChanged, Matched, Status
from param_tools.rcl_in_python.waiting import changed

_gids = itertools.count(1)


class Sample(NamedTuple):
    """A message on its way."""

    message: Any
    published_ns: int
    received_ns: int
    number: int
    """Of those that its writer has sent: 1 for the first."""
    writer: 'Writer'
    header: Any
    """Of a request or an answer: which request."""


@dataclass(eq=False)
class NodeEntry:
    """A node in the graph."""

    name: str
    namespace: str
    enclave: str
    context: object
    """Its context; all nodes of one share the types of their topics."""


class TopicTypeError(Exception):
    """A topic has one type in one context."""


def _have_one_type(one: 'Endpoint', other: 'Endpoint') -> bool:
    return messages.dds_name(one.message_type) == messages.dds_name(other.message_type)


class Endpoint:
    """A writer or a reader of a topic."""

    is_writer = False

    def __init__(self, domain: 'Domain', node: NodeEntry, topic: str, message_type: type, profile: qos.Profile):
        """:param topic: As DDS knows it."""
        self.domain, self.node, self.topic, self.message_type = domain, node, topic, message_type
        self.profile = qos.settled(profile, is_writer=self.is_writer)
        self.gid = [*next(_gids).to_bytes(8, 'little'), *bytes(8)]
        self.matched: list[Any] = []
        self.matches, self.incompatible_type = Matched(), Status()
        self.incompatible_qos = IncompatibleQos()
        domain.add(self)

    def match(self, other: Any) -> None:
        """Add an endpoint that has been found on the other end to the matches."""
        self.matched.append(other)
        self.matches.add(1)

    def unmatch(self, other: Any) -> None:
        """Remove an endpoint that has been destroyed from the matches."""
        self.matched.remove(other)
        self.matches.add(-1)

    def leave(self) -> None:
        """Take it out of the graph."""
        self.domain.remove(self)


class Writer(Endpoint):
    """The end of a topic that sends."""

    is_writer = True

    def __init__(self, *args: Any):
        self._numbers = itertools.count(1)
        self._kept: deque[Sample] = deque()
        self.deadline_missed, self.liveliness = Status(), Status()
        super().__init__(*args)

    def write(self, message: Any, header: Any = None, to: 'Reader | None' = None) -> None:
        """Send a message to every reader that matches.

        :param to: Send it to this one only, and to none if it doesn't match.
        :raises TypeError: a field holds something that its type does not take.
        """
        copied = messages.copy(message, self.message_type)
        now = time.time_ns()
        with changed:
            sample = Sample(copied, now, now, next(self._numbers), self, header)
            if self.profile.durability == qos.TRANSIENT_LOCAL:
                self._kept.append(sample)
                while self.profile.limit is not None and len(self._kept) > self.profile.limit:
                    self._kept.popleft()
            for reader in list(self.matched):
                if to in (None, reader):
                    reader.receive(sample)
            changed.notify_all()

    def match(self, other: 'Reader') -> None:
        super().match(other)
        if other.profile.durability == qos.TRANSIENT_LOCAL:
            oldest = time.time_ns() - self.profile.lifespan
            for sample in self._kept:
                if sample.published_ns >= oldest:
                    other.receive(sample._replace(received_ns=time.time_ns()))


class Reader(Endpoint):
    """The end of a topic that receives, and keeps what nobody has taken yet."""

    def __init__(self, *args: Any):
        self.queue: deque[Sample] = deque()
        self.deadline_missed, self.message_lost, self.liveliness = Status(), Status(), LivelinessChanged()
        super().__init__(*args)

    def receive(self, sample: Sample) -> None:
        limit = self.profile.limit
        if limit is not None and len(self.queue) >= limit:
            self.queue.popleft()
        self.queue.append(sample)

    def take(self) -> Sample | None:
        """Return the oldest message in the queue, None if there is none."""
        while self.queue:
            sample = self.queue.popleft()
            if time.time_ns() - sample.published_ns <= sample.writer.profile.lifespan:
                return sample
        return None

    def match(self, other: Writer) -> None:
        super().match(other)
        self.liveliness.add(1)

    def unmatch(self, other: Writer) -> None:
        super().unmatch(other)
        self.liveliness.add(-1)


@dataclass(eq=False)
class Domain:
    """All that is in the graph of one ROS domain."""

    nodes: list[NodeEntry] = field(default_factory=list)
    endpoints: list[Any] = field(default_factory=list)

    def add(self, new: Endpoint) -> None:
        """Add an endpoint, and match it with those on the other end of its topic.

        :raises TopicTypeError: in its context, the topic has another type.
        """
        with changed:
            namesakes = [each for each in list(self.endpoints) if each.topic == new.topic]
            for other in namesakes:
                if other.node.context is new.node.context and not _have_one_type(new, other):
                    raise TopicTypeError(f'topic name {new.topic} with incompatible type '
                                         f'{messages.dds_name(new.message_type)}')
            for other in namesakes:
                if other.is_writer != new.is_writer:
                    self._meet(new, other)
            self.endpoints.append(new)
            changed.notify_all()

    def _meet(self, new: Endpoint, other: Any) -> None:
        writer, reader = (new, other) if new.is_writer else (other, new)
        if not _have_one_type(writer, reader):
            writer.incompatible_type.add(1)
            reader.incompatible_type.add(1)
        elif policy := qos.incompatible_policy(writer.profile, reader.profile):
            writer.incompatible_qos.add(1, policy)
            reader.incompatible_qos.add(1, policy)
        else:
            reader.match(writer)
            writer.match(reader)

    def remove(self, old: Any) -> None:
        with changed:
            self.endpoints.remove(old)
            for other in list(old.matched):
                other.unmatch(old)
            changed.notify_all()


domains: dict[int, Domain] = {}


def dds_topic(name: str, profile: qos.Profile) -> str:
    """Return what DDS calls a topic of ROS."""
    return name if profile.avoid_ros_namespace_conventions else f'rt{name}'


def dds_service(name: str) -> tuple[str, str]:
    """Return what DDS calls the two topics of a service: that of the requests, and that of the replies."""
    return f'rq{name}Request', f'rr{name}Reply'
