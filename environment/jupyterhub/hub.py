"""Start JupyterHub for a class; `make hub` runs this with .venv's Python.

JupyterHub gets an environment of its own in build/jupyterhub/: what a learner needs, and the locked JupyterHub. A stamp
in it, written last, says which locks it was made from.
"""

import os
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / 'build' / 'jupyterhub'
STAMP = FOLDER / 'locks.txt'
LOCKS = ('environment/requirements.lock', 'environment/requirements-hub.lock')

sys.path.insert(0, str(ROOT / 'environment'))
import setup_venv  # noqa: E402


def set_up() -> None:
    """Make the environment if there is none, or one from other locks."""
    wanted = '\n'.join(map(setup_venv.digest, LOCKS))
    if STAMP.exists() and STAMP.read_text() == wanted:
        return
    print('Setting up JupyterHub; the first time there are 20 MB to download.', flush=True)
    shutil.rmtree(FOLDER, ignore_errors=True)
    uv, python = setup_venv.fetch_uv(), str(FOLDER / 'bin' / 'python')
    options = ['--quiet', '--no-project', '--no-python-downloads', '--python', setup_venv.base_python()]
    setup_venv.run([uv, 'venv', *options, str(FOLDER)], f"uv can't make {FOLDER}.")
    # In this order: where both name a package, the hub's lock has the same version.
    requirements = [word for lock in LOCKS for word in ('--requirement', lock)]
    setup_venv.run([uv, 'pip', 'install', '--quiet', '--python', python, '--no-deps', '--build-constraints', LOCKS[0],
                    '--require-build-hashes', *requirements, '--editable', '.'],
                   'uv could not install JupyterHub, ' + setup_venv.AGAIN)
    STAMP.write_text(wanted)


def main(arguments: list[str]) -> None:
    """Bring the environment up to date, then become JupyterHub."""
    try:
        with setup_venv.only_one():
            set_up()
    except setup_venv.SetupError as error:
        sys.exit(str(error))
    python = str(FOLDER / 'bin' / 'python')
    # A file of the teacher's own takes the place of ours, and may load it with load_subconfig().
    if not any(word.startswith(('-f', '--config')) for word in arguments):
        arguments = ['--config', str(Path(__file__).with_name('jupyterhub_config.py')), *arguments]
    os.execv(python, [python, '-m', 'jupyterhub', *arguments])


if __name__ == '__main__':
    main(sys.argv[1:])
