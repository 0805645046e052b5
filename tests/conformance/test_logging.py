"""Logging: levels, what stands on the terminal, and /rosout."""

import re

import pytest
import rclpy.logging
from rcl_interfaces.msg import Log
from rclpy.impl.implementation_singleton import rclpy_implementation as layer
from rclpy.logging import LoggingSeverity, get_logger
from rclpy.qos import DurabilityPolicy, QoSProfile

ROSOUT = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture(autouse=True)
def fresh_levels():
    rclpy.logging.clear_config()
    yield
    rclpy.logging.clear_config()


def test_levels_go_down(ros):
    assert get_logger('a.b').get_effective_level() == LoggingSeverity.INFO
    get_logger('a').set_level(LoggingSeverity.WARN)
    get_logger('a.b.c').set_level(LoggingSeverity.DEBUG)
    assert [get_logger(name).get_effective_level() for name in ('a', 'a.b', 'a.b.c', 'a.b.c.d', 'ab')] == [
        LoggingSeverity.WARN, LoggingSeverity.WARN, LoggingSeverity.DEBUG, LoggingSeverity.DEBUG, LoggingSeverity.INFO]
    assert rclpy.logging.get_logger_level('a.b') == LoggingSeverity.UNSET
    rclpy.logging.set_logger_level('', LoggingSeverity.ERROR)
    assert get_logger('ab').get_effective_level() == LoggingSeverity.ERROR
    assert not get_logger('ab').is_enabled_for(LoggingSeverity.WARN)
    get_logger('a').set_level(LoggingSeverity.UNSET)
    assert get_logger('a.b').get_effective_level() == LoggingSeverity.ERROR
    rclpy.logging.clear_config()
    assert get_logger('a.b.c').get_effective_level() == LoggingSeverity.INFO


def test_levels_from_the_command_line(ros):
    ros.init('--log-level', 'error', '--log-level', 'loud:=debug')
    assert get_logger('any').get_effective_level() == LoggingSeverity.ERROR
    assert get_logger('loud.child').get_effective_level() == LoggingSeverity.DEBUG


@pytest.mark.parametrize('level', [7, -7])
def test_a_level_that_is_none(level):
    with pytest.raises(RuntimeError, match='Failed reason: '):
        layer.rclpy_logging_set_logger_level('x', level, True)
    with pytest.raises(RuntimeError, match='Failed to set level for logger'):
        layer.rclpy_logging_set_logger_level('x', level)
    with pytest.raises(RuntimeError):
        rclpy.logging.get_logging_severity_from_string('loud')


def test_the_terminal(ros, capfd):
    logger = ros.node(namespace='/ns').get_logger()
    capfd.readouterr()
    logger.debug('not enabled')
    logger.info('two\nlines {name} %d')
    out, err = capfd.readouterr()
    assert out == ''
    assert re.fullmatch(r'\[INFO\] \[\d+\.\d{9}\] \[ns\.node\]: two\nlines \{name\} %d\n', err)


def test_each_level_on_the_terminal(ros, capfd):
    logger = ros.node().get_logger()
    logger.set_level(LoggingSeverity.DEBUG)
    capfd.readouterr()
    logger.debug('text')
    logger.info('text')
    logger.warning('text')
    logger.error('text')
    logger.fatal('text')
    own = [line for line in capfd.readouterr().err.splitlines() if '[node]' in line]
    assert [line.partition('] [')[0] for line in own] == ['[DEBUG', '[INFO', '[WARN', '[ERROR', '[FATAL']


def test_rosout(ros):
    heard = []
    listener = ros.node('listener', enable_rosout=False)
    listener.create_subscription(Log, '/rosout', heard.append, ROSOUT)
    node = ros.node('talker', namespace='/ns')
    node.get_logger().warning('hello')
    node.get_logger().debug('not heard')
    node.get_logger().get_child('child').error('child')
    ros.wait(lambda: len(heard) == 2)
    assert [(each.level, each.name, each.msg) for each in heard] == [
        (30, 'ns.talker', 'hello'), (40, 'ns.talker.child', 'child')]
    assert heard[0].file == __file__
    assert heard[0].function == 'test_rosout'
    assert heard[0].line > 0
    assert heard[0].stamp.sec > 10**9


def test_a_late_listener_hears_what_was_logged_before(ros):
    node, heard = ros.node('talker'), []
    node.get_logger().info('early')
    node.create_subscription(Log, '/rosout', heard.append, ROSOUT)
    ros.wait(lambda: [each.msg for each in heard] == ['early'])


def test_without_rosout(ros):
    ros.init('--disable-rosout-logs')
    assert ros.node().get_publishers_info_by_topic('/rosout') == []


def test_without_the_terminal(ros, capfd):
    ros.init('--disable-stdout-logs')
    ros.node().get_logger().info('nothing')
    assert 'nothing' not in ''.join(capfd.readouterr())


def test_two_nodes_of_one_name(ros, capfd):
    heard, listener = [], ros.node('listener', enable_rosout=False)
    listener.create_subscription(Log, '/rosout', heard.append, ROSOUT)
    ros.node('twin')
    capfd.readouterr()
    ros.node('twin')
    assert "Publisher already registered for node name: 'twin'." in capfd.readouterr().err
    ros.nodes[1].get_logger().info('hello')
    ros.wait(lambda: [each.msg for each in heard] == ['hello'])


def test_the_folder_of_the_log_files(monkeypatch):
    monkeypatch.setenv('ROS_LOG_DIR', '/some/where')
    assert str(rclpy.logging.get_logging_directory()) == '/some/where'
    monkeypatch.delenv('ROS_LOG_DIR')
    monkeypatch.setenv('ROS_HOME', '/home/of/ros')
    assert str(rclpy.logging.get_logging_directory()) == '/home/of/ros/log'
