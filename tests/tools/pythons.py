"""Run the chapters, and the tests that talk to rclpy, on every other CPython from 3.10 to 3.14.

`make test-rare` runs this.

Each version gets an environment under build/pythons/, from the lock and so with the same packages. uv finds the
interpreters on the PATH, and pyenv's. It downloads none: a version that isn't here is named and passed over.
"""

import os
import subprocess
import sys
from pathlib import Path

from tests.support.paths import ROOT

LOCK = ROOT / 'environment' / 'requirements-dev.lock'
# What runs nodes in this process. Browser, website, builds and commands take minutes, and are about others.
TESTS = [*(f'tests/{room}' for room in ('nodes', 'files', 'node', 'systems', 'ros', 'widgets')), 'notebooks']


def main(arguments: list[str]) -> int:
    uv = ROOT / 'build' / 'uv' / 'bin' / 'uv'
    # The names that pyenv puts on the PATH run only versions that were selected.
    pyenv = Path(os.environ.get('PYENV_ROOT', Path.home() / '.pyenv')) / 'versions'
    # An environment inherited from this Python's rclpy would lead the others to this one's libraries.
    environment = {name: value for name, value in os.environ.items()
                   if name not in ('LD_LIBRARY_PATH', '_ROS_WHEELS_BOOTSTRAP_COMPLETE')}
    environment['PATH'] = os.pathsep.join([os.environ['PATH'], *map(str, pyenv.glob('3.*/bin'))])
    environment.setdefault('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))

    def run(*words: str | Path) -> bool:
        return subprocess.run(words, cwd=ROOT, env=environment).returncode == 0

    failed = []
    for version in (f'3.{minor}' for minor in range(10, 15) if minor != sys.version_info.minor):
        folder = ROOT / 'build' / 'pythons' / version
        python = folder / 'bin' / 'python'
        print(f'CPython {version}:', flush=True)
        if not run(uv, 'venv', '--quiet', '--no-project', '--clear', '--no-managed-python', '--no-python-downloads',
                   '--python', f'cpython@{version}', folder):
            continue
        if not (run(uv, 'pip', 'install', '--quiet', '--python', python, '--no-deps', '--requirement', LOCK,
                    '--editable', '.', '--build-constraints', LOCK, '--require-build-hashes')
                and run(python, '-m', 'pytest', '-q', '-n', '4', '--dist', 'loadscope', '--nbval',
                        '-m', 'not thorough and not rare', *arguments, *TESTS)):
            failed.append(version)
    print(f'Failed on CPython {" and ".join(failed)}.' if failed else 'All went well.')
    return int(bool(failed))


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
