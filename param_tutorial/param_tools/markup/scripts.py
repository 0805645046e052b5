"""The scripts of what the rooms show: ES modules, each beside the markup that it brings to life.

A browser gets one text that imports nothing: anywidget takes a view's script as one string, and a page on a disk may
load no module. A bundler such as esbuild would join the modules too, but its output would have to be in git, since a
learner's clone has to work without a toolchain. These few lines, for the forms of import and export that our modules
use, are less to keep than a second copy of every script.
"""

import posixpath
import re

from param_tools.markup.styles import sheet

_IMPORT = re.compile(r"^import (\{[^}]*\}) from '(\.[^']*)';$", re.MULTILINE)
_EXPORT = re.compile(r'^export (?=(?:async )?(?:class|const|function\*?) (\w+))', re.MULTILINE)
_UNKNOWN = re.compile(r'^(?:import|export(?! default \{))\b.*', re.MULTILINE)


def bundle(entry: str) -> str:
    """Return a module and all that it imports as one module that imports nothing.

    :param entry: As for ``sheet``, e.g. ``'param_tools/panel/panel.js'``.
    :raises FileNotFoundError: a module is not there, or was not installed.
    :raises ValueError: a module imports or exports in another form than ``import {a, b} from './file.js';``, ``export``
        before a class, a constant or a function, and ``export default {…}`` in the entry.
    """
    scopes: dict[str, str] = {}
    text = _linked(entry, scopes)
    return ''.join(scopes.values()) + text


def _linked(path: str, scopes: dict[str, str]) -> str:
    """Return a module that takes what it imports from constants; add those that are missing to ``scopes``.

    :param scopes: For each imported module, in the order in which they run, the constant that holds what it exports.
    """
    def link(found: re.Match[str]) -> str:
        imported = posixpath.normpath(posixpath.join(posixpath.dirname(path), found[2]))
        constant = re.sub(r'\W', '_', imported)
        if imported not in scopes:
            text = _linked(imported, scopes)
            # The names of a module are its own, as they are in the browser's modules.
            scopes[imported] = (f'const {constant} = (() => {{\n{_EXPORT.sub("", text)}\n'
                                f'return {{{", ".join(_EXPORT.findall(text))}}};\n}})();\n')
        return f'const {found[1]} = {constant};'

    text = _IMPORT.sub(link, sheet(path))
    if unknown := _UNKNOWN.search(_EXPORT.sub('', text)):
        raise ValueError(f'{path}: bundle() knows no such form of import or export: {unknown[0]}')
    return text
