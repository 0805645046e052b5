"""claims.md: each claim of the article has one line, and each line leads to cells and tests that are there."""

import re
from typing import NamedTuple

import nbformat

from tests.support.paths import NOTEBOOKS, ROOT
from tests.tools import notebook_lint

TESTS = {path.stem: path.read_text() for path in (ROOT / 'tests').rglob('test_*.py')}
IDS = [f'A{number:03}' for number in range(1, 162)]

SECTION = re.compile(r'`(\d\w*|deeper/\w+)` › (.+)')
TEST = re.compile(r'`(test_\w+)::(test_\w+)`')


class Row(NamedTuple):
    claim: str
    verdict: str
    proofs: list[str]


def rows():
    """Return (id, Row) for each line of the tables."""
    for line in (NOTEBOOKS / 'claims.md').read_text().splitlines():
        if re.match(r'\| A\d', line):
            identifier, claim, verdict, proofs = (each.strip() for each in line[2:].removesuffix('|').split(' | '))
            yield identifier, Row(claim, verdict, [proof.strip() for proof in proofs.split(';') if proof.strip()])


TABLE = dict(rows())


def sections(path):
    """Return the cells of a notebook by the heading under which they stand."""
    found, heading = {}, ''
    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == 'markdown':
            heading = next((title for _, title in reversed(notebook_lint.headings(cell.source))), heading)
        found.setdefault(heading, []).append(cell)
    return found


CHAPTERS = {path.stem: sections(path) for path in NOTEBOOKS.glob('[0-9]*.ipynb')}
CHAPTERS |= {f'deeper/{path.stem}': sections(path) for path in (NOTEBOOKS / 'deeper').glob('*.ipynb')}
SECTIONS = [(chapter, heading, cells) for chapter, parts in CHAPTERS.items() for heading, cells in parts.items()]


def test_each_claim_has_one_line_and_is_proved_or_says_why_it_cannot_be():
    assert [identifier for identifier, _ in rows()] == IDS
    for identifier, (claim, verdict, proofs) in TABLE.items():
        kind, _, words = verdict.partition(': ')
        assert claim, identifier
        assert kind in ('true', 'partly', 'false', 'outdated', 'not testable here'), identifier
        assert words or kind == 'true', f'{identifier}: say what is really so, or why it cannot be tested'
        assert proofs or kind == 'not testable here', identifier
        for proof in proofs:
            if section := SECTION.fullmatch(proof):
                chapter, heading = section.groups()
                cells = CHAPTERS.get(chapter, {}).get(heading, [])
                assert any(is_compared(cell) for cell in cells), f'no output is compared there: {proof}'
            else:
                test = TEST.fullmatch(proof)
                assert test and f'\ndef {test[2]}(' in TESTS[test[1]], proof


def is_compared(cell):
    return cell.cell_type == 'code' and bool(cell.outputs) and not notebook_lint.is_not_compared(cell)


def test_a_claim_that_a_chapter_names_is_shown_by_cells():
    for chapter, heading, cells in SECTIONS:
        text = '\n'.join(cell.source for cell in cells if cell.cell_type == 'markdown')
        for identifier in re.findall(r'\bA\d{3}\b', text):
            assert any(SECTION.fullmatch(proof) for proof in TABLE[identifier].proofs), (
                f'{chapter} names {identifier} under {heading!r}: add `{chapter}` › {heading} to its line in claims.md')


def test_a_test_of_claims_names_those_that_lead_to_it():
    for block in TESTS['test_claims'].split('\n\n\n'):
        if name := re.search(r'^def (test_\w+)', block, re.MULTILINE):
            leading = [identifier for identifier, row in TABLE.items() if f'`test_claims::{name[1]}`' in row.proofs]
            assert leading and re.findall(r'A\d{3}', block.splitlines()[0]) == leading, name[1]
