"""The table of events: what it holds, whom it follows, and that it lets go."""

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

import param_tutorial
from param_tutorial import ParameterClient
from param_tutorial.views import EventView


class Arm(Node):
    def __init__(self, name='arm'):
        super().__init__(name)
        self.declare_parameter('speed', 1)
        self.declare_parameter('note', '<b>', ParameterDescriptor(dynamic_typing=True))


@pytest.fixture
def view(ros):
    return EventView('arm')


@pytest.mark.slow
def test_it_tells_new_changed_and_deleted_apart(ros, view):
    client = ParameterClient(ros.add(Arm))
    client.set_parameters({'speed': 0, 'note': None})
    param_tutorial.wait_until(lambda: view.changes and view.changes[-1].kind == 'deleted', 'the deletion')
    assert view.changes[-4:] == [('/arm', 'new', 'speed', 1), ('/arm', 'new', 'note', '<b>'),
                                 ('/arm', 'changed', 'speed', 0), ('/arm', 'deleted', 'note', None)]
    content = view.children[1]
    param_tutorial.wait_until(lambda: 'deleted' in content.value, 'the table')
    cells = '<td>/arm</td><td>{}</td><td>{}</td><td>{}</td>'.format
    assert content.value.index(cells('deleted', 'note', '')) < content.value.index(cells('changed', 'speed', '0'))
    assert '&lt;b&gt;' in content.value and '<b>' not in content.value


def test_it_follows_one_node_or_all(ros, view):
    everything = EventView()
    ros.add(Arm, '_hidden')
    ParameterClient(ros.add(Arm, 'leg')).set_parameter('speed', 2)
    ParameterClient(ros.add(Arm)).set_parameter('speed', 3)
    param_tutorial.wait_until(lambda: ('/arm', 'changed', 'speed', 3) in everything.changes, 'the event')
    assert ('/leg', 'changed', 'speed', 2) in everything.changes
    assert {change.node for change in view.changes} == {'/arm'}
    assert {change.node for change in everything.changes} == {'/arm', '/leg'}
    assert (repr(everything), repr(view)) == ('<EventView: all nodes>', '<EventView: /arm>')
