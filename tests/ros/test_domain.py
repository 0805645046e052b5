"""domain: a ROS domain for each process, unless the user chose one."""

import os
import socket
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from param_tools.errors import ExecutorError
from param_tools.ros import domain
from tests.support.processes import environment_without_domain

CHOOSE = """
import os
from param_tools.ros import domain
print(domain.choose(), *map(os.environ.get, ('ROS_AUTOMATIC_DISCOVERY_RANGE', 'FASTRTPS_DEFAULT_PROFILES_FILE')))
"""


def nothing_chosen():
    """Return the environment of a user who has chosen neither a domain nor a network."""
    return {name: value for name, value in os.environ.items() if not name.startswith(('ROS_', 'FAST'))}


def choose(**environment):
    """Let a new process choose, and return what it prints: its domain, the range of discovery, and the profiles."""
    return subprocess.run([sys.executable, '-c', CHOOSE], env={**nothing_chosen(), **environment},
                          capture_output=True, text=True, check=False)


def test_living_processes_have_different_domains():
    source = 'from param_tools.ros import domain; print(domain.choose(), flush=True); input()'
    environment = environment_without_domain()
    children = [subprocess.Popen([sys.executable, '-c', source], env=environment, text=True,
                                 stdin=subprocess.PIPE, stdout=subprocess.PIPE) for _ in range(3)]
    try:
        chosen = [int(child.stdout.readline()) for child in children]
    finally:
        for child in children:
            child.communicate('\n')
    assert len({*chosen, domain.choose()}) == 4
    assert set(chosen) <= set(domain.DOMAIN_IDS)


def test_a_claimed_domain_stays_on_the_loopback_interface_and_out_of_shared_memory():
    source = 'import param_tutorial; param_tutorial.start(); print(flush=True); input()'
    with subprocess.Popen([sys.executable, '-c', source], env=nothing_chosen(), text=True,
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE) as child:
        child.stdout.readline()
        sockets = {socket.laddr.ip for socket in psutil.Process(child.pid).net_connections('udp')}
        maps = Path(f'/proc/{child.pid}/maps').read_text()
        child.communicate('\n')
    assert sockets == {'127.0.0.1'}
    assert 'fastrtps' in maps  # its library
    assert '/dev/shm/fastrtps' not in maps


def test_what_the_user_chose_is_kept():
    number, discovery, profiles = choose(ROS_DOMAIN_ID='42').stdout.split()
    assert (number, discovery) == ('42', 'None') and profiles.endswith('/fastdds.xml')
    _, discovery, profiles = choose(ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET').stdout.split()
    assert discovery == 'SUBNET' and profiles.endswith('/fastdds.xml')
    assert choose(FASTRTPS_DEFAULT_PROFILES_FILE='/x').stdout.split()[2] == '/x'
    assert "ROS_DOMAIN_ID is '233': it must be an integer" in choose(ROS_DOMAIN_ID='233').stderr


def test_a_domain_where_a_stranger_lives_is_passed_over(monkeypatch):
    domain_id, descriptor = domain._claim_free_domain()
    monkeypatch.setattr(domain, 'DOMAIN_IDS', range(domain_id, domain_id + 1))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(('127.0.0.1', 7400 + 250 * domain_id + 10 + 2 * 7))
        os.close(descriptor)
        with pytest.raises(ExecutorError, match='are in use on this machine'):
            domain._claim_free_domain()


def test_what_the_user_has_set_for_a_robots_network_does_not_part_processes_here():
    source = ('import param_tutorial, subprocess, sys\n'
              'ros = param_tutorial.start()\n'
              'from rclpy.node import Node\n'
              'ros.add(Node, "here")\n'
              'print(subprocess.check_output([sys.executable, "-m", "param_tutorial", "node", "list"], text=True))')
    # Each of them, alone, keeps the second process from finding the node, or one of the two from starting.
    others = {'ROS_DISCOVERY_SERVER': '192.0.2.1:11811', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF',
              'ROS_SECURITY_ENABLE': 'true', 'ROS_SECURITY_STRATEGY': 'Enforce', 'ROS_LOCALHOST_ONLY': '1',
              'RMW_IMPLEMENTATION': 'rmw_cyclonedds_cpp'}
    done = subprocess.run([sys.executable, '-c', source], env={**nothing_chosen(), **others}, capture_output=True,
                          text=True, check=False)
    assert done.stdout.split() == ['/here'], done.stderr
    # One warning, and from this module alone.
    assert done.stderr == ('RMW_IMPLEMENTATION is rmw_cyclonedds_cpp, which this Python does not have: continuing with '
                           'the default.\n')
