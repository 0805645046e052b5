"""However a build ends, it leaves one complete site and no process."""

import shutil
import subprocess
import sys

import psutil
import pytest

from param_tools.ros.waiting import wait_until
from param_tutorial.site import replacing


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


# A page whose Python never comes.
PYODIDE = '''
import fs from "node:fs";
export const loadPyodide = ({ indexURL }) => new Promise(() => {
  fs.writeFileSync(`${indexURL}/runs`, "");
  setInterval(() => {}, 1000);
});
'''
BUILD = '''
import sys
from pathlib import Path
from param_tutorial.site.live.running import run_notebook
folder = Path(sys.argv[1])
run_notebook(folder / 'a.ipynb', folder, folder / 'packages')
'''


@pytest.mark.slow
def test_a_chapter_that_runs_ends_with_its_build_also_if_that_is_killed(tmp_path):
    (tmp_path / 'pyodide.mjs').write_text(PYODIDE)
    build = subprocess.Popen([sys.executable, '-c', BUILD, tmp_path])
    wait_until((tmp_path / 'runs').exists, 'the chapter to run')
    chapter = psutil.Process(build.pid).children(recursive=True)
    assert chapter
    build.kill()
    build.wait()
    assert not psutil.wait_procs(chapter, 60)[1]
