"""A real JupyterHub for a class, as `make hub` starts it: two learners at once.

Once as a teacher starts it, as root, with the sign-in by PAM and a server under each learner's own account; and once as
far as it goes without root's rights.
"""

import contextlib
import http.cookiejar
import json
import os
import random
import shutil
import socket
import subprocess
import sys
import tempfile
import urllib.error
import urllib.parse
import urllib.request
import uuid
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import psutil
import pytest
import websocket

from tests.support import accounts, missing
from tests.support.lab import TIMEOUT_SEC, wait_for
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(500)]

# /proc/sys/net/ipv4/ip_local_port_range begins here. JupyterHub takes its ports seconds after they were chosen, and
# meanwhile hundreds of sockets of other tests are given one.
FIRST_EPHEMERAL_PORT = 32_768
SCRIPTS = ROOT / 'environment' / 'jupyterhub'
NAMES = ('ada', 'grace')
PASSWORD = 'long-enough-a-secret'
# As in /etc/shadow: `openssl passwd -6 -salt salt`.
PASSWORD_HASH = '$6$salt$qTgY4srfAhPuEJIpdXf0BcwCLzUvvKn430S/M7qXRfhDx4bqG7g1r/y78K2tXUM.l8qvH9imOGHGADy0hV8BU/'
CHAPTER = '01_what_are_parameters.ipynb'
# The course's settings, on ports and in a folder of the test's.
SETTINGS = '''
load_subconfig({course!r})
c.JupyterHub.bind_url = 'http://127.0.0.1:{port}'
c.JupyterHub.hub_port = {hub_port}
c.ConfigurableHTTPProxy.api_url = 'http://127.0.0.1:{api_port}'
c.JupyterHub.db_url = 'sqlite:///{folder}/jupyterhub.sqlite'
c.JupyterHub.cookie_secret_file = '{folder}/cookie_secret'
c.ConfigurableHTTPProxy.pid_file = '{folder}/proxy.pid'
'''
# With any password, and without accounts of the machine's.
WITHOUT_ROOT = '''
c.JupyterHub.authenticator_class = 'shared-password'
c.SharedPasswordAuthenticator.user_password = {password!r}
c.Authenticator.allow_all = True
c.JupyterHub.spawner_class = 'simple'
c.SimpleLocalProcessSpawner.home_dir_template = '{homes}/{{username}}'
'''


def free_ports(count: int) -> list[int]:
    """Return ports that are free now, and that Linux gives to nobody who leaves the choice to it."""
    with contextlib.ExitStack() as stack:
        ports: list[int] = []
        while len(ports) < count:
            port = random.randrange(10_000, FIRST_EPHEMERAL_PORT)
            with contextlib.suppress(OSError):  # it is in use
                stack.enter_context(socket.create_server(('127.0.0.1', port)))
                ports.append(port)
        return ports


@pytest.fixture(scope='module')
def homes() -> Iterator[Path]:
    """Yield a folder that everybody may enter; pytest's own are for one user."""
    homes = Path(tempfile.mkdtemp(prefix='param_tutorial_'))
    homes.chmod(0o755)
    yield homes
    # The servers and kernels that JupyterHub leaves behind end by themselves, a moment after it.
    wait_for(lambda: not [each for each in psutil.process_iter(['cwd'])
                          if each.info['cwd'] and Path(each.info['cwd']).is_relative_to(homes)], 'an empty class')
    shutil.rmtree(homes)


