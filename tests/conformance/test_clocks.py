"""Timers by a clock whose time is set."""

import pytest
from rclpy.clock import ClockType, ROSClock
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.time import Time


@pytest.mark.parametrize('times, calls', [
    ([3, 10], [0, 1]), ([3, 5, 6.5, 7], [0, 1, 1, 1]), ([3, 4, 5], [0, 1, 1]), ([3, 8, 3.5, 4.5], [0, 1, 0, 1])])
def test_a_timer_is_due_once_however_far_its_clock_jumps(ros, times, calls):
    ros.init()
    clock, timer = ROSClock(), None
    clock._set_ros_time_is_active(True)
    for seconds, expected in zip(times, calls):
        clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
        timer = timer or layer.Timer(clock.handle, ros.context.handle, 10**9, True)
        found = 0
        while timer.is_timer_ready():
            timer.call_timer()
            found += 1
        assert found == expected
