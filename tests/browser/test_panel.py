"""The panel in JupyterLab beyond one change: search, undo by keyboard, and what is being typed; the list of nodes."""

import ast
import os
import signal

import pytest
from playwright.sync_api import expect

from tests.support.axe import violations_in_both_themes
from tests.support.lab import wait_for

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A planner\nWith many parameters:',
    '''import param_tutorial
from param_tutorial import ParameterClient, ParameterPanel
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.declare_parameter('rate_hz', 10, ParameterDescriptor(
            description='How often it plans.', integer_range=[IntegerRange(from_value=0, to_value=100, step=5)]))
        self.declare_parameter('map_name', 'hall')
        for critic in ('path', 'goal'):
            for number in range(100):
                self.declare_parameter(f'critics.{critic}.weight_{number}', number)


ros = param_tutorial.start()
node = ros.add(Planner)
client = ParameterClient(node)
panel = ParameterPanel(node)
panel''',
    'And of all nodes:',
    'ParameterPanel()',
)


DOUBLE_IDS = '''() => {
    const ids = [...document.querySelectorAll('.param-panel [id]')].map(each => each.id);
    return ids.filter((each, index) => ids.indexOf(each) !== index);
}'''


@pytest.fixture
def planner(opened):
    """Return the server and the page, on which running the cell has made a new node; it must not complain."""
    lab, page = opened
    page.run_all()
    expect(page.box('rate_hz')).to_have_value('10')
    yield lab, page
    assert page.complaints() == []


def value(lab, name):
    return ast.literal_eval(lab.ask_kernel(f'client.get_parameter({name!r})'))


def button(page, name):
    return page.page.locator('.param-head').get_by_role('button', name=name)


def test_a_search_shows_what_fits_and_where_it_stands(planner):
    _, page = planner
    search = page.page.get_by_role('searchbox', name='Search the parameters of /planner')
    rows = page.page.locator('.param-row:visible')
    search.fill('goal weight_7')
    expect(page.page.locator('.param-found')).to_have_text('11 of 204 found')
    expect(rows).to_have_count(11)
    search.fill('how often')  # in a description
    expect(rows).to_have_count(1)
    search.press('Escape')
    expect(page.page.locator('.param-found')).to_be_hidden()
    expect(page.row('map_name')).to_be_visible()


def test_many_parameters_have_one_line_each(planner):
    _, page = planner
    rows = page.page.locator('.jp-OutputArea-output .param-row:visible')
    assert {round(each.bounding_box()['height']) for each in (rows.first, rows.nth(1), rows.nth(99))} == {24}
    page.box('rate_hz').focus()  # what a column is too narrow for is seen then, and nothing moves
    expect(page.row('rate_hz').locator('.param-help')).to_have_css('white-space', 'pre-line')
    assert rows.first.bounding_box()['height'] == 24


def test_the_nodes_name_and_the_search_stay_in_sight(planner):
    _, page = planner
    panel = page.page.locator('.jp-OutputArea-output .param-panel').first
    search, name = panel.get_by_role('searchbox'), panel.locator('.param-node')
    for parameter in ('critics.path.weight_99', 'critics.goal.weight_50'):
        box = panel.locator(f'[data-name="{parameter}"] input').first

        def stands_below_the_head(box=box):
            # What is brought to the top, as by a key. The rows around it take their places when they are first seen.
            box.evaluate('box => box.scrollIntoView()')
            below, above = (each.bounding_box() for each in (box, search))
            return below['y'] >= above['y'] + above['height']

        wait_for(stands_below_the_head, f'{parameter} to stand below the head')
        for each in (box, search, name):
            expect(each).to_be_in_viewport()


def test_undo_by_keyboard_and_a_value_brought_back(planner):
    lab, page = planner
    page.box('rate_hz').fill('20')
    page.box('rate_hz').press('Enter')
    expect(page.row('rate_hz').get_by_role('button', name='Back to')).to_have_text('↺ 10')
    page.box('map_name').fill('yard')
    page.box('map_name').press('Control+z')  # while it is being typed, the browser undoes the text
    expect(page.box('rate_hz')).to_have_value('20')
    # The box or the slider is where the keys are pressed, and the browser would undo only its text.
    for box in (page.box('map_name'), page.slider('rate_hz')):
        page.box('map_name').fill('yard')
        page.box('map_name').press('Enter')
        wait_for(lambda: value(lab, 'map_name') == 'yard', 'the node to have it')
        expect(button(page, 'Undo')).to_be_enabled()
        box.press('Control+z')
        expect(page.box('map_name')).to_have_value('hall')
        wait_for(lambda: (value(lab, 'rate_hz'), value(lab, 'map_name')) == (20, 'hall'), 'the node to have it')
        expect(button(page, 'Undo')).to_be_disabled()
    page.row('rate_hz').get_by_role('button', name='Back to 10: rate_hz').click()
    expect(page.slider('rate_hz')).to_have_value('2')
    expect(page.row('rate_hz').get_by_role('button', name='Back to')).to_be_hidden()
    page.box('map_name').fill('yard')
    page.box('map_name').press('Enter')
    button(page, 'Reset').click()
    expect(page.box('map_name')).to_have_value('hall')
    wait_for(lambda: (value(lab, 'rate_hz'), value(lab, 'map_name')) == (10, 'hall'), 'the node to have its values')
    expect(page.page.locator(':focus .param-reset')).to_be_disabled()  # the panel has the focus, and hears Ctrl+Z


