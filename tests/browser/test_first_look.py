"""What a learner sees first, and what on coming back: `make lab` as it is, in Chromium."""

from pathlib import Path

import nbformat
import pytest
from playwright.sync_api import Browser, Page, expect

from tests.support import lesson
from tests.support.lab import TIMEOUT_SEC, CourseLab, chromium

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]

CHAPTER = '01_what_are_parameters.ipynb'
# JupyterLab takes the style sheet away where it doesn't trust the notebook.
PICTURE = ('from IPython.display import HTML\n\n'
           'HTML(\'<style>.picture { color: rgb(1, 2, 3) }</style><p class="picture">A picture</p>\')')
CELLS = """() => window.jupyterapp.shell.currentWidget.content.widgets.filter(cell => cell.model.type === 'code')
    .map(cell => [cell.model.executionCount, cell.model.outputs.length, cell.model.trusted])"""


def write_chapter(path: Path, first: str) -> None:
    """Write a chapter as the repository has it: run, with an output and a number."""
    lesson.write(path, (first, *lesson.LESSON[1:], 'A picture:', PICTURE))
    notebook = nbformat.read(path, as_version=4)
    for number, cell in enumerate((cell for cell in notebook.cells if cell.cell_type == 'code'), start=1):
        cell.execution_count, cell.outputs = number, [nbformat.v4.new_output('stream', text='an answer\n')]
    nbformat.write(notebook, path)


def open_lab(lab: CourseLab, browser: Browser, path: str = '') -> Page:
    page = browser.new_page(viewport={'width': 1280, 'height': 800})
    page.set_default_timeout(TIMEOUT_SEC * 1000)
    page.goto(f'{lab.url}{path}?token={lab.token}')
    page.wait_for_function('() => window.jupyterapp && window.jupyterapp.restored.then(() => true)')
    return page


def execute(page: Page, command: str) -> None:
    page.evaluate('command => window.jupyterapp.commands.execute(command).then(() => null)', command)


def wait_for_kernel(page: Page) -> None:
    page.wait_for_function("""() => {
        const context = window.jupyterapp.shell.currentWidget.sessionContext;
        return context && context.session && context.session.kernel && context.session.kernel.status === 'idle';
    }""")


def expect_picture(page: Page) -> None:
    expect(page.locator('.picture')).to_have_css('color', 'rgb(1, 2, 3)')


def expect_live_panel(page: Page) -> None:
    expect(page.get_by_label('robot_name', exact=True)).to_have_value('Clawbot')


def test_a_learner_starts_comes_back_and_gets_a_new_version(tmp_path):
    lab = CourseLab(tmp_path / 'lab', [])
    write_chapter(lab.course / 'notebooks' / CHAPTER, '# A lesson\nStart ROS:')
    (lab.course / 'notebooks' / 'conftest.py').touch()
    with lab, chromium() as browser:
        page = open_lab(lab, browser)

        # The start page, and beside it what is the learner's.
        expect(page.get_by_role('heading', name='Mastering ROS 2 Parameters with Python')).to_be_visible()
        names = page.locator('.jp-DirListing-itemText')
        expect(names).to_have_text([CHAPTER, 'index.md'])

        # A chapter without answers and numbers, that JupyterLab trusts.
        page.get_by_role('link', name='Start with chapter 1').click()
        expect(page.get_by_role('heading', name='A lesson')).to_be_visible()
        wait_for_kernel(page)
        assert page.evaluate(CELLS) == [[None, 0, True]] * 4
        expect(page.locator('.jp-OutputArea-output')).to_have_count(0)

        # It runs, is saved, closed and opened again, and nothing of it is lost.
        execute(page, 'notebook:run-all-cells')
        expect_picture(page)
        expect_live_panel(page)
        execute(page, 'docmanager:save')
        execute(page, 'application:close')
        expect(page.locator('.picture')).to_have_count(0)
        page.get_by_role('link', name='Start with chapter 1').click()
        expect_picture(page)
        # A page that gets no word of the kernel's widgets in 4 s gives up on them until it is loaded again: so it is in
        # ipywidgets, and on a busy machine 4 s are short.
        lost = page.get_by_text('Error displaying widget').first
        expect(page.get_by_label('robot_name', exact=True).or_(lost).first).to_be_visible()
        if lost.is_visible():
            page.reload()
        expect_live_panel(page)
        assert [trusted for _, _, trusted in page.evaluate(CELLS)] == [True] * 4

    # The course changes, the learner has changed no cell: the next start brings the new version.
    write_chapter(lab.course / 'notebooks' / CHAPTER, '# A better lesson\nStart ROS:')
    with lab, chromium() as browser:
        page = open_lab(lab, browser, f'lab/tree/{CHAPTER}')
        expect(page.get_by_role('heading', name='A better lesson')).to_be_visible()
        expect(page.locator('.jp-OutputArea-output')).to_have_count(0)
        assert [trusted for _, _, trusted in page.evaluate(CELLS)] == [True] * 4
