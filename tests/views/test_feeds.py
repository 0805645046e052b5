"""The log and the table of events: which nodes they show, in what order, and in how many updates."""

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from param_tools.ros.waiting import wait_until
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.views import EventView, LogView
from tests.support.widgets import texts


def test_the_log_follows_all_nodes_or_one(ros):
    view, one = LogView(), LogView('simple_param_node')
    assert repr(view) == '<LogView: all nodes>' and repr(one) == '<LogView: /simple_param_node>'
    assert 'nothing logged yet' in texts(view)
    ros.add(SimpleParamNode)
    node = ros.add(Node, 'other')
    node.get_logger().error('from another')
    wait_until(lambda: '<span class="param-log-loud">[ERROR] [other]: from another</span>' in texts(view), 'the line')
    wait_until(lambda: 'robot_serial_number: SN-CLAW-001' in texts(one), 'the lines of the one node')
    assert 'from another' not in texts(one)
    assert 'role="log"' in texts(one)


def test_a_chatty_node_is_shown_its_last_lines_in_few_updates(ros):
    node = ros.add(Node, 'chatty')
    view = LogView()
    updates = []
    view._content.observe(lambda change: updates.append(change['new']), 'value')
    for number in range(1000):
        node.get_logger().info(f'line {number}')
    wait_until(lambda: 'line 999' in texts(view), 'the last line')
    assert len(updates) < 100
    assert max(update.count('\n') for update in updates) < 300


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
