"""However a build ends, it leaves one complete site and no process."""

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import nbformat
import psutil
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from param_tools.ros.waiting import wait_until
from param_tutorial.site import replacing
from param_tutorial.site.browser import page_python
from tests.support import missing


class EndedError(BaseException):
    """The build is ended here, as by a signal."""


def pages(folder):
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.mark.parametrize('can_exchange', [True, False])
def test_there_is_one_whole_site_at_whatever_step_the_build_ends(tmp_path, monkeypatch, can_exchange):
    steps = 0
    ended_at = -1

    def counted(do):
        def step(*arguments, **options):
            nonlocal steps
            steps += 1
            if steps - 1 == ended_at:
                raise EndedError
            return do(*arguments, **options)
        return step

    if not can_exchange:
        monkeypatch.setattr(replacing, '_exchange', lambda *_: False)
    for owner, name in ((Path, 'rename'), (shutil, 'copytree'), (shutil, 'rmtree'), (replacing, '_exchange')):
        monkeypatch.setattr(owner, name, counted(getattr(owner, name)))
    old, new = {'index.html': 'old', 'a.html': 'old'}, {'index.html': 'new', 'b.html': 'new'}
    outcomes = []
    for moment in range(20):
        folder = tmp_path / str(moment)
        for name, content in (('html', old), ('work', new)):
            (folder / name).mkdir(parents=True)
            for page, text in content.items():
                (folder / name / page).write_text(text)
        steps, ended_at = 0, moment
        try:
            replacing.replace(folder / 'work', folder / 'html')
        except EndedError:
            if can_exchange:
                assert pages(folder / 'html') in (old, new)
            ended_at = -1
            replacing.recover(folder / 'html')
        outcomes.append('old' if pages(folder / 'html') == old else 'new')
        assert pages(folder / 'html') in (old, new)
        assert not (folder / 'html.old').exists()
    assert outcomes[0] == 'old' and outcomes[-1] == 'new'
    assert outcomes == sorted(outcomes, reverse=True)


@pytest.mark.slow
@pytest.mark.thorough
@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_no_process_outlives_a_build(tmp_path, number):
    if not page_python.PYODIDE.exists():
        missing.skip('there is no Pyodide in node_modules: `make html` gets it')
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
