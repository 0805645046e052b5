"""A context for each test, in a domain that no other process is in, and waiting by spinning."""

import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import rclpy
from builtin_interfaces.msg import Time
from rcl_interfaces.msg import Log
from rcl_interfaces.srv import GetParameters
from rclpy.context import Context
from rclpy.executors import Executor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from rclpy.type_support import check_for_type_support

from param_tools.ros import domain

LIMIT_SEC = 60.0


class Ros:
    """A context, an executor, and the nodes of one test."""

    def __init__(self) -> None:
        self.context = Context()
        self.executor: Executor | None = None
        self.nodes: list[Node] = []

    def init(self, *ros_args: str) -> None:
        """Begin; done by the first node, if a test has no arguments for it."""
        rclpy.init(args=['program', '--ros-args', *ros_args], context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)

    def node(self, name: str = 'node', **options: Any) -> Any:
        """Return a node that ``wait`` spins."""
        if self.executor is None:
            self.init()
        node = Node(name, context=self.context, **options)
        self.nodes.append(node)
        self.executor.add_node(node)
        return node

    def wait(self, condition: Callable[[], object]) -> None:
        """Spin until something is true."""
        end = time.monotonic() + LIMIT_SEC
        while not condition():
            assert time.monotonic() < end, 'it has not become true'
            self.executor.spin_once(timeout_sec=0.05)

    def result(self, future: Future) -> Any:
        """Spin until a future is done, and return its result."""
        self.wait(future.done)
        return future.result()

    def call(self, node: Node, service_type: Any, service: str, **fields: Any) -> Any:
        """Call a service from a node, and return the response."""
        client = node.create_client(service_type, service)
        self.wait(client.service_is_ready)
        response = self.result(client.call_async(service_type.Request(**fields)))
        node.destroy_client(client)
        return response

    def end(self) -> None:
        """Shut everything down."""
        for node in self.nodes:
            node.destroy_node()
        if self.executor is not None:
            self.executor.shutdown()
        self.context.try_shutdown()


@pytest.fixture(scope='session', autouse=True)
def own_domain() -> None:
    """Keep nodes of other processes out of the graph."""
    domain.choose()


@pytest.fixture(scope='session', autouse=True)
def type_support() -> None:
    """Import the compiled messages that tests hand to the layer itself; rclpy does so when it creates a handle."""
    for message_type in (Log, Time):
        check_for_type_support(message_type)
    check_for_type_support(GetParameters)


@pytest.fixture
def ros() -> Iterator[Ros]:
    ros = Ros()
    yield ros
    ros.end()
