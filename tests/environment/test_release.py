"""What `make release` makes: a wheel that needs no checkout, a list of licenses, and an SBOM."""

import json
import os
import re
import signal
import subprocess
import sys
import urllib.error
import urllib.request
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

import param_tools
from tests.support.lab import wait_for
from tests.support.paths import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(400)]

VERSION = param_tools.__version__
LOCKED = re.findall(r'^([\w.-]+)==', (ROOT / 'environment' / 'requirements.lock').read_text(), re.MULTILINE)
USE = '''
import param_tutorial
from param_tutorial.nodes.simple_param_node import SimpleParamNode
node = param_tutorial.start().add(SimpleParamNode)
param_tutorial.ParameterClient('/simple_param_node').set_parameter('max_speed_rpm', 120)
panel = param_tutorial.ParameterPanel('/simple_param_node')
panel['max_speed_rpm'].value = 130
panel.settle()
print(param_tutorial.__file__, node.get_parameter('max_speed_rpm').value)
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
    uv, = (ROOT / 'build').glob('uv-[0-9]*')
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
def elsewhere(tmp_path: Path) -> Iterator[dict[str, str]]:
    """Return the environment of a user without a checkout."""
    yield {'PATH': os.defpath, 'HOME': str(tmp_path), 'LANG': 'C.UTF-8'}


def test_client_and_panel_work_without_the_checkout(python, elsewhere, tmp_path):
    done = subprocess.run([python, '-c', USE], cwd=tmp_path, env=elsewhere, capture_output=True, text=True)
    *file, value = done.stdout.split(' ')
    assert int(value) == 130, done.stderr
    assert Path(' '.join(file)).is_relative_to(python.parents[1])


def test_a_parameter_file_of_the_course_and_its_ros_package_are_found(python, elsewhere, tmp_path):
    done = subprocess.run(
        [python, '-c', 'from pathlib import Path; import param_tutorial\n'
                       'print((Path(param_tutorial.__file__).parents[2] / "config" / "cart_config.yaml").exists())'],
        cwd=tmp_path, env=elsewhere, capture_output=True, text=True)
    assert done.stdout == 'True\n', done.stderr
    done = subprocess.run([python, '-m', 'param_tutorial', 'launch', 'param_tutorial', 'simple_param_launch.py', '-s'],
                          cwd=tmp_path, env=elsewhere, capture_output=True, text=True)
    assert 'Arguments' in done.stdout, done.stderr


def test_check_works_without_the_checkout(python, elsewhere, tmp_path):
    (tmp_path / 'arm.yaml').write_text('arm:\n  ros__parameters:\n    speed: [1, two]\n')
    done = subprocess.run([python, '-m', 'param_tutorial', 'check', 'arm.yaml'], cwd=tmp_path, env=elsewhere,
                          capture_output=True, text=True)
    assert done.returncode == 1 and done.stdout.startswith('arm.yaml:3:'), done.stdout + done.stderr


def test_the_page_with_a_panel_works_without_the_checkout(python, elsewhere, tmp_path):
    with subprocess.Popen([python, '-m', 'param_tutorial', 'panel', '--no-browser'], cwd=tmp_path, env=elsewhere,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        try:
            line = process.stdout.readline()
            address = re.search(r'http://127\S+', line)
            assert address, line + process.stdout.read()
            with urllib.request.urlopen(address[0]) as answer:
                page = answer.read().decode()
        finally:
            process.send_signal(signal.SIGINT)
            process.communicate()
    # Of the course's own template, and of the view that the page runs.
    assert '<title>Parameters</title>' in page and 'anywidget' in page


def test_lab_copies_the_chapters_into_the_current_folder_and_opens_them(python, elsewhere, tmp_path):
    log = tmp_path / 'log'
    with log.open('w') as output:
        process = subprocess.Popen([python, '-m', 'param_tutorial', 'lab', '--no-browser', '--port=0'], cwd=tmp_path,
                                   env=elsewhere, stdout=output, stderr=subprocess.STDOUT)
    try:
        runtime = tmp_path / 'my_lessons' / '.jupyter' / 'runtime'
        found = wait_for(lambda: process.poll() is not None or re.search(r'http://127\S+(?=\s)', log.read_text()),
                         'JupyterLab')
        assert found is not True, log.read_text()
        names = wait_for(lambda: names_in(found[0].replace('lab/tree/index.md', 'api/contents')), 'its answer')
        assert {'index.md', '01_what_are_parameters.ipynb', '11_conclusion.ipynb'} <= names
        assert runtime.is_dir()
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait()


def names_in(contents):
    """Ask JupyterLab for the names in its folder; None if it does not listen yet, which it says a little too early."""
    try:
        with urllib.request.urlopen(contents, timeout=100) as answer:
            return {each['name'] for each in json.load(answer)['content']}
    except urllib.error.URLError as error:
        if not isinstance(error.reason, ConnectionRefusedError):
            raise
        return None


def test_the_wheel_holds_what_git_knows_and_nothing_else(released):
    assert (released / f'param_tools-{VERSION}-py3-none-any.whl').is_file()
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
