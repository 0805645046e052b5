"""ROS in the background of a Python process: one rclpy context, one executor, one thread.

A notebook kernel is busy with cells, so nobody is left to spin a node. A BackgroundExecutor runs rclpy's own
SingleThreadedExecutor, which is what ``rclpy.spin`` runs, in a thread: code that works here works on a robot, and what
hangs there hangs here. It survives exceptions in callbacks, ends endless loops in them, and offers the feeds that tools
listen to: /rosout, /parameter_events, nodes coming and going. ``stage`` holds the one executor of a process.

Tools need three things of it: ``run`` a function in its thread, ``services`` to call, and the feeds.
"""

import contextlib
import functools
import linecache
import sys
import threading
import time
import traceback
import weakref
from collections import deque
from collections.abc import Callable, Coroutine, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar, cast

import rclpy
from rcl_interfaces.msg import Log, ParameterEvent, ParameterValue
from rclpy import executors, task, utilities
from rclpy.client import Client
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events
from rclpy.service import Service
from rclpy.signals import SignalHandlerOptions
from rclpy.subscription import Subscription
from rclpy.timer import Timer

from param_tools.errors import ExecutorError, StuckError
from param_tools.rcl_in_python.arguments import Arguments, parse_remap, remapped
from param_tools.ros import domain, host, interrupts, no_input, rclpy_private, tutorial_lines
from param_tools.ros.graph import Incarnations, incarnations, nodes_in_graph
from param_tools.ros.listeners import Listeners
from param_tools.ros.node_log import NodeLog
from param_tools.ros.services import Services
from param_tools.ros.waiting import wait_for

# A name that starts with an underscore is hidden: ``ros2 node list`` does not show it.
TOOL_NODE_NAME = '_param_tools'
TICK_PERIOD_SEC = 0.5
STOP_TIMEOUT_SEC = 3.0
# How long a callback may take to end once an exception has been raised in it.
INTERRUPT_TIMEOUT_SEC = 3.0
# A callback that has kept the thread for so long, when an answer does not come in time, is the reason.
_BUSY_SEC = 2.0
# How long a caller that needs the thread waits at least, even if a callback has kept it for long already.
_LEAST_PATIENCE_SEC = 0.3
_KINDS = {Timer: 'timer', Subscription: 'subscription', Service: 'service', Client: 'client'}

T = TypeVar('T')


class _CallbackInterrupted(BaseException):
    """Raised inside a callback that does not return, to get the executor's thread back."""

    def __str__(self) -> str:
        return 'this callback did not return, so it was interrupted: the executor has one thread for all nodes'


@dataclass(frozen=True, eq=False)
class Callback:
    """A callback of a node on the stage, as the executor runs it."""

    node: Node
    node_name: str
    """Fully qualified."""
    kind: str
    """'timer', 'subscription', 'service' or 'client'."""
    function: Callable[..., Any]
    parameter_service: str = ''
    """The name of the parameter service that it serves, if it is rclpy's own."""

    def __str__(self) -> str:
        if self.parameter_service:
            return f'the service {self.parameter_service} of {self.node_name}'
        return f'the {self.kind} callback {function_name(self.function)} of {self.node_name}'


def function_name(function: Callable[..., Any]) -> str:
    """Return the name that a function's author gave it, also if it is in a ``functools.partial``."""
    return str(getattr(getattr(function, 'func', function), '__name__', type(function).__name__))


@dataclass
class Failure:
    """An exception that left a callback, and how often it did."""

    error: BaseException
    """The first one."""
    callback: Callback | None
    """None if it is not the callback of a node on the stage."""
    times: int = 1
    times_shown: int = 0

    def __str__(self) -> str:
        """Name the callback."""
        return 'a callback' if self.callback is None else str(self.callback)

    def is_repeated_by(self, error: BaseException, callback: Callback | None) -> bool:
        """True if the same callback of the same node raised the same type of exception, in the same line."""
        return (type(error) is type(self.error) and _line_of(error) == _line_of(self.error)
                and _identity(callback) == _identity(self.callback))


