"""Make .venv in this checkout from the lock file, or say in one sentence why that can't be done.

`make lab` and `make test` run this before anything else, with whatever `python3` there is. It therefore uses the
standard library only, keeps to the syntax of Python 3.6, and downloads nothing until every check has passed.

A stamp, written last, says what .venv was made from. While it holds, a run does nothing; without it, after an
interruption or a change of the lock, .venv is made afresh.
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

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), os.pardir))
LOCK = os.path.join('environment', 'requirements.lock')
PROJECT = 'pyproject.toml'
STAMP = 'param_tutorial_setup.json'

OLDEST, NEWEST = (3, 10), (3, 14)
# Tried in this order when `python3` itself won't do; the middle ones have had the most use.
FALLBACKS = ('python3.12', 'python3.13', 'python3.11', 'python3.10', 'python3.14')
# 0.7 GB installed, and pip unpacks its downloads beside that.
BYTES_NEEDED = 2 * 10**9
# The wheels are tagged manylinux_2_28.
OLDEST_GLIBC = (2, 28)


UNISOLATED = ('--no-deps', '--no-build-isolation', '--use-pep517')


class SetupError(Exception):
    """A sentence for the learner; printed without a traceback."""


def facts():
    """Describe the interpreter that runs this, and its system; printed as JSON for the one that asks."""
    libc = ''
    with contextlib.suppress(AttributeError, OSError, ValueError):
        libc = os.confstr('CS_GNU_LIBC_VERSION') or ''
    return {
        'python': sys.executable,
        'system': platform.system(),
        'machine': platform.machine(),
        'libc': libc,
        'implementation': platform.python_implementation(),
        'version': list(sys.version_info[:3]),
        'pointer_bits': 64 if sys.maxsize > 2**32 else 32,
        # Inside an activated .venv the interpreter behind it counts; a venv made from a venv breaks with the first.
        'base': getattr(sys, '_base_executable', None) or sys.executable,
        'free_threaded': hasattr(sys, 'abiflags') and 't' in sys.abiflags,
        'venv': all(importlib.util.find_spec(name) for name in ('venv', 'ensurepip')),
    }


def system_problem(found):
    """Say what is wrong with the system, or None. No other Python on it could help."""
    elsewhere = 'see environment/README.md for the ways with RoboStack (conda or pixi) and Docker.'
    if found['system'] != 'Linux' or found['machine'] != 'x86_64':
        return (
            f'This set-up needs Linux on x86-64, because ROS 2 wheels exist for nothing else, and this is '
            f'{found["system"]} on {found["machine"]}: {elsewhere}'
        )
    numbers = re.match(r'glibc (\d+)\.(\d+)', found['libc'])
    if not numbers:
        return f'This set-up needs a Linux with glibc, and this one has another C library (musl?): {elsewhere}'
    if tuple(int(number) for number in numbers.groups()) < OLDEST_GLIBC:
        return f'This set-up needs glibc 2.28 or newer, and this system has {found["libc"]}: {elsewhere}'
    return None


def python_problem(found):
    """Say what is wrong with this interpreter, or None. Another one may do."""
    version = '.'.join(str(number) for number in found['version'])
    if found['implementation'] != 'CPython' or not OLDEST <= tuple(found['version'][:2]) <= NEWEST:
        return (
            f'The course needs CPython 3.10 to 3.14, and {found["python"]} is {found["implementation"]} {version}: '
            f'install one of these and name it, as in `PYTHON=python3.12 make lab`, or see environment/README.md.'
        )
    if found['pointer_bits'] != 64 or found['free_threaded']:
        return (
            f'The course needs a 64-bit CPython with the usual GIL, and {found["python"]} is another build: '
            f'name such a one, as in `PYTHON=python3.12 make lab`, or see environment/README.md.'
        )
    if not found['venv']:
        return (
            f'{found["python"]} comes without venv or ensurepip: '
            f'`sudo apt install python3-venv` adds them on Debian and Ubuntu; environment/README.md has other ways.'
        )
    return None


def place_problem(root, free_bytes=None):
    """Say why .venv can't be made in this folder, or None."""
    if not os.access(root, os.W_OK):
        return f"The folder {root} can't be written to: copy or clone the course to a folder of your own."
    if ':' in root:
        return f"Python can't make a virtual environment below a folder with a colon in its name: move {root}."
    if free_bytes is None:
        free_bytes = shutil.disk_usage(root).free
    if free_bytes < BYTES_NEEDED:
        return (
            f'The disk that holds {root} has {free_bytes / 1e9:.1f} GB free and the set-up needs '
            f'{BYTES_NEEDED / 1e9:.1f} GB: make room, or clone the course to another disk.'
        )
    if os.path.isdir(venv_path(root)) and os.listdir(venv_path(root)) and read_stamp(root) is None:
        return (
            f'{venv_path(root)} was not made by this course, so it is left alone: '
            f'move it away or delete it, then try again.'
        )
    return None


