"""Joins a script of the site with what it imports, also from npm: a page on a disk can load no modules."""

import os
import subprocess
import sys
from pathlib import Path

from param_tutorial.site.browser.page_python import PYODIDE

_HERE = Path(__file__).parent
_NODE_MODULES = PYODIDE.parent


def bundle(path: str, name: str = '') -> str:
    """Return a module and all that it imports as one script.

    :param path: In this folder, e.g. ``'scripts/main.js'``.
    :param name: The global variable that has what the module exports; by default there is none.
    """
    return subprocess.run(
        [Path(sys.executable).with_name('node'), _NODE_MODULES / 'esbuild/bin/esbuild', _HERE / path,
         '--bundle', '--minify', '--charset=utf8', '--log-level=warning', '--format=iife', f'--global-name={name}'],
        env={**os.environ, 'NODE_PATH': str(_NODE_MODULES)}, check=True, stdout=subprocess.PIPE, text=True).stdout
