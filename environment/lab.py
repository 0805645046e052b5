"""Start JupyterLab on the course; `make lab` runs this with .venv's Python.

Everything that JupyterLab reads or writes lies in the checkout: the settings come from environment/jupyter/, and what
the learner changes (theme, layout, history) goes to .venv/jupyter/. The user's own ~/.jupyter, ~/.ipython and
kernels take no part, so a lesson looks the same for everybody and leaves no trace.
"""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STATE = Path(sys.prefix) / 'jupyter'
START_PAGE = 'notebooks/index.md'
# Each of these would bring in settings, extensions or kernels from somewhere else.
FOREIGN = ('JUPYTER_PATH', 'JUPYTERLAB_DIR', 'JUPYTERLAB_SETTINGS_DIR', 'JUPYTERLAB_WORKSPACES_DIR')


def environment(outer):
    """Return the environment for JupyterLab and its kernels, made from the one outside."""
    return {
        **{name: value for name, value in outer.items() if name not in FOREIGN},
        # So that `python -m param_tutorial` in one of JupyterLab's terminals means this Python.
        'PATH': os.pathsep.join([str(Path(sys.executable).parent), outer.get('PATH', os.defpath)]),
        'VIRTUAL_ENV': sys.prefix,
        'JUPYTER_CONFIG_PATH': str(ROOT / 'environment' / 'jupyter'),
        'JUPYTER_CONFIG_DIR': str(STATE / 'config'),
        'JUPYTER_DATA_DIR': str(STATE / 'data'),
        'JUPYTER_RUNTIME_DIR': str(STATE / 'runtime'),
        'IPYTHONDIR': str(STATE / 'ipython'),
    }


def command(arguments):
    """Return JupyterLab's command line; the learner's own arguments come last, so that they win."""
    # Jupyter refuses to run as root unless told so. In a container or a robot's shell root is the only user there is.
    as_root = ['--allow-root'] if os.geteuid() == 0 else []
    return [
        sys.executable,
        '-m',
        'jupyterlab',
        f'--ServerApp.root_dir={ROOT}',
        f'--LabApp.default_url=/lab/tree/{START_PAGE}',
        '--LabApp.extension_manager=readonly',
        *as_root,
        *arguments,
    ]


if __name__ == '__main__':
    os.execve(sys.executable, command(sys.argv[1:]), environment(os.environ))
