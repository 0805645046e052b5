"""Layers of a value: which one is on top, what a later source changes below, and that a wrong story is noticed."""

from xml.etree import ElementTree

import pytest

from param_tutorial.pictures import motion
from param_tutorial.pictures.layers import Layers

BLOCKS = [('default', 100), ('all.yaml', '/**', 300), ('robot.yaml', '/robot', 200), ('-p', '/**', 400)]


def drawn(layers):
    return ElementTree.fromstring(layers.html(motion.Reel('one', is_still=True)))


def test_the_last_layer_covers_the_others():
    layers = Layers('speed', [('default', 100), ('file', 180), ('-p', 200), ('set', 150)])
    assert repr(layers).splitlines() == ['set 150', '-p 200', 'file 180', 'default 100', 'speed = 150, from set.']
    assert layers.text == (
        'Layers of speed, from the top: set 150; -p 200; file 180; default 100. speed = 150, from set.')
    words = [text for text in drawn(layers).itertext() if text in ('covered', 'on top: this counts')]
    assert words.count('covered') == 3 and words.count('on top: this counts') == 1


def test_a_source_that_goes_into_a_covered_layer_stays_covered():
    layers = Layers('speed', BLOCKS, has=200)
    assert repr(layers).splitlines() == [
        '/robot: robot.yaml 200', '/**: all.yaml 300, then -p 400', 'default 100', 'speed = 200, from robot.yaml.']
    assert 'the node has 200' in ''.join(drawn(layers).itertext())


def test_what_the_layers_do_not_explain_is_said():
    layers = Layers('speed', BLOCKS, has=400)
    assert layers.sentence == 'The node has speed = 400, which these layers do not explain.'
    assert 'this counts' not in ''.join(drawn(layers).itertext())


def test_a_source_that_ends_with_its_value_says_it_once():
    layers = Layers('speed', [('default', 100), ('-p 400', 400)])
    assert repr(layers).splitlines() == ['-p 400', 'default 100', 'speed = 400, from -p 400.']
    assert {'-p 400', 'default: 100'} < set(drawn(layers).itertext())


def test_sources_are_text():
    assert '<b>: 1' in drawn(Layers('speed', [('<b>', 1)])).itertext()


def test_layers_of_nothing_are_rejected():
    with pytest.raises(ValueError, match='one source'):
        Layers('speed', [])
