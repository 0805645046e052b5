"""A node on one host, a terminal and a panel on another, and a cable between them.

A host is a network namespace of this machine: its processes have its interfaces, its loopback and its shared memory.
"""

import contextlib
import os
import subprocess
import sys

import pytest

from tests.support import missing
from tests.support.lab import wait_for
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.slow, pytest.mark.rare, pytest.mark.timeout(400)]

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


def ip(*words):
    subprocess.run(['ip', *words], check=True, capture_output=True)


class Host:
    """A host with one Ethernet interface."""

    def __init__(self, name, folder):
        self.name = f'pt{os.getpid()}-{name}'
        folder.mkdir()
        # What `ip netns exec` runs has mounts of its own.
        self._command = ['ip', 'netns', 'exec', self.name, 'sh', '-c', 'mount --bind "$0" /dev/shm; exec "$@"',
                         str(folder), sys.executable]
        self._started = []
        ip('netns', 'add', self.name)
        ip('-n', self.name, 'link', 'set', 'lo', 'up')

    def start(self, *words, stderr=None, **variables):
        """Start Python with these words, as a user who has set only these variables; it ends with the host."""
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(('ROS_', 'FASTRTPS_', 'RMW_', 'PYTEST'))}
        self._started.append(subprocess.Popen([*self._command, *words], env=environment | variables, cwd=ROOT,
                                              text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr))
        return self._started[-1]

    def param(self, *words, **variables):
        """Return what a command answers."""
        process = self.start('-m', 'param_tutorial', 'param', *words, stderr=subprocess.STDOUT, **variables)
        return process.communicate()[0].strip()

    def end(self):
        for process in self._started:
            process.stdin.close()
            wait_or_kill(process)
            process.stdout.close()
        ip('netns', 'delete', self.name)


@pytest.fixture
def hosts(tmp_path):
    """Yield a robot and a laptop that share a network."""
    if subprocess.run(['unshare', '--net', '--mount', 'true'], capture_output=True).returncode:
        missing.skip('two hosts need root')
    with contextlib.ExitStack() as stack:
        robot, laptop = hosts = [Host(name, tmp_path / name) for name in ('robot', 'laptop')]
        for host in hosts:
            stack.callback(host.end)
        ip('link', 'add', 'eth0', 'netns', robot.name, 'type', 'veth', 'peer', 'name', 'eth0', 'netns', laptop.name)
        for host, address in zip(hosts, ('10.77.0.2/24', '10.77.0.1/24')):
            ip('-n', host.name, 'address', 'add', address, 'dev', 'eth0')
            ip('-n', host.name, 'link', 'set', 'eth0', 'up')
        yield hosts


def said(process):
    return process.stdout.readline().strip()


def go_on(process):
    process.stdin.write('\n')
    process.stdin.flush()


def test_a_terminal_and_a_panel_set_a_node_on_another_host_until_the_cable_is_out(hosts):
    robot, laptop = hosts
    assert said(robot.start('-c', NODE, ROS_DOMAIN_ID='42')) == '42'
    # In the second after an interface is up, a process may see none of the other host, and not for as long as it lives.
    wait_for(lambda: laptop.param('set', '/simple_param_node', 'max_speed_rpm', '110', ROS_DOMAIN_ID='42')
             == 'Set parameter successful', 'the node to be found')
    panel = laptop.start('-c', PANEL, ROS_DOMAIN_ID='42')
    assert said(panel) == '120'
    ip('-n', robot.name, 'link', 'set', 'eth0', 'down')
    go_on(panel)
    assert 'is not running, or the network to its machine is down' in said(panel)
    ip('-n', robot.name, 'link', 'set', 'eth0', 'up')
    go_on(panel)
    assert said(panel) == '160'


def test_no_other_host_sees_a_node_unless_its_user_says_so(hosts):
    robot, laptop = hosts
    domain = said(robot.start('-c', NODE))
    # Someone who knows the domain, listens on all interfaces, and knows the address.
    assert 'Node not found' in laptop.param(
        'get', '/simple_param_node', 'max_speed_rpm', ROS_DOMAIN_ID=domain, ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET',
        ROS_STATIC_PEERS='10.77.0.2')
