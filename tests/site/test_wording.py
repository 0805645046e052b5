"""A page orders nothing that only a notebook can do, and says nothing that is not so on it.

A chapter says both where they differ: see ``chapter.for_page``.
"""

import re

import nbformat
import pytest

from param_tutorial.site.pages.chapter import for_page, output_for_page
from tests.support.paths import NOTEBOOKS

CHAPTERS = sorted(NOTEBOOKS.glob('[0-9]*.ipynb'))
ONLY_IN_A_NOTEBOOK = re.compile('|'.join((
    r'\*\*Shift \+ Enter\*\*', r'\b[Rr]un (?:it|this cell|the cell|that cell|both cells|these cells|the next cell)\b',
    r'\bcell above again\b', r'\bFile → New\b', r'\*\*Alt \+ [↑↓]\*\*', r'\b[Rr]estart the kernel\b',
    r'\b[Ss]croll (?:up|back)\b', r'\b[Oo]pen a terminal\b',
    r'\binterrupt the (?:cell|kernel)\b', r'\bpanel (?:above|further up|near the top|at the top) (?:has|finds|shows)\b',
    r'\bpanel near the top: it shows\b', r'\bpanel in sight\b', r'\bexercises\.hint\(', r'\b[Tt]ry other values\b',
    r'\b[Pp]ress \*(?:Gather|Discard|Undo|Redo)\*', r'\bon your machine\b')))
NOTEBOOK, PAGE = '<!-- notebook -->', '<!-- page:'
# What is before two wordings, the two, and what is after them.
BOTH = re.compile(rf'(.?){NOTEBOOK}(.*?){PAGE}\s*(.*?)\s*-->(.?)', re.DOTALL)


def prose(path):
    return [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == 'markdown']


@pytest.mark.parametrize('path', CHAPTERS, ids=lambda path: path.stem)
def test_a_page_says_nothing_that_only_a_notebook_can_do(path):
    assert [found.group() for text in prose(path) for found in ONLY_IN_A_NOTEBOOK.finditer(for_page(text))] == []


@pytest.mark.parametrize('path', CHAPTERS, ids=lambda path: path.stem)
def test_what_a_cell_put_out_orders_nothing_that_only_a_notebook_can_do(path):
    shown = [output_for_page(output.data['text/html']) for cell in nbformat.read(path, as_version=4).cells
             for output in cell.get('outputs', ()) if 'text/html' in output.get('data', {})]
    orders = re.compile(rf'{ONLY_IN_A_NOTEBOOK.pattern}|\bexercises\.\w+\(|\bmake lab\b')
    assert [found.group() for text in shown for found in orders.finditer(text)] == []
    ticks = [text for text in shown if 'class="param-progress"' in text]
    assert [text for text in ticks if 'In the notebook, what you solve is remembered' not in text] == []


@pytest.mark.parametrize('path', CHAPTERS, ids=lambda path: path.stem)
def test_each_second_wording_is_complete(path):
    for text in prose(path):
        assert text.count(NOTEBOOK) == text.count(PAGE)
        page = for_page(text)
        assert NOTEBOOK not in page and PAGE not in page
        # What a comment begins, Markdown takes for HTML up to the end of the line.
        assert not re.search(rf'^\s*{NOTEBOOK}', text, re.MULTILINE)
        for before, *wordings, after in BOTH.findall(text):
            for wording in wordings:
                # A word that touches what is before it has lost its blank.
                assert not re.search(r'[^\s(]\w', before + wording[:1]), wording
                assert not re.search(r'[^\s(]\w', (wording[-1:] or before) + after), wording


def test_a_chapter_says_both():
    text = 'Look. <!-- notebook -->Run this cell.<!-- page: It was run. --> More. <!-- a comment -->'
    assert for_page(text) == 'Look. It was run. More. <!-- a comment -->'
    assert ONLY_IN_A_NOTEBOOK.search(text) and not ONLY_IN_A_NOTEBOOK.search(for_page(text))
    assert for_page('It ends<!-- notebook -->. Run it<!-- page: -->:') == 'It ends:'
