"""The embedded ros2 against recordings of the genuine one, in this process and as processes of their own.

transcripts/README.md says how the recordings were made and how closely to agree.
"""

import hashlib
import json
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter

from tests.support.commands import run

DATA = Path(__file__).parent / 'transcripts'
NODES = json.loads((DATA / 'nodes.json').read_text())['nodes']
PACKAGES = json.loads((DATA / 'pkg_create.json').read_text())
SCENARIOS = json.loads((DATA / 'transcripts.json').read_text())['scenarios']

# What our own sentences must hold where the genuine command prints a usage or a traceback.
MEANING = {
    'ros2 param get /simple_param_node': 'the following arguments are required: parameter_name',
    'ros2 param load /simple_param_node missing.yaml': 'cannot read missing.yaml: No such file or directory',
}


class RecordedNode(Node):
    """A node as nodes.json describes it."""

    def __init__(self, description):
        super().__init__(description['name'], namespace=description['namespace'])
        for each in description['parameters']:
            descriptor = ParameterDescriptor(
                description=each.get('description', ''),
                additional_constraints=each.get('additional_constraints', ''),
                read_only=each.get('read_only', False),
                dynamic_typing=each.get('dynamic_typing', False))
            if 'floating_point_range' in each:
                descriptor.floating_point_range = [FloatingPointRange(**each['floating_point_range'])]
            if 'integer_range' in each:
                descriptor.integer_range = [IntegerRange(**each['integer_range'])]
            value = each['value']
            if each['type'] == 'byte_array':
                value = [bytes([byte]) for byte in value]
            self.declare_parameter(
                each['name'], Parameter(each['name'], Parameter.Type[each['type'].upper()], value).value, descriptor)


def run_as_new_process(*words):
    """As ``run``; what a command prints does not depend on its process, but whether it finds the nodes does."""
    done = subprocess.run([sys.executable, '-m', 'param_tools', *words], capture_output=True, text=True,
                          stdin=subprocess.DEVNULL)
    return done.stdout, done.stderr, done.returncode


@pytest.mark.parametrize(('scenario', 'run_words'), [
    *((scenario, run) for scenario in SCENARIOS),
    pytest.param({**SCENARIOS[0], 'steps': SCENARIOS[0]['steps'][:5]}, run_as_new_process,
                 marks=pytest.mark.thorough),
], ids=lambda value: value['scenario'].replace(' ', '_') if isinstance(value, dict) else value.__name__)
def test_agrees_with_the_genuine_command(scenario, run_words, ros, tmp_path, monkeypatch):
    for description in NODES:
        ros.add(RecordedNode, description)
    for name, text in scenario['files'].items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    for step in scenario['steps']:
        stdout, stderr, status = run_words(*shlex.split(step['command'])[1:])
        assert status == step['returncode'], f"{step['command']}: {stderr}"
        if step['match'] == 'exact':
            assert (stdout, stderr) == (step['stdout'], step['stderr']), step['command']
        else:
            assert stdout == ''
            assert MEANING[step['command']] in stderr
            assert 'Traceback' not in stderr


@pytest.mark.parametrize('recorded', PACKAGES, ids=lambda recorded: ' '.join(recorded['words'][1:5]))
def test_a_new_package_has_the_genuine_commands_files(recorded, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path('src').mkdir()
    stdout, stderr, status = run('pkg', 'create', *recorded['words'])
    assert (stderr, status) == ('', 0)
    assert stdout.replace(str(tmp_path), 'FOLDER').startswith(recorded['stdout'])
    assert {str(path): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in Path().rglob('*') if path.is_file()} == recorded['files']
