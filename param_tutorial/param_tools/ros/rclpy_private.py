"""What the tools use of rclpy that rclpy does not promise: private names, and habits that no documentation states.

All of it stands here, so that a new rclpy breaks this file and no other. Each function rests on an assumption about
rclpy 7.1, and tests/ros/test_rclpy_private.py has one test for each, named like the assumption.
"""

import contextlib
import ctypes
import functools
import time
import types
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy import utilities
from rclpy.client import Client
from rclpy.context import Context
from rclpy.executors import Executor, TimeoutException, TimeoutObject, await_or_execute
from rclpy.experimental.events_executor import EventsExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.service import Service
from rclpy.task import Future

from param_tools.ros.waiting import machine_time

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
ForbiddenHere = Callable[[], Exception | None]
# How long Ctrl+C may have to wait.
_SLICE_SEC = 0.1


# -- executors ------------------------------------------------------------------------------------------------

def new_executor(context: Context) -> Executor:
    """Return an executor for ``spin_once`` in a loop.

    rclpy calls it experimental. It answers in a third of the SingleThreadedExecutor's time. Its own spin() serves
    nothing in the wheel of rclpy 7.1.6, but spin_once() with a time limit works.
    """
    return EventsExecutor(context=context)


class WaitLimit(NamedTuple):
    """What becomes of a wait without a time limit where waiting as such is fine."""

    applies_here: Callable[[], bool]
    """Called in the thread that is about to wait."""
    timeout_sec: float
    endless: Callable[[list[Node]], Exception]
    """Returns the exception to raise in place of spinning these nodes forever."""
    in_vain: Callable[[str, float], Exception]
    """Returns the exception to raise when what was waited for did not come within so many seconds."""


def forbid_waiting(forbidden_here: ForbiddenHere, limit: WaitLimit | None = None) -> Callable[[], None]:
    """Make rclpy ask before it waits for what only a spinning executor can bring.

    All of rclpy's own executors wait in ``Executor.wait_for_ready_callbacks``, and with them every ``spin…``; a
    ``Client.call`` without a time limit waits for another thread.

    They wait in C++, where Python runs no handler of a signal: where the limit applies, they wait a little at a time.

    :param forbidden_here: Called in the thread that is about to wait. Returns the exception to raise, or None.
    :param limit: For waits that are not forbidden, and have no time limit of their own.
    :return: Call it to leave rclpy as it was.
    """
    guard = _WaitGuard(forbidden_here, limit)
    restorers = [_replace(Executor, 'wait_for_ready_callbacks', guard.wait),
                 _replace(Executor, 'spin_until_future_complete', guard.spin_until),
                 _replace(Executor, 'spin', guard.spin),
                 _replace(Client, 'call', guard.call),
                 _replace(rclpy, 'spin', guard.spin_node)]

    def allow_waiting() -> None:
        for restore in restorers:
            restore()
    return allow_waiting


def _replace(owner: Any, name: str, function: Callable[..., Any]) -> Callable[[], None]:
    """Put a function in the place of one of rclpy's.

    :param function: Called as the other was; with the instance, if it was a method.
    :return: Puts the other one back, unless somebody else has replaced it since.
    """
    original = getattr(owner, name)

    # A method of ours would not be given the instance of theirs.
    @functools.wraps(original)
    def instead(*args: Any, **options: Any) -> Any:
        return function(*args, **options)

    def restore() -> None:
        if getattr(owner, name) is instead:
            setattr(owner, name, original)
    setattr(owner, name, instead)
    return restore