@pytest.fixture(scope='module', params=['accounts of the machine', 'without root'])
def hub(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, homes: Path) -> Iterator[str]:
    """Start JupyterHub; yield its address."""
    folder = tmp_path_factory.mktemp('hub')
    port, hub_port, api_port = free_ports(3)
    settings = SETTINGS.format(course=str(SCRIPTS / 'jupyterhub_config.py'), folder=folder, port=port,
                               hub_port=hub_port, api_port=api_port)
    config = folder / 'config.py'
    words: list[str | Path] = [sys.executable, SCRIPTS / 'hub.py', '--config', config]
    if request.param == 'without root':
        settings += WITHOUT_ROOT.format(password=PASSWORD, homes=homes / 'of_one_account')
    elif why := accounts.why_none():
        missing.skip(f'no accounts can be made: {why}')
    else:
        words = accounts.command(words, folder, homes, NAMES, PASSWORD_HASH, needed=[ROOT, Path(sys.base_prefix)])
    config.write_text(settings)
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(('JUPYTER', 'ROS_', 'FASTRTPS_', 'PYTEST', 'IPYTHON'))}
    log = folder / 'hub.log'
    with log.open('w') as output:
        process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT)
    address = f'http://127.0.0.1:{port}'

    def answers() -> bool:
        if process.poll() is not None:
            said = log.read_text()
            if 'the set-up needs the network' in said and not os.environ.get('CI'):
                pytest.skip(f'JupyterHub is not in the course, and could not be fetched:\n{said}')
            pytest.fail(said)
        with contextlib.suppress(OSError), urllib.request.urlopen(f'{address}/hub/login', timeout=5):
            return True
        return False

    try:
        wait_for(answers, 'JupyterHub')
        yield address
    finally:
        process.terminate()
        print(log.read_text())  # which pytest shows when a test fails
        wait_or_kill(process, 60)


class Learner:
    """A user who signs in with a browser and runs a notebook."""

    def __init__(self, hub: str, name: str):
        self.hub, self.name, self.server = hub, name, f'{hub}/user/{name}'
        self._cookies = http.cookiejar.CookieJar()
        self._opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(self._cookies))
        self._token = ''
        self._kernel: websocket.WebSocket | None = None

    def sign_in(self) -> None:
        """Fill in the form, and wait for JupyterLab."""
        with self._opener.open(f'{self.hub}/hub/login', timeout=TIMEOUT_SEC):
            pass
        entries = {'username': self.name, 'password': PASSWORD, '_xsrf': self._xsrf()}
        with self._opener.open(f'{self.hub}/hub/login', urllib.parse.urlencode(entries).encode(), timeout=TIMEOUT_SEC):
            pass
        headers = {'Content-Type': 'application/json', 'X-XSRFToken': self._xsrf(),
                   'Referer': f'{self.hub}/hub/home'}
        request = urllib.request.Request(f'{self.hub}/hub/api/users/{self.name}/tokens', b'{}', headers)
        with self._opener.open(request, timeout=TIMEOUT_SEC) as answer:
            self._token = json.load(answer)['token']
        with self._opener.open(f'{self.hub}/hub/spawn/{self.name}', timeout=TIMEOUT_SEC):
            pass
        wait_for(lambda: self.status('/api/status') == 200, f'the server of {self.name}')

    def _xsrf(self) -> str:
        return next(cookie.value for cookie in self._cookies if cookie.name == '_xsrf' and cookie.path == '/hub/')

    def _request(self, path: str, method: str = 'GET', data: bytes | None = None,
                 server: str = '') -> urllib.request.Request:
        headers = {'Content-Type': 'application/json', 'Authorization': f'token {self._token}'}
        return urllib.request.Request((server or self.server) + path, data, headers, method=method)

    def status(self, path: str, server: str = '') -> int:
        """Return the HTTP status of a page of this learner's server, or of another one."""
        try:
            with urllib.request.urlopen(self._request(path, server=server), timeout=TIMEOUT_SEC) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code

    def get(self, path: str) -> dict:
        """Return what the server answers."""
        with urllib.request.urlopen(self._request(path), timeout=TIMEOUT_SEC) as answer:
            return json.load(answer)

    def start_kernel(self) -> None:
        """Start a kernel and listen to it."""
        with urllib.request.urlopen(self._request('/api/kernels', 'POST', b'{}'), timeout=TIMEOUT_SEC) as answer:
            kernel = json.load(answer)['id']
        self._kernel = websocket.create_connection(
            f'{self.server.replace("http", "ws")}/api/kernels/{kernel}/channels', timeout=TIMEOUT_SEC,
            header=[f'Authorization: token {self._token}'])
        self.run('import os')

    def run(self, source: str) -> str:
        """Run a cell; return its value as text.

        :raises RuntimeError: it raised something.
        """
        number = uuid.uuid4().hex
        self._kernel.send(json.dumps({
            'channel': 'shell', 'parent_header': {}, 'metadata': {},
            'header': {'msg_id': number, 'msg_type': 'execute_request', 'session': number, 'username': self.name,
                       'version': '5.3'},
            'content': {'code': source, 'silent': False, 'allow_stdin': False, 'stop_on_error': False}}))
        value = ''
        while True:
            message = json.loads(self._kernel.recv())
            if message['parent_header'].get('msg_id') != number:
                continue
            content = message['content']
            if message['msg_type'] == 'execute_result':
                value = content['data']['text/plain']
            elif message['msg_type'] == 'error':
                raise RuntimeError(f'{content["ename"]}: {content["evalue"]}\n{source}')
            elif message['msg_type'] == 'status' and content['execution_state'] == 'idle':
                return value

    def run_chapter(self) -> None:
        """Run all cells of this learner's copy of the chapter."""
        for cell in self.get(f'/api/contents/{CHAPTER}')['content']['cells']:
            if cell['cell_type'] == 'code':
                expected = 'raises-exception' in cell['metadata'].get('tags', [])
                with contextlib.suppress(*[RuntimeError] if expected else []):
                    self.run(cell['source'])

    def close(self) -> None:
        if self._kernel:
            self._kernel.close()


