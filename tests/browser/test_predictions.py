"""Predict, then run, in the real JupyterLab: by keyboard, and remembered until the next start."""

import json

import nbformat
import pytest
from playwright.sync_api import expect

from tests.support import lesson
from tests.support.lab import RESTART_KERNEL, CourseLab, LabPage, chromium

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]

CHAPTER = '03_declaring.ipynb'
CELLS = ('# 3\nA question:', "from param_tutorial import exercises\n\nexercises.predict('3-3')", "print('decided')",
         'And a value:', "exercises.predict('6.1-2')", "print('decided too')",
         'What is solved:', "exercises.progress('3')", 'The next one solves it:',
         "from param_tutorial.learner.progress import own_progress\n\n"
         "for number in ('3a', '3b', '3c', '3d'):\n    own_progress().add_solved(number)",
         "exercises.progress('3')")

VEILED = ('# 3\nThe first cell:', '%load_ext param_tutorial\nfrom param_tutorial import exercises',
          'A question:', "exercises.predict('3-3')", "print('decided')", 'What it means:', "print('later')",
          'Still veiled:\n\n## The next part\n\nAnother question:', "exercises.predict('3-2')", "print('second')",
          'What the second means:')
OF_FIRST = ('decided', 'What it means:', 'later', 'Still veiled:')
OF_SECOND = ('second', 'What the second means:')


def expect_shown(page, *, shown=(), hidden=()):
    cells = page.locator('.jp-RenderedMarkdown, .jp-OutputArea-output')
    for text in shown:
        expect(cells.get_by_text(text, exact=True)).to_be_visible()
    for text in hidden:
        expect(cells.get_by_text(text, exact=True)).to_be_hidden()


def run_all_again(lab_page):
    """Run all cells, and wait until each has run anew."""
    lab_page.command('notebook:clear-all-cell-outputs')
    lab_page.run_all()


def test_a_prediction_is_committed_decided_and_remembered(tmp_path):
    lab = CourseLab(tmp_path / 'lab', [])
    lesson.write(lab.course / 'notebooks' / CHAPTER, CELLS)
    notebook = nbformat.read(lab.course / 'notebooks' / CHAPTER, as_version=4)
    notebook.cells += [nbformat.v4.new_code_cell(id=f'check-3{letter}') for letter in 'abd']
    nbformat.write(notebook, lab.course / 'notebooks' / CHAPTER)
    with lab, chromium() as browser:
        lab_page = LabPage(lab, browser, CHAPTER)
        page = lab_page.page
        lab_page.run_cell(1)
        first = page.locator('form.param-predict').first
        commit = first.get_by_role('button', name='Commit')
        expect(commit).to_be_disabled()

        # By keyboard: choose with the arrow keys, which JupyterLab leaves to the group; go on to the button; press it.
        choices = first.get_by_role('radio')
        choices.first.focus()
        page.keyboard.press('Space')
        for chosen in (1, 2, 0):
            page.keyboard.press('ArrowDown')
            expect(choices.nth(chosen)).to_be_focused()
            expect(choices.nth(chosen)).to_be_checked()
        page.keyboard.press('Tab')
        expect(commit).to_be_focused()
        page.keyboard.press('Space')
        # That runs the cell that decides. The sentence stands once, below its output.
        told = 'Not so. To declare is to create'
        expect(first.get_by_role('status')).to_have_text('✗ Not so.')
        expect(choices.first).to_be_disabled()
        assert [each.get_attribute('data-mark') for each in first.locator('label').all()] == ['wrong', None, 'right']
        # JupyterLab scrolls to the next cell; what it was about stands above that.
        below = page.locator('.jp-Cell').nth(2).locator('.param-predict')
        expect(below).to_contain_text(f'✗ {told}')
        expect(below).to_be_in_viewport(ratio=1)

        # After Run All the verdict comes at once, and nothing was held up.
        lab_page.run_all()
        second = page.locator('form.param-predict').nth(1)
        second.get_by_role('textbox').fill('2')
        second.get_by_role('textbox').press('Enter')
        expect(second).to_contain_text('Right. 2.0 and 2.000001')
        expect(page.locator('.param-progress').first).to_contain_text('1 of 6 predictions made, 0 of them right')
        expect(page.locator('.param-progress').last).to_contain_text('Solved.')
        assert lab_page.errors == []
    remembered = json.loads((lab.copies / 'progress.json').read_text())
    assert list(remembered['solved']) == ['3a', '3b', '3c', '3d']
    assert {number: each['right'] for number, each in remembered['predicted'].items()} == {'3-3': False, '6.1-2': True}

    # The next start: the page has a tick, and the file is what it was.
    with lab, chromium() as browser:
        page = browser.new_page()
        page.goto(f'{lab.url}?token={lab.token}')
        page.get_by_text('All chapters', exact=True).click()
        expect(page.get_by_role('row', name='3 ✓ Declaring')).to_be_visible()
    assert json.loads((lab.copies / 'progress.json').read_text()) == remembered


