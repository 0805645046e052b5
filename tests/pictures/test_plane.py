"""The plane of two parameters: what the node takes, and the ways of requests."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.plane import Plane

DAYS = (0, 10, 20)
ANSWERS = {(low, high): low < high for low in DAYS for high in DAYS}


@pytest.fixture
def plane():
    return Plane(('low', 'high'), ANSWERS)


def drawn(plane):
    return ElementTree.fromstring(plane.html(motion.Reel('one', is_still=True)))


def test_every_pair_that_was_asked_for_has_a_ring_or_a_cross(plane):
    parts = list(drawn(plane).iter())
    rings = [part for part in parts if part.tag == 'circle']
    # One of each is that of the legend.
    assert len(rings) == 3 + 1
    assert sum(part.get('class') == 'motion-line motion-faint' for part in parts) == 6 + 1
    assert plane.sentence == 'The node takes 3 of 9 pairs.'


def test_a_way_with_a_rejected_request_ends_where_the_node_is(plane):
    plane.add_way('one by one', (10, 20), [('high = 0', (10, 0), (10, 20)), ('low = 0', (0, 20), (0, 20))])
    assert plane.sentence == 'one by one: ends at (0, 20).'
    assert ('one by one, from (10, 20): high = 0 is rejected, now (10, 20), low = 0 is accepted, now (0, 20).'
            in plane.text)
    picture = drawn(plane)
    # In the plane, and beside the words.
    assert sum(part.get('class') == 'motion-cross' for part in picture.iter()) == 2
    assert sum(part.get('class') == 'motion-check' for part in picture.iter()) == 1
    assert {'high = 0', 'rejected: now (10, 20)', 'accepted: now (0, 20)'} <= set(picture.itertext())


def test_a_rejected_request_springs_back(plane):
    plane.add_way('way', (10, 20), [('high = 0', (10, 0), (10, 20))])
    marker = [part for part in drawn(plane).iter('g') if 'translate' in part.get('style', '')]
    start = next(part for part in drawn(plane).iter('circle') if part.get('class') == 'motion-dot')
    assert marker[-1].get('style').endswith(f'translate({start.get("cx")}px,{start.get("cy")}px)')


def test_the_second_way_is_recognizable_without_color(plane):
    for name in ('first', 'second'):
        plane.add_way(name, (0, 10), [('high = 20', (0, 20), (0, 20))])
    used = [part.get('class') for part in drawn(plane).iter('path')]
    assert 'motion-dashed' in used and 'motion-thick' in used


def test_what_lies_outside_of_the_pairs_still_has_its_place(plane):
    plane.add_way('far', (0, 10), [('high = 90', (0, 90), (0, 10))])
    for part in drawn(plane).iter('circle'):
        assert 0 <= float(part.get('cy') or 0) <= 410


@pytest.mark.parametrize('answers', [{}, {(0, 0): True}, {(0, 0): True, (1, 0): True}])
def test_a_plane_needs_two_directions(answers):
    with pytest.raises(ValueError, match='differ in both'):
        Plane(('a', 'b'), answers)


def test_a_way_needs_a_step(plane):
    with pytest.raises(ValueError, match='one step'):
        plane.add_way('nowhere', (0, 10), [])
