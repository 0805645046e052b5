"""What the course adds to JupyterLab: what a notebook shows whose kernel has ended."""

import pytest
from playwright.sync_api import Page, expect

from tests.support import lesson
from tests.support.lab import RESTART_KERNEL, CourseLab, LabPage, wait_for

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]

WORDS = 'The kernel is new. Click here to run this cell, after all cells above it.'
# What the style sheet writes before an element, and before each widget in it that JupyterLab marks with a broken link.
BEFORE = """output => [output, ...output.querySelectorAll('.jupyter-widgets-disconnected')]
    .map(each => getComputedStyle(each, '::before').content).filter(content => content !== 'none')"""


@pytest.fixture
def lab(tmp_path):
    path = tmp_path / 'lesson.ipynb'
    lesson.write(path)
    with CourseLab(tmp_path / 'lab', [path]) as lab:
        yield lab


def panel_output(page: Page):
    """Return the output that shows the panel, or showed it."""
    return page.locator('.jp-CodeCell').nth(1).locator('.jp-OutputArea-output')


def before(page: Page) -> list[str]:
    output = panel_output(page)
    return output.evaluate(BEFORE) if output.count() else ['no output']


def expect_words(page: Page) -> None:
    wait_for(lambda: before(page) == [f'"{WORDS}"'], 'the words on the new kernel')


def expect_live_panel(page: Page) -> None:
    wait_for(lambda: before(page) == [], 'the words to go')
    expect(page.get_by_label('robot_name', exact=True)).to_have_value('Clawbot')


def test_after_a_restart_and_in_a_notebook_opened_again_a_click_brings_a_view_back(lab, browser):
    notebook = LabPage(lab, browser, 'lesson.ipynb')
    page = notebook.page
    notebook.run_all()
    expect_live_panel(page)

    page.evaluate(RESTART_KERNEL)
    expect_words(page)
    # What cannot answer does not take the mouse, so that the click is for the whole output.
    expect(page.locator('.param-reset')).to_have_css('pointer-events', 'none')
    page.get_by_label('robot_name', exact=True).click(force=True)
    expect_live_panel(page)

    notebook.command('docmanager:save')
    lab.end_kernels()
    page.reload()
    notebook._wait_for_kernel()
    expect_words(page)
    # JupyterLab's own words are there, and take no room.
    expect(panel_output(page)).to_have_css('font-size', '0px')
    panel_output(page).click()
    expect_live_panel(page)
