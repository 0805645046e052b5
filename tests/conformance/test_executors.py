"""Executors, callback groups, timers, guard conditions, tasks and futures."""

import threading

import pytest
from builtin_interfaces.msg import Time
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.executors import (
    ExternalShutdownException,
    MultiThreadedExecutor,
    SingleThreadedExecutor,
    TimeoutException,
)
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.task import Future


def test_spinning_once_does_one_thing(ros):
    node, heard = ros.node(), []
    for name in ('a', 'b'):
        guard = node.create_guard_condition(lambda name=name: heard.append(name))
        guard.trigger()
    ros.wait(lambda: heard)
    assert len(heard) == 1
    ros.wait(lambda: len(heard) == 2)
    assert sorted(heard) == ['a', 'b']


def test_without_work_spinning_takes_no_time_or_its_time(ros):
    ros.node()
    clock = Clock(clock_type=ClockType.STEADY_TIME)
    ros.executor.spin_once(timeout_sec=0)
    for timeout, least in ((0.2, 0.19), (0, 0)):
        before = clock.now()
        ros.executor.spin_once(timeout_sec=timeout)
        assert (clock.now() - before).nanoseconds >= least * 1e9
    with pytest.raises(TimeoutException):
        next(ros.executor.wait_for_ready_callbacks(timeout_sec=0))


def test_timers(ros):
    node, heard = ros.node(), []
    timer = node.create_timer(0.01, lambda: heard.append(timer.time_since_last_call()))
    assert timer.timer_period_ns == 10**7
    ros.wait(lambda: len(heard) == 3)
    timer.cancel()
    assert timer.is_canceled()
    assert not timer.is_ready()
    assert timer.time_until_next_call() is None
    ros.executor.spin_once(timeout_sec=0.05)
    assert len(heard) == 3
    timer.timer_period_ns = 3 * 10**7
    timer.reset()
    assert 0 < timer.time_until_next_call() <= 3 * 10**7
    ros.wait(lambda: len(heard) == 4)
    node.destroy_timer(timer)


@pytest.fixture
def clock(ros):
    """Return a clock of ROS time that stands at 1000 ns."""
    ros.node()
    clock = layer.Clock(ClockType.ROS_TIME)
    clock.set_ros_time_override_is_enabled(True)
    clock.set_ros_time_override(layer.rcl_time_point_t(1000, ClockType.ROS_TIME))
    return clock


def test_a_timer_that_was_late_keeps_its_beat(ros, clock):
    timer = layer.Timer(clock, ros.context.handle, 100, True)
    for now, is_ready, until in ((1050, False, 50), (1100, True, 0), (1101, True, 99), (1350, True, 50),
                                 (1400, True, 100)):
        clock.set_ros_time_override(layer.rcl_time_point_t(now, ClockType.ROS_TIME))
        assert timer.is_timer_ready() is is_ready, now
        if is_ready and now != 1100:
            timer.call_timer()
        assert timer.time_until_next_call() == until, now
    # After a jump back beyond its last call, it waits for one period.
    clock.set_ros_time_override(layer.rcl_time_point_t(500, ClockType.ROS_TIME))
    assert timer.time_until_next_call() == 100
    assert timer.time_since_last_call() == 0
    timer.cancel_timer()
    with pytest.raises(layer.RCLError, match='timer is canceled'):
        timer.call_timer()
    with pytest.raises(layer.RCLError, match='period must be non-negative'):
        layer.Timer(clock, ros.context.handle, -1, True)
    assert layer.Timer(clock, ros.context.handle, 1, False).is_timer_canceled()


