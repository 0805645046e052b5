"""Layers of a value: which one is on top, what a later source changes below, and that a wrong story is noticed."""

import pytest
from rclpy.node import Node

import param_tutorial
from param_tutorial import ParameterClient
from param_tutorial.views import LayersView
from param_tutorial.views.drawing.layers import Layers
from tests.support.drawings import words

BLOCKS = [('default', 100), ('all.yaml', '/**', 300), ('robot.yaml', '/robot', 200), ('-p', '/**', 400)]


def test_the_last_layer_covers_the_others():
    layers = Layers('speed', [('default', 100), ('file', 180), ('-p', 200), ('set', 150)])
    assert layers.text == (
        'Layers of speed, from the top: set 150; -p 200; file 180; default 100. speed = 150, from set.')
    assert words(layers).count('covered') == 3 and words(layers).count('on top: this counts') == 1


def test_a_source_that_goes_into_a_covered_layer_stays_covered():
    layers = Layers('speed', BLOCKS, has=200)
    assert layers.text == ('Layers of speed, from the top: /robot: robot.yaml 200; /**: all.yaml 300, then -p 400; '
                           'default 100. speed = 200, from robot.yaml.')
    assert 'the node has 200' in words(layers)


def test_what_the_layers_do_not_explain_is_said():
    layers = Layers('speed', BLOCKS, has=400)
    assert layers.sentence == 'The node has speed = 400, which these layers do not explain.'
    assert 'on top' in words(layers) and 'on top: this counts' not in words(layers)


@pytest.mark.parametrize('source', ['-p 400', '-p robot:speed:=400'])
def test_a_source_that_ends_with_its_value_says_it_once(source):
    layers = Layers('speed', [('default', 100), (source, 400)])
    assert layers.text == f'Layers of speed, from the top: {source}; default 100. speed = 400, from {source}.'
    assert {source, 'default: 100'} < set(words(layers))


# -- the view ------------------------------------------------------------------------------------------------

def test_sources_are_put_into_another_order_and_a_node_is_started_with_them(ros):
    class Robot(Node):
        def __init__(self, **options):
            super().__init__('robot', **options)
            self.declare_parameter('speed', 100)

    def start(*options):
        words = [word for option in options for word in ('-p', option)]
        return ros.add(Robot, ros_args=words).get_parameter('speed').value

    view = LayersView('speed', [('default', 100), ('speed:=400', '/**', 400), ('robot:speed:=500', 'robot', 500)],
                      start=start)
    *_, below = view.children
    assert 'speed = 500, from robot:speed:=500' in view.text and below.items == ['speed:=400', 'robot:speed:=500']
    below._handle_custom_msg({'chosen': ['robot:speed:=500', 'speed:=400']}, [])
    assert ParameterClient('/robot').get_parameter('speed') == 400
    assert below.told == view.text and view.text.endswith('speed = 400, from speed:=400.')
    param_tutorial.stop()
    below._handle_custom_msg({'chosen': ['speed:=400', 'robot:speed:=500']}, [])
    assert 'start()' in below.said and below.items == ['robot:speed:=500', 'speed:=400'] and below.answered == 2
    assert len(LayersView('speed', [('default', 100), ('file', 2)]).children) == len(view.children) - 1
