"""Start one learner's JupyterLab for JupyterHub, under that learner's account."""

import os
import sys
from pathlib import Path

# The course's folder is for all to read; what a learner writes is at home.
os.environ['PARAM_TUTORIAL_LESSONS'] = str(Path.home() / 'my_lessons')

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import lab

os.execv(sys.executable, [sys.executable, '-m', 'jupyterhub.singleuser', *lab.prepare(), *sys.argv[1:]])
