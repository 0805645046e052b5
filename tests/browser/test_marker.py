"""A prediction in the picture: the reader puts a robot on the track, and the real one drives past it."""

import pytest
from playwright.sync_api import expect

from tests.support.axe import violations_in_both_themes

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A track\nThe robot and its picture:',
    'import rclpy\n\nimport param_tutorial\nfrom param_tutorial import exercises\n'
    'from param_tutorial.nodes.base_node import BaseNode\nfrom param_tutorial.nodes.driver_node import DriverNode\n'
    'from param_tutorial.views import TrackView\n\n'
    'ros = param_tutorial.start()\nbase, driver = ros.add(BaseNode), ros.add(DriverNode)\nview = TrackView(base)\nview',
    "exercises.predict('1-1')",
    "driver.set_parameters([rclpy.Parameter('max_speed_mps', value=2.0)])\nview.drive()",
)


def test_it_is_dragged_and_moved_by_keys_and_commit_runs_the_cell(opened):
    _, lab_page = opened
    page = lab_page.page
    lab_page.run_cell(1)
    lab_page.run_cell(2)
    form = page.locator('form.param-predict')
    line, number = form.get_by_role('slider'), form.locator('.param-predict-number')
    commit = form.get_by_role('button', name='Commit')
    form.scroll_into_view_if_needed()
    expect(number).to_have_text('?')
    expect(line).to_have_attribute('aria-valuetext', 'not answered yet')
    expect(commit).to_be_disabled()
    # In the picture, away from the wall.
    page.locator('.track-scene').scroll_into_view_if_needed()
    box = page.locator('.track-ghost path').bounding_box()
    x, y = box['x'] + box['width'] / 2, box['y'] + box['height'] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 60, y)
    page.mouse.up()
    assert 5 < float(number.text_content().removesuffix(' m')) < 9
    line.focus()
    page.keyboard.press('Home')
    expect(number).to_have_text('0 m')
    expect(line).to_have_attribute('aria-valuetext', '0 m')
    assert violations_in_both_themes(page, 'form.param-predict') == []
    commit.click()
    expect(page.locator('.robot-word')).to_have_text('CRASHED')
    expect(form.get_by_role('status')).to_have_text('✓ Right.')
    expect(page.locator('.jp-Cell').nth(3)).to_contain_text('You predicted: 0 m')
    expect(form.locator('.param-predict-truth')).to_be_visible()
