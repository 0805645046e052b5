"""A node on one host, a terminal and a panel on another, and a cable between them."""

import subprocess
import sys

import pytest

from tests.network.conftest import Host, ip
from tests.support.lab import wait_for

pytestmark = [pytest.mark.slow, pytest.mark.rare, pytest.mark.timeout(400)]

ROS2 = (sys.executable, '-m', 'param_tutorial')
# Each input() waits for the test.
NODE = '''
import os, param_tutorial
from param_tutorial.nodes.simple_param_node import SimpleParamNode
ros = param_tutorial.start()
ros.add(SimpleParamNode)
print(os.environ['ROS_DOMAIN_ID'], flush=True)
input()
own = ['/_param_tools', '/simple_param_node']
param_tutorial.wait_until(lambda: ros.services.node_names(hidden=True) == own, 'the laptop to be given up', 60)
print('alone', flush=True)
input()
'''
PANEL = '''
import param_tutorial
param_tutorial.start()
panel = param_tutorial.ParameterPanel('/simple_param_node')
param_tutorial.wait_until(lambda: 'max_speed_rpm' in panel, 'the panel to find the node', 60)
control = panel['max_speed_rpm']
control.value = 120
panel.settle(60)
print(control.value, flush=True)
input()
control.value = 150
param_tutorial.wait_until(lambda: control.message, 'a word that no answer came', 60)
print(control.message, flush=True)
param_tutorial.wait_until(lambda: 'is not running' in panel.status, 'the word that the node is gone', 60)
print(panel.status, flush=True)
input()
param_tutorial.wait_until(lambda: not panel.status, 'the panel to find the node again', 60)
control.value = 160
panel.settle(60)
print(control.value, flush=True)
input()
'''


def said(process: subprocess.Popen[str]) -> str:
    return process.stdout.readline().strip()


def go_on(process: subprocess.Popen[str]) -> None:
    process.stdin.write('\n')
    process.stdin.flush()


def param(host: Host, *words: str) -> str:
    """Return what a command answers that has found the node: each looks for half a second at most.

    In the second after an interface is up, a process may see none of the other host, and not for as long as it lives.
    """
    def answer() -> str | None:
        text = host.run(*ROS2, 'param', *words, ROS_DOMAIN_ID='42')
        return None if 'Node not found' in text else text

    return wait_for(answer, 'the node to be found')


def test_a_terminal_and_a_panel_set_a_node_on_another_host_until_the_cable_is_out(hosts):
    robot, laptop = hosts
    node = robot.start('-c', NODE, ROS_DOMAIN_ID='42')
    assert said(node) == '42'
    assert param(laptop, 'set', '/simple_param_node', 'max_speed_rpm', '110') == 'Set parameter successful'
    panel = laptop.start('-c', PANEL, ROS_DOMAIN_ID='42')
    assert said(panel) == '120'
    ip('-n', robot.name, 'link', 'set', 'eth0', 'down')
    for process in (node, panel):
        go_on(process)
    assert 'or the network to its machine is slow or down' in said(panel)
    assert 'is not running, or the network to its machine is down' in said(panel)
    assert said(node) == 'alone'
    ip('-n', robot.name, 'link', 'set', 'eth0', 'up')
    go_on(panel)
    assert said(panel) == '160'


def test_no_other_host_sees_a_node_unless_its_user_says_so(hosts):
    robot, laptop = hosts
    domain = said(robot.start('-c', NODE))
    # Someone who knows the domain, listens on all interfaces, knows the address, and tries three times.
    answers = (laptop.run(*ROS2, 'param', 'get', '/simple_param_node', 'max_speed_rpm', ROS_DOMAIN_ID=domain,
                          ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET', ROS_STATIC_PEERS=robot.address) for _ in range(3))
    assert not any(answer == 'Integer value is: 100' for answer in answers)
