"""The tools without the course: a wheel of their own, which needs PyYAML, and ROS only for running nodes."""

import importlib.metadata
import os
import shutil
import subprocess
import sys
import zipfile

import pytest

from param_tools import __version__
from tests.support.paths import TOOLS

BAD = '/n:\n  ros__parameters:\n    a: [1, x]\n'


@pytest.fixture(scope='module')
def python(tmp_path_factory):
    """Install the wheel and PyYAML, and nothing else, into an empty environment; return its Python."""
    folder = tmp_path_factory.mktemp('alone')
    # setuptools leaves files beside what it builds.
    copy = shutil.copytree(TOOLS, folder / 'param_tools', ignore=shutil.ignore_patterns('__pycache__'))
    pip = [sys.executable, '-m', 'pip', '--quiet', '--disable-pip-version-check']
    subprocess.run([*pip, 'wheel', '--no-deps', '--no-build-isolation', '--wheel-dir', folder, copy], check=True)
    subprocess.run([sys.executable, '-m', 'venv', '--without-pip', folder / 'venv'], check=True)
    python = folder / 'venv' / 'bin' / 'python'
    wheel = folder / f'param_tools-{__version__}-py3-none-any.whl'
    with zipfile.ZipFile(wheel) as archive:
        assert {str(path.relative_to(TOOLS.parent)) for ending in ('py', 'css', 'js', 'xml', 'txt')
                for path in TOOLS.rglob(f'*.{ending}') if 'build' not in path.parts} <= set(archive.namelist())
    subprocess.run([*pip, '--python', python, 'install', '--no-index', '--no-deps', wheel], check=True)
    packages, = (folder / 'venv').glob('lib/python*/site-packages')
    for file in importlib.metadata.files('pyyaml'):
        (packages / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file.locate(), packages / file)
    return python


@pytest.mark.parametrize(('words', 'status', 'said'), [
    (['good.yaml'], 0, ''),
    (['bad.yaml'], 1, 'bad.yaml:3:12: unreadable: rcl rejects the file here: the elements of a must all be'),
    (['good.yaml', '--against', '/n'], 2, 'This needs ROS, and Python finds no rclpy'),
])
def test_files_are_checked_with_nothing_but_pyyaml(python, tmp_path, words, status, said):
    (tmp_path / 'bad.yaml').write_text(BAD)
    (tmp_path / 'good.yaml').write_text(BAD.replace('x', '2'))
    done = subprocess.run([python, '-m', 'param_tools', 'check', *words], cwd=tmp_path, capture_output=True, text=True,
                          env={'PATH': os.defpath, 'HOME': str(tmp_path), 'LANG': 'C.UTF-8'})
    assert done.returncode == status, done.stderr
    assert (done.stdout + done.stderr).startswith(said)
    assert 'Traceback' not in done.stderr