@pytest.fixture(scope='module')
def learners(hub: str) -> Iterator[list[Learner]]:
    """Sign in two learners, and run the chapter as both at once."""
    both = [Learner(hub, name) for name in NAMES]

    def learn(learner: Learner) -> None:
        learner.sign_in()
        learner.start_kernel()
        learner.run_chapter()

    with ThreadPoolExecutor() as pool:
        list(pool.map(learn, both))
    yield both
    for learner in both:
        learner.close()


def test_each_has_copies_of_their_own(learners):
    for learner in learners:
        names = {each['name'] for each in learner.get('/api/contents')['content']}
        assert {'index.md', CHAPTER} <= names
        folder = Path(learner.run('os.getcwd()').strip("'"))
        assert folder.parts[-2:] == (learner.name, 'my_lessons')
        # The test has made the account's home folder, or has only one account.
        assert int(learner.run('os.getuid()')) == folder.parent.stat().st_uid
    assert not (ROOT / 'environment' / 'jupyterhub' / 'my_lessons').exists()


def test_neither_touches_the_others_node(learners):
    ada, grace = learners
    nodes = [learner.run('sorted(node.get_fully_qualified_name() for node in ros.nodes)') for learner in learners]
    assert nodes[0] == nodes[1] != '[]'
    for learner in learners:
        learner.run('%ros2 param set /clawbot_node max_acceleration_mps2 1.1')
    ada.run('%ros2 param set /clawbot_node max_acceleration_mps2 1.7')
    assert ada.run("robot.get_parameter('max_acceleration_mps2').value") == '1.7'
    assert grace.run("robot.get_parameter('max_acceleration_mps2').value") == '1.1'
    assert ada.run("os.environ['ROS_DOMAIN_ID']") != grace.run("os.environ['ROS_DOMAIN_ID']")


def test_nobody_opens_the_others_server(learners):
    ada, grace = learners
    assert ada.status('/api/contents', grace.server) == 403
    assert grace.status('/api/contents', ada.server) == 403


def test_what_is_solved_is_kept_at_home(learners):
    for learner in learners:
        path = Path(learner.run("os.environ['PARAM_TUTORIAL_PROGRESS']").strip("'"))
        assert path.parts[-3:] == (learner.name, 'my_lessons', 'progress.json')
