"""The turning wheel: how far it turns, and when it is the same picture."""

import pytest

from param_tutorial.pictures.wheel import Wheel

STEADY = [(number / 100, 10.0) for number in range(301)]


def test_it_turns_as_far_as_the_speed_says():
    wheel = Wheel(STEADY)
    assert wheel.duration_sec == pytest.approx(3.0)
    assert wheel.angles[-1] == pytest.approx((3.0, 30.0))
    assert len(wheel.angles) < 45


def test_it_speeds_up_from_rest():
    wheel = Wheel([(0.0, 0.0), (1.0, 2.0), (2.0, 2.0)])
    assert [angle for _, angle in wheel.angles] == pytest.approx([0.0, 1.0, 3.0])


def test_the_same_motion_is_the_same_picture_and_another_one_is_not():
    assert Wheel(STEADY).html() == Wheel(STEADY).html()
    assert Wheel(STEADY).html() != Wheel(STEADY[:200]).html()


def test_at_rest_it_stands_where_it_has_turned_to():
    assert 'style="transform:rotate(1718.9deg);animation' in Wheel(STEADY).html()


def test_of_one_point_there_is_no_wheel():
    with pytest.raises(ValueError, match='two points'):
        Wheel(STEADY[:1])
