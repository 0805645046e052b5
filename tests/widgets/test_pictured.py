"""Pictures of what was measured: what they ask a real node, what they show, and what they leave behind."""

import re

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node

import param_tutorial
from param_tutorial import (
    CallsView,
    ChecksView,
    DeclarationsView,
    LayersView,
    LiftsView,
    ParameterClient,
    PlaneView,
    RequestsView,
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


# -- the plane -----------------------------------------------------------------------------------------------

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


@pytest.mark.slow
def test_a_plane_has_two_parameters_of_a_node_that_is_there(weather, ros):
    with pytest.raises(ValueError, match='two parameters'):
        PlaneView(weather, {'low_c': DAYS})
    with pytest.raises(NodeNotFoundError):
        PlaneView('/nobody', {'low_c': DAYS, 'high_c': DAYS})


# -- checks and requests -------------------------------------------------------------------------------------

class Strict(Node):
    def __init__(self):
        super().__init__('strict')
        limits = [IntegerRange(from_value=0, to_value=100, step=10)]
        self.declare_parameter('speed', 50, ParameterDescriptor(integer_range=limits))
        self.declare_parameter('serial', 50, ParameterDescriptor(integer_range=limits, read_only=True))
        self.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(successful=parameters[0].value != 60, reason='it rattles'))


def test_a_request_is_stopped_by_the_first_check_that_it_fails(ros):
    """Each but the last is wrong for its own check and for all later ones that can see it."""
    view = ChecksView(ros.add(Strict), [
        ('sped', 'x'), ('serial', 'x'), ('serial', 905), ('speed', None), ('speed', '60'), ('speed', 905),
        ('speed', 45), ('speed', 60), ('speed', 70)])
    stopped = re.findall(r'(\w+ = \S+) .*?(?:stopped at ([\w -]+):|is (stored))', view.text)
    assert stopped == [
        ("sped = 'x'", 'declared', ''), ("serial = 'x'", 'read-only', ''), ('serial = 905', 'read-only', ''),
        ('speed = None', 'type', ''), ("speed = '60'", 'type', ''), ('speed = 905', 'range', ''),
        ('speed = 45', 'step', ''), ('speed = 60', 'on-set callbacks', ''), ('speed = 70', '', 'stored')]
    assert repr(view) == '<ChecksView: 1 of 9 get through all checks.>' and view.node == '/strict'


def test_requests_one_by_one_and_as_one_show_what_the_node_keeps(weather):
    view, client = RequestsView('winter'), ParameterClient(weather)
    view.send('one by one', weather, {'high_c': -10, 'low_c': -30})
    assert repr(view) == '<RequestsView: one by one: 1 of 2 accepted.>'
    assert 'high_c = -10 is rejected (rejected by the node), and /weather keeps 40' in view.text
    view.send('as one', client, {'high_c': -10, 'low_c': -30}, atomically=True)
    view.conclude('cold')
    assert 'one request: high_c = -10 is accepted, and /weather keeps -10' in view.text and 'cold.' in view.text
    assert client.get_parameters(['low_c', 'high_c']) == {'low_c': -30, 'high_c': -10}


def test_what_fits_no_message_or_no_parameter_is_shown_as_rejected(weather):
    view = RequestsView('high_c')
    view.send('ROS 2', '/weather', [('high_c', [1, 'two']), ('high_c', 'hot'), ('hihg_c', 1)])
    assert "high_c = [1, 'two'] is rejected (no type for it), and /weather keeps 40" in view.text
    assert "high_c = 'hot' is rejected (wrong type), and /weather keeps 40" in view.text
    assert 'hihg_c = 1 is rejected (undeclared), and /weather keeps nothing' in view.text


def test_a_lenient_world_takes_everything_and_a_third_side_sends_nothing(weather):
    view = RequestsView('high_c')
    for title in ('ROS 1', 'once more'):
        view.add_lenient(title, '/weather', {'high_c': 40}, [('high_c', 'hot')], server='master')
    assert "ROS 1, high_c = 'hot' is accepted, and master keeps 'hot'; /weather gets 'hot' from master." in view.text
    with pytest.raises(ValueError, match='room for 2 sides'):
        view.send('ROS 2', weather, {'high_c': 20})
    assert ParameterClient(weather).get_parameter('high_c') == 40


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


@pytest.mark.slow
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


VIEWS = {'calls': make_calls, 'checks': lambda: ChecksView('/weather', [('low_c', -6)]),
         'requests': lambda: RequestsView('speed'), 'worlds': lambda: WorldsView('speed'),
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
