"""The marks on the start page: right, and gone again without a trace."""

import re

from param_tutorial.exercises import CHAPTERS
from param_tutorial.learner.copies import Copies
from param_tutorial.learner.syllabus import read_syllabus
from param_tutorial.learner.ticks import with_ticks, without_ticks
from tests.support.paths import NOTEBOOKS

PAGE = (NOTEBOOKS / 'index.md').read_text()
EXERCISES = {chapter.name: [each.number for each in chapter.exercises] for chapter in CHAPTERS.values()}


def marks(text: str) -> dict[str, str]:
    """Return the mark after the number of each chapter."""
    return {number: mark for number, mark in re.findall(r'^\| ([\d.]+) ?(.*?) \| \[', text, re.MULTILINE)}


def test_every_chapter_has_a_row():
    assert list(marks(PAGE)) == list(CHAPTERS)
    assert set(marks(PAGE).values()) == {''}


def test_the_chapters_name_the_exercises_that_there_are():
    assert list(read_syllabus(NOTEBOOKS).items()) == list(EXERCISES.items())


def test_a_solved_chapter_has_a_tick_and_a_begun_one_says_how_much():
    found = marks(with_ticks(PAGE, EXERCISES, ['3a', '3b', '3c', '3d', '5.2a', '10.4b']))
    assert {number: mark for number, mark in found.items() if mark} == {'3': '✓', '5.2': '1/3', '10.4': '1/2'}


def test_marks_change_and_go():
    begun = with_ticks(PAGE, EXERCISES, ['3b'])
    assert marks(begun)['3'] == '1/4'
    assert marks(with_ticks(begun, EXERCISES, ['3a', '3b', '3c', '3d']))['3'] == '✓'
    assert with_ticks(begun, EXERCISES, []) == without_ticks(begun) == without_ticks(PAGE) == PAGE


def test_our_own_marks_are_no_change_of_the_learners(tmp_path):
    (tmp_path / 'notebooks').mkdir()
    (tmp_path / 'notebooks' / '03_x.ipynb').write_text(
        '{"cells": [{"cell_type": "code", "id": "check-3a", "metadata": {}, "source": "", "outputs": [],'
        ' "execution_count": null}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}')
    (tmp_path / 'notebooks' / 'index.md').write_text('| 3 | [x](03_x.ipynb) | |\n')
    copies = Copies(tmp_path)
    copies.deliver()
    copies.progress.add_solved('3a')
    assert copies.deliver() == []
    page = copies.folder / 'index.md'
    assert page.read_text() == '| 3 ✓ | [x](03_x.ipynb) | |\n'
    (tmp_path / 'notebooks' / 'index.md').write_text('| 3 | [better](03_x.ipynb) | |\n')
    assert copies.deliver() == []
    assert page.read_text() == '| 3 ✓ | [better](03_x.ipynb) | |\n'