def ask(python):
    """Return the facts of another interpreter, or None when it doesn't run."""
    path = shutil.which(python)
    if path is None:
        return None
    # A name found may still be a stub, such as pyenv's shim of a version that isn't selected.
    done = subprocess.run(
        [path, os.path.abspath(__file__), '--facts'],
        env=clean_environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        check=False,
    )
    try:
        return json.loads(done.stdout.decode())
    except ValueError:
        return None


def choose_python(wanted=None, own=None):
    """Return the facts of the interpreter to use, or raise the sentence that says why there is none."""
    if wanted:
        found = ask(wanted)
        if found is None:
            raise SetupError(
                f'PYTHON={wanted} does not run as Python 3.6 or newer: '
                f'name an interpreter of CPython 3.10 to 3.14, as in `PYTHON=python3.12 make lab`.'
            )
        problem = python_problem(found)
        if problem:
            raise SetupError(problem)
        return found
    own = own or facts()
    problem = python_problem(own)
    if problem is None:
        return own
    for name in FALLBACKS:
        found = ask(name)
        if found is not None and python_problem(found) is None:
            return found
    raise SetupError(problem)


def clean_environment():
    """Return this process's environment without what would lead another Python astray.

    A sourced ROS sets PYTHONPATH, an activated environment may set PYTHONHOME, and the ROS wheels leave word that the
    libraries of *some* environment are on the path already.
    """
    drop = ('PYTHONPATH', 'PYTHONHOME', '_ROS_WHEELS_BOOTSTRAP_COMPLETE', '__PYVENV_LAUNCHER__')
    # Options of the user's that would send the packages somewhere else, or refuse them.
    drop += ('PIP_USER', 'PIP_TARGET', 'PIP_PREFIX', 'PIP_ROOT', 'PIP_CONSTRAINT', 'PIP_DRY_RUN')
    return {name: value for name, value in os.environ.items() if name not in drop}


def venv_path(root):
    return os.path.join(root, '.venv')


def venv_python(root):
    return os.path.join(venv_path(root), 'bin', 'python')


