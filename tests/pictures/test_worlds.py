"""The picture of two worlds: who keeps a value, and what the successor of a killed node begins with."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.worlds import Worlds


@pytest.fixture
def worlds():
    worlds = Worlds('speed')
    worlds.add('ROS 1', {'/robot': 900}, server='master', killed='/robot', successor='900')
    worlds.add('ROS 2', {'/robot': 150, '/robot2': 900}, killed='/robot2', successor=100)
    return worlds


def drawn(worlds):
    return ElementTree.fromstring(worlds.html(motion.Reel('one', is_still=True)))


def test_both_worlds_are_told_in_words(worlds):
    assert worlds.sentence == 'ROS 1: the new /robot has 900; ROS 2: the new /robot2 has 100.'
    assert worlds.text == (
        'Who keeps speed. ROS 1: master keeps /robot/speed = 900; /robot is killed; a new /robot starts with '
        'speed = 900. ROS 2: /robot keeps speed = 150; /robot2 keeps speed = 900; /robot2 is killed; a new /robot2 '
        'starts with speed = 100.')


def test_the_server_keeps_what_the_node_does_not(worlds):
    words = list(drawn(worlds).itertext())
    assert words.count('keeps nothing') == 1 and '/robot/speed = 900' in words and 'gets 900' in words
    assert 'killed, and 900 with it' in words and 'from its code' in words and '= 100' in words


def test_a_killed_node_is_marked_by_shape_and_word_and_the_other_is_still_there(worlds):
    picture = drawn(worlds)
    classes = [each.get('class') for each in picture.iter()]
    assert classes.count('motion-token-bad') == 2 and classes.count('motion-cross') == 2
    assert list(picture.itertext()).count('still there') == 1


def test_it_moves_and_ends_as_it_is_drawn_at_rest(worlds):
    assert '@keyframes' in worlds.html(motion.Reel('one'))
    assert 'Play again' not in list(drawn(worlds).itertext())


@pytest.mark.parametrize(('values', 'options', 'words'), [
    ({'/robot': 1}, {'killed': '/arm'}, "'/arm' is not one of the nodes"),
    ({'/robot': 1, '/arm': 2}, {'killed': '/arm', 'server': 'master'}, 'room for one node')])
def test_what_cannot_be_drawn_is_rejected(values, options, words):
    with pytest.raises(ValueError, match=words):
        Worlds('speed').add('here', values, successor=1, **options)


def test_there_is_room_for_two_worlds(worlds):
    with pytest.raises(ValueError, match='room for 2 worlds'):
        worlds.add('ROS 3', {'/robot': 1}, killed='/robot', successor=1)


def test_names_are_text():
    worlds = Worlds('<b>')
    worlds.add('<i>', {'/a': '<u>'}, killed='/a', successor='<u>')
    assert '= <u>' in drawn(worlds).itertext() and '<i>' in drawn(worlds).itertext()
