"""Checks that show what a learner's work makes a robot do, solved or not."""

import re

import pytest

from param_tutorial import exercises

PARKED = {'sensor_offset_meters': -0.15, 'max_speed_rpm': 95, 'max_acceleration_mps2': 2.0,
          'min_operating_temperature_c': -10}
ORDERED = """
client = ParameterClient(robot)
client.set_parameter('max_speed_rpm', 50)
client.set_parameter('enable_safety_mode', True)
robot.drive()
"""


def test_solved_work_shows_the_robot_parking_in_the_cold():
    result = exercises.check('1b', PARKED)
    assert result.done, result
    shown = result._repr_html_()
    assert 'aria-label="STOPPED. Clawbot has stopped 0.50 m from the wall.' in shown
    assert 'robot-snow' in shown
    assert re.findall(r'step-end">([A-Z ]+)</span>', shown) == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']


@pytest.mark.parametrize(('number', 'work', 'shown'), [
    ('1a', ORDERED, 'STOPPED. Clawbot has stopped 0.20 m from the wall.'),
    ('1a', ORDERED.replace('True', 'False'), 'CRASHED. Clawbot has run into the wall at 0.52 m/s.'),
    ('1b', {'max_speed_rpm': 50}, 'WAITING. Clawbot is waiting'),
    ('1b', {**PARKED, 'enable_safety_mode': False}, 'CRASHED. Clawbot has run into the wall'),
    ('10.3b', {f'gains.wheel_joint.{name}': value for name, value in (('p', 0.4), ('i', 0.0), ('d', 0.0))},
     'overshoot 21.5 %'),
    ('11f', lambda client: None, 'has reached the end of the aisle after 14.00 s'),
    ('11f', lambda client: client.set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0}),
     'has reached the end of the aisle after 8.00 s'),
])
def test_what_the_robot_did_is_shown(number, work, shown):
    assert shown in exercises.check(number, work)._repr_html_()


@pytest.mark.parametrize(('number', 'work'), [('1b', {}), ('1a', 'client.set_parameter("max_speed_rpm", 50)')])
def test_where_nothing_drove_there_is_no_picture(number, work):
    assert 'robot-stage' not in exercises.check(number, work)._repr_html_()
