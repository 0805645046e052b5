"""ROS in the background of a Python process: one rclpy context, one executor, one thread.

A notebook kernel is busy with cells, so nobody is left to spin a node. A BackgroundExecutor spins nodes in a thread
of its own, survives exceptions in their callbacks, and offers the feeds that tools listen to: /rosout,
/parameter_events, nodes coming and going. ``stage`` holds the one executor of a process.
"""

import ctypes
import functools
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import rclpy
from rcl_interfaces.msg import Log, ParameterEvent
from rclpy.executors import ExternalShutdownException
from rclpy.experimental.events_executor import EventsExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events
from rclpy.service import Service
from rclpy.signals import SignalHandlerOptions

from param_tutorial.errors import ExecutorError
from param_tutorial.runtime import domain
from param_tutorial.runtime.graph import incarnations
from param_tutorial.runtime.listeners import Listeners
from param_tutorial.runtime.node_log import NodeLog
from param_tutorial.runtime.services import Services

# A name that starts with an underscore is hidden: ``ros2 node list`` does not show it.
TOOL_NODE_NAME = '_param_tutorial'
GRAPH_PERIOD_SEC = 0.5
STOP_TIMEOUT_SEC = 3.0

T = TypeVar('T')


class _CallbackInterrupted(BaseException):
    """Raised inside a callback that does not return, to get the executor's thread back."""

    def __str__(self) -> str:
        return 'this callback did not return, so it was interrupted: the executor has one thread for all nodes'


