"""node_log: what nodes logged, and reading it like a terminal."""


import pytest
from rcl_interfaces.msg import Log
from rclpy.node import Node

from param_tools.errors import WaitTimeoutError
from param_tools.ros.node_log import NodeLog


def message(text, name='a', level=20):
    return Log(level=level, name=name, msg=text)


def test_real_nodes_are_heard_with_level_and_name(ros):
    class Talker(Node):
        def __init__(self):
            super().__init__('talker', namespace='/lab')
            self.get_logger().info('first, in the constructor')

    talker = ros.add(Talker)
    talker.get_logger().warning('two\nlines')
    talker.get_logger().error('last')
    assert ros.node_log.read(until='last') == (
        '[INFO] [lab.talker]: first, in the constructor\n[WARN] [lab.talker]: two\nlines\n[ERROR] [lab.talker]: last')
    assert len(ros.node_log.lines('/lab/talker')) == 3
    assert ros.node_log.lines('/other') == []


def test_each_line_is_read_once_and_only_up_to_the_one_wanted():
    log = NodeLog()
    for text in ('one', 'two', 'three', 'two'):
        log.receive(message(text))
    assert log.read(until='two') == '[INFO] [a]: one\n[INFO] [a]: two'
    assert log.read(until='two') == '[INFO] [a]: three\n[INFO] [a]: two'
    with pytest.raises(WaitTimeoutError, match=r"waiting for a log line with 'two'; what came:\n\(nothing\)"):
        log.read(until='two', timeout_sec=0.01)


def test_after_a_mark_only_what_was_logged_later_is_read_even_if_the_rest_arrives_later(ros):
    talker = ros.add(Node, 'talker')
    talker.get_logger().info('before')
    ros.node_log.mark()
    talker.get_logger().info('after')
    assert ros.node_log.read(until='after') == '[INFO] [talker]: after'
    assert ros.node_log.lines('/talker') == ['[INFO] [talker]: before', '[INFO] [talker]: after']


def test_since_leaves_out_what_comes_before_a_line():
    log = NodeLog()
    for text in ('stopped', 'off', 'stopped'):
        log.receive(message(text))
    assert log.read(since='off', until='stopped') == '[INFO] [a]: off\n[INFO] [a]: stopped'
    log.receive(message('stopped'))
    with pytest.raises(WaitTimeoutError, match='stopped'):
        log.read(since='off', until='stopped', timeout_sec=0.01)
