"""The HTML lessons in Chromium, with the network off: what readers see, what they can do, and what the page says.

A site of two small chapters, made once for all tests; the kernels, the nodes and their answers are real. `make html`
holds the chapters of the course to the same rules when CI builds them, see test_built_site.py.
"""

import contextlib
import functools
import http.server
import json
import re
import shutil
import threading
import zipfile

import nbformat
import pytest
from nbclient import NotebookClient
from playwright.sync_api import expect

from param_tutorial.site import single
from param_tutorial.site.build import Site
from param_tutorial.site.pages import writing
from param_tutorial.site.recording import run
from tests.support import lesson, missing
from tests.support.firefox import FIREFOX, firefox
from tests.support.lab import ROOT, wait_for
from tests.tools.site_rules import check_page, open_page

# Sphinx and its extensions tell each other, in each release, what the next one will bring.
pytestmark = [
    pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600),  # the site is made in the first one's time
    *(pytest.mark.filterwarnings(f'ignore::{kind}Warning') for kind in ('Deprecation', 'PendingDeprecation'))]

# What a chapter with all that the pages know looks like. Its node has a rule over two parameters, a limit that a
# callback applies, and a log.
LIMITS = (
    '# 1 · Limits\n\n**What does a node say?**',
    '''import param_tutorial
from param_tutorial import ParameterPanel
from param_tutorial.views import EventView, LogView
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter


class Heater(Node):
    def __init__(self):
        super().__init__('heater')
        for name, value in (('low_c', 18), ('high_c', 22)):
            self.declare_parameter(name, value, ParameterDescriptor(
                description='A limit.', integer_range=[IntegerRange(from_value=0, to_value=34, step=1)]))
        self.declare_parameter('power_w', 100)
        self.declare_parameter('name', 'Heater')
        self.declare_parameter('on', True)
        self.declare_parameter('levels', [1])
        self.declare_parameter('serial', 'SN-1', ParameterDescriptor(read_only=True))
        self.add_pre_set_parameters_callback(self.trim)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.tell)

    def trim(self, parameters):
        return [Parameter('power_w', value=min(p.value, 300)) if p.name == 'power_w' and type(p.value) is int else p
                for p in parameters]

    def judge(self, parameters):
        new = {p.name: p.value for p in parameters}
        low, high = (new.get(name, self.get_parameter(name).value) for name in ('low_c', 'high_c'))
        return SetParametersResult(successful=low < high, reason=f'{low} is not below {high}')

    def tell(self, parameters):
        for p in parameters:
            self.get_logger().info(f'{p.name} is now {p.value}')


ros = param_tutorial.start()
heater = ros.add(Heater)''',
    'Its controls:',
    "panel = ParameterPanel('/heater')\npanel",
    "display(LogView(node='/heater'), EventView())",
    'Two predictions, one to choose and one to type:',
    "from param_tutorial import exercises\n\nexercises.predict('6.1-1')",
    "exercises.predict('6.1-2')",
    "print('-20, -15, 0, 50 and 52')",
    'Five of the eight. What a hand does later does not show above:',
    "panel['low_c'].value = 19\npanel.settle()\npanel['low_c'].value",
    '## Words\n\nA callback is called. Another callback, `callback`, and a [callback](2_robot.ipynb).\n\n'
    'A post-set callback is no mere callback.\n\n'
    '| word | meaning |\n|---|---|\n| callback | a function that `rclpy` calls |\n'
    '| post-set callback | acts on what is stored |\n| step | an everyday word |',
    '## Next\n\nA table, and a link to [the other one](2_robot.ipynb). No callback.\n\n'
    '| a | b |\n| --- | --- |\n| 1 | 2 |',
    "print('the end')\n1 / 0",
)
ROBOT = (
    '# 2 · A robot\n\n**Does it move?**',
    'import param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import LinePlot, RobotView\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    'ros = param_tutorial.start()\nrobot = ros.add(ClawbotNode)\nview = RobotView(robot)\nview',
    'Its controls:',
    "ParameterPanel(robot, names=['max_speed_rpm', 'enable_safety_mode', 'robot_name'])",
    'A picture:',
    "LinePlot({'a line': [(0, 0), (1, 2)]}, x='time in s', y='speed in m/s')",
    '## 7.3a · Put three sources in order',
    "sources = [\n    '-p speed:=400',\n    '--params-file slow.yaml',\n    '--params-file fast.yaml',\n]",
    "from param_tutorial import exercises\n\nexercises.check('7.3a', sources)",
)
SOLVED = "sources = ['--params-file fast.yaml', '--params-file slow.yaml', '-p speed:=400']"
INDEX = '''# Start

| | Chapter | Question | Minutes |
| --- | --- | --- | ---: |
| 1 | [Limits](1_limits.ipynb) | What does a node say? | 5 |
| 2 | [A robot](2_robot.ipynb) | Does it move? | 5 |
'''


def write_chapter(path, cells):
    """Write a chapter as its author saves it: run, with its outputs."""
    lesson.write(path, cells)
    notebook = nbformat.read(path, as_version=4)
    for at, cell in enumerate(notebook.cells):
        if 'exercises.check(' in cell.source:
            notebook.cells[at - 1].id, cell.id = 'exercise-7-3a', 'check-7-3a'
    if '1 / 0' in notebook.cells[-1].source:
        notebook.cells[-1].metadata.tags = ['raises-exception']
    NotebookClient(notebook, kernel_manager_class=run.OwnKernel, store_widget_state=False, coalesce_streams=True,
                   resources={'metadata': {'path': str(path.parent)}}).execute()
    nbformat.write(notebook, path)


