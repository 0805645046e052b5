"""What `make release` makes: a wheel that needs no checkout, a list of licenses, and an SBOM."""

import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import urllib.request
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import param_tools
from tests.support.paths import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(400)]

VERSION = param_tools.__version__
LOCKED = re.findall(r'^([\w.-]+)==', (ROOT / 'environment' / 'requirements.lock').read_text(), re.MULTILINE)
USE = '''
import os
import param_tutorial
from param_tutorial.nodes.simple_param_node import SimpleParamNode
node = param_tutorial.start().add(SimpleParamNode)
param_tutorial.ParameterClient('/simple_param_node').set_parameter('max_speed_rpm', 120)
panel = param_tutorial.ParameterPanel('/simple_param_node')
panel['max_speed_rpm'].value = 130
panel.settle()
print(os.path.dirname(param_tutorial.__file__))
print(node.get_parameter('max_speed_rpm').value)
'''


@pytest.fixture(scope='module')
def released() -> Path:
    """Make a release; return its folder."""
    subprocess.run([sys.executable, ROOT / 'environment' / 'release.py'], check=True, capture_output=True)
    return ROOT / 'build' / 'release'


@pytest.fixture(scope='module')
def python(released: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install the wheel into an empty environment made from the lock; return its Python."""
    venv = tmp_path_factory.mktemp('installed') / 'ein Käse'
    uv = ROOT / 'build' / 'uv' / 'bin' / 'uv'
    wheel = released / f'param_tutorial-{VERSION}-py3-none-any.whl'
    lock = ROOT / 'environment' / 'requirements.lock'
    environment = {**os.environ, 'UV_OFFLINE': '1',
                   'UV_CACHE_DIR': os.environ.get('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))}
    for words in (['venv', '--no-project', '--python', sys.executable, venv],
                  ['pip', 'install', '--python', venv / 'bin' / 'python', '--no-deps', '--build-constraints', lock,
                   '--require-build-hashes', '--requirement', lock],
                  ['pip', 'install', '--python', venv / 'bin' / 'python', '--no-deps', wheel]):
        done = subprocess.run([uv, *words], env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    return venv / 'bin' / 'python'


@pytest.fixture
def start(python: Path, tmp_path: Path) -> Iterator[Callable[..., subprocess.Popen[str]]]:
    """Yield a function that starts Python as a user without a checkout does; what still runs then is ended."""
    with contextlib.ExitStack() as stack:
        def start(*words: str) -> subprocess.Popen[str]:
            process = stack.enter_context(subprocess.Popen(
                [python, *words], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                env={'PATH': os.defpath, 'HOME': str(tmp_path), 'LANG': 'C.UTF-8'}))
            stack.callback(process.send_signal, signal.SIGTERM)
            return process
        yield start


def address_in(process: subprocess.Popen[str]) -> str:
    """Wait until a process prints an address."""
    said = ''
    while not (found := re.search(r'http://127\S+', said)):
        line = process.stdout.readline()
        assert line, said
        said += line
    return found[0]


def test_client_panel_and_parameter_files_work_without_the_checkout(python, start):
    folder, value = start('-c', USE).communicate()[0].splitlines()
    assert Path(folder).is_relative_to(python.parents[1])
    assert (Path(folder).parents[1] / 'config' / 'cart_config.yaml').exists()
    assert int(value) == 130


def test_the_courses_ros_package_is_found(start):
    process = start('-m', 'param_tutorial', 'launch', 'param_tutorial', 'simple_param_launch.py', '-s')
    assert 'Arguments' in process.communicate()[0]


def test_check_works_without_the_checkout(start, tmp_path):
    (tmp_path / 'arm.yaml').write_text('arm:\n  ros__parameters:\n    speed: [1, two]\n')
    process = start('-m', 'param_tutorial', 'check', 'arm.yaml')
    assert process.communicate()[0].startswith('arm.yaml:3:') and process.returncode == 1


def test_the_page_with_a_panel_works_without_the_checkout(start):
    with urllib.request.urlopen(address_in(start('-m', 'param_tutorial', 'panel', '--no-browser'))) as answer:
        page = answer.read().decode()
    # Of the course's own template, and of the view that the page runs.
    assert '<title>Parameters</title>' in page and 'anywidget' in page


def test_lab_copies_the_chapters_into_the_current_folder_and_opens_them(start, tmp_path):
    address = address_in(start('-m', 'param_tutorial', 'lab', '--no-browser', '--port=0'))
    with urllib.request.urlopen(address.replace('lab/tree/index.md', 'api/contents')) as answer:
        names = {each['name'] for each in json.load(answer)['content']}
    assert {'index.md', '01_what_are_parameters.ipynb', '11_conclusion.ipynb'} <= names
    assert (tmp_path / 'my_lessons' / '.jupyter' / 'runtime').is_dir()


def test_the_wheel_holds_what_git_knows_and_nothing_else(released):
    with zipfile.ZipFile(released / f'param_tutorial-{VERSION}-py3-none-any.whl') as wheel:
        names = {name.removeprefix('param_tutorial_course/') for name in wheel.namelist() if '.dist-info/' not in name}
    known = subprocess.run(['git', 'ls-files', '-z'], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert names - set(known.split('\0')) == {'param_tutorial_course.pth'}
    assert {'notebooks/index.md', 'config/cart_config.yaml', 'LICENSE'} <= names


def test_each_locked_package_is_in_the_sbom_and_states_its_license(released):
    sbom = json.loads((released / 'sbom.json').read_text())
    assert (sbom['bomFormat'], sbom['metadata']['component']['version']) == ('CycloneDX', VERSION)
    listed = {each['name']: each for each in sbom['components']}
    # The lock is for five Pythons, and each gets a few packages fewer.
    assert len(set(LOCKED) - listed.keys()) < 10
    assert listed.keys() <= set(LOCKED)
    assert all(each['purl'] == f'pkg:pypi/{name}@{each["version"]}' for name, each in listed.items())
    # This one is empty: it names the package that it stands for.
    assert [name for name, each in listed.items() if each['licenses'][0]['license']['name'] == 'not stated'] == [
        'ros-jazzy-rclpy']


def test_the_changelog_begins_with_this_version():
    text = (ROOT / 'environment' / 'CHANGELOG.md').read_text()
    assert re.search(r'^## (\S+?),? ', text, re.MULTILINE)[1] == VERSION
