"""The set-up's checks and its stamp. pip itself is replaced here; `make test` on a fresh clone runs the real one."""

import ast
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from tests.support.paths import ROOT

SCRIPT = ROOT / 'environment' / 'setup_venv.py'
GOOD = {
    'python': '/usr/bin/python3',
    'base': '/usr/bin/python3',
    'system': 'Linux',
    'machine': 'x86_64',
    'libc': 'glibc 2.36',
    'implementation': 'CPython',
    'version': [3, 12, 1],
    'pointer_bits': 64,
    'free_threaded': False,
    'venv': True,
}
# Passes only where something hangs: a machine that does much else beside needs half a minute for a new environment.
DEADLINE_SEC = 180


@pytest.fixture
def setup_venv():
    """A fresh copy of the script as a module, so that a test may replace its parts."""
    spec = importlib.util.spec_from_file_location('setup_venv_under_test', SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def checkout(tmp_path):
    """A folder that looks like a checkout to the script."""
    root = tmp_path / 'a checkout'
    (root / 'environment').mkdir(parents=True)
    shutil.copy(SCRIPT, root / 'environment')
    (root / 'environment' / 'requirements.lock').write_text('six==1.17.0 \\\n    --hash=sha256:00\n')
    (root / 'pyproject.toml').write_text('[project]\n')
    return root


@pytest.fixture
def pip_calls(setup_venv, monkeypatch):
    """Replace pip, and the import of what it would have installed; the list of its calls."""
    calls = []
    run = subprocess.run

    def without_pip(words, **options):
        """Make a real virtual environment; most of the time would go into the pip that nobody calls here."""
        return run([*words, '--without-pip'] if 'venv' in words else words, **options)

    monkeypatch.setattr(subprocess, 'run', without_pip)
    monkeypatch.setattr(setup_venv, 'run_pip', lambda root, arguments, total=None: calls.append(arguments))
    monkeypatch.setattr(setup_venv, 'check_imports', lambda root: None)
    return calls


def run_script(python, root, path, **variables):
    return subprocess.run(
        [python, root / 'environment' / 'setup_venv.py'],
        env={'PATH': str(path), **variables},
        capture_output=True,
        text=True,
        timeout=DEADLINE_SEC,
        check=False,
    )


def is_one_sentence(text):
    return text.count('\n') == 1 and text.endswith('.\n') and 'Traceback' not in text


# The checks


@pytest.mark.parametrize(
    ('change', 'words'),
    [
        ({'system': 'Darwin', 'machine': 'arm64'}, 'Darwin on arm64'),
        ({'system': 'Windows', 'machine': 'AMD64'}, 'Windows on AMD64'),
        ({'machine': 'aarch64'}, 'Linux on aarch64'),
        ({'libc': ''}, 'another C library'),
        ({'libc': 'glibc 2.27'}, 'glibc 2.28 or newer'),
    ],
)
def test_an_unsuitable_system_is_named(setup_venv, change, words):
    problem = setup_venv.system_problem({**GOOD, **change})
    assert words in problem and 'environment/README.md' in problem
    assert is_one_sentence(problem + '\n')


@pytest.mark.parametrize(
    ('change', 'words'),
    [
        ({'version': [3, 9, 18]}, 'is CPython 3.9.18'),
        ({'version': [3, 15, 0]}, 'is CPython 3.15.0'),
        ({'implementation': 'PyPy'}, 'is PyPy 3.12.1'),
        ({'pointer_bits': 32}, '64-bit CPython'),
        ({'free_threaded': True}, 'usual GIL'),
        ({'venv': False}, 'sudo apt install python3-venv'),
    ],
)
def test_an_unsuitable_python_is_named(setup_venv, change, words):
    problem = setup_venv.python_problem({**GOOD, **change})
    assert words in problem and GOOD['python'] in problem
    assert is_one_sentence(problem + '\n')


@pytest.mark.parametrize('minor', range(10, 15))
def test_every_python_of_the_lock_will_do(setup_venv, minor):
    assert setup_venv.system_problem(GOOD) is None
    assert setup_venv.python_problem({**GOOD, 'version': [3, minor, 0]}) is None


def test_this_system_will_do(setup_venv):
    assert setup_venv.system_problem(setup_venv.facts()) is None
    assert setup_venv.python_problem(setup_venv.facts()) is None


def test_an_unsuitable_place_is_named(setup_venv, checkout, monkeypatch):
    assert setup_venv.place_problem(str(checkout)) is None
    assert '0.5 GB free' in setup_venv.place_problem(str(checkout), free_bytes=5 * 10**8)
    with_colon = checkout.with_name('a:b')
    with_colon.mkdir()
    assert 'with a colon' in setup_venv.place_problem(str(with_colon))
    monkeypatch.setattr(os, 'access', lambda path, mode: False)
    assert "can't be written to" in setup_venv.place_problem(str(checkout))


def test_nothing_is_made_or_fetched_when_a_check_fails(setup_venv, checkout, pip_calls, monkeypatch):
    monkeypatch.setattr(setup_venv, 'facts', lambda: {**GOOD, 'system': 'Darwin'})
    with pytest.raises(setup_venv.SetupError, match='Darwin'):
        setup_venv.set_up(str(checkout))
    assert pip_calls == []
    assert not (checkout / '.venv').exists()


# The interpreter


def test_the_script_keeps_to_the_syntax_of_python_3_6():
    ast.parse(SCRIPT.read_text(), feature_version=(3, 6))


def test_old_pythons_say_one_sentence(checkout, tmp_path):
    """Run the script with every old Python that this machine happens to have; a machine may have none."""
    for python in Path.home().glob('.pyenv/versions/3.[6-9].*/bin/python3'):
        done = run_script(python, checkout, tmp_path)
        assert done.returncode == 1
        assert is_one_sentence(done.stderr), done.stderr
        assert 'CPython 3.10 to 3.14' in done.stderr and str(python.parent) in done.stderr
        assert done.stdout == ''
        assert not (checkout / '.venv').exists()


def executable(path, text):
    path.write_text(text)
    path.chmod(0o755)


def test_another_python_is_found_when_python3_will_not_do(setup_venv, tmp_path, monkeypatch):
    # A name that is found but doesn't run, as pyenv's shim of a version that isn't selected.
    executable(tmp_path / 'python3.12', '#!/bin/sh\necho "pyenv: python3.12: command not found" >&2\nexit 127\n')
    executable(tmp_path / 'python3.13', f'#!/bin/sh\nexec {sys.executable} "$@"\n')
    monkeypatch.setenv('PATH', str(tmp_path))
    chosen = setup_venv.choose_python(own={**GOOD, 'version': [3, 8, 18]})
    assert chosen['version'] == list(sys.version_info[:3])


def test_a_python_asked_for_is_used_or_refused_by_name(setup_venv, tmp_path, monkeypatch):
    assert setup_venv.choose_python(sys.executable)['version'] == list(sys.version_info[:3])
    monkeypatch.setenv('PATH', str(tmp_path))
    with pytest.raises(setup_venv.SetupError, match=r'PYTHON=python3\.99 does not run'):
        setup_venv.choose_python('python3.99')


def test_a_python_asked_for_in_vain_is_one_sentence(checkout, tmp_path):
    done = run_script(sys.executable, checkout, tmp_path, PYTHON='python3.99')
    assert done.returncode == 1
    assert is_one_sentence(done.stderr) and 'PYTHON=python3.99' in done.stderr


def test_a_sourced_ros_does_not_reach_the_new_environment(setup_venv, monkeypatch):
    for name in ('PYTHONPATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE', 'PIP_USER'):
        monkeypatch.setenv(name, 'x')
    assert not {'PYTHONPATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE', 'PIP_USER'} & set(setup_venv.clean_environment())


# The stamp


def test_a_second_run_does_nothing(setup_venv, checkout, pip_calls):
    setup_venv.set_up(str(checkout))
    assert [arguments[-1] for arguments in pip_calls][1:] == [setup_venv.LOCK, '.']
    first = list(pip_calls)
    setup_venv.set_up(str(checkout))
    assert pip_calls == first


def test_an_interrupted_set_up_starts_afresh(setup_venv, checkout, pip_calls, monkeypatch):
    with monkeypatch.context() as interrupted:
        interrupted.setattr(setup_venv, 'check_imports', lambda root: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            setup_venv.set_up(str(checkout))
    (checkout / '.venv' / 'half').mkdir()
    assert setup_venv.outdated(str(checkout)) == 'venv'
    setup_venv.set_up(str(checkout))
    assert setup_venv.outdated(str(checkout)) is None
    assert not (checkout / '.venv' / 'half').exists()


def test_a_stale_venv_is_noticed(setup_venv, checkout, pip_calls):
    setup_venv.set_up(str(checkout))
    lock, project = checkout / 'environment' / 'requirements.lock', checkout / 'pyproject.toml'

    before = lock.read_text()
    lock.write_text('six==1.16.0\n')
    assert setup_venv.outdated(str(checkout)) == 'venv'
    lock.write_text(before)
    assert setup_venv.outdated(str(checkout)) is None

    project.write_text('[project]\nname = "other"\n')
    assert setup_venv.outdated(str(checkout)) == 'project'
    pip_calls.clear()
    setup_venv.set_up(str(checkout))
    assert [arguments[-1] for arguments in pip_calls] == ['.']
    assert setup_venv.outdated(str(checkout)) is None

    moved = checkout.with_name('moved')
    checkout.rename(moved)
    assert setup_venv.outdated(str(moved)) == 'venv'
    moved.rename(checkout)
    assert setup_venv.outdated(str(checkout)) is None

    # The Python that it was made with is gone.
    (checkout / '.venv' / 'bin' / 'python').unlink()
    assert setup_venv.outdated(str(checkout)) == 'venv'


def test_a_venv_of_somebody_else_is_left_alone(setup_venv, checkout, pip_calls):
    (checkout / '.venv').mkdir()
    (checkout / '.venv' / 'pyvenv.cfg').write_text('')
    with pytest.raises(setup_venv.SetupError, match='was not made by this course'):
        setup_venv.set_up(str(checkout))
    assert (checkout / '.venv' / 'pyvenv.cfg').exists()
    assert pip_calls == []


def test_two_runs_at_once_make_it_once(setup_venv, checkout, pip_calls, monkeypatch):
    waiting = threading.Event()
    monkeypatch.setattr(setup_venv, 'say', lambda text: waiting.set() if 'waiting for it' in text else None)
    make_venv = setup_venv.make_venv
    made = []

    def make_while_another_waits(root, python):
        assert waiting.wait(DEADLINE_SEC), 'the second run never waited for the first'
        made.append(root)
        make_venv(root, python)

    monkeypatch.setattr(setup_venv, 'make_venv', make_while_another_waits)
    runs = [threading.Thread(target=setup_venv.set_up, args=[str(checkout)]) for _ in range(2)]
    for run in runs:
        run.start()
    for run in runs:
        run.join(DEADLINE_SEC)
    assert made == [str(checkout)]
    assert setup_venv.outdated(str(checkout)) is None


# pip


def test_pip_failing_shows_its_last_words(setup_venv, checkout, capsys):
    (checkout / '.venv' / 'bin').mkdir(parents=True)
    executable(checkout / '.venv' / 'bin' / 'python', '#!/bin/sh\necho "ERROR: no such package"\nexit 1\n')
    with pytest.raises(setup_venv.SetupError, match='for the reason above'):
        setup_venv.run_pip(str(checkout), ['x'])
    assert 'ERROR: no such package' in capsys.readouterr().out


def test_the_lock_pins_the_build_backend(setup_venv):
    pins = setup_venv.setuptools_pins((SCRIPT.parent / 'requirements.lock').read_text())
    assert re.findall(r'^[a-z]\S*', pins, flags=re.MULTILINE) == [re.match(r'setuptools==\S+', pins)[0]]
    assert '--hash=sha256:' in pins
