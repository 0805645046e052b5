"""A node on one host, a terminal or a panel on another, and a cable between them; and who cannot reach a notebook."""

import contextlib
import json
import socket
import subprocess
import sys
import urllib.error
import urllib.request

import psutil
import pytest

from tests.network.conftest import Host, ip
from tests.support.lab import CourseLab, wait_for
from tests.support.paths import NOTEBOOKS

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(400)]

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


def test_a_terminal_sets_a_node_on_another_host(hosts):
    robot, laptop = hosts
    assert said(robot.start('-c', NODE, ROS_DOMAIN_ID='42')) == '42'
    assert param(laptop, 'set', '/simple_param_node', 'max_speed_rpm', '120') == 'Set parameter successful'
    assert param(laptop, 'get', '/simple_param_node', 'max_speed_rpm') == 'Integer value is: 120'
    said_no = param(laptop, 'set', '/simple_param_node', 'max_speed_rpm', '-5')
    assert 'max_speed_rpm must not be negative, got -5' in said_no


def test_a_panel_says_that_the_cable_is_out_and_comes_back_with_it(hosts):
    robot, laptop = hosts
    node = robot.start('-c', NODE, ROS_DOMAIN_ID='42')
    assert said(node) == '42'
    param(laptop, 'get', '/simple_param_node', 'max_speed_rpm')
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


# In the second case, the stranger is not blind.
@pytest.mark.parametrize(('chosen', 'is_seen'), [({}, False), ({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}, True)])
def test_no_other_host_sees_a_node_unless_its_user_says_so(hosts, chosen, is_seen):
    robot, laptop = hosts
    domain = said(robot.start('-c', NODE, **chosen))
    # Someone who knows the domain, listens on all interfaces, knows the address, and tries ten times.
    answers = (laptop.run(*ROS2, 'param', 'get', '/simple_param_node', 'max_speed_rpm', ROS_DOMAIN_ID=domain,
                          ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET', ROS_STATIC_PEERS=robot.address) for _ in range(10))
    assert any(answer == 'Integer value is: 100' for answer in answers) is is_seen


class PlainLab(CourseLab):
    """JupyterLab as `make lab` starts it, without a word on addresses, ports and tokens."""

    def _options(self) -> list[str]:
        return ['--no-browser']

    def _find_url(self) -> str | None:
        info = self.runtime / f'jpserver-{self._process.pid}.json'
        with contextlib.suppress(OSError, ValueError):
            self.token = json.loads(info.read_text())['token']
        return super()._find_url()


def test_jupyterlab_and_its_kernels_cannot_be_reached_from_another_host(tmp_path):
    with PlainLab(tmp_path / 'lab', [NOTEBOOKS / '01_what_are_parameters.ipynb']) as lab:
        start_kernel = urllib.request.Request(f'{lab.url}api/kernels?token={lab.token}', b'{}')
        assert urllib.request.urlopen(start_kernel).status == 201
        server = psutil.Process(lab._process.pid)
        listening = {each.laddr.ip for process in (server, *server.children(recursive=True))
                     for each in process.net_connections('inet')
                     if each.status == psutil.CONN_LISTEN or each.type == socket.SOCK_DGRAM}
        assert listening <= {'127.0.0.1', '::1'}
        assert len(lab.token) >= 40
        with pytest.raises(urllib.error.HTTPError, match='403'):
            urllib.request.urlopen(f'{lab.url}api/kernels')


def test_a_chapter_needs_no_network(hosts):
    robot, _ = hosts
    ip('-n', robot.name, 'link', 'delete', 'eth0')
    chapter = NOTEBOOKS / '05_2_with_a_callback.ipynb'
    said = robot.run(sys.executable, '-m', 'pytest', '-q', '-p', 'no:cacheprovider', '--nbval', chapter)
    assert ' passed' in said and 'failed' not in said, said