def test_nothing_on_the_panel_keeps_anybody_from_using_it(planner):
    """By the rules of axe-core, in both themes; in a narrow column nothing sticks out."""
    lab, page = planner
    long = 'w' * 300
    lab.ask_kernel(f'node.declare_parameter("{long}", "{long}")')
    expect(page.row(long)).to_be_visible()
    page.box('map_name').fill('x')
    page.box('map_name').press('Enter')
    page.box('rate_hz').fill('20')
    page.box('rate_hz').press('Enter')
    back = page.row('rate_hz').get_by_role('button', name='Back to')
    expect(back).to_be_visible()
    page.box('rate_hz').fill('x')
    page.box('rate_hz').press('Enter')
    expect(page.message('rate_hz')).to_be_visible()
    assert violations_in_both_themes(page.page, '.param-panel') == []
    page.page.evaluate("""() => document.querySelectorAll('.param-panel').forEach(
        each => { each.style.width = '400px'; })""")
    assert page.page.evaluate("""() => { return [...document.querySelectorAll('.param-panel *')].filter(each => {
            const [box, panel] = [each, each.closest('.param-panel')].map(one => one.getBoundingClientRect());
            return box.width && box.right > panel.right + 1; })
            .map(each => each.outerHTML.slice(0, 120)) }""") == []
    # Nor does the way back cover the frame of a slider that has the focus.
    above, below = (each.bounding_box() for each in (back, page.slider('rate_hz')))
    assert above['y'] + above['height'] <= below['y'] - 3


def test_shift_is_a_tenth_for_keys_and_for_the_mouse(planner):
    lab, page = planner
    lab.ask_kernel("node.declare_parameter('reach', 0.5, ParameterDescriptor(floating_point_range=["
                   "FloatingPointRange(from_value=0.0, to_value=2.0)]))")
    slider = page.slider('reach')
    slider.press('ArrowRight')
    expect(page.box('reach')).to_have_value('0.51')
    slider.press('Shift+ArrowRight')
    expect(page.box('reach')).to_have_value('0.511')
    page.box('reach').fill('1.0')
    page.box('reach').press('Enter')
    expect(slider).to_have_value('100')
    box = slider.bounding_box()
    page.page.keyboard.down('Shift')
    middle, end = ({'x': x, 'y': 9} for x in (box['width'] / 2, box['width'] - 9))
    slider.drag_to(slider, source_position=middle, target_position=end)
    page.page.keyboard.up('Shift')
    wait_for(lambda: 1.05 < value(lab, 'reach') < 1.15, 'a tenth of the way')


def test_what_has_changed_is_copied(planner):
    _, page = planner
    page.box('rate_hz').fill('20')
    page.box('rate_hz').press('Enter')
    panel = page.page.locator('.jp-OutputArea-output .param-panel').first
    copy = panel.get_by_role('button', name='Copy…')
    expect(copy).to_be_enabled()  # when the node has answered
    copy.press('Enter')
    dialog = panel.get_by_role('dialog', name='The changed values of /planner')
    dialog.get_by_role('button', name='Copy').last.press('Enter')
    expect(dialog.get_by_role('button', name='Copied')).to_be_focused()
    page.page.keyboard.press('Escape')
    expect(dialog).to_be_hidden()
    panel.get_by_role('searchbox').press('Control+v')
    expect(panel.get_by_role('searchbox')).to_have_value('ros2 param set /planner rate_hz 20')


