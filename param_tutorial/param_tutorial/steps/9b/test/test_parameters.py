"""What holds for the driver, and for each parameter file of its package."""
from contextlib import contextmanager
from pathlib import Path

import rclpy
import yaml
from my_robot.driver_node import Driver, Limits
from rclpy.parameter import Parameter

FILES = sorted(Path(__file__).parents[1].glob('config/my_robot*.yaml'))


@contextmanager
def started(*words):
    """Start a driver with these words after --ros-args, and end it after the block."""
    rclpy.init(args=['--ros-args', *words])
    try:
        yield Driver()
    finally:
        rclpy.shutdown()


def test_each_file_reaches_the_driver():
    assert FILES
    for path in FILES:
        block, = yaml.safe_load(path.read_text()).values()
        with started('--params-file', str(path)) as driver:
            for name, value in block['ros__parameters'].items():
                assert driver.has_parameter(name), f'{path.name}: the driver has no {name}'
                assert driver.get_parameter(name).value == value, f'{path.name}: {name}'


def test_it_rejects_a_speed_from_which_it_cannot_brake():
    with started() as driver:
        answer, = driver.set_parameters([Parameter('max_speed_mps', value=2.0)])
        assert not answer.successful


def test_the_limits_change_together_and_only_once_they_are_stored():
    with started() as driver:
        before = driver.limits
        driver.set_parameters_atomically([Parameter('max_speed_mps', value=2.0)])
        assert driver.limits == before
        driver.set_parameters_atomically([Parameter('max_speed_mps', value=2.0),
                                          Parameter('stop_distance_m', value=2.5)])
        assert driver.limits == Limits(2.0, 2.5, 1.0)
        assert before == Limits(0.5, 0.5, 1.0)


def test_nobody_talks_the_brakes_stronger():
    with started('-p', 'braking_mps2:=0.8') as driver:
        answer, = driver.set_parameters([Parameter('braking_mps2', value=3.0)])
        assert not answer.successful
        assert driver.limits.braking_mps2 == 0.8


def test_a_start_chooses_the_depth_of_the_commands():
    with started('-p', 'qos_overrides./cmd_vel.publisher.depth:=1') as driver:
        assert driver.commands.qos_profile.depth == 1
