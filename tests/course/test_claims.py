"""Claims of the article that no cell of a chapter shows, each tried on the real rclpy; the table is in claims.md.

A comment above each test names the claims that it decides. Where the article's own listing matters, a node written
anew does what that listing does.
"""

import re
import sys
import textwrap

import pytest
from rcl_interfaces.msg import (
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    ParameterValue,
    SetParametersResult,
)
from rcl_interfaces.msg import Parameter as ParameterMessage
from rcl_interfaces.srv import DescribeParameters, GetParameters
from rclpy.duration import Duration
from rclpy.exceptions import InvalidParameterException
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler

from param_tools.errors import NoAnswerError, NodeGoneError
from param_tutorial import ParameterClient, Terminal, wait_until
from param_tutorial.nodes.param_setter_node import ParamSetterNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode


class Robot(Node):
    """One integer, and a list of what its on-set callback was asked."""

    def __init__(self):
        super().__init__('robot')
        self.declare_parameters('', [('speed', 100), ('gain', 0.5)])
        self.asked = []
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters):
        self.asked.append([(each.name, each.value) for each in parameters])
        return SetParametersResult(successful=parameters[0].value != -1, reason='no')


@pytest.fixture
def robot(ros):
    return ros.add(Robot)


@pytest.fixture
def client(robot):
    return ParameterClient(robot)


# -- declaring ---------------------------------------------------------------------------------------------


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
def test_a_name_alone_is_deprecated_and_the_parameter_takes_any_type(ros, robot, client):
    with pytest.warns(UserWarning, match='only providing its name is deprecated'):
        ros.run(lambda: robot.declare_parameter('alone'), 'declare')
    assert client.describe_parameter('alone').dynamic_typing
    assert client.set_parameters({'alone': 3}).successful
    assert client.set_parameters({'alone': 'three'}).successful


# A026, A111
@pytest.mark.slow
@pytest.mark.parametrize('caught', ['KeyboardInterrupt', 'KeyboardInterrupt, ExternalShutdownException'])
def test_after_ctrl_c_a_second_shutdown_is_an_error(tmp_path, caught):
    program = tmp_path / 'program.py'
    program.write_text(textwrap.dedent(f'''
        import time

        import rclpy
        from rclpy.executors import ExternalShutdownException
        from rclpy.node import Node
        rclpy.init()
        node = Node('ends_twice')
        node.create_timer(0.05, lambda: print('spinning', flush=True))
        try:
            rclpy.spin(node)
        except ({caught}):
            pass
        finally:
            while rclpy.ok():  # rclpy's signal handler has a thread of its own, and need not be the first
                time.sleep(0.01)
            node.destroy_node()
            rclpy.shutdown()
        '''))
    terminal = Terminal(f'"{sys.executable}" {program}')
    terminal.read(until='spinning')
    assert terminal.interrupt() == 1
    assert 'rcl_shutdown already called' in terminal.text


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


# A085
@pytest.mark.slow
def test_with_two_ranges_a_node_cannot_describe_itself(ros):
    class TwoRanges(Node):
        def __init__(self):
            super().__init__('two_ranges')
            self.declare_parameter('speed', 5, ParameterDescriptor(integer_range=[
                IntegerRange(from_value=0, to_value=10), IntegerRange(from_value=100, to_value=110)]))

    client = ParameterClient(ros.add(TwoRanges))
    with pytest.raises(NoAnswerError):
        ros.services.call('/two_ranges', 'describe_parameters', DescribeParameters.Request(names=['speed']),
                          timeout_sec=0.5)
    assert client.get_parameter('speed') == 5  # and it lives


# A129: what grows with the number of parameters is not the number of services.
def test_many_parameters_need_no_more_services(ros):
    class Many(Node):
        def __init__(self, count):
            super().__init__(f'with_{count}')
            self.declare_parameters('', [(f'p{index}', index) for index in range(count)])

    few, many = ros.add(Many, 1), ros.add(Many, 500)
    assert len(list(few.services)) == len(list(many.services))


# -- callbacks ---------------------------------------------------------------------------------------------


