"""The plane of two parameters: what the node takes, and the ways of requests."""

import pytest

from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient
from param_tutorial.views import PlaneView
from param_tutorial.views.drawing.plane import Plane
from tests.support.drawings import drawn, kinds, words

DAYS = (0, 10, 20)
ANSWERS = {(low, high): low < high for low in DAYS for high in DAYS}


@pytest.fixture
def plane():
    return Plane(('low', 'high'), ANSWERS)


def test_every_pair_that_was_asked_for_has_a_ring_or_a_cross(plane):
    # One of each is that of the legend.
    assert len(list(drawn(plane).iter('circle'))) == 3 + 1
    assert kinds(plane).count('line faint') == 6 + 1
    assert plane.sentence == 'The node takes 3 of 9 pairs.'


def test_a_way_with_a_rejected_request_ends_where_the_node_is(plane):
    plane.add_way('one by one', (10, 20), [('high = 0', (10, 0), (10, 20)), ('low = 0', (0, 20), (0, 20))])
    assert plane.sentence == 'one by one: ends at (0, 20).'
    assert ('one by one, from (10, 20): high = 0 is rejected, now (10, 20), low = 0 is accepted, now (0, 20).'
            in plane.text)
    # In the plane, and beside the words.
    assert kinds(plane).count('cross') == 2 and kinds(plane).count('check') == 1
    assert {'high = 0', 'rejected: now (10, 20)', 'accepted: now (0, 20)'} <= set(words(plane))


def test_a_rejected_request_springs_back(plane):
    plane.add_way('way', (10, 20), [('high = 0', (10, 0), (10, 20))])
    marker = [part for part in drawn(plane).iter('g') if 'translate' in part.get('style', '')]
    start = next(part for part in drawn(plane).iter('circle') if part.get('class') == 'motion-dot')
    assert marker[-1].get('style').endswith(f'translate({start.get("cx")}px,{start.get("cy")}px)')


def test_the_second_way_is_recognizable_without_color(plane):
    for name in ('first', 'second'):
        plane.add_way(name, (0, 10), [('high = 20', (0, 20), (0, 20))])
    used = [part.get('class') for part in drawn(plane).iter('line')]
    assert used == ['motion-dashed', 'motion-thick']


# -- the view ------------------------------------------------------------------------------------------------

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
    with pytest.raises(ValueError, match='does not take the start'):
        view.go('never', {'low_c': 20, 'high_c': 10}, {'high_c': 30})
    assert ParameterClient(weather).get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 40}


@pytest.mark.slow
def test_a_plane_is_of_a_node_that_is_there(ros):
    with pytest.raises(NodeNotFoundError):
        PlaneView('/nobody', {'low_c': DAYS, 'high_c': DAYS})