class _WaitGuard:
    """rclpy's ways to wait, as they were when it was made, each with a question first."""

    def __init__(self, forbidden_here: ForbiddenHere, limit: WaitLimit | None) -> None:
        self._forbidden_here, self._limit = forbidden_here, limit
        self._wait, self._spin, self._call = Executor.wait_for_ready_callbacks, Executor.spin, Client.call
        self._spin_until, self._spin_node = Executor.spin_until_future_complete, rclpy.spin

    def _ask(self) -> None:
        if error := self._forbidden_here():
            raise error

    @property
    def _limit_here(self) -> WaitLimit | None:
        return self._limit if self._limit is not None and self._limit.applies_here() else None

    def wait(self, executor: Executor, timeout_sec: float | TimeoutObject | None = None, *args: Any) -> Any:
        self._ask()
        if limit := self._limit_here:
            return _wait_in_slices(self._wait, limit, executor, timeout_sec, *args)
        return self._wait(executor, timeout_sec, *args)

    def spin_until(self, executor: Executor, future: Future, timeout_sec: float | None = None) -> None:
        limit = self._limit_here
        if limit is None or (timeout_sec is not None and timeout_sec >= 0):
            self._spin_until(executor, future, timeout_sec)
            return
        self._spin_until(executor, future, limit.timeout_sec)
        if not future.done():
            raise limit.in_vain('the future', limit.timeout_sec)

    def spin(self, executor: Executor) -> None:
        self._ask()
        if limit := self._limit_here:
            raise limit.endless(executor.get_nodes())
        self._spin(executor)

    def spin_node(self, node: Node, executor: Executor | None = None) -> None:
        self._ask()
        if limit := self._limit_here:
            raise limit.endless([node])
        self._spin_node(node, executor)

    def call(self, client: Client, request: Any, timeout_sec: float | None = None) -> Any:
        if timeout_sec is not None:
            return self._call(client, request, timeout_sec)
        self._ask()
        limit = self._limit_here
        if limit is None:
            return self._call(client, request, None)
        answer = self._call(client, request, limit.timeout_sec)
        if answer is None:
            raise limit.in_vain(f'an answer from {client.srv_name}', limit.timeout_sec)
        return answer


def _wait_in_slices(wait: Callable[..., Any], limit: WaitLimit, executor: Executor,
                    timeout_sec: float | TimeoutObject | None, *args: Any) -> Any:
    """Wait as rclpy does, a little at a time, and not forever."""
    seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
    own_limit_sec = None if seconds is None or seconds < 0 else seconds
    clock = machine_time if own_limit_sec is None else time.monotonic
    deadline = clock() + (limit.timeout_sec if own_limit_sec is None else own_limit_sec)
    while True:
        left_sec = deadline - clock()
        try:
            return wait(executor, max(0.0, min(left_sec, _SLICE_SEC)), *args)
        except TimeoutException:
            if left_sec > _SLICE_SEC:
                continue
            if own_limit_sec is None:
                raise limit.in_vain('something to do', limit.timeout_sec) from None
            raise


# -- the context ----------------------------------------------------------------------------------------------

def keep_context(context: Context, tell: Callable[[str], None]) -> Callable[[], None]:
    """Make ``init`` and ``shutdown`` of the default context do nothing, however they are called.

    ``rclpy.shutdown`` forgets the default context before it shuts it down. ``rclpy.init`` installs handlers of signals
    that shut down every context, whichever it was called for.

    :param tell: Called with 'init' or 'shutdown' in the thread that tried it.
    :return: Call it to leave the context and rclpy as they were.
    """
    def init(*_args: Any, **_options: Any) -> None:
        tell('init')

    def shutdown() -> None:
        with utilities.g_context_lock:
            vars(utilities)['g_default_context'] = context
        tell('shutdown')

    def try_shutdown() -> None:
        tell('shutdown')

    def install_no_handlers(_options: object = None) -> None:
        pass

    in_rclpy = vars(rclpy)
    install = in_rclpy['install_signal_handlers']
    instead = {'init': init, 'shutdown': shutdown, 'try_shutdown': try_shutdown}
    for name, function in instead.items():
        setattr(context, name, function)
    in_rclpy['install_signal_handlers'] = install_no_handlers

    def let_go() -> None:
        for name in instead:
            vars(context).pop(name, None)
        if in_rclpy['install_signal_handlers'] is install_no_handlers:
            in_rclpy['install_signal_handlers'] = install
    return let_go


