"""All that writes files, where the disk gets full meanwhile: a clear word, and nothing lost."""

import contextlib
import resource
from collections.abc import Iterator

import pytest

from param_tools.systems.change_log import ChangeLog
from param_tutorial import ParameterPanel
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from tests.support import commands

NODE = '/simple_param_node'
HAND_WRITTEN = f'{NODE}:\n  ros__parameters:\n    max_speed_rpm: 3  # as the motor has it\n    robot_name: Old\n'
FULL = 'File too large'


@contextlib.contextmanager
def little_room() -> Iterator[None]:
    """Let no file grow beyond 40 bytes: a write is cut short and then fails, as where a disk gets full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def run(*words):
    """Run a command; return what it says went wrong, and the exit status."""
    return commands.run(*words)[1:]


def save_by_panel(path):
    """Save from a panel."""
    panel = ParameterPanel(NODE)
    try:
        panel.save(path)
    except OSError as error:
        return str(error), 1
    finally:
        panel.close()
    return '', 0


WRITERS = {
    'panel': save_by_panel,
    'snapshot': lambda path: run('snapshot', '--save', path),
    'update': lambda path: run('snapshot', '--update', path),
    'describe': lambda path: run('describe', NODE, '--save', path),
    'backup': lambda path: run('restore', path.with_name('other.yaml'), '--backup', path),
}


@pytest.mark.parametrize('writer', WRITERS)
def test_what_cannot_be_written_is_said_and_the_file_of_before_stays(ros, tmp_path, writer):
    node = ros.add(SimpleParamNode)
    path, other = tmp_path / 'robot.yaml', tmp_path / 'other.yaml'
    other.write_text(f'{NODE}:\n  ros__parameters:\n    max_speed_rpm: 7\n')
    path.write_text(HAND_WRITTEN)
    with little_room():
        said, status = WRITERS[writer](path)
    assert status == 1
    assert FULL in said and said.rstrip('\n').count('\n') == 0
    assert path.read_text() == HAND_WRITTEN
    assert set(tmp_path.iterdir()) == {path, other}
    assert node.get_parameter('max_speed_rpm').value == 100


@pytest.mark.slow
def test_a_log_that_could_not_be_continued_is_read_and_goes_on_when_there_is_room(ros, tmp_path):
    ros.add(SimpleParamNode)
    path = tmp_path / 'changes.log'
    assert run('watch', '--log', path, '--duration', 0.5) == ('', 0)
    first = ChangeLog.read(path).records
    with little_room():
        said, status = run('watch', '--log', path, '--duration', 60)
    assert status == 1 and FULL in said
    assert ChangeLog.read(path).records == first
    assert run('watch', '--log', path, '--duration', 0.5) == ('', 0)
    assert len(ChangeLog.read(path).records) == 2 * len(first)


def test_a_redirected_command_says_that_its_file_cannot_be_written(ros, tmp_path, ipython, capsys):
    ros.add(SimpleParamNode)
    with little_room():
        ipython.run_line_magic('ros2', f'param dump {NODE} > {tmp_path}/robot.yaml')
    printed = capsys.readouterr()
    assert f"{FULL}: '{tmp_path}/robot.yaml'" in printed.err
    assert 'Traceback' not in printed.err
