"""Bring .venv up to date with its lock, or say in one sentence why that can't be done.

`make` runs this before anything else, with whatever `python3` there is. It therefore uses the standard library only,
keeps to the syntax of Python 3.6, and downloads nothing until every check has passed. uv does the work: pip fetches
that one program, with its hash, and uv makes .venv and fills it.

A stamp in .venv, written last, says what .venv was made from. Without it, after an interruption, .venv is made afresh.
"""

import contextlib
import hashlib
import importlib.util
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), os.pardir))
VENV = os.path.join(ROOT, '.venv')
VENV_PYTHON = os.path.join(VENV, 'bin', 'python')
STAMP = os.path.join(VENV, 'param_tutorial_setup.json')
BUILD = os.path.join(ROOT, 'build')
# What a lesson needs; that and what tests, website and lint need; uv.
LEARNER, EVERYTHING, UV = ('environment/requirements{}.lock'.format(part) for part in ('', '-dev', '-uv'))

# Tried in this order when `python3` itself won't do; the first ones have had the most use.
FALLBACKS = ('python3.12', 'python3.13', 'python3.11', 'python3.10', 'python3.14')
# A sourced ROS or an activated environment would lead Python astray, and so would options of the user's that send
# packages somewhere else. What says which index to ask, and how, stays.
FOREIGN = {'PYTHONPATH', 'PYTHONHOME', 'LD_LIBRARY_PATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE', '__PYVENV_LAUNCHER__'}
FOREIGN |= {'PIP_USER', 'PIP_TARGET', 'PIP_PREFIX', 'PIP_ROOT', 'PIP_CONSTRAINT', 'UV_CONSTRAINT', 'UV_OVERRIDE'}
# The cache is in the checkout, so that uv links files in place of copying them, and needs no writable home.
ENVIRONMENT = {'UV_CACHE_DIR': os.path.join(BUILD, 'uv-cache')}
ENVIRONMENT.update((name, value) for name, value in os.environ.items() if name not in FOREIGN)

AGAIN = 'for the reason above: the set-up needs the network; run the same command again once that is put right.'


class SetupError(Exception):
    """A sentence for the learner; printed without a traceback."""


def system_problem():
    """Return what is wrong with this system, or None. No other Python on it could help."""
    libc, version = platform.libc_ver()
    found = platform.system(), platform.machine(), libc
    # The ROS wheels are tagged manylinux_2_28_x86_64.
    if found == ('Linux', 'x86_64', 'glibc') and [int(number) for number in version.split('.')] >= [2, 28]:
        return None
    return (
        f'This set-up needs Linux on x86-64 with glibc 2.28 or newer, because ROS 2 wheels exist for nothing else, and '
        f'this is {platform.platform()}: see environment/README.md for RoboStack (conda or pixi) and Docker.'
    )


def python_problem():
    """Return what is wrong with the Python that runs this, or None. Another one may do."""
    implementation, has_gil = platform.python_implementation(), 't' not in getattr(sys, 'abiflags', '')
    if implementation != 'CPython' or not (3, 10) <= sys.version_info < (3, 15) or sys.maxsize < 2**32 or not has_gil:
        return (
            f'The course needs CPython 3.10 to 3.14, 64-bit and with the usual GIL, and {sys.executable} is '
            f'{implementation} {platform.python_version()}{"" if has_gil else "t"}: install one of these and name it, '
            f'as in `PYTHON=python3.12 make lab`, or see environment/README.md.'
        )
    if not all(map(importlib.util.find_spec, ('venv', 'ensurepip'))):
        return (
            f'{sys.executable} comes without venv or ensurepip: `sudo apt install python3-venv` adds them on Debian '
            f'and Ubuntu; environment/README.md has other ways.'
        )
    return None


def run_with_another_python():
    """Start this script anew with a Python that will do; return if there is none."""
    for path in filter(None, map(shutil.which, FALLBACKS)):
        # A name found may still be a stub, such as pyenv's shim of a version that isn't selected.
        if subprocess.call([path, __file__, '--check'], stderr=subprocess.DEVNULL, env=ENVIRONMENT) == 0:
            os.execve(path, [path] + sys.argv, ENVIRONMENT)


def base_python():
    """Return the interpreter that runs this; inside an activated .venv, the one behind it."""
    return os.path.realpath(getattr(sys, '_base_executable', None) or sys.executable)