# In WebDriver's table of keys.
FIREFOX_ENTER, FIREFOX_DOWN = '\ue007', '\ue015'


@pytest.fixture(scope='module')
def made(tmp_path_factory):
    """Build a site, and yield it."""
    folder = tmp_path_factory.mktemp('site')
    notebooks = folder / 'notebooks'
    notebooks.mkdir()
    (notebooks / 'index.md').write_text(INDEX)
    for name, cells in (('1_limits', LIMITS), ('2_robot', ROBOT)):
        write_chapter(notebooks / f'{name}.ipynb', cells)
    (notebooks / 'solutions').mkdir()
    path = lesson.write(notebooks / 'solutions' / '2_robot.ipynb', ('# Solutions', SOLVED))
    solved = nbformat.read(path, as_version=4)
    solved.cells[1].id = 'solution-7-3a'
    nbformat.write(solved, path)
    (notebooks / 'claims.md').write_text('# The claims\n\n| A001 | true |\n| --- | --- |\n| A002 | false |\n')
    site = Site(notebooks, folder / 'html', folder / 'work', processes=2, address='https://lessons.example/ros')
    site.build()
    return site


@pytest.fixture
def page(made, browser, request):
    """Return a chapter's page, from the disk; nothing may be requested elsewhere, or complained of."""
    with open_page(browser, (made.target / request.param).as_uri()) as page:
        yield page


@contextlib.contextmanager
def served(folder):
    """Serve a folder like any web server, and yield its address."""
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(('127.0.0.1', 0), functools.partial(Quiet, directory=folder)) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f'http://127.0.0.1:{server.server_port}'
        finally:
            server.shutdown()
            thread.join()


def files(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob('*') if path.is_file()}


def row(page, name):
    return page.locator(f'.param-row[data-name="{name}"]').first


def box(page, name):
    return row(page, name).get_by_label(name, exact=True)


def message(page, name):
    return row(page, name).locator('.param-message')


def type_into(page, name, text):
    box(page, name).fill(text)
    box(page, name).press('Enter')


limits = pytest.mark.parametrize('page', ['1_limits.html'], indirect=True)
robot = pytest.mark.parametrize('page', ['2_robot.html'], indirect=True)


@limits
def test_a_value_that_the_node_took_is_in_its_log_and_in_the_table_of_events(page):
    rows = page.get_by_role('log', name='Changes of all nodes').get_by_role('row')
    expect(rows).to_have_count(1)
    type_into(page, 'power_w', '150')
    expect(message(page, 'power_w')).to_have_text('Accepted.')
    expect(box(page, 'power_w')).to_have_value('150')
    expect(page.get_by_role('log', name='Log of /heater')).to_contain_text('[INFO] [heater]: power_w is now 150')
    type_into(page, 'low_c', '25')  # rejected, so nothing is told
    box(page, 'on').click()
    expect(rows).to_have_count(3)
    expect(rows.nth(1)).to_have_text('/heaterchangedonFalse')
    expect(rows.nth(2)).to_have_text('/heaterchangedpower_w150')


@limits
def test_a_value_that_the_node_rejected_springs_back_with_the_nodes_reason(page):
    type_into(page, 'low_c', '25')
    expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')
    expect(box(page, 'low_c')).to_have_value('18')
    expect(row(page, 'low_c').get_by_role('slider')).to_have_value('18')
    type_into(page, 'low_c', '35')
    expect(message(page, 'low_c')).to_contain_text('Rejected: ')
    type_into(page, 'low_c', 'fast')
    expect(message(page, 'low_c')).to_have_text(
        "Rejected: 'fast' cannot be read: low_c takes an integer, e.g. 42")
    expect(box(page, 'low_c')).to_have_value('18')


@limits
def test_a_value_that_the_node_rewrote_shows_as_the_node_has_it(page):
    type_into(page, 'power_w', '900')
    expect(box(page, 'power_w')).to_have_value('300')
    expect(message(page, 'power_w')).to_have_text('Accepted. The node has made it 300.')


@limits
def test_a_value_that_was_not_recorded_is_said_to_be(page):
    type_into(page, 'power_w', '123456')
    expect(message(page, 'power_w')).to_contain_text('Not recorded: the node was not asked for “123456”')
    expect(box(page, 'power_w')).to_have_value('100')
    for text in ('Nobody thought of this', '__proto__'):
        type_into(page, 'name', text)
        expect(message(page, 'name')).to_contain_text('Not recorded')
        expect(box(page, 'name')).to_have_value('Heater')


