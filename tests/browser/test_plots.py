"""Plots in JupyterLab: opened by keyboard, drawn while messages come, marked, paused, zoomed, saved, closed."""

import csv
import re

import pytest
from playwright.sync_api import expect

from tests.support.axe import violations
from tests.support.lab import wait_for

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A wheel\nIt turns:',
    '''import math
import param_tutorial
from param_tutorial import ParameterClient, ParameterPanel
from rcl_interfaces.msg import FloatingPointRange
from rclpy.node import Node


class Wheel(Node):
    def __init__(self):
        super().__init__('wheel')
        self.declare_parameter('height', 2.0)
        self.declare_parameter('name', 'left')
        self.publisher = self.create_publisher(FloatingPointRange, '~/turn', 10)
        self.timer = self.create_timer(0.02, self.turn)

    def turn(self):
        seconds = self.get_clock().now().nanoseconds / 1e9
        height = self.get_parameter('height').value
        self.publisher.publish(FloatingPointRange(from_value=height * math.sin(seconds), to_value=0.1, step=-0.1))


ros = param_tutorial.start()
node = ros.add(Wheel)
panel = ParameterPanel(node)
panel''',
)

# How many pixels of a canvas have a color, which only curves have.
COLORED = '''canvas => {
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let index = 0; index < data.length; index += 4) {
        const [red, green, blue] = data.slice(index, index + 3);
        if (Math.max(red, green, blue) - Math.min(red, green, blue) > 60) count += 1;
    }
    return count;
}'''


@pytest.fixture
def wheel(opened):
    """Return the server and the page, on which running the cell has made a new node; it must not complain."""
    lab, page = opened
    page.run_all()
    expect(page.box('height')).to_have_value('2.0')
    yield lab, page
    assert page.complaints() == []


@pytest.fixture
def plot(wheel):
    """Return the page, and the plot of the height with the wheel's turn beside it."""
    _, page = wheel
    page.box('height').focus()
    page.page.keyboard.press('Tab')
    opener = page.row('height').get_by_role('button', name='Plot of height')
    expect(opener).to_be_focused()
    page.page.keyboard.press('Enter')
    plot = page.page.get_by_role('group', name='Plot of height')
    field = plot.get_by_label('Add a curve')
    field.fill('turn from')  # words in any order find it
    wait_for(lambda: plot.locator('datalist option').evaluate_all('all => all.map(each => each.value)')
             == ['/wheel/turn.from_value'], 'the field to be offered')
    field.fill('/wheel/turn.from_value')
    field.press('Enter')
    expect(plot.locator('.param-plot-key li')).to_have_count(2)
    return page, plot


def drawn(plot):
    return plot.locator('canvas').evaluate(COLORED)


def test_it_draws_what_comes_and_marks_what_changed(plot):
    page, plot = plot
    wait_for(lambda: drawn(plot) > 200, 'the curves to be drawn')
    turn = plot.locator('output').nth(1)
    first = turn.inner_text()
    expect(turn).not_to_have_text(first)
    page.box('height').fill('5.5')
    page.box('height').press('Enter')
    expect(plot.locator('output').first).to_have_text('5.5')
    changes = plot.locator('.param-plot-changes')
    expect(changes.locator('summary')).to_have_text('1 change')
    changes.locator('summary').click()
    expect(changes.locator('li')).to_contain_text('/wheel height 2.0 → 5.5 (from here)')
    plot.locator('canvas').focus()
    expect(plot.locator('canvas')).to_have_attribute('aria-label', re.compile(
        r'The last 30 seconds\. height: now 5\.5, from 2 to 5\.5\. /wheel/turn\.from_value: now .*\. 1 change\.$'))
    assert violations(page.page, '.param-plot') == []


def test_paused_it_stands_still_and_a_drag_shows_a_part(plot):
    page, plot = plot
    wait_for(lambda: drawn(plot) > 200, 'the curves to be drawn')
    canvas = plot.locator('canvas')
    canvas.focus()
    page.page.keyboard.press('Space')
    expect(plot.get_by_role('button', name='Go on')).to_have_attribute('aria-pressed', 'true')
    paused = drawn(plot)
    box = canvas.bounding_box()
    page.page.mouse.move(box['x'] + box['width'] - 60, box['y'] + 80)
    page.page.mouse.down()
    page.page.mouse.move(box['x'] + box['width'] - 20, box['y'] + 80)
    page.page.mouse.up()
    # Fewer seconds are wider, so more of the picture is a curve.
    wait_for(lambda: drawn(plot) > 2 * paused, 'the part to be drawn')
    zoomed = drawn(plot)
    page.page.mouse.move(box['x'], box['y'] - 40)
    page.page.wait_for_timeout(500)  # in which it would have been drawn anew
    assert abs(drawn(plot) - zoomed) < 200
    plot.get_by_role('button', name='Go on').click()
    expect(plot.get_by_role('button', name='Pause')).to_be_visible()


def test_it_is_saved_as_a_table_and_as_a_picture(plot, tmp_path):
    page, plot = plot
    wait_for(lambda: drawn(plot) > 200, 'the curves to be drawn')
    page.box('height').fill('3.0')
    page.box('height').press('Enter')
    expect(plot.locator('.param-plot-changes')).to_be_visible()
    with page.page.expect_download() as table:
        plot.get_by_role('button', name='CSV').click()
    assert table.value.suggested_filename == 'height.csv'
    table.value.save_as(tmp_path / 'height.csv')
    rows = list(csv.DictReader((tmp_path / 'height.csv').read_text().splitlines()))
    assert list(rows[0]) == ['time', 'height', '/wheel/turn.from_value', 'change']
    assert [row['height'] for row in rows if row['height']] == ['2', '3']
    assert [row['change'] for row in rows if row['change']] == ['/wheel height 2.0 → 3.0 (from here)']
    turns = [float(row['/wheel/turn.from_value']) for row in rows if row['/wheel/turn.from_value']]
    assert len(turns) > 10 and all(-3 <= each <= 3 for each in turns)
    assert [row['time'] for row in rows] == sorted(row['time'] for row in rows)
    with page.page.expect_download() as picture:
        plot.get_by_role('button', name='PNG').click()
    picture.value.save_as(tmp_path / 'height.png')
    assert (tmp_path / 'height.png').read_bytes().startswith(b'\x89PNG')


def test_it_stays_when_its_node_ends_and_when_the_page_is_loaded_again(opened, plot):
    lab, _ = opened
    page, plot = plot
    wait_for(lambda: drawn(plot) > 200, 'the curves to be drawn')
    lab.ask_kernel('ros.remove(node)')
    expect(plot.locator('output').first).to_have_text('/wheel is not running')
    expect(plot.locator('output').nth(1)).to_have_text('nobody publishes it now')
    page.reload()
    plot = page.page.get_by_role('group', name='Plot of height')
    wait_for(lambda: drawn(plot) > 200, 'the curves to be drawn again')
    plot.get_by_role('button', name='Close').click()
    expect(plot).to_have_count(0)
    expect(page.row('height').get_by_role('button', name='Plot of height')).to_be_focused()
