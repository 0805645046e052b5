"""The table of events: which nodes it shows, and in what order."""

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools.ros.waiting import wait_until
from param_tutorial import ParameterClient
from param_tutorial.views import EventView
from tests.support.widgets import texts


class Arm(Node):
    def __init__(self, name='arm'):
        super().__init__(name)
        self.declare_parameter('speed', 1)
        self.declare_parameter('note', '<b>', ParameterDescriptor(dynamic_typing=True))


def test_events_are_new_changed_and_deleted_of_one_node_or_all(ros):
    view, everything = EventView('arm'), EventView()
    ros.add(Arm, '_hidden')
    ParameterClient(ros.add(Arm, 'leg')).set_parameter('speed', 2)
    ParameterClient(ros.add(Arm)).set_parameters({'speed': 0, 'note': None})
    wait_until(lambda: ('/arm', 'deleted', 'note', None) in view.changes and
               ('/arm', 'deleted', 'note', None) in everything.changes, 'the deletion')
    assert view.changes[-4:] == [('/arm', 'new', 'speed', 1), ('/arm', 'new', 'note', '<b>'),
                                 ('/arm', 'changed', 'speed', 0), ('/arm', 'deleted', 'note', None)]
    assert ('/leg', 'changed', 'speed', 2) in everything.changes
    assert {change.node for change in view.changes} == {'/arm'}
    assert {change.node for change in everything.changes} == {'/arm', '/leg'}
    wait_until(lambda: 'deleted' in texts(view), 'the table')
    cells = '<td>/arm</td><td>{}</td><td>{}</td><td>{}</td>'.format
    assert texts(view).index(cells('deleted', 'note', '')) < texts(view).index(cells('changed', 'speed', '0'))
    assert cells('new', 'note', '&#x27;&lt;b&gt;&#x27;') in texts(view)
