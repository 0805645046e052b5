"""Start JupyterLab on the learner's copies of the chapters; `make lab` runs this with .venv's Python.

The copies are in my_lessons/, and are brought up to date first (see param_tutorial/learner). Everything else that
JupyterLab reads or writes lies in the checkout, too: the settings come from environment/jupyter/, and what the learner
changes (theme, layout, history) goes to .venv/jupyter/. The user's own ~/.jupyter, ~/.ipython and kernels take no part,
so a lesson looks the same for everybody and leaves no trace.
"""

import os
import shlex
import shutil
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from param_tutorial.errors import CopiesError
from param_tutorial.learner.copies import LESSONS, Copies
from param_tutorial.learner.progress import VARIABLE

ROOT = Path(__file__).resolve().parent.parent
# Where the course is installed, or for many to read, .venv is not the learner's.
STATE = Path(os.environ[LESSONS], '.jupyter') if os.environ.get(LESSONS) else Path(sys.prefix) / 'jupyter'
TERMINAL = ROOT / 'environment' / 'jupyter' / 'terminal.bash'
START_PAGE = 'index.md'
# Each of these would bring in settings, extensions or kernels from somewhere else; the last ones are what `make lab`
# hands on, which is not meant for a `make` that the learner runs in a terminal.
FOREIGN = ('JUPYTER_PATH', 'JUPYTERLAB_DIR', 'JUPYTERLAB_SETTINGS_DIR', 'JUPYTERLAB_WORKSPACES_DIR',
           'MAKEFLAGS', 'MAKELEVEL', 'MFLAGS', 'MAKEOVERRIDES', 'ARGS')


def environment(outer: Mapping[str, str]) -> dict[str, str]:
    """Return the environment for JupyterLab and its kernels, made from the one outside."""
    programs = str(Path(sys.executable).parent)
    return {
        **{name: value for name, value in outer.items() if name not in FOREIGN},
        # So that `!python` in a cell, and `python` in one of JupyterLab's terminals, mean this Python.
        'PATH': os.pathsep.join([programs, outer.get('PATH', os.defpath)]),
        'PARAM_TUTORIAL_PROGRAMS': programs,
        'VIRTUAL_ENV': sys.prefix,
        # What the learner solves is remembered there; without the variable nothing is remembered.
        VARIABLE: str(Copies.of_learner(ROOT).progress.path),
        'JUPYTER_CONFIG_PATH': str(ROOT / 'environment' / 'jupyter'),
        'JUPYTER_CONFIG_DIR': str(STATE / 'config'),
        'JUPYTER_DATA_DIR': str(STATE / 'data'),
        'JUPYTER_RUNTIME_DIR': str(STATE / 'runtime'),
        'IPYTHONDIR': str(STATE / 'ipython'),
    }


def command(arguments: Sequence[str], program: str) -> list[str]:
    """Return JupyterLab's command line; the learner's own arguments come last, so that they win."""
    copies = Copies.of_learner(ROOT)
    # Jupyter does not run as root unless it is told to. In a container or a robot's shell, root is the only user.
    as_root = ['--allow-root'] if hasattr(os, 'geteuid') and os.geteuid() == 0 else []
    # The chapters' commands are bash's, whichever shell the learner has, and its start-up file puts `python` right.
    bash = shutil.which('bash')
    shell = shlex.join([bash, '--rcfile', str(TERMINAL), '-i']) if bash else None
    terminal = [f'--ServerApp.terminado_settings=shell_command={shell}'] if shell else []
    return [
        sys.executable,
        '-m',
        program,
        f'--ServerApp.root_dir={copies.folder}',
        f'--NotebookNotary.data_dir={copies.trust}',
        f'--LabApp.default_url=/lab/tree/{START_PAGE}',
        '--LabApp.extension_manager=readonly',
        *terminal,
        *as_root,
        *arguments,
    ]


def main(arguments: Sequence[str], program: str = 'jupyterlab') -> None:
    """Bring the copies up to date, then become JupyterLab.

    :param program: The module that starts it; JupyterHub has its own.
    """
    copies = Copies.of_learner(ROOT)
    try:
        for sentence in copies.deliver():
            print(sentence)
    except CopiesError as error:
        sys.exit(str(error))
    sys.stdout.flush()
    # Terminals open where the server runs, and `make -C ..` is then right in each of them.
    os.chdir(copies.folder)
    os.execve(sys.executable, command(arguments, program), environment(os.environ))


if __name__ == '__main__':
    main(sys.argv[1:])
