"""Predict, then run, in the real JupyterLab: by keyboard, and remembered until the next start."""

import json

import nbformat
import pytest
from playwright.sync_api import expect

from tests.support import lesson
from tests.support.lab import CourseLab, LabPage, chromium

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]

CHAPTER = '03_declaring.ipynb'
CELLS = ('# 3\nA question:', "from param_tutorial import exercises\n\nexercises.predict('3-1')", "print('decided')",
         'And a value:', "exercises.predict('6.1-2')", "print('decided too')",
         'What is solved:', "exercises.progress('3')", 'The next one solves it:',
         "from param_tutorial.learner.progress import own_progress\n\n"
         "for number in ('3a', '3b', '3c', '3d'):\n    own_progress().add_solved(number)",
         "exercises.progress('3')")


def test_a_prediction_is_committed_decided_and_remembered(tmp_path):
    lab = CourseLab(tmp_path / 'lab', [])
    lesson.write(lab.course / 'notebooks' / CHAPTER, CELLS)
    notebook = nbformat.read(lab.course / 'notebooks' / CHAPTER, as_version=4)
    notebook.cells += [nbformat.v4.new_code_cell(id=f'check-3{letter}') for letter in 'abd']
    nbformat.write(notebook, lab.course / 'notebooks' / CHAPTER)
    with lab, chromium() as browser:
        lab_page = LabPage(lab, browser, CHAPTER)
        page = lab_page.page
        lab_page.select_cell(1)
        lab_page.command('notebook:run-cell')
        first = page.locator('.param-predict')
        commit = first.get_by_role('button', name='Commit')
        expect(commit).to_be_disabled()

        # By keyboard: choose, go on to the button, press it.
        first.get_by_role('radio').first.focus()
        page.keyboard.press('Space')
        expect(commit).to_be_enabled()
        # JupyterLab keeps the arrow keys and Enter for itself.
        for _ in range(3):
            page.keyboard.press('Tab')
        page.keyboard.press('Space')
        expect(first).to_contain_text('Now run the next cell.')
        expect(first.get_by_role('radio').first).to_be_disabled()
        # From there Shift+Enter runs the same cell again, and then the one that gives the answer.
        page.keyboard.press('Shift+Enter')
        expect(first).to_contain_text('Now run the next cell.')
        page.keyboard.press('Shift+Enter')
        expect(first).to_contain_text('Not so. A parameter that is not declared')

        # After Run All the verdict comes at once, and nothing was held up.
        lab_page.run_all()
        second = page.locator('.param-predict').nth(1)
        second.get_by_role('textbox').fill('5')
        second.get_by_role('button', name='Commit').click()
        expect(second).to_contain_text('Right. -20, -15')
        expect(page.locator('.param-progress').first).to_contain_text('1 of 7 predictions made, 0 of them right')
        expect(page.locator('.param-praise')).to_have_count(1)
        assert lab_page.errors == []
    remembered = json.loads((lab.copies / 'progress.json').read_text())
    assert list(remembered['solved']) == ['3a', '3b', '3c', '3d']
    assert {number: each['right'] for number, each in remembered['predicted'].items()} == {'3-1': False, '6.1-2': True}

    # The next start: the page has a tick, and the file is what it was.
    with lab, chromium() as browser:
        page = browser.new_page()
        page.goto(f'{lab.url}?token={lab.token}')
        expect(page.get_by_role('row', name='3 ✓ Declaring')).to_be_visible()
    assert json.loads((lab.copies / 'progress.json').read_text()) == remembered
