"""``python -m param_tutorial.teacher``: the table of a class, and what to talk about next."""

import sys

from param_tutorial.teacher.command import main

if __name__ == '__main__':
    sys.exit(main())
