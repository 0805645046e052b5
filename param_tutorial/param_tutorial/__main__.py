"""``python -m param_tutorial param list`` and so on: the embedded ``ros2``, as after ``python -m param_tools``."""

import os
import sys

from param_tools.__main__ import main as run_embedded


def main() -> int:
    """Run the command that the process's arguments say."""
    # In a terminal of JupyterLab, `ros2` is this command.
    if 'PARAM_TOOLS_STAND_IN' in os.environ:
        from param_tutorial.notebook import newest_kernel

        newest_kernel.join()
    return run_embedded()


if __name__ == '__main__':
    sys.exit(main())
