"""The set-up: the real script and the real uv, in small checkouts with a lock of one or two packages."""

import ast
import importlib.util
import json
import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

from tests.support import missing
from tests.support.paths import ROOT

SCRIPT = ROOT / 'environment' / 'setup_venv.py'
HUB = ROOT / 'environment' / 'jupyterhub' / 'hub.py'


class Checkout:
    """A small course: a script, its locks, a package that does nothing, and the uv that this checkout has."""

    def __init__(self, root: Path):
        self.root = root
        self.started: list[subprocess.Popen[str]] = []
        self.venv = root / '.venv'
        self.python = self.venv / 'bin' / 'python'
        self.script = root / 'environment' / SCRIPT.name
        self.lock = root / 'environment' / 'requirements.lock'
        self.project = root / 'pyproject.toml'
        self.package = root / 'param_tutorial.py'
        self.script.parent.mkdir(parents=True)
        shutil.copy(SCRIPT, self.script)
        shutil.copy(ROOT / 'Makefile', root)
        shutil.copy(ROOT / 'environment' / 'requirements-uv.lock', self.script.parent)
        self.lock.write_text(locked('setuptools'))
        (root / 'environment' / 'requirements-dev.lock').write_text(locked('setuptools') + locked('six'))
        self.project.write_text(
            '[build-system]\nrequires = ["setuptools"]\nbuild-backend = "setuptools.build_meta"\n'
            '[project]\nname = "param-tutorial"\nversion = "1"\n[tool.setuptools]\npy-modules = ["param_tutorial"]\n')
        self.package.touch()
        uv = Path(load(SCRIPT).fetch_uv())
        (root / 'build').mkdir()
        (root / 'build' / uv.name).symlink_to(uv)

    def start(self, *arguments: str, code: str | None = None, python: str | Path = sys.executable,
              **variables: str) -> subprocess.Popen[str]:
        """Start the script, or code that ends by running it; the cache of this checkout stands for the network."""
        cache = os.environ.get('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))
        process = subprocess.Popen(
            [python, *(['-c', code] if code else []), self.script, *arguments], text=True, start_new_session=True,
            env={'PATH': os.defpath, 'UV_CACHE_DIR': cache, 'UV_OFFLINE': '1', **variables},
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.started.append(process)
        return process

    def run(self, *arguments: str, status: int = 0, **options: str | Path) -> SimpleNamespace:
        """Run the script; return what it prints."""
        with self.start(*arguments, **options) as process:
            out, err = process.communicate()
        assert process.returncode == status, out + err
        return SimpleNamespace(out=out, err=err)

    def has(self, module: str) -> bool:
        return subprocess.run([self.python, '-c', f'import {module}'], stderr=subprocess.DEVNULL).returncode == 0

    def mark(self) -> Path:
        """Return a file put into .venv that is gone when .venv is made afresh."""
        mark = self.venv / 'mark'
        mark.touch()
        return mark


def locked(name: str) -> str:
    """Return the real lock's entry for this package."""
    lock = (ROOT / 'environment' / 'requirements-dev.lock').read_text()
    return re.search(rf'^{name}==.*\n(?: .*\n)+', lock, flags=re.MULTILINE)[0]


def load(script: Path) -> ModuleType:
    """Return the script as a new module, so that a test can replace its parts."""
    spec = importlib.util.spec_from_file_location('setup_venv_under_test', script)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def checkout(tmp_path: Path) -> Iterator[Checkout]:
    checkout = Checkout(tmp_path / 'ein Käse')
    yield checkout
    # A failed test may have left one waiting.
    for process in checkout.started:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()


@pytest.fixture
def setup_venv() -> ModuleType:
    return load(SCRIPT)


@pytest.fixture
def blocked(checkout: Checkout) -> Iterator[Path]:
    """A pipe: a set-up reads from it near its end, so it waits there until a test writes to it."""
    pipe = checkout.root / 'pipe'
    os.mkfifo(pipe)
    checkout.package.write_text(f'open({str(pipe)!r}).read()\n')
    return pipe


def is_one_sentence(text: str) -> bool:
    return text.count('\n') == 1 and text.endswith('.\n') and 'Traceback' not in text


# The checks


@pytest.mark.parametrize(('system', 'machine', 'libc', 'described'), [
    ('Darwin', 'arm64', ('', ''), 'macOS-15.0-arm64-arm-64bit'),
    ('Windows', 'AMD64', ('', ''), 'Windows-11-10.0.22631-SP0'),
    ('Linux', 'aarch64', ('glibc', '2.39'), 'Linux-6.8.0-aarch64-with-glibc2.39'),
    ('Linux', 'x86_64', ('', ''), 'Linux-6.8.0-x86_64-with'),
    ('Linux', 'x86_64', ('glibc', '2.27'), 'Linux-4.15.0-x86_64-with-glibc2.27'),
])
def test_an_unsuitable_system_is_named(setup_venv, monkeypatch, system, machine, libc, described):
    answers = {'system': system, 'machine': machine, 'libc_ver': libc, 'platform': described}
    for name, answer in answers.items():
        monkeypatch.setattr(setup_venv.platform, name, lambda answer=answer: answer)
    problem = setup_venv.system_problem()
    assert described in problem and 'environment/README.md' in problem
    assert is_one_sentence(problem + '\n')


@pytest.mark.parametrize(('version', 'maxsize', 'abiflags', 'implementation', 'words'), [
    ((3, 9, 18), 2**63 - 1, '', 'CPython', 'CPython 3.10 to 3.14'),
    ((3, 15, 0), 2**63 - 1, '', 'CPython', 'CPython 3.10 to 3.14'),
    ((3, 12, 1), 2**63 - 1, '', 'PyPy', 'is PyPy'),
    ((3, 12, 1), 2**31 - 1, '', 'CPython', '64-bit'),
    ((3, 13, 0), 2**63 - 1, 't', 'CPython', 'usual GIL'),
])
def test_an_unsuitable_python_is_named(setup_venv, monkeypatch, version, maxsize, abiflags, implementation, words):
    python = SimpleNamespace(executable='/usr/bin/python3', version_info=version, maxsize=maxsize, abiflags=abiflags)
    monkeypatch.setattr(setup_venv, 'sys', python)
    monkeypatch.setattr(setup_venv.platform, 'python_implementation', lambda: implementation)
    problem = setup_venv.python_problem()
    assert words in problem and '/usr/bin/python3' in problem
    assert is_one_sentence(problem + '\n')


def test_a_python_without_venv_is_named(setup_venv, monkeypatch):
    monkeypatch.setattr(setup_venv.importlib.util, 'find_spec', lambda name: None if name == 'ensurepip' else name)
    problem = setup_venv.python_problem()
    assert 'sudo apt install python3-venv' in problem and sys.executable in problem
    assert is_one_sentence(problem + '\n')


@pytest.mark.parametrize('minor', range(10, 15))
def test_every_python_of_the_lock_will_do(setup_venv, monkeypatch, minor):
    assert setup_venv.system_problem() is None
    monkeypatch.setattr(setup_venv, 'sys', SimpleNamespace(version_info=(3, minor, 0), maxsize=2**63 - 1))
    assert setup_venv.python_problem() is None


def test_the_script_keeps_to_the_syntax_of_python_3_6():
    ast.parse(SCRIPT.read_text(), feature_version=(3, 6))


@pytest.mark.slow
def test_old_pythons_say_one_sentence(checkout):
    """Run the script with every old Python that this machine happens to have; a machine may have none."""
    for python in Path.home().glob('.pyenv/versions/3.[6-9].*/bin/python3'):
        said = checkout.run(python=python, status=1, PATH=str(checkout.root))
        assert is_one_sentence(said.err), said.err
        assert 'CPython 3.10 to 3.14' in said.err and str(python.parent) in said.err
        assert said.out == '' and not checkout.venv.exists()


# What makes the script think that it runs on an unsuitable Python.
AS_PYPY = ('import platform, runpy, sys; sys.argv = sys.argv[1:]; platform.python_implementation = lambda: "PyPy"; '
           'runpy.run_path(sys.argv[0], run_name="__main__")')


@pytest.mark.slow
@pytest.mark.thorough
def test_another_python_is_found_when_python3_will_not_do(checkout, tmp_path):
    # A name that is found but doesn't run, as pyenv's shim of a version that isn't selected.
    for name, text in {'python3.12': 'exit 127', 'python3.13': f'exec "{sys.executable}" "$@"'}.items():
        (tmp_path / name).write_text(f'#!/bin/sh\n{text}\n')
        (tmp_path / name).chmod(0o755)
    checkout.run('--everything', code=AS_PYPY, PATH=f'{tmp_path}:{os.defpath}')
    assert checkout.has('six')


def test_no_other_python_is_used_than_the_one_asked_for(checkout, tmp_path):
    (tmp_path / 'python3.12').symlink_to(sys.executable)
    said = checkout.run(code=AS_PYPY, status=1, PATH=str(tmp_path), PYTHON='pypy3')
    assert is_one_sentence(said.err) and 'is PyPy' in said.err
    assert not checkout.venv.exists()


def test_make_names_a_python_that_does_not_run(checkout):
    done = subprocess.run(['make', 'setup', 'PYTHON=python3.99'], cwd=checkout.root, capture_output=True, text=True)
    assert done.returncode and done.stderr.startswith('python3.99 does not run as Python 3: ')


# What .venv is made from


@pytest.mark.slow
@pytest.mark.thorough
def test_a_learner_gets_what_lessons_need_and_the_rest_is_added_when_asked_for(checkout):
    checkout.run()
    assert checkout.has('param_tutorial') and not checkout.has('six')
    mark = checkout.mark()
    checkout.run('--everything')
    assert checkout.has('six') and mark.exists()
    # It stays even though a lesson needs less.
    checkout.project.write_text(checkout.project.read_text() + '# changed\n')
    assert 'is done' in checkout.run().out
    assert checkout.has('six') and mark.exists()
    assert checkout.run('--everything').out == ''


@pytest.mark.slow
@pytest.mark.thorough
def test_a_second_run_does_nothing(checkout):
    assert 'is done' in checkout.run().out
    (checkout.root / 'build').rename(checkout.root / 'gone')
    said = checkout.run()
    assert (said.out, said.err) == ('', '')
    assert not (checkout.root / 'build').exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_a_stale_venv_is_made_afresh(checkout):
    checkout.run()
    mark = checkout.mark()
    checkout.lock.write_text(checkout.lock.read_text() + locked('six'))
    checkout.run()
    assert checkout.has('six') and not mark.exists()

    mark = checkout.mark()
    # The Python that it was made with is gone.
    checkout.python.unlink()
    checkout.run()
    assert checkout.has('param_tutorial') and not mark.exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_the_venv_of_an_older_set_up_is_made_afresh(checkout):
    """Its stamp says other things; it is the course's all the same."""
    checkout.run()
    mark = checkout.mark()
    (checkout.root / '.venv' / 'param_tutorial_setup.json').write_text('{"lock": "0", "folder": "/elsewhere"}')
    checkout.run()
    assert checkout.has('param_tutorial') and not mark.exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_a_checkout_that_was_moved_gets_a_new_venv(checkout):
    checkout.run()
    mark = checkout.mark()
    moved = checkout.root.with_name('moved')
    checkout.root.rename(moved)
    said = subprocess.run([sys.executable, moved / 'environment' / SCRIPT.name], check=True, capture_output=True,
                          text=True, env=os.environ | {'UV_CACHE_DIR': str(ROOT / 'build' / 'uv-cache')})
    assert 'is done' in said.stdout
    assert not (moved / '.venv' / mark.name).exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_another_python_asked_for_makes_it_afresh(checkout):
    """As far as this machine happens to have another one."""
    checkout.run()
    for python in list(Path.home().glob('.pyenv/versions/3.1[0-4].*/bin/python3'))[:2]:
        checkout.run(python=python, PYTHON=str(python))
        version = subprocess.check_output([python, '--version'])
        assert subprocess.check_output([checkout.python, '--version']) == version
        # Without a wish, it stays.
        assert checkout.run().out == ''


@pytest.mark.slow
@pytest.mark.thorough
def test_an_interrupted_set_up_starts_afresh(checkout, blocked):
    with checkout.start() as process, blocked.open('w'):
        os.killpg(process.pid, signal.SIGKILL)
    assert json.loads((checkout.venv / 'param_tutorial_setup.json').read_text()) == {}
    mark = checkout.mark()
    checkout.package.write_text('')
    checkout.run()
    assert checkout.has('param_tutorial') and not mark.exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_two_runs_at_once_make_it_once(checkout, blocked):
    first = checkout.start()
    # This waits until the first run reads from the pipe, and it reads on until the pipe is closed.
    with blocked.open('w'):
        second = checkout.start()
        line = second.stdout.readline()
    said = [run.communicate()[0] for run in (first, second)]
    assert (first.returncode, second.returncode) == (0, 0)
    assert line == 'Another set-up of this checkout is running; waiting for it to end.\n'
    assert 'is done' in said[0] and said[1] == ''


def test_a_venv_of_somebody_else_is_left_alone(checkout):
    checkout.venv.mkdir()
    (checkout.venv / 'pyvenv.cfg').touch()
    said = checkout.run(status=1)
    assert 'did not make' in said.err and is_one_sentence(said.err)
    assert [path.name for path in checkout.venv.iterdir()] == ['pyvenv.cfg']


# What goes wrong on the way


@pytest.mark.slow
def test_a_package_with_another_hash_is_not_installed(checkout):
    checkout.lock.write_text(re.sub('sha256:[0-9a-f]{60}', 'sha256:' + 60 * '0', checkout.lock.read_text()))
    said = checkout.run(status=1)
    assert 'hash' in said.err.lower()
    assert 'run the same command again' in said.err.splitlines()[-1]
    assert not checkout.has('setuptools')


@pytest.mark.slow
@pytest.mark.thorough
def test_a_library_that_is_broken_is_found_at_once(checkout):
    checkout.package.write_text('import no_such_library\n')
    said = checkout.run(status=1)
    assert 'no_such_library' in said.err
    assert said.err.splitlines()[-1] == "The course can't be imported, for the reason above."


def test_a_checkout_that_cannot_be_written_to_is_named(checkout):
    shutil.rmtree(checkout.root / 'build')
    (checkout.root / 'build').touch()
    said = checkout.run(status=1)
    assert is_one_sentence(said.err) and str(checkout.root / 'build') in said.err


@pytest.mark.slow
@pytest.mark.thorough
def test_a_sourced_ros_does_not_reach_the_new_environment(checkout, tmp_path):
    (tmp_path / 'six.py').touch()
    (tmp_path / 'contextlib.py').write_text('raise ImportError("from another Python")\n')
    # As the Makefile does for the script itself.
    code = f'import os, runpy, sys; sys.argv = sys.argv[1:]; os.environ["PYTHONPATH"] = {str(tmp_path)!r}; ' \
           'runpy.run_path(sys.argv[0], run_name="__main__")'
    checkout.run(code=code)
    assert checkout.has('param_tutorial')


# JupyterHub's environment


@pytest.fixture
def hub(checkout: Checkout) -> Checkout:
    """A checkout whose script is that of `make hub`. Its JupyterHub says what it was given, and ends."""
    folder = checkout.root / 'environment' / 'jupyterhub'
    folder.mkdir()
    checkout.script = Path(shutil.copy(HUB, folder))
    (folder / 'learner.py').touch()
    (checkout.root / 'environment' / 'requirements-hub.lock').write_text(locked('six'))
    (checkout.root / 'jupyterhub.py').write_text('import sys\nprint("JupyterHub", *sys.argv[1:])\n')
    checkout.project.write_text(checkout.project.read_text().replace('["param_tutorial"]',
                                                                     '["param_tutorial", "jupyterhub"]'))
    checkout.venv = checkout.root / 'build' / 'jupyterhub'
    checkout.python = checkout.venv / 'bin' / 'python'
    return checkout


@pytest.mark.slow
@pytest.mark.thorough
def test_the_environment_of_jupyterhub_is_made_once(hub):
    assert hub.run('--config', 'own.py').out.splitlines()[-1] == 'JupyterHub --config own.py'
    assert hub.has('param_tutorial') and hub.has('six')
    mark = hub.mark()
    assert hub.run('--config', 'own.py').out == 'JupyterHub --config own.py\n'
    assert mark.exists()


@pytest.mark.slow
@pytest.mark.thorough
def test_the_environment_of_jupyterhub_is_made_afresh_by_another_python_and_in_another_folder(hub):
    hub.run('--config', 'own.py')
    mark, stamp = hub.mark(), hub.venv / 'made_from.json'
    python = os.path.realpath(sys.executable)
    stamp.write_text(stamp.read_text().replace(python, '/usr/bin/python3.99'))
    hub.run('--config', 'own.py')
    assert not mark.exists() and python in stamp.read_text()

    moved = hub.root.with_name('moved')
    hub.root.rename(moved)
    hub.script = moved / hub.script.relative_to(hub.root)
    assert 'Setting up JupyterHub' in hub.run('--config', 'own.py').out


@pytest.mark.slow
@pytest.mark.thorough
def test_a_course_that_other_accounts_cannot_read_is_named_before_jupyterhub_starts(hub):
    """The folders that pytest makes are closed to others."""
    if os.geteuid() != 0:
        missing.skip('only root starts JupyterHub for others')
    said = hub.run(status=1).err
    assert f'must be able to read all of {hub.root}' in said and 'PYTHON=/usr/bin/python3' in said
    assert is_one_sentence(said)