class BackgroundExecutor:
    """Spins nodes in a thread of its own until it is stopped. Get it from ``start()``."""

    def __init__(self):
        if rclpy.ok():
            raise ExecutorError('rclpy is initialised already in this process, by somebody else: call '
                                'rclpy.shutdown() first, then start() again')
        self.domain_id = domain.choose()
        # Without NO, the kernel's "interrupt" button would shut the context down. The console and file logs
        # are off because a thread's output lands in whichever cell is running: node_log reads /rosout instead.
        rclpy.init(args=['--ros-args', '--disable-stdout-logs', '--disable-external-lib-logs'],
                   domain_id=self.domain_id, signal_handler_options=SignalHandlerOptions.NO)
        self.context = rclpy.get_default_context()
        self.node_log = NodeLog()
        self.errors: deque[BaseException] = deque(maxlen=100)
        self._nodes: list[Node] = []
        self._event_listeners: Listeners[[ParameterEvent]] = Listeners()
        self._graph_listeners: Listeners[[]] = Listeners()
        self._incarnations: frozenset[tuple[str, bytes]] = frozenset()
        self._stopping = False
        # Answers in a third of the SingleThreadedExecutor's time. Its own spin() serves nothing in the wheel
        # of rclpy 7.1.6, so the thread below calls spin_once() with a time limit, which works.
        self._executor = EventsExecutor(context=self.context)
        self.tool_node = Node(TOOL_NODE_NAME, start_parameter_services=False, enable_rosout=False)
        self.tool_node.create_subscription(
            Log, '/rosout', self.node_log.receive,
            QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.tool_node.create_subscription(
            ParameterEvent, '/parameter_events', self._event_listeners.call, qos_profile_parameter_events)
        self._executor.add_node(self.tool_node)
        self.services = Services(self.tool_node, lambda: threading.current_thread() is self._thread)
        self._thread = threading.Thread(target=self._spin, name='ros-background-executor', daemon=True)
        self._thread.start()

    @property
    def is_running(self) -> bool:
        """Does the thread spin, on a context that is alive?"""
        return self._thread.is_alive() and self.context.ok() and not self._stopping

    @property
    def nodes(self) -> tuple[Node, ...]:
        """The nodes that were added, oldest first."""
        return tuple(self._nodes)

    def __repr__(self) -> str:
        names = ', '.join(_full_name(node) for node in self._nodes) or 'no node'
        return f'<BackgroundExecutor: {"spinning " + names if self.is_running else "stopped"}>'

    # -- nodes ------------------------------------------------------------------------------------------

    def add(self, node_class: type[Node], *args: Any, ros_args: Sequence[str] = (), **kwargs: Any) -> Node:
        """Create a node and spin it. A node of the same name is destroyed first.

        :param node_class: A class derived from rclpy.node.Node; further arguments go to its constructor.
        :param ros_args: What would stand behind ``--ros-args`` on its command line, e.g.
            ``['-p', 'max_speed_rpm:=120']`` or ``['--params-file', path]``.
        :return: The node. Change it through its services (see ``client``), not through its own setters:
            rclpy's parameter storage has no lock, and the executor's thread is reading it.
        :raises ExecutorError: this executor is stopped, or node_class is not a class of nodes.
        """
        self._require_running()
        if not (isinstance(node_class, type) and issubclass(node_class, Node)):
            raise ExecutorError(f'add() takes a class derived from rclpy.node.Node, not {node_class!r}')
        managed = _managed(node_class)
        node = managed.__new__(managed)
        node._before_init = functools.partial(self._before_node_init, list(ros_args))
        try:
            node.__init__(*args, **kwargs)
        except BaseException:
            # Half a node still has services on the network that nobody would ever serve.
            if hasattr(node, '_Node__node'):
                node.destroy_node()
            raise
        # Known before it is spun: its first callback, and whoever is told of the graph, may look for it.
        self._nodes.append(node)
        self.run(lambda: self._executor.add_node(node), f'add {_full_name(node)}')
        self._check_graph_soon()
        return node

    def _before_node_init(self, ros_args: list[str], node_name: str, options: dict[str, Any]) -> None:
        """Make room for a node that is about to be created under this name, and pass its ros_args on."""
        options['cli_args'] = [*(options.get('cli_args') or ()), *(['--ros-args', *ros_args] if ros_args else ())]
        name, namespace = node_name, options.get('namespace') or '/'
        for argument in options['cli_args']:
            key, separator, value = argument.partition(':=')
            if separator and key in ('__node', '__name'):
                name = value
            elif separator and key == '__ns':
                namespace = value
        self.remove(f'/{namespace.strip("/")}/{name}'.replace('//', '/'))

    def remove(self, node: Node | str) -> bool:
        """Stop spinning a node and destroy it.

        :param node: The node, or its fully qualified name.
        :return: Was there such a node?
        """
        doomed = [each for each in self._nodes if node is each or _full_name(each) == node]
        for each in doomed:
            self._nodes.remove(each)
            self.run(functools.partial(self._destroy, each), f'remove {_full_name(each)}')
        if doomed:
            self._check_graph_soon()
        return bool(doomed)

    def remove_all(self) -> None:
        """Destroy all nodes that were added."""
        for node in reversed(self.nodes):
            self.remove(node)

    def _destroy(self, node: Node) -> None:
        self._executor.remove_node(node)
        node.destroy_node()

    # -- the thread -------------------------------------------------------------------------------------

    def run(self, function: Callable[[], T], what: str, timeout_sec: float = STOP_TIMEOUT_SEC) -> T:
        """Run a function in the executor's thread, between two callbacks, and give its result.

        A callback that does not return within the time limit is interrupted with an exception.

        :param what: Names the work in the error.
        :raises ExecutorError: the thread cannot be had even so.
        """
        if threading.current_thread() is self._thread:
            return function()
        outcome: dict[str, Any] = {}
        finished = threading.Event()

        def work():
            try:
                outcome['value'] = function()
            except BaseException as error:
                outcome['error'] = error
            finally:
                finished.set()

        self._require_running()
        self._executor.create_task(work)
        if not finished.wait(timeout_sec):
            self._interrupt_callback()
            if not finished.wait(timeout_sec):
                raise ExecutorError(f'cannot {what}: a callback keeps the executor busy and cannot be interrupted. '
                                    f'Restart the kernel')
        if 'error' in outcome:
            raise outcome['error']
        return outcome['value']

    def _spin(self) -> None:
        next_graph_check = 0.0
        while not self._stopping and self.context.ok():
            try:
                self._executor.spin_once(timeout_sec=GRAPH_PERIOD_SEC)
                if time.monotonic() >= next_graph_check:
                    next_graph_check = time.monotonic() + GRAPH_PERIOD_SEC
                    self._check_graph()
                    self.services.expire()
            except ExternalShutdownException:
                break
            except (Exception, _CallbackInterrupted) as error:
                # Also what a callback raises: rclpy would end spin() here, and with it every node.
                if self.context.ok() and not self._stopping:
                    self._show_once(error)

    def _interrupt_callback(self) -> None:
        ctypes.pythonapi.PyThreadState_SetAsyncExc(
            ctypes.c_ulong(self._thread.ident), ctypes.py_object(_CallbackInterrupted))

    def _show_once(self, error: BaseException) -> None:
        if self._is_of_a_removed_node(error):
            return
        self.errors.append(error)
        if self.services.take(error):
            return  # whoever made that call raises it
        text = ''.join(traceback.format_exception(error))
        print(f'A callback raised an exception; the node goes on.\n{text}', file=sys.stderr, end='')

    def _is_of_a_removed_node(self, error: BaseException) -> bool:
        """Was a callback or an answer due when its node was removed, and has found its handles gone?"""
        nodes = (*self._nodes, self.tool_node)
        for frame, _ in traceback.walk_tb(error.__traceback__):
            owner = frame.f_locals.get('self')
            if isinstance(owner, Node):
                return owner not in nodes
            if isinstance(owner, Service):
                return all(owner not in node.services for node in nodes)
        return False

    def stop(self) -> None:
        """Stop spinning, destroy all nodes and shut the context down. Twice is as good as once.

        :raises ExecutorError: a callback does not return and cannot be interrupted.
        """
        # This order is not free: shutting down without joining the thread aborts the interpreter at its exit.
        self._stopping = True
        if self._thread.is_alive() and self.context.ok():
            self._executor.create_task(lambda: None)
        self._thread.join(STOP_TIMEOUT_SEC)
        if self._thread.is_alive():
            self._interrupt_callback()
            self._thread.join(STOP_TIMEOUT_SEC)
            if self._thread.is_alive():
                raise ExecutorError('a callback keeps the executor busy and cannot be interrupted: '
                                    'restart the kernel')
        self._executor.shutdown()
        for node in [*reversed(self._nodes), self.tool_node]:
            node.destroy_node()
        self._nodes.clear()
        if self.context.ok():
            rclpy.shutdown()  # without naming the context, so that the next init gets a new default one

    def _require_running(self) -> None:
        if not self.is_running:
            raise ExecutorError('this executor is stopped: call param_tutorial.start() for a new one')

    # -- feeds ------------------------------------------------------------------------------------------

    def on_parameter_event(self, listener: Callable[[ParameterEvent], None]) -> Callable[[], None]:
        """Call a listener, in the executor's thread, with each message on /parameter_events.

        :return: Call it to stop listening.
        """
        return self._event_listeners.add(listener)

    def on_graph_change(self, listener: Callable[[], None]) -> Callable[[], None]:
        """Call a listener, in the executor's thread, soon after a node came, went or was replaced.

        :return: Call it to stop listening.
        """
        return self._graph_listeners.add(listener)

    def node_incarnations(self, node: str) -> frozenset[bytes]:
        """Tell which nodes of this name there are; a restarted node is another one.

        :param node: Fully qualified name.
        :return: For each, the DDS identity of its publisher on /parameter_events, which every node has.
        """
        return frozenset(gid for name, gid in self._incarnations if name == node)

    def _check_graph(self) -> None:
        nodes = incarnations(self.tool_node)
        if nodes != self._incarnations:
            self._incarnations = nodes
            self.services.graph_changed()
            self._graph_listeners.call()

    def _check_graph_soon(self) -> None:
        if self.is_running:
            self.run(self._check_graph, 'look at the graph')


def _full_name(node: Node) -> str:
    return node.get_fully_qualified_name()


@functools.cache
def _managed(node_class: type[Node]) -> type[Node]:
    """Derive a class that tells its name to the executor before the node exists.

    A node's name is known only when its constructor calls ``super().__init__(name)``, and two nodes of one
    name must never exist at once: both would obey every set, and the second would log nothing. The hook is
    a base class that comes just before Node in the method resolution order.
    """
    bases = (_NameHook,) if node_class is Node else (node_class, _NameHook)
    return type(node_class.__name__, bases, {
        '__module__': node_class.__module__, '__doc__': node_class.__doc__, '__qualname__': node_class.__qualname__})


class _NameHook(Node):
    def __init__(self, node_name: str, **options: Any):
        self._before_init(node_name, options)
        super().__init__(node_name, **options)