def test_what_follows_is_veiled_until_one_commits_or_skips(tmp_path):
    lab = CourseLab(tmp_path / 'lab', [])
    lesson.write(lab.course / 'notebooks' / CHAPTER, VEILED)
    with lab, chromium() as browser:
        lab_page = LabPage(lab, browser, CHAPTER)
        page = lab_page.page
        expect_shown(page, shown=['What it means:', 'Still veiled:', 'What the second means:'])
        lab_page.run_all()
        first, second = (page.locator('form.param-predict').nth(number) for number in (0, 1))
        expect_shown(page, hidden=OF_FIRST + OF_SECOND, shown=['Another question:'])
        expect(page.get_by_role('heading', name='The next part')).to_be_visible()
        # A screen reader hears that something is hidden, and not what.
        heard = page.locator('.jp-Notebook').aria_snapshot()
        assert heard.count('Hidden until you commit to an answer, or skip.') == len(OF_FIRST + OF_SECOND)
        assert not any(text in heard for text in ('What it means', 'Still veiled', 'What the second means'))
        page.emulate_media(media='print')
        expect_shown(page, shown=OF_FIRST + OF_SECOND)
        page.emulate_media(media='screen')
        expect_shown(page, hidden=OF_FIRST + OF_SECOND)

        second.get_by_role('button', name='Skip').press('Enter')
        expect_shown(page, shown=OF_SECOND, hidden=OF_FIRST)
        expect(second.get_by_role('button', name='Skip')).to_be_focused()
        first.get_by_role('radio').first.check()
        first.get_by_role('button', name='Commit').click()
        expect_shown(page, shown=OF_FIRST + OF_SECOND)
        expect(first.get_by_role('button', name='Skip')).to_be_hidden()
        run_all_again(lab_page)
        lab_page.reload()
        expect_shown(page, shown=OF_FIRST + OF_SECOND)

        # Later JupyterLab complains about what a restart has interrupted.
        assert lab_page.strange_errors() == []

        # The next kernel knows what was committed to. The one that has ended hides nothing.
        page.evaluate(RESTART_KERNEL)
        run_all_again(lab_page)
        expect_shown(page, shown=OF_FIRST, hidden=OF_SECOND)
        page.evaluate(RESTART_KERNEL)
        expect_shown(page, shown=OF_FIRST + OF_SECOND)
        run_all_again(lab_page)
        expect_shown(page, hidden=OF_SECOND)
        lab_page.select_cell(8)
        lab_page.command('notebook:delete-cell')
        expect_shown(page, shown=OF_SECOND)

    lab.environment['PARAM_TUTORIAL_VEIL'] = 'off'
    (lab.copies / 'progress.json').unlink()
    with lab, chromium() as browser:
        lab_page = LabPage(lab, browser, CHAPTER)
        lab_page.run_all()
        expect_shown(lab_page.page, shown=OF_FIRST)
        expect(lab_page.page.get_by_role('button', name='Skip')).to_have_count(0)