def digest(path):
    with open(path, 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


def wanted_stamp(root, python):
    """Return what the stamp says when .venv is up to date."""
    return {
        'lock': digest(os.path.join(root, LOCK)),
        'project': digest(os.path.join(root, PROJECT)),
        # Scripts in .venv/bin hold the folder's path, so a checkout that was moved or copied needs a new one.
        'folder': os.path.realpath(venv_path(root)),
        # A system upgrade can put another Python behind the name that .venv links to.
        'python': os.path.realpath(python),
    }


def read_stamp(root):
    try:
        with open(os.path.join(venv_path(root), STAMP), encoding='utf-8') as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


def write_stamp(root, stamp):
    path = os.path.join(venv_path(root), STAMP)
    with open(path + '.new', 'w', encoding='utf-8') as file:
        json.dump(stamp, file, indent=1)
    os.replace(path + '.new', path)


def outdated(root, wanted=None):
    """Return what is out of date: "venv", "project" (the course's own metadata) or None; quick, as every run asks."""
    stamp = read_stamp(root)
    if stamp is None or not os.path.exists(venv_python(root)):
        return 'venv'
    expected = wanted_stamp(root, venv_python(root))
    if any(stamp.get(key) != expected[key] for key in ('lock', 'folder', 'python')):
        return 'venv'
    if wanted and os.path.realpath(choose_python(wanted)['base']) != stamp['python']:
        return 'venv'
    return None if stamp == expected else 'project'


def say(text):
    print(text, flush=True)


def run_pip(root, arguments, total=None):
    """Run .venv's pip, showing a count of packages in place of its hundreds of lines."""
    command = [venv_python(root), '-I', '-m', 'pip', 'install', '--disable-pip-version-check', '--no-input']
    lines, seen, on_screen = [], 0, sys.stdout.isatty()
    with subprocess.Popen(
        command + arguments,
        cwd=root,
        env=clean_environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
    ) as process:
        for line in process.stdout:
            lines.append(line.rstrip())
            if not total:
                continue
            if line.startswith('Collecting '):
                seen += 1
                if on_screen:
                    print(f'\r  {seen} of about {total} packages fetched', end='', flush=True)
                elif seen % 50 == 0:
                    say(f'  {seen} of about {total} packages fetched')
            elif line.startswith('Installing collected packages'):
                say(('\r' if on_screen else '') + f'  {seen} of about {total} packages fetched; unpacking them')
    if process.returncode != 0:
        say('\n'.join(lines[-15:]))
        raise SetupError(
            'pip could not install the packages, for the reason above; '
            'nothing is left half done, so run the same command again once that is put right.'
        )


@contextlib.contextmanager
def only_one(root):
    """Let one set-up of this checkout run at a time; a second one waits, then finds the work done."""
    import fcntl  # not on Windows, where the checks end the run before this

    with open(os.path.join(root, 'environment', '.setup.lock'), 'w', encoding='utf-8') as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            say('Another set-up of this checkout is running; waiting for it to end.')
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def setuptools_pins(lock):
    """Return the lock's entry for setuptools, by itself."""
    return ''.join(re.findall(r'^setuptools==.*\n(?: .*\n)+', lock, flags=re.MULTILINE))


def check_imports(root):
    """Import once what every lesson needs, so that a broken library is found now and not in a lesson."""
    done = subprocess.run(
        [venv_python(root), '-I', '-c', 'import ipywidgets, jupyterlab, param_tutorial, rclpy'],
        env=clean_environment(),
        check=False,
    )
    if done.returncode != 0:
        raise SetupError("The packages are installed but can't be imported, for the reason above.")


def make_venv(root, python):
    """Make .venv afresh and fill it; the stamp is written when everything is in place."""
    with open(os.path.join(root, LOCK), encoding='utf-8') as file:
        lock = file.read()
    say(f'Setting up .venv with {python} (once; about 150 MB to download).')
    stamp = wanted_stamp(root, python)
    os.makedirs(venv_path(root), exist_ok=True)
    # From here on the folder is ours, finished or not: one without this file is never touched.
    write_stamp(root, {'unfinished': True})
    for entry in os.scandir(venv_path(root)):
        if entry.is_dir(follow_symlinks=False):
            shutil.rmtree(entry.path)
        elif entry.name != STAMP:
            os.remove(entry.path)
    made = subprocess.run([python, '-I', '-m', 'venv', venv_path(root)], env=clean_environment(), check=False)
    if made.returncode != 0:
        raise SetupError(f'{python} could not make a virtual environment, for the reason above.')

    # One dependency, empy, is published as source only. The locked setuptools builds it, and the course itself;
    # pip's build isolation would fetch another, unlocked one for that.
    pins = os.path.join(venv_path(root), 'setuptools.txt')
    with open(pins, 'w', encoding='utf-8') as file:
        file.write(setuptools_pins(lock))
    run_pip(root, ['--no-deps', '--require-hashes', '-r', pins])
    names = set(re.findall(r'^([a-z0-9-]+)==', lock, flags=re.MULTILINE))
    run_pip(root, [*UNISOLATED, '--require-hashes', '-r', LOCK], total=len(names))
    run_pip(root, [*UNISOLATED, '--editable', '.'])

    check_imports(root)
    write_stamp(root, stamp)
    say('The set-up is done.')


def refresh_project(root):
    """Install the course itself again, after a change of its metadata; the packages it needs are as locked."""
    stamp = wanted_stamp(root, venv_python(root))
    run_pip(root, [*UNISOLATED, '--editable', '.'])
    write_stamp(root, stamp)


def set_up(root, wanted=None):
    """Bring .venv up to date, or raise the sentence that says why that can't be."""
    if outdated(root, wanted) is None:
        return
    problem = system_problem(facts())
    if problem:
        raise SetupError(problem)
    python = choose_python(wanted)['base']
    problem = place_problem(root)
    if problem:
        raise SetupError(problem)
    with only_one(root):
        # Asked again, for another run may have done the work while this one waited.
        part = outdated(root, wanted)
        if part == 'venv':
            make_venv(root, python)
        elif part == 'project':
            refresh_project(root)


def main(arguments):
    if arguments == ['--facts']:
        print(json.dumps(facts()))
        return 0
    try:
        set_up(ROOT, os.environ.get('PYTHON'))
    except SetupError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print('\nStopped; the next run starts the set-up again.', file=sys.stderr)
        return 130
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
