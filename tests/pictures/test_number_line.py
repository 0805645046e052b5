"""The number line: where values stand, which of them have a ring, and which traces a request leaves on it."""

import math
from itertools import pairwise
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tutorial.pictures import motion
from param_tutorial.pictures.number_line import NumberLine, Request, Scale

GRIPPER = Scale(0, 85, 10)


def drawn(scale=GRIPPER, stored=40, **others):
    return ElementTree.fromstring(
        NumberLine('/gripper', 'opening', scale, stored, **others).html(motion.Reel('one', is_still=True)))


def classes(picture):
    return [part.get('class') for part in picture.iter()]


def test_rings_are_the_steps_and_both_ends():
    assert GRIPPER.dots == [0, 10, 20, 30, 40, 50, 60, 70, 80, 85]
    assert Scale(-20, 52, 5).dots[-2:] == [50, 52]
    assert Scale(0.0, 1.0, 0.1).dots == pytest.approx([index / 10 for index in range(11)])
    assert classes(drawn()).count('motion-dot') == 10


@pytest.mark.parametrize('scale', [Scale(0, 2), Scale(0, 100_000, 1), Scale(0, 1, is_range=False)])
def test_where_any_value_will_do_there_is_a_thick_line(scale):
    assert scale.dots == [] and 'motion-thick' in classes(drawn(scale, 1))


@given(st.floats(allow_nan=False))
def test_what_is_outside_stands_outside_and_in_the_picture(value):
    x = GRIPPER.x(value)
    assert 0 < x < 720
    assert (x < GRIPPER.x(0)) == (value < 0) and (x > GRIPPER.x(85)) == (value > 85)


def test_nan_has_a_place_of_its_own():
    assert GRIPPER.x(math.nan) < GRIPPER.x(0)


@given(st.lists(st.floats(-1e9, 1e9), min_size=1, max_size=3))
def test_without_a_range_every_value_has_its_place(values):
    scale = Scale.around(*values)
    assert scale.low <= min(values) <= max(values) <= scale.high and not scale.is_range
    assert scale.words == 'no limits'


def test_a_rejected_value_leaves_a_cross_and_the_nodes_words():
    line = NumberLine('/gripper', 'opening', GRIPPER, 40, request=Request(45, '45', 'no valid step'))
    assert line.text == ('Number line of opening of /gripper: 0 to 85 in steps of 10; stored is 40. '
                         'opening = 45 is rejected; 40 stays. no valid step')
    picture = drawn(request=Request(45, '45', 'no valid step'))
    assert {'motion-cross', 'motion-token-bad'} <= set(classes(picture))
    assert 'rejected: no valid step' in ''.join(picture.itertext())


def test_an_accepted_value_leaves_the_marker_at_its_place_and_no_cross():
    line = NumberLine('/gripper', 'opening', GRIPPER, 85, before=40, request=Request(85, '85'))
    assert line.text.endswith('stored is 85. opening = 85 is stored.')
    assert 'motion-cross' not in classes(drawn(stored=85, before=40, request=Request(85, '85')))


def test_a_value_of_another_type_has_no_place_on_the_line():
    picture = drawn(request=Request(None, "'fast'", 'wrong type'))
    assert 'motion-cross' not in classes(picture) and 'motion-token-bad' in classes(picture)


def test_a_locked_parameter_has_a_lock():
    assert 'motion-lock' in classes(drawn(is_locked=True)) and 'motion-lock' not in classes(drawn())
    assert 'read-only' in NumberLine('/g', 'serial', GRIPPER, 40, is_locked=True).text


def test_without_a_value_there_is_no_marker():
    assert 'motion-fill' not in classes(drawn(stored=None))
    assert 'stored is nothing' in NumberLine('/g', 'target', GRIPPER, None).text


def test_labels_leave_room_for_each_other():
    picture = drawn(Scale(0, 60, 1), 1)
    places = sorted(float(text.get('x')) for text in picture.iter('text') if text.text.isdigit())
    assert all(right - left > 15 for left, right in pairwise(places))