def _identity(callback: Callback | None) -> tuple[object, ...]:
    return () if callback is None else (id(callback.node), callback.kind, callback.function)


def _line_of(error: BaseException) -> tuple[str, int]:
    """Return the file and the line in which an exception came up."""
    step = error.__traceback__
    while step is not None and step.tb_next is not None:
        step = step.tb_next
    return ('', 0) if step is None else (step.tb_frame.f_code.co_filename, step.tb_lineno)


# In a page a module without its source has another __file__ than its lines.
_PLUMBING = (function_name.__code__.co_filename, executors.__file__, task.__file__,
             interrupts.raise_in.__code__.co_filename)


def _describe(error: BaseException) -> str:
    """Return an exception and the lines it went through, without those that called or interrupted the callback."""
    described = traceback.TracebackException.from_exception(error)
    described.stack[:] = [step for step in described.stack if step.filename not in _PLUMBING]
    return ''.join(described.format()).rstrip('\n')


class _WatchedExecutor(SingleThreadedExecutor):
    """A SingleThreadedExecutor that knows what it runs."""

    running: tuple[Any, Any] | None = None
    """The entity (a timer, a service, …) whose callback runs or has raised the latest exception, and its node."""
    began = 0.0
    thread = 0
    before_callback: Callable[[], None]

    def wait_for_ready_callbacks(self, *args: Any, **options: Any) -> Any:
        """Wait for the next callback, as rclpy does, and note which one it is."""
        self.running = None
        found: tuple[Any, Any, Any] = super().wait_for_ready_callbacks(*args, **options)
        self.running, self.began, self.thread = found[1:], time.monotonic(), threading.get_ident()
        self.before_callback()
        return found


