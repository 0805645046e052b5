"""An IPython without a kernel, in the test's own process."""

import contextlib
from collections.abc import Iterator

from IPython.core.interactiveshell import InteractiveShell


@contextlib.contextmanager
def ipython_with_extension() -> Iterator[InteractiveShell]:
    """Yield the IPython of this process with the notebook extension; each use gets a new one."""
    shell = InteractiveShell.instance()
    shell.history_manager.enabled = False  # two test processes would share its database
    shell.run_line_magic('load_ext', 'param_tutorial')
    try:
        yield shell
    finally:
        InteractiveShell.clear_instance()
