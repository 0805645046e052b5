"""Plots of a panel, on real nodes and without a browser: what is sent to it."""

import sys

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterValue
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

from param_tools.errors import ParameterNotDeclaredError, ParameterToolError
from param_tools.node.client import ParameterClient
from param_tools.panel.panel import ParameterPanel
from param_tools.ros import stage
from param_tools.ros.waiting import wait_until
from tests.support.nodes import Arm
from tests.support.widgets import press

SPEED = '/arm/state.double_value'
SECOND = '/arm/state.double_array_value[1]'


class Talker(Node):
    """Publishes what a test says."""

    def __init__(self):
        super().__init__('talker')
        self.state = self.create_publisher(ParameterValue, '/arm/state', 10)
        self.create_publisher(IntegerRange, '/arm/range', 10)


@pytest.fixture
def sent(arm, monkeypatch):
    """Return all that the panel sends to the browser about its plots."""
    messages = []
    send = arm._front.send
    monkeypatch.setattr(arm._front, 'send', lambda message: (messages.append(message), send(message)))
    return messages


@pytest.fixture
def heard(arm, monkeypatch):
    """Return all changes that the plots hear of; first come the values that the nodes have."""
    changes = []
    hear = arm._plots._on_changes
    monkeypatch.setattr(arm._plots, '_on_changes', lambda new: (changes.extend(new), hear(new)))
    return changes


def values_of(sent, name):
    """Return what was sent of a curve."""
    return [value for each in sent if each['plot'] == 'data' for value in each['curves'].get(name, ([], []))[1]]


def marks_of(sent):
    """Return the changes that were sent, without their time."""
    return [tuple(mark[1:]) for each in sent if each['plot'] == 'data' for mark in each['marks']]


def word(panel, name):
    return panel._front.plots['words'].get(name, '')


def test_a_parameters_curve_and_who_changed_what(ros, arm, sent, heard):
    press(arm, 'plot', act='open', row='joints')
    assert arm._front.plots == {'open': [{'row': 'joints', 'curves': ['joints']}], 'words': {}}
    wait_until(lambda: heard, 'changes to be heard')
    ParameterClient('/arm').set_parameter('joints', 9)
    wait_until(lambda: values_of(sent, 'joints') == [5, 9], 'the curve')
    wait_until(lambda: marks_of(sent), 'the mark')
    # Not through these tools: what another program does is seen in the same way.
    elsewhere = AsyncParameterClient(ros.add(Node, 'elsewhere'), '/arm')
    assert elsewhere.wait_for_services(5)
    elsewhere.set_parameters([Parameter('tool', value='saw')])
    wait_until(lambda: len(marks_of(sent)) == 2, 'the second mark')
    assert marks_of(sent) == [('/arm', 'joints', '5', '9', True), ('/arm', 'tool', "'gripper'", "'saw'", False)]
    # Another view of the panel gets all that came before.
    press(arm, 'plot', act='all', client='late')
    assert sent[-1]['client'] == 'late'
    assert (sent[-1]['curves']['joints'][1], len(sent[-1]['marks'])) == ([5, 9], 2)


def test_a_topics_field_beside_it_until_nobody_publishes_and_after_that(ros, arm, sent):
    talker = ros.add(Talker)
    arm.plot('offset', SPEED, SECOND)
    assert arm._front.plots['open'] == [{'row': 'offset', 'curves': ['offset', SPEED, SECOND]}]
    wait_until(lambda: word(arm, SPEED) == 'no message yet', 'somebody to listen')
    talker.state.publish(ParameterValue(double_value=2.5, double_array_value=[1.0]))
    wait_until(lambda: values_of(sent, SPEED) == [2.5], 'the message')
    wait_until(lambda: word(arm, SECOND) == 'its last message had fewer elements', 'the word')
    assert word(arm, SPEED) == ''
    ros.remove(talker)
    wait_until(lambda: word(arm, SPEED) == 'nobody publishes it now', 'the word')
    assert values_of(sent, SPEED) == [2.5, None], 'a gap follows'
    talker = ros.add(Talker)
    wait_until(lambda: word(arm, SPEED) == 'no message yet', 'somebody to listen')
    talker.state.publish(ParameterValue(double_value=3.5))
    wait_until(lambda: values_of(sent, SPEED) == [2.5, None, 3.5], 'the message')


def test_the_plot_of_a_node_that_ends_stays_with_a_word(ros, arm, sent, heard):
    arm.plot('reach')
    wait_until(lambda: heard, 'changes to be heard')
    ros.remove('/arm')
    wait_until(lambda: word(arm, 'reach') == '/arm is not running', 'the word')
    wait_until(lambda: values_of(sent, 'reach') == [0.5, None], 'the end of the curve')
    wait_until(lambda: ('/arm', '', 'not set', 'not set', False) in marks_of(sent), 'the mark')
    assert arm._front.plots['open']
    ros.add(Arm)
    wait_until(lambda: (word(arm, 'reach'), values_of(sent, 'reach')) == ('', [0.5, None, 0.5]), 'the node')


