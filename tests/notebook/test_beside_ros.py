"""The course on an engineer's machine: ROS variables set, a workspace sourced that holds an old build of the course."""

import os
import subprocess
import sys

import pytest

from param_tools.ros import environment
from tests.support.paths import NOTEBOOKS, ROS_PACKAGE

# As they stand in many a .bashrc. RMW_IMPLEMENTATION is another test's: a cell says that it is not used.
VARIABLES = {'ROS_DISTRO': 'jazzy', 'ROS_VERSION': '2', 'ROS_LOCALHOST_ONLY': '1', 'RCUTILS_COLORIZED_OUTPUT': '1',
             'RCUTILS_CONSOLE_OUTPUT_FORMAT': '[{severity}] [{time}] {message}', 'ROS_SECURITY_ENABLE': 'false'}
# Here commands run in a shell, beside the cells, and in the cells.
CHAPTERS = ('02_workspace.ipynb', '05_1_from_the_command_line.ipynb', '07_2_launch_files.ipynb')


def install_space(folder, *programs):
    """Make an install space that holds a package of the course's name, whose programs fail, and return its folder."""
    marker = folder / 'share' / 'ament_index' / 'resource_index' / 'packages' / 'param_tutorial'
    marker.parent.mkdir(parents=True)
    marker.touch()
    for name in programs:
        fails(folder / 'lib' / 'param_tutorial' / name)
    return folder


def fails(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text('#!/bin/sh\necho "no cell may start $0"\nexit 1\n')
    path.chmod(0o755)


def test_an_old_build_of_the_course_is_not_found(tmp_path, monkeypatch):
    spaces = [install_space(tmp_path / 'isolated' / 'param_tutorial'), install_space(tmp_path / 'merged')]
    monkeypatch.setenv('AMENT_PREFIX_PATH', os.pathsep.join(map(str, [*spaces, '/opt/ros/jazzy'])))
    monkeypatch.setenv('COLCON_PREFIX_PATH', os.pathsep.join([str(tmp_path / 'isolated'), str(tmp_path / 'other')]))
    environment.drop_old_builds()
    assert os.environ['AMENT_PREFIX_PATH'] == '/opt/ros/jazzy'
    assert os.environ['COLCON_PREFIX_PATH'] == str(tmp_path / 'other')


@pytest.mark.rare
@pytest.mark.timeout(600)
@pytest.mark.parametrize('chapter', CHAPTERS)
def test_a_chapter_prints_the_same_beside_ros(tmp_path, chapter):
    ros = tmp_path / 'opt' / 'ros'
    fails(ros / 'bin' / 'ros2')
    (ros / 'local_setup.bash').touch()  # colcon looks for it
    nodes = [path.stem for path in (ROS_PACKAGE / 'param_tutorial' / 'nodes').glob('*_node.py')]
    workspace = install_space(tmp_path / 'ros2_ws' / 'install', *nodes)
    machine = {**os.environ, **VARIABLES, 'PATH': f'{ros / "bin"}{os.pathsep}{os.environ["PATH"]}',
               'AMENT_PREFIX_PATH': f'{workspace}{os.pathsep}{ros}'}
    done = subprocess.run([sys.executable, '-m', 'pytest', '-q', '--nbval', NOTEBOOKS / chapter],
                          env=machine, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
