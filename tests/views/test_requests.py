"""The picture of requests in two ways: what is kept, what comes back, and what stands beside what."""

import re

import pytest

from param_tutorial import ParameterClient
from param_tutorial.views import RequestsView
from param_tutorial.views.drawing.requests import Request, Requests
from param_tutorial.views.drawing.svg import Animation
from tests.support.drawings import drawn, kinds, words


@pytest.fixture
def worlds():
    worlds = Requests('gain')
    worlds.add('ROS 1', '/robot', {'gain': '0.5'}, [Request('gain', '1', '1'), Request('gain', "'high'", "'high'")],
               server='master')
    worlds.add('ROS 2', '/robot', {'gain': '0.5'}, [Request('gain', '1', '0.5', 'wrong type'),
                                                    Request('gain', "'high'", '0.5', 'wrong type')])
    worlds.conclude('2 * gain = 1.0')
    return worlds


def heights(requests, text):
    return [part.get('y') for part in drawn(requests).iter() if part.text == text]


def test_both_sides_are_told_in_words(worlds):
    assert worlds.sentence == 'ROS 1: 2 of 2 accepted; ROS 2: 0 of 2 accepted.'
    assert worlds.text == (
        "gain. ROS 1, gain = 1 is accepted, and master keeps 1; gain = 'high' is accepted, and master keeps 'high'; "
        "/robot gets 'high' from master. ROS 2, gain = 1 is rejected (wrong type), and /robot keeps 0.5; "
        "gain = 'high' is rejected (wrong type), and /robot keeps 0.5; 2 * gain = 1.0.")


def test_ticks_and_crosses_tell_it_without_color(worlds):
    assert kinds(worlds).count('check') == kinds(worlds).count('cross') == 2
    told = words(worlds)
    assert told.count('wrong type') == 2 and told.count("gets 'high'") == 1 and '2 * gain = 1.0' in told


def test_what_was_replaced_is_struck_and_what_stays_is_not(worlds):
    assert kinds(worlds).count('thick') == 1


def test_a_parameter_has_one_row_on_both_sides_also_where_it_is_not_sent():
    ways = Requests('back')
    has = {'low': '-30', 'mode': "'brisk'"}
    ways.add('all', '/robot', has, [Request('low', '-5', '-30', 'rejected'), Request('mode', "'calm'", "'calm'")])
    ways.add('one', '/robot', has, [Request('mode', "'calm'", "'calm'")], is_one=True)
    assert len(set(heights(ways, "'calm'"))) == 1 and len(set(heights(ways, '-30'))) == 1
    assert kinds(ways).count('faint') == 1
    assert "one, one request: mode = 'calm' is accepted" in ways.text


def test_one_request_travels_in_one_frame():
    one, each = Requests('back'), Requests('back')
    sent = [Request('low', '-5', '-5'), Request('high', '40', '40')]
    one.add('one', '/robot', {}, sent, is_one=True)
    each.add('each', '/robot', {}, sent)
    assert 'dashed' in kinds(one) and 'dashed' not in kinds(each)
    animations = Animation('one'), Animation('each')
    one.html(animations[0])
    each.html(animations[1])
    assert animations[0].duration_sec < animations[1].duration_sec


def test_the_frame_is_around_all_rows_in_whatever_order_they_are_sent():
    ways = Requests('back')
    low, high, mode = (Request(name, '1', '1') for name in ('low', 'high', 'mode'))
    ways.add('all', '/robot', {}, [mode, low, high])
    ways.add('one', '/robot', {}, [low, high, mode], is_one=True)
    frame = next(part.get('d') for part in drawn(ways).iter() if part.get('class') == 'motion-dashed')
    top, bottom = float(re.search(r'^M\S+ ([\d.]+)', frame)[1]), float(re.search(r'V([\d.]+)', frame)[1])
    assert all(top < float(y) < bottom for y in heights(ways, '1')) and len(set(heights(ways, '1'))) == 3


def test_there_is_room_for_two(worlds):
    with pytest.raises(ValueError, match='room for 2 sides'):
        worlds.add('ROS 3', '/robot', {}, [Request('gain', '1', '1')])


# -- the view ------------------------------------------------------------------------------------------------

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


def test_requests_are_put_into_another_order_and_sent_again_from_the_same_beginning(weather):
    client = ParameterClient(weather)
    has, wanted = {'low_c': -30, 'high_c': -10}, {'low_c': -5, 'high_c': 40}
    view = RequestsView('back')
    *_, below = view.children
    for title, as_one in (('one by one', False), ('as one', True)):
        client.set_parameters_atomically(has)
        view.send(title, client, wanted, atomically=as_one)
        view.conclude(lambda: f'low_c is {client.get_parameter("low_c")}')
    assert view._picture.sentence == 'one by one: 1 of 2 accepted; as one: 2 of 2 accepted.'
    assert below.items == ['low_c', 'high_c'] and 'low_c is -30. as one' in view.text
    below._handle_custom_msg({'chosen': ['high_c', 'low_c']}, [])
    assert view._picture.sentence == 'one by one: 2 of 2 accepted; as one: 2 of 2 accepted.'
    assert 'one by one, high_c = 40 is accepted' in view.text and 'low_c is -5. as one' in view.text
    assert (below.items, below.told) == (['high_c', 'low_c'], view.text) and client.get_parameter('low_c') == -5
    client.set_parameters_atomically({'low_c': 0, 'high_c': 1})
    below._handle_custom_msg({'chosen': ['low_c', 'high_c']}, [])
    assert view._picture.sentence == 'one by one: 1 of 2 accepted; as one: 2 of 2 accepted.'


def test_nothing_is_put_into_order_where_a_side_has_sent_nothing_or_a_name_twice(weather):
    view = RequestsView('high_c')
    *_, below = view.children
    view.send('ROS 2', weather, {'high_c': 20, 'low_c': 1})
    assert below.items
    view.add_lenient('ROS 1', '/weather', {'high_c': 40}, [('high_c', 'hot')], server='master')
    assert not below.items
    twice = RequestsView('high_c')
    twice.send('ROS 2', weather, [('high_c', 20), ('low_c', 1), ('high_c', 2)])
    assert not twice.children[-1].items
