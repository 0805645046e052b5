"""The lessons' nodes: what they declare, reject and do, and that each stands on rclpy alone."""

import ast
import re
import sys

import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

import param_tutorial
from param_tutorial import ParameterClient, Terminal
from param_tutorial.nodes.param_event_monitor import ParamEventMonitor
from param_tutorial.nodes.param_query_node import ParamQueryNode
from param_tutorial.nodes.param_setter_node import ParamSetterNode
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.paths import PACKAGE

ALLOWED = {'rclpy', 'rcl_interfaces', 'geometry_msgs', 'sensor_msgs'}
FILES = sorted((PACKAGE / 'nodes').glob('[a-z]*.py'))


def test_a_node_can_be_copied_out():
    for path in FILES:
        imported = set()
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                imported |= {alias.name.split('.')[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                imported.add('.' if node.level else node.module.split('.')[0])
        assert imported - set(sys.stdlib_module_names) <= ALLOWED, path.stem


@pytest.mark.parametrize('path', [FILES[0], *(pytest.param(each, marks=pytest.mark.rare) for each in FILES[1:])],
                         ids=lambda path: path.stem)
def test_a_copied_node_runs_and_ends_on_ctrl_c_without_a_traceback(ros, path, tmp_path):
    copy = tmp_path / 'copied.py'
    copy.write_text(path.read_text())
    terminal = Terminal(f'"{sys.executable}" {copy}')
    name = re.search(r'\[(\w+)\]: ', terminal.read(until='has been started'))[1]
    # It answers, so it spins. A Ctrl+C while rclpy is still building its executor makes rclpy itself complain.
    ParameterClient(f'/{name}', timeout_sec=30).list_parameters()
    assert terminal.interrupt() == 0
    assert 'Traceback' not in terminal.text


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(SimpleParamNode))


def test_the_robot_declares_the_seven_parameters_of_the_course(client):
    own = {name: value for name, value in client.get_parameters().items()
           if name not in ('use_sim_time', 'start_type_description_service')}
    assert own == {'robot_name': 'Clawbot', 'max_speed_rpm': 100, 'enable_safety_mode': True,
                   'sensor_offset_meters': 0.15, 'max_acceleration_mps2': 0.5,
                   'min_operating_temperature_c': -5, 'robot_serial_number': 'SN-CLAW-001'}
    assert all(each.description for each in client.describe_parameters(own).values())


# claims A052: the article's comparison rejects every one of the first three.
def test_the_robot_rejects_what_makes_no_sense(client):
    for name, value, kind in [
            ('max_speed_rpm', 150, 'accepted'), ('max_speed_rpm', 0, 'accepted'),
            ('max_acceleration_mps2', 0.75, 'accepted'), ('max_speed_rpm', -1, 'rejected by the node'),
            ('robot_name', ' ', 'rejected by the node'), ('max_acceleration_mps2', 2.5, 'out of range'),
            ('min_operating_temperature_c', 51, 'out of range'), ('robot_serial_number', 'SN-2', 'read only'),
            ('enable_safety_mode', 1, 'wrong type')]:
        assert client.set_parameter(name, value).kind == kind, (name, value)


def test_the_robot_reacts_to_stored_values_alone(client, ros):
    ros.node_log.read(until='robot_serial_number')
    client.set_parameters_atomically({'max_speed_rpm': 5, 'robot_name': ''})
    client.set_parameter('max_speed_rpm', 6)
    assert ros.node_log.read(until='max_speed_rpm') == '[INFO] [simple_param_node]: max_speed_rpm is now 6'


def test_the_setter_waits_for_its_target_and_reports_each_result(ros):
    setter = ros.add(ParamSetterNode)
    ros.run(setter.set_parameters_periodically, 'press the button')
    assert 'not there yet' in ros.node_log.read(until='/simple_param_node')
    ros.add(SimpleParamNode)
    setter.iteration = 2
    param_tutorial.wait_until(setter.client.service_is_ready, 'the target')
    ros.run(setter.set_parameters_periodically, 'press the button')
    report = ros.node_log.read(until='max_acceleration_mps2 =', node='/param_setter_node').splitlines()
    assert [line.split(': ')[2] for line in report[-4:]] == ['accepted', 'accepted', 'accepted', 'rejected']
    assert ParameterClient('/simple_param_node').get_parameter('max_speed_rpm') == 130


def test_the_setter_asks_for_safety_each_second_time_and_for_a_wrong_value_each_third():
    for iteration in range(1, 61):
        _, safety, _, acceleration = (each.value for each in ParamSetterNode.proposal(iteration))
        assert safety == (iteration % 2 == 0)
        assert (0.01 <= acceleration <= 2.0) == (iteration % 3 != 0)


class Odd(Node):
    """Stands in for the robot, with values that the article's chain of `or` shows as False, and one that is not set."""

    def __init__(self, *, unset=False):
        super().__init__('simple_param_node')
        self.declare_parameters('', [('zero', 0), ('nought', 0.0), ('empty', ''), ('numbers', [1, 2])])
        self.declare_parameter('note', 'dynamic', ParameterDescriptor(dynamic_typing=True))
        if unset:
            self.declare_parameter('unset', Parameter.Type.DOUBLE)


def said(ros, node, until):
    lines = ros.node_log.read(until=until, node=node).splitlines()
    return [line.partition(']: ')[2] for line in lines]


# claims A147, A150, A151
def test_the_monitor_tells_what_became_of_each_parameter_and_its_true_value(ros):
    ros.add(ParamEventMonitor)
    client = ParameterClient(ros.add(Odd))
    client.set_parameters({'zero': 0, 'nought': -0.0, 'empty': '', 'numbers': [3], 'note': None})
    lines = said(ros, '/param_event_monitor', 'deleted')
    assert [line for line in lines if line.startswith('/simple_param_node: new')][-5:-1] == [
        f'/simple_param_node: new {each}' for each in ('zero = 0', 'nought = 0.0', "empty = ''", 'numbers = [1, 2]')]
    assert lines[-5:] == [f'/simple_param_node: {each}' for each in (
        'changed zero = 0', 'changed nought = -0.0', "changed empty = ''", 'changed numbers = [3]', 'deleted note')]


# claim A148
def test_the_monitor_loses_nothing_of_a_burst(ros):
    monitor, robot = ros.add(ParamEventMonitor), ros.add(Odd)
    heard = []
    monitor.format_parameter = lambda parameter: heard.append(parameter.value.integer_value)
    ros.run(lambda: [robot.set_parameters([Parameter('zero', value=value)]) for value in range(300)], 'burst')
    param_tutorial.wait_until(lambda: heard[-1:] == [299], 'the last event')
    assert heard[-300:] == list(range(300))


@pytest.mark.parametrize('unset', [False, True])
def test_the_query_node_waits_for_its_target_and_logs_all_parameters(ros, unset):
    query = ros.add(ParamQueryNode)
    ros.run(query.ask, 'press the button')
    assert said(ros, '/param_query_node', 'waiting')[-1] == '/simple_param_node is not there yet, waiting...'
    ros.add(Odd, unset=unset)
    param_tutorial.wait_until(lambda: all(client.service_is_ready() for client in query.clients), 'the target')
    ros.run(query.ask, 'press the button')
    lines = said(ros, '/param_query_node', 'unset is not set' if unset else 'note =')
    assert lines[-6 - unset:] == [
        '  start_type_description_service = True', '  zero = 0', '  nought = 0.0', "  empty = ''", '  numbers = [1, 2]',
        "  note = 'dynamic'", *['  unset is not set'] * unset]


def test_the_query_node_asks_again_where_no_answer_comes(ros):
    dozing = Node('simple_param_node')  # there, and nobody spins it
    try:
        query = ros.add(ParamQueryNode)
        param_tutorial.wait_until(lambda: all(client.service_is_ready() for client in query.clients), 'the target')
        for _ in range(2):
            ros.run(query.ask, 'press the button')
        assert 'has not answered within 2 s, asking again' in ros.node_log.read('asking again', '/param_query_node')
    finally:
        dozing.destroy_node()


class Forgetful(Node):
    """Has the name of the robot, and says which parameters it has, but leaves the first question for values open."""

    def __init__(self):
        super().__init__('simple_param_node', start_parameter_services=False)
        self.asked = 0
        self.create_service(ListParameters, '~/list_parameters', self.tell_names)
        self.create_service(GetParameters, '~/get_parameters', self.tell_values)

    def tell_names(self, _, response):
        response.result.names = ['speed']
        return response

    def tell_values(self, _, response):
        self.asked += 1
        if self.asked == 1:
            raise RuntimeError('as good as dead')
        response.values = [Parameter('speed', value=3).get_parameter_value()]
        return response


def test_the_query_node_asks_again_where_only_the_names_came(ros):
    target = ros.add(Forgetful)
    query = ros.add(ParamQueryNode)
    param_tutorial.wait_until(lambda: all(client.service_is_ready() for client in query.clients), 'the target')
    ros.run(query.ask, 'press the button')
    param_tutorial.wait_until(lambda: target.asked == 1, 'the first question')
    assert not query.timer.is_canceled()
    ros.run(query.ask, 'press the button')
    assert said(ros, '/param_query_node', 'speed =')[-1] == '  speed = 3'
    param_tutorial.wait_until(query.timer.is_canceled, 'the timer to end')
