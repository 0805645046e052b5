"""The simulated base drives as it is told, within what its motor can do, and reports the distance to its wall."""

import math

import pytest
from geometry_msgs.msg import Twist, Vector3
from rclpy.node import Node
from sensor_msgs.msg import Range

import param_tutorial
from param_tutorial import ParameterClient
from param_tutorial.nodes.base_node import TICK_SEC, BaseNode


class Resting(BaseNode):
    """A base whose timer does nothing, so that only ``step`` lets time pass."""

    def create_timer(self, *_):
        pass


@pytest.fixture
def base(ros):
    return ros.add(Resting)


def drive(base, speed_mps, duration_sec):
    """Repeat a command for a time, as a driver does at every tick."""
    for _ in range(round(duration_sec / TICK_SEC)):
        base.take_command(Twist(linear=Vector3(x=speed_mps)))
        base.step(TICK_SEC)


def test_a_command_and_a_distance_go_through_as_ordinary_messages(ros):
    base, driver, heard = ros.add(BaseNode), ros.add(Node, 'driver'), []
    driver.create_subscription(Range, 'distance', heard.append, 10)
    publisher = driver.create_publisher(Twist, 'cmd_vel', 10)
    driver.create_timer(TICK_SEC, lambda: publisher.publish(Twist(linear=Vector3(x=0.5))))
    param_tutorial.wait_until(lambda: base.speed_mps == 0.5 and heard and heard[-1].range < 9.9, 'the base to drive')
    assert base.commanded_mps == 0.5
    assert heard[-1].min_range <= heard[-1].range <= heard[-1].max_range
    assert heard[-1].header.frame_id == 'range_sensor'
    ros.remove(driver)
    param_tutorial.wait_until(lambda: base.commanded_mps == base.speed_mps == 0.0, 'the base to stop')


def test_speed_follows_the_command_within_the_acceleration_in_both_directions(base):
    drive(base, 0.8, 0.5)
    assert (base.speed_mps, base.position_m) == pytest.approx((0.5, 0.125))
    drive(base, 0.8, 1.0)
    assert base.speed_mps == pytest.approx(0.8)
    ParameterClient(base).set_parameter('max_acceleration_mps2', 4.0)
    drive(base, -0.2, 0.25)
    assert base.speed_mps == pytest.approx(-0.2)
    drive(base, -0.2, 10.0)
    assert (base.position_m, base.speed_mps, base.has_crashed) == (0.0, 0.0, False)


def test_without_a_command_it_stops_after_the_timeout(base):
    drive(base, 0.5, 1.0)
    base.step(0.45)
    assert base.speed_mps == base.commanded_mps == 0.5
    base.step(0.1)
    assert base.commanded_mps == 0.0
    base.step(0.5)
    assert base.speed_mps == 0.0


def test_the_wall_stops_it_once_and_a_reset_makes_it_whole(base, ros):
    ParameterClient(base).set_parameter('wall_m', 1.0)
    drive(base, 2.0, 3.0)
    assert (base.position_m, base.speed_mps, base.has_crashed, base.distance_m) == (1.0, 0.0, True, 0.0)
    drive(base, 2.0, 1.0)
    base.get_logger().info('The end.')
    log = ros.node_log.read(until='The end.')
    assert log.count('Crashed') == log.count('[WARN] [base]: Crashed: hit the wall at 1.45 m/s.') == 1
    base.reset()
    assert (base.position_m, base.has_crashed, base.commanded_mps, base.distance_m) == (0.0, False, 0.0, 1.0)


@pytest.mark.parametrize('speed', [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_no_command(base, speed):
    drive(base, 0.5, 0.5)
    drive(base, speed, 0.2)
    assert base.commanded_mps == 0.5
    drive(base, speed, 1.0)
    assert base.commanded_mps == base.speed_mps == 0.0
