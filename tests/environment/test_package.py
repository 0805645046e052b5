"""The set-up files agree with one another, and with what is really there."""

import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import pytest

from param_tools import __version__
from param_tools.cli.run import node_programs
from tests.support.paths import PACKAGE, ROOT, ROS_PACKAGE, TOOLS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

LOCKS = {path.name: path.read_text() for path in (ROOT / 'environment').glob('*.lock')}
PYPROJECT = tomllib.loads((ROOT / 'pyproject.toml').read_text())
PROJECT = PYPROJECT['project']
EXTRAS = PROJECT['optional-dependencies']
COURSE = [*PROJECT['dependencies'], *EXTRAS['course']]
# What each lock is made from.
REQUIREMENTS = {
    'requirements.lock': COURSE,
    'requirements-dev.lock': [*COURSE, *EXTRAS['html'][1:], *PYPROJECT['dependency-groups']['test']],
    'requirements-hub.lock': PYPROJECT['dependency-groups']['hub'],
    'requirements-uv.lock': PYPROJECT['dependency-groups']['uv'],
}
# setup.py as setuptools sees it, from a process of its own: it has to run in its own folder.
DESCRIBE = """
import json
from distutils.core import run_setup
found = run_setup('setup.py', stop_after='init')
print(json.dumps({
    'name': found.get_name(), 'version': found.get_version(), 'license': found.metadata.license,
    'packages': found.packages, 'entry_points': found.entry_points,
}))
"""


@pytest.fixture(scope='module')
def setup_py():
    done = subprocess.run([sys.executable, '-c', 'import setuptools\n' + DESCRIBE], cwd=ROS_PACKAGE,
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_names_versions_and_licences_agree(setup_py):
    package_xml = ET.parse(ROS_PACKAGE / 'package.xml').getroot()
    assert package_xml.findtext('name') == setup_py['name'] == PROJECT['name'].replace('-', '_')
    assert package_xml.findtext('version') == setup_py['version'] == __version__
    assert package_xml.findtext('license') == setup_py['license'] == PROJECT['license'] == 'Apache-2.0'
    assert 'Apache License' in (ROOT / 'LICENSE').read_text()


def test_colcon_installs_the_programs_that_our_run_knows(setup_py):
    nodes = {path.stem: path.read_text() for path in (PACKAGE / 'nodes').glob('[a-z]*.py')}
    assert set(setup_py['entry_points']['console_scripts']) == {
        f'{name} = param_tutorial.nodes.__main__:program' for name in node_programs('param_tutorial')}
    assert sorted(nodes) == node_programs('param_tutorial')
    for name, source in nodes.items():
        assert re.search(r'^def main\(args: list\[str\] \| None = None\) -> None:$', source, re.MULTILINE), name


def test_each_package_below_the_ros_package_is_installed(setup_py):
    on_disk = {
        '.'.join(init.parent.relative_to(ROS_PACKAGE).parts)
        for package in (PACKAGE, TOOLS) for init in package.rglob('__init__.py') if 'steps' not in init.parts
    }
    assert set(setup_py['packages']) == on_disk


def test_the_course_takes_the_tools_with_all_that_they_need():
    tools = tomllib.loads((TOOLS / 'pyproject.toml').read_text())['project']
    needed = {each for extra in [tools['dependencies'], *tools['optional-dependencies'].values()] for each in extra}
    assert {each for each in needed if not each.startswith('param-tools[')} <= set(COURSE)


def entries(lock: str) -> list[str]:
    """Return a lock's packages, each with its version, its marker and its hashes."""
    return re.split(r'^(?=[a-z])', LOCKS[lock], flags=re.MULTILINE)[1:]


def test_each_locked_package_has_hashes_and_no_address():
    assert '://' not in ''.join(LOCKS.values())
    assert [entry for lock in LOCKS for entry in entries(lock) if '--hash=sha256:' not in entry] == []
    packages = json.loads((ROOT / 'environment' / 'package-lock.json').read_text())['packages']
    assert [name for name, package in packages.items() if name and 'integrity' not in package] == []
    assert [name for name, package in packages.items() if 'resolved' in package] == []


def test_each_direct_dependency_is_locked_and_has_its_reason():
    reasons = (ROOT / 'environment' / 'dependencies.md').read_text()
    for lock, requirements in REQUIREMENTS.items():
        for name in {re.match(r'[\w-]+', each)[0] for each in requirements}:
            assert re.search(rf'^{name}==', LOCKS[lock], re.MULTILINE), (lock, name)
            assert re.search(rf'^\| `{name}` \| .{{10,}} \|$', reasons, re.MULTILINE), name


def test_what_is_tested_is_what_a_learner_gets_and_a_learner_gets_no_more():
    assert set(entries('requirements.lock')) < set(entries('requirements-dev.lock'))
    names = {re.match(r'[a-z0-9-]+', entry)[0] for entry in entries('requirements.lock')}
    assert not names & {'playwright', 'sphinx', 'hypothesis', 'ruff', 'lark-parser'}


def test_pages_name_the_addresses_that_are_set_and_no_placeholder():
    readers, others = ('README.md', 'notebooks/index.md'), ('param_tutorial/param_tools', 'environment/jupyterhub')
    for page in (*readers, *(f'{folder}/README.md' for folder in others)):
        text = (ROOT / page).read_text()
        assert 'ADDRESS-OF' not in text, page
        assert page not in readers or all(url in text for url in PYPROJECT['project'].get('urls', {}).values()), page
