"""The panel's page beside a robot: who on another host reaches it, what it shows there, and what can be set there."""

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.network.conftest import Host
from tests.support import lab, missing
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]

DOMAIN = {'ROS_DOMAIN_ID': '42'}
NODE = '''
import sys
import param_tutorial
from rclpy.node import Node
node = param_tutorial.start().add(Node, sys.argv[1])
node.declare_parameter('speed', 1.5)
print('ready', flush=True)
sys.stdin.read()
'''
# Says where a request has ended, or why it got nowhere.
ASK = '''
import ssl, sys, urllib.request
url, *certificate = sys.argv[1:]
trusted = ssl.create_default_context(cafile=certificate[0]) if certificate else None
try:
    print(urllib.request.urlopen(url, context=trusted, timeout=20).url)
except OSError as error:
    print(error)
'''


def start_node(host: Host, name: str, **variables: str) -> None:
    assert host.start('-c', NODE, name, **DOMAIN, **variables).stdout.readline() == 'ready\n'


@pytest.fixture
def page(hosts, tmp_path):
    """Return a function that starts the page on the robot, and returns its address and what else it says."""
    robot, _ = hosts
    started = []

    def start(*options: str | Path, **variables: str) -> tuple[str, str]:
        started.append(robot.start('-m', 'param_tools', 'panel', '--no-browser', *options, **DOMAIN,
                                   **variables, PYTHONUNBUFFERED='1', TMPDIR=str(tmp_path)))
        address, said = started[-1].stdout.readline(), started[-1].stdout.readline()
        return re.fullmatch(r'The panel is at (https?://[0-9.]+:\d+/\?token=\S{32})\n', address)[1], said

    yield start
    for process in started:
        process.send_signal(signal.SIGINT)
        wait_or_kill(process)


@pytest.fixture
def certificate(hosts, tmp_path):
    """Return a certificate for the robot's address, and its key."""
    robot, _ = hosts
    files = tmp_path / 'certificate.pem', tmp_path / 'key.pem'
    subprocess.run(['openssl', 'req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-days', '2', '-subj', '/CN=robot',
                    '-addext', f'subjectAltName=IP:{robot.address}', '-out', files[0], '-keyout', files[1]],
                   check=True, capture_output=True)
    return files


@pytest.fixture
def tablet(hosts, tmp_path) -> Iterator[Browser]:
    """Yield a browser on the other host."""
    if lab.CHROMIUM is None:
        missing.skip('there is no Chromium on the PATH: apt-get install chromium-headless-shell')
    robot, laptop = hosts
    start = tmp_path / 'chromium'
    start.write_text(f'#!/bin/sh\nexec ip netns exec {laptop.name} {lab.CHROMIUM} "$@"\n')
    start.chmod(0o755)
    with lab.chromium(start, robot.address) as browser:
        yield browser


def ask(host: Host, *words: str | Path) -> str:
    return host.run(sys.executable, '-c', ASK, *words)


def test_no_other_host_reaches_the_page_unless_its_user_says_so(hosts, page):
    robot, laptop = hosts
    address, said = page()
    assert said == 'Only programs on this machine can reach it. Ctrl+C ends it.\n'
    assert ask(robot, address) == address
    assert 'Connection refused' in ask(laptop, address.replace('127.0.0.1', robot.address))


def test_a_page_on_the_network_wants_its_token(hosts, page):
    robot, laptop = hosts
    address, said = page('--host', robot.address)
    assert 'Anyone on the network who has this address with its token can reach it' in said and '--certfile' in said
    assert ask(laptop, address) == address
    root = address.partition('?')[0]
    for wrong in (root, f'{root}?token=wrong'):
        assert '/login' in ask(laptop, wrong)


def test_with_a_certificate_the_page_is_encrypted(hosts, page, certificate):
    robot, laptop = hosts
    address, said = page('--host', robot.address, '--certfile', certificate[0], '--keyfile', certificate[1])
    assert address.startswith('https://') and '--certfile' not in said
    assert ask(laptop, address, certificate[0]) == address
    assert 'CERTIFICATE_VERIFY_FAILED' in ask(laptop, address)
    assert '/login' in ask(laptop, address.partition('?')[0], certificate[0])
    assert address not in ask(laptop, address.replace('https', 'http'))


def test_a_tablet_sees_where_the_nodes_are_and_sets_them(hosts, page, tablet, certificate):
    robot, laptop = hosts
    start_node(robot, 'arm')
    start_node(laptop, 'lift')
    address, _ = page('--host', robot.address, '--certfile', certificate[0], '--keyfile', certificate[1])
    shown = tablet.new_page(ignore_https_errors=True)
    shown.goto(address, timeout=120_000)
    expect(shown.locator('.param-where')).to_have_text('ROS domain 42, looks for nodes on this machine and its subnet.')
    lines = shown.locator('.node-line')
    expect(lines.filter(has_text='/arm')).to_contain_text('3 parameters, on this machine')
    expect(lines.filter(has_text='/lift')).to_contain_text(
        re.compile(r'3 parameters, on another machine \([0-9a-f]{4}\)'))
    shown.get_by_role('button', name='/lift', exact=True).click()
    expect(shown.locator('.param-status').last).to_contain_text('on another machine')
    box = shown.get_by_label('speed', exact=True)
    box.fill('2.5')
    box.press('Enter')
    lab.wait_for(lambda: robot.run(sys.executable, '-m', 'param_tools', 'param', 'get', '/lift', 'speed', **DOMAIN)
                 == 'Double value is: 2.5', 'the node to have it')


def test_a_node_that_was_not_looked_for_is_told_to_be_elsewhere(hosts, page, tablet):
    robot, laptop = hosts
    start_node(robot, 'arm')
    address, _ = page('--host', robot.address, ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
    shown = tablet.new_page()
    shown.goto(address, timeout=120_000)
    expect(shown.locator('.param-where')).to_have_text('ROS domain 42, looks for nodes on this machine only.')
    start_node(laptop, 'lift', ROS_STATIC_PEERS=robot.address)
    lines = shown.locator('.node-line')
    expect(lines.filter(has_text='/lift')).to_contain_text('3 parameters, on another machine')
    expect(lines.filter(has_text='/arm')).to_have_text('/arm3 parameters')


def test_nothing_can_be_set_from_a_page_that_is_read_only(hosts, page, tablet):
    robot, _ = hosts
    start_node(robot, 'arm')
    address, _ = page('/arm', '--host', robot.address, '--read-only')
    shown = tablet.new_page()
    shown.goto(address, timeout=120_000)
    expect(shown.locator('.param-where')).to_contain_text('Read-only: nothing can be set from this page.')
    expect(shown.locator('.param-status')).to_contain_text('read-only')
    expect(shown.get_by_role('button', name='Save…')).to_be_hidden()
    box = shown.get_by_label('speed', exact=True)
    expect(box).to_be_disabled()
    # Someone who knows how to change a page.
    box.evaluate('box => { box.disabled = false }')
    box.fill('2.5')
    box.press('Enter')
    expect(shown.locator('.param-message').first).to_have_text('nothing was set at /arm: this panel is read-only')
    expect(box).to_have_value('1.5')
    get = (sys.executable, '-m', 'param_tools', 'param', 'get', '/arm', 'speed')
    assert robot.run(*get, **DOMAIN) == 'Double value is: 1.5'
