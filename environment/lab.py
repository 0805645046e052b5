"""Start JupyterLab on the learner's copies of the chapters; `make lab` runs this with .venv's Python.

The copies are in my_lessons/, and are brought up to date first (see param_tutorial/learner). Everything else that
JupyterLab reads or writes lies in the checkout, too: the settings come from environment/jupyter/, and what the learner
changes (theme, layout, history) goes to .venv/jupyter/. The user's own ~/.jupyter, ~/.ipython and kernels take no part,
so a lesson looks the same for everybody and leaves no trace.
"""

import contextlib
import json
import os
import shlex
import shutil
import sys
import urllib.request
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from param_tools.errors import ParameterToolError
from param_tools.ros.environment import drop_missing_middleware
from param_tutorial.learner.copies import LESSONS, Copies
from param_tutorial.learner.progress import VARIABLE

ROOT = Path(__file__).resolve().parent.parent
# Where the course is installed, or for many to read, .venv is not the learner's.
STATE = Path(os.environ[LESSONS], '.jupyter') if os.environ.get(LESSONS) else Path(sys.prefix) / 'jupyter'
TERMINAL = ROOT / 'environment' / 'jupyter' / 'terminal.bash'
OWN_ROS2 = str(ROOT / 'environment' / 'jupyter' / 'bin')
START_PAGE = 'index.md'
# Each of these would bring in settings, extensions or kernels from somewhere else; the last ones are what `make lab`
# hands on, which is not meant for a `make` that the learner runs in a terminal.
FOREIGN = ('JUPYTER_PATH', 'JUPYTERLAB_DIR', 'JUPYTERLAB_SETTINGS_DIR', 'JUPYTERLAB_WORKSPACES_DIR',
           'MAKEFLAGS', 'MAKELEVEL', 'MFLAGS', 'MAKEOVERRIDES', 'ARGS')
# What IPython reads when a kernel starts. Its warnings would stand in the terminal of `make lab`.
KERNEL = {'InteractiveShellApp': {'extensions': ['param_tutorial.notebook.kernel_start']},
          'IPKernelApp': {'log_level': 'ERROR'}}


def prepare() -> list[str]:
    """Bring the copies up to date, and give this process the environment of JupyterLab and its kernels.

    :return: JupyterLab's options.
    """
    copies = Copies.of_learner(ROOT)
    try:
        for sentence in copies.deliver():
            print(sentence, flush=True)
    except ParameterToolError as error:
        sys.exit(str(error))
    # Terminals open where the server runs, and `make -C ..` is then right in each of them.
    os.chdir(copies.folder)
    programs = str(Path(sys.executable).parent)
    drop_missing_middleware()
    for name in FOREIGN:
        os.environ.pop(name, None)
    os.environ |= {
        # So that `!python` in a cell, and `python` in one of JupyterLab's terminals, mean this Python; and `ros2` the
        # course's own, unless there is a genuine one.
        'PATH': os.pathsep.join([programs, os.environ.get('PATH', os.defpath), OWN_ROS2]),
        'PARAM_TUTORIAL_PROGRAMS': programs,
        'PARAM_TOOLS_STAND_IN': OWN_ROS2,
        'VIRTUAL_ENV': sys.prefix,
        # What the learner solves is remembered there; without the variable nothing is remembered.
        VARIABLE: str(copies.progress.path),
        'JUPYTER_CONFIG_PATH': str(ROOT / 'environment' / 'jupyter'),
        'JUPYTER_CONFIG_DIR': str(STATE / 'config'),
        'JUPYTER_DATA_DIR': str(STATE / 'data'),
        'JUPYTER_RUNTIME_DIR': str(STATE / 'runtime'),
        'IPYTHONDIR': str(STATE / 'ipython'),
    }
    # Jupyter does not run as root unless it is told to. In a container or a robot's shell, root is the only user.
    as_root = ['--allow-root'] if hasattr(os, 'geteuid') and os.geteuid() == 0 else []
    # The chapters' commands are bash's, whichever shell the learner has, and its start-up file puts `python` right.
    bash = shutil.which('bash')
    shell = shlex.join([bash, '--rcfile', str(TERMINAL), '-i']) if bash else None
    profile = STATE / 'ipython' / 'profile_default'
    profile.mkdir(parents=True, exist_ok=True)
    (profile / 'ipython_kernel_config.json').write_text(json.dumps(KERNEL))
    return [
        f'--ServerApp.root_dir={copies.folder}',
        f'--NotebookNotary.data_dir={copies.trust}',
        f'--LabApp.default_url=/lab/tree/{START_PAGE}',
        '--LabApp.extension_manager=readonly',
        f'--LabApp.extra_labextensions_path={ROOT / "environment" / "jupyter" / "labextensions"}',
        *([f'--ServerApp.terminado_settings=shell_command={shell}'] if shell else []),
        *as_root,
    ]


def find_running() -> dict[str, Any] | None:
    """Return what Jupyter Server wrote down about the JupyterLab of this course that runs already, if one does."""
    from jupyter_server.serverapp import list_running_servers

    straight = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    for server in list_running_servers(str(STATE / 'runtime')):
        # After a crash, another process may have the server's number.
        with contextlib.suppress(OSError), \
                straight.open(f'{server["url"]}api/status?token={server["token"]}', timeout=5):
            return dict(server)
    return None


def main(arguments: Sequence[str]) -> None:
    """Start JupyterLab and say where it is, or say where it is running already.

    :param arguments: The learner's own, which win over what is set here.
    """
    if {'-h', '--help'} & set(arguments):
        print("ARGS holds JupyterLab's options, such as --no-browser or --port=9999; python -m jupyterlab --help lists "
              'them.')
        return
    options = prepare()
    if running := find_running():
        print(f'JupyterLab is running already; open this address in your browser:\n'
              f'    {running["url"]}lab/tree/{START_PAGE}?token={running["token"]}')
        return
    # Imported here, in the environment that it is to work in.
    from jupyterlab.labapp import LabApp
    from traitlets.config import Config

    # Without these, JupyterLab prints a page of lines that no learner needs.
    quiet = {'log_level': 'ERROR'}
    server = LabApp.initialize_server([*options, *arguments], config=Config({'ServerApp': quiet, 'LabApp': quiet}))
    is_here = server.ip in ('', 'localhost', '0.0.0.0', '::')
    # Printed as soon as it listens.
    server.io_loop.add_callback(
        print, f"JupyterLab is running; open this address if your browser doesn't:\n"
               f'    {server.local_url if is_here else server.public_url}\n'
               f'Press Ctrl+C here twice to stop it.', flush=True)
    # Otherwise Jupyter Server would print the address, too.
    server.identity_provider.token_generated = False
    server.start()


if __name__ == '__main__':
    main(sys.argv[1:])
