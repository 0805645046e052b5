"""However a build ends, it leaves one complete site and no process."""

import os
import shutil
import signal
import subprocess
import sys

import nbformat
import psutil
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from param_tools.ros.waiting import wait_until
from param_tutorial.site import replacing
from param_tutorial.site.browser import page_python
from tests.support import missing


def test_the_old_site_stays_until_the_new_one_is_whole(tmp_path, monkeypatch):
    for name in ('html', 'work'):
        (tmp_path / name).mkdir()
        (tmp_path / name / f'{name}.html').touch()

    def run_out_of_room(_, target, **__):
        target.mkdir()
        raise OSError('no room')

    with monkeypatch.context() as patched, pytest.raises(OSError, match='no room'):
        patched.setattr(shutil, 'copytree', run_out_of_room)
        replacing.replace(tmp_path / 'work', tmp_path / 'html')
    assert (tmp_path / 'html' / 'html.html').exists()
    replacing.replace(tmp_path / 'work', tmp_path / 'html')
    assert [path.name for path in (tmp_path / 'html').iterdir()] == ['work.html']
    assert {path.name for path in tmp_path.iterdir()} == {'html', 'work'}


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGKILL])
def test_no_process_outlives_a_build(tmp_path, number):
    if not page_python.PYODIDE.exists():
        missing.skip('there is no Pyodide in environment/node_modules: `make html` gets it')
    cells = [new_markdown_cell('# 1 · A'), new_code_cell('import asyncio\nawait asyncio.sleep(100)')]
    nbformat.write(new_notebook(cells=cells), tmp_path / '1_a.ipynb')
    process = subprocess.Popen(
        [sys.executable, '-m', 'param_tutorial.site', '--notebooks', tmp_path, '--target', tmp_path / 'html',
         '--work', tmp_path / 'work', '--only', '1'], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        start_new_session=True)

    def chapters_below():
        assert process.poll() is None, process.stderr.read()
        return [each for each in psutil.Process(process.pid).children(recursive=True)
                if 'run.mjs' in ' '.join(each.cmdline())]

    wait_until(chapters_below, 'a chapter to run', 120)
    below = psutil.Process(process.pid).children(recursive=True)
    # As from a terminal: its Ctrl+C goes to all processes of the group.
    (os.killpg if number == signal.SIGINT else os.kill)(process.pid, number)
    said = process.communicate()[1]
    if number == signal.SIGINT:
        assert said == '\nStopped; the previous site is kept.\n' and process.returncode == 130
    wait_until(lambda: not any(each.is_running() for each in below), 'the processes that it had started to end', 30)