def digest(name):
    with open(os.path.join(ROOT, name), 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


def wanted_stamp(lock, python):
    """Return what the stamp says when .venv is up to date."""
    return {
        # Scripts in .venv/bin hold the folder's path, so a checkout that was moved or copied needs a new one.
        'folder': VENV,
        # A system upgrade can put another Python behind the name that .venv links to.
        'python': os.path.realpath(python),
        'locks': [digest(LEARNER), digest(EVERYTHING)],
        'project': digest('pyproject.toml'),
        'installed': lock,
    }


def read_stamp():
    with contextlib.suppress(OSError, ValueError), open(STAMP, encoding='utf-8') as file:
        return json.load(file)
    return None


def write_stamp(stamp):
    with open(STAMP + '.new', 'w', encoding='utf-8') as file:
        json.dump(stamp, file, indent=1)
    os.replace(STAMP + '.new', STAMP)


def run(words, problem):
    """Run a command, which says itself what it does and what goes wrong; raise the sentence if it fails."""
    if subprocess.call(words, cwd=ROOT, env=ENVIRONMENT, close_fds=False) != 0:
        raise SetupError(problem)


def fetch_uv():
    """Return the path of the locked uv, fetched if need be. A file of that name is whole: it is moved there last."""
    with open(os.path.join(ROOT, UV), encoding='utf-8') as file:
        uv = os.path.join(BUILD, 'uv-' + re.search(r'^uv==(\S+)', file.read(), flags=re.MULTILINE).group(1))
    if not os.path.exists(uv):
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            python, made = os.path.join(folder, 'bin', 'python'), os.path.join(folder, 'bin', 'uv')
            run([base_python(), '-I', '-m', 'venv', folder], f"{base_python()} can't run venv, for the reason above.")
            options = ['-qq', '--disable-pip-version-check', '--no-input', '--no-deps', '--require-hashes']
            run([python, '-I', '-m', 'pip', 'install', *options, '-r', UV], 'pip could not fetch uv, ' + AGAIN)
            os.replace(made, uv)
    return uv


def make_venv(uv):
    """Make .venv afresh, with no packages in it."""
    os.makedirs(VENV, exist_ok=True)
    # From here on the folder is ours, finished or not: one without this file is never touched.
    write_stamp({})
    for entry in os.scandir(VENV):
        if entry.is_dir(follow_symlinks=False):
            shutil.rmtree(entry.path)
        elif entry.path != STAMP:
            os.remove(entry.path)
    options = ['--quiet', '--no-project', '--no-python-downloads', '--allow-existing', '--python', base_python()]
    run([uv, 'venv', *options, VENV], f"uv can't make a virtual environment with {base_python()}.")


def install(uv, lock):
    """Put what is locked into .venv, and the course itself; what is there already stays."""
    # Never `uv pip sync`, nor --exact: a ROS wheel has a second package inside, such as rclpy in ros-rclpy. No lock
    # names it, so both would uninstall it, and with it the files of the first.
    # The locked setuptools builds the course itself and empy, the one dependency that is published as source only.
    options = ['--no-deps', '--build-constraints', lock, '--require-build-hashes', '--reinstall-package=param-tutorial']
    options += [] if sys.stderr.isatty() else ['--quiet']
    run(
        [uv, 'pip', 'install', '--python', VENV_PYTHON, *options, '--requirement', lock, '--editable', '.'],
        'uv could not install the packages, ' + AGAIN,
    )
    # So that a broken library is found now and not in a lesson.
    run([VENV_PYTHON, '-I', '-c', 'import param_tutorial'], "The course can't be imported, for the reason above.")


@contextlib.contextmanager
def only_one():
    """Let one set-up of this checkout run at a time; a second one waits, then finds the work done."""
    import fcntl  # not on Windows, where the checks end the run before this

    os.makedirs(BUILD, exist_ok=True)
    with open(os.path.join(BUILD, '.setup.lock'), 'w', encoding='utf-8') as file:
        # uv holds the lock too: it works on when this process is killed.
        os.set_inheritable(file.fileno(), True)
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            print('Another set-up of this checkout is running; waiting for it to end.', flush=True)
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def check(wanted_python):
    """Raise the sentence that says why .venv can't be made here, or start anew with a Python that can."""
    problem = system_problem()
    if problem is None:
        problem = python_problem()
        if problem and not wanted_python:
            run_with_another_python()
    if problem:
        raise SetupError(problem)
    if os.path.isdir(VENV) and os.listdir(VENV) and read_stamp() is None:
        raise SetupError(f'This course did not make {VENV}, so it is left alone: move it away, then try again.')


def outdated(lock, wanted_python):
    """Return what of .venv is out of date: "venv", "packages" or None; quick, as every run asks."""
    stamp = read_stamp()
    if not stamp or not os.path.exists(VENV_PYTHON):
        return 'venv'
    wanted = wanted_stamp(lock, base_python() if wanted_python else VENV_PYTHON)
    if any(stamp.get(key) != wanted[key] for key in ('folder', 'python', 'locks')):
        return 'venv'
    complete = stamp.get('project') == wanted['project'] and stamp.get('installed') in (lock, EVERYTHING)
    return None if complete else 'packages'


def set_up(lock, wanted_python):
    """Bring .venv up to date; nothing else may do so meanwhile."""
    part, stamp = outdated(lock, wanted_python), read_stamp()
    if part is None:
        return
    print('Setting up .venv; the first time there are up to 200 MB to download.', flush=True)
    # What tests and website need stays once it is there.
    lock = EVERYTHING if stamp and stamp.get('installed') == EVERYTHING else lock
    uv = fetch_uv()
    if part == 'venv':
        make_venv(uv)
    write_stamp({})
    install(uv, lock)
    write_stamp(wanted_stamp(lock, VENV_PYTHON))
    print('The set-up is done.', flush=True)


def report(work):
    """Do the work, and return an exit status: what goes wrong is printed in one sentence."""
    try:
        work()
    except SetupError as error:
        print(error, file=sys.stderr)
        return 1
    except OSError as error:
        print(f'The set-up could not write to this checkout: {error}.', file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print('\nStopped; the next run starts the set-up again.', file=sys.stderr)
        return 130
    return 0


def main(arguments):
    if arguments == ['--check']:
        return 1 if python_problem() else 0
    lock, wanted_python = EVERYTHING if arguments == ['--everything'] else LEARNER, os.environ.get('PYTHON')

    def work():
        if outdated(lock, wanted_python):
            check(wanted_python)
            with only_one():
                set_up(lock, wanted_python)

    return report(work)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
