"""Beginning and end: contexts, signals, and destroying things in any order."""

import contextlib
import gc
import itertools
import signal

import pytest
import rclpy
from builtin_interfaces.msg import Time
from rcl_interfaces.srv import GetParameters
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


def test_what_is_left_after_shutdown(ros):
    node = ros.node()
    publisher = node.create_publisher(Time, 'topic', 1)
    client = node.create_client(GetParameters, 'service')
    timer = node.create_timer(100.0, print)
    ros.context.shutdown()
    assert node.get_fully_qualified_name() == '/node'
    assert publisher.topic_name == '/topic'
    assert not timer.is_ready()
    for attempt in (lambda: publisher.publish(Time()), publisher.get_subscription_count, node.get_node_names,
                    node.get_topic_names_and_types, lambda: node.count_publishers('/topic'), client.service_is_ready,
                    lambda: node.create_publisher(Time, 'other', 1), lambda: node.create_timer(1.0, print),
                    lambda: node.create_subscription(Time, 'other', print, 1),
                    lambda: node.create_guard_condition(print),
                    lambda: node.create_service(GetParameters, 'other', print)):
        with pytest.raises(layer.RCLError):
            attempt()


THINGS = ('publisher', 'subscription', 'client', 'service', 'timer', 'guard_condition', 'node')


@pytest.mark.parametrize('order', [*itertools.islice(itertools.permutations(THINGS), 0, None, 500)])
def test_destroying_in_any_order(ros, order):
    node = ros.node()
    things = {
        'publisher': node.create_publisher(Time, 'topic', 1),
        'subscription': node.create_subscription(Time, 'topic', print, 1),
        'client': node.create_client(GetParameters, 'service'),
        'service': node.create_service(GetParameters, 'service', print),
        'timer': node.create_timer(1.0, print),
        'guard_condition': node.create_guard_condition(print),
    }
    for name in order:
        if name == 'node':
            node.destroy_node()
        else:
            getattr(node, f'destroy_{name}')(things[name])
        ros.executor.spin_once(timeout_sec=0)
    for thing in things.values():
        with pytest.raises(layer.InvalidHandle), thing.handle:
            pass


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


def test_destroying_what_waits(ros):
    node, heard = ros.node(), []
    publisher = node.create_publisher(Time, 'topic', 10)
    subscription = node.create_subscription(Time, 'topic', heard.append, 10)
    ros.wait(publisher.get_subscription_count)
    publisher.publish(Time())
    node.destroy_subscription(subscription)
    ros.executor.spin_once(timeout_sec=0.05)
    assert heard == []


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
