"""The set-up files agree with one another, and with what is really there."""

import csv
import json
import os
import re
import subprocess
import sys
import sysconfig
import xml.etree.ElementTree as ET
from collections import defaultdict
from pathlib import Path

import pytest

from param_tutorial.ros2.run import node_programs
from tests.support.paths import PACKAGE, ROOT, ROS_PACKAGE

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

LOCKS = {path.name: path.read_text() for path in (ROOT / 'environment').glob('*.lock')}
# Everything, and the part that a learner gets.
LOCK, LEARNER_LOCK = LOCKS['requirements-dev.lock'], LOCKS['requirements.lock']
PYPROJECT = tomllib.loads((ROOT / 'pyproject.toml').read_text())
PROJECT = PYPROJECT['project']
# What each lock is made from.
REQUIREMENTS = {
    'requirements.lock': PROJECT['dependencies'],
    'requirements-dev.lock': [
        *PROJECT['dependencies'], *PROJECT['optional-dependencies']['html'], *PYPROJECT['dependency-groups']['test']],
    'requirements-hub.lock': PYPROJECT['dependency-groups']['hub'],
    'requirements-uv.lock': PYPROJECT['dependency-groups']['uv'],
}
DIRECT = sorted({(lock, re.match(r'[\w-]+', requirement)[0])
                 for lock, requirements in REQUIREMENTS.items() for requirement in requirements})

# setup.py as setuptools sees it, from a process of its own: it has to run in its own folder.
DESCRIBE = """
import json
from distutils.core import run_setup
found = run_setup('setup.py', stop_after='init')
print(json.dumps({
    'name': found.get_name(), 'version': found.get_version(), 'license': found.metadata.license,
    'packages': found.packages, 'entry_points': found.entry_points, 'data_files': found.data_files,
    'package_data': found.package_data,
}))
"""


