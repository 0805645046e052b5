"""Hosts on this machine: network namespaces with interfaces, a loopback and shared memory of their own."""

import json
import os
import subprocess
import sys
from pathlib import Path

from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

# A node until input() ends, with rclpy alone or as the course runs it; it says what a process needs to join it.
PLAIN_NODE = '''
import sys, threading, rclpy
from rclpy.node import Node
rclpy.init()
robot = Node(sys.argv[1])
robot.declare_parameter('x', 1)
threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
print('{}', flush=True)
input()
'''
NODE_OF_THE_COURSE = '''
import json, sys, param_tutorial
from rclpy.node import Node
from param_tools.ros import domain
param_tutorial.start().add(Node, sys.argv[1]).declare_parameter('x', 1)
print(json.dumps(domain.settings()), flush=True)
input()
'''
# What a user has set, and the other node. Where nothing is set, a kernel is in a domain of its own, with our profile.
SETTINGS = {
    'nothing': ({}, NODE_OF_THE_COURSE),
    'LOCALHOST': ({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}, PLAIN_NODE),
    'SUBNET': ({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}, PLAIN_NODE),
}


def can_be_made() -> bool:
    """True if this user may make network namespaces, as root may."""
    return not subprocess.run(['unshare', '--net', '--mount', 'true'], capture_output=True).returncode


def ip(*words: str) -> None:
    subprocess.run(['ip', *words], check=True, capture_output=True)


class Host:
    """A host with one Ethernet interface."""

    def __init__(self, name: str, folder: Path):
        self.name = f'pt{os.getpid()}-{name}'
        folder.mkdir()
        # What `ip netns exec` runs has mounts of its own.
        self._command = ['ip', 'netns', 'exec', self.name, 'sh', '-c', 'mount --bind "$0" /dev/shm; exec "$@"',
                         str(folder), sys.executable]
        self._started: list[subprocess.Popen[str]] = []
        ip('netns', 'add', self.name)
        ip('-n', self.name, 'link', 'set', 'lo', 'up')

    def start(self, *words: str, stderr: int | None = None, **variables: str) -> 'subprocess.Popen[str]':
        """Start Python with these words, as a user who has set only these variables; it ends with the host."""
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(('ROS_', 'FASTRTPS_', 'RMW_', 'PYTEST'))}
        self._started.append(subprocess.Popen([*self._command, *words], env=environment | variables, cwd=ROOT,
                                              text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr))
        return self._started[-1]

    def ros2(self, *words: str, **variables: str) -> str:
        """Return what a command answers."""
        process = self.start('-m', 'param_tutorial', *words, stderr=subprocess.STDOUT, **variables)
        return process.communicate()[0].strip()

    def start_nodes(self, setting: str, *names: str) -> dict[str, str]:
        """Start nodes, each in a process of its own, and return the variables with which a new process joins them.

        :param setting: One of SETTINGS.
        """
        variables, node = SETTINGS[setting]
        for name in names:
            process = self.start('-c', node, name, **variables)
            variables = variables | json.loads(process.stdout.readline())
        return variables

    def end(self) -> None:
        """End its processes, and the host."""
        for process in self._started:
            process.stdin.close()
            wait_or_kill(process)
            process.stdout.close()
        ip('netns', 'delete', self.name)


def connect(one: Host, other: Host) -> None:
    """Lay a cable between two hosts."""
    ip('link', 'add', 'eth0', 'netns', one.name, 'type', 'veth', 'peer', 'name', 'eth0', 'netns', other.name)
    for host, address in ((one, '10.77.0.2/24'), (other, '10.77.0.1/24')):
        ip('-n', host.name, 'address', 'add', address, 'dev', 'eth0')
        ip('-n', host.name, 'link', 'set', 'eth0', 'up')