@limits
def test_an_answer_that_depends_on_another_parameter_is_not_given_for_another_state(page):
    """21 is below 22 but not below 20: the page must not answer from the state that was first shown."""
    type_into(page, 'high_c', '20')
    type_into(page, 'low_c', '21')
    expect(message(page, 'low_c')).to_have_text('Rejected: 21 is not below 20')
    page.get_by_role('button', name='Back to the start').click()
    expect(box(page, 'high_c')).to_have_value('22')
    # high_c has no room below 18 until low_c has gone down.
    type_into(page, 'low_c', '3')
    type_into(page, 'high_c', '4')
    type_into(page, 'low_c', '5')
    expect(message(page, 'low_c')).to_have_text('Rejected: 5 is not below 4')
    type_into(page, 'low_c', 'nobody thought of this')
    expect(message(page, 'low_c')).to_contain_text('Not recorded')
    expect(box(page, 'low_c')).to_have_value('3')


@limits
def test_slider_check_box_and_array_by_keyboard(page):
    slider = row(page, 'low_c').get_by_role('slider')
    slider.focus()
    page.keyboard.press('ArrowLeft')
    expect(box(page, 'low_c')).to_have_value('17')
    expect(slider).to_have_attribute('aria-valuetext', '17')
    page.keyboard.press('End')
    expect(message(page, 'low_c')).to_contain_text('34 is not below 22')
    expect(slider).to_have_value('17')
    box(page, 'on').focus()
    page.keyboard.press('Space')
    expect(box(page, 'on')).not_to_be_checked()
    # Answers that depend on nothing hold with the others changed, and say how they were recorded.
    expect(message(page, 'on')).to_have_text('Accepted. Recorded with the other values as first shown.')
    type_into(page, 'levels', '[1, 2, 3]')
    expect(message(page, 'levels')).to_contain_text('Accepted.')
    expect(box(page, 'serial')).to_be_disabled()


@limits
def test_the_panel_shows_the_state_in_which_the_cell_ran(page):
    expect(box(page, 'low_c')).to_have_value('18')
    expect(page.locator('.cell_output').get_by_text('19', exact=True)).to_be_visible()


@limits
def test_a_prediction_by_keyboard(page):
    form = page.locator('.rec-prediction').first
    commit = form.get_by_role('button', name='Commit')
    expect(commit).to_be_disabled()
    form.get_by_role('radio').first.focus()
    page.keyboard.press('Space')
    page.keyboard.press('ArrowDown')
    page.keyboard.press('Tab')
    page.keyboard.press('Enter')
    expect(form.get_by_role('status')).to_contain_text('Right. 85 is off the step too')
    expect(form.get_by_role('radio').first).to_be_disabled()
    expect(commit).to_be_hidden()
    expect(page.get_by_text("exercises.predict('6.1-1')")).to_have_count(0)


@limits
@pytest.mark.parametrize(('typed', 'said'), [(' 5.0 ', 'Right. -20, -15'), ('4', 'Not so. There is one more'),
                                             ('many', 'Not so. It accepts five')])
def test_a_prediction_that_is_typed(page, typed, said):
    form = page.locator('.rec-prediction').nth(1)
    box = form.get_by_label('Your value')
    box.fill(typed)
    box.press('Enter')
    expect(form.get_by_role('status')).to_contain_text(said)


def test_predictions_are_kept_in_the_browser_and_marked_beside_the_lessons(made, browser):
    with open_page(browser, (made.target / '1_limits.html').as_uri()) as page:
        marks = page.get_by_role('navigation', name='Lessons').locator('.lesson-mark')
        chosen, typed = (page.locator('.rec-prediction').nth(number) for number in (0, 1))
        expect(marks).to_have_count(0)
        chosen.get_by_role('radio').nth(1).check()
        chosen.get_by_role('button', name='Commit').click()
        expect(marks).to_have_attribute('title', '1 of 2 questions answered')
        typed.get_by_label('Your value').fill('many')
        typed.get_by_label('Your value').press('Enter')
        expect(marks).to_have_text('✓ (2 of 2 questions answered)')
        said = chosen.get_by_role('status').inner_text()
        page.reload()
        expect(chosen.get_by_role('status')).to_have_text(said)
        expect(chosen.get_by_role('radio').nth(1)).to_be_checked()
        expect(chosen.get_by_role('radio').nth(1)).to_be_disabled()
        expect(typed.get_by_label('Your value')).to_have_value('many')
        chosen.get_by_role('button', name='Answer again').click()
        expect(chosen.get_by_role('radio').first).to_be_focused()
        expect(chosen.get_by_role('status')).to_be_empty()
        expect(marks).to_have_text('1/2 (1 of 2 questions answered)')
        page.goto((made.target / 'index.html').as_uri())
        expect(page.locator('.front-lessons .lesson-mark')).to_have_text('1/2 (1 of 2 questions answered)')
        expect(page.locator('.lesson-progress')).to_contain_text('You have answered one question.')
        assert check_page(page) == []
        page.get_by_role('button', name='Forget my answers').click()
        expect(page.locator('.lesson-mark')).to_have_count(0)
        expect(page.locator('.lesson-progress')).to_be_hidden()


