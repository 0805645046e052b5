"""All that writes files, where the disk is full and where the folder is read-only: a clear word, and nothing lost."""

import contextlib
import io
import os
import resource
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from param_tutorial import ParameterClient, ParameterPanel
from param_tutorial.learner.progress import ProgressFile
from param_tutorial.nodes.simple_param_node import SimpleParamNode
from param_tutorial.parameters.change_log import ChangeLog
from param_tutorial.ros2 import command
from param_tutorial.runtime import stage
from tests.support import missing

NODE = '/simple_param_node'
HAND_WRITTEN = f'{NODE}:\n  ros__parameters:\n    max_speed_rpm: 3  # as the motor has it\n    robot_name: Old\n'
# So few bytes of a file find room.
ROOM = 40
NOBODY = 65534


@contextlib.contextmanager
def full_disk(folder: Path) -> Iterator[str]:
    """Fill the disk on which a folder is, which must be a small one."""
    filler = folder.with_name('filler')
    with filler.open('wb', buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(4096))
    assert shutil.disk_usage(folder).free == 0
    try:
        yield 'No space left on device'
    finally:
        filler.unlink()


@contextlib.contextmanager
def little_room(_folder: Path) -> Iterator[str]:
    """Let no file grow beyond a few bytes: a write is cut short and then fails, as where a disk gets full meanwhile."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (ROOM, before[1]))
    try:
        yield 'File too large'
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@contextlib.contextmanager
def read_only(folder: Path) -> Iterator[str]:
    """Keep everyone from writing into a folder, even root, for whom its permissions don't count."""
    modes = {path: path.stat().st_mode for path in [*folder.rglob('*'), folder]}
    for path, mode in modes.items():
        path.chmod(mode & ~0o222 | 0o444)
    user = os.geteuid()
    if user == 0:
        os.seteuid(NOBODY)
    try:
        yield 'Permission denied'
    finally:
        os.seteuid(user)
        for path, mode in modes.items():
            path.chmod(mode)


@pytest.fixture
def folder(request):
    """Yield a folder that everybody may look into; pytest's own are for one user. One to be full is on a small disk."""
    made = Path(tempfile.mkdtemp(prefix='param_tutorial_'))
    is_small = 'hindered' in request.fixturenames and request.getfixturevalue('hindered') is full_disk
    if is_small:
        done = subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=256k', 'param_tutorial', made], capture_output=True,
                              text=True)
        if done.returncode != 0:
            made.rmdir()
            missing.skip(f'root only can make a disk: {done.stderr.strip()}')
    made.chmod(0o755)
    folder = made / 'folder'
    folder.mkdir()
    yield folder
    if is_small:
        subprocess.run(['umount', made], check=True)
    shutil.rmtree(made)


def files(folder):
    """Return the content of each file in a folder."""
    return {path.name: path.read_text() for path in folder.iterdir()}


def run(*words):
    """Run a command; return what it says went wrong, and the exit status."""
    stdout, stderr = io.StringIO(), io.StringIO()
    status = command.main([str(word) for word in words], stdout=stdout, stderr=stderr, get_executor=stage.current,
                          in_notebook=True)
    return stderr.getvalue(), status


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


def remember(path):
    """Remember that an exercise is solved."""
    said = ProgressFile(path).add_solved('3a')
    return said or '', 1 if said else 0


WRITERS = {
    'panel': save_by_panel,
    'snapshot': lambda path: run('snapshot', '--save', path),
    'update': lambda path: run('snapshot', '--update', path),
    'describe': lambda path: run('describe', NODE, '--save', path),
    'backup': lambda path: run('restore', path.with_name('other.yaml'), '--backup', path),
    'watch': lambda path: run('watch', '--log', path, '--duration', 60),
    'progress': remember,
}


@pytest.mark.parametrize(('writer', 'is_new', 'hindered'), [
    (writer, is_new, hindered) for writer in WRITERS for is_new in (True, False)
    for hindered in (full_disk, little_room, read_only)
    if (writer != 'update' or not is_new)
    # A full disk has room for the next lines of a log, in a page that the file has already.
    and (writer != 'watch' or is_new or hindered is not full_disk)])
def test_what_cannot_be_written_is_said_and_changes_nothing(ros, folder, tmp_path, writer, is_new, hindered):
    ros.add(SimpleParamNode)
    # What is imported or read on the way has to be there before: without root's rights, nobody may look into /root.
    WRITERS[writer](tmp_path / 'missing' / 'robot.yaml')
    path = folder / 'robot.yaml'
    (folder / 'other.yaml').write_text(f'{NODE}:\n  ros__parameters:\n    max_speed_rpm: 7\n')
    if not is_new and writer == 'progress':
        ProgressFile(path).add_solved('1a')
    elif not is_new:
        path.write_text(HAND_WRITTEN)
    before = files(folder)
    with hindered(folder) as reason:
        said, status = WRITERS[writer](path)
    assert status == 1
    assert reason in said
    assert 'Traceback' not in said and said.rstrip('\n').count('\n') == 0
    after = files(folder)
    if writer == 'watch' and hindered is not read_only:
        # What was in the log stays, and a torn last line does not prevent reading or continuing it.
        assert after.pop(path.name).startswith(before.pop(path.name, ''))
    assert after == before
    assert ParameterClient(NODE).get_parameter('max_speed_rpm') == 100


@pytest.mark.slow
def test_a_log_that_could_not_be_continued_is_read_and_goes_on_when_there_is_room(ros, folder):
    ros.add(SimpleParamNode)
    path = folder / 'changes.log'
    assert run('watch', '--log', path, '--duration', 0.5) == ('', 0)
    first = ChangeLog.read(path).changes
    with little_room(folder):
        assert run('watch', '--log', path, '--duration', 60)[1] == 1
    assert ChangeLog.read(path).changes == first
    assert run('watch', '--log', path, '--duration', 0.5) == ('', 0)
    assert len(ChangeLog.read(path).changes) == 2 * len(first)


@pytest.mark.parametrize('hindered', [full_disk, little_room, read_only])
def test_a_redirected_command_says_that_its_file_cannot_be_written(ros, folder, hindered, ipython, capsys):
    ros.add(SimpleParamNode)
    with hindered(folder) as reason:
        ipython.run_line_magic('ros2', f'param dump {NODE} > {folder}/robot.yaml')
    printed = capsys.readouterr()
    assert f"{reason}: '{folder}/robot.yaml'" in printed.err
    assert 'Traceback' not in printed.err