# A041
def test_an_event_handler_hears_of_its_own_node_and_of_others(ros, robot, client):
    heard = []
    handler = ParameterEventHandler(robot)
    other = ros.add(SimpleParamNode)
    for node in (robot, other):
        name = {robot: 'speed', other: 'max_speed_rpm'}[node]
        handler.add_parameter_callback(name, node.get_fully_qualified_name(),
                                       lambda message: heard.append((message.name, message.value.integer_value)))
    client.set_parameter('speed', 7).raise_for_reason()
    wait_until(lambda: ('speed', 7) in heard, 'the event of its own node')
    ParameterClient(other).set_parameter('max_speed_rpm', 8).raise_for_reason()
    wait_until(lambda: ('max_speed_rpm', 8) in heard, 'the event of the other node')
    # The declarations, of 100 each, may still have been under way when the handler began to listen.
    assert [each for each in heard if each[1] != 100] == [('speed', 7), ('max_speed_rpm', 8)]


# A045
def test_on_set_is_asked_for_more_than_changes_of_declared_parameters(ros, robot, client):
    client.set_parameter('speed', 100)  # what it is already
    client.set_parameter('use_sim_time', False)
    ros.run(lambda: robot.declare_parameter('late', 7), 'declare')
    ros.run(lambda: robot.undeclare_parameter('late'), 'undeclare')
    client.set_parameter('speed', 'fast')  # rejected before
    assert robot.asked == [[('speed', 100)], [('use_sim_time', False)], [('late', 7)]]


# A046
def test_on_set_gets_parameters_one_by_one_or_all_together(robot, client):
    client.set_parameters({'speed': 1, 'gain': 0.1})
    client.set_parameters_atomically({'speed': 2, 'gain': 0.2})
    assert robot.asked == [[('speed', 1)], [('gain', 0.1)], [('speed', 2), ('gain', 0.2)]]


# A074
def test_an_accepted_parameter_has_no_reason(client):
    assert [(each.successful, each.reason) for each in client.set_parameters({'speed': 1, 'gain': 0.1})] == [
        (True, ''), (True, '')]


class ComparesTypes(SimpleParamNode):
    """Judges and logs as the article's robot does: by comparing types, with two kinds of numbers."""

    def __init__(self):
        super().__init__()
        self.heard = []
        self.state_afterwards = []
        self.add_on_set_parameters_callback(self.judge_types)

    def judge_types(self, parameters):
        answer = SetParametersResult(successful=True)
        for each in parameters:
            self.heard.append((each.name, each.value))
            if each.name == 'max_speed_rpm':
                answer.successful = each.type_ == ParameterType.PARAMETER_INTEGER and each.value >= 0
            elif each.name == 'max_acceleration_mps2':
                answer.successful = each.type_ == ParameterType.PARAMETER_DOUBLE and each.value > 0
        self.state_afterwards.append(self.get_parameter('robot_name').value)
        return answer


@pytest.fixture
def article(ros):
    return ros.add(ComparesTypes)


# A009, A051, A053, A054, A055, A056, A098, A100, A103
@pytest.mark.parametrize(('name', 'value', 'kind'), [
    ('robot_name', 'AlphaClaw', 'accepted'), ('enable_safety_mode', False, 'accepted'),
    ('min_operating_temperature_c', 10, 'accepted'), ('min_operating_temperature_c', 51, 'out of range'),
    ('max_speed_rpm', 150, 'rejected by the node'), ('max_speed_rpm', 180, 'rejected by the node'),
    ('max_acceleration_mps2', 0.75, 'rejected by the node'),
])
def test_the_articles_robot_rejects_every_speed_and_every_acceleration(article, name, value, kind):
    assert ParameterClient(article).set_parameter(name, value).kind == kind


# A059, A060
def test_what_the_articles_robot_logs_is_the_wish_and_then_the_old_state(article):
    client = ParameterClient(article)
    client.set_parameter('robot_name', 'AlphaClaw')
    client.set_parameter('max_speed_rpm', 150)
    assert article.heard == [('robot_name', 'AlphaClaw'), ('max_speed_rpm', 150)]
    assert article.state_afterwards[0] == 'Clawbot'
    assert client.get_parameter('max_speed_rpm') == 100


# A071, A072, A075
def test_the_setter_gets_two_of_four_into_the_articles_robot(article):
    proposal = {each.name: each.value for each in ParamSetterNode.proposal(1)}
    assert proposal['enable_safety_mode'] is False
    assert [each.successful for each in ParameterClient(article).set_parameters(proposal)] == [
        True, True, False, False]