@robot
def test_an_exercise_is_answered_in_a_form_in_place_of_its_cells_and_kept(page):
    form = page.get_by_role('form', name='Exercise 7.3a: Put three sources in order')
    check, score = form.get_by_role('button', name='Check', exact=True), form.get_by_role('status')
    for source in ('sources = [', "exercises.check('7.3a'"):
        expect(page.get_by_text(source)).to_have_count(0)
    check.click()
    expect(score).to_have_text('Exercise 7.3a: not yet, 0 of 2 done')
    expect(form.get_by_role('listitem').filter(has_text='not yet').first).to_contain_text('Which block is opened last?')
    page.reload()
    expect(score).to_have_text('Exercise 7.3a: not yet, 0 of 2 done')  # what was tried is kept, and not counted
    expect(page.locator('.lesson-mark')).to_have_count(0)
    down = form.get_by_role('button', name='Down: -p speed:=400')
    down.press('Enter')
    expect(down).to_be_focused()
    expect(score).to_be_hidden()
    down.press('Enter')
    form.get_by_role('button', name='Up: --params-file fast.yaml').click()
    check.click()
    expect(score).to_have_text('Exercise 7.3a: done, 2 of 2 done')
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 1 questions answered')
    page.reload()
    expect(score).to_have_text('Exercise 7.3a: done, 2 of 2 done')
    assert check_page(page) == []


@limits
def test_an_output_below_a_prediction_is_folded_until_one_commits_or_looks(page):
    form = page.locator('.rec-prediction').nth(1)
    shown, told = page.get_by_text('-20, -15, 0, 50 and 52', exact=True), page.get_by_text('Five of the eight')
    look = page.get_by_role('button', name='Commit to an answer, or look at that of question 6.1-2')
    expect(page.locator('.lesson-look')).to_have_count(1)  # below the other prediction no cell decides it
    expect(shown).to_be_hidden()
    expect(told).to_be_hidden()
    expect(look).to_have_attribute('aria-expanded', 'false')
    # What is too wide is scrolled by keyboard; the theme's script could not know, for what is hidden has no width.
    shown.evaluate('''each => {
        each.tabIndex = -1;
        each.style.cssText = 'width: 3em; white-space: pre; overflow: auto' }''')
    look.press('Enter')
    expect(shown).to_be_visible()
    expect(shown).to_have_attribute('tabindex', '0')
    expect(told).to_be_visible()
    expect(look).to_have_attribute('aria-expanded', 'true')
    look.press('Enter')
    expect(shown).to_be_hidden()
    page.emulate_media(media='print')
    expect(shown).to_be_visible()
    expect(look).to_be_hidden()
    page.emulate_media(media='screen')
    form.get_by_label('Your value').fill('4')
    form.get_by_label('Your value').press('Enter')
    expect(shown).to_be_visible()
    expect(look).to_be_hidden()
    page.reload()
    expect(shown).to_be_visible()


def test_without_a_script_nothing_is_folded(made, browser):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((made.target / '1_limits.html').as_uri())
    expect(page.get_by_text('-20, -15, 0, 50 and 52', exact=True)).to_be_visible()
    expect(page.locator('.lesson-look, .lesson-term')).to_have_count(0)
    context.close()


@limits
def test_a_word_of_the_glossary_is_explained_at_its_first_use_in_a_section(page):
    terms, meaning = page.locator('.lesson-term'), page.locator('.lesson-meaning')
    expect(terms).to_have_text(['callback', 'post-set callback', 'callback'])
    term = page.get_by_role('button', name='callback', exact=True).first
    expect(term).to_have_accessible_description('callback · a function that rclpy calls (chapter 1)')
    term.focus()
    expect(meaning).to_have_text('callback · a function that rclpy calls (chapter 1)')
    expect(meaning).to_be_in_viewport(ratio=1)
    page.keyboard.press('Escape')
    expect(meaning).to_be_hidden()
    expect(term).to_be_focused()
    page.keyboard.press('Enter')
    expect(meaning).to_be_visible()
    page.keyboard.press('Tab')
    expect(meaning).to_be_hidden()
    terms.nth(1).hover()
    expect(meaning).to_have_text('post-set callback · acts on what is stored (chapter 1)')
    meaning.hover()
    expect(meaning).to_be_visible()
    page.get_by_role('heading', level=1).hover()
    expect(meaning).to_be_hidden()


@limits
def test_a_link_brings_the_settings_of_a_panel_back(page):
    copy = page.get_by_role('button', name='Copy a link to these settings')
    expect(copy).to_be_disabled()
    type_into(page, 'power_w', '900')  # the node makes it 300
    type_into(page, 'high_c', '34')
    type_into(page, 'low_c', '30')  # which the node accepts after that alone
    type_into(page, 'name', 'Rex')
    copy.click()
    expect(page.locator('.rec-from-link')).to_have_text('The link is copied. It brings these settings back.')
    page.evaluate("document.body.append(Object.assign(document.createElement('textarea'), {id: 'here'}))")
    page.locator('#here').focus()
    page.keyboard.press('Control+v')
    address = page.locator('#here').input_value()
    page.goto('about:blank')
    page.goto(address)
    for name, text in (('power_w', '300'), ('high_c', '34'), ('low_c', '30'), ('name', 'Rex')):
        expect(box(page, name)).to_have_value(text)
    expect(page.locator('.rec-from-link')).to_have_text('These settings come from the link that brought you here.')
    expect(page.get_by_role('log', name='Log of /heater')).to_contain_text('power_w is now 300')
    assert check_page(page) == []


