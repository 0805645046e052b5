"""An array is shared: what chapter 4 says of the list in ``get_parameter(...).value``, tried on the real rclpy."""

import pytest
from rcl_interfaces.msg import ParameterEvent, SetParametersResult
from rclpy.node import Node

from param_tutorial import ParameterClient, wait_until


class Courier(Node):
    """A list of stops, and a note of each callback and each event about it."""

    def __init__(self, stops):
        super().__init__('courier')
        self.declare_parameters('', [('stops', stops), ('marker', 0)])
        self.called, self.events = [], []
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.note)
        self.create_subscription(ParameterEvent, '/parameter_events', self.hear, 10)

    def judge(self, parameters):
        self.note(parameters)
        return SetParametersResult(successful=True)

    def note(self, parameters):
        self.called += [each.name for each in parameters]

    def hear(self, event):
        if event.node == '/courier':
            self.events += [each.name for each in event.changed_parameters]


@pytest.mark.parametrize('stops', [['dock', 'door'], [1, 2], [1.0, 2.0], [True, False]], ids=str)
@pytest.mark.parametrize('is_set_first', [False, True])
def test_taking_from_the_list_changes_the_parameter_and_nobody_is_told(ros, stops, is_set_first):
    courier = ros.add(Courier, list(stops))
    client = ParameterClient(courier)
    if is_set_first:  # a value that came through a service is an array.array
        client.set_parameter('stops', stops[::-1]).raise_for_reason()
        wait_until(lambda: courier.events, 'the event of the set')
        courier.called.clear()
        courier.events.clear()
    photograph = courier.get_parameter('stops')
    courier.get_parameter('stops').value.pop()
    assert len(photograph.value) == len(courier.get_parameter('stops').value) == len(client.get_parameter('stops')) == 1
    assert courier.called == []
    client.set_parameter('marker', 1).raise_for_reason()  # an event of the pop would come before that of this set
    wait_until(lambda: 'marker' in courier.events, 'the event of the marker')
    assert courier.events == ['marker']


def test_the_list_of_the_default_is_shared_as_well(ros):
    default = ['dock', 'door']
    courier = ros.add(Courier, default)
    default.pop()
    assert ParameterClient(courier).get_parameter('stops') == ['dock']


def test_a_copy_of_the_list_is_the_readers_own(ros):
    courier = ros.add(Courier, ['dock', 'door'])
    list(courier.get_parameter('stops').value).pop()
    assert ParameterClient(courier).get_parameter('stops') == ['dock', 'door']
