"""Hides in JupyterLab what follows a prediction, until the learner commits to an answer or skips it.

Hidden are texts and outputs up to the next heading, or to the next prediction, which hides what follows it. The code
stays. ``veil.js`` does it, in the JupyterLab that the course starts; in any other program nothing is hidden, nor once
the kernel has ended that could show it again. A page of the website hides the same: ``site/scripts/predictions.js``.

A teacher turns it off with ``PARAM_TUTORIAL_VEIL=off`` in the environment, or ``%env`` in a cell above the first one.
"""

import os

import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.panel.front import Front, answer_beside_cells
from param_tutorial.learner.progress import own_progress

VARIABLE = 'PARAM_TUTORIAL_VEIL'


class Veil(Front):
    """The veil of one notebook. It is not shown anywhere: its script finds the notebook by itself."""

    _esm = bundle('param_tutorial/notebook/veil.js')
    _css = sheet('param_tutorial/notebook/veil.css')
    lifted = traitlets.List(traitlets.Unicode()).tag(sync=True)
    """The numbers of the predictions that hide nothing any more."""


_veil: Veil | None = None


def begin() -> None:
    """Hide what follows the predictions that the learner has not committed to. Safe to call more than once."""
    global _veil
    if os.environ.get(VARIABLE) == 'off' or _veil is not None:
        return
    file = own_progress()
    _veil = Veil(lifted=[] if file is None else list(file.read()[0].predicted))
    answer_beside_cells(_veil)


def lift(number: str) -> None:
    """Show what follows a prediction."""
    if _veil is not None and number not in _veil.lifted:
        _veil.lifted = [*_veil.lifted, number]
