"""Start JupyterHub for a class; `make hub` runs this with .venv's Python.

JupyterHub gets an environment of its own in build/jupyterhub/: what a learner needs, and the locked JupyterHub. A stamp
in it, written last, says what it was made from.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / 'build' / 'jupyterhub'
PYTHON = FOLDER / 'bin' / 'python'
STAMP = FOLDER / 'made_from.json'
LEARNER = Path(__file__).with_name('learner.py')
# What a learner's account does first of all; if it can, it can do the rest.
PROBE = f'import param_tutorial; open({str(LEARNER)!r})'
# Linux's "nobody", whatever its name is on this machine.
NOBODY = 65_534
LOCKS = ('environment/requirements.lock', 'environment/requirements-hub.lock')

sys.path.insert(0, str(ROOT / 'environment'))
import setup_venv  # noqa: E402


def set_up() -> None:
    """Make the environment if there is none, or one from other locks, by another Python, or in another folder."""
    base = setup_venv.base_python()
    wanted = json.dumps([str(FOLDER), base, *map(setup_venv.digest, LOCKS)])
    if STAMP.exists() and STAMP.read_text() == wanted:
        return
    print('Setting up JupyterHub; the first time there are 20 MB to download.', flush=True)
    shutil.rmtree(FOLDER, ignore_errors=True)
    uv = setup_venv.fetch_uv()
    options = ['--quiet', '--no-project', '--no-python-downloads', '--python', base]
    setup_venv.run([uv, 'venv', *options, str(FOLDER)], f"uv can't make {FOLDER}.")
    # In this order: where both name a package, the hub's lock has the same version.
    requirements = [word for lock in LOCKS for word in ('--requirement', lock)]
    setup_venv.run([uv, 'pip', 'install', '--quiet', '--python', str(PYTHON), '--no-deps', '--build-constraints',
                    LOCKS[0], '--require-build-hashes', *requirements, '--editable', '.'],
                   'uv could not install JupyterHub, ' + setup_venv.AGAIN)
    STAMP.write_text(wanted)


def check_access() -> None:
    """Make sure that the learners' accounts can run the course; without root's rights only the own account signs in.

    :raises SetupError: they can't.
    """
    if os.geteuid() != 0:
        return
    try:
        done = subprocess.run([str(PYTHON), '-c', PROBE], cwd='/', user=NOBODY, group=NOBODY, extra_groups=[],
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        said = done.stderr.strip() or f'exit status {done.returncode}'
        reason = said.rpartition('\n')[2] if done.returncode else ''
    except PermissionError as error:
        reason = str(error)
    if reason:
        raise setup_venv.SetupError(
            f"The learners' accounts can't run the course ({reason}). They must be able to read all of "
            f'{ROOT} and to run {setup_venv.base_python()}: move the course out of a home folder that is '
            f'closed to others, open it with `chmod -R go+rX`, or choose another Python, as in '
            f'`make hub PYTHON=/usr/bin/python3`.')


def main(arguments: list[str]) -> None:
    """Bring the environment up to date, then become JupyterHub."""
    # A file of the teacher's own takes the place of ours, and may load it with load_subconfig().
    own = any(word.startswith(('-f', '--config')) for word in arguments)

    def prepare() -> None:
        with setup_venv.only_one():
            set_up()
        # Their own file may give each learner a container, for instance.
        if not own:
            check_access()

    if status := setup_venv.report(prepare):
        sys.exit(status)
    if not own:
        arguments = ['--config', str(Path(__file__).with_name('jupyterhub_config.py')), *arguments]
    os.execv(PYTHON, [str(PYTHON), '-m', 'jupyterhub', *arguments])


if __name__ == '__main__':
    main(sys.argv[1:])
