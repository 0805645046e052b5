"""Service calls: what is really asked, where requests end up, what answers carry, and the same in words."""

import pytest
from rclpy.node import Node

import param_tutorial
from param_tools.errors import ExecutorError, InvalidValueError
from param_tutorial import ParameterClient
from param_tutorial.views import CallsView
from param_tutorial.views.drawing.calls import Call, Calls, Line
from tests.support.drawings import drawn, kinds, rests, words

ANSWERED = Call('/arm', 'get_parameters', ('tool', 'kp'), (Line("''"), Line('2.0')))
MIXED = Call('/arm', 'set_parameters', ('kp = 3.0', 'tool = 5'),
             (Line('accepted', True), Line('rejected: wrong type', False)))
REJECTED = Call('/arm', 'set_parameters', ('tool = 5',), (Line('rejected: wrong type', False),))
LOST = Call('/amr', 'get_parameters', ('tool',), problem='there is no node /amr. Did you mean /arm?',
            is_delivered=False)
SILENT = Call('/dozing', 'list_parameters', (), problem='/dozing did not answer within 0.5 s')


def x_of_cards(call):
    """Return where each card of a call ends up, from the left."""
    markup = Calls('this notebook', [call])
    return [float(each.partition('(')[2].partition('px')[0])
            for part in drawn(markup).iter('g') for each in rests(f'style="{part.get("style", "")}"')]


def test_all_calls_are_told_in_words():
    assert Calls('me').sentence == 'Nothing has been asked yet.'
    assert Calls('me', [ANSWERED]).sentence == '/arm answers get_parameters.'
    assert Calls('me', [MIXED, LOST, SILENT]).text == (
        'Service calls of me. The request set_parameters to /arm carries kp = 3.0; tool = 5. /arm answers '
        'set_parameters, 1 of 2 rejected. The answer carries accepted; rejected: wrong type. The request '
        'get_parameters to /amr carries tool. Nobody takes the request get_parameters for /amr. There is no node '
        '/amr. Did you mean /arm? The request list_parameters to /dozing carries nothing. /dozing gets the request '
        'list_parameters, and no answer comes. /dozing did not answer within 0.5 s.')


def test_a_message_rests_where_it_has_arrived_or_where_its_way_has_ended():
    request, answer = x_of_cards(ANSWERED)
    assert answer < 300 < x_of_cards(LOST)[0] < 400 < request
    assert x_of_cards(SILENT) == pytest.approx([request], abs=40)
    lost, silent = Calls('me', [LOST]), Calls('me', [SILENT])
    assert {'cross', 'dashed'} <= set(kinds(lost)) and 'not there' in words(lost)
    assert {'(nothing)', 'no answer'} <= set(words(silent)) and 'cross' in kinds(silent)


def test_a_rejection_has_its_own_shape_and_word():
    mixed, rejected = Calls('me', [MIXED]), Calls('me', [REJECTED])
    assert {'check', 'cross'} <= set(kinds(mixed)) and 'token-bad' not in kinds(mixed)
    assert 'token-bad' in kinds(rejected) and 'check' not in kinds(rejected)
    assert 'rejected: wrong type' in words(rejected)


def test_a_long_answer_is_cut_and_says_so():
    shown = words(Calls('me', [Call('/arm', 'list_parameters', (), tuple(Line(f'p{number}') for number in range(9)))]))
    assert 'p2' in shown and 'p3' not in shown and '… and 6 more' in shown


# -- the view ------------------------------------------------------------------------------------------------

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
def test_a_node_that_is_not_there_and_one_that_does_not_answer_are_told_apart(ros, weather):
    dozing, view = Node('dozing'), CallsView(timeout_sec=.2)
    view.call('/wether', 'get_parameters', ['low_c'])
    assert 'Nobody takes the request get_parameters for /wether. There is no node /wether. Did you mean' in view.text
    param_tutorial.wait_until(lambda: '/dozing' in ros.services.node_names(), 'the dozing node to be seen')
    view.call('/dozing', 'list_parameters')
    assert repr(view) == '<CallsView: /dozing gets the request list_parameters, and no answer comes.>'
    dozing.destroy_node()


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
