"""What stands beside the text in the real JupyterLab: in sight, once, and whatever cells run again."""

import pytest
from playwright.sync_api import expect

from tests.support.lab import RESTART_KERNEL, wait_for

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A robot\nOn the stage:',
    'import param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import RobotView, SideBySide\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    'ros = param_tutorial.start()\nrobot = ros.add(ClawbotNode)\nview = RobotView(robot)',
    "panel = ParameterPanel(robot, names=['max_speed_rpm'])\nSideBySide(view, panel)",
    'The same again:',
    'robot.drive()\nSideBySide(view, panel)',
    '# Far away\n' + 'A line.\n\n' * 60,
    "SideBySide(view, ParameterPanel(robot, names=['robot_name']))",
)
SETTINGS, AGAIN, OTHER = 2, 4, 6


@pytest.fixture
def page(opened):
    """Return the page, wide, with the cells run up to the second that shows the robot and its speed."""
    _, page = opened
    page.page.set_viewport_size({'width': 1280, 'height': 800})
    page.run_all()
    page.run_cell(SETTINGS)
    page.run_cell(AGAIN)
    expect(beside(page).get_by_label('max_speed_rpm', exact=True)).to_be_visible()
    return page


def beside(page):
    return page.page.get_by_role('complementary', name='Beside the text')


def test_it_is_drawn_once_and_stays_in_sight_at_the_end_of_the_text(page):
    expect(page.page.get_by_role('button', name='Beside the text →', exact=True)).to_have_count(2)
    expect(page.page.locator('.side-by-side:has([data-is-beside]) .robot-view:visible')).to_have_count(0)
    page.page.get_by_role('heading', name='Far away').scroll_into_view_if_needed()
    expect(beside(page).locator('.robot-scene')).to_be_in_viewport(ratio=0.99)
    expect(page.row('max_speed_rpm')).to_be_in_viewport(ratio=0.99)
    page.box('max_speed_rpm').fill('50')
    page.box('max_speed_rpm').press('Enter')
    expect(page.row('max_speed_rpm')).to_contain_text('↺')
    # And no text is below it.
    text = page.page.get_by_role('heading', name='Far away').bounding_box()
    assert text['x'] + text['width'] <= beside(page).bounding_box()['x']


def test_what_the_last_cell_shows_takes_the_place(page):
    page.run_cell(OTHER)
    expect(beside(page).get_by_label('robot_name', exact=True)).to_be_visible()
    expect(beside(page).get_by_label('max_speed_rpm', exact=True)).to_have_count(0)
    # A cell whose output is out of sight has shown something, too.
    page.run_all()
    page.select_cell(0)
    expect(beside(page).get_by_label('robot_name', exact=True)).to_be_visible()


def test_nothing_goes_blank_when_an_earlier_cell_runs_again(page):
    page.run_cell(SETTINGS)
    expect(beside(page).get_by_label('max_speed_rpm', exact=True)).to_be_visible()
    page.run_cell(1)
    page.run_cell(SETTINGS)
    expect(beside(page).locator('.robot-view')).to_have_count(1)
    expect(beside(page).locator('.robot-word')).to_have_text('READY')
    page.box('max_speed_rpm').fill('60')
    page.box('max_speed_rpm').press('Enter')
    expect(page.row('max_speed_rpm')).to_contain_text('↺')


def test_a_reader_puts_it_into_the_cell_and_that_of_another_cell_beside_the_text(page):
    beside(page).get_by_role('button', name='Put into the cell').click()
    expect(beside(page)).to_be_hidden()
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    page.select_cell(OTHER)
    page.page.get_by_role('button', name='Put beside the text').last.click()
    expect(beside(page)).to_be_focused()
    expect(beside(page).get_by_label('robot_name', exact=True)).to_be_visible()


def test_a_narrow_window_has_it_in_the_cell(page):
    page.page.set_viewport_size({'width': 800, 'height': 800})
    expect(beside(page)).to_be_hidden()
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    expect(page.page.get_by_role('button', name='Put beside the text')).to_have_count(0)
    page.page.set_viewport_size({'width': 1280, 'height': 800})
    expect(beside(page).locator('.robot-view')).to_be_visible()


def test_a_reload_brings_it_back(page):
    page.reload()
    wait_for(lambda: beside(page).locator('.robot-view').count() == 1, 'the robot beside the text')
    expect(beside(page).get_by_label('max_speed_rpm', exact=True)).to_be_visible()


def test_a_kernel_that_has_ended_leaves_nothing_beside_the_text(page):
    page.page.evaluate(RESTART_KERNEL)
    expect(beside(page)).to_be_hidden()
    page.select_cell(SETTINGS)
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    page.run_all()
    expect(beside(page).get_by_label('robot_name', exact=True)).to_be_visible()
