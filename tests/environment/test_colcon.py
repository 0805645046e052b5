"""This repository is a ROS package: `colcon build`, plain and with links, and a node run from the install space."""

import re
import shutil
from contextlib import closing

import pytest

from param_tutorial import ParameterClient, Shell, Terminal
from tests.support.paths import ROOT

pytestmark = pytest.mark.thorough

NAME = 'param_tutorial'
IGNORED = shutil.ignore_patterns('__pycache__', '*.egg-info', 'build', 'install', 'log')


class Workspace:
    """A workspace in which this checkout has been built."""

    def __init__(self, *options: str):
        self.shell = Shell()
        # config/ stands beside the ROS package, as in the checkout.
        for folder in (NAME, 'config'):
            shutil.copytree(ROOT / folder, self.shell.home / 'ws' / 'src' / folder, ignore=IGNORED)
        self.shell.run('cd ~/ws')
        self.said = self.shell.run(f'colcon build {" ".join(options)}')
        self.status = self.shell.status
        self.shell.run('source install/setup.bash')
        self.log = (self.shell.home / 'ws/log/latest_build/logger_all.log').read_text()
        self.share = self.shell.home / 'ws' / 'install' / NAME / 'share' / NAME


@pytest.fixture(scope='module', params=['', '--symlink-install'], ids=['plain', 'symlink'])
def workspace(request):
    workspace = Workspace(request.param)
    workspace.links = bool(request.param)
    yield workspace
    workspace.shell.close()


def test_it_builds_as_a_package_of_type_ament_python(workspace):
    assert workspace.status == 0, workspace.said
    # Nothing on standard error, which the summary would count.
    assert workspace.said.splitlines() == [
        f'Starting >>> {NAME}', f'Finished <<< {NAME}', '', 'Summary: 1 package finished']
    # With a package.xml that cannot be read, colcon takes it for a plain Python package, in silence.
    assert f"Package 'src/{NAME}' with type 'ros.ament_python' and name '{NAME}'" in workspace.log


def test_parameter_and_launch_files_are_installed(workspace):
    for source in (ROOT / 'config', ROOT / NAME / 'launch'):
        files = {path.name: path.read_text() for path in source.glob('*') if path.is_file()}
        there = workspace.share / source.name
        assert {path.name: path.read_text() for path in there.iterdir() if path.is_file()} == files


def test_a_node_runs_from_the_install_space(workspace, ros):
    robot = Terminal(f'ros2 run {NAME} simple_param_node --ros-args -p max_speed_rpm:=7 '
                     f'--params-file {workspace.share}/config/clawbot_config.yaml', shell=workspace.shell)
    robot.read(until='robot_serial_number')
    client = ParameterClient('/simple_param_node', timeout_sec=30)
    assert client.get_parameters(['robot_name', 'max_speed_rpm']) == {'robot_name': 'AlphaClaw', 'max_speed_rpm': 180}
    assert robot.interrupt() == 0
    assert 'Traceback' not in robot.text


def test_a_setup_py_that_takes_a_folder_for_a_file_does_not_build():
    """Claims A009, A016, A017, A077: the article's ``data_files``."""
    with closing(Shell()) as shell:
        shell.run('mkdir -p ws/src; cd ws/src; ros2 pkg create --build-type ament_python param_tutorial; cd ..')
        setup = shell.home / 'ws/src/param_tutorial/setup.py'
        setup.write_text(re.sub(r'data_files=\[.*?^    \]', "data_files=[('share/param_tutorial', ['package.xml']), "
                                "('share/param_tutorial/resource', ['param_tutorial'])]", setup.read_text(),
                                flags=re.DOTALL | re.MULTILINE))
        said = shell.run('colcon build; source install/setup.bash; ros2 run param_tutorial simple_param_node')
    assert "error: can't copy 'param_tutorial': doesn't exist or not a regular file" in said
    assert "doesn't explicitly install a marker in the package index" in said
    assert said.endswith("Package 'param_tutorial' not found")


def test_an_edit_takes_effect_with_links_and_does_not_without(workspace):
    """Claim A031."""
    node = workspace.shell.home / 'ws' / 'src' / NAME / NAME / 'nodes' / 'simple_param_node.py'
    before = node.read_text()
    try:
        node.write_text(before.replace('Clawbot', 'Edited'))
        said = workspace.shell.run('python -c "import inspect; from param_tutorial.nodes import simple_param_node as n'
                                   '; print(inspect.getsource(n))"')
    finally:
        node.write_text(before)
    assert ('Edited' in said) == workspace.links
