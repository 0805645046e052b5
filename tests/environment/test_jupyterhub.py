"""A real JupyterHub for a class, as `make hub` starts it: two learners at once, who sign in with one password."""

import contextlib
import http.cookiejar
import json
import os
import random
import shutil
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

from tests.support import missing
from tests.support.lab import TIMEOUT_SEC, wait_for
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(500)]

PYTHON = ROOT / 'build' / 'jupyterhub' / 'bin' / 'python'
SCRIPTS = ROOT / 'environment' / 'jupyterhub'
NAMES = ('ada', 'grace')
PASSWORD = 'long-enough-a-secret'
CHAPTER = '01_what_are_parameters.ipynb'
# The course's settings, on ports and in a folder of the test's, and without accounts of the machine's.
SETTINGS = '''
load_subconfig({course!r})
c.JupyterHub.bind_url = 'http://127.0.0.1:{ports[0]}'
c.JupyterHub.hub_port = {ports[1]}
c.ConfigurableHTTPProxy.api_url = 'http://127.0.0.1:{ports[2]}'
c.JupyterHub.db_url = 'sqlite:///{folder}/jupyterhub.sqlite'
c.JupyterHub.cookie_secret_file = '{folder}/cookie_secret'
c.ConfigurableHTTPProxy.pid_file = '{folder}/proxy.pid'
c.JupyterHub.authenticator_class = 'shared-password'
c.SharedPasswordAuthenticator.user_password = {password!r}
c.Authenticator.allow_all = True
c.JupyterHub.spawner_class = 'simple'
c.SimpleLocalProcessSpawner.home_dir_template = '{folder}/{{username}}'
'''


@pytest.fixture(scope='module', autouse=True)
def environment() -> None:
    """Make what `make hub` makes first."""
    done = subprocess.run([sys.executable, ROOT / 'environment' / 'set_up.py', 'build/jupyterhub', 'requirements.lock',
                           'requirements-hub.lock'], stderr=subprocess.PIPE, text=True)
    if done.returncode:
        missing.skip(f'JupyterHub could not be fetched: {done.stderr}')


@pytest.fixture(scope='module')
def folder() -> Iterator[Path]:
    folder = Path(tempfile.mkdtemp(prefix='param_tutorial_'))
    yield folder
    # The servers and kernels that JupyterHub leaves behind end by themselves, a moment after it.
    wait_for(lambda: not [each for each in psutil.process_iter(['cwd'])
                          if each.info['cwd'] and Path(each.info['cwd']).is_relative_to(folder)], 'an empty class')
    shutil.rmtree(folder)


