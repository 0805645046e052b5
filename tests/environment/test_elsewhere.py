"""What runs the course elsewhere (GitHub, dev containers, Binder, conda, pixi, Docker) names what is really here.

None of these can be run by a test; environment/README.md says which tools have looked at the files.
"""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from param_tutorial.learner.progress import VARIABLE
from tests.support.paths import ROOT
from tests.support.toml import read_toml

WORKFLOWS = sorted((ROOT / '.github' / 'workflows').glob('*.yml'))
# In JSON with comments, which Python's json does not read.
DEVCONTAINER = json.loads(
    re.sub('^//.*\n', '', (ROOT / '.devcontainer' / 'devcontainer.json').read_text(), flags=re.MULTILINE))
PYPROJECT = read_toml(ROOT / 'pyproject.toml')
TARGETS = re.findall(r'^([a-z-]+):', (ROOT / 'Makefile').read_text(), re.MULTILINE)


def steps(workflow: Path) -> list[dict]:
    """Return all steps of a workflow's jobs."""
    return [step for job in yaml.safe_load(workflow.read_text())['jobs'].values() for step in job.get('steps', [])]


COMMANDS = [
    *(step['run'] for workflow in WORKFLOWS for step in steps(workflow) if 'run' in step),
    DEVCONTAINER['postCreateCommand'],
    DEVCONTAINER['postAttachCommand'],
    (ROOT / '.ci' / 'run').read_text(),
]


def test_each_target_that_is_called_is_in_the_makefile():
    # A comment may talk of make, and a list of packages name it.
    called = {target for command in COMMANDS for target in re.findall(r'^ *make ([a-z-]+)', command, re.MULTILINE)}
    assert called >= {'setup', 'lab', 'test-all', 'html', 'lock'}
    assert called <= set(TARGETS)


def test_each_script_that_is_called_is_here_and_can_be_run():
    called = {path for command in COMMANDS for path in re.findall(r'^(\.\w+/\w+)', command)}
    called |= {path for hook in (ROOT / '.binder').iterdir()
               for path in re.findall(r'^exec (\S+)', hook.read_text(), re.MULTILINE)}
    assert called == {'.ci/run', 'environment/binder.sh'}
    for path in [*called, '.binder/postBuild', '.binder/start']:
        assert os.access(ROOT / path, os.X_OK), path
        subprocess.run(['bash', '-n', ROOT / path], check=True)


@pytest.mark.parametrize('workflow', WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_may_write_only_where_a_job_says_so(workflow):
    content = yaml.safe_load(workflow.read_text())
    assert content['permissions'] == {'contents': 'read'}
    assert all('timeout-minutes' in job for job in content['jobs'].values() if 'uses' not in job)


def test_what_pages_publishes_is_what_make_html_writes():
    published, = (step['with']['path'] for workflow in WORKFLOWS for step in steps(workflow)
                  if 'upload-pages-artifact' in step.get('uses', ''))
    html, = re.findall(r'^html:.*## .* in ([\w/]+)/,', (ROOT / 'Makefile').read_text(), re.MULTILINE)
    assert published == html


def test_the_browser_opens_the_port_that_jupyterlab_has():
    port, = DEVCONTAINER['forwardPorts']
    assert f'--port {port}' in DEVCONTAINER['postAttachCommand']
    assert DEVCONTAINER['portsAttributes'].keys() == {str(port)}


def test_each_named_python_is_one_that_the_course_supports():
    named = {
        'devcontainer.json': re.search(r'python:(\d+\.\d+)', DEVCONTAINER['image'])[1],
        'runtime.txt': (ROOT / '.binder' / 'runtime.txt').read_text().strip().removeprefix('python-'),
        'environment.yml': next(each for each in conda() if each.startswith('python=')).removeprefix('python='),
        'pixi.toml': pixi()['dependencies']['python'].removesuffix('.*'),
    }
    low, high = (tuple(map(int, version.split('.')))
                 for version in re.findall(r'\d+\.\d+', PYPROJECT['project']['requires-python']))
    assert [name for name, version in named.items() if not low <= tuple(map(int, version.split('.'))) < high] == []


def conda() -> list[str]:
    """Return what environment.yml asks of conda."""
    content = yaml.safe_load((ROOT / 'environment' / 'environment.yml').read_text())
    return [each for each in content['dependencies'] if isinstance(each, str)]


def pixi() -> dict:
    return read_toml(ROOT / 'environment' / 'pixi.toml')


def test_conda_and_pixi_ask_for_the_same_versions():
    by_conda = {re.match(r'[\w-]+', each)[0]: re.sub(r'^[\w-]+', '', each) for each in conda()}
    by_pixi = {name: '' if version == '*' else version for name, version in pixi()['dependencies'].items()}
    # conda's =3.12 is pixi's 3.12.*
    assert {name: re.sub(r'^=(.*)', r'\1.*', version) for name, version in by_conda.items()} == by_pixi


@pytest.mark.parametrize(('name', 'extras'), [
    ('environment.yml', ['jupyter', 'page', 'colcon', 'course']),
    ('pixi.toml', ['jupyter', 'page', 'colcon', 'course']),
    # It installs the course with its extra `page`.
    ('Dockerfile', ['colcon', 'course']),
])
def test_packages_and_versions_are_those_of_the_project(name, extras):
    text = re.sub(r"""["']| = """, '', (ROOT / 'environment' / name).read_text())
    project = PYPROJECT['project']
    wanted = {each for extra in extras for each in project['optional-dependencies'][extra]}
    # What a distribution of ROS brings, it brings in a version of its own.
    wanted = {each for each in wanted if not each.startswith(('param-tutorial[', 'colcon-'))}
    wanted |= {'ros-jazzy-ament-index-python', 'colcon-common-extensions'}
    wanted |= {'.[page]'} if name == 'Dockerfile' else set(project['dependencies'])
    assert [each for each in sorted(wanted) if each not in text] == []


def test_binder_remembers_progress_under_the_name_that_the_course_reads():
    script = (ROOT / 'environment' / 'binder.sh').read_text()
    assert f'{VARIABLE}=$PWD/my_lessons/progress.json' in script


@pytest.mark.slow
def test_binder_starts_with_the_learners_copies(tmp_path):
    """What repo2docker puts in front of its command, in a folder with what the script needs of the course."""
    for name in ('environment', 'notebooks'):
        (tmp_path / name).symlink_to(ROOT / name)
    done = subprocess.run(
        [tmp_path / 'environment' / 'binder.sh', 'start', 'sh', '-c', 'echo $JUPYTER_CONFIG_PATH; ls my_lessons'],
        cwd=tmp_path, env={**os.environ, 'PATH': f'{Path(sys.executable).parent}{os.pathsep}{os.environ["PATH"]}'},
        capture_output=True, text=True, check=True)
    settings, *copies = done.stdout.split()
    assert (Path(settings) / 'labconfig' / 'page_config.json').is_file()
    assert {'index.md', '01_what_are_parameters.ipynb'} <= set(copies)
