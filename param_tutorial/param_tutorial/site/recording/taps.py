"""Listening to one node between two questions: what it logged, and what it published on /parameter_events."""

import threading
import time

from rcl_interfaces.msg import ParameterEvent
from rclpy.node import Node

from param_tools.ros import stage
from param_tools.ros.node_log import LogLine
from param_tutorial.views.events import changes_in

_MARK = 'param_tutorial: end of an answer'
_TIMEOUT_SEC = 5.0


class NodeLogTap:
    """The lines that a node logs, cut into batches; for nodes of this process only."""

    def __init__(self, node: Node):
        self._node = node
        self._lines: list[str] = []
        self._batches: list[list[str]] = []
        self._cuts = 0
        self._arrived = threading.Condition()
        self.stop = stage.current().node_log.on_line(self._take)

    def _take(self, line: LogLine) -> None:
        if line.logger != self._node.get_logger().name:
            return
        if line.text != _MARK:
            self._lines.append(str(line))
            return
        with self._arrived:
            self._batches.append(self._lines)
            self._lines = []
            self._arrived.notify_all()

    def cut(self) -> int:
        """End a batch here, and return its number; its lines may still be on their way."""
        # What one publisher sends keeps its order: when the mark is here, so is all that came before.
        self._node.get_logger().fatal(_MARK)
        self._cuts += 1
        return self._cuts - 1

    def batch(self, number: int) -> list[str]:
        """Wait for the lines of a batch, and return them, oldest first.

        :raises RuntimeError: they do not arrive.
        """
        with self._arrived:
            if not self._arrived.wait_for(lambda: len(self._batches) > number, _TIMEOUT_SEC):
                raise RuntimeError(f'the log of {self._node.get_name()} does not arrive')
            return self._batches[number]


class EventTap:
    """What a node publishes on /parameter_events."""

    def __init__(self, node: str):
        self._node = node
        self._begin_ns = time.time_ns()
        self._events: list[ParameterEvent] = []
        self._arrived = threading.Condition()
        self.stop = stage.current().on_parameter_event(self._take)

    def _take(self, event: ParameterEvent) -> None:
        # What was published before may still be on its way; in simulated time nobody can tell.
        is_old = 0 < event.stamp.sec * 10**9 + event.stamp.nanosec < self._begin_ns
        if event.node == self._node and not is_old:
            with self._arrived:
                self._events.append(event)
                self._arrived.notify_all()

    def rows(self, count: int) -> list[list[str]]:
        """Wait for so many messages, and return what they say as an EventView writes it: what, parameter, value.

        :raises RuntimeError: they do not arrive.
        """
        with self._arrived:
            if not self._arrived.wait_for(lambda: len(self._events) >= count, _TIMEOUT_SEC):
                raise RuntimeError(f'{self._node} published {len(self._events)} changes and not {count}')
            events, self._events = self._events, []
        return [[change.kind, change.name, '' if change.kind == 'deleted' else repr(change.value)]
                for event in events for change in changes_in(event)]


def node_here(name: str) -> Node | None:
    """Return the node of this process that has a full name, if there is one."""
    return next((node for node in stage.current().nodes if node.get_fully_qualified_name() == name), None)


def wait_for_logs() -> None:
    """Wait until all that the nodes of this process have logged so far has arrived."""
    for node in stage.current().nodes:
        tap = NodeLogTap(node)
        tap.batch(tap.cut())
        tap.stop()


def without_marks(lines: list[str]) -> list[str]:
    """Return lines of a log without those that taps have put there."""
    return [line for line in lines if _MARK not in line]