def test_nothing_is_heard_and_sent_once_the_last_plot_is_closed(ros, arm, sent):
    ros.add(Talker)
    arm.plot('offset', SPEED)
    wait_until(lambda: ros.tool_node.count_subscribers('/arm/state') == 1, 'somebody to listen')
    press(arm, 'plot', act='remove', row='offset', curve=SPEED)
    wait_until(lambda: ros.tool_node.count_subscribers('/arm/state') == 0, 'nobody to listen')
    arm.plot('offset', SPEED)
    wait_until(lambda: ros.tool_node.count_subscribers('/arm/state') == 1, 'somebody to listen')
    press(arm, 'plot', act='close', row='offset')
    wait_until(lambda: ros.tool_node.count_subscribers('/arm/state') == 0, 'nobody to listen')
    wait_until(lambda: arm._plots._job.is_idle, 'nothing to be sent')
    assert arm._front.plots == {'open': [], 'words': {}}


@pytest.mark.parametrize(('text', 'said'), [
    ('/arm/state', 'choose one of the numbers in /arm/state, such as /arm/state.type'),
    ('/arm/state.duble_value', "/arm/state has no number 'duble_value'. Did you mean double_value"),
    ('/rosout.msg', "/rosout has no number 'msg'"),
    ('/nobody', 'nobody publishes /nobody now; to wait for it, name a field, as in /nobody.data'),
    ('tool', "there is no numeric parameter 'tool' here"),
])
def test_what_cannot_be_drawn_says_why(ros, arm, text, said):
    ros.add(Talker)
    wait_until(lambda: ros.tool_node.count_publishers('/arm/state'), 'the topic')
    with pytest.raises(ParameterToolError) as error:
        arm.plot('offset', text)
    assert str(error.value).startswith(said)
    assert arm._front.plots == {}
    with pytest.raises(ParameterNotDeclaredError):
        arm.plot('ofset')


def test_a_type_that_is_not_installed_is_named(ros, arm, sent, monkeypatch):
    ros.add(Talker)
    wait_until(lambda: ros.tool_node.count_publishers('/arm/range'), 'the topic')
    monkeypatch.setitem(sys.modules, 'rcl_interfaces.msg', None)  # the import fails, as without the package
    press(arm, 'plot', act='open', row='offset')
    press(arm, 'plot', act='add', row='offset', curve='/arm/range.step', client='me')
    wait_until(lambda: [each for each in sent if each['plot'] == 'said'], 'the answer')
    answer = next(each for each in sent if each['plot'] == 'said')
    assert (answer['client'], answer['said']) == (
        'me', 'messages on /arm/range are of type rcl_interfaces/msg/IntegerRange, and rcl_interfaces is not installed '
              'here: install it, or source its workspace, and start again')


def test_what_can_be_plotted_is_offered(ros, arm, sent):
    ros.add(Talker)
    wait_until(lambda: ros.tool_node.count_publishers('/arm/range'), 'the topic')
    press(arm, 'plot', act='offer', client='me')
    wait_until(lambda: sent, 'the offer')
    assert ('/arm/range', 'rcl_interfaces/msg/IntegerRange') in sent[-1]['topics']
    assert sent[-1]['fields']['rcl_interfaces/msg/IntegerRange'] == ['from_value', 'to_value', 'step']
    assert {'joints', 'gains.kp', 'payload'} <= set(sent[-1]['parameters'])
    assert 'tool' not in sent[-1]['parameters']


def test_the_executor_is_followed_through_a_stop_and_a_new_start(ros, arm, sent):
    arm.plot('offset', SPEED)
    wait_until(lambda: word(arm, SPEED) == 'nobody publishes it now', 'the executor to be asked')
    stage.stop()
    wait_until(lambda: word(arm, SPEED) == 'no executor is running', 'the word')
    stage.start().add(Talker).state.publish(ParameterValue())
    wait_until(lambda: word(arm, SPEED) == 'no message yet', 'somebody to listen')


def test_the_list_of_nodes_plots_a_topic(ros):
    talker = ros.add(Talker)
    browser = ParameterPanel()
    wait_until(lambda: ros.tool_node.count_publishers('/arm/state'), 'the topic')
    browser.plot(SPEED)
    wait_until(lambda: word(browser, SPEED) == 'no message yet', 'somebody to listen')
    talker.state.publish(ParameterValue(double_value=2.5))
    wait_until(lambda: word(browser, SPEED) == '', 'the message')
    assert browser._front.plots['open'] == [{'row': '', 'curves': [SPEED]}]
