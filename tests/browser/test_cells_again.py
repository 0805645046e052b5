"""Earlier cells are run again, in any order: no output loses what it shows."""

import pytest

from tests.support.lab import Lab, LabPage, wait_for
from tests.support.paths import NOTEBOOKS

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]

# For each code cell, by its place in the notebook: how many robots and panels it shows.
SHOWN = """() => Object.fromEntries(window.jupyterapp.shell.currentWidget.content.widgets.map((cell, index) =>
    [index, cell.node.querySelectorAll('.robot-drive').length, cell.node.querySelectorAll('.param-head').length])
    .filter(([_, robots, panels]) => robots || panels).map(([index, ...shown]) => [index, shown]))"""
FIRST, PANEL, DRIVE = 2, 4, 6


@pytest.fixture
def page(tmp_path, browser):
    with Lab(tmp_path, [NOTEBOOKS / '01_what_are_parameters.ipynb']) as lab:
        page = LabPage(lab, browser, '01_what_are_parameters.ipynb')
        page.run_all()
        yield page
        page.page.close()


def run_again(page, index):
    """Run a cell, and wait until it has another number and shows something."""
    number = f'window.jupyterapp.shell.currentWidget.content.widgets[{index}].model.executionCount'
    before = page.page.evaluate(number)
    page.select_cell(index)
    page.command('notebook:run-cell')
    wait_for(lambda: (page.page.evaluate(number) or before) > before, f'cell {index} to run')


def test_no_output_goes_blank(page):
    shown = page.page.evaluate(SHOWN)
    assert len(shown) > 7 and shown[str(PANEL)] == [1, 1]
    for index in (PANEL, FIRST, DRIVE, PANEL):
        run_again(page, index)
        wait_for(lambda: page.page.evaluate(SHOWN) == shown, f'all that was shown before cell {index} ran again')
    # The robot of each output is the one on the stage, and does what a hand tells it.
    robots = page.page.locator('.robot-drive')
    robots.last.click()
    page.page.locator('.robot-word', has_text='SPEEDING UP').first.wait_for(state='attached')
    assert page.strange_errors() == []
