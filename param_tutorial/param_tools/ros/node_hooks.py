"""The classes of the nodes on the stage: a learner's class, with hooks between it and rclpy's Node.

Through these hooks the executor learns a node's name before the node exists, knows which callback of which node
raised an exception, and keeps the node when another executor would take it.
"""

import functools
import inspect
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Protocol

from rclpy.executors import Executor
from rclpy.node import Node
from rclpy.parameter_service import ParameterService
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Timer

from param_tools.ros import rclpy_private
from param_tools.ros.service_types import SERVICE_TYPES
from param_tools.ros.waiting import machine_time

_EXECUTOR_OF_NODE: property = vars(Node)['executor']
_PARAMETER_SERVICES = {service_type: name for name, service_type in SERVICE_TYPES.items()}


@dataclass(frozen=True, eq=False)
class Callback:
    """A callback that a node has registered with rclpy."""

    node: Node
    node_name: str
    """Fully qualified."""
    kind: str
    """'timer', 'subscription' or 'service'."""
    function: Callable[..., Any]
    parameter_service: str = ''
    """Which of SERVICE_TYPES it serves, if it is rclpy's own."""
    request: Any = None
    """What it was serving when it raised an exception."""

    def __str__(self) -> str:
        if self.parameter_service:
            return f'{self.parameter_service} of {self.node_name}'
        return f'the {self.kind} callback {function_name(self.function)} of {self.node_name}'


def function_name(function: Callable[..., Any]) -> str:
    """Return the name that a function's author gave it."""
    return str(getattr(function, '__name__', type(function).__name__))


class CallbackWatch:
    """Knows which callback runs, and which one raised the latest exception."""

    def __init__(self, before_each: Callable[[], None]) -> None:
        """:param before_each: Called before each callback, in its thread."""
        self.running: Callback | None = None
        self._before_each = before_each
        self._began = 0.0
        self._failed: tuple[BaseException, Callback] | None = None

    @property
    def busy_sec(self) -> float:
        """For how long the callback that runs has been running, in machine time; 0.0 if none runs."""
        return 0.0 if self.running is None else machine_time() - self._began

    def failed(self, callback: Callback, error: BaseException) -> None:
        """Note that an exception leaves a callback."""
        self._failed = error, callback

    def culprit(self, error: BaseException) -> Callback | None:
        """Return the callback that raised this exception, None if it was not watched. Ask once for each."""
        failed, self._failed = self._failed, None  # an exception keeps all that its frames hold
        return failed[1] if failed is not None and failed[0] is error else None

    def around(self, callback: Callback) -> Callable[..., Any]:
        """Return a function that does what the callback does, and tells this watch."""
        function = callback.function

        @functools.wraps(function)
        def call(*args: Any) -> Any:
            if self.running is None:
                self._began = machine_time()
            before, self.running = self.running, callback
            self._before_each()
            try:
                return function(*args)
            except BaseException as error:
                self.failed(replace(callback, request=args[0] if args else None), error)
                raise
            finally:
                self.running = before

        @functools.wraps(function)
        async def call_and_await(*args: Any) -> Any:
            self._before_each()
            try:
                return await function(*args)
            except BaseException as error:
                self.failed(callback, error)
                raise

        return call_and_await if inspect.iscoroutinefunction(function) else call


class Host(Protocol):
    """What a node on the stage needs of its executor."""

    @property
    def callback_watch(self) -> CallbackWatch:
        """Return the watch over the callbacks of all nodes on the stage."""

    def before_node_init(self, node_name: str, options: dict[str, Any]) -> None:
        """Hear of a node that is about to be created; options are the keyword arguments of Node."""

    def objection(self, node: Node, other: Executor) -> Exception | None:
        """Return the exception to raise when another executor wants to spin a node, None if it may."""

    def destroy(self, node: Node, destroy: Callable[[], None]) -> None:
        """Take a node off the stage, if it is there, and destroy it."""


