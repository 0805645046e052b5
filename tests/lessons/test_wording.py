"""A page orders nothing that only a notebook can do.

A chapter says both where they differ: see ``chapter.for_page``. The chapters get their second wordings one by one;
this test knows how many sentences each still lacks, and fails when there is one more.
"""

import re

import nbformat
import pytest

from param_tutorial.lessons.pages.chapter import for_page
from tests.support.paths import NOTEBOOKS

ORDERS = re.compile('|'.join((
    r'\*\*Shift \+ Enter\*\*', r'\b[Rr]un (?:it|this cell|the cell|that cell|both cells|these cells|the next cell)\b',
    r'\bcell above again\b', r'\bFile → New\b', r'\*\*Alt \+ [↑↓]\*\*', r'\b[Rr]estart the kernel\b',
    r'\b[Ss]croll (?:up|back)\b', r'\bwhile (?:it|the robot) drives\b', r'\bpanel above has (?:lost|gained|followed)\b',
    r'\bopen a terminal\b', r'\binterrupt the (?:cell|kernel)\b')))
STILL = {
    '01_what_are_parameters': 8,
    '02_workspace': 2,
    '03_declaring': 1,
    '04_retrieving': 1,
    '05_1_from_the_command_line': 1,
    '05_3_from_another_node': 2,
    '06_2_locks_types_and_order': 1,
    '07_1_saving': 2,
    '10_1_parameter_events': 1,
    '10_2_asking_another_node': 1,
    '10_3_ros2_control': 3,
    '10_5_whole_sets': 2,
}


def orders_in(path):
    return [found.group() for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == 'markdown'
            for found in ORDERS.finditer(for_page(cell.source))]


@pytest.mark.parametrize('path', sorted(NOTEBOOKS.glob('[0-9]*.ipynb')), ids=lambda path: path.stem)
def test_a_page_orders_nothing_that_only_a_notebook_can_do(path):
    assert len(orders_in(path)) <= STILL.get(path.stem, 0), orders_in(path)


def test_a_chapter_says_both():
    text = 'Look. <!-- notebook -->Run this cell.<!-- page: It was run. --> More. <!-- a comment -->'
    assert for_page(text) == 'Look. It was run. More. <!-- a comment -->'
    assert ORDERS.search(text) and not ORDERS.search(for_page(text))
