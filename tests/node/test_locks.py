"""locks: which parameters of a node can't be changed now, as its descriptors say."""

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools import Rules, locks
from param_tools.node.locks import conditions_of
from param_tutorial import ParameterClient


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        self.declare_parameters('', [
            ('moving', True), ('mode', 'a; b'), ('gain', 1.0), ('reach_m', 2), ('name', 'Arm'),
            ('serial', 'A-1', ParameterDescriptor(read_only=True))])
        (Rules(self).only_while(['gain', 'reach_m'], 'moving', False)
         .check('gain', lambda gain: gain > 0, 'must be above 0').only_while('gain', 'mode', 'a; b'))


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(Arm))


def test_what_cannot_be_changed_now_and_why(client):
    read_only = {'serial': 'It is read-only.', 'start_type_description_service': 'It is read-only.'}
    assert locks(client) == {
        'gain': 'It can change only while moving is False; now moving = True.',
        'reach_m': 'It can change only while moving is False; now moving = True.', **read_only}
    client.set_parameter('mode', 'c')
    assert locks(client)['gain'] == (
        "It can change only while moving is False and mode is 'a; b'; now moving = True, mode = 'c'.")
    client.set_parameter('moving', False)
    assert locks(client) == {
        'gain': "It can change only while mode is 'a; b'; now mode = 'c'.", **read_only}
    # As the node sees it, too.
    assert not client.set_parameter('gain', 2.0).successful
    assert client.set_parameter('reach_m', 3).successful


@pytest.mark.parametrize('words', [
    'Can change only while', 'Can change only while moving', 'Can change only while x is y',
    'Can change only while x is [', 'can change only while x is 1'])
def test_words_of_somebody_else_are_no_condition(ros, client, words):
    ros.nodes[0].describe_parameter('name').additional_constraints = words
    assert conditions_of(client.describe_parameter('name')) == []
