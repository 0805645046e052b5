"""Each sentence of a chapter with *always*, *never*, *every*, *only* or *any* has a line in `sweeping/`.

The line names the cells or tests that decide the sentence; *no claim* says why nothing is to be decided.
"""

import re
from pathlib import Path
from typing import NamedTuple

import nbformat
import pytest

from tests.course.test_claims_table import CHAPTERS, SECTION, TEST, TESTS, is_compared
from tests.support.paths import NOTEBOOKS
from tests.tools import notebook_lint

WORD = re.compile(r'\b(always|never|every|only|any)\b', re.IGNORECASE)
END = re.compile(r'(?<=[.?!:])(?:["”*)_]*)\s+|\n\s*\n|\n\s*(?:- |\d+\. |\|)')
NO_CLAIM = re.compile(r'no claim: \w.+')
CELL = re.compile(r'`([\w-]+)`')
SWEEPING = Path(__file__).parent / 'sweeping'


class Row(NamedTuple):
    cell: str
    words: str
    proofs: list[str]


def table(chapter):
    """Return the rows of a chapter."""
    found = []
    for line in (SWEEPING / f'{chapter}.md').read_text().splitlines():
        if line.startswith('| `'):
            cell, words, proofs = (each.strip() for each in line[2:].removesuffix('|').split(' | '))
            found.append(Row(cell.strip('`'), words, [each.strip() for each in proofs.split(';')]))
    return found


TABLE = {chapter: table(chapter) for chapter in CHAPTERS}


def plain(text):
    return ' '.join(text.split())


def sentences(chapter):
    """Yield (cell id, sentence) for each sentence of the text with such a word, on one line."""
    for cell in nbformat.read(NOTEBOOKS / f'{chapter}.ipynb', as_version=4).cells:
        if cell.cell_type == 'markdown':
            text = notebook_lint.FENCE.sub('', cell.source)
            for sentence in END.split(re.sub(r'\n> ?', '\n', text)):
                if WORD.search(sentence):
                    yield cell.id, plain(sentence)


@pytest.mark.parametrize('chapter', sorted(CHAPTERS))
def test_each_sweeping_sentence_has_a_line(chapter):
    rows = TABLE[chapter]
    missing = [f'{cell} | {sentence}' for cell, sentence in sentences(chapter)
               if not any(row.cell == cell and row.words in sentence for row in rows)]
    assert missing == []


@pytest.mark.parametrize('chapter', sorted(CHAPTERS))
def test_each_line_quotes_a_sentence_and_leads_to_its_proof(chapter):
    said = list(sentences(chapter))
    cells = {cell.id: cell for part in CHAPTERS[chapter].values() for cell in part}
    for row in TABLE[chapter]:
        assert any(row.cell == cell and row.words in sentence for cell, sentence in said), row
        assert WORD.search(row.words), row
        for proof in row.proofs:
            if cell := CELL.fullmatch(proof):
                assert is_compared(cells[cell[1]]), f'no output is compared there: {proof}'
            elif section := SECTION.fullmatch(proof):
                assert any(is_compared(cell) for cell in CHAPTERS[section[1]].get(section[2], [])), proof
            elif test := TEST.fullmatch(proof):
                assert f'\ndef {test[2]}(' in TESTS[test[1]], proof
            else:
                assert NO_CLAIM.fullmatch(proof), f'{row}: name a cell, a section, a test, or say "no claim: why"'
