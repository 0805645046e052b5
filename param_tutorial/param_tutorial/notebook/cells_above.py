"""What to do about a name that a cell above would have defined, in a kernel in which that cell has not run.

``make lab`` and the kernel of a page load this as an extension before the first cell.
"""

import re
import sys

from IPython.core.error import UsageError
from IPython.core.interactiveshell import ExecutionResult, InteractiveShell


def load_ipython_extension(shell: InteractiveShell) -> None:
    """Say it below each error about such a name."""
    shell.events.register('post_run_cell', _after_cell)


def _after_cell(result: ExecutionResult) -> None:
    error = result.error_in_exec
    if type(error) is NameError:
        print(f'If a cell above defines {error.name}, run it first: Run → Run All Above Selected Cell.', file=sys.stderr)
    elif isinstance(error, UsageError) and (magic := re.search('`(%%?(ros2|shell)[^`]*)` not found', str(error))):
        print(f'The first cell of the notebook makes {magic[1]} known; run it first: '
              'Run → Run All Above Selected Cell.', file=sys.stderr)
