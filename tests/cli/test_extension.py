"""The commands as extensions of the genuine ros2: what ros2cli does with an entry point is done here by hand.

ros2cli is not on PyPI. So that it finds the entry points is seen in a package that setuptools has built; what it calls
follows ros2cli/command/__init__.py and ros2cli/cli.py of Jazzy.
"""

import argparse
import importlib.metadata
import json
import os
import subprocess
import sys

import pytest

from param_tools.cli.genuine import OWN_COMMANDS
from param_tutorial import ParameterClient
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.paths import ROOT

# Loads an entry point and runs its command, as ros2cli does.
AS_ROS2CLI_DOES = '''
import argparse, importlib.metadata, sys
parser = argparse.ArgumentParser()
commands = parser.add_subparsers()
for point in importlib.metadata.entry_points(group='ros2cli.command'):
    if point.name == sys.argv[1]:
        extension = point.load()()
        extension.NAME = point.name
        command = commands.add_parser(point.name, description=extension.__doc__.splitlines()[0])
        command.set_defaults(_command=extension)
        extension.add_arguments(command, f'ros2 {point.name}')
args = parser.parse_args()
sys.exit(args._command.main(parser=parser, args=args))
'''


@pytest.fixture(scope='module')
def installed(tmp_path_factory):
    """Return a folder with the entry points that colcon, which calls setup.py, would install."""
    folder = tmp_path_factory.mktemp('installed')
    subprocess.run([sys.executable, 'setup.py', '-q', 'egg_info', '--egg-base', folder], cwd=ROOT / 'param_tutorial',
                   check=True, capture_output=True)
    return folder


def ros2(installed, *words):
    environment = {**os.environ, 'PYTHONPATH': os.pathsep.join([str(installed), os.environ.get('PYTHONPATH', '')])}
    return subprocess.run([sys.executable, '-c', AS_ROS2CLI_DOES, *map(str, words)], env=environment, text=True,
                          capture_output=True)


def test_each_command_is_an_entry_point_that_can_be_loaded(installed):
    points = {point.name: point for distribution in importlib.metadata.distributions(path=[str(installed)])
              for point in distribution.entry_points.select(group='ros2cli.command')}
    assert set(points) == {f'param_{name}' for name in OWN_COMMANDS}
    for point in points.values():
        extension = point.load()()
        assert extension.EXTENSION_POINT_VERSION == '0.1'
        assert extension.__doc__.splitlines()[0].endswith('.')
        extension.add_arguments(argparse.ArgumentParser(), f'ros2 {point.name}')


@pytest.mark.slow
def test_two_nodes_are_compared_as_by_the_genuine_command(ros, installed, tmp_path):
    ros.add(SimpleParamNode)
    path = tmp_path / 'monday.yaml'
    done = ros2(installed, 'param_snapshot', '/simple_param_node', '--save', path)
    assert (done.returncode, done.stderr) == (0, '')
    ParameterClient('/simple_param_node').set_parameter('robot_name', 'Berta')
    done = ros2(installed, 'param_diff', path, '/simple_param_node', '--format', 'json')
    assert (done.returncode, done.stderr) == (1, '')
    assert json.loads(done.stdout)[0]['after'] == 'Berta'
    done = ros2(installed, 'param_restore', tmp_path / 'nowhere.yaml')
    assert done.returncode == 1
    assert done.stderr.startswith('cannot read')
    assert ros2(installed, 'param_diff', '-h').stdout.startswith('usage: ')
