"""What a learner sees first, and again: `make lab` as it is, in Chromium."""

import json
from collections.abc import Iterator
from pathlib import Path

import nbformat
import pytest
from playwright.sync_api import Browser, Page, expect

from tests.support import lesson
from tests.support.lab import TIMEOUT_SEC, CourseLab, LabPage

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]

# A picture in HTML, as the chapters have them, which JupyterLab cleans of its style sheet where it does not trust it.
CELLS = (*lesson.LESSON, 'A picture:', "from IPython.display import HTML\n\n"
         "HTML('<style>.ours { color: rgb(1, 2, 3) }</style><p class=\"ours\">a picture</p>')")
