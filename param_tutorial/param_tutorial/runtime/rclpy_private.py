"""What the tools use of rclpy that rclpy does not promise: private names, and habits that no documentation states.

All of it stands here, so that a new rclpy breaks this file and no other. Each function rests on an assumption about
rclpy 7.1, and tests/runtime/test_rclpy_private.py has one test for each, named like the assumption.
"""

import contextlib
import functools
from collections.abc import Callable, Iterator
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent
from rclpy.client import Client
from rclpy.context import Context
from rclpy.executors import Executor
from rclpy.experimental.events_executor import EventsExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.service import Service

# What a parameter callback is called with, and what it returns, depends on its kind.
ParameterCallback = Callable[[list[Parameter]], Any]
# Called in place of a parameter callback: with its kind, itself and the parameters. Calls it, and returns its answer.
CallInstead = Callable[[str, ParameterCallback, list[Parameter]], Any]

_CALLBACK_LISTS = {
    'pre-set': '_pre_set_parameters_callbacks',
    'on-set': '_on_set_parameters_callbacks',
    'post-set': '_post_set_parameters_callbacks',
}
ForbiddenHere = Callable[[], Exception | None]


# -- executors ------------------------------------------------------------------------------------------------

def new_executor(context: Context) -> Executor:
    """Return an executor for ``spin_once`` in a loop.

    rclpy calls it experimental. It answers in a third of the SingleThreadedExecutor's time. Its own spin() serves
    nothing in the wheel of rclpy 7.1.6, but spin_once() with a time limit works.
    """
    return EventsExecutor(context=context)


def forbid_waiting(forbidden_here: ForbiddenHere) -> Callable[[], None]:
    """Make rclpy ask before it waits for what only a spinning executor can bring.

    All of rclpy's own executors wait in ``Executor.wait_for_ready_callbacks``, and with them every ``spin…``; a
    ``Client.call`` without a time limit waits for another thread.

    :param forbidden_here: Called in the thread that is about to wait. Returns the exception to raise, or None.
    :return: Call it to leave rclpy as it was.
    """
    wait, call = Executor.wait_for_ready_callbacks, Client.call

    def ask_and_wait(self: Executor, *args: Any, **kwargs: Any) -> Any:
        if error := forbidden_here():
            raise error
        return wait(self, *args, **kwargs)

    def ask_and_call(self: Client, request: Any, timeout_sec: float | None = None) -> Any:
        if timeout_sec is None and (error := forbidden_here()):
            raise error
        return call(self, request, timeout_sec)

    def allow_waiting() -> None:
        if Executor.wait_for_ready_callbacks is ask_and_wait:
            Executor.wait_for_ready_callbacks = wait  # type: ignore[method-assign]
        if Client.call is ask_and_call:
            Client.call = call  # type: ignore[method-assign]

    Executor.wait_for_ready_callbacks = ask_and_wait  # type: ignore[method-assign]
    Client.call = ask_and_call  # type: ignore[method-assign]
    return allow_waiting


# -- nodes ----------------------------------------------------------------------------------------------------

def is_in_graph(node: Node) -> bool:
    """True if a node has got so far in its constructor that it exists for others, and has to be destroyed."""
    return hasattr(node, '_Node__node')


def destroy_by_force(node: Node) -> None:
    """Destroy a node whose executor will never run again.

    An executor counts as a user of each handle that it waits for, and rclpy destroys a handle when the last user
    has left it: with ``__exit__``, as at the end of a ``with`` block.
    """
    entities: list[Any] = [*node.publishers, *node.subscriptions, *node.clients, *node.services, *node.timers]
    handles = [*node.waitables, *(entity.handle for entity in entities), node.handle]
    node.destroy_node()
    for handle in handles:
        with contextlib.suppress(RuntimeError):  # raised when there is no user left
            while True:
                handle.__exit__(None, None, None)


def watch_answers(service: Service, failed: Callable[[BaseException], None]) -> None:
    """Call a function with each exception that sending an answer raises.

    The executor looks ``send_response`` up on the service object, each time it answers.
    """
    send_response = service.send_response

    def send_watched(response: Any, header: Any) -> None:
        try:
            send_response(response, header)
        except BaseException as error:
            failed(error)
            raise

    service.send_response = send_watched  # type: ignore[method-assign]


# -- parameters -----------------------------------------------------------------------------------------------

def pending_overrides(node: Node) -> dict[str, Parameter]:
    """Return a node's own dictionary of overrides; a declaration looks its name up here.

    rclcpp has get_parameter_overrides() for this, and rclpy has nothing.
    """
    return node._parameter_overrides


def own_descriptor(node: Node, name: str) -> ParameterDescriptor:
    """Return the descriptor object that a node keeps for a parameter; what is written into it, the node describes.

    The public set_descriptor() rejects that of a read-only parameter.
    """
    return node.describe_parameter(name)


def observe_changes(node: Node, call_instead: CallInstead,
                    publish_instead: Callable[[Callable[[ParameterEvent], None], ParameterEvent], None],
                    ) -> Callable[[], None]:
    """Step in between a node and its parameter callbacks, and between the node and its parameter events.

    The node keeps its callbacks themselves, in the same order, and they may register and remove each other; only
    who goes through the list gets others to call. To be called, and undone, between two callbacks.

    :param publish_instead: Called with the function that publishes an event, and with the event.
    :return: Call it to leave the node as it was, with the callbacks that it has by then.
    """
    originals: dict[str, list[ParameterCallback]] = {}
    for kind, attribute in _CALLBACK_LISTS.items():
        originals[attribute] = getattr(node, attribute)
        setattr(node, attribute, _Observed(kind, originals[attribute], call_instead))
    publisher: Any = node._parameter_event_publisher
    publisher.publish = functools.partial(publish_instead, publisher.publish)

    def stop_observing() -> None:
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
