"""``python -m param_tutorial.learner``: make one chapter fresh again."""

import sys

from param_tutorial.learner.command import main

if __name__ == '__main__':
    sys.exit(main())
