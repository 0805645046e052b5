"""Starts the course in a kernel that is itself in the browser: Pyodide, without threads, processes and a network.

The kernel's IPython loads this as an extension before the first cell. From then on rclpy stands on
``param_tools.rcl_in_python``, and nodes live whenever a cell waits, and between the cells.
"""

import asyncio
import json
import os
import sys
from functools import partial
from pathlib import Path
from typing import NoReturn

from IPython.core.interactiveshell import ExecutionResult, InteractiveShell

from param_tools.errors import NoProcessError
from param_tools.rcl_in_python import install
from param_tools.ros import turns
from param_tutorial.learner import progress
from param_tutorial.notebook import kernel_start, stored
from param_tutorial.notebook.shell import NO_SHELL

# Where JupyterLab's own files are seen by the kernel.
_FILES = Path('/drive')
# The cells that can't run here, beside the course's packages.
STORED = 'stored_cells.json'
_LOOK_SEC = 0.05
# asyncio itself keeps no task alive.
_tasks: set[asyncio.Future[None]] = set()


def load_ipython_extension(shell: InteractiveShell) -> None:
    """Make the kernel one that the chapters run in."""
    # A look into this folder asks the page and waits for its answer, so Python looks for a module there last.
    sys.path.sort(key=lambda path: path == '')
    # A page has no network, and no other process in it.
    os.environ.update(ROS_DOMAIN_ID='0', ROS_AUTOMATIC_DISCOVERY_RANGE='LOCALHOST')
    install.install()
    os.environ[progress.VARIABLE] = str(_FILES / progress.FILE)
    cells = Path(__file__).parents[3] / STORED
    stored.offer(json.loads(cells.read_text(encoding='utf-8')))
    for name in ('system', 'getoutput'):
        setattr(shell, name, _run_no_command)
    for name, kind, why in (('%%bash', 'cell', NO_SHELL), ('%%sh', 'cell', NO_SHELL), ('%%script', 'cell', NO_SHELL),
                            ('%pip', 'line', 'there is no network in a web page')):
        shell.magics_manager.register_function(partial(_run_no_command, name, why), kind, name.strip('%'))
    os._exit = partial(_run_no_command, 'os._exit()', "it would end this page's Python")
    host = turns.install()
    shell.events.register('pre_run_cell', lambda _: host.settle())
    shell.events.register('post_run_cell', _after_cell)
    _tasks.add(asyncio.ensure_future(_live(host)))


def _run_no_command(command: str, why: str = NO_SHELL, *_: object, **__: object) -> NoReturn:
    """Say what ``!`` would need, or another command."""
    raise NoProcessError(f'{why}, so {command!r} does not run here')


def _after_cell(result: ExecutionResult) -> None:
    """Say of an error what a page does without, if that is the reason."""
    kernel_start.after_cell(result)
    error = result.error_in_exec
    if isinstance(error, ModuleNotFoundError):
        print(f"Nothing can be installed in a web page, so {error.name} isn't here. In JupyterLab on your own computer "
              '(make lab), it can be installed.', file=sys.stderr)
    elif isinstance(error, RuntimeError) and 'start new thread' in str(error):
        print('A web page has no threads. A timer of a node runs beside the cells here, too.', file=sys.stderr)


async def _live(host: turns.Turns) -> None:
    """Give turns between the cells, from each start of a stage to its end."""
    while True:
        await host.pump()
        await asyncio.sleep(_LOOK_SEC)
