"""Beginning and end: contexts, signals, and what is destroyed while it is in use."""

import contextlib
import gc
import signal

import pytest
import rclpy
from builtin_interfaces.msg import Time
from rclpy.context import Context
from rclpy.exceptions import NotInitializedException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options


def test_a_context_begins_and_ends_once():
    context = Context()
    assert not context.ok()
    with pytest.raises(RuntimeError):
        context.shutdown()
    context.init(['program'])
    assert context.ok()
    with pytest.raises(RuntimeError, match='must only be called once'):
        context.init(['program'])
    heard = []
    context.on_shutdown(lambda: lambda: heard.append(1))
    context.shutdown()
    assert heard == [1]
    with pytest.raises(layer.RCLError, match='Failed to get domain id'):
        context.get_domain_id()
    with pytest.raises(layer.RCLError, match='rcl_shutdown already called on the given context'):
        context.shutdown()
    context.try_shutdown()
    with pytest.raises(NotInitializedException):
        Node('node', context=context)


def test_a_handle_in_use_stays_until_the_end_of_the_with(ros):
    node = ros.node()
    handle = layer.Publisher(node.handle, Time, 'topic', None)
    with handle:
        handle.destroy_when_not_in_use()
        assert handle.get_topic_name() == '/topic'
        with pytest.raises(layer.InvalidHandle, match='destruction was requested'), handle:
            pass
    ros.wait(lambda: node.count_publishers('/topic') == 0)
    with pytest.raises(RuntimeError, match='use_count would be negative'):
        handle.__exit__(None, None, None)


def test_what_nobody_holds_leaves_the_graph(ros):
    node = ros.node()
    handle = layer.Subscription(node.handle, Time, 'topic', None)
    ros.wait(lambda: node.count_subscribers('/topic') == 1)
    del handle
    gc.collect()
    ros.wait(lambda: node.count_subscribers('/topic') == 0)


def test_destroying_a_node_in_its_own_callback(ros):
    node, heard = ros.node(), []

    def end():
        heard.append(1)
        ros.executor.remove_node(node)
        node.destroy_node()

    node.create_timer(0.001, end)
    ros.wait(lambda: heard)
    ros.executor.spin_once(timeout_sec=0.05)
    assert heard == [1]


@pytest.mark.parametrize('number, raised', [
    (signal.SIGINT, KeyboardInterrupt), (signal.SIGTERM, ())])
def test_a_signal_shuts_down(number, raised):
    rclpy.init(args=['program'])
    context, executor, node = rclpy.get_default_context(), SingleThreadedExecutor(), rclpy.create_node('node')
    try:
        assert get_current_signal_handlers_options() == SignalHandlerOptions.ALL
        executor.add_node(node)
        node.create_timer(0.01, lambda: signal.raise_signal(number))
        with pytest.raises(raised) if raised else contextlib.suppress(ExternalShutdownException, layer.RCLError):
            executor.spin()
        while rclpy.ok():  # rcl does it in a thread of its own
            pass
    finally:
        node.destroy_node()
        executor.shutdown()
        # rclpy forgets this after a signal, and the next context would have the levels of this one.
        context._logging_fini()
        rclpy.try_shutdown()
        rclpy.signals.uninstall_signal_handlers()
    assert get_current_signal_handlers_options() == SignalHandlerOptions.NO