@limits
@pytest.mark.parametrize(('settings', 'said'), [
    ('{panel}?power_w=150&low_c=25', 'asks for low_c = 25, which this panel has not recorded as accepted.'),
    ('{panel}?power_w=150&__proto__=%3Cb%3E', 'asks for __proto__ = <b>, which'),
    ('nowhere?power_w=150', 'asks for settings of a panel that is not on this page.')])
def test_a_bad_link_is_ignored_with_a_sentence(page, settings, said):
    panel = page.locator('.rec-panel').get_attribute('id')
    page.evaluate('hash => { location.hash = hash }', f'#set-{settings.format(panel=panel)}')
    note = page.locator('.lesson-no-link' if 'nowhere' in settings else '.rec-from-link')
    expect(note).to_contain_text(said)
    expect(note).to_contain_text('It was ignored.')
    expect(box(page, 'power_w')).to_have_value('100')
    expect(box(page, 'low_c')).to_have_value('18')
    expect(page.get_by_role('button', name='Back to the start')).to_be_disabled()


@pytest.mark.parametrize('fault', [
    "IDBFactory.prototype.open = () => { throw new DOMException('', 'SecurityError') }",
    "IDBObjectStore.prototype.put = () => { throw new DOMException('', 'QuotaExceededError') }"])
def test_a_page_lives_where_the_browser_keeps_nothing(made, browser, fault):
    with open_page(browser, (made.target / '1_limits.html').as_uri()) as page:
        page.add_init_script(fault)
        page.reload()
        form = page.locator('.rec-prediction').first
        form.get_by_role('radio').first.check()
        form.get_by_role('button', name='Commit').click()
        expect(form.get_by_role('status')).not_to_be_empty()
        expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 2 questions answered')


def stop_the_clock(page):
    """Let the page's time pass only when a test says so: on a busy machine a drive would be over too early."""
    page.clock.install(time=0)
    page.clock.pause_at(1_000)


def start_to_drive(page):
    """Press the robot's button, with the clock stopped."""
    stop_the_clock(page)
    page.get_by_role('button', name='Drive').click()
    expect(page.locator('.robot-word')).to_have_text('SPEEDING UP')


def drive_to_the_end(page):
    """Press the robot's button, and let an hour of the page's time pass; its clock must be stopped."""
    page.get_by_role('button', name='Drive').click()
    expect(page.locator('.robot-film')).to_have_count(1)
    page.clock.fast_forward(3_600_000)
    expect(page.locator('.robot-film')).to_have_count(0)


@robot
def test_the_robot_drives_as_recorded(page):
    status = page.locator('.robot-says')
    stop_the_clock(page)
    page.get_by_role('button', name='Drive').click()
    # Under the pointer, too, its word can be read.
    assert page.get_by_role('button', name='Drive').evaluate(
        'each => getComputedStyle(each).color !== getComputedStyle(each).backgroundColor')
    expect(page.locator('.robot-word')).to_have_text('SPEEDING UP')
    assert page.evaluate('document.getAnimations().filter(each => /^robot-/.test(each.animationName)).length') > 0
    type_into(page, 'max_speed_rpm', '300')
    box(page, 'enable_safety_mode').uncheck()
    drive_to_the_end(page)
    expect(page.locator('.robot-word')).to_have_text('CRASHED')
    expect(page.get_by_role('img', name=re.compile('has run into the wall'))).to_be_visible()
    expect(status).to_contain_text('has run into the wall at')
    # What it says is what the node said, with these two values: v² = 2 a s = 2 · 0.5 m/s² · 4 m.
    expect(status).to_contain_text('at 2.00 m/s')


@robot
def test_a_drive_that_was_not_recorded_is_said_not_to_be(page):
    shown = page.locator('.robot-scene').inner_html()
    type_into(page, 'max_speed_rpm', '77')
    type_into(page, 'robot_name', 'Rex')
    expect(box(page, 'max_speed_rpm')).to_have_value('77')
    expect(page.locator('.rec-robot')).to_have_class(re.compile('rec-stale'))
    page.get_by_role('button', name='Drive').click()
    expect(page.locator('.robot-says')).to_contain_text(
        'Not recorded: no drive with max_speed_rpm = 77, robot_name = Rex.')
    assert page.locator('.robot-scene').inner_html() == shown
    page.get_by_role('button', name='Back to the start').click()
    expect(page.locator('.rec-robot')).not_to_have_class(re.compile('rec-stale'))


@robot
def test_a_reader_who_wants_no_motion_sees_each_phase_where_it_begins(page):
    """As in JupyterLab: the picture jumps, and the words come in their time."""
    page.emulate_media(reduced_motion='reduce')
    stop_the_clock(page)
    page.get_by_role('button', name='Drive').click()
    x = 'each => new DOMMatrix(getComputedStyle(each).transform).e'
    places = []
    for word, milliseconds in (('SPEEDING UP', 2_200), ('CRUISING', 1_700), ('BRAKING', 60_000), ('STOPPED', 0)):
        expect(page.locator('.robot-word')).to_have_text(word)
        expect(page.get_by_role('img', name=re.compile(f'^{word}'))).to_be_visible()
        places.append(page.locator('.robot-mover').evaluate(x))
        assert page.evaluate("document.getAnimations().filter(each => each.playState === 'running').length") == 0
        page.clock.fast_forward(milliseconds)
    assert places == sorted(set(places))


