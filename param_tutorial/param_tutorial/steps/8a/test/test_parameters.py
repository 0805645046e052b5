"""What holds for the driver, and for each parameter file of its package."""
from contextlib import contextmanager
from pathlib import Path

import rclpy
import yaml
from my_robot.driver_node import Driver
from rclpy.parameter import Parameter

FILES = sorted(Path(__file__).parents[1].glob('config/*.yaml'))


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
