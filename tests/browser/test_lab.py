"""A learner at work: the real JupyterLab, Chromium, and a terminal beside it."""

import ast
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from tests.support import lab as lab_module
from tests.support import lesson
from tests.support.lab import ROOT, Lab, LabPage

pytestmark = pytest.mark.timeout(600)  # each wait may take lab.TIMEOUT_SEC

NODE = '/simple_param_node'


@pytest.fixture
def opened_lesson(tmp_path, browser):
    """Return a server and a page with a lesson; afterwards the browser must not have complained."""
    cells = (*lesson.LESSON[:2], 'from param_tutorial import ParameterPanel, views\n'
             f'views.SideBySide(views.EventView(), ParameterPanel({NODE!r}))')
    with Lab(tmp_path / 'lab', [lesson.write(tmp_path / 'lesson.ipynb', cells)]) as lab:
        page = LabPage(lab, browser, 'lesson.ipynb')
        yield lab, page
        assert page.strange_errors() == []


def terminal(lab, *words):
    """Run a command as in a second terminal, in the kernel's ROS domain, and return what it printed."""
    done = subprocess.run([sys.executable, '-m', 'param_tutorial', *words], env=lab.ros_environment(), cwd=ROOT,
                          capture_output=True, text=True)
    assert done.returncode == 0, f'{words}: {done.stdout}{done.stderr}'
    return done.stdout.strip()


def value(lab, name):
    """Return a parameter's value from the node in the kernel, faster than a new process could."""
    client = f"__import__('param_tutorial').ParameterClient({NODE!r})"
    return ast.literal_eval(lab.ask_kernel(f'{client}.get_parameter({name!r})'))


def position(page):
    """Return the value of max_acceleration_mps2 that its slider shows; it counts hundredths from 0.01."""
    return round(0.01 + 0.01 * float(page.slider('max_acceleration_mps2').input_value()), 2)


def drag(page, slider):
    """Take hold of a slider where it stands, and pull it to the right, in steps as a hand does."""
    slider.hover()  # which scrolls there, and waits until it stands still
    box = slider.bounding_box()
    share = float(slider.input_value()) / float(slider.get_attribute('max'))
    start, middle = box['x'] + 8 + share * (box['width'] - 16), box['y'] + box['height'] / 2
    page.page.mouse.move(start, middle)
    page.page.mouse.down()
    page.page.mouse.move(start + 60, middle, steps=20)
    page.page.mouse.up()


def test_a_learner_and_a_terminal(opened_lesson):
    lab, page = opened_lesson
    page.run_all()
    # Until then the slider may be in its cell.
    expect(page.page.get_by_role('complementary', name='Beside the text').get_by_role('slider').first).to_be_visible()
    slider, box = page.slider('max_acceleration_mps2'), page.box('max_acceleration_mps2')
    before = float(box.input_value())

    # The page may still be growing above the slider and push it from under the mouse: then the hand takes hold of it
    # again.
    def dragged():
        drag(page, slider)
        return float(box.input_value()) > before

    lab_module.wait_for(dragged, 'the slider to be dragged')
    # The last of the hand's moves may still be on its way: in the end slider, box and node agree.
    lab_module.wait_for(
        lambda: value(lab, 'max_acceleration_mps2') == float(box.input_value()) == position(page),
        'slider, box and node to agree')
    assert terminal(lab, 'param', 'get', NODE, 'max_acceleration_mps2') == f'Double value is: {position(page)}'

    # The terminal sets another value, and the panel shows it.
    assert terminal(lab, 'param', 'set', NODE, 'max_acceleration_mps2', '1.75') == 'Set parameter successful'
    expect(box).to_have_value('1.75')
    lab_module.wait_for(lambda: position(page) == 1.75, 'the slider to follow the node')

    # By keyboard.
    slider.focus()
    page.page.keyboard.press('ArrowLeft')
    expect(box).to_have_value('1.74')
    page.page.keyboard.press('End')
    expect(box).to_have_value('2.0')
    lab_module.wait_for(lambda: value(lab, 'max_acceleration_mps2') == 2.0, 'the node to have it')

    # What the node rejects springs back, with its reason, until the next change.
    speed = page.box('max_speed_rpm')
    kept = speed.input_value()
    speed.fill('-5')
    speed.press('Enter')
    expect(page.message('max_speed_rpm')).to_have_text('Rejected: max_speed_rpm must not be negative, got -5')
    expect(speed).to_have_value(kept)
    assert value(lab, 'max_speed_rpm') == int(kept)
    speed.fill('120')
    speed.press('Tab')
    expect(page.message('max_speed_rpm')).to_have_count(0)
    assert value(lab, 'max_speed_rpm') == 120

    # Tab goes on to what brings the value back, and then to the next control, a check box; the space bar turns it.
    page.row('max_speed_rpm').get_by_role('button', name='Back to').focus()
    page.page.keyboard.press('Tab')
    safety = page.box('enable_safety_mode')
    expect(safety).to_be_focused()
    ticked = safety.is_checked()
    page.page.keyboard.press('Space')
    expect(safety).to_be_checked(checked=not ticked)
    lab_module.wait_for(lambda: value(lab, 'enable_safety_mode') is not ticked, 'the node to have it')

    # Locked is locked.
    expect(page.box('robot_serial_number')).to_be_disabled()
