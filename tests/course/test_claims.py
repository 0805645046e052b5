"""Claims of the article that no cell of a chapter shows, each tried on the real rclpy; the table is in claims.md.

A comment above each test names the claims that it decides.
"""

import re
import textwrap

import pytest
from rcl_interfaces.msg import ParameterType, SetParametersResult
from rcl_interfaces.srv import GetParameters
from rclpy.exceptions import InvalidParameterException
from rclpy.node import Node
from rclpy.parameter import Parameter

from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.param_setter_node import ParamSetterNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode


# A009, A014, A015
def test_importing_classes_does_not_give_the_name_of_their_module(ros):
    listing = textwrap.dedent("""
        from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
        from rclpy.node import Node

        class Listing1(Node):
            def __init__(self):
                super().__init__('listing_1')
                self.get_logger().info('started')
                self.declare_parameter('temperature', -5, ParameterDescriptor(
                    integer_range=[rcl_interfaces.msg.IntegerRange(from_value=-20, to_value=50, step=1)]))
                self.get_logger().info('declared')
        """)
    names = {}
    exec(listing, names)
    with pytest.raises(NameError, match="name 'rcl_interfaces' is not defined"):
        ros.add(names['Listing1'])
    assert 'declared' not in ros.node_log.read(until='started')


# A012
def test_a_name_alone_is_deprecated_and_the_parameter_takes_any_type(ros):
    robot = ros.add(SimpleParamNode)
    client = ParameterClient(robot)
    with pytest.warns(UserWarning, match='only providing its name is deprecated'):
        ros.run(lambda: robot.declare_parameter('alone'), 'declare')
    assert client.describe_parameter('alone').dynamic_typing
    assert client.set_parameters({'alone': 3}).successful
    assert client.set_parameters({'alone': 'three'}).successful


# A074
def test_a_set_that_succeeds_has_no_reason(ros):
    node = ros.add(SimpleParamNode)
    result, = ros.run(lambda: node.set_parameters([Parameter('max_speed_rpm', value=90)]), 'set a parameter')
    assert (result.successful, result.reason) == (True, '')


# A127, A142
def test_any_name_but_the_empty_one_can_be_declared(ros):
    names = ['gains.kp', 'with space', 'lab/arm', 'a:b', '.first', 'x..y', 'last.']

    class Names(Node):
        def __init__(self):
            super().__init__('names')
            for name in names:
                self.declare_parameter(name, 1)

    node = ros.add(Names)
    assert ParameterClient(node).list_parameters()[2:] == names
    with pytest.raises(InvalidParameterException):
        ros.run(lambda: node.declare_parameter('', 1), 'declare')


# A030, A045, A050, A051, A052, A053, A054, A055, A056, A075, A090, A091, A092, A094, A095, A098, A100, A103: the
# article's robot compares types, with two kinds of numbers.
def test_two_of_four_values_get_into_the_articles_robot(ros):
    asked, types = [], {
        'max_speed_rpm': ParameterType.PARAMETER_INTEGER, 'max_acceleration_mps2': ParameterType.PARAMETER_DOUBLE}

    def judge(parameters):
        asked.extend(each.name for each in parameters)
        return SetParametersResult(successful=all(
            each.type_ == types[each.name] for each in parameters if each.name in types))

    article = ros.add(SimpleParamNode)
    assert len(re.findall(r'\w+: [-\w.]+$', ros.node_log.read(until='robot_serial_number: '), re.MULTILINE)) == 7
    assert len(ParameterClient(article).list_parameters()) == 9
    assert ParameterClient(article).get_parameter('max_speed_rpm') == 100
    article.add_on_set_parameters_callback(judge)
    ros.run(lambda: article.declare_parameter('later', 1), 'declare')
    assert asked == ['later']
    typed = {'max_speed_rpm': 150, 'enable_safety_mode': False, 'max_acceleration_mps2': 0.75,
             'min_operating_temperature_c': 10}
    proposal = {each.name: each.value for each in ParamSetterNode.proposal(1)}
    for values, taken in ((typed, [False, True, False, True]), (proposal, [True, True, False, False])):
        assert [each.successful for each in ParameterClient(article).set_parameters(values)] == taken
    asked.clear()
    del types['max_acceleration_mps2']  # the last one judges the speed alone
    assert [ParameterClient(article).set_parameter(name, value).kind for name, value in (
        ('max_acceleration_mps2', 1.5), ('max_acceleration_mps2', 5.0), ('robot_serial_number', 'SN-CLAW-002'),
        ('max_speed_rpm', 180))] == ['accepted', 'out of range', 'read only', 'rejected by the node']
    assert asked == ['max_acceleration_mps2', 'max_speed_rpm']


# A009, A066
def test_the_result_of_a_set_is_a_message_and_no_service():
    assert SetParametersResult.__module__.startswith('rcl_interfaces.msg.')
    with pytest.raises(ImportError, match='SetParametersResult'):
        exec('from rcl_interfaces.srv import SetParameters, SetParametersResult')


# A069
def test_wait_for_service_waits_until_somebody_offers_it(ros):
    client = ros.tool_node.create_client(GetParameters, '/simple_param_node/get_parameters')
    assert not client.wait_for_service(timeout_sec=0.05)
    ros.add(SimpleParamNode)
    assert client.wait_for_service(timeout_sec=10.0)
    ros.run(lambda: ros.tool_node.destroy_client(client), 'destroy the client')


# A070
def test_a_timer_comes_again_and_again(ros):
    calls = []

    class Ticks(Node):
        def __init__(self):
            super().__init__('ticks')
            self.create_timer(0.01, lambda: calls.append(1))

    ros.add(Ticks)
    wait_until(lambda: len(calls) >= 3, 'three ticks')
    assert ros.add(ParamSetterNode).timer.timer_period_ns == 5_000_000_000
