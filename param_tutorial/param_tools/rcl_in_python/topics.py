"""Publishers and subscriptions."""

from typing import Any

from param_tools.rcl_in_python import names, qos
from param_tools.rcl_in_python.exceptions import RCLError
from param_tools.rcl_in_python.graph import Reader, TopicTypeError, Writer, dds_topic
from param_tools.rcl_in_python.messages import TooLongError, copy
from param_tools.rcl_in_python.nodes import Node
from param_tools.rcl_in_python.serialization import rclpy_deserialize, rclpy_serialize
from param_tools.rcl_in_python.waiting import Destroyable, changed

Given = qos.rmw_qos_profile_t | qos.Profile | None


class _TopicEnd(Destroyable):
    endpoint: Any
    what: str

    def __init__(self, node: Node, topic: str):
        self.node = node
        node.check_valid(f'Failed to create {self.what}')
        try:
            self._topic = node.resolve(topic, 'topic')
        except names.InvalidNameError:
            raise ValueError(f"Failed to create {self.what} due to invalid topic name '{topic}'") from None

    def _join(self, kind: Any, message_type: type, given: Given) -> Any:
        profile = qos.profile_of(given)
        try:
            self.endpoint = kind(self.node.context.domain, self.node.entry, dds_topic(self._topic, profile),
                                 message_type, profile)
        except TopicTypeError as error:
            raise RCLError(f'Failed to create {self.what}: create_{self.what}() called for existing {error}') from None
        Destroyable.__init__(self)
        return self.endpoint

    def _destroy(self) -> None:
        self.endpoint.leave()

    def get_topic_name(self) -> str:
        return self._topic

    def get_logger_name(self) -> str:
        return self.node.logger_name()


class Publisher(_TopicEnd):
    """Sends messages to a topic."""

    what = 'publisher'

    def __init__(self, node: Node, message_type: type, topic: str, profile: Given):
        super().__init__(node, topic)
        self.endpoint: Writer = self._join(Writer, message_type, profile)

    def _check(self, what: str) -> None:
        if not self.node.context.ok():
            raise RCLError(f"{what}: publisher's context is invalid")

    def publish(self, message: Any) -> None:
        self._check('Failed to publish')
        try:
            self.endpoint.write(message)
        except TooLongError as error:
            raise RCLError(f'Failed to publish: {error}') from None

    def publish_raw(self, data: bytes) -> None:
        self.publish(rclpy_deserialize(data, self.endpoint.message_type))

    def get_subscription_count(self) -> int:
        self._check('failed to get subscription count')
        return len(self.endpoint.matched)

    def wait_for_all_acked(self, _: qos.rcl_duration_t) -> bool:
        self._check('Failed to wait for all acknowledgements')
        return True


class Subscription(_TopicEnd):
    """Receives messages from a topic."""

    what = 'subscription'

    def __init__(self, node: Node, message_type: type, topic: str, profile: Given):
        super().__init__(node, topic)
        self.endpoint: Reader = self._join(Reader, message_type, profile)

    def is_ready(self) -> bool:
        return bool(self.endpoint.queue)

    def take_message(self, message_type: type, raw: bool) -> tuple[Any, dict[str, int | None]] | None:
        with changed:
            sample = self.endpoint.take()
        if sample is None:
            return None
        taken = rclpy_serialize(sample.message, message_type) if raw else copy(sample.message, message_type)
        return taken, {
            'source_timestamp': sample.published_ns, 'received_timestamp': sample.received_ns,
            'publication_sequence_number': sample.number, 'reception_sequence_number': None}

    def get_publisher_count(self) -> int:
        return len(self.endpoint.matched)


def rclpy_assert_liveliness(_: Publisher) -> None:
    """A publisher is alive as long as it is there."""
