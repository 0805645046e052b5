"""ROS in the background of a Python process: one rclpy context, one executor, one thread.

A notebook kernel is busy with cells, so nobody is left to spin a node. A BackgroundExecutor spins nodes in a thread
of its own, survives exceptions in their callbacks, and offers the feeds that tools listen to: /rosout,
/parameter_events, nodes coming and going. ``stage`` holds the one executor of a process.
"""

import contextlib
import signal
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import rclpy
from rcl_interfaces.msg import Log, ParameterEvent
from rclpy import utilities
from rclpy.executors import Executor, ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events
from rclpy.signals import SignalHandlerOptions

from param_tools.errors import ExecutorError, StuckError, WaitTimeoutError
from param_tools.ros import domain, interrupts, rclpy_private
from param_tools.ros.graph import Incarnations, incarnations, nodes_in_graph, note_arrival
from param_tools.ros.lean_messages import import_messages
from param_tools.ros.listeners import Listeners
from param_tools.ros.node_hooks import Callback, CallbackWatch, before_node_init, is_managed, prepare
from param_tools.ros.node_log import NodeLog
from param_tools.ros.output_guard import Guard
from param_tools.ros.services import Services
from param_tools.ros.waiting import within

# A name that starts with an underscore is hidden: ``ros2 node list`` does not show it.
TOOL_NODE_NAME = '_param_tutorial'
GRAPH_PERIOD_SEC = 0.5
STOP_TIMEOUT_SEC = 3.0
# An interrupted callback may have to wait for a busy processor before it ends. Only after this is it called stuck.
INTERRUPT_TIMEOUT_SEC = 3.0
# A callback that has not noticed by then that it is interrupted is not running Python: it sleeps, in time.sleep() say.
_NOTICE_TIMEOUT_SEC = 2.0
# A callback that has kept the thread for so long, when a request is not answered in time, is why.
_BUSY_SEC = 2.0
# How long a caller that needs the thread waits at least, even if a callback has kept it for long already.
_LEAST_PATIENCE_SEC = 0.3
# How long rclpy waits in a cell for what has no time limit of its own.
WAIT_LIMIT_SEC = 3.0

T = TypeVar('T')


class _CallbackInterrupted(BaseException):
    """Raised inside a callback that does not return, to get the executor's thread back."""

    is_noticed = False

    def __init__(self) -> None:
        _CallbackInterrupted.is_noticed = True

    def __str__(self) -> str:
        return 'this callback did not return, so it was interrupted: the executor has one thread for all nodes'


class _Parked(BaseException):
    """Raised inside a callback that cannot be interrupted, to keep its thread from ever running again.

    The interpreter creates the exception object in that thread, and creating it never ends. A daemon thread that is
    asleep in a lock lets the interpreter end; one that still runs Python aborts it with status 134.
    """

    is_parked = interrupts.Latch()

    def __init__(self) -> None:
        self.is_parked.set()
        threading.Event().wait()


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