def prepare(node_class: type[Node], host: Host) -> Node:
    """Return an object of a class derived from node_class, with the hooks; its constructor has yet to run."""
    managed_class = _managed(node_class)
    node = managed_class.__new__(managed_class)
    node.host_of_node = host
    return node


def before_node_init(node: Node, node_name: str, options: dict[str, Any]) -> None:
    """Tell the host of a node that was prepared for the stage that the node is about to be created; as in Host."""
    # A node's name is known only here, and two nodes of one name must never exist at once: both would obey every set,
    # and the second would log nothing.
    if isinstance(node, _Hooks):
        node.host_of_node.before_node_init(node_name, options)


def is_managed(node: object) -> bool:
    """True if a node was prepared for the stage; its constructor may still be running."""
    return isinstance(node, _Hooks)


def _managed(node_class: Any) -> 'type[_Hooks]':
    """Derive a class with the hooks: a base class that comes just before Node in the method resolution order."""
    bases = (_Hooks,) if node_class is Node else (node_class, _Hooks)
    # A class knows those derived from it without keeping them. A cache would keep all classes of cells that run again.
    for derived in bases[0].__subclasses__():
        if derived.__bases__ == bases:
            return derived
    return type(node_class.__name__, bases, {
        '__module__': node_class.__module__, '__doc__': node_class.__doc__, '__qualname__': node_class.__qualname__})


class _Hooks(Node):
    host_of_node: Host

    # rclpy registers its own callbacks through these methods too: those of the parameter services among them.

    def create_timer(self, timer_period_sec: float, callback: Any, *args: Any, **options: Any) -> Timer:
        return super().create_timer(timer_period_sec, self._watched('timer', callback), *args, **options)

    def create_subscription(self, msg_type: Any, topic: str, callback: Any, *args: Any, **options: Any
                            ) -> Subscription:
        watched = self._watched('subscription', callback)
        if inspect.iscoroutinefunction(watched):
            watched = self._as_task(watched)
        return super().create_subscription(msg_type, topic, watched, *args, **options)

    def create_service(self, srv_type: Any, srv_name: str, callback: Any, *args: Any, **options: Any) -> Service:
        is_rclpys = isinstance(getattr(callback, '__self__', None), ParameterService)
        parameter_service = _PARAMETER_SERVICES[srv_type] if is_rclpys else ''
        watched = self._watched('service', callback, parameter_service)
        service = super().create_service(srv_type, srv_name, watched, *args, **options)
        answering = Callback(self, self.get_fully_qualified_name(), 'service', callback, parameter_service)
        rclpy_private.watch_answers(
            service, functools.partial(self.host_of_node.callback_watch.failed, answering))
        return service

    def destroy_node(self) -> None:
        self.host_of_node.destroy(self, super().destroy_node)

    def _watched(self, kind: str, function: Any, parameter_service: str = '') -> Any:
        if not callable(function):
            return function  # rclpy says what is wrong with it
        return self.host_of_node.callback_watch.around(
            Callback(self, self.get_fully_qualified_name(), kind, function, parameter_service))

    def _as_task(self, function: Any) -> Any:
        """Return a function that begins an ``async def`` callback, which rclpy 7.1.6 drops for a subscription."""
        @functools.wraps(function)
        def begin(*args: Any) -> None:
            if self.executor is not None:
                self.executor.create_task(function, *args)
        return begin

    @property
    def executor(self) -> Executor | None:
        """The executor that spins this node."""
        executor: Executor | None = _EXECUTOR_OF_NODE.__get__(self)
        return executor

    @executor.setter
    def executor(self, executor: Executor | None) -> None:
        if executor is not None and (objection := self.host_of_node.objection(self, executor)):
            executor.remove_node(self)  # which has taken it in already, and asks afterwards
            raise objection
        _EXECUTOR_OF_NODE.__set__(self, executor)
