"""The number line: where values stand, and that it follows a real node."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

import param_tutorial
from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient
from param_tutorial.views import NumberLineView
from param_tutorial.views.drawing.number_line import Scale
from tests.support.widgets import texts
from tests.views.conftest import Robot, shows

GRIPPER = Scale(0, 85, 10)


@pytest.mark.parametrize(('scale', 'dots'), [
    (GRIPPER, [0, 10, 20, 30, 40, 50, 60, 70, 80, 85]),
    (Scale(0.0, 1.0, 0.1), pytest.approx([index / 10 for index in range(11)])),
    # Where any value will do, or too many would, there is a thick line.
    (Scale(0, 2), []), (Scale(0, 100_000, 1), []), (Scale(0, 1, is_range=False), [])])
def test_rings_are_the_steps_and_both_ends(scale, dots):
    assert scale.dots == dots


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


# -- the view ------------------------------------------------------------------------------------------------

def test_it_shows_what_is_asked_for_in_code_or_typed_below_it(robot, client):
    view = NumberLineView(robot, 'opening')
    assert view.text == 'Number line of opening of /robot: 0 to 85 in steps of 10; stored is 40. opening = 40'
    client.set_parameter('opening', 45)
    shows(view, 'opening = 45 is rejected; 40 stays. The parameter value for opening is not a valid step')
    *_, below = view.children
    below._handle_custom_msg({'asked': '50'}, [])
    shows(view, 'opening = 50 is stored.')
    assert below.outcome == 'opening = 50 is stored.'


def test_a_locked_number_one_without_limits_and_none_at_all(robot, client):
    locked, free = NumberLineView(robot, 'serial'), NumberLineView(robot, 'speed')
    client.set_parameter('serial', 8)
    shows(locked, 'no limits, read-only; stored is 7. serial = 8 is rejected; 7 stays.')
    client.set_parameter('speed', 900)
    # A callback trims it.
    shows(free, 'stored is 300')
    assert NumberLineView(robot, 'note').text == 'note is not a number.'
    assert 'no parameter wings' in NumberLineView(robot, 'wings').text


def test_asked_for_a_value_it_shows_what_comes_of_it_and_nothing_after(robot, client):
    asked, other = NumberLineView(client, 'opening', 45), NumberLineView(robot, 'opening')
    before = texts(asked)
    client.set_parameter('opening', 50)
    shows(other, 'opening = 50')
    assert repr(asked) == '<NumberLineView: opening = 45 is rejected; 40 stays.>' and texts(asked) == before
    assert len(asked.children) == len(other.children) - 1
    with pytest.raises(NodeNotFoundError, match='/nobody'):
        NumberLineView('nobody', 'opening', 1)


def test_it_follows_a_node_that_comes_back_also_on_the_next_stage_until_it_is_closed(ros, robot, client):
    view, other = NumberLineView(robot, 'opening'), NumberLineView(robot, 'opening')
    ros.remove(robot)
    param_tutorial.wait_until(lambda: 'stored' not in view.text, 'the node to be gone')
    ParameterClient(ros.add(Robot)).set_parameter('opening', 20)
    shows(view, 'stored is 20')
    view.close()
    param_tutorial.stop()
    param_tutorial.start().add(Robot)
    ParameterClient('/robot').set_parameter('opening', 30)
    shows(other, 'stored is 30')
    assert 'stored is 30' not in view.text and 'closed' in repr(view)