class BackgroundExecutor:
    """Spins nodes in a thread of its own until it is stopped. Get it from ``start()``."""

    def __init__(self) -> None:
        self.domain_id = domain.choose()
        import_messages()
        self.node_log = NodeLog()
        self.failures: deque[Failure] = deque(maxlen=100)
        """The exceptions that callbacks raised, oldest first; those that repeat are counted in one."""
        self._guard = Guard(self._in_thread, self._error_if_asked)
        self.callback_watch = CallbackWatch(self._guard.look)
        self._nodes: list[Node] = []
        self._event_listeners: Listeners[[ParameterEvent]] = Listeners()
        self._graph_listeners: Listeners[[]] = Listeners()
        self._incarnations: Incarnations = frozenset()
        self._names: list[tuple[str, str]] = []
        self._stopping = False
        with contextlib.ExitStack() as undo:  # a process that may open no more files, say, gets no participant of DDS
            # Without NO, the kernel's "interrupt" button would shut the context down. The console and file logs
            # are off because a thread's output lands in whichever cell is running: node_log reads /rosout instead.
            rclpy.init(args=['--ros-args', '--disable-stdout-logs', '--disable-external-lib-logs'],
                       domain_id=self.domain_id, signal_handler_options=SignalHandlerOptions.NO)
            undo.callback(utilities.try_shutdown)
            self.context = utilities.get_default_context()
            self._executor = rclpy_private.new_executor(self.context)
            self.tool_node = Node(TOOL_NODE_NAME, start_parameter_services=False, enable_rosout=False)
            undo.callback(self.tool_node.destroy_node)
            note_arrival(self.tool_node)
            self.tool_node.create_subscription(
                Log, '/rosout', self.node_log.receive,
                QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL))
            self.tool_node.create_subscription(
                ParameterEvent, '/parameter_events', self._event_listeners.call, qos_profile_parameter_events)
            self._executor.add_node(self.tool_node)
            self.services = Services(self.tool_node, self._in_thread, self._free_thread)
            self._thread = self._new_thread()
            self._let_go_of_rclpy = undo.enter_context(contextlib.ExitStack())
            keep = self._let_go_of_rclpy.callback
            keep(rclpy_private.forbid_waiting(self._error_if_in_callback, rclpy_private.WaitLimit(
                self._in_main_thread, WAIT_LIMIT_SEC, self._error_if_endless, self._error_if_in_vain)))
            keep(rclpy_private.keep_context(self.context, self._tell_who_keeps_rclpy))
            keep(rclpy_private.call_before_node_init(before_node_init))
            keep(interrupts.raise_again())
            self._thread.start()
            undo.pop_all()

    @property
    def is_running(self) -> bool:
        """True if the thread spins, on a context that is alive."""
        return not self._ended.is_set() and self.context.ok() and not self._stopping

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
        return f'<BackgroundExecutor: {"spinning " + names if self.is_running else "stopped"}>'

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
        node = prepare(node_class, _NodeHost(self, list(ros_args)))
        try:
            node.__init__(*args, **kwargs)  # type: ignore[misc]
        except BaseException:
            # Half a node still has services on the network that nobody would ever serve.
            rclpy_private.destroy_unfinished(node)
            raise
        what = f'add {_full_name(node)}'
        # Known before it is spun: its first callback, and listeners to the graph, may look for it.
        self._nodes.append(node)
        self.run(lambda: self._executor.add_node(node), what)
        if self.is_running:
            self.run(self._tell_of_nodes, 'look at the graph')
        return node

    def remove(self, node: Node | str) -> bool:
        """Stop spinning a node and destroy it.

        :param node: The node, or its fully qualified name.
        :return: True if there was such a node.
        """
        doomed = [each for each in self._nodes if node is each or _full_name(each) == node]
        for each in doomed:
            self._destroy_in_thread(each, each.destroy_node)
        if doomed:
            self._check_graph_soon()
        return bool(doomed)

    def remove_all(self) -> None:
        """Destroy all nodes that were added."""
        for node in reversed(self.nodes):
            self.remove(node)

    def clear(self) -> None:
        """Destroy all nodes that were added, and forget what was logged and what failed.

        :raises ExecutorError: a callback does not return; from then on, this executor is stopped.
        """
        self.remove_all()
        self.run(self.node_log.clear, 'clear the log')
        self._guard.renew()  # what those nodes printed is not held against the next
        self.failures.clear()

    def destroy(self, node: Node, destroy: Callable[[], None]) -> None:
        """Take a node off the stage, if it is there, and call the function that destroys it."""
        if node not in self._nodes or not self.is_running:
            destroy()
            return

        def take_off() -> None:
            self._nodes.remove(node)
            self._executor.remove_node(node)
            destroy()
        self._destroy_in_thread(node, take_off)

    def _destroy_in_thread(self, node: Node, destroy: Callable[[], None]) -> None:
        """Let the executor's thread destroy a node, and then what rclpy forgets."""
        what = f'destroy {_full_name(node)}'
        executor, end_service = self._executor, rclpy_private.keep_type_description_service(node)
        # The service ends in a turn of its own: by then the executor has let go of it. One that is stuck never does.
        if self._in_thread():  # a callback runs now, maybe the node's own
            destroy()
            executor.create_task(end_service)
            return
        self.run(destroy, what)
        if self._executor is executor:
            self.run(end_service, what)

    # -- the thread -------------------------------------------------------------------------------------

    def run(self, function: Callable[[], T], what: str, timeout_sec: float = STOP_TIMEOUT_SEC) -> T:
        """Run a function in the executor's thread, between two callbacks, and return its result.

        A callback that does not return within the time limit is interrupted with an exception. One that cannot be
        interrupted loses its node, and the other nodes get a new thread.

        :param what: Names the work in the error.
        :raises StuckError: the function does not return and cannot be interrupted.
        """
        if self._in_thread():
            return function()
        values: list[T] = []
        errors: list[BaseException] = []
        begun, finished = interrupts.Latch(), interrupts.Latch()

        def work() -> None:
            begun.set()
            try:
                self._guard.look()
                values.append(function())
            except BaseException as error:
                errors.append(error)
            finally:
                finished.set()

        self._require_running()
        self._executor.create_task(work)
        patience_sec = max(timeout_sec - self.callback_watch.busy_sec, min(timeout_sec, _LEAST_PATIENCE_SEC))
        if not within(patience_sec, finished.wait) and not self._interrupt(finished.wait):
            self._move_to_a_new_thread()
            if begun.is_set():
                raise StuckError(f'cannot {what}: it does not return and cannot be interrupted')
            return self.run(function, what, timeout_sec)
        if errors:
            raise errors[0]
        return values[0]

    def _new_thread(self) -> threading.Thread:
        # Thread.is_alive() and join() take a thread that runs for one that has ended, for good, if Ctrl+C comes while
        # they look (CPython 3.10 to 3.12).
        self._ended = interrupts.Latch()
        return threading.Thread(target=self._spin_until_the_end, args=(self._ended,), name='ros-background-executor',
                                daemon=True)

    def _spin_until_the_end(self, ended: interrupts.Latch) -> None:
        # Linux may deliver the alarm of an exercise's time limit to any thread, and so wake a callback that sleeps: see
        # raise_in. SIGINT and SIGTERM are not blocked: a process that a callback starts would inherit that.
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM])
        try:
            self._spin()
        finally:
            ended.set()

    def _spin(self) -> None:
        next_graph_check = 0.0
        while not self._stopping and self.context.ok() and self._in_thread():
            try:
                self._executor.spin_once(timeout_sec=GRAPH_PERIOD_SEC)
                if time.monotonic() >= next_graph_check:
                    next_graph_check = time.monotonic() + GRAPH_PERIOD_SEC
                    self._check_graph()
                    self.services.expire()
                    self._tell_what_is_left_out()
            except ExternalShutdownException:
                break
            except BaseException as error:
                # Also what a callback raises: rclpy would end spin() here, and with it every node.
                if self.context.ok() and not self._stopping:
                    self._show_once(error)

    def _in_thread(self) -> bool:
        return threading.current_thread() is self._thread

    def _interrupt(self, has_ended_within: Callable[[float], bool]) -> bool:
        """Raise an exception in the callback that keeps the thread. Return True if that ends it.

        An exception that comes while Python runs a ``__del__``, and rclpy's loggers have one, is printed and lost. So
        before a callback counts as one that cannot be interrupted, it is raised a second time.
        """
        kept_by = self.callback_watch.running
        _CallbackInterrupted.is_noticed = False
        interrupts.raise_in(self._thread, _CallbackInterrupted)
        if within(_NOTICE_TIMEOUT_SEC, has_ended_within):
            return True
        if not _CallbackInterrupted.is_noticed:
            return False
        if within(INTERRUPT_TIMEOUT_SEC, has_ended_within):
            return True
        if self.callback_watch.running is kept_by:
            interrupts.raise_in(self._thread, _CallbackInterrupted)
        return within(INTERRUPT_TIMEOUT_SEC, has_ended_within)

    def _ends_within(self, seconds: float) -> bool:
        if not self._ended.wait(seconds):
            return False
        self._thread.join()
        return True

    def _free_thread(self) -> bool:
        """Interrupt a callback that keeps the thread for longer than anybody waits for an answer, if there is one."""
        is_kept = self.callback_watch.busy_sec > _BUSY_SEC and self.is_running
        if is_kept:
            self.run(lambda: None, 'go on')
        return is_kept

    def _move_to_a_new_thread(self) -> None:
        """Leave a callback that never returns behind, and its node, and go on with the others in a new thread."""
        stuck = self.callback_watch.running
        self._park_thread()
        self.callback_watch = CallbackWatch(self._guard.look)
        if stuck is not None and stuck.node in self._nodes:
            self._nodes.remove(stuck.node)
            rclpy_private.destroy_by_force(stuck.node)
            print(f'{_sentence(stuck)} does not return and cannot be interrupted, so {stuck.node_name} was removed; '
                  f'all other nodes keep running.', file=sys.stderr)
        self._executor = rclpy_private.new_executor(self.context)
        self._thread = self._new_thread()
        for node in [self.tool_node, *self._nodes]:
            rclpy_private.take_from_dead_executor(node)
            self._executor.add_node(node)
            rclpy_private.take_over_unread(self._executor, node)
        self._thread.start()
        # A client that is created while the executor still takes over the nodes may never hear an answer.
        self.run(lambda: None, 'go on in a new thread')

    def _park_thread(self) -> None:
        """Keep the thread from ever running Python again: it sleeps until the process ends."""
        _Parked.is_parked = interrupts.Latch()
        interrupts.raise_in(self._thread, _Parked)
        if _CallbackInterrupted.is_noticed:  # otherwise it is asleep already, which is as good
            within(_NOTICE_TIMEOUT_SEC, _Parked.is_parked.wait)

    # -- what code on the stage must not do -------------------------------------------------------------

    def _in_main_thread(self) -> bool:
        return threading.current_thread() is threading.main_thread() and self.is_running

    def _error_if_in_callback(self) -> ExecutorError | None:
        """Return what to raise where rclpy is about to wait in the executor's thread."""
        if not self._in_thread():
            return None
        return ExecutorError(
            'this callback already runs inside the executor that it waits for, so the wait could never end: use '
            'call_async() and future.add_done_callback(...), or await the future in an async callback')

    def _error_if_endless(self, nodes: list[Node]) -> ExecutorError:
        """Return what to raise where rclpy is about to spin nodes forever in the main thread."""
        node = next(iter(nodes), None)
        if node in self._nodes:
            return self._error_if_taken(node)
        name = type(node).__name__ if node is not None and type(node) is not Node else 'MyNode'
        if is_managed(node):
            return ExecutorError(f'spin() never returns, and the constructor of {name} would wait forever: leave this '
                                 f'line out. The stage spins the node as soon as it is constructed')
        return ExecutorError(
            f'spin() never returns, and no further cell would run: leave this line out. ros.add({name}) creates the '
            f'node and spins it in the background; to wait for something, use param_tutorial.wait_until(...)')

    def _error_if_in_vain(self, what: str, seconds: float) -> WaitTimeoutError:
        """Return what to raise where rclpy has waited without a time limit in the main thread."""
        return WaitTimeoutError(
            f'timed out after {seconds:g} s waiting for {what}. rclpy itself would wait forever; pass timeout_sec=... '
            f'to wait longer. Is what you wait for on the stage? ros.add(...) puts a node there')

    def _error_if_taken(self, node: Node) -> ExecutorError:
        return ExecutorError(
            f'{_full_name(node)} is spun in the background already, and spinning it here would take it away from '
            f'there: to wait for something in a cell, use param_tutorial.wait_until(...)')

    def objection(self, node: Node, other: Executor) -> Exception | None:
        """Return the exception to raise when another executor wants to spin a node, None if it may."""
        if other is self._executor or not self.is_running or node not in self._nodes:
            return None
        return self._error_if_in_callback() or self._error_if_taken(node)

    def _error_if_asked(self) -> ExecutorError | None:
        """Return what input() raises in the executor's thread."""
        if not self._in_thread():
            return None
        return ExecutorError(
            'a callback cannot ask with input(): while it waits for you to type, no node gets a turn. Ask in a cell, '
            'and give the node the answer as a parameter')

    def _tell_who_keeps_rclpy(self, what: str) -> None:
        """Explain why rclpy.init() or rclpy.shutdown() did nothing."""
        if what == 'init':
            text = 'rclpy.init() has nothing to do here: param_tutorial.start() has initialized rclpy already.'
        else:
            text = ('rclpy.shutdown() has nothing to do here: it would end every node on the stage, so the stage '
                    'keeps running. To end it, call param_tutorial.stop().')
        print(f'{text} A program of your own needs this line.', file=sys.stderr)

    def _tell_what_is_left_out(self) -> None:
        if count := self._guard.left_out():
            self._guard.say(f'… and {count:,} more lines from callbacks, which are left out: while a callback prints, '
                            f'no node gets a turn.')

    # -- exceptions in callbacks ------------------------------------------------------------------------

    def _show_once(self, error: BaseException) -> None:
        callback = self.callback_watch.culprit(error)
        if callback is not None and callback.node not in self._nodes:
            return  # a callback or an answer was due when its node was removed, and has found its handles gone
        failure = self._count(error, callback)
        is_ours = isinstance(error, _CallbackInterrupted)
        if callback is not None and callback.parameter_service and not is_ours and self.services.take(
                error, callback.node_name, callback.parameter_service, callback.request):
            return  # the caller raises it
        failure.times_shown += 1
        if failure.times_shown == 1:
            text = ''.join(traceback.format_exception(error)).rstrip('\n')
            self._guard.say(f'{_sentence(failure)} raised an exception; the node keeps running.\n{text}')
        elif failure.times_shown == 2:
            self._guard.say(f'The same {type(error).__name__} again in {failure}. From now on, repeats are only '
                            f'counted, in the failures of the executor.')

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

        A callback that never returns is left behind in its thread, asleep, with its context shut down. Ctrl+C comes
        through when all is done: nobody could use half an executor, and nobody else could have rclpy.
        """
        # This order is not free: shutting down without joining the thread aborts the interpreter at its exit.
        self._stopping = True
        self._let_go_of_rclpy.close()
        if not self._ended.is_set() and self.context.ok():
            self._executor.create_task(lambda: None)
        has_ended = within(STOP_TIMEOUT_SEC, self._ends_within) or self._interrupt(self._ends_within)
        if has_ended:
            self._executor.shutdown()
        else:
            self._park_thread()
        for node in [*reversed(self._nodes), self.tool_node]:
            if has_ended:
                node.destroy_node()
            else:
                # Left as they are, other nodes would see those of a parked thread for as long as this process lives,
                # and never get an answer.
                rclpy_private.destroy_by_force(node)
        self._nodes.clear()
        self._guard.leave()
        if utilities.get_default_context() is self.context:
            utilities.try_shutdown()  # without naming the context, so that the next init gets a new default one

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

    def _check_graph_soon(self) -> None:
        if self.is_running:
            self.run(self._check_graph, 'look at the graph')


def _sentence(callback: Callback | Failure) -> str:
    """Return the name of a callback as the beginning of a sentence."""
    name = str(callback)
    return name[0].upper() + name[1:]


def _full_name(node: Node) -> str:
    return node.get_fully_qualified_name()


@dataclass(frozen=True)
class _NodeHost:
    """What one node on the stage sees of its executor."""

    ros: BackgroundExecutor
    ros_args: list[str]

    @property
    def callback_watch(self) -> CallbackWatch:
        return self.ros.callback_watch

    def before_node_init(self, node_name: str, options: dict[str, Any]) -> None:
        """Make room for a node that is about to be created under this name, and pass its ros_args on."""
        ros_args = ['--ros-args', *self.ros_args] if self.ros_args else []
        options['cli_args'] = [*(options.get('cli_args') or ()), *ros_args]
        name, namespace = node_name, options.get('namespace') or '/'
        for argument in options['cli_args']:
            key, separator, value = argument.partition(':=')
            if separator and key in ('__node', '__name'):
                name = value
            elif separator and key == '__ns':
                namespace = value
        self.ros.remove(f'/{namespace.strip("/")}/{name}'.replace('//', '/'))

    def objection(self, node: Node, other: Executor) -> Exception | None:
        """Return the exception to raise when another executor wants to spin a node, None if it may."""
        return self.ros.objection(node, other)

    def destroy(self, node: Node, destroy: Callable[[], None]) -> None:
        """Take a node off the stage, if it is there, and destroy it."""
        self.ros.destroy(node, destroy)
