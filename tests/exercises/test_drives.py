"""Checks that show what solved work does: in 1b the robot parks, and in 11f the cart drives."""

import re

import pytest

from param_tutorial import exercises
from param_tutorial.exercises.chapters import ch01

PARKED = {'sensor_offset_meters': -0.15, 'max_speed_rpm': 95, 'max_acceleration_mps2': 2.0,
          'min_operating_temperature_c': -10}


def test_solved_work_shows_the_robot_parking_in_the_cold():
    result = exercises.check('1b', PARKED)
    assert result.done, result
    shown = result._repr_html_()
    assert 'aria-label="STOPPED. Clawbot has stopped 0.50 m from the wall.' in shown
    assert 'robot-snow' in shown
    assert re.findall(r'step-end">([A-Z ]+)</span>', shown) == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']


def test_the_cart_drives_as_it_was_tuned():
    result = exercises.check('11f', lambda client: client.set_parameters_atomically(
        {'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0}))
    assert result.done, result
    assert 'has reached the end of the aisle after 8.00 s' in result._repr_html_()


@pytest.mark.parametrize('work', [{}, {'max_speed_rpm': 50}])
def test_unsolved_work_is_not_shown(work):
    assert 'robot-stage' not in exercises.check('1b', work)._repr_html_()


@pytest.mark.slow
def test_a_picture_that_cannot_be_drawn_takes_nothing_from_the_result(monkeypatch):
    def fail(_):
        raise ZeroDivisionError
    monkeypatch.setattr(ch01.park, '_draw', fail)
    result = exercises.check('1b', PARKED)
    assert result.done and 'robot-stage' not in result._repr_html_()
