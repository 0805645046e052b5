"""``python -m param_tutorial lab``: JupyterLab on the learner's copies of the chapters, where no ``make`` is.

Any other word goes to the embedded ``ros2``, as after ``python -m param_tools``.
"""

import os
import sys

from param_tools.__main__ import main as run_embedded


def main() -> int:
    """Run the command that the process's arguments say."""
    if sys.argv[1:2] == ['lab']:
        from param_tutorial.learner.command import open_lab

        open_lab(sys.argv[2:])
    # In a terminal of JupyterLab, `ros2` is this command.
    if 'PARAM_TOOLS_STAND_IN' in os.environ:
        from param_tutorial.notebook import newest_kernel

        newest_kernel.join()
    status = run_embedded()
    if sys.argv[1:2] in ([], ['-h'], ['--help']):
        print('\n`python -m param_tutorial lab` starts JupyterLab on your own copies of the chapters.')
    return status


if __name__ == '__main__':
    sys.exit(main())
