"""Pictures of what was measured: what they ask a real node, what they show, and what they leave behind."""

import re

import pytest
from rclpy.node import Node

import param_tutorial
from param_tutorial import (
    CallsView,
    DeclarationsView,
    LayersView,
    LiftsView,
    ParameterClient,
    PlaneView,
    Rules,
    TrailView,
    WorldsView,
)
from param_tutorial.errors import ExecutorError, InvalidValueError, NodeNotFoundError
from tests.support.widgets import texts

DAYS = (0, 10, 20)


class Weather(Node):
    def __init__(self):
        super().__init__('weather')
        self.declare_parameter('low_c', -5)
        self.declare_parameter('high_c', 40)
        Rules(self).check(['low_c', 'high_c'], lambda low, high: low < high, 'low_c must be below high_c')


@pytest.fixture
def weather(ros):
    return ros.add(Weather)


def make_trail():
    view = TrailView('speed', ['parameter', 'wheel'])
    view.add('set', [100, ...], ('', 'parameter'))
    return view


# -- the trail -----------------------------------------------------------------------------------------------

def test_a_trail_grows_and_plays_anew_with_each_moment():
    view = make_trail()
    first = texts(view)
    view.add('drive', [100, 100], ('parameter', 'wheel'), note='it drives')
    assert 'drive: 100 arrives at wheel' in view.text and texts(view) != first
    assert repr(view) == '<TrailView: drive: it drives.>'
    assert view.node == 'speed'


def test_a_trail_without_moments_is_empty_and_still():
    assert 'Play again' not in texts(TrailView('speed', ['parameter']))


# -- declarations --------------------------------------------------------------------------------------------

def test_the_table_fills_with_defaults_and_overrides(ros):
    view = DeclarationsView(Weather, {'high_c': 30, 'hihg_c': 20})
    assert 'low_c: -5 arrives at the node has; declare_parameter -5, the node has -5.' in view.text
    assert 'high_c: 30 arrives at the node has; from outside 30, declare_parameter 40, the node has 30' in view.text
    assert 'hihg_c: 20 bounces off the node has (ignored); from outside 20; an override, never declared.' in view.text
    assert ParameterClient('/weather').get_parameter('high_c') == 30


def test_requests_from_outside_get_in_or_bounce(ros):
    view = DeclarationsView(Weather)
    view.set_parameter('high_c', 35)
    view.set_parameter('hihg_c', 20)
    assert 'set high_c: 35 arrives at the node has' in view.text
    assert 'set hihg_c: 20 bounces off the node has (rejected); from outside 20; undeclared.' in view.text


# -- layers --------------------------------------------------------------------------------------------------

def test_layers_are_shown_without_asking_anybody():
    view = LayersView('speed', [('default', 100), ('-p', 200)], has=200)
    assert repr(view) == '<LayersView: speed = 200, from -p.>'
    assert 'aria-label="Layers of speed' in view.snapshot()['html']
    view.close()


# -- lifts ---------------------------------------------------------------------------------------------------

def test_lifts_are_shown():
    view = LiftsView({'a': [(0, 0.0), (1, 1.0)], 'b': [(0, 0.0), (1, 0.5)]}, {0: 'start'})
    assert repr(view) == '<LiftsView: After 1 s: a at 1.00 m, b at 0.50 m.>'
    assert '@keyframes' in texts(view)


# -- the plane -----------------------------------------------------------------------------------------------

def test_the_plane_is_what_the_node_answers(weather):
    view = PlaneView(weather, {'low_c': DAYS, 'high_c': DAYS})
    assert repr(view) == '<PlaneView: The node takes 3 of 9 pairs.>'
    assert ParameterClient(weather).get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 40}


def test_ways_are_those_of_real_requests(weather):
    view = PlaneView(weather, {'low_c': DAYS, 'high_c': DAYS})
    view.go('one by one', {'low_c': 10, 'high_c': 20}, {'high_c': 5}, {'low_c': 0})
    view.go('atomically', {'low_c': 10, 'high_c': 20}, {'high_c': 5, 'low_c': 0})
    assert repr(view) == '<PlaneView: one by one: ends at (0, 20); atomically: ends at (0, 5).>'
    assert 'high_c = 5 is rejected, now (10, 20), low_c = 0 is accepted, now (0, 20)' in view.text
    assert ParameterClient(weather).get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 40}


def test_a_way_that_cannot_begin_is_rejected(weather):
    view = PlaneView(ParameterClient(weather), {'low_c': DAYS, 'high_c': DAYS})
    with pytest.raises(ValueError, match='does not take the start'):
        view.go('never', {'low_c': 20, 'high_c': 10}, {'high_c': 30})


