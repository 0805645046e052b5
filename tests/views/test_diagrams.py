"""The views of diagrams: what real nodes answer, also from the line below the picture; what all of them do."""

import re

import pytest
from rclpy.node import Node

import param_tutorial
from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient, views, wait_until
from tests.support.widgets import texts

SOME = range(0, 30, 10)


def ask(view, text):
    """Do what the browser does when a reader asks for a value below a picture, and return the line."""
    *_, below = view.children
    below._handle_custom_msg({'asked': text}, [])
    return below


@pytest.mark.parametrize('make', [
    views.CallsView,
    lambda: views.LadderView('/weather', 'low_c', -6),
], ids=['calls', 'ladder'])
def test_a_picture_of_what_was_measured_outlives_the_stage(weather, make):
    view = make()
    param_tutorial.stop()
    assert re.search(r'<div class="motion">.*role="img" aria-label="[^"]', texts(view), re.DOTALL)
    view.close()
    view.close()
    assert 'closed' in repr(view)


def test_what_is_added_is_played_and_a_closed_view_draws_no_more(weather):
    view = views.CallsView()
    assert 'Play again' not in texts(view)
    view.call(weather, 'get_parameters', ['low_c'])
    played = texts(view)
    assert '@keyframes' in played and repr(view) == '<CallsView: /weather answers get_parameters.>'
    view.close()
    view.call(weather, 'get_parameters', ['high_c'])
    assert view._drawn.value in played


# -- calls, planes -----------------------------------------------------------------------------------------

def test_calls_are_real_and_show_what_came_back(weather):
    view, pair = views.CallsView(), {'high_c': 30, 'low_c': 'cold'}
    view.call(weather, 'get_parameters', ['low_c', 'high_c'])
    assert 'carries low_c; high_c. /weather answers get_parameters. The answer carries -5; 40.' in view.text
    view.call('weather', 'get_parameters', ['low_c', 'wings'])
    assert view.text.endswith('The answer carries no values at all.')
    view.call('/weather', 'list_parameters', ['nothing'])
    assert view.text.endswith('The answer carries no names at all.')
    # Each value has a result, and an atomic request has one.
    view.call(weather, 'set_parameters_atomically', pair)
    assert view.text.endswith('The answer carries rejected: wrong type.')
    view.call(weather, 'set_parameters', pair)
    assert view.text.endswith('1 of 2 rejected. The answer carries accepted; rejected: wrong type.')
    assert repr(view) == '<CallsView: /weather answers set_parameters, 1 of 2 rejected.>'
    with pytest.raises(ValueError, match='a CallsView calls get_parameters, '):
        view.call(weather, 'describe_parameters', ['low_c'])


def test_a_node_that_is_not_there_and_one_that_does_not_answer_are_told_apart(ros, weather):
    dozing, view = Node('dozing'), views.CallsView(timeout_sec=.2)
    view.call('/wether', 'get_parameters', ['low_c'])
    assert 'Nobody takes the request get_parameters for /wether. There is no node /wether. Did you mean' in view.text
    wait_until(lambda: '/dozing' in ros.services.node_names(), 'the dozing node to be seen')
    view.call('/dozing', 'list_parameters')
    assert repr(view) == '<CallsView: /dozing gets the request list_parameters, and no answer comes.>'
    dozing.destroy_node()


def test_the_ways_in_a_plane_are_those_of_real_requests_and_the_node_has_what_it_had(weather):
    view = views.PlaneView(weather, {'low_c': SOME, 'high_c': SOME})
    assert repr(view) == '<PlaneView: The node takes 3 of 9 pairs.>'
    view.go('one by one', {'low_c': 10, 'high_c': 20}, {'high_c': 5}, {'low_c': 0})
    view.go('atomically', {'low_c': 10, 'high_c': 20}, {'high_c': 5, 'low_c': 0})
    assert repr(view) == '<PlaneView: one by one: ends at (0, 20); atomically: ends at (0, 5).>'
    assert 'high_c = 5 is rejected, now (10, 20), low_c = 0 is accepted, now (0, 20)' in view.text
    with pytest.raises(ValueError, match='does not take the start'):
        view.go('never', {'low_c': 20, 'high_c': 10}, {'high_c': 30})
    assert ParameterClient(weather).get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 40}


# -- the ladder ----------------------------------------------------------------------------------------------

def test_a_value_climbs_down_the_ladder_or_returns_from_it_and_another_is_typed(ros, robot):
    view = views.LadderView(robot, 'speed', 900)
    assert repr(view) == '<LadderView: speed = 900 is accepted, and 300 is stored.>' and view.node == '/robot'
    below = ask(view, '-5')
    assert 'judge rejects: minus five; stored is 300' in view.text and (below.name, below.text) == ('speed', '900')
    # With the type that `ros2 param set` would give it.
    ask(view, 'fast')
    assert 'an exception at pre-set callbacks, and the caller gets no answer' in view.text and below.problem == ''
    ros.remove(robot)
    before = view.text
    assert '/robot' in ask(view, '7').problem and view.text == before
    with pytest.raises(NodeNotFoundError, match='/nobody'):
        views.LadderView('nobody', 'speed', 1)