@pytest.fixture(scope='module')
def hub(folder: Path) -> Iterator[str]:
    """Start JupyterHub; yield its address."""
    # Below the ports that Linux chooses itself, as for the sockets of the other tests.
    ports = random.sample(range(10_000, 32_768), 3)
    config = folder / 'config.py'
    config.write_text(SETTINGS.format(course=str(SCRIPTS / 'jupyterhub_config.py'), folder=folder, ports=ports,
                                      password=PASSWORD))
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(('JUPYTER', 'ROS_', 'FASTRTPS_', 'PYTEST', 'IPYTHON'))}
    log = folder / 'hub.log'
    with log.open('w') as output:
        process = subprocess.Popen([PYTHON, SCRIPTS / 'hub.py', '--config', config], cwd=ROOT, env=environment,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
    address = f'http://127.0.0.1:{ports[0]}'

    def answers() -> bool:
        assert process.poll() is None, log.read_text()
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
        self._open('/hub/login')
        entries = {'username': name, 'password': PASSWORD, '_xsrf': self._xsrf()}
        self._open('/hub/login', urllib.parse.urlencode(entries).encode())
        self._token = json.loads(self._open(f'/hub/api/users/{name}/tokens', b'{}', 'application/json'))['token']
        self._open(f'/hub/spawn/{name}')
        wait_for(lambda: self.status(f'{self.server}/api/status') == 200, f'the server of {name}')
        kernel = self.ask(f'{self.server}/api/kernels', b'{}')['id']
        self.kernel = websocket.create_connection(
            f'{self.server.replace("http", "ws")}/api/kernels/{kernel}/channels', timeout=TIMEOUT_SEC,
            header=[f'Authorization: token {self._token}'])
        self.run('import os')

    def _open(self, path: str, data: bytes | None = None, kind: str = 'application/x-www-form-urlencoded') -> bytes:
        """Ask for a page as the browser does."""
        headers = {'X-XSRFToken': self._xsrf(), 'Referer': f'{self.hub}/hub/home', 'Content-Type': kind}
        request = urllib.request.Request(self.hub + path, data, headers)
        with self._opener.open(request, timeout=TIMEOUT_SEC) as answer:
            return answer.read()

    def _xsrf(self) -> str:
        return next((cookie.value for cookie in self._cookies if cookie.name == '_xsrf' and cookie.path == '/hub/'), '')

    def ask(self, url: str, data: bytes | None = None) -> dict:
        """Ask this learner's server, or another's, with this learner's token."""
        request = urllib.request.Request(url, data, {'Authorization': f'token {self._token}'})
        with urllib.request.urlopen(request, timeout=TIMEOUT_SEC) as answer:
            return json.load(answer)

    def status(self, url: str) -> int:
        """Return the HTTP status of the answer."""
        try:
            self.ask(url)
        except urllib.error.HTTPError as error:
            return error.code
        return 200

    def run(self, source: str) -> str:
        """Run a cell; return its value as text.

        :raises RuntimeError: it raised something.
        """
        number = uuid.uuid4().hex
        self.kernel.send(json.dumps({
            'channel': 'shell', 'parent_header': {}, 'metadata': {},
            'header': {'msg_id': number, 'msg_type': 'execute_request', 'session': number, 'username': self.name,
                       'version': '5.3'},
            'content': {'code': source, 'silent': False, 'allow_stdin': False, 'stop_on_error': False}}))
        value = ''
        while True:
            message = json.loads(self.kernel.recv())
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
        for cell in self.ask(f'{self.server}/api/contents/{CHAPTER}')['content']['cells']:
            if cell['cell_type'] == 'code':
                expected = 'raises-exception' in cell['metadata'].get('tags', [])
                with contextlib.suppress(*[RuntimeError] if expected else []):
                    self.run(cell['source'])


@pytest.fixture(scope='module')
def learners(hub: str) -> Iterator[list[Learner]]:
    """Sign in two learners, and run the chapter as both at once."""
    with ThreadPoolExecutor() as pool:
        both = list(pool.map(lambda name: Learner(hub, name), NAMES))
        list(pool.map(Learner.run_chapter, both))
    yield both
    for learner in both:
        learner.kernel.close()


def test_each_has_copies_and_progress_of_their_own(learners, folder):
    for learner in learners:
        home = folder / learner.name / 'my_lessons'
        assert learner.run('os.getcwd()') == repr(str(home))
        assert learner.run("os.environ['PARAM_TUTORIAL_PROGRESS']") == repr(str(home / 'progress.json'))
    assert not (SCRIPTS / 'my_lessons').exists()


def test_neither_touches_the_others_node(learners):
    ada, grace = learners
    for learner in learners:
        learner.run('%ros2 param set /clawbot_node max_acceleration_mps2 1.1')
    ada.run('%ros2 param set /clawbot_node max_acceleration_mps2 1.7')
    assert ada.run("robot.get_parameter('max_acceleration_mps2').value") == '1.7'
    assert grace.run("robot.get_parameter('max_acceleration_mps2').value") == '1.1'
    assert ada.run("os.environ['ROS_DOMAIN_ID']") != grace.run("os.environ['ROS_DOMAIN_ID']")


def test_nobody_opens_the_others_server(learners):
    ada, grace = learners
    assert ada.status(f'{grace.server}/api/contents') == 403
    assert grace.status(f'{ada.server}/api/contents') == 403


def test_a_course_that_other_accounts_cannot_read_is_named_before_jupyterhub_starts(tmp_path):
    """The folders that pytest makes are closed to others."""
    if os.geteuid() != 0:
        missing.skip('only root starts JupyterHub for others')
    (tmp_path / 'environment').mkdir()
    scripts = shutil.copytree(SCRIPTS, tmp_path / 'environment' / 'jupyterhub')
    done = subprocess.run([PYTHON, scripts / 'hub.py'], capture_output=True, text=True)
    assert done.returncode == 1
    assert f'must be able to read all of {tmp_path}' in done.stderr and 'PYTHON=/usr/bin/python3' in done.stderr