# -- nodes ----------------------------------------------------------------------------------------------------

def call_before_node_init(before: Callable[[Node, str, dict[str, Any]], None]) -> Callable[[], None]:
    """Call a function before each ``Node.__init__``, whether a class gets there by ``super()`` or by its name.

    :param before: Called with the node, its name, and the other arguments, which it may change.
    :return: Call it to leave rclpy as it was.
    """
    init = Node.__init__

    @functools.wraps(init)
    def tell_and_init(self: Node, node_name: str, **options: Any) -> None:
        before(self, node_name, options)
        init(self, node_name, **options)

    Node.__init__ = tell_and_init  # type: ignore[method-assign]

    def leave() -> None:
        if Node.__init__ is tell_and_init:
            Node.__init__ = init  # type: ignore[method-assign]
    return leave


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


def take_from_dead_executor(node: Node) -> None:
    """Let go of a node's handles in the name of an executor that will never run again, so that another may have it.

    An executor counts as a user of each handle that it waits for, and rclpy destroys a handle when the last user has
    left it. To be called before the other executor becomes a user: what is let go of here is everybody's.
    """
    _release(_waited_for(node))


def take_over_unread(executor: Executor, node: Node) -> None:
    """Let an executor deal with what has arrived for a node, and only an executor that never runs again was told of.

    An EventsExecutor is told of each message once, and takes one from the reader for each time. So without this, every
    later message would wait in the reader until the next one arrives, and each answer would be that to the question
    before.

    :param executor: Has the node, and does not spin yet.
    """
    for subscription in node.subscriptions:
        for work in iter(functools.partial(Executor._take_subscription, executor, subscription), None):
            executor.create_task(work)
    each: Any
    for each in node.clients:
        take_response = functools.partial(each.handle.take_response, each.srv_type.Response)
        for header, response in iter(take_response, (None, None)):
            executor.create_task(_answer, executor, each, header, response)
    for each in node.services:
        take_request = functools.partial(each.handle.service_take_request, each.srv_type.Request)
        for request, header in iter(take_request, (None, None)):
            executor.create_task(_serve, each, request, header)


def _answer(executor: Executor, client: Client, header: Any, response: Any) -> None:
    with contextlib.suppress(KeyError):  # of a request that was given up
        future = client.get_pending_request(header.request_id.sequence_number)
        future._set_executor(executor)
        future.set_result(response)


async def _serve(service: Any, request: Any, header: Any) -> None:
    service.send_response(await await_or_execute(service.callback, request, service.srv_type.Response()), header)


def destroy_by_force(node: Node) -> None:
    """Destroy a node whose executor will never run again."""
    handles = [*_waited_for(node), *(publisher.handle for publisher in node.publishers), node.handle]
    node.destroy_node()
    _release(handles)


def _waited_for(node: Node) -> list[Any]:
    """Return the handles of what a node has created and its executor waits for."""
    entities: list[Any] = [*node.subscriptions, *node.clients, *node.services, *node.timers]
    return [*node.waitables, *(entity.handle for entity in entities)]


def _release(handles: list[Any]) -> None:
    """Leave handles with ``__exit__``, as at the end of a ``with`` block, until they have no user."""
    for handle in handles:
        with contextlib.suppress(RuntimeError):  # raised when there is no user left
            while True:
                handle.__exit__(None, None, None)


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
        _rcl().rcl_service_fini(ctypes.c_void_p(impl.pointer), ctypes.c_void_p(pointer_to_node))
    return end


@functools.cache
def _rcl() -> ctypes.CDLL:
    """Return the library in C on which rclpy stands, and which it has loaded."""
    return ctypes.CDLL('librcl.so')


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
