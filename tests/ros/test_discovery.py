"""Discovery between processes: each new one finds the node that is there, on its own host and over a cable."""

import contextlib

import pytest

from tests.support import hosts, missing
from tests.support.lab import wait_for

pytestmark = pytest.mark.timeout(400)

# Each input() waits for the test.
NODE = '''
import os, param_tutorial
from param_tutorial.nodes.simple_param_node import SimpleParamNode
param_tutorial.start().add(SimpleParamNode)
print(os.environ['ROS_DOMAIN_ID'], flush=True)
input()
'''
PANEL = '''
import param_tutorial
param_tutorial.start()
panel = param_tutorial.ParameterPanel('/simple_param_node')
param_tutorial.wait_until(lambda: 'max_speed_rpm' in panel, 'the panel to find the node', 60)
control = panel['max_speed_rpm']
for value in (120, 160):
    control.value = value
    panel.settle(60)
    print(control.value, flush=True)
    input()
    param_tutorial.wait_until(lambda: 'is not running' in panel.status, 'the word that the node is gone', 60)
    print(panel.status, flush=True)
    input()
    param_tutorial.wait_until(lambda: not panel.status, 'the panel to find the node again', 60)
'''


@pytest.fixture
def two_hosts(tmp_path):
    """Yield a robot and a laptop that share a network."""
    if not hosts.can_be_made():
        missing.skip('two hosts need root')
    with contextlib.ExitStack() as stack:
        robot, laptop = (hosts.Host(name, tmp_path / name) for name in ('robot', 'laptop'))
        for host in (robot, laptop):
            stack.callback(host.end)
        hosts.connect(robot, laptop)
        yield robot, laptop


def said(process):
    return process.stdout.readline().strip()


def go_on(process):
    process.stdin.write('\n')
    process.stdin.flush()


@pytest.mark.rare
def test_a_terminal_and_a_panel_set_a_node_on_another_host_until_the_cable_is_out(two_hosts):
    robot, laptop = two_hosts
    assert said(robot.start('-c', NODE, ROS_DOMAIN_ID='42')) == '42'
    # In the second after an interface is up, a process may see none of the other host, and not for as long as it lives.
    wait_for(lambda: laptop.ros2('param', 'set', '/simple_param_node', 'max_speed_rpm', '110', ROS_DOMAIN_ID='42')
             == 'Set parameter successful', 'the node to be found')
    panel = laptop.start('-c', PANEL, ROS_DOMAIN_ID='42')
    assert said(panel) == '120'
    hosts.ip('-n', robot.name, 'link', 'set', 'eth0', 'down')
    go_on(panel)
    assert 'is not running, or the network to its machine is down' in said(panel)
    hosts.ip('-n', robot.name, 'link', 'set', 'eth0', 'up')
    go_on(panel)
    assert said(panel) == '160'


@pytest.mark.rare
def test_no_other_host_sees_a_node_unless_its_user_says_so(two_hosts):
    robot, laptop = two_hosts
    domain = said(robot.start('-c', NODE))
    # Someone who knows the domain, listens on all interfaces, and knows the address.
    assert 'Node not found' in laptop.ros2(
        'param', 'get', '/simple_param_node', 'max_speed_rpm', ROS_DOMAIN_ID=domain,
        ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET', ROS_STATIC_PEERS='10.77.0.2')


@pytest.mark.thorough
@pytest.mark.parametrize('setting', hosts.SETTINGS)
def test_each_new_process_finds_the_node_that_is_there(two_hosts, setting):
    variables = two_hosts[0].start_nodes(setting, 'robot')
    for _ in range(30):
        assert two_hosts[0].ros2('param', 'get', '/robot', 'x', **variables) == 'Integer value is: 1'


@pytest.mark.thorough
@pytest.mark.parametrize('setting', hosts.SETTINGS)
def test_each_new_process_lists_all_nodes(two_hosts, setting):
    names = [f'robot_{number}' for number in range(3)]
    variables = two_hosts[0].start_nodes(setting, *names)
    wait_for(lambda: len(two_hosts[0].ros2('node', 'list', **variables).split()) == len(names), 'the nodes to come')
    for _ in range(5):
        assert two_hosts[0].ros2('node', 'list', **variables).split() == [f'/{name}' for name in names]