# A159
def test_a_rule_with_a_regular_expression_needs_no_new_ros(ros):
    class Named(Node):
        def __init__(self):
            super().__init__('named')
            self.declare_parameter('serial', 'GR-0042')
            self.add_on_set_parameters_callback(self.judge)

        def judge(self, parameters):
            fits = all(re.fullmatch(r'GR-\d{4}', each.value) for each in parameters)
            return SetParametersResult(successful=fits, reason='GR and four digits')

    client = ParameterClient(ros.add(Named))
    assert [client.set_parameter('serial', text).successful for text in ('GR-0043', 'GR-43')] == [True, False]


# A160
def test_an_old_name_can_be_forwarded_to_a_new_one(ros):
    class Renamed(Node):
        def __init__(self):
            super().__init__('renamed')
            self.declare_parameter('max_speed_rpm', 100)
            self.add_pre_set_parameters_callback(lambda parameters: [
                Parameter('max_speed_rpm', value=each.value) if each.name == 'speed' else each for each in parameters])

    client = ParameterClient(ros.add(Renamed))
    assert client.set_parameters({'speed': 150}).successful
    assert client.get_parameter('max_speed_rpm') == 150


# -- from another node ---------------------------------------------------------------------------------------


# A009, A066
def test_the_result_of_a_set_is_a_message_and_no_service():
    assert SetParametersResult.__module__.startswith('rcl_interfaces.msg.')
    with pytest.raises(ImportError, match='SetParametersResult'):
        exec('from rcl_interfaces.srv import SetParameters, SetParametersResult')


# A067
def test_the_message_of_the_same_name_takes_no_positional_arguments():
    with pytest.raises((TypeError, AttributeError)):
        ParameterMessage('speed', Parameter.Type.INTEGER, 1)
    assert Parameter('speed', Parameter.Type.INTEGER, 1).to_parameter_msg().value.integer_value == 1


# A069, A157
@pytest.mark.slow
def test_wait_for_service_waits_until_somebody_offers_it(ros):
    client = ros.tool_node.create_client(GetParameters, '/robot/get_parameters')
    assert not client.wait_for_service(timeout_sec=0.05)
    ros.add(Robot)
    assert client.wait_for_service(timeout_sec=10.0)
    future = client.call_async(GetParameters.Request(names=['speed']))
    wait_until(future.done, 'the answer')
    assert future.result().values[0].integer_value == 100
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


# A132
def test_the_nodes_own_setters_answer_one_by_one(ros, robot):
    results = ros.run(lambda: robot.set_parameters([Parameter('speed', value=-1), Parameter('gain', value=0.1)]), 'set')
    assert [each.successful for each in results] == [False, True]


# A143
@pytest.mark.slow
def test_a_node_that_crashes_takes_no_other_ones_parameters_along(ros, client, tmp_path):
    program = tmp_path / 'program.py'
    program.write_text(textwrap.dedent('''
        import rclpy
        from rclpy.node import Node
        rclpy.init()
        node = Node('crashes')
        node.declare_parameter('speed', 1)
        node.add_on_set_parameters_callback(lambda parameters: 1 / 0)
        node.create_timer(0.05, lambda: print('spinning', flush=True))
        rclpy.spin(node)
        '''))
    terminal = Terminal(f'"{sys.executable}" {program}')
    terminal.read(until='spinning')
    other = ParameterClient('/crashes', timeout_sec=20)
    assert other.get_parameter('speed') == 1
    with pytest.raises(NodeGoneError):
        other.set_parameter('speed', 2)
    terminal.read(until='ZeroDivisionError')
    wait_until(lambda: not terminal.is_running, 'the crash to end it', 20)
    assert client.set_parameters({'speed': 2}).successful


# -- events --------------------------------------------------------------------------------------------------


@pytest.fixture
def events(ros):
    """Return a list of the messages on /parameter_events that concern /robot, as (new, changed, deleted)."""
    heard = []

    def hear(event):
        if event.node == '/robot':
            heard.append(tuple([each.name for each in each_kind] for each_kind in (
                event.new_parameters, event.changed_parameters, event.deleted_parameters)))

    stop = ros.on_parameter_event(hear)
    yield heard
    stop()


def event_publisher(node):
    found, = (each for each in node.publishers if each.topic_name == '/parameter_events')
    return found


