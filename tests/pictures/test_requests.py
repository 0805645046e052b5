"""The picture of requests in two ways: what is kept, what comes back, and what stands beside what."""

import re
from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.requests import Request, Requests


@pytest.fixture
def worlds():
    worlds = Requests('gain')
    worlds.add('ROS 1', '/robot', {'gain': '0.5'}, [Request('gain', '1', '1'), Request('gain', "'high'", "'high'")],
               server='master')
    worlds.add('ROS 2', '/robot', {'gain': '0.5'}, [Request('gain', '1', '0.5', 'wrong type'),
                                                    Request('gain', "'high'", '0.5', 'wrong type')])
    worlds.conclude('2 * gain = 1.0')
    return worlds


def drawn(requests):
    return ElementTree.fromstring(requests.html(motion.Reel('one', is_still=True)))


def classes(requests):
    return [part.get('class') for part in drawn(requests).iter()]


def heights(requests, text):
    return [part.get('y') for part in drawn(requests).iter() if part.text == text]


def test_both_sides_are_told_in_words(worlds):
    assert worlds.sentence == 'ROS 1: 2 of 2 accepted; ROS 2: 0 of 2 accepted.'
    assert worlds.text == (
        "gain. ROS 1, gain = 1 is accepted, and master keeps 1; gain = 'high' is accepted, and master keeps 'high'; "
        "/robot gets 'high' from master. ROS 2, gain = 1 is rejected (wrong type), and /robot keeps 0.5; "
        "gain = 'high' is rejected (wrong type), and /robot keeps 0.5; 2 * gain = 1.0.")


def test_ticks_and_crosses_tell_it_without_color(worlds):
    found = classes(worlds)
    assert found.count('motion-check') == found.count('motion-cross') == 2
    words = list(drawn(worlds).itertext())
    assert words.count('wrong type') == 2 and words.count("gets 'high'") == 1 and '2 * gain = 1.0' in words


def test_what_was_replaced_is_struck_and_what_stays_is_not(worlds):
    assert classes(worlds).count('motion-thick') == 1


def test_a_parameter_has_one_row_on_both_sides_also_where_it_is_not_sent():
    ways = Requests('back')
    has = {'low': '-30', 'mode': "'brisk'"}
    ways.add('all', '/robot', has, [Request('low', '-5', '-30', 'rejected'), Request('mode', "'calm'", "'calm'")])
    ways.add('one', '/robot', has, [Request('mode', "'calm'", "'calm'")], is_one=True)
    assert len(set(heights(ways, "'calm'"))) == 1 and len(set(heights(ways, '-30'))) == 1
    assert classes(ways).count('motion-faint') == 1
    assert "one, one request: mode = 'calm' is accepted" in ways.text


def test_one_request_travels_in_one_frame():
    one, each = Requests('back'), Requests('back')
    sent = [Request('low', '-5', '-5'), Request('high', '40', '40')]
    one.add('one', '/robot', {}, sent, is_one=True)
    each.add('each', '/robot', {}, sent)
    assert 'motion-dashed' in classes(one) and 'motion-dashed' not in classes(each)
    reels = motion.Reel('one'), motion.Reel('each')
    one.html(reels[0])
    each.html(reels[1])
    assert reels[0].duration_sec < reels[1].duration_sec


def test_the_frame_is_around_all_rows_in_whatever_order_they_are_sent():
    ways = Requests('back')
    low, high, mode = (Request(name, '1', '1') for name in ('low', 'high', 'mode'))
    ways.add('all', '/robot', {}, [mode, low, high])
    ways.add('one', '/robot', {}, [low, high, mode], is_one=True)
    frame = next(part.get('d') for part in drawn(ways).iter() if part.get('class') == 'motion-dashed')
    top, bottom = float(re.search(r'^M\S+ ([\d.]+)', frame)[1]), float(re.search(r'V([\d.]+)', frame)[1])
    assert all(top < float(y) < bottom for y in heights(ways, '1')) and len(set(heights(ways, '1'))) == 3


def test_it_ends_as_it_is_drawn_at_rest(worlds):
    reel = motion.Reel('one')
    moving, still = worlds.html(reel), worlds.html(motion.Reel('one', is_still=True))
    assert reel.moves and 'animation' not in still
    ends = [re.findall(r'style="((?:opacity|transform)[^";]*(?:;transform[^";]*)?)', picture)
            for picture in (moving, still)]
    # The line of words appears in the moving one only.
    assert [end for end in ends[0] if end != 'opacity:1'] == [end for end in ends[1] if end != 'opacity:1']


def test_what_cannot_be_drawn_is_rejected(worlds):
    with pytest.raises(ValueError, match='room for 2 sides'):
        worlds.add('ROS 3', '/robot', {}, [Request('gain', '1', '1')])
    with pytest.raises(ValueError, match='one request at least'):
        Requests('gain').add('ROS 2', '/robot', {}, [])
    with pytest.raises(ValueError, match='no side yet'):
        Requests('gain').conclude('nothing')


def test_names_and_values_are_text():
    requests = Requests('<s>')
    requests.add('<t>', '<n>', {}, [Request('<a>', '<v>', '<k>', '<o>')])
    assert {'<s>', '<t>', '<n> keeps', '<a> = <v>', '<k>', '<o>'} <= set(drawn(requests).itertext())
