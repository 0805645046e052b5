"""The words of the course that are explained where they stand: ``terms.js`` marks them in the text.

A page of the website holds them in a script; a notebook in JupyterLab gets them from its kernel, with its first cell.
"""

import re
from typing import Any

import traitlets

from param_tools.markup.scripts import bundle
from param_tools.markup.styles import sheet
from param_tools.markup.tables import with_code
from param_tools.panel.front import Front
from param_tutorial.notebook.glossary import Glossary

# The text has them in their everyday sense, too.
_EVERYDAY = frozenset((
    'alias', 'block', 'clamp', 'client', 'constant', 'convert', 'deadline', 'depth', 'difference', 'dump', 'fleet',
    'future', 'gain', 'graph', 'group', 'history', 'left', 'load', 'log', 'marker', 'master', 'mirror', 'node',
    'parameter', 'range', 'reference', 'reject', 'restore', 'rule', 'scene', 'source', 'stale', 'start value', 'step',
    'tolerance', 'tune', 'type', 'value'))


def words_of(glossary: Glossary) -> dict[str, list[dict[str, Any]]]:
    """Return what each chapter says about a word, as ``terms.js`` takes it."""
    words: dict[str, list[dict[str, Any]]] = {}
    for entry in glossary.entries:
        for word in re.sub(r'\bto ', '', entry.plain_word).split(', '):
            if word not in _EVERYDAY:
                meaning = f'<b>{with_code(entry.word)}</b> · {with_code(entry.meaning)} (chapter {entry.chapter})'
                words.setdefault(word, []).append(
                    {'chapter': entry.chapter, 'code': '`' in entry.word, 'meaning': meaning})
    return words


class Terms(Front):
    """The words of one notebook. It is not shown anywhere: its script finds the notebook by itself."""

    _esm = bundle('param_tutorial/notebook/terms_widget.js')
    _css = sheet('param_tutorial/notebook/terms.css')
    words = traitlets.Dict().tag(sync=True)


_terms: Terms | None = None


def begin() -> None:
    """Explain the words in the notebook, if it is among the chapters. Safe to call more than once."""
    global _terms
    if _terms is None:
        try:
            _terms = Terms(words=words_of(Glossary.of('.')))
        except FileNotFoundError:  # a notebook of the learner's own, somewhere else
            return