@robot
def test_a_change_on_the_way_takes_effect_on_the_way(page):
    start_to_drive(page)
    page.clock.run_for(500)
    box(page, 'enable_safety_mode').uncheck()
    # It goes on from where it is then, a moment later; nothing stops it any more.
    head = page.locator('.robot-head')
    wait_for(lambda: page.clock.run_for(10) or 'safety off' in head.inner_text(), 'the change to take effect')
    expect(page.locator('.robot-word')).to_have_text('SPEEDING UP')
    type_into(page, 'max_speed_rpm', '300')
    page.clock.fast_forward(1_000)
    expect(page.locator('.robot-says')).to_have_text('The next drive will show the change.')
    page.clock.fast_forward(60_000)
    # As fast as before the second change.
    expect(page.locator('.robot-says')).to_have_text('Clawbot has run into the wall at 1.05 m/s.')


@limits
def test_a_box_says_what_was_recorded_before_anyone_types(page):
    expect(row(page, 'power_w').locator('.param-help')).to_contain_text('Recorded: -20 to 200 in steps of 1, and')
    name = box(page, 'name')
    assert name.evaluate("each => [...each.list.options].map(option => option.value).includes('Rex')")


def test_a_browser_that_cannot_unpack_the_recordings_says_so(made, browser):
    page = browser.new_page()
    page.add_init_script('delete globalThis.DecompressionStream')
    page.goto((made.target / '1_limits.html').as_uri())
    page.wait_for_selector('html[data-lesson=ready]', state='attached')
    expect(page.locator('.rec-panel .rec-dead')).to_contain_text('has no DecompressionStream')
    expect(box(page, 'power_w')).to_be_disabled()
    page.close()


@limits
def test_a_button_copies_the_code_of_a_cell(page):
    cell = page.locator('div.cell_input').nth(1)
    cell.hover()
    cell.get_by_role('button', name='Copy the code of this cell').click()
    expect(cell.locator('.lesson-copy')).to_have_text('Copied')
    page.evaluate("document.body.append(Object.assign(document.createElement('textarea'), {id: 'here'}))")
    page.locator('#here').focus()
    page.keyboard.press('Control+v')
    expect(page.locator('#here')).to_have_value("panel = ParameterPanel('/heater')\npanel")


@limits
def test_paper_is_white_and_all_code_is_on_it(page):
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    page.emulate_media(media='print')
    dark_on_white = page.evaluate('''() => {
        const brightness = color => color.match(/[\\d.]+/g).slice(0, 3).reduce((sum, each) => sum + Number(each), 0);
        return [...document.querySelectorAll('.bd-article p, .bd-article h1, .cell_input span')].filter(each =>
          each.textContent.trim() && brightness(getComputedStyle(each).color) > 450).length }''')
    assert dark_on_white == 0
    assert page.locator('.cell_input .highlight pre').first.evaluate(
        'each => getComputedStyle(each).whiteSpace') == 'pre-wrap'
    assert page.locator('.bd-article h1').evaluate('each => getComputedStyle(each).breakAfter') == 'avoid'
    for whole in ('.cell_input', '.rec', '.rec-prediction'):
        assert page.locator(whole).first.evaluate('each => getComputedStyle(each).breakInside') == 'avoid'
    announced = page.get_by_text('Two predictions, one to choose').evaluate('each => getComputedStyle(each).breakAfter')
    assert announced == 'avoid'
    expect(page.get_by_role('button', name='Commit')).to_have_count(0)


@pytest.mark.parametrize('way', ['file', 'server'])
def test_every_page_from_the_disk_and_from_a_server(made, browser, way):
    with served(made.target) if way == 'server' else contextlib.nullcontext(made.target.as_uri()) as address:
        for name in ('index', '1_limits', '2_robot'):
            with open_page(browser, f'{address}/{name}.html') as page:
                expect(page.get_by_role('navigation', name='Lessons')).to_be_visible()
                expect(page.get_by_role('heading', level=1)).to_have_count(1)
        with open_page(browser, f'{address}/index.html') as page:
            page.keyboard.press('Control+k')
            page.keyboard.type('table')
            dialog = page.get_by_role('dialog', name='Search')
            expect(dialog.get_by_role('option')).to_have_text(re.compile('^Next 1 · Limits A table, and a link to '))
            expect(dialog.get_by_role('option').locator('mark')).to_have_text('table')
            expect(dialog.get_by_role('status')).to_have_text('1 section found.')
            page.keyboard.press('ArrowDown')
            page.keyboard.press('Enter')
            expect(page).to_have_url(re.compile(r'/1_limits\.html#next$'))
            expect(page.get_by_role('heading', name='Next')).to_be_in_viewport()