def test_what_is_left_of_a_timers_period_when_ros_time_goes(ros, clock):
    hour = 3600 * 10**9
    timer = layer.Timer(clock, ros.context.handle, hour, True)
    clock.set_ros_time_override(layer.rcl_time_point_t(1000 + hour // 4, ClockType.ROS_TIME))
    clock.set_ros_time_override_is_enabled(False)
    # rcl takes what is left for what is over.
    assert hour // 4 - hour // 60 < timer.time_until_next_call() <= hour // 4


def test_one_thread_calls_one_callback_at_a_time_and_several_do_not(ros):
    node = ros.node()
    ros.executor.remove_node(node)
    for group, size in ((MutuallyExclusiveCallbackGroup(), 1), (ReentrantCallbackGroup(), 2)):
        executor = MultiThreadedExecutor(3, context=ros.context)
        running, most, calls, both = set(), [0], [], threading.Event()

        def callback(running=running, most=most, calls=calls, both=both, size=size):
            running.add(threading.get_ident())
            most[0] = max(most[0], len(running))
            if most[0] == size:
                both.set()
            both.wait(30)
            running.discard(threading.get_ident())
            calls.append(1)

        guards = [node.create_guard_condition(callback, callback_group=group) for _ in range(2)]
        executor.add_node(node)
        for guard in guards:
            guard.trigger()
        end = Clock(clock_type=ClockType.STEADY_TIME).now().nanoseconds + 60 * 10**9
        while len(calls) < 2:
            assert Clock(clock_type=ClockType.STEADY_TIME).now().nanoseconds < end
            executor.spin_once(timeout_sec=0.05)
        assert most == [size]
        executor.shutdown()
        for guard in guards:
            node.destroy_guard_condition(guard)


def test_a_callback_that_raises(ros):
    node = ros.node()
    node.create_guard_condition(lambda: 1 / 0).trigger()
    with pytest.raises(ZeroDivisionError):
        ros.wait(lambda: False)


def test_tasks_and_futures(ros):
    node = ros.node()
    begun, gate = [], Future()

    async def work(number):
        begun.append(number)
        return number + await gate

    task = ros.executor.create_task(work, 1)
    ros.wait(lambda: begun)
    assert not task.done()
    guard = node.create_guard_condition(lambda: gate.set_result(41))
    guard.trigger()
    assert ros.result(task) == 42
    failing = ros.executor.create_task(lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        ros.result(failing)
    canceled = Future(executor=ros.executor)
    canceled.cancel()
    ros.executor.spin_until_future_complete(canceled, 1)
    assert canceled.cancelled()


def test_a_future_that_is_not_done_in_time(ros):
    ros.node()
    future = Future()
    ros.executor.spin_until_future_complete(future, 0.05)
    assert not future.done()


def test_another_thread_wakes_an_executor_that_waits(ros):
    node, heard = ros.node(), []
    guard = node.create_guard_condition(lambda: heard.append(threading.current_thread()))
    # What the executor has still to do for itself.
    ros.executor.spin_once(timeout_sec=0)
    thread = threading.Thread(target=guard.trigger)
    thread.start()
    while not heard:
        ros.executor.spin_once()
    thread.join()
    assert heard == [threading.current_thread()]


def test_shutdown_ends_a_spin_in_another_thread(ros):
    node, raised = ros.node(), []
    begun = threading.Event()
    node.create_guard_condition(begun.set).trigger()

    def spin():
        try:
            ros.executor.spin()
        except ExternalShutdownException as error:
            raised.append(error)

    thread = threading.Thread(target=spin)
    thread.start()
    assert begun.wait(60)
    ros.context.shutdown()
    thread.join(60)
    assert not thread.is_alive()


def test_an_executor_that_has_been_shut_down(ros):
    node = ros.node()
    executor = SingleThreadedExecutor(context=ros.context)
    ros.executor.remove_node(node)
    executor.add_node(node)
    assert executor.shutdown()
    executor.spin()
    executor.spin_once(timeout_sec=0)
    assert executor.get_nodes() == []


def test_subscriptions_are_served_in_turn(ros):
    node, heard = ros.node(), []
    publishers = []
    for name in ('a', 'b'):
        node.create_subscription(Time, name, lambda message, name=name: heard.append((name, message.sec)), 10)
        publishers.append(node.create_publisher(Time, name, 10))
    ros.wait(lambda: all(each.get_subscription_count() for each in publishers))
    for number in range(3):
        for publisher in publishers:
            publisher.publish(Time(sec=number))
    ros.wait(lambda: len(heard) == 6)
    for name in ('a', 'b'):
        assert [number for topic, number in heard if topic == name] == [0, 1, 2]


def test_a_guard_condition_is_taken_once(ros):
    ros.node()
    with ros.context.handle:
        guard = layer.GuardCondition(ros.context.handle)
        guard.trigger_guard_condition()
        guard.trigger_guard_condition()
        for expected in ([guard.pointer], []):
            waits = layer.WaitSet(0, 1, 0, 0, 0, 0, ros.context.handle)
            waits.add_guard_condition(guard)
            waits.wait(0)
            assert waits.get_ready_entities('guard_condition') == expected
    guard.destroy_when_not_in_use()