def test_what_is_being_typed_outlives_whatever_else_happens(planner):
    lab, page = planner
    box = page.box('map_name')
    box.focus()
    page.page.keyboard.press('Home')
    page.page.keyboard.type('big')
    lab.ask_kernel("client.set_parameter('rate_hz', 50)")
    expect(page.box('rate_hz')).to_have_value('50')
    # After a new parameter, the whole panel is rebuilt.
    lab.ask_kernel("node.declare_parameter('late', 1)")
    expect(page.row('late')).to_be_visible()
    expect(page.box('map_name')).to_be_focused()
    page.page.keyboard.type(' old ')
    expect(page.box('map_name')).to_have_value('big old hall')
    page.page.keyboard.press('Enter')
    wait_for(lambda: value(lab, 'map_name') == 'big old hall', 'the node to have it')
    page.box('map_name').fill('never')

    def is_given_up():
        # While the node is long in answering, the boxes hear of no key.
        page.box('map_name').press('Escape')
        return page.box('map_name').input_value() == 'big old hall'

    wait_for(is_given_up, 'Escape to bring the value of before back')
    assert value(lab, 'map_name') == 'big old hall'


def test_what_is_entered_while_a_cell_runs_is_answered(planner, tmp_path):
    lab, page = planner
    go = tmp_path / 'go'
    code = f'import pathlib, time\nwhile not pathlib.Path({str(go)!r}).exists():\n    time.sleep(0.01)'
    page.page.evaluate(f"""() => {{ window.jupyterapp.shell.currentWidget.sessionContext.session.kernel.requestExecute(
        {{code: {code!r}}}) }}""")
    try:
        page.box('map_name').fill('yard')
        page.box('map_name').press('Enter')
        expect(page.row('map_name').get_by_role('button')).to_have_text('↺ hall')
    finally:
        go.touch()  # the cell that waits for it keeps the kernel from all later tests
    assert value(lab, 'map_name') == 'yard'


def test_what_is_entered_while_the_kernel_stands_still_is_said_to_wait(planner):
    lab, page = planner
    kernel = int(lab.ask_kernel("__import__('os').getpid()"))
    os.kill(kernel, signal.SIGSTOP)
    try:
        page.box('map_name').fill('yard')
        page.box('map_name').press('Enter')
        expect(page.message('map_name')).to_contain_text('Waiting for the kernel')
    finally:
        os.kill(kernel, signal.SIGCONT)
    expect(page.message('map_name')).to_have_count(0)
    assert value(lab, 'map_name') == 'yard'


def test_a_node_is_found_by_its_parameters_and_opened(planner):
    _, page = planner
    nodes = page.page.locator('.param-nodes')
    nodes.get_by_role('searchbox', name='Search nodes and parameters').fill('hall')
    nodes.get_by_role('button', name='map_name = hall').click()
    opened = page.page.locator('.node-panels .param-panel')
    expect(opened.get_by_role('searchbox')).to_have_value('map_name')
    expect(opened.locator('.param-row:visible')).to_have_count(1)
    expect(nodes.get_by_role('button', name='/planner', exact=True)).to_have_attribute('aria-expanded', 'true')
    # Each control has its own label, also where two panels show the same node.
    assert page.page.evaluate(DOUBLE_IDS) == []
    assert page.page.evaluate("[...document.querySelectorAll('.param-box')].every(each => each.labels.length)")
    opened.get_by_label('map_name', exact=True).fill('yard')
    opened.get_by_label('map_name', exact=True).press('Enter')
    expect(page.box('map_name')).to_have_value('yard')
    nodes.get_by_role('button', name='/planner', exact=True).click()
    expect(opened).to_have_count(0)
    nodes.get_by_role('searchbox').fill('no such thing')
    expect(nodes.locator('.node-line')).to_have_count(0)
    nodes.get_by_role('searchbox').press('Escape')
    expect(nodes.locator('.node-line')).to_have_count(1)


@pytest.fixture
def slow_script(opened):
    """Let the script of a panel take longer to load than the two seconds that anywidget waits for it."""
    lab, _ = opened
    lab.ask_kernel('exec("from param_tools.panel.panel import _Front; _Front.quick = _Front._esm; '
                   '_Front._esm = \'await new Promise(go => setTimeout(go, 3000));\' + str(_Front.quick)")')
    yield
    lab.ask_kernel('exec("_Front._esm = _Front.quick; del _Front.quick")')


def test_a_panel_whose_script_is_slow_to_load_follows_its_node(opened, slow_script):
    lab, page = opened
    page.run_all()
    expect(page.box('rate_hz')).to_have_value('10')
    lab.ask_kernel("client.set_parameter('map_name', 'yard')")
    expect(page.box('map_name')).to_have_value('yard')
    page.page.locator('.param-nodes').get_by_role('button', name='/planner', exact=True).click()
    opened_panel = page.page.locator('.node-panels .param-panel')
    expect(opened_panel.get_by_label('map_name', exact=True)).to_have_value('yard')
    lab.ask_kernel("client.set_parameter('map_name', 'attic')")
    expect(opened_panel.get_by_label('map_name', exact=True)).to_have_value('attic')
