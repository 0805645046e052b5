"""What the tools use of rclpy that rclpy does not promise: private names, and habits that no documentation states.

All of it stands here, so that a new rclpy breaks this file and no other.
"""

import contextlib
import ctypes
import functools
import types
from collections.abc import Callable, Iterator
from typing import Any

import rclpy
from rcl_interfaces.msg import ParameterEvent, SetParametersResult
from rclpy import context, utilities
from rclpy.exceptions import InvalidHandle
from rclpy.executors import Executor
from rclpy.node import Node
from rclpy.parameter import Parameter

# What a parameter callback is called with, and what it returns, depends on its kind.
ParameterCallback = Callable[[list[Parameter]], Any]
# Called in place of a parameter callback: with its kind, itself and the parameters. Calls it, and returns its answer.
CallInstead = Callable[[str, ParameterCallback, list[Parameter]], Any]
# Sets the parameters at one go, and returns the node's result.
SetParameters = Callable[[list[Parameter]], SetParametersResult]

_CALLBACK_LISTS = {
    'pre-set': '_pre_set_parameters_callbacks',
    'on-set': '_on_set_parameters_callbacks',
    'post-set': '_post_set_parameters_callbacks',
}


# -- nodes ----------------------------------------------------------------------------------------------------

@contextlib.contextmanager
def before_init_of(node: Node, before: Callable[[str, dict[str, Any]], None]) -> Iterator[None]:
    """Call a function before ``Node.__init__`` of a node that is constructed in this block.

    Its class may get there by ``super()`` or by the name of Node.

    :param before: Called with the node's name and the other arguments, which it may change.
    """
    init = Node.__init__

    @functools.wraps(init)
    def tell_and_init(self: Node, node_name: str, **options: Any) -> None:
        if self is node:
            before(node_name, options)
        init(self, node_name, **options)

    Node.__init__ = tell_and_init  # type: ignore[method-assign]
    try:
        yield
    finally:
        Node.__init__ = init  # type: ignore[method-assign]


def destroy_unfinished(node: Node) -> None:
    """Destroy a node whose constructor has raised an exception, if it got so far that it exists for others.

    rclpy's own ``destroy_node`` takes for granted that the constructor of Node came to its end. Where a value for
    ``use_sim_time`` is no bool, say, it did not, and an AttributeError would hide why.
    """
    if not hasattr(node, '_Node__node'):
        return
    end_service = keep_type_description_service(node)
    node.__dict__.setdefault('_type_description_service', types.SimpleNamespace(destroy=lambda: None))
    node.__dict__.setdefault('_Node__executor_weakref', None)
    node.destroy_node()
    end_service()


def destroy_by_force(node: Node) -> None:
    """Destroy a node whose executor will never run again, and still holds the handles of what it waits for."""
    entities: list[Any] = [*node.subscriptions, *node.clients, *node.services, *node.timers, *node.publishers]
    handles: list[Any] = [*node.waitables, *(entity.handle for entity in entities), node.handle]
    node.destroy_node()
    for handle in handles:  # each is left, as at the end of a ``with`` block, until it has no user
        with contextlib.suppress(RuntimeError):  # raised when there is no user left
            while True:
                handle.__exit__(None, None, None)


def drop_coroutines(executor: Executor, node: Node) -> None:
    """Cancel what a node that is destroyed still awaits: rclpy's executor keeps its coroutines, and so the node."""
    for task, _, owner in executor._tasks:
        if owner is node and not task.executing():
            task.cancel()


def keep_type_description_service(node: Node) -> Callable[[], None]:
    """Return a function that ends the service get_type_description of a node, which rclpy leaves behind.

    rclpy 7.1 creates it and has nobody to destroy it (https://github.com/ros2/rclpy/pull/1711, in the comments): each
    node that was there leaves 0.1 MiB and two ends of DDS, which every process that joins has to discover.

    :return: To be called once, when the node has been destroyed and no executor waits for its services any more.
    """
    service = getattr(getattr(node, '_type_description_service', None), '_type_description_srv', None)
    if service is None:  # start_type_description_service is false, or the constructor did not get so far
        return lambda: None
    # What is kept has a share in the node, which therefore is there until the end, wherever node.handle is by then.
    kept, pointer_to_node = [service.impl], node.handle.pointer

    def end() -> None:
        impl = kept.pop()
        with contextlib.suppress(InvalidHandle), impl:  # rclpy in Python has ended it with its node
            # The library in C on which rclpy stands, and which it has loaded.
            ctypes.CDLL('librcl.so').rcl_service_fini(ctypes.c_void_p(impl.pointer), ctypes.c_void_p(pointer_to_node))
    return end


# -- processes ----------------------------------------------------------------------------------------------------

def process_globals() -> list[tuple[Any, str, Any]]:
    """Return rclpy's module-level state as (module, attribute, initial value); ``programs.Program`` swaps it.

    It is the default context, the executor of ``rclpy.spin``, and how many contexts use the logging.
    """
    return [(utilities, 'g_default_context', None), (rclpy, '__executor', None), (context, 'g_logging_ref_count', 0)]


# -- parameters -----------------------------------------------------------------------------------------------

def has_judge(node: Any) -> bool:
    """True if somebody has registered a callback that may reject; rclpy itself registers one, for ``use_sim_time``."""
    return len(node._on_set_parameters_callbacks) > 1 or bool(node._pre_set_parameters_callbacks)


def observe_changes(node: Node, call_instead: CallInstead,
                    publish_instead: Callable[[Callable[[ParameterEvent], None], ParameterEvent], None],
                    set_instead: Callable[[SetParameters, list[Parameter]], SetParametersResult] | None = None,
                    ) -> Callable[[], None]:
    """Step in between a node and its parameter callbacks, and between the node and its parameter events.

    The node keeps its callbacks themselves, in the same order, and they may register and remove each other; only
    who goes through the list gets others to call. To be called, and undone, between two callbacks.

    :param publish_instead: Called with the function that publishes an event, and with the event.
    :param set_instead: Called with the function that sets parameters, and with those that somebody wants to set,
        whether by a service or in the node's own code; returns the result. A declaration is not a set.
    :return: Call it to leave the node as it was, with the callbacks that it has by then.
    """
    originals: dict[str, list[ParameterCallback]] = {}
    for kind, attribute in _CALLBACK_LISTS.items():
        originals[attribute] = getattr(node, attribute)
        setattr(node, attribute, _Observed(kind, originals[attribute], call_instead))
    publisher: Any = node._parameter_event_publisher
    publisher.publish = functools.partial(publish_instead, publisher.publish)
    in_node = vars(node)
    if set_instead is not None:
        in_node['_set_parameters_atomically'] = functools.partial(set_instead, node._set_parameters_atomically)

    def stop_observing() -> None:
        in_node.pop('_set_parameters_atomically', None)
        for attribute, original in originals.items():
            original[:] = getattr(node, attribute).callbacks()
            setattr(node, attribute, original)
        del publisher.publish
    return stop_observing


class _Observed(list[ParameterCallback]):
    """The callbacks of one kind. rclpy adds to it, removes from it, and calls what a ``for`` loop over it yields."""

    def __init__(self, kind: str, callbacks: list[ParameterCallback], call_instead: CallInstead):
        super().__init__(callbacks)
        self._kind = kind
        self._call_instead = call_instead

    def callbacks(self) -> list[ParameterCallback]:
        """Return the callbacks themselves."""
        return self[:]

    def __iter__(self) -> Iterator[ParameterCallback]:
        for callback in super().__iter__():
            yield functools.partial(self._call_instead, self._kind, callback)
