"""Start JupyterHub for a class; `make hub` runs this with the Python of build/jupyterhub/, which it sets up first."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEARNER = Path(__file__).with_name('learner.py')
# What a learner's account does first of all; if it can, it can do the rest.
PROBE = f'import param_tutorial; open({str(LEARNER)!r})'
# Linux's "nobody", whatever its name is on this machine.
NOBODY = 65_534


def check_access() -> None:
    """Exit with a sentence if the learners' accounts can't run the course."""
    try:
        done = subprocess.run([sys.executable, '-c', PROBE], cwd='/', user=NOBODY, group=NOBODY, extra_groups=[],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        reason = done.returncode and (done.stderr.strip().rpartition('\n')[2] or f'exit status {done.returncode}')
    except PermissionError as error:
        reason = str(error)
    if reason:
        sys.exit(f"The learners' accounts can't run the course ({reason}). They must be able to read all of {ROOT} and "
                 f'to run {os.path.realpath(sys.executable)}: move the course out of a home folder that is closed to '
                 f'others, open it with `chmod -R go+rX`, or choose another Python, as in '
                 f'`make hub PYTHON=/usr/bin/python3`.')


def main(arguments: list[str]) -> None:
    """Become JupyterHub."""
    # A file of the teacher's own takes the place of ours, and may load it with load_subconfig(). It may also give each
    # learner a container, for instance, so who can read what here doesn't matter.
    if not any(word.startswith(('-f', '--config')) for word in arguments):
        # Without root's rights only the own account signs in.
        if os.geteuid() == 0:
            check_access()
        arguments = ['--config', str(Path(__file__).with_name('jupyterhub_config.py')), *arguments]
    os.execv(sys.executable, [sys.executable, '-m', 'jupyterhub', *arguments])


if __name__ == '__main__':
    main(sys.argv[1:])