def test_a_plane_has_two_parameters_of_a_node_that_is_there(weather, ros):
    with pytest.raises(ValueError, match='two parameters'):
        PlaneView(weather, {'low_c': DAYS})
    with pytest.raises(NodeNotFoundError):
        PlaneView('/nobody', {'low_c': DAYS, 'high_c': DAYS})


# -- worlds --------------------------------------------------------------------------------------------------

def test_a_world_that_is_added_is_played():
    view = WorldsView('speed')
    before = texts(view)
    view.add('ROS 2', {'/robot': 900}, killed='/robot', successor=100)
    assert repr(view) == '<WorldsView: ROS 2: the new /robot has 100.>'
    assert '@keyframes' in texts(view) and texts(view) != before


# -- service calls -------------------------------------------------------------------------------------------

def test_calls_are_real_and_show_what_came_back(weather):
    view = CallsView()
    view.call(weather, 'get_parameters', ['low_c', 'high_c'])
    assert 'carries low_c; high_c. /weather answers get_parameters. The answer carries -5; 40.' in view.text
    view.call('weather', 'get_parameters', ['low_c', 'wings'])
    assert 'The answer carries no values at all.' in view.text
    view.call('/weather', 'list_parameters', ['nothing'])
    assert 'The answer carries no names at all.' in view.text
    assert repr(view) == '<CallsView: /weather answers list_parameters.>' and view.node == 'this notebook'


def test_each_value_has_a_result_and_an_atomic_request_has_one(weather):
    view, pair = CallsView(), {'high_c': 30, 'low_c': 'cold'}
    view.call(weather, 'set_parameters_atomically', pair)
    assert 'The answer carries rejected: wrong type.' in view.text
    view.call(weather, 'set_parameters', pair)
    assert "carries high_c = 30; low_c = 'cold'. /weather answers set_parameters, 1 of 2 rejected." in view.text
    assert 'The answer carries accepted; rejected: wrong type.' in view.text
    view.call(weather, 'set_parameters', {'low_c': 50})
    assert view.text.endswith('The answer carries rejected.')
    assert ParameterClient(weather).get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 30}


def test_who_is_not_there_and_who_does_not_answer_are_told_apart(weather):
    dozing, view = Node('dozing'), CallsView(timeout_sec=.2)
    view.call('/wether', 'get_parameters', ['low_c'])
    assert 'Nobody takes the request get_parameters for /wether. There is no node /wether. Did you mean' in view.text
    param_tutorial.wait_until(lambda: '/dozing' in node_names(), 'the dozing node to be seen')
    view.call('/dozing', 'list_parameters')
    assert repr(view) == '<CallsView: /dozing gets the request list_parameters, and no answer comes.>'
    dozing.destroy_node()


def node_names():
    return param_tutorial.start().services.node_names()


def test_what_cannot_be_asked_is_said_and_adds_nothing(weather):
    view = CallsView()
    with pytest.raises(ValueError, match='a CallsView calls get_parameters, '):
        view.call(weather, 'describe_parameters', ['low_c'])
    with pytest.raises(InvalidValueError):
        view.call(weather, 'set_parameters', {'low_c': object()})
    param_tutorial.stop()
    with pytest.raises(ExecutorError):
        view.call('/weather', 'list_parameters')
    assert repr(view) == '<CallsView: Nothing has been asked yet.>'


# -- all of them ---------------------------------------------------------------------------------------------

def make_calls():
    view = CallsView()
    view.call('/weather', 'get_parameters', ['low_c'])
    return view


VIEWS = {'calls': make_calls, 'worlds': lambda: WorldsView('speed'),
         'layers': lambda: LayersView('speed', [('default', 100)]),
         'trail': make_trail, 'declarations': lambda: DeclarationsView(Weather),
         'lifts': lambda: LiftsView({'a': [(0, 0.0), (1, 1.0)]}),
         'plane': lambda: PlaneView('/weather', {'low_c': DAYS, 'high_c': DAYS})}


@pytest.mark.parametrize('make', VIEWS.values(), ids=VIEWS)
def test_each_has_a_still_for_a_page_without_a_kernel(weather, make):
    view = make()
    recorded = view.snapshot()
    assert recorded['kind'] == 'still' and recorded['text'] == repr(view)
    assert re.search(r'<div class="motion">.*role="img" aria-label="[^"]', recorded['html'], re.DOTALL)
    assert 'prefers-reduced-motion' in recorded['html']


@pytest.mark.parametrize('make', VIEWS.values(), ids=VIEWS)
def test_each_can_be_closed_twice_and_outlives_the_stage(weather, make):
    view = make()
    param_tutorial.stop()
    view.close()
    view.close()
    assert 'closed' in repr(view)
