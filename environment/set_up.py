"""Make an environment for Python from locks: `make` runs this first.

    python3 environment/set_up.py .venv requirements.lock

pip fetches one program, uv, and uv fills the folder; both check each download against its hash. A stamp in the folder,
written last, says what the folder was made from. Where it says something else, the folder is made afresh.
"""

import hashlib
import importlib.util
import os
import platform
import signal
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
# This may be the Python of the environment that is to be made afresh, so the one behind it does that.
BASE = os.path.realpath(sys.executable)
SIGN_OF_LIFE_SEC = 2.0
AFRESH = [BASE, '-I', '-m', 'venv', '--clear']


def check_system() -> None:
    """Say in one sentence what is missing. The Makefile has looked at the version of Python."""
    if (platform.system(), platform.machine(), platform.libc_ver()[0]) != ('Linux', 'x86_64', 'glibc'):
        sys.exit(f'This set-up needs Linux on x86-64 with glibc, because ROS 2 wheels exist for nothing else, and this '
                 f'is {platform.platform()}. The course in a browser runs anywhere: see environment/README.md.')
    if not importlib.util.find_spec('ensurepip'):
        sys.exit(f'{sys.executable} comes without venv: `sudo apt install python3-venv` adds it on Debian and Ubuntu; '
                 f'environment/README.md has other ways.')


def run(*words: str | Path) -> None:
    """Run a command, which says itself what goes wrong; each dot is a sign of life while it downloads."""
    with subprocess.Popen(words, cwd=ROOT) as process:
        while True:
            try:
                process.wait(SIGN_OF_LIFE_SEC)
                break
            except subprocess.TimeoutExpired:
                print('.', end='', flush=True)
    if process.returncode:
        sys.exit('\nThe set-up failed, for the reason above. It needs the network; run the same command again once '
                 'that is put right.')


def fetch_uv() -> Path:
    """Return the path of the locked uv, fetched by pip if it isn't here."""
    lock, folder = HERE / 'requirements-uv.lock', ROOT / 'build' / 'uv'
    fetched = folder / lock.name
    if not fetched.exists() or fetched.read_bytes() != lock.read_bytes():
        run(*AFRESH, folder)
        run(folder / 'bin' / 'python', '-I', '-m', 'pip', 'install', '-qq', '--disable-pip-version-check',
            '--no-deps', '--require-hashes', '--requirement', lock)
        fetched.write_bytes(lock.read_bytes())
    return folder / 'bin' / 'uv'


def set_up(folder: Path, locks: list[Path]) -> None:
    """Bring an environment up to date."""
    stamp = folder / 'param_tutorial_setup.txt'
    # Scripts in the environment hold its path, so a checkout that was moved needs a new one.
    wanted = {str(folder), BASE}
    wanted |= {hashlib.sha256(path.read_bytes()).hexdigest() for path in (ROOT / 'pyproject.toml', *locks)}
    made_from = set(stamp.read_text().splitlines()) if stamp.exists() else set()
    if wanted <= made_from:
        return
    check_system()
    print(f'Setting up {folder.relative_to(ROOT)}; the first time there are up to 200 MB to download.', end='',
          flush=True)
    uv = [fetch_uv(), 'pip', 'install', '--quiet', '--no-deps', '--python', folder / 'bin' / 'python']
    folder.mkdir(parents=True, exist_ok=True)
    stamp.write_text('')
    # Where nothing has changed, a further lock adds its packages to those that are there.
    if not made_from or not made_from <= wanted:
        run(*AFRESH, '--without-pip', folder)
    # Never `uv sync`, `uv pip sync` or --exact: a ROS wheel has a second package inside, such as rclpy in ros-rclpy.
    # No lock names it, so each of these would remove it.
    # The locked setuptools builds empy, the one package that is published as source only, and the course itself.
    run(*uv, '--require-hashes', '--build-constraints', locks[0], '--require-build-hashes',
        *(word for lock in locks for word in ('--requirement', lock)))
    run(*uv, '--no-build-isolation', '--editable', '.')
    stamp.write_text('\n'.join(wanted))
    print()


if __name__ == '__main__':
    # Ctrl+C ends this without a traceback.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    # The cache is in the checkout, so that uv links files in place of copying them, and needs no writable home.
    os.environ.setdefault('UV_CACHE_DIR', str(ROOT / 'build' / 'uv-cache'))
    set_up(ROOT / sys.argv[1], [HERE / name for name in sys.argv[2:]])
