"""What a kernel of ``make lab`` has before its first cell, which makes the rest of the course known.

An error about a name that a cell above would have defined, or that a Node has, says so, and of some errors with rclpy
the cause is told. Terminals find its nodes.
"""

import codeop
import re
import sys

from IPython.core.error import UsageError
from IPython.core.interactiveshell import ExecutionResult, InteractiveShell

from param_tools.errors import cause
from param_tutorial.notebook import newest_kernel

_ABOVE = 'run it first (in JupyterLab: Run → Run All Above Selected Cell).'


def load_ipython_extension(shell: InteractiveShell) -> None:
    """Let the kernel begin so; IPython calls this when it starts, as ``environment/lab.py`` tells it."""
    shell.events.register('post_run_cell', after_cell)
    # So that Python says which bracket was never closed, in place of 'incomplete input'.
    shell.compile.flags &= ~getattr(codeop, 'PyCF_ALLOW_INCOMPLETE_INPUT', 0)
    newest_kernel.note_domain()


def after_cell(result: ExecutionResult) -> None:
    """Say below an error which cells to run first, or what the cause is, if it may be one that we know."""
    error = result.error_in_exec
    if result.error_before_exec and (line := re.search(r'^ *(ros2 .*)', getattr(result.info, 'raw_cell', ''), re.M)):
        print(f'A command begins with a percent sign: %{line[1]}', file=sys.stderr)
    if type(error) is NameError:
        node = getattr(sys.modules.get('rclpy.node'), 'Node', None)
        print(f'A Node has {error.name}: do you mean self.{error.name}?' if hasattr(node, str(error.name)) else
              f'If a cell above defines {error.name}, {_ABOVE}', file=sys.stderr)
    elif isinstance(error, UsageError) and (magic := re.search('`(%%?(ros2|shell)[^`]*)` not found', str(error))):
        print(f'The first cell of the notebook makes {magic[1]} known; {_ABOVE}', file=sys.stderr)
    elif error is not None and (why := cause(error)):
        print(f'{why}.', file=sys.stderr)
