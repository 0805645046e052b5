"""Lines that every ROS program needs and a cell must not run: ``rclpy.spin(node)``, ``rclpy.shutdown()`` and the like.

While ROS runs in the background, they would end it, or block a cell or the executor forever. So each answers with a
sentence on what to do instead; nothing else of rclpy changes. In other threads that a learner starts, they do what they
always do.
"""

import functools
import sys
import threading
from collections.abc import Callable
from typing import Any, Protocol

import rclpy
from rclpy import utilities
from rclpy.client import Client
from rclpy.executors import Executor
from rclpy.node import Node

from param_tools.errors import ExecutorError, WaitTimeoutError

# How long rclpy waits in a cell for what has no time limit of its own.
WAIT_LIMIT_SEC = 3.0


class Stage(Protocol):
    """What these lines need to know of the executor in the background."""

    @property
    def nodes(self) -> tuple[Node, ...]:
        """Return the nodes that it spins."""

    def in_thread(self) -> bool:
        """Return True in its thread."""


def replace(stage: Stage, own_executor: Executor) -> Callable[[], None]:
    """Replace the lines by functions that answer with a sentence.

    :param own_executor: The executor in the background, which may do what others may not.
    :return: Call it to leave rclpy as it was.
    """
    lines = _Lines(stage, own_executor)
    replaced = (
        (rclpy, 'init', lines.init), (rclpy, 'shutdown', lines.shutdown), (rclpy, 'try_shutdown', lines.shutdown),
        (rclpy, 'spin', lines.spin), (rclpy, 'spin_once', lines.spin_once),
        (rclpy, 'spin_until_future_complete', lines.spin_until_future_complete),
        (Executor, 'spin', lines.spin_executor), (Executor, 'add_node', lines.add_node),
        (Executor, 'spin_until_future_complete', lines.spin_executor_until), (Client, 'call', lines.call))
    restorers = [_put(*each) for each in replaced]

    def restore() -> None:
        for each in restorers:
            each()
    return restore


def _put(owner: Any, name: str, instead: Callable[..., Any]) -> Callable[[], None]:
    """Put a function in the place of one of rclpy's, which it gets as its first argument.

    :return: Puts rclpy's back, unless somebody else has replaced ours since.
    """
    original = getattr(owner, name)

    # A plain function, so that as a method it is given the instance.
    @functools.wraps(original)
    def ours(*args: Any, **options: Any) -> Any:
        return instead(original, *args, **options)

    def restore() -> None:
        if getattr(owner, name) is ours:
            setattr(owner, name, original)
    setattr(owner, name, ours)
    return restore


class _Lines:
    """What each line does in place of rclpy's function, which is its first argument."""

    def __init__(self, stage: Stage, own_executor: Executor):
        self._stage, self._own_executor = stage, own_executor

    def init(self, init: Callable[..., Any], *, context: Any = None, **options: Any) -> None:
        if self._is_about_another(context):
            init(context=context, **options)
            return
        print('rclpy.init() has nothing to do here: start() has initialized rclpy already. A program of your own needs '
              'this line.', file=sys.stderr)

    def shutdown(self, shutdown: Callable[..., Any], *, context: Any = None, **options: Any) -> None:
        if self._is_about_another(context):
            shutdown(context=context, **options)
            return
        print('rclpy.shutdown() has nothing to do here: it would end every node on the stage, so the stage keeps '
              'running. To end it, call stop(). A program of your own needs this line.', file=sys.stderr)

    def spin(self, spin: Callable[..., Any], node: Node, executor: Executor | None = None) -> None:
        self._refuse_to_wait(node)
        if _in_main_thread():
            raise _endless(node)
        spin(node, executor)

    def spin_once(self, spin_once: Callable[..., Any], node: Node, *, executor: Executor | None = None,
                  timeout_sec: float | None = None) -> None:
        self._refuse_to_wait(node)
        spin_once(node, executor=executor, timeout_sec=_limited(timeout_sec))

    def spin_until_future_complete(self, spin: Callable[..., Any], node: Node, future: Any,
                                   executor: Executor | None = None, timeout_sec: float | None = None) -> None:
        self._refuse_to_wait(node)
        spin(node, future, executor, _limited(timeout_sec))
        if not future.done() and _limited(timeout_sec) != timeout_sec:
            raise _in_vain('the future')

    def spin_executor(self, spin: Callable[..., Any], executor: Executor) -> None:
        nodes = executor.get_nodes()
        self._refuse_to_wait(*nodes)
        if _in_main_thread():
            raise _endless(next(iter(nodes), None))
        spin(executor)

    def spin_executor_until(self, spin: Callable[..., Any], executor: Executor, future: Any,
                            timeout_sec: float | None = None) -> None:
        if timeout_sec is None:
            self._refuse_to_wait()
        spin(executor, future, timeout_sec)

    def add_node(self, add_node: Callable[..., Any], executor: Executor, node: Node) -> Any:
        if executor is not self._own_executor and node in self._stage.nodes:
            self._refuse_to_wait(node)
        return add_node(executor, node)

    def call(self, call: Callable[..., Any], client: Client, request: Any, timeout_sec: float | None = None) -> Any:
        if timeout_sec is None:
            self._refuse_to_wait()
        answer = call(client, request, _limited(timeout_sec))
        if answer is None and _limited(timeout_sec) != timeout_sec:
            raise _in_vain(f'an answer from {client.srv_name}')
        return answer

    def _is_about_another(self, context: Any) -> bool:
        """True for another context than that of the stage; where a program runs, the default context is its own."""
        return (context or utilities.get_default_context()) is not self._own_executor.context

    def _refuse_to_wait(self, *nodes: Node) -> None:
        if self._stage.in_thread():
            raise ExecutorError(
                'this callback already runs inside the executor that it waits for, so the wait could never end: use '
                'call_async() and future.add_done_callback(...), or await the future in an async callback')
        for node in nodes:
            if node in self._stage.nodes:
                raise ExecutorError(
                    f'{node.get_fully_qualified_name()} is spun in the background already, and spinning it here would '
                    f'take it away from there: to wait for something in a cell, use wait_until(...)')


def _in_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def _limited(timeout_sec: float | None) -> float | None:
    """Return a time limit, also for a wait in a cell without one: Ctrl+C doesn't reach rclpy where it waits in C++."""
    is_endless = timeout_sec is None or timeout_sec < 0
    return WAIT_LIMIT_SEC if is_endless and _in_main_thread() else timeout_sec


def _endless(node: Node | None) -> ExecutorError:
    name = 'MyNode' if node is None or type(node) is Node else type(node).__name__
    return ExecutorError(
        f'spin() never returns, and no further cell would run: leave this line out. ros.add({name}) creates the node '
        f'and spins it in the background; to wait for something, use wait_until(...)')


def _in_vain(what: str) -> WaitTimeoutError:
    return WaitTimeoutError(
        f'timed out after {WAIT_LIMIT_SEC:g} s waiting for {what}. rclpy itself would wait forever; pass '
        f'timeout_sec=... to wait longer. Is what you wait for on the stage? ros.add(...) puts a node there')
