"""Values brought back: what restoring does, and what it says where it cannot."""

import hypothesis
import hypothesis.strategies as st
import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tools import ParameterSet, all_parameters, compare, restore, values
from param_tutorial import ParameterClient
from tests.support.nodes import Arm, Weather
from tests.support.strategies import VALUES

NAMES = ('a', 'b', 'c')
FULL_SETS = st.fixed_dictionaries(dict.fromkeys(NAMES, VALUES))


class Robot(Weather):
    def __init__(self, name='robot'):
        super().__init__(name)
        self.declare_parameter('speed', 100, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=300, step=1)]))
        self.declare_parameter('numbers', [1, 2])
        self.declare_parameter('serial', 'S1', ParameterDescriptor(read_only=True))
        self.declare_parameter('unset', Parameter.Type.DOUBLE)
        self.declare_parameter('any', 'free', ParameterDescriptor(dynamic_typing=True))


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(Robot))


def test_what_no_request_can_change_is_reported_and_the_rest_is_set(client):
    client.set_parameter('unset', 1.5)
    restored = restore(client, {'serial': 'S2', 'speed': 1.0, 'unset': None, 'nowhere': 1, 'low_c': 19, 'numbers': []})
    assert not restored.complete
    assert {each.name: each.word for each in restored} == {
        'serial': 'read only', 'speed': 'wrong type', 'unset': 'no value', 'nowhere': 'not declared', 'low_c': 'set',
        'numbers': 'set'}
    assert restored['speed'].reason == 'it is of type integer, not double'
    assert repr(restored).startswith('/robot from given values: NOT COMPLETE, 2 of 6 parameters set\n')
    assert client.get_parameters(['serial', 'speed', 'unset', 'low_c', 'numbers']) == {
        'serial': 'S1', 'speed': 100, 'unset': 1.5, 'low_c': 19, 'numbers': []}


def test_what_the_node_rejects_together_is_left_with_its_reason(client):
    restored = restore(client, {'low_c': 60, 'high_c': 50})
    assert {each.name: each.word for each in restored} == {'low_c': 'left', 'high_c': 'left'}
    assert restored['low_c'].reason == 'the node rejected them together: low_c must be below high_c'
    assert client.get_parameters(['low_c', 'high_c']) == {'low_c': -5, 'high_c': 40}
    alone = restore(client, {'speed': 301})['speed']
    assert (alone.word, 'out of range' in alone.reason) == ('rejected', True)


def test_a_node_that_stores_something_else_is_reported(ros, client):
    ros.nodes[0].add_pre_set_parameters_callback(lambda parameters: [
        Parameter(each.name, value=min(each.value, 200)) if each.name == 'speed' else each for each in parameters])
    restored = restore(client, {'speed': 250})
    assert (restored.complete, restored['speed'].word) == (False, 'not kept')
    assert restored['speed'].reason == 'the node holds 200'
    assert 'NOT COMPLETE, 0 of 1 parameter set' in repr(restored)
    assert restore(client, {'speed': 150}).complete


class Open(Node):  # to a value of any type
    def __init__(self):
        super().__init__('open')
        for name in NAMES:
            self.declare_parameter(name, 0, ParameterDescriptor(dynamic_typing=True))


@hypothesis.settings(max_examples=50)
@hypothesis.given(FULL_SETS, FULL_SETS)
def test_restoring_makes_equal_whatever_the_values(ros, first, second):
    if not ros.nodes:
        ros.add(Open)
    assert restore('/open', first).complete
    then = ParameterSet.of('/open')
    restored = restore('/open', second)
    assert restored.complete
    assert {each.name for each in restored} == {change.name for change in compare(first, second)}
    assert not compare(second, '/open', names=NAMES)
    restore('/open', then)
    assert all(values.same(ParameterSet.of('/open')[name], first[name]) for name in NAMES)


def test_a_rehearsal_says_what_restoring_would_do_and_does_nothing(ros):
    ros.add(Arm)
    before = all_parameters()
    wanted = {'joints': 9, 'reach': 5.0, 'gains.kp': 0.31, 'model': 'B2', 'tool': 3, 'nothing': 1, 'offset': 0.5}
    expected = restore('/arm', wanted, rehearse=True)
    assert {each.name: each.word for each in expected} == {
        'joints': 'would be set', 'reach': 'out of range', 'gains.kp': 'off the step', 'model': 'read only',
        'tool': 'wrong type', 'nothing': 'not declared'}
    assert repr(expected).startswith('/arm from given values: 1 of 6 parameters would be set\n')
    assert not expected.complete
    assert all_parameters() == before
