"""The trail of values: what stands at rest, and what travels."""

import pytest
from rclpy.node import Node

from param_tutorial import ParameterClient, wait_until
from param_tutorial.views import CopiesView, DeclarationsView
from param_tutorial.views.drawing.trail import Trail
from tests.support.drawings import kinds, words
from tests.views.conftest import Weather


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
    assert words(build).count('new') == 2 and words(build).count('old') == 3
    assert kinds(build).count('token') == 2


def test_what_is_not_taken_bounces_and_leaves_a_cross():
    trail = Trail('/robot', ['outside', 'node'])
    trail.add('set sped', [90, ...], ('outside', 'node', 90, 'rejected'), note='undeclared')
    assert trail.text.endswith('set sped: 90 bounces off node (rejected); outside 90; undeclared.')
    assert {'cross', 'token-bad'} <= set(kinds(trail)) and 'token' not in kinds(trail)


def test_what_travels_over_a_value_strikes_it_out():
    trail = Trail('/robot', ['outside', 'default', 'node'])
    trail.add('speed', [150, ..., 150], ('outside', 'node'))
    assert 'thick' not in kinds(trail)
    trail.add('speed', [150, 100, 150], ('outside', 'node'))
    assert 'thick' in kinds(trail)


# -- the trail of a node's declarations ----------------------------------------------------------------------

def test_the_table_fills_with_defaults_and_overrides(ros):
    view = DeclarationsView(Weather, {'high_c': 30, 'hihg_c': 20})
    assert 'low_c: -5 arrives at the node has; declare_parameter -5, the node has -5.' in view.text
    assert 'high_c: 30 arrives at the node has; from outside 30, declare_parameter 40, the node has 30' in view.text
    assert 'hihg_c: 20 bounces off the node has (ignored); from outside 20; an override, never declared.' in view.text
    assert ParameterClient('/weather').get_parameter('high_c') == 30


def test_requests_from_outside_get_in_or_bounce(ros):
    view = DeclarationsView(Weather)
    view.set_parameter('high_c', 35)
    view.set_parameter('hihg_c', 20)
    assert 'set high_c: 35 arrives at the node has' in view.text
    assert 'set hihg_c: 20 bounces off the node has (rejected); from outside 20; undeclared.' in view.text


# -- the trail of a value through a node that copies, and one that reads -------------------------------------

class Copies(Node):
    def __init__(self):
        super().__init__('copies')
        self.speed = self.declare_parameter('speed', 1).value
        self.used = 0
        self.create_timer(0.01, self.drive)

    def drive(self):
        self.used = self.speed


class Reads(Node):
    def __init__(self):
        super().__init__('reads')
        self.declare_parameter('speed', 1)
        self.used = 0
        self.create_timer(0.01, self.drive)

    def drive(self):
        self.used = self.get_parameter('speed').value


def test_a_new_value_stops_at_the_parameter_of_the_node_that_copies(ros):
    copies, reads = ros.add(Copies), ros.add(Reads)
    wait_until(lambda: copies.used == reads.used == 1, 'both to use the first value')
    view = CopiesView(copies, reads, 'speed', used='used')
    view.set_parameter(2)
    assert view.text.endswith(
        '/copies parameter 2, /copies variable 1, /copies used 1, /reads parameter 2, /reads used 2; '
        'the copy is stale.')
