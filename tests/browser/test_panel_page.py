"""`python -m param_tutorial panel`: the panel as a page, served to this machine by a process that Ctrl+C ends."""

import os
import re
import signal
import subprocess
import sys
import textwrap
import urllib.error
import urllib.request

import psutil
import pytest
from playwright.sync_api import expect

from param_tools.ros import domain
from tests.support.lab import wait_for
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

NODE = '''
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.node import Node
    rclpy.init()
    node = Node('arm')
    node.declare_parameter('speed', 1.5)
    print('ready', flush=True)
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        node.destroy_node()
'''


@pytest.fixture
def environment(tmp_path):
    """Return the environment of a shell in a domain that only this test uses."""
    domain.choose()
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(('JUPYTER', 'PYTEST'))}
    return {**inherited, 'HOME': str(tmp_path), 'PYTHONUNBUFFERED': '1'}


@pytest.fixture
def arm(environment):
    """Run a node in its own process."""
    with subprocess.Popen([sys.executable, '-c', textwrap.dedent(NODE)], env=environment, stdout=subprocess.PIPE,
                          text=True) as process:
        assert process.stdout.readline() == 'ready\n'
        yield process
        # Asked politely, it takes leave: killed, it would stand in the graph of this worker's next tests for 8 s.
        process.terminate()
        wait_or_kill(process)  # once, of some hundred times, rclpy's own spin has not heard of it


@pytest.fixture
def page_process(environment, tmp_path):
    """Return a function that starts the command in a folder, and returns the process and the address of the page."""
    started = []

    def start(*arguments):
        process = subprocess.Popen(
            [sys.executable, '-m', 'param_tutorial', 'panel', '--no-browser', *arguments], cwd=tmp_path,
            env={**environment, 'TMPDIR': str(tmp_path)}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        started.append(process)
        line = process.stdout.readline()
        address = re.fullmatch(r'The panel is at (http://127\.0\.0\.1:\d+/\?token=\S{32})\n', line)
        assert address, line + process.stdout.read()
        return process, address[1]

    yield start
    for process in started:
        process.kill()
        process.wait()
        process.stdout.close()


def test_the_page_shows_and_changes_a_node_and_ends_with_its_kernel(browser, arm, page_process, environment, tmp_path):
    process, address = page_process()  # it opens the only node at once
    page = browser.new_page()
    elsewhere = []
    page.on('request', lambda request: request.url.startswith((address.partition('?')[0], 'data:', 'blob:'))
            or elsewhere.append(request.url))
    page.goto(address, timeout=120_000)
    box = page.get_by_label('speed', exact=True)
    expect(box).to_have_value('1.5')
    box.fill('2.5')
    box.press('Enter')
    # The other way round, from another process.
    asked = [sys.executable, '-m', 'param_tutorial', 'param']
    get = [*asked, 'get', '/arm', 'speed']
    wait_for(lambda: subprocess.run(get, env=environment, capture_output=True, text=True).stdout
             == 'Double value is: 2.5\n', 'the node to have it')
    subprocess.run([*asked, 'set', '/arm', 'speed', '0.5'], env=environment, check=True, capture_output=True)
    expect(box).to_have_value('0.5')
    assert elsewhere == []
    me = psutil.Process(process.pid)
    family = [me, *me.children(recursive=True)]
    assert len(family) > 1, 'there is a kernel'
    # A second page has a kernel of its own, which ends when the page is left.
    other = browser.new_page()
    other.goto(address, timeout=120_000)
    expect(other.get_by_label('speed', exact=True)).to_have_value('0.5')
    assert len(me.children()) == 2
    other.goto('about:blank')
    wait_for(lambda: len(me.children()) == 1, 'the kernel of the page to end')
    other.close()
    ports = [each.laddr for one in family for each in one.net_connections('inet') if each.status == psutil.CONN_LISTEN]
    assert {ip for ip, _ in ports} == {'127.0.0.1'}
    process.send_signal(signal.SIGINT)
    assert process.wait() == 0
    wait_for(lambda: not any(each.is_running() for each in family), 'its kernel to end')
    assert process.stdout.read() == 'Only programs on this machine can reach it. Ctrl+C ends it.\n'
    assert list(tmp_path.glob('param_tools_panel_*')) == []
    page.close()


def test_the_page_rejects_requests_without_the_token(page_process):
    process, address = page_process()
    root = address.partition('?')[0]
    assert '/login' in urllib.request.urlopen(root, timeout=20).url
    for path in ('?token=wrong', 'api/kernels/01234567-0123-0123-0123-0123456789ab'):
        try:
            assert '/login' in urllib.request.urlopen(root + path, timeout=20).url
        except urllib.error.HTTPError as error:
            assert error.code == 403
    children = psutil.Process(process.pid).children()
    assert children == [], 'a kernel was started for somebody without the token'
    # The command line is in the list of processes, which everybody can read.
    assert address.partition('token=')[2] not in ' '.join(psutil.Process(process.pid).cmdline())
    process.send_signal(signal.SIGTERM)
    assert process.wait() == 0
