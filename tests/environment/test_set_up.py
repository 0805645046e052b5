"""The set-up: the real Makefile, script and uv, in small checkouts with a lock of one or two packages."""

import os
import re
import runpy
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.support.paths import ROOT

SCRIPT = ROOT / 'environment' / 'set_up.py'
UV = ROOT / 'build' / 'uv'


def locked(name: str) -> str:
    """Return the real lock's entry for this package."""
    lock = (ROOT / 'environment' / 'requirements-dev.lock').read_text()
    return re.search(rf'^{name}==.*\n(?: .*\n)+', lock, flags=re.MULTILINE)[0]


class Checkout:
    """A small course: the Makefile, the script, its locks, a package that does nothing, and the uv that is here."""

    def __init__(self, root: Path):
        self.root, self.lock = root, root / 'environment' / 'requirements.lock'
        self.lock.parent.mkdir(parents=True)
        shutil.copy(ROOT / 'Makefile', root)
        for path in (SCRIPT, SCRIPT.with_name('requirements-uv.lock')):
            shutil.copy(path, self.lock.parent)
        self.lock.write_text(locked('setuptools'))
        self.lock.with_name('requirements-dev.lock').write_text(locked('setuptools') + locked('ruff'))
        (root / 'pyproject.toml').write_text(
            '[build-system]\nrequires = ["setuptools"]\nbuild-backend = "setuptools.build_meta"\n'
            '[project]\nname = "param-tutorial"\nversion = "1"\n[tool.setuptools]\npy-modules = ["param_tutorial"]\n')
        (root / 'param_tutorial.py').touch()
        (root / 'build').mkdir()
        (root / 'build' / 'uv').symlink_to(UV)

    def make(self, target: str = 'setup', python: str = sys.executable, **variables: str) -> SimpleNamespace:
        """Run a target; the cache of this checkout stands for the network."""
        cache = os.environ.get('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))
        return subprocess.run(
            ['make', '--silent', target, f'PYTHON={python}'], cwd=self.root, capture_output=True, text=True,
            env={'PATH': os.defpath, 'UV_CACHE_DIR': cache, 'UV_OFFLINE': '1', **variables})

    def has(self, module: str) -> bool:
        return subprocess.run([self.root / '.venv/bin/python', '-c', f'import {module}'],
                              stderr=subprocess.DEVNULL).returncode == 0

    def mark(self) -> Path:
        """Return a file put into .venv that is gone when .venv is made afresh."""
        mark = self.root / '.venv' / 'mark'
        mark.touch()
        return mark


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    return Checkout(tmp_path / 'ein Käse')


@pytest.mark.thorough
def test_what_is_there_stays_until_a_lock_or_the_folder_changes(checkout):
    assert checkout.make().stdout.startswith('Setting up .venv')
    assert checkout.has('param_tutorial') and not checkout.has('ruff')
    mark = checkout.mark()
    # Without a word which Python, that of .venv stays.
    assert [checkout.make(python=python).stdout for python in (sys.executable, '')] == ['', '']
    checkout.make('setup-all')
    assert checkout.has('ruff') and mark.exists()
    assert checkout.make().stdout == ''

    checkout.lock.write_text(locked('setuptools') + locked('lark'))
    checkout.make(python='')
    assert checkout.has('lark') and checkout.has('ruff') and not mark.exists()

    checkout.root = checkout.root.rename(checkout.root.with_name('moved'))
    assert checkout.make().stdout.startswith('Setting up .venv')
    assert checkout.has('param_tutorial')


def test_after_a_set_up_that_failed_the_next_one_starts_afresh(checkout):
    good = checkout.lock.read_text()
    checkout.lock.write_text(re.sub('sha256:[0-9a-f]{60}', 'sha256:' + 60 * '0', good))
    failed = checkout.make()
    assert failed.returncode and 'hash' in failed.stderr.lower()
    assert 'run the same command again' in failed.stderr
    mark = checkout.mark()
    checkout.lock.write_text(good)
    # As after an interruption: its Python runs, but not as one of an environment.
    (checkout.root / '.venv' / 'pyvenv.cfg').unlink()
    assert checkout.make(python='').returncode == 0
    assert checkout.has('param_tutorial') and not mark.exists()


def test_a_python_that_will_not_do_is_named(checkout):
    done = checkout.make(python='python3.99')
    assert done.returncode
    assert done.stderr.startswith("The course needs CPython 3.10 to 3.14, and python3.99 isn't one: install one")
    assert not (checkout.root / '.venv').exists()


@pytest.mark.parametrize(('part', 'answer', 'words'), [
    ('platform.machine', lambda: 'aarch64', 'in a browser'),
    ('platform.libc_ver', lambda: ('', ''), 'glibc'),
    ('importlib.util.find_spec', lambda name: None, 'sudo apt install python3-venv'),
])
def test_what_else_is_missing_is_said_in_one_sentence(monkeypatch, part, answer, words):
    script = runpy.run_path(str(SCRIPT))
    script['check_system']()
    monkeypatch.setattr(part, answer)
    with pytest.raises(SystemExit) as error:
        script['check_system']()
    assert words in error.value.code and 'environment/README.md' in error.value.code
