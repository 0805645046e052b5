"""What a reader drags and types below a picture, with mouse and keyboard, and what real nodes say to it."""

import re

import pytest
from playwright.sync_api import expect

from tests.support.axe import violations_in_both_themes

pytestmark = pytest.mark.timeout(300)

CELLS = (
    """import os
import time

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node

import param_tutorial
from param_tutorial import ParameterClient
from param_tutorial.views import LadderView, NumberLineView


class Robot(Node):
    def __init__(self, **options):
        super().__init__('robot', **options)
        self.declare_parameter('speed', 100)
        self.declare_parameter('opening', 40, ParameterDescriptor(
            integer_range=[IntegerRange(from_value=0, to_value=80, step=20)]))
        self.add_on_set_parameters_callback(self.judge)

    def judge(self, parameters):
        while os.path.exists('busy'):
            time.sleep(0.02)
        return SetParametersResult(successful=True)


ros = param_tutorial.start()
ros.add(Robot)
NumberLineView('/robot', 'opening')""",
    "LadderView('/robot', 'speed', 7)",
)
LINE, LADDER = range(len(CELLS))


@pytest.fixture(scope='module')
def opened(opened):
    """Return the server, and the page on which the cells have run."""
    opened[1].run_all()
    return opened


def view(page, index):
    return page.page.locator('.jp-CodeCell').nth(index).locator('.motion-view')


def outcome(page, index):
    return view(page, index).locator('.motion-outcome')


def drag(page, what, to_x, held=0):
    """Drag what is seen to another place at its height, held so many pixels beside its middle."""
    box = what.bounding_box()
    x, y = box['x'] + box['width'] / 2 + held, box['y'] + box['height'] / 2
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move((x + to_x) / 2, y)
    page.page.mouse.move(to_x, y)
    page.page.mouse.up()


def test_the_marker_of_a_number_line_is_dragged_also_to_where_no_value_is_allowed(opened):
    lab, page = opened
    drawing = view(page, LINE).locator('svg').first
    drawing.scroll_into_view_if_needed()
    ring = [each.bounding_box() for each in drawing.locator('.motion-dot').all()]
    drag(page, drawing.locator('.motion-pin'), ring[3]['x'] + ring[3]['width'] / 2 + 8, held=8)
    expect(outcome(page, LINE)).to_have_text('opening = 60 is stored.')
    assert lab.ask_kernel("ParameterClient('/robot').get_parameter('opening')") == '60'
    expect(drawing).to_contain_text('60')
    # Far beside the picture: the marker stops at its edge, which on this scale is -15.
    drag(page, view(page, LINE).locator('svg').first.locator('.motion-pin'), 1)
    expect(outcome(page, LINE)).to_contain_text('opening = -15 is rejected: Parameter opening out of range')
    expect(view(page, LINE).get_by_role('textbox')).to_have_value('-15')


def test_as_long_as_there_is_no_answer_the_line_says_so(opened):
    lab, page = opened
    line = view(page, LADDER).locator('.motion-handle')
    line.get_by_role('textbox').fill('8')
    (lab.folder / 'busy').touch()
    try:
        line.get_by_role('textbox').press('Enter')
        expect(line).to_have_class(re.compile('motion-waiting'))
    finally:
        (lab.folder / 'busy').unlink()
    expect(line).not_to_have_class(re.compile('motion-waiting'))
    expect(outcome(page, LADDER)).to_have_text('speed = 8 is accepted.')


def test_nothing_that_axe_finds_in_the_pictures(opened):
    _, page = opened
    page.page.emulate_media(reduced_motion='reduce')
    assert violations_in_both_themes(page.page, '.motion-view', options=None) == []
