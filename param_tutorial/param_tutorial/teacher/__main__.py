"""``python -m param_tutorial.teacher``: the table and the page of a class, or the plans of the lessons."""

import sys

from param_tutorial.teacher.command import main

if __name__ == '__main__':
    sys.exit(main())
