"""Run the chapters, and the tests that talk to rclpy, on every other CPython that the lock is for.

Each output of a chapter is compared with the stored one, whatever Python that came from.

Each version gets an environment under build/pythons/, from the lock and so with the same packages. uv finds the
interpreters on the PATH, to which those of pyenv are added here. It downloads none: a version that isn't here is named
and passed over.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from tests.support.paths import ROOT

LOCK = ROOT / 'environment' / 'requirements-dev.lock'
MINORS = range(10, 15)
# The chapters, and what runs nodes in this process. Browser, website, builds and commands take minutes, and are about
# others.
TESTS = [*(f'tests/{room}' for room in ('nodes', 'parameters', 'runtime', 'widgets')), 'notebooks']


def find_uv() -> Path:
    """Return the uv that the set-up has fetched."""
    return ROOT / 'build' / 'uv' / 'bin' / 'uv'


def make_environment(uv: Path, version: str) -> Path | None:
    """Return the interpreter of an environment for this version, made if need be; None if the version isn't here."""
    folder = ROOT / 'build' / 'pythons' / version
    made = subprocess.run(
        [uv, 'venv', '--quiet', '--no-project', '--clear', '--no-managed-python', '--no-python-downloads',
         '--python', f'cpython@{version}', folder],
        stderr=subprocess.DEVNULL, check=False)
    if made.returncode:
        shutil.rmtree(folder, ignore_errors=True)
        return None
    python = folder / 'bin' / 'python'
    subprocess.run(
        [uv, 'pip', 'install', '--quiet', '--python', python, '--no-deps', '--requirement', LOCK, '--editable', '.',
         '--build-constraints', LOCK, '--require-build-hashes'],
        cwd=ROOT, check=True)
    return python


def run_tests(python: Path, arguments: list[str]) -> tuple[bool, str]:
    """Return whether the tests passed, and the last line of what pytest said; print all of it if they did not."""
    done = subprocess.run(
        [python, '-m', 'pytest', '-q', '-n', '4', '--dist', 'loadscope', '--no-loadscope-reorder', '--nbval',
         '-m', 'not slow', *arguments, *TESTS],
        cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        print(done.stdout)
    return done.returncode == 0, done.stdout.rstrip().rpartition('\n')[2]


def main(arguments: list[str]) -> int:
    uv, failed = find_uv(), False
    # The names that pyenv puts on the PATH run only versions that were selected.
    kept = (Path(os.environ.get('PYENV_ROOT', Path.home() / '.pyenv')) / 'versions').glob('3.*/bin')
    os.environ['PATH'] = os.pathsep.join([os.environ['PATH'], *map(str, kept)])
    os.environ.setdefault('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))
    # An environment inherited from this Python's rclpy would lead the others to this one's libraries.
    for name in ('LD_LIBRARY_PATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE'):
        os.environ.pop(name, None)
    for minor in MINORS:
        version = f'3.{minor}'
        if minor == sys.version_info.minor:
            print(f'CPython {version}: `make test` runs on it.', flush=True)
            continue
        python = make_environment(uv, version)
        if python is None:
            print(f'CPython {version}: not here.', flush=True)
            continue
        passed, summary = run_tests(python, arguments)
        failed = failed or not passed
        print(f'CPython {version}: {summary}', flush=True)
    return int(failed)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
