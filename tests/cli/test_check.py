"""The commands check and describe: exit status, formats, and what files are checked against."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from param_tools.files import descriptions
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support.commands import run

GOOD = '/simple_param_node:\n  ros__parameters:\n    max_speed_rpm: 120\n'
BAD = GOOD.replace('max_speed', 'max_sped')


def test_a_file_against_a_running_node(ros, write):
    ros.add(SimpleParamNode)
    assert run('check', write(GOOD), '--against', '/simple_param_node') == ('', '', 0)
    path = write(BAD)
    stdout, stderr, status = run('check', path, '--against', '/simple_param_node')
    assert stdout == (f"{path}:3:5: unknown parameter: /simple_param_node has no parameter 'max_sped_rpm'. Did you "
                      f'mean max_speed_rpm?\n')
    assert (stderr, status) == ('', 1)


def test_what_a_running_node_declares_is_saved_and_checked_against(ros, write, tmp_path):
    ros.add(SimpleParamNode)
    saved = tmp_path / 'saved.yaml'
    stdout, stderr, status = run('describe', '/**', '--save', saved)
    assert (stdout, stderr, status) == (f'Saved 9 parameters of 1 node to {saved}\n', '', 0)
    ros.remove_all()
    assert descriptions.read(saved).complete
    assert run('check', write(GOOD), '--against', saved)[2] == 0
    assert run('check', write(BAD), '--against', saved)[2] == 1


@pytest.mark.parametrize(('words', 'complaint'), [
    (['nowhere.yaml'], 'cannot read nowhere.yaml: No such file'),
    (['FILE', '--against', '/nobody'], 'there is no node /nobody'),
    (['FILE', '--against', 'FILE'], 'it is no saved description'),
    (['FILE', '--against', 'nowhere.yaml'], 'cannot read nowhere.yaml'),
    (['FILE', '--format', 'xml'], "invalid choice: 'xml'"),
    (['x_launch.py', '--launch', '--source', '.'], 'takes no launch file'),
    ([], 'give a FILE, or --source FOLDER'),
])
def test_what_cannot_be_checked_has_a_status_of_its_own(ros, write, words, complaint):
    stdout, stderr, status = run('check', *(write(GOOD) if word == 'FILE' else word for word in words))
    assert (stdout, status) == ('', 2)
    assert complaint in stderr
    assert 'Traceback' not in stderr


def test_of_several_files_those_that_are_no_parameter_files_are_passed_over(write):
    good, other = write(GOOD, 'good.yaml'), write('arm:\n  solver: demo/Solver\n', 'kinematics.yaml')
    assert run('check', good, other) == (
        '', f'{other}: not a parameter file, because it has no ros__parameters\n', 0)
    stdout, _, status = run('check', other)
    assert stdout.startswith(f'{other}:1:1: no header: the file has no ros__parameters, so rcl rejects it: a block')
    assert status == 1


def test_what_only_launch_fills_in_is_named(write):
    path = write(GOOD.replace('120', '$(var rpm)'))
    stdout, stderr, status = run('check', path)
    assert (stdout, status) == ('', 0)
    assert stderr.endswith(f'elsewhere the node gets the text: {path}:3\n')


def test_a_terminal_that_knows_only_ascii_gets_every_line(write):
    path = write('/lift:\n  ros__parameters:\n    größe_mm: 1\n    größe_mm: 2\n')
    done = subprocess.run([sys.executable, '-m', 'param_tools', 'check', path], capture_output=True, text=True,
                          env={**os.environ, 'PYTHONIOENCODING': 'ascii'})
    assert (done.returncode, done.stderr) == (1, '')
    assert 'gr\\xf6\\xdfe_mm has a value in line 3 already' in done.stdout


def test_a_full_disk_behind_the_output_is_said():
    with Path('/dev/full').open('w') as full:
        done = subprocess.run([sys.executable, '-m', 'param_tools', 'check', '--help'], stdout=full,
                              stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (2, 'cannot write the output: No space left on device\n')


@pytest.mark.parametrize(('closed', 'is_printed'), [('1', False), ('2', True)])
def test_a_command_works_where_the_shell_has_closed_an_output(closed, is_printed):
    done = subprocess.run(['sh', '-c', f'exec "$0" -m param_tools check --help {closed}>&-', sys.executable],
                          capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, '')
    assert ('--against' in done.stdout) is is_printed
