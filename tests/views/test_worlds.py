"""The picture of two worlds: who keeps a value, and what the successor of a killed node begins with."""

import pytest

from param_tutorial.views.drawing.worlds import Worlds
from tests.support.drawings import kinds, words


@pytest.fixture
def worlds():
    worlds = Worlds('speed')
    worlds.add('ROS 1', {'/robot': 900}, server='master', killed='/robot', successor='900')
    worlds.add('ROS 2', {'/robot': 150, '/robot2': 900}, killed='/robot2', successor=100)
    return worlds


def test_both_worlds_are_told_in_words(worlds):
    assert worlds.sentence == 'ROS 1: the new /robot has 900; ROS 2: the new /robot2 has 100.'
    assert worlds.text == (
        'Who keeps speed. ROS 1: master keeps /robot/speed = 900; /robot is killed; a new /robot starts with '
        'speed = 900. ROS 2: /robot keeps speed = 150; /robot2 keeps speed = 900; /robot2 is killed; a new /robot2 '
        'starts with speed = 100.')


def test_the_server_keeps_what_the_node_does_not(worlds):
    assert words(worlds).count('keeps nothing') == 1
    assert {'/robot/speed = 900', 'gets 900', 'killed, and 900 with it', 'from its code', '= 100'} <= set(words(worlds))


def test_a_killed_node_is_marked_by_shape_and_word_and_the_other_is_still_there(worlds):
    assert kinds(worlds).count('token-bad') == kinds(worlds).count('cross') == 2
    assert words(worlds).count('still there') == 1


def test_there_is_room_for_two(worlds):
    with pytest.raises(ValueError, match='room for 2 worlds'):
        worlds.add('ROS 3', {'/robot': 1}, killed='/robot', successor=1)
