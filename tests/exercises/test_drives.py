"""Checks that show what a learner's work makes a robot do, solved or not."""

import pytest

from param_tutorial import exercises

FAST = {'max_speed_mps': 2.0, 'stop_distance_m': 2.5}


@pytest.mark.parametrize(('number', 'work', 'shown'), [
    ('1a', FAST, 'STOPPED. The robot stands 0.30 m from the wall.'),
    ('1a', {**FAST, 'stop_distance_m': 0.5}, 'CRASHED. The robot has hit the wall at 1.'),
    ('10.3a', {f'gains.wheel_joint.{name}': value for name, value in (('p', 0.4), ('i', 0.0), ('d', 0.0))},
     'overshoot 21.5 %'),
    ('11c', {'max_speed_mps': 1.0, 'stop_distance_m': 1.2}, 'STOPPED. The robot stands 0.10 m from the wall.'),
])
def test_what_the_robot_did_is_shown(number, work, shown):
    assert shown in exercises.check(number, work)._repr_html_()


@pytest.mark.parametrize('work', [{}, {'max_speed_mps': 0.0}])
def test_where_nothing_drove_there_is_no_picture(work):
    assert 'track-stage' not in exercises.check('1a', work).picture
