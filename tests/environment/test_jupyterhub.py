"""A real JupyterHub for a class, as `make hub` starts it: a learner signs in and has copies of the chapters at home."""

import contextlib
import http.cookiejar
import os
import random
import subprocess
import sys
import urllib.parse
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from tests.support import missing
from tests.support.lab import TIMEOUT_SEC, wait_for
from tests.support.paths import ROOT
from tests.support.processes import wait_or_kill

pytestmark = [pytest.mark.rare, pytest.mark.timeout(500)]

PASSWORD = 'long-enough-a-secret'
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


@pytest.fixture
def hub(tmp_path: Path) -> Iterator[str]:
    """Start JupyterHub; yield its address."""
    folder = 'build/jupyterhub'
    made = subprocess.run([sys.executable, ROOT / 'environment' / 'set_up.py', folder, 'requirements.lock',
                           'requirements-hub.lock'], stderr=subprocess.PIPE, text=True)
    if made.returncode:
        missing.skip(f'JupyterHub could not be fetched: {made.stderr}')
    # Below the ports that Linux chooses itself, as for the sockets of the other tests.
    ports = random.sample(range(10_000, 32_768), 3)
    config, log = tmp_path / 'config.py', tmp_path / 'hub.log'
    course = ROOT / 'environment' / 'jupyterhub' / 'jupyterhub_config.py'
    config.write_text(SETTINGS.format(course=str(course), folder=tmp_path, ports=ports, password=PASSWORD))
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(('JUPYTER', 'ROS_', 'FASTRTPS_', 'PYTEST', 'IPYTHON'))}
    with log.open('w') as output:
        process = subprocess.Popen([ROOT / folder / 'bin' / 'python', '-m', 'jupyterhub', '--config', config], cwd=ROOT,
                                   env=environment, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
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
    # The server that JupyterHub leaves behind ends by itself, a moment after it.
    wait_for(lambda: not [each for each in psutil.process_iter(['cwd'])
                          if each.info['cwd'] and Path(each.info['cwd']).is_relative_to(tmp_path)], 'an empty class')


def test_a_learner_signs_in_and_has_the_chapters_at_home(hub, tmp_path):
    cookies = http.cookiejar.CookieJar()
    opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(cookies))

    def open_page(path: str, **form: str) -> None:
        """Open a page, or send a form, as the browser does, which sends the cookie against forged requests back."""
        xsrf = next((cookie.value for cookie in cookies if cookie.name == '_xsrf' and cookie.path == '/hub/'), '')
        data = urllib.parse.urlencode({**form, '_xsrf': xsrf}).encode() if form else None
        opener.open(urllib.request.Request(hub + path, data, {'Referer': f'{hub}/hub/home'}), timeout=TIMEOUT_SEC)

    open_page('/hub/login')
    open_page('/hub/login', username='ada', password=PASSWORD)
    open_page('/hub/spawn/ada')
    wait_for((tmp_path / 'ada' / 'my_lessons' / '01_what_are_parameters.ipynb').exists, "the learner's copies")
