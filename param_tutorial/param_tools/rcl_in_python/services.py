"""Services and their clients: a request goes to every server of that name, and the answer to the one that asked."""

from dataclasses import dataclass
from typing import Any

from param_tools.rcl_in_python import names, qos
from param_tools.rcl_in_python.exceptions import NotImplementedError as NotImplementedErrorOfROS
from param_tools.rcl_in_python.exceptions import RCLError
from param_tools.rcl_in_python.graph import Reader, Sample, TopicTypeError, Writer, dds_service
from param_tools.rcl_in_python.messages import TooLongError, copy
from param_tools.rcl_in_python.nodes import Node
from param_tools.rcl_in_python.topics import Given
from param_tools.rcl_in_python.waiting import Destroyable, changed


@dataclass(frozen=True)
class rmw_request_id_t:
    """Which request, and of whom."""

    sequence_number: int
    client: 'Reader | None' = None
    """Where the answer goes."""


@dataclass(frozen=True)
class rmw_service_info_t:
    """When a request or an answer was sent."""

    source_timestamp: int
    received_timestamp: int
    request_id: rmw_request_id_t


class _ServiceEnd(Destroyable):
    """A writer and a reader."""

    reader: Reader
    writer: Writer

    def __init__(self, node: Node, name: str, what: str, invalid: str):
        self.node = node
        node.check_valid(f'failed to create {what}')
        try:
            self._name = node.resolve(name, 'service')
        except names.InvalidNameError as error:
            raise ValueError(f"failed to create {what} due to invalid {invalid} name '{name}': {error}") from None

    def _join(self, what: str, service_type: Any, requests: type, replies: type, profile: qos.Profile,
              ) -> tuple[Any, Any]:
        domain, entry = self.node.context.domain, self.node.entry
        topic_of_requests, topic_of_replies = dds_service(self._name)
        with changed:
            try:
                ends = (requests(domain, entry, topic_of_requests, service_type.Request, profile),
                        replies(domain, entry, topic_of_replies, service_type.Response, profile))
            except TopicTypeError as error:
                raise RCLError(
                    f'failed to create {what}: create_{what}() called for existing request {error}') from None
            Destroyable.__init__(self)
        return ends

    def _destroy(self) -> None:
        self.reader.leave()
        self.writer.leave()

    def is_ready(self) -> bool:
        return bool(self.reader.queue)

    def get_logger_name(self) -> str:
        return self.node.logger_name()

    def configure_introspection(self, *_: object) -> None:
        raise NotImplementedErrorOfROS('service introspection is not part of rclpy in Python')


def _info(sample: Sample) -> rmw_service_info_t:
    return rmw_service_info_t(sample.published_ns, sample.received_ns, sample.header)


def _send(what: str, writer: Writer, message: Any, header: rmw_request_id_t, to: Reader | None = None) -> None:
    try:
        writer.write(message, header, to)
    except TooLongError as error:
        raise RCLError(f'{what}: {error}') from None


class Service(_ServiceEnd):
    """Answers requests."""

    def __init__(self, node: Node, service_type: Any, name: str, profile: Given):
        super().__init__(node, name, 'service', 'topic')
        self._profile = qos.profile_of(profile)
        self.reader, self.writer = self._join('service', service_type, Reader, Writer, self._profile)

    @property
    def name(self) -> str:
        return self._name

    @property
    def qos(self) -> dict[str, Any]:
        return self._profile.to_dict()

    def service_take_request(self, request_type: type) -> tuple[Any, rmw_service_info_t | None]:
        with changed:
            sample = self.reader.take()
        if sample is None:
            return None, None
        return copy(sample.message, request_type), _info(sample)

    def service_send_response(self, response: Any, header: rmw_request_id_t) -> None:
        _send('failed to send response', self.writer, response, header, header.client)


class Client(_ServiceEnd):
    """Sends requests."""

    def __init__(self, node: Node, service_type: Any, name: str, profile: Given):
        super().__init__(node, name, 'client', 'service')
        self.writer, self.reader = self._join('client', service_type, Writer, Reader, qos.profile_of(profile))
        self._sent = 0

    @property
    def service_name(self) -> str:
        return self._name

    def service_server_is_available(self) -> bool:
        self.node.check_valid('failed to check service availability')
        with changed:
            servers = {each.node for each in self.writer.matched}
            return any(each.node in servers for each in self.reader.matched)

    def send_request(self, request: Any) -> int:
        with changed:
            self._sent += 1
            _send('failed to send request', self.writer, request, rmw_request_id_t(self._sent, self.reader))
            return self._sent

    def take_response(self, response_type: type) -> tuple[rmw_service_info_t | None, Any]:
        with changed:
            sample = self.reader.take()
        if sample is None:
            return None, None
        return _info(sample), copy(sample.message, response_type)
