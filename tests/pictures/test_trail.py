"""The trail of values: what stands at rest, what travels, and which stories are rejected."""

import re
from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.trail import Trail


def drawn(trail):
    return ElementTree.fromstring(trail.html(motion.Reel('one', is_still=True)))


def classes(trail):
    return [part.get('class') for part in drawn(trail).iter()]


@pytest.fixture
def build():
    trail = Trail('node.py', ['src', 'install', 'the node'])
    trail.add('you edit', ['new', 'old', ...], ('', 'src'))
    trail.add('ros2 run', ['new', 'old', 'old'], ('install', 'the node'), note='the old code')
    return trail


def test_each_moment_says_what_moved_and_what_every_place_holds(build):
    assert build.text == (
        'node.py, moment by moment. you edit: new arrives at src; src new, install old. '
        'ros2 run: old arrives at the node; src new, install old, the node old; the old code.')
    assert build.sentence == 'ros2 run: the old code.'


def test_at_rest_every_value_stands_in_its_moment(build):
    words = list(drawn(build).itertext())
    assert words.count('new') == 2 and words.count('old') == 3
    assert classes(build).count('motion-token') == 2


def test_a_moving_reel_moves_and_a_still_one_shows_the_same_end(build):
    reel = motion.Reel('one')
    moving = build.html(reel)
    assert reel.moves
    still = build.html(motion.Reel('one', is_still=True))
    ends = [re.findall(r'style="(.*?)(?:;animation:[^"]*)?"', re.sub(r' style="opacity:1"', '', picture))
            for picture in (still, moving)]
    assert [end for end in ends[0] if 'transform' in end] == [end for end in ends[1] if 'transform' in end]


def test_what_is_not_taken_bounces_and_leaves_a_cross():
    trail = Trail('/robot', ['outside', 'node'])
    trail.add('set sped', [90, ...], ('outside', 'node', 90, 'rejected'), note='undeclared')
    assert trail.text.endswith('set sped: 90 bounces off node (rejected); outside 90; undeclared.')
    assert {'motion-cross', 'motion-token-bad'} <= set(classes(trail)) and 'motion-token' not in classes(trail)


def test_what_travels_over_a_value_strikes_it_out():
    trail = Trail('/robot', ['outside', 'default', 'node'])
    trail.add('speed', [150, ..., 150], ('outside', 'node'))
    assert 'motion-thick' not in classes(trail)
    trail.add('speed', [150, 100, 150], ('outside', 'node'))
    assert 'motion-thick' in classes(trail)


@pytest.mark.parametrize(('values', 'moves', 'words'), [
    ([1, 2, 3], [], '3 values for 2 places'),
    ([1, 2], [('a', 'c')], "'c' is not one of the places"),
    ([1, ...], [('a', 'b')], 'b holds nothing'),
])
def test_a_story_that_cannot_be_is_rejected(values, moves, words):
    with pytest.raises(ValueError, match=words):
        Trail('x', ['a', 'b']).add('now', values, *moves)


@pytest.mark.parametrize('places', [[], ['a', 'a']])
def test_places_are_there_and_are_told_apart(places):
    with pytest.raises(ValueError, match='each once'):
        Trail('x', places)


def test_names_and_values_are_text():
    trail = Trail('<x>', ['<a>'])
    trail.add('<now>', ['<b>'], ('', '<a>'), note='<note>')
    assert {'<x>', '<a>', '<now>', '<b>', '<note>'} <= set(drawn(trail).itertext())
