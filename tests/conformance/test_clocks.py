"""Timers by a clock whose time is set."""

import pytest
from rclpy.clock import ClockType, ROSClock
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.time import Time


@pytest.mark.parametrize('jumps, calls', [
    ([10.0], [1]), ([5.0, 6.5, 7.0], [1, 1, 1]), ([4.0, 5.0], [1, 1]), ([3.5, 8.0, 3.5, 4.5], [0, 1, 0, 1])])
def test_a_timer_is_due_once_however_far_its_clock_jumps(ros, jumps, calls):
    ros.init()
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    set_time = lambda seconds: clock.set_ros_time_override(  # noqa: E731
        Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
    set_time(3.0)
    timer = layer.Timer(clock.handle, ros.context.handle, 10**9, True)
    found = []
    for seconds in jumps:
        set_time(seconds)
        found.append(0)
        while timer.is_timer_ready():
            timer.call_timer()
            found[-1] += 1
    assert found == calls
