"""Clocks, simulated time, jumps, and sleeping."""

import threading
import time

import pytest
from rclpy.clock import Clock, ClockChange, JumpThreshold, ROSClock
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.parameter import Parameter
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMessage


def test_what_clocks_say():
    for clock_type, now_ns in ((ClockType.SYSTEM_TIME, time.time_ns), (ClockType.ROS_TIME, time.time_ns),
                               (ClockType.STEADY_TIME, time.monotonic_ns)):
        before = now_ns()
        now = Clock(clock_type=clock_type).now()
        assert before <= now.nanoseconds <= now_ns()
        assert now.clock_type == clock_type


@pytest.mark.parametrize('clock_type', [ClockType.SYSTEM_TIME, ClockType.STEADY_TIME])
def test_only_ros_time_can_be_set(clock_type):
    clock = layer.Clock(clock_type)
    for ask in (clock.get_ros_time_override_is_enabled, lambda: clock.set_ros_time_override_is_enabled(True),
                lambda: clock.set_ros_time_override(layer.rcl_time_point_t(1, clock_type))):
        with pytest.raises(layer.RCLError, match='Clock is not of type RCL_ROS_TIME'):
            ask()
    with pytest.raises(layer.RCLError, match='Clock is not initialized'):
        layer.Clock(ClockType.UNINITIALIZED).get_now()
    with pytest.raises(layer.RCLError):
        layer.Clock(7)


def test_jumps():
    clock, heard = ROSClock(), []
    handles = [clock.create_jump_callback(threshold, pre_callback=lambda name=name: heard.append(name),
                                          post_callback=lambda jump, name=name: heard.append(
                                              (name, int(jump.clock_change), jump.delta.nanoseconds)))
               for name, threshold in (
                   ('change', JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True)),
                   ('forward', JumpThreshold(min_forward=Duration(nanoseconds=10), min_backward=None,
                                             on_clock_change=False)),
                   ('back', JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-10),
                                          on_clock_change=False)))]
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert clock.now().nanoseconds == 0
    assert heard == ['change', ('change', ClockChange.ROS_TIME_ACTIVATED, 0)]
    heard.clear()
    for now in (100, 105, 95, 85):
        clock.set_ros_time_override(Time(nanoseconds=now, clock_type=ClockType.ROS_TIME))
        assert clock.now().nanoseconds == now
    no_change = int(ClockChange.ROS_TIME_NO_CHANGE)
    assert heard == ['forward', ('forward', no_change, 100), 'back', ('back', no_change, -10), 'back',
                     ('back', no_change, -10)]
    for handle in handles:
        handle.unregister()
    clock._set_ros_time_is_active(False)
    assert clock.now().nanoseconds > 10**18


def test_a_jump_callback_that_raises():
    clock, heard = ROSClock(), []

    def fail(*_):
        raise ZeroDivisionError

    threshold = JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True)
    first = clock.create_jump_callback(threshold, post_callback=fail)
    second = clock.create_jump_callback(threshold, post_callback=heard.append)
    with pytest.raises(ZeroDivisionError):
        clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert heard == []
    first.unregister()
    second.unregister()


def test_simulated_time(ros):
    node, heard = ros.node(parameter_overrides=[Parameter('use_sim_time', value=True)]), []
    clock = ros.node('clock').create_publisher(ClockMessage, '/clock', 10)
    node.create_timer(1.0, lambda: heard.append(node.get_clock().now().nanoseconds))
    ros.wait(clock.get_subscription_count)
    assert node.get_clock().now().nanoseconds == 0
    for second in range(1, 4):
        message = ClockMessage()
        message.clock.sec = second
        clock.publish(message)
        ros.wait(lambda second=second: len(heard) == second)
    assert heard == [10**9, 2 * 10**9, 3 * 10**9]
    node.set_parameters([Parameter('use_sim_time', value=False)])
    assert node.get_clock().now().nanoseconds > 10**18


def test_sleeping(ros):
    ros.node()
    for clock_type in (ClockType.STEADY_TIME, ClockType.SYSTEM_TIME, ClockType.ROS_TIME):
        clock = Clock(clock_type=clock_type)
        before = clock.now()
        assert clock.sleep_for(Duration(nanoseconds=10**7), context=ros.context)
        assert (clock.now() - before).nanoseconds >= 10**7


def sleeping(ros, clock, seconds):
    """Return a thread that sleeps by a clock, and the list that will hold what the sleep returned."""
    ended, until = [], clock.now() + Duration(seconds=seconds)
    thread = threading.Thread(target=lambda: ended.append(clock.sleep_until(until, context=ros.context)))
    thread.start()
    return thread, ended


def test_a_clock_that_jumps_ends_a_sleep(ros):
    ros.node()
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    thread, ended = sleeping(ros, clock, 5)
    seconds = 5
    while thread.is_alive():  # until it sleeps, it hears of no jump
        clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
        seconds += 1
    assert ended == [True]


def test_shutdown_ends_a_sleep(ros):
    ros.node()
    clock, before = ROSClock(), len(ros.context._callbacks)
    clock._set_ros_time_is_active(True)
    thread, ended = sleeping(ros, clock, 5)
    while len(ros.context._callbacks) == before:
        assert thread.is_alive()
    ros.context.shutdown()
    thread.join(60)
    assert ended == [False]