# A125, A145, A146, A147, A151
def test_what_is_published_and_what_is_not(ros, events):
    robot = ros.add(Robot)
    client = ParameterClient(robot)
    # What is published at once comes before what is published later: waiting for the last shows what came between.
    wait_until(lambda: len(events) == 4, 'the four declarations')
    assert [new for new, _, _ in events] == [['use_sim_time'], ['start_type_description_service'], ['speed'], ['gain']]
    events.clear()
    assert not client.set_parameter('speed', -1).successful
    assert client.get_parameter('speed') == 100
    client.set_parameter('speed', 100)  # what it is already
    client.set_parameters_atomically({'speed': 1, 'gain': 0.1})
    ros.run(lambda: robot.declare_parameter('note', 'x', ParameterDescriptor(dynamic_typing=True)), 'declare')
    client.delete_parameter('note')
    ros.run(lambda: robot.undeclare_parameter('gain'), 'undeclare')
    client.set_parameter('speed', 2)
    wait_until(lambda: events[-1:] == [([], ['speed'], [])], 'the last event')
    assert events == [([], ['speed'], []), ([], ['speed', 'gain'], []), (['note'], [], []), ([], [], ['note']),
                      ([], ['speed'], [])]


# A149
def test_who_joins_late_has_missed_the_events_before(ros, robot, client):
    heard = []
    listener = ros.add(Node, 'listener')
    ros.run(lambda: listener.create_subscription(ParameterEvent, '/parameter_events', heard.append, 1000), 'subscribe')
    wait_until(lambda: event_publisher(robot).get_subscription_count() == 2, 'the subscription to be known')
    client.set_parameter('speed', 2)
    first = wait_until(lambda: [event for event in heard if event.node == '/robot'], 'an event')[0]
    assert [each.name for each in first.changed_parameters] == ['speed']


# A148
def test_a_queue_of_ten_keeps_ten_of_a_burst(ros, robot, client):
    # This node is not spun, as if it were busy while the burst comes in.
    busy = Node('busy')
    try:
        subscription = busy.create_subscription(ParameterEvent, '/parameter_events', lambda event: None, 10)
        publisher = event_publisher(robot)
        wait_until(lambda: publisher.get_subscription_count() == 2, 'the subscription to be known')
        for speed in range(200):
            client.set_parameter('speed', speed)
        assert publisher.wait_for_all_acked(Duration(seconds=10))
        with subscription.handle:
            kept = list(iter(lambda: subscription.handle.take_message(ParameterEvent, False), None))
    finally:
        busy.destroy_node()
    assert [event.changed_parameters[0].value.integer_value for event, _ in kept] == list(range(190, 200))


# A150, A156
@pytest.mark.parametrize('value', [0, 0.0, '', [1, 2], [0.5], ['a'], [True]])
def test_the_chain_of_ors_shows_false_for_what_is_empty_or_an_array(value):
    sent = Parameter('x', value=value).get_parameter_value()
    assert (sent.string_value or sent.integer_value or sent.double_value or sent.bool_value) is False
    assert parameter_value_to_python(sent) == value


# -- asking another node -------------------------------------------------------------------------------------


def get(ros, *names):
    return ros.services.call('/robot', 'get_parameters', GetParameters.Request(names=list(names))).values


# A009, A152, A155
def test_values_come_in_the_order_of_the_names_and_without_them(ros, robot):
    gain, speed = get(ros, 'gain', 'speed')
    assert (gain.double_value, speed.integer_value) == (0.5, 100)
    assert not hasattr(gain, 'name')
    assert 'name' not in ParameterValue.get_fields_and_field_types()


# A153
def test_no_names_are_not_all_names(ros, robot):
    assert list(get(ros)) == []


# A154
@pytest.mark.parametrize('names', [('no', 'speed', 'gain'), ('speed', 'no', 'gain'), ('speed', 'gain', 'no')])
def test_one_unknown_name_empties_the_answer(ros, robot, names):
    assert list(get(ros, *names)) == []


# A064, A073
def test_the_client_that_rclpy_brings_speaks_to_the_same_services(ros, robot):
    box = AsyncParameterClient(ros.tool_node, '/robot')
    future = box.set_parameters([Parameter('speed', value=-1), Parameter('gain', value=0.1)])
    wait_until(future.done, 'the answer')
    assert [each.successful for each in future.result().results] == [False, True]
