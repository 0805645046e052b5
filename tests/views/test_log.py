"""The log view: which nodes' lines it shows, and in how many updates."""

import pytest
from rclpy.node import Node

from param_tools.ros.waiting import wait_until
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.views.log import LogView
from tests.support.widgets import texts


def test_the_log_view_follows_all_nodes_or_one(ros):
    view, one = LogView(), LogView('simple_param_node')
    assert repr(view) == '<LogView: all nodes>'
    assert repr(one) == '<LogView: /simple_param_node>'
    assert 'nothing logged yet' in texts(view)
    ros.add(SimpleParamNode)
    node = ros.add(Node, 'other')
    node.get_logger().error('from another')
    wait_until(lambda: '<span class="param-log-loud">[ERROR] [other]: from another</span>' in texts(view),
                          'the line')
    wait_until(lambda: 'robot_serial_number: SN-CLAW-001' in texts(one), 'the lines of the one node')
    assert 'from another' not in texts(one)
    assert 'role="log"' in texts(one)


@pytest.mark.slow
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
