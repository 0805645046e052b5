"""In the real JupyterLab, what SideBySide shows stands beside the text while there is room."""

import pytest
from playwright.sync_api import expect

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A robot\nOn its track:',
    'import param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import SideBySide, TrackView\n'
    'from param_tutorial.nodes.base_node import BaseNode\nfrom param_tutorial.nodes.driver_node import DriverNode\n\n'
    'ros = param_tutorial.start()\nbase, driver = ros.add(BaseNode), ros.add(DriverNode)\nview = TrackView(base)',
    "panel = ParameterPanel(driver, names=['max_speed_mps'])\nSideBySide(view, panel)",
    '# Far away\n' + 'A line.\n\n' * 60,
    'SideBySide(view, panel)',
    "SideBySide(view, ParameterPanel(driver, names=['stop_distance_m']))",
)
ROBOT, SETTINGS, AGAIN, OTHER = 1, 2, 4, 5


@pytest.fixture
def page(opened):
    """Return the page, wide, with the cells run up to the second that shows the robot and its speed."""
    _, page = opened
    page.page.set_viewport_size({'width': 1280, 'height': 800})
    page.run_all()
    page.run_cell(SETTINGS)
    page.run_cell(AGAIN)
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
    return page


def beside(page):
    return page.page.get_by_role('complementary', name='Beside the text')


def test_it_is_drawn_once_and_stays_in_sight_also_when_an_earlier_cell_runs_again(page):
    expect(page.page.locator('.side-by-side:has([data-is-beside]) .robot-view:visible')).to_have_count(0)
    page.page.get_by_role('heading', name='Far away').scroll_into_view_if_needed()
    expect(beside(page).locator('.track-scene')).to_be_in_viewport(ratio=0.99)
    # And no text is below it.
    text = page.page.get_by_role('heading', name='Far away').bounding_box()
    assert text['x'] + text['width'] <= beside(page).bounding_box()['x']
    page.run_cell(ROBOT)
    page.run_cell(SETTINGS)
    expect(beside(page).locator('.robot-view')).to_have_count(1)
    page.box('max_speed_mps').fill('0.7')
    page.box('max_speed_mps').press('Enter')
    expect(page.row('max_speed_mps')).to_contain_text('↺')


def test_what_the_last_cell_shows_takes_the_place_until_a_reader_chooses(page):
    page.run_cell(OTHER)
    expect(beside(page).get_by_label('stop_distance_m', exact=True)).to_be_visible()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_have_count(0)
    beside(page).get_by_role('button', name='Put into the cell').click()
    expect(beside(page)).to_be_hidden()
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    page.select_cell(SETTINGS)
    page.page.get_by_role('button', name='Put beside the text').first.click()
    expect(beside(page)).to_be_focused()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
