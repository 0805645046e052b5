"""What `make lab` starts: the real JupyterLab, and a real terminal in it, without a browser."""

import json
import os
import re
import subprocess
import sys
import urllib.request
from collections.abc import Iterator

import pytest
import websocket

from tests.support.lab import TIMEOUT_SEC, CourseLab
from tests.support.paths import NOTEBOOKS, ROOT

pytestmark = pytest.mark.timeout(300)

TERMINAL = ROOT / 'environment' / 'jupyter' / 'terminal.bash'
# What a learner's own start-up files may do, and Debian's /etc/profile does.
START_UP = '''
PATH=/usr/local/bin:/usr/bin:/bin
alias python=false pip=false
python3() { false; }
'''


@pytest.fixture(scope='module')
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[CourseLab]:
    home = tmp_path_factory.mktemp('home')
    for name in ('.bashrc', '.profile', '.bash_profile', '.zshrc'):
        (home / name).write_text(START_UP)
    lab = CourseLab(tmp_path_factory.mktemp('lab') / 'a lab', [NOTEBOOKS / '01_what_are_parameters.ipynb'])
    lab.environment |= {'HOME': str(home), 'MAKEFLAGS': ' -- ARGS=--no-browser', 'ARGS': '--no-browser'}
    # What a crash has left behind, and another process has its number now.
    lab.runtime.mkdir()
    (lab.runtime / f'jpserver-{os.getpid()}.json').write_text(json.dumps(
        {'pid': os.getpid(), 'url': 'http://localhost:9/', 'token': ''}))
    with lab:
        yield lab


class Terminal:
    """A terminal of JupyterLab, over its WebSocket."""

    def __init__(self, lab: CourseLab):
        request = urllib.request.Request(f'{lab.url}api/terminals?token={lab.token}', method='POST', data=b'{}')
        with urllib.request.urlopen(request, timeout=TIMEOUT_SEC) as answer:
            name = json.load(answer)['name']
        self._socket = websocket.create_connection(
            f'{lab.url.replace("http", "ws")}terminals/websocket/{name}?token={lab.token}', timeout=TIMEOUT_SEC)

    def close(self) -> None:
        self._socket.close()

    def run(self, line: str) -> str:
        """Type a line; return what it prints."""
        # The line itself is echoed, so it must not hold the marks as they are printed.
        self._socket.send(json.dumps(['stdin', f"echo '<''<<'; {line}; echo '>''>>'\r"]))
        text = ''
        while not (found := re.search('<<<\r?\n(.*?)>>>', text, re.DOTALL)):
            kind, *content = json.loads(self._socket.recv())
            text += content[0] if kind == 'stdout' else ''
        return found[1].replace('\r', '').strip()


@pytest.fixture
def terminal(lab: CourseLab) -> Iterator[Terminal]:
    terminal = Terminal(lab)
    yield terminal
    terminal.close()


def test_a_terminal_has_the_courses_python_and_the_learners_own_settings(terminal, lab):
    assert terminal.run("python3 -c 'import sys; print(sys.prefix)'") == sys.prefix
    assert ':/usr/local/bin:/usr/bin:/bin:' in terminal.run('echo $PATH')
    # And none of the `make` that has started JupyterLab.
    assert terminal.run('pwd; echo "[$MAKEFLAGS$ARGS]"') == f'{lab.copies}\n[]'


def test_where_nothing_that_is_built_could_be_started_colcon_says_so():
    programs = '/home/learner/my course/.venv/bin'
    done = subprocess.run(
        ['bash', '--rcfile', TERMINAL, '-i', '-c', 'colcon --help'], capture_output=True, text=True,
        env={'PATH': os.environ['PATH'], 'HOME': '/nowhere', 'PARAM_TUTORIAL_PROGRAMS': programs})
    assert done.returncode == 1
    assert f"a space in it: {programs}. Move the course's folder" in done.stderr


@pytest.fixture
def node(lab):
    """Start a node in a kernel, and yield its name."""
    request = urllib.request.Request(f'{lab.url}api/kernels?token={lab.token}', method='POST', data=b'{}')
    urllib.request.urlopen(request, timeout=TIMEOUT_SEC).close()
    lab.ask_kernel("__import__('param_tutorial').start().add(__import__('rclpy').node.Node, 'of_a_notebook')")
    yield '/of_a_notebook'
    lab.end_kernels()


def test_ros2_in_a_terminal_is_the_courses_in_the_domain_of_the_newest_kernel_and_says_so_once(terminal, lab, node):
    domain = lab.ask_kernel("__import__('os').environ['ROS_DOMAIN_ID']").strip("'")
    first, second = (terminal.run('ros2 node list') for _ in range(2))
    assert first == (f"This is the course's own ros2, in the ROS domain of the notebook started last ({domain}). "
                     f"A notebook's %ros2_terminal shows a line to join another one's.\n{node}")
    assert second == node


def test_ros2_after_an_exclamation_mark_finds_the_kernels_own_nodes(lab, node):
    assert lab.ask_kernel("get_ipython().getoutput('ros2 node list').n") == repr(node)


def test_a_genuine_ros2_on_the_path_stays_the_one(terminal, tmp_path):
    genuine = tmp_path / 'ros2'
    genuine.write_text('#!/bin/sh\necho genuine')
    genuine.chmod(0o755)
    assert terminal.run(f'export PATH="{tmp_path}:$PATH"; ros2 node list') == 'genuine'


def test_make_lab_prints_four_lines(lab):
    copies, start, address, stop = lab.log().splitlines()
    assert copies.startswith('Your own copies of the chapters are in my_lessons/.')
    assert start == "JupyterLab is running; open this address if your browser doesn't:"
    # Jupyter Server keeps a token to itself that it was given.
    assert address == f'    {lab.url.replace("localhost", "127.0.0.1")}lab/tree/index.md?token=...'
    assert stop == 'Press Ctrl+C here twice to stop it.'


def test_a_second_make_lab_says_where_the_first_one_is(lab):
    assert lab.start_again() == (
        f'JupyterLab is running already; open this address in your browser:\n'
        f'    {lab.url}lab/tree/index.md?token={lab.token}\n')


def test_a_folder_that_cannot_be_made_is_one_sentence_and_no_server(tmp_path):
    lab = CourseLab(tmp_path / 'lab', [])
    lab.copies.write_text('in the way')
    with pytest.raises(RuntimeError) as error, lab:
        pass
    assert re.search(r'status 1:\nYour copies of the chapters in .*/my_lessons could not be .*\.\n$', str(error.value))