class BackgroundExecutor:
    """Spins nodes in a thread of its own until it is stopped. Get it from ``start()``."""

    def __init__(self) -> None:
        self.domain_id = domain.choose()
        self.node_log = NodeLog()
        self.failures: deque[Failure] = deque(maxlen=100)
        """The exceptions that callbacks raised, oldest first; those that repeat are counted in one."""
        self._nodes: list[Node] = []
        self._coroutines: weakref.WeakSet[Coroutine[Any, Any, object]] = weakref.WeakSet()
        self._first_values: dict[str, dict[str, ParameterValue]] = {}
        self._event_listeners: Listeners[[ParameterEvent]] = Listeners()
        self._graph_listeners: Listeners[[]] = Listeners()
        self._incarnations: Incarnations = frozenset()
        self._names: list[tuple[str, str]] = []
        self._stopping = False
        self._next_tick = 0.0
        # The callback that was interrupted last, with its line, and when.
        self._interrupted = '', 0.0
        self._objection = self._error_if_asked
        with contextlib.ExitStack() as undo:  # a process that may open no more files, say, gets no participant of DDS
            # Without NO, the kernel's "interrupt" button would shut the context down. The console and file logs
            # are off because a thread's output lands in whichever cell is running: node_log reads /rosout instead.
            rclpy.init(args=['--ros-args', '--disable-stdout-logs', '--disable-external-lib-logs'],
                       domain_id=self.domain_id, signal_handler_options=SignalHandlerOptions.NO)
            undo.callback(utilities.try_shutdown)
            self.context = utilities.get_default_context()
            self._executor = _WatchedExecutor(context=self.context)
            self._executor.before_callback = functools.partial(no_input.forbid, self._objection)
            self.tool_node = Node(TOOL_NODE_NAME, start_parameter_services=False, enable_rosout=False)
            undo.callback(self.tool_node.destroy_node)
            self.tool_node.create_subscription(
                Log, '/rosout', self.node_log.receive,
                QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL))
            self.tool_node.create_subscription(
                ParameterEvent, '/parameter_events', self._event_listeners.call, qos_profile_parameter_events)
            self._executor.add_node(self.tool_node)
            self.services = Services(self)
            self._let_go_of_rclpy = undo.enter_context(contextlib.ExitStack())
            self._let_go_of_rclpy.callback(tutorial_lines.replace(self, self._executor))
            self._let_go_of_rclpy.callback(no_input.allow, self._objection)
            self._loop = host.host.loop(self._spin_once, lambda: self._stopping or not self.context.ok(),
                                        'ros-background-executor', TICK_PERIOD_SEC)
            self._loop.start()
            undo.pop_all()

    @property
    def is_running(self) -> bool:
        """True if the loop spins, on a context that is alive."""
        return not self._loop.has_ended and self.context.ok() and not self._stopping

    @property
    def errors(self) -> list[BaseException]:
        """The exceptions that callbacks raised, oldest first, each once."""
        return [failure.error for failure in list(self.failures)]

    @property
    def nodes(self) -> tuple[Node, ...]:
        """The nodes that were added, oldest first."""
        return tuple(self._nodes)

    def __repr__(self) -> str:
        names = ', '.join(_full_name(node) for node in self._nodes) or 'no node'
        if not self.is_running:
            return '<BackgroundExecutor: stopped>'
        return f'<BackgroundExecutor: spinning {names}, on {utilities.get_rmw_implementation_identifier()}>'

    # -- nodes ------------------------------------------------------------------------------------------

    def add(self, node_class: type[Node], *args: Any, ros_args: Sequence[str] = (), **kwargs: Any) -> Node:
        """Create a node and spin it. A node of the same name is destroyed first.

        :param node_class: A class derived from rclpy.node.Node; further arguments go to its constructor.
        :param ros_args: What would come after ``--ros-args`` on its command line, e.g.
            ``['-p', 'max_speed_rpm:=120']`` or ``['--params-file', path]``.
        :return: The node. Change it through its services (see ``client``), not through its own setters:
            rclpy's parameter storage has no lock, and the executor's thread is reading it.
        :raises ExecutorError: this executor is stopped, or node_class is not a class of nodes.
        """
        self._require_running()
        if not (isinstance(node_class, type) and issubclass(node_class, Node)):
            raise ExecutorError(f'add() takes a class derived from rclpy.node.Node, not {node_class!r}')
        node = node_class.__new__(node_class)
        with rclpy_private.before_init_of(node, functools.partial(self._make_room, ros_args)):
            try:
                node.__init__(*args, **kwargs)  # type: ignore[misc]
                name = _full_name(node)  # fails if the class does not call Node.__init__
            except BaseException:
                # Half a node still has services on the network that nobody would ever serve.
                rclpy_private.destroy_unfinished(node)
                raise
        # The learner may call it, in any thread.
        node.destroy_node = functools.partial(self._destroy, node, node.destroy_node)  # type: ignore[method-assign]
        parameters = cast(dict[str, Parameter], node.get_parameters_by_prefix(''))  # rclpy says that these are values
        self._first_values[name] = {each: parameter.get_parameter_value() for each, parameter in parameters.items()}
        # Known before it is spun: its first callback, and listeners to the graph, may look for it.
        self._nodes.append(node)
        self.run(lambda: self._executor.add_node(node), f'add {name}')
        if self.is_running:
            self.run(self._tell_of_nodes, 'look at the graph')
        return node

    def first_values(self, name: str) -> dict[str, ParameterValue] | None:
        """Return what the parameters of a node had when it was added; None if no node of this name is here."""
        return self._first_values.get(name)

    def _make_room(self, ros_args: Sequence[str], node_name: str, options: dict[str, Any]) -> None:
        """Destroy the node whose name a node is about to get, and pass that one its ros_args.

        A node's name is known only when its constructor calls that of Node. Two nodes of one name must never exist at
        once: either or both would obey a set, and the second would log nothing.
        """
        options['cli_args'] = [*(options.get('cli_args') or ()), *(['--ros-args', *ros_args] if ros_args else [])]
        rules = Arguments([rule for word in options['cli_args'] if (rule := parse_remap(word))])
        name = remapped([rules], 'name', node_name, node_name, '')
        namespace = remapped([rules], 'namespace', options.get('namespace') or '', name, '')
        self.remove(f'/{namespace.strip("/")}/{name}'.replace('//', '/'))

    def remove(self, node: Node | str) -> bool:
        """Stop spinning a node and destroy it.

        :param node: The node, or its fully qualified name.
        :return: True if there was such a node.
        """
        doomed = [each for each in self._nodes if node is each or _full_name(each) == node]
        for each in doomed:
            each.destroy_node()
        if doomed and self.is_running:
            self.run(self._check_graph, 'look at the graph')
        return bool(doomed)

    def remove_all(self) -> None:
        """Destroy all nodes that were added."""
        for node in reversed(self.nodes):
            self.remove(node)

    def clear(self) -> None:
        """Destroy all nodes that were added, and forget what was logged and what failed.

        :raises StuckError: a callback does not return.
        """
        self.remove_all()
        self.run(self.node_log.clear, 'clear the log')
        self.failures.clear()

    def _destroy(self, node: Node, destroy: Callable[[], None]) -> None:
        """Take a node off the stage, if it is there, and call the function that destroys it."""
        if node not in self._nodes or not self.is_running:
            destroy()
            return

        def take_off() -> Callable[[], None]:
            end_service = rclpy_private.keep_type_description_service(node)
            if node in self._nodes:
                self._nodes.remove(node)
                self._first_values.pop(_full_name(node), None)
            self._executor.remove_node(node)
            destroy()
            rclpy_private.drop_coroutines(self._executor, node)
            return end_service

        # The service ends in a turn of its own: by then the executor has let go of it.
        if self.in_thread():  # a callback runs now, maybe the node's own
            self._executor.create_task(take_off())
        else:
            what = f'destroy {_full_name(node)}'
            self.run(self.run(take_off, what), what)

    # -- the thread -------------------------------------------------------------------------------------

    def run(self, function: Callable[[], T], what: str, timeout_sec: float = STOP_TIMEOUT_SEC) -> T:
        """Run a function in the executor's thread, between two callbacks, and return its result.

        A callback that does not return within the time limit is interrupted with an exception.

        :param what: Names the work in the error.
        :raises StuckError: a callback, or the function, neither returns nor can be interrupted. The function may still
            run, when the callback returns.
        """
        if self.in_thread():
            return function()
        values: list[T] = []
        errors: list[BaseException] = []
        finished = threading.Event()

        def work() -> None:
            try:
                values.append(function())
            except BaseException as error:
                errors.append(error)
            finally:
                finished.set()

        self._require_running()
        self._executor.create_task(work)
        patience_sec = max(timeout_sec - self.busy_sec, min(timeout_sec, _LEAST_PATIENCE_SEC))
        if not wait_for(finished, patience_sec) and not self._interrupt(finished):
            running = self.running
            raise StuckError(f'cannot {what}: {_sentence(running) if running else "A function"} does not return and '
                             f'cannot be interrupted. Call start() again: it begins anew, without any node')
        if errors:
            raise errors[0]
        return values[0]

    def create_task(self, task: Coroutine[Any, Any, object] | Callable[[], object]) -> None:
        """Run a function, or a coroutine that awaits rclpy's futures, in the executor's thread, between callbacks."""
        if isinstance(task, Coroutine):
            if self.is_running:
                self._coroutines.add(task)
            else:
                task.close()
        self._require_running()
        self._executor.create_task(task)

    def _spin_once(self, wait_sec: float) -> bool:
        """Run the next callback that is due within a time, and return whether there was one."""
        # Only in the main thread, where everybody waits for the callback: a thread of its own has no limit, and run()
        # interrupts the callback when somebody needs the thread.
        with interrupts.time_limit(STOP_TIMEOUT_SEC, _CallbackInterrupted):
            return self._run_next(wait_sec)

    def _run_next(self, wait_sec: float) -> bool:
        try:
            self._executor.spin_once(timeout_sec=wait_sec)
            if time.monotonic() >= self._next_tick:
                self._next_tick = time.monotonic() + TICK_PERIOD_SEC
                self._check_graph()
                self.services.expire()
        except ExternalShutdownException:
            pass
        except BaseException as error:
            # Also what a callback raises: rclpy would end spin() here, and with it every node.
            if self.context.ok() and not self._stopping and not self._is_of_removed_node():
                self._show_once(error)
        return self._executor.running is not None

    def _is_of_removed_node(self) -> bool:
        """True if what runs awaited something while its node was removed: rclpy goes on with it in the same round."""
        node = self._executor.running[1] if self._executor.running else None
        return node is not None and node is not self.tool_node and node not in self._nodes

    def in_thread(self) -> bool:
        """True in the executor's thread, which must not wait for anything that an executor brings."""
        return self._loop.is_current()

    @property
    def running(self) -> Callback | None:
        """The callback that runs now, or that has raised the latest exception; None if it is not a node's."""
        if self._executor.running is None or self._executor.running[1] is None:
            return None
        entity, node = self._executor.running
        if type(entity) not in _KINDS or node is self.tool_node:
            return None
        is_rclpys = isinstance(getattr(entity.callback, '__self__', None), ParameterService)
        return Callback(node, _full_name(node), _KINDS[type(entity)], entity.callback,
                        entity.srv_name.rpartition('/')[2] if is_rclpys else '')

    @property
    def busy_sec(self) -> float:
        """For how long the callback that runs now has been running; 0.0 if none runs."""
        return 0.0 if self._executor.running is None else time.monotonic() - self._executor.began

    def free(self) -> bool:
        """End a callback that keeps the thread for longer than anybody waits for an answer.

        :return: True if there was one, and it has ended.
        """
        if self.busy_sec <= _BUSY_SEC or not self.is_running:
            return False
        try:
            self.run(lambda: None, 'go on')
        except StuckError:
            return False
        return True

    def culprit(self, since: float) -> str:
        """Say which callback, in which line, keeps the thread or was interrupted since a monotonic time; or nothing."""
        if self.busy_sec > _BUSY_SEC and (running := self.running):
            name = _with_line(running, traceback.walk_stack(sys._current_frames()[self._executor.thread]))
            return (f'{name} does not return, and keeps the one thread of all nodes. If it never does, start() begins '
                    f'anew, without any node')
        name, when = self._interrupted
        return f'{name} did not return, and kept the one thread of all nodes' if when > since else ''

    def _interrupt(self, has_ended: threading.Event) -> bool:
        """Raise an exception in the callback that keeps the thread, if it runs Python code; return whether it ended.

        An exception that comes while Python runs a ``__del__``, and rclpy's loggers have one, is printed and lost. So
        it is raised a second time.
        """
        return any(self._loop.interrupt(_CallbackInterrupted)
                   and wait_for(has_ended, INTERRUPT_TIMEOUT_SEC) for _ in range(2))

    def _error_if_asked(self) -> ExecutorError | None:
        return None if not self.in_thread() else ExecutorError(
            'a callback cannot ask with input(): while it waits for you to type, no node gets a turn. Ask in a cell, '
            'and give the node the answer as a parameter')

    # -- exceptions in callbacks ------------------------------------------------------------------------

    def _show_once(self, error: BaseException) -> None:
        callback = self.running
        if isinstance(error, _CallbackInterrupted):
            self.services.give_a_turn((callback.node_name, callback.parameter_service) if callback else ('', ''))
            if callback:
                frames = reversed([*traceback.walk_tb(error.__traceback__)])
                self._interrupted = _with_line(callback, frames), time.monotonic()
        if callback is not None and callback.node not in self._nodes:
            return  # a callback or an answer was due when its node was removed, and has found its handles gone
        failure = self._count(error, callback)
        if (callback is not None and callback.parameter_service and not isinstance(error, _CallbackInterrupted)
                and self.services.fail(callback.node_name, callback.parameter_service, error)):
            return  # the caller raises it
        failure.times_shown += 1
        if failure.times_shown == 1:
            print(f'{_sentence(failure)} raised an exception; the node keeps running.\n{_describe(error)}',
                  file=sys.stderr)
        elif failure.times_shown == 2:
            print(f'The same {type(error).__name__} again in {failure}. From now on, repeats are only counted, in the '
                  f'failures of the executor.', file=sys.stderr)

    def _count(self, error: BaseException, callback: Callback | None) -> Failure:
        for failure in self.failures:
            if failure.is_repeated_by(error, callback):
                failure.times += 1
                return failure
        self.failures.append(Failure(error, callback))
        return self.failures[-1]

    # -- the end ----------------------------------------------------------------------------------------

    @interrupts.held_back()
    def stop(self) -> None:
        """Stop spinning, destroy all nodes and shut the context down; safe to call more than once.

        A callback that never returns is left behind in its thread, with its context shut down.
        """
        # This order is not free: shutting down without joining the thread aborts the interpreter at its exit.
        self._stopping = True
        self._let_go_of_rclpy.close()
        self._executor.wake()
        has_ended = self._loop.join(STOP_TIMEOUT_SEC) or (
            self._loop.interrupt(_CallbackInterrupted) and self._loop.join(INTERRUPT_TIMEOUT_SEC))
        if has_ended:
            self._executor.shutdown()
            for each in list(self._coroutines):  # of one that has not begun, Python would say that nobody awaited it
                each.close()
        for node in [*reversed(self._nodes), self.tool_node]:
            if has_ended:
                node.destroy_node()
            else:
                # Left as they are, other nodes would see them for as long as this process lives, and get no answer.
                rclpy_private.destroy_by_force(node)
        self._nodes.clear()
        if utilities.get_default_context() is self.context:
            utilities.try_shutdown()  # without naming the context, so that the next init gets a new default one

    def _require_running(self) -> None:
        if not self.is_running:
            raise ExecutorError('this executor is stopped: call start() for a new one')

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
        """Return an identity of each node of this name; a restarted node has another one.

        :param node: Fully qualified name.
        :return: The DDS identities of their publishers on /parameter_events; every node has one.
        """
        return frozenset(gid for name, gid in self._incarnations if name == node)

    def _check_graph(self) -> bool:
        """Tell the listeners if the graph has changed, and return whether it has."""
        nodes, names = incarnations(self.tool_node), nodes_in_graph(self.tool_node)
        # A name comes and goes apart from what tells one node of this name from the next.
        if (nodes, names) == (self._incarnations, self._names):
            return False
        before, self._incarnations, self._names = self._incarnations, nodes, names
        self.services.graph_changed(before, nodes)
        self._graph_listeners.call()
        return True

    def _tell_of_nodes(self) -> None:
        # The graph may have reported a node while its constructor ran, when nobody could find it among the nodes yet.
        if not self._check_graph():
            self._graph_listeners.call()


def _sentence(callback: Callback | Failure) -> str:
    """Return the name of a callback as the beginning of a sentence."""
    name = str(callback)
    return name[0].upper() + name[1:]


def _with_line(callback: Callback, frames: Iterable[tuple[Any, int]]) -> str:
    """Return the name of a callback, with the innermost line that stands where the class of its node does."""
    for frame, number in frames:
        if frame.f_globals.get('__name__') == type(callback.node).__module__:
            line = linecache.getline(frame.f_code.co_filename, number, frame.f_globals).strip()
            return f'{callback}, in line {number}' + (f' (`{line}`)' if line else '') + ','
    return str(callback)


def _full_name(node: Node) -> str:
    return node.get_fully_qualified_name()