@limits
def test_the_search_by_keyboard(page):
    page.keyboard.press('Control+k')
    box = page.get_by_role('combobox', name='Search the lessons …')
    options = page.get_by_role('option')
    expect(box).to_be_focused()
    expect(box).to_have_attribute('aria-expanded', 'false')
    page.keyboard.type('controls')
    # "Control" is another form of the word; the code that says ParameterPanel is not.
    expect(options).to_have_count(2)
    expect(box).to_have_attribute('aria-expanded', 'true')
    chosen = page.locator('[role=option][aria-selected=true]')
    for key, position in (('ArrowDown', 0), ('ArrowDown', 1), ('ArrowDown', None), ('ArrowUp', 1), ('ArrowUp', 0),
                          ('ArrowUp', None)):
        page.keyboard.press(key)
        expect(chosen).to_have_count(0 if position is None else 1)
        pointed = box.get_attribute('aria-activedescendant')
        assert pointed == (None if position is None else options.nth(position).get_attribute('id'))
        expect(box).to_be_focused()
    box.fill('nobody wrote this')
    expect(options).to_have_count(0)
    expect(page.get_by_role('dialog').get_by_role('status')).to_have_text('Nothing found.')
    page.keyboard.press('Escape')
    expect(page.get_by_role('dialog')).to_have_count(0)


@limits
def test_enter_without_a_choice_shows_all_hits_on_a_page_with_an_address(page):
    page.keyboard.press('Control+k')
    page.keyboard.type('heater')
    page.keyboard.press('Enter')
    expect(page).to_have_url(re.compile(r'/search\.html\?q=heater$'))
    box = page.get_by_role('combobox')
    expect(box).to_have_value('heater')
    expect(page.get_by_role('option').first).to_contain_text('1 · Limits')
    box.fill('safety mode')
    expect(page).to_have_url(re.compile(r'/search\.html\?q=safety%20mode$'))
    expect(page.get_by_role('option')).to_contain_text(['2 · A robot'])
    assert check_page(page) == []


@pytest.mark.parametrize('scheme', ['light', 'dark'])
def test_nothing_that_axe_finds_in_the_open_search(made, browser, scheme):
    with open_page(browser, (made.target / '1_limits.html').as_uri(), scheme=scheme) as page:
        page.keyboard.press('Control+k')
        page.keyboard.type('node')
        page.get_by_role('option').first.wait_for()
        page.keyboard.press('ArrowDown')
        assert check_page(page) == []


def test_what_the_search_does_not_give_away(made):
    index = (made.target / 'searchindex.js').read_text()
    assert 'Its controls' in index and 'a line' in index
    for hidden in ('Right.', 'Not so.', 'rec-data', '85 is off the step'):
        assert hidden not in index


@pytest.mark.parametrize('scheme', ['light', 'dark'])
@pytest.mark.parametrize('name', ['index', '1_limits', '2_robot', 'search'])
def test_nothing_that_axe_finds(made, browser, scheme, name):
    with open_page(browser, (made.target / f'{name}.html').as_uri(), scheme=scheme, width=390) as page:
        assert check_page(page) == []


def test_search_engines_and_messengers_learn_what_a_page_is(made):
    html = (made.target / '1_limits.html').read_text()
    assert '<meta name="description" content="What does a node say?">' in html
    assert '<meta property="og:title" content="1 · Limits">' in html
    assert '<link rel="canonical" href="https://lessons.example/ros/1_limits.html"' in html
    assert re.findall('<loc>(.*?)</loc>', (made.target / 'sitemap.xml').read_text()) == [
        f'https://lessons.example/ros/{name}.html' for name in ('index', '1_limits', '2_robot')]
    assert 'There is no such page' in (made.target / '404.html').read_text()


def test_the_course_is_in_the_site_with_the_way_to_start_it(made):
    html = (made.target / '1_limits.html').read_text()
    assert 'href="param-course.zip"' in html and '<code>make lab</code>' in html
    with zipfile.ZipFile(made.target / 'param-course.zip') as course:
        names = set(course.namelist())
        assert course.testzip() is None
        makefile = course.read('param-course/Makefile')
    assert makefile == (ROOT / 'Makefile').read_bytes()
    assert {'param-course/README.md', 'param-course/notebooks/01_what_are_parameters.ipynb'} <= names
    assert not any('/build/' in name or '/.venv/' in name for name in names)


def test_links_lead_where_the_site_has_something(made):
    html = (made.target / '1_limits.html').read_text()
    assert 'href="2_robot.html"' in html
    assert (made.target / 'notebooks/1_limits.ipynb').read_bytes() == (made.notebooks / '1_limits.ipynb').read_bytes()
    assert 'href="notebooks/1_limits.ipynb"' in html


def test_building_again_changes_nothing_and_runs_nothing(made, capsys):
    before = files(made.target)
    made.build()
    assert '2 of 2 chapters have not changed' in capsys.readouterr().out
    assert files(made.target) == before


def test_recording_again_gives_the_same_answers(made):
    kept = json.loads((made.work / 'recordings' / '2_robot.json').read_text())['recordings']
    assert run.record_chapter(made.notebooks / '2_robot.ipynb') == kept


def test_a_page_that_sphinx_warns_of_stops_the_build(made, tmp_path):
    (tmp_path / 'source').mkdir()
    (tmp_path / 'source' / 'index.md').write_text('# Start\n\n[nowhere](nowhere.ipynb)\n')
    writing.write_static(tmp_path / 'source')
    with pytest.raises(writing.BuildError, match='nowhere'):
        writing.write_pages(tmp_path / 'source', tmp_path / 'html', tmp_path / 'doctrees')


