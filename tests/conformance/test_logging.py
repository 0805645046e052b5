"""Logging: levels, what stands on the terminal, and /rosout."""

import re

import pytest
import rclpy.logging
from rcl_interfaces.msg import Log
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


def test_the_terminal(ros, capfd):
    logger = ros.node(namespace='/ns').get_logger()
    capfd.readouterr()
    logger.debug('not enabled')
    logger.info('two\nlines {name} %d')
    logger.info(None)
    with pytest.raises(TypeError):
        logger.info(5)
    out, err = capfd.readouterr()
    assert out == ''
    begin = r'\[INFO\] \[\d+\.\d{9}\] \[ns\.node\]: '
    assert re.fullmatch(rf'{begin}two\nlines \{{name\}} %d\n{begin}\(null\)\n', err)


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


def test_without_the_terminal(ros, capfd):
    ros.init('--disable-stdout-logs')
    ros.node().get_logger().info('nothing')
    assert 'nothing' not in ''.join(capfd.readouterr())
