"""The number line: where values stand, which of them have a ring, and which traces a request leaves on it."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

import param_tutorial
from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient
from param_tutorial.views import NumberLineView
from param_tutorial.views.drawing.number_line import NumberLine, Request, Scale
from tests.support.drawings import drawn, kinds
from tests.support.widgets import texts
from tests.views.conftest import Robot, shows

GRIPPER = Scale(0, 85, 10)


def line(scale=GRIPPER, stored=40, **others):
    return NumberLine('/gripper', 'opening', scale, stored, **others)


def test_rings_are_the_steps_and_both_ends():
    assert GRIPPER.dots == [0, 10, 20, 30, 40, 50, 60, 70, 80, 85]
    assert Scale(-20, 52, 5).dots[-2:] == [50, 52]
    assert Scale(0.0, 1.0, 0.1).dots == pytest.approx([index / 10 for index in range(11)])
    assert kinds(line()).count('dot') == 10


@pytest.mark.parametrize('scale', [Scale(0, 2), Scale(0, 100_000, 1), Scale(0, 1, is_range=False)])
def test_where_any_value_will_do_there_is_a_thick_line(scale):
    assert scale.dots == [] and 'thick' in kinds(line(scale, 1))


@given(st.floats(allow_nan=False))
def test_what_is_outside_stands_outside_and_in_the_picture(value):
    x = GRIPPER.x(value)
    assert 0 < x < 720
    assert (x < GRIPPER.x(0)) == (value < 0) and (x > GRIPPER.x(85)) == (value > 85)
    assert GRIPPER.x(math.nan) < GRIPPER.x(0)


@given(st.lists(st.floats(-1e9, 1e9), min_size=1, max_size=3))
def test_without_a_range_every_value_has_its_place(values):
    scale = Scale.around(*values)
    assert scale.low <= min(values) <= max(values) <= scale.high and not scale.is_range
    assert scale.words == 'no limits'


@pytest.mark.parametrize(('facts', 'text', 'seen', 'unseen'), [
    ({}, 'stored is 40. opening = 40', {'fill'}, {'lock', 'cross'}),
    ({'stored': None}, 'stored is nothing. opening = nothing', set(), {'fill'}),
    ({'is_locked': True}, 'steps of 10, read-only; stored is 40. opening = 40', {'lock'}, set()),
    ({'stored': 85, 'before': 40, 'request': Request(85, '85')}, 'stored is 85. opening = 85 is stored.', set(),
     {'cross'}),
    ({'request': Request(45, '45', 'no step')}, 'opening = 45 is rejected; 40 stays. no step', {'cross', 'token-bad'},
     set()),
    # A value of another type has no place on the line.
    ({'request': Request(None, "'fast'", 'wrong type')}, "opening = 'fast' is rejected; 40 stays. wrong type",
     {'token-bad'}, {'cross'})])
def test_what_is_stored_and_what_was_asked_for_are_told_and_marked(facts, text, seen, unseen):
    picture = line(**facts)
    assert picture.text.startswith('Number line of opening of /gripper: 0 to 85 in ') and picture.text.endswith(text)
    assert seen <= set(kinds(picture)) and not unseen & set(kinds(picture))


def test_labels_leave_room_for_each_other():
    labels = [text for text in drawn(line(Scale(0, 60, 1), 1)).iter('text') if text.text.isdigit()]
    places = sorted(float(text.get('x')) for text in labels)
    assert all(right - left > 15 for left, right in pairwise(places))


# -- the view ------------------------------------------------------------------------------------------------

@pytest.mark.slow
def test_the_number_line_shows_range_value_and_request(robot, client):
    view = NumberLineView(robot, 'opening')
    assert view.text == 'Number line of opening of /robot: 0 to 85 in steps of 10; stored is 40. opening = 40'
    client.set_parameter('opening', 45)
    shows(view, 'opening = 45 is rejected; 40 stays. The parameter value for opening is not a valid step')
    client.set_parameter('opening', 85)
    shows(view, 'stored is 85. opening = 85 is stored.')


def test_a_locked_number_and_one_without_limits(robot, client):
    locked, free = NumberLineView(robot, 'serial'), NumberLineView(robot, 'speed')
    client.set_parameter('serial', 8)
    shows(locked, 'no limits, read-only; stored is 7. serial = 8 is rejected; 7 stays.')
    client.set_parameter('speed', -5)
    shows(free, 'speed = -5 is rejected')
    client.set_parameter('speed', 900)
    # A callback trims it.
    shows(free, 'stored is 300')


def test_the_number_line_of_no_number_says_so(robot):
    assert NumberLineView(robot, 'note').text == 'note is not a number.'
    assert 'no parameter wings' in NumberLineView(robot, 'wings').text


@pytest.mark.slow
def test_the_number_line_of_a_node_that_leaves_and_comes_back(ros, robot):
    view = NumberLineView(robot, 'opening')
    ros.remove(robot)
    shows(view, '/robot')
    param_tutorial.wait_until(lambda: 'stored' not in view.text, 'the node to be gone')
    ParameterClient(ros.add(Robot)).set_parameter('opening', 20)
    shows(view, 'stored is 20')


def test_a_value_is_typed_below_the_number_line_where_it_follows_the_node(robot):
    view = NumberLineView(robot, 'opening')
    *_, below = view.children
    below._handle_custom_msg({'chosen': '45'}, [])
    shows(view, 'opening = 45 is rejected; 40 stays.')
    below._handle_custom_msg({'chosen': '50'}, [])
    shows(view, 'opening = 50 is stored.')
    assert len(NumberLineView(robot, 'opening', 45).children) == len(view.children) - 1


def test_asked_for_a_value_it_shows_what_comes_of_it_and_nothing_after(robot, client):
    asked, other = NumberLineView(client, 'opening', 45), NumberLineView(robot, 'opening')
    before = texts(asked)
    client.set_parameter('opening', 50)
    shows(other, 'opening = 50')
    assert repr(asked) == '<NumberLineView: opening = 45 is rejected; 40 stays.>' and texts(asked) == before
    with pytest.raises(NodeNotFoundError, match='/nobody'):
        NumberLineView('nobody', 'opening', 1)


@pytest.mark.slow
def test_it_lets_go_of_a_node_and_follows_the_next_stage(robot, client):
    view, other = NumberLineView(robot, 'speed'), NumberLineView(robot, 'speed')
    client.set_parameter('speed', 5)
    shows(view, 'speed = 5')
    view.close()
    view.close()
    client.set_parameter('speed', 6)
    shows(other, 'speed = 6')
    assert 'speed = 6' not in view.text and 'closed' in repr(view)
    param_tutorial.stop()
    param_tutorial.start().add(Robot)
    ParameterClient('/robot').set_parameter('speed', 9)
    shows(other, '9')