def test_a_chapter_that_fails_stops_the_build_and_the_old_site_stays(made, tmp_path):
    before = files(made.target)
    notebooks = tmp_path / 'notebooks'
    shutil.copytree(made.notebooks, notebooks)
    nbformat.write(nbformat.v4.new_notebook(cells=[
        nbformat.v4.new_markdown_cell('# 3 · Broken'),
        nbformat.v4.new_code_cell('undefined', execution_count=1)]), notebooks / '3_broken.ipynb')
    with pytest.raises(run.ChapterError, match=r'3_broken\.ipynb, cell 2 \(undefined\): it raises NameError'):
        Site(notebooks, made.target, made.work).build()
    assert files(made.target) == before


def test_one_lesson_as_one_file(made, browser, tmp_path):
    site = Site(made.notebooks, made.target, made.work, ['1'])
    alone = tmp_path / 'lesson.html'
    shutil.move(single.build(site), alone)
    with open_page(browser, alone.as_uri()) as page:
        type_into(page, 'low_c', '25')
        expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')
        expect(page.locator('.lesson-download')).to_contain_text('This file is one lesson of the course')
        assert check_page(page) == []
        assert page.locator('a[href$=".ipynb"], a[href="2_robot.html"]').count() == 0
        loaded = page.evaluate("performance.getEntriesByType('resource').map(each => each.name)"
                               '.filter(name => !/^(data|blob):/.test(name))')
    assert loaded == []


def test_a_chapter_that_is_not_there(made, tmp_path):
    with pytest.raises(writing.BuildError, match=r'there is no chapter 7 in .*1_limits, 2_robot'):
        Site(made.notebooks, tmp_path, tmp_path, ['7'])
    with pytest.raises(writing.BuildError, match='more than one chapter: 1_limits, 2_robot'):
        single.build(Site(made.notebooks, tmp_path, tmp_path, ['1', '2']))


# -- the same site in Firefox -------------------------------------------------------------------------------


@pytest.fixture(scope='module')
def firefox_page(tmp_path_factory):
    """The tab of a Firefox; nothing may be complained of. In CI a missing Firefox is a failure."""
    if FIREFOX is None:
        missing.skip('there is no Firefox on the PATH: apt-get install firefox-esr')
    with firefox(tmp_path_factory.mktemp('profile')) as page:
        yield page
        assert page.complaints == []


def show_in_firefox(page, path):
    page.open(path.as_uri())
    page.wait_for("document.documentElement.dataset.lesson === 'ready'")


CONTROLS = """[...document.querySelectorAll('.param-row :is(input, textarea), .rec-prediction input')].map(
    each => ['checkbox', 'radio'].includes(each.type) ? each.checked : each.value)"""
MESSAGE = "document.querySelector('.param-row[data-name=%s] .param-message')?.textContent"


def test_all_controls_begin_anew_after_a_reload_in_firefox(made, firefox_page):
    """Firefox restores the values of a form unless the page forbids it; then a control and its picture differ."""
    show_in_firefox(firefox_page, made.target / '1_limits.html')
    before = firefox_page.evaluate(CONTROLS)
    firefox_page.click('.rec-prediction input[type=radio]')
    firefox_page.click('.param-row[data-name=on] input')
    firefox_page.click('.param-row[data-name=low_c] input[type=range]')
    firefox_page.click('.param-row[data-name=name] input')
    firefox_page.press('x')
    firefox_page.wait_for(f'{MESSAGE % "on"} && {MESSAGE % "low_c"}')
    assert sum(one != other for one, other in zip(before, firefox_page.evaluate(CONTROLS), strict=True)) >= 4
    firefox_page.reload()
    firefox_page.wait_for("document.documentElement.dataset.lesson === 'ready'")
    assert firefox_page.evaluate(CONTROLS) == before


def test_firefox_keeps_a_prediction_and_marks_it_on_the_first_page(made, firefox_page):
    show_in_firefox(firefox_page, made.target / '1_limits.html')
    firefox_page.click('.rec-prediction input[type=radio]')
    firefox_page.click('.rec-prediction .rec-commit')
    firefox_page.reload()
    firefox_page.wait_for("document.querySelector('.rec-prediction .rec-says').textContent.trim()")
    firefox_page.open((made.target / 'index.html').as_uri())
    firefox_page.wait_for("document.querySelector('.front-lessons .lesson-mark')?.title.startsWith('1 of 2 ')")
    firefox_page.click('.lesson-progress button')
    firefox_page.wait_for("!document.querySelector('.lesson-mark')")


def test_the_robot_drives_in_firefox(made, firefox_page):
    show_in_firefox(firefox_page, made.target / '2_robot.html')
    firefox_page.click('.param-row[data-name=enable_safety_mode] input')
    firefox_page.click('.robot-drive')
    firefox_page.wait_for("document.getAnimations().some(each => each.animationName?.startsWith('robot-'))")
    firefox_page.wait_for("document.querySelector('.robot-says').textContent.includes('has run into the wall')")


def test_the_search_in_firefox_from_the_disk(made, firefox_page):
    show_in_firefox(firefox_page, made.target / 'index.html')
    firefox_page.click('.search-button__button')
    firefox_page.press(*'table')
    firefox_page.wait_for("document.querySelector('.search-hit mark')?.textContent === 'table'")
    firefox_page.press(FIREFOX_DOWN, FIREFOX_ENTER)
    firefox_page.wait_for("location.href.endsWith('/1_limits.html#next')")