@pytest.fixture(scope='module')
def setup_py():
    done = subprocess.run(
        [sys.executable, '-c', 'import setuptools\n' + DESCRIBE],
        cwd=ROS_PACKAGE,
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


@pytest.fixture(scope='module')
def package_xml():
    # colcon falls back to a plain Python package, in silence, when this can't be parsed.
    return ET.parse(ROS_PACKAGE / 'package.xml').getroot()


def test_package_xml_is_that_of_an_ament_python_package(package_xml):
    assert package_xml.tag == 'package' and package_xml.get('format') == '3'
    assert package_xml.findtext('export/build_type') == 'ament_python'
    assert {depend.text for depend in package_xml.iter('exec_depend')} >= {'rclpy', 'rcl_interfaces'}
    for required in ('name', 'version', 'description', 'maintainer', 'license'):
        assert package_xml.findtext(required).strip(), required


def test_names_versions_and_licences_agree(package_xml, setup_py):
    assert package_xml.findtext('name') == setup_py['name'] == PROJECT['name'].replace('-', '_')
    assert package_xml.findtext('version') == setup_py['version'] == PROJECT['version']
    assert package_xml.findtext('license') == setup_py['license'] == PROJECT['license'] == 'Apache-2.0'
    assert 'Apache License' in (ROOT / 'LICENSE').read_text()


def test_colcon_installs_the_programs_that_our_run_knows(setup_py):
    nodes = {path.stem: path.read_text() for path in (PACKAGE / 'nodes').glob('[a-z]*.py')}
    assert set(setup_py['entry_points']['console_scripts']) == {
        f'{name} = param_tutorial.nodes.__main__:program' for name in node_programs()}
    assert sorted(nodes) == node_programs()
    for name, source in nodes.items():
        assert re.search(r'^def main\(args: list\[str\] \| None = None\) -> None:$', source, re.MULTILINE), name


def test_each_package_below_the_ros_package_is_installed(setup_py):
    on_disk = {
        '.'.join(init.parent.relative_to(ROS_PACKAGE).parts)
        for init in (ROS_PACKAGE / 'param_tutorial').rglob('__init__.py')
    }
    assert set(setup_py['packages']) == on_disk


def test_style_sheets_and_scripts_are_installed_by_pip_and_by_colcon(setup_py):
    files = {*PACKAGE.rglob('*.css'), *PACKAGE.rglob('*.js')}
    assert len(files) >= 20
    for data in (PYPROJECT['tool']['setuptools']['package-data'], setup_py['package_data']):
        assert files <= {path for pattern in data['param_tutorial'] for path in PACKAGE.glob(pattern)}


def test_marker_and_parameter_files_are_installed(setup_py):
    installed = {folder: files for folder, files in setup_py['data_files']}
    assert installed['share/ament_index/resource_index/packages'] == ['resource/param_tutorial']
    assert installed['share/param_tutorial'] == ['package.xml']
    assert sorted(installed['share/param_tutorial/config']) == [
        f'../config/{path.name}' for path in sorted((ROOT / 'config').glob('*.yaml'))
    ]
    for files in installed.values():
        assert all((ROS_PACKAGE / file).is_file() for file in files)


@pytest.mark.parametrize('lock', LOCKS.values(), ids=LOCKS)
def test_the_lock_names_no_address(lock):
    assert '://' not in lock
    assert not re.search(r'^\s*--(?!hash=sha256:)', lock, re.MULTILINE)


def test_the_lock_of_the_javascript_tools_names_no_address_of_a_package():
    packages = json.loads((ROOT / 'package-lock.json').read_text())['packages']
    assert len(packages) > 3
    assert [name for name, package in packages.items() if 'resolved' in package] == []
    assert [name for name, package in packages.items() if name and 'integrity' not in package] == []


@pytest.mark.parametrize(('lock', 'name'), DIRECT)
def test_each_direct_dependency_is_locked_and_has_its_reason(lock, name):
    assert re.search(rf'^{name}==', LOCKS[lock], re.MULTILINE)
    readme = (ROOT / 'environment' / 'README.md').read_text()
    assert re.search(rf'^\| `{name}` \| .{{10,}} \|$', readme, re.MULTILINE)


def entries(lock: str) -> list[str]:
    """Return a lock's packages, each with its version, its marker and its hashes."""
    return re.split(r'^(?=[a-z])', lock, flags=re.MULTILINE)[1:]


def test_each_locked_package_has_hashes():
    assert len(entries(LOCK)) > 100
    assert [entry for lock in LOCKS.values() for entry in entries(lock) if '--hash=sha256:' not in entry] == []


def test_what_is_tested_is_what_a_learner_gets():
    assert len(entries(LEARNER_LOCK)) > 100
    assert set(entries(LEARNER_LOCK)) <= set(entries(LOCK))


def test_a_learner_is_spared_what_only_tests_and_website_need():
    names = {re.match(r'[a-z0-9-]+', entry)[0] for entry in entries(LEARNER_LOCK)}
    assert not names & {'playwright', 'sphinx', 'hypothesis', 'ruff', 'sqlalchemy', 'coverage', 'lark-parser'}


@pytest.mark.slow
def test_no_two_packages_write_the_same_file():
    """Which of the two would win is left to chance, as with lark and lark-parser, which share the folder lark/."""
    site = Path(sysconfig.get_path('purelib'))
    # Each package's list of its files, as paths from here. importlib.metadata reads the same ones in 15 s.
    written = {record.parent.name: [os.path.normpath(file) for file, *_ in csv.reader(record.read_text().splitlines())]
               for record in site.glob('*.dist-info/RECORD')}
    # A ROS wheel brings the metadata of a second package along, such as rclpy in ros-rclpy: one package, two names.
    inner = {file.split('/')[0] for owner, files in written.items() for file in files
             if file.split('/')[0].endswith(('.dist-info', '.egg-info')) and file.split('/')[0] != owner}
    owners = defaultdict(set)
    for owner in written.keys() - inner:
        for file in written[owner]:
            owners[file].add(owner)
    assert len(owners) > 10_000
    assert {file: names for file, names in owners.items() if len(names) > 1} == {}


def test_the_other_environments_name_the_same_packages():
    """Those that need no ROS wheels list the packages themselves, in step with pyproject.toml."""
    wanted = {re.sub(r'[<>=].*', '', each) for each in PROJECT['dependencies']}
    wanted -= {'ros-jazzy-rclpy[fastrtps]', 'lark'}  # they bring a whole ROS, with all that it needs
    # Distributions of ROS take colcon's parts together.
    wanted = {re.sub(r'^colcon-.*', 'colcon-common-extensions', each) for each in wanted}
    wanted = {each.replace('ros-ament', 'ros-jazzy-ament') for each in wanted}
    for name in ('environment.yml', 'pixi.toml', 'Dockerfile'):
        text = (ROOT / 'environment' / name).read_text()
        assert [package for package in sorted(wanted) if package not in text] == [], name
    pixi = tomllib.loads((ROOT / 'environment' / 'pixi.toml').read_text())
    assert pixi['dependencies'].keys() >= wanted
