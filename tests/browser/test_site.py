"""The HTML lessons in Chromium, with the network off: what readers see, what they can do, and what the page says.

A site of two small chapters, made once for all tests; each page runs its own Python and its own nodes. CI holds the
pages of the course to the same rules when it has built them, see `tests/tools/site_rules.py`.
"""

import re
import shutil
import zipfile

import nbformat
import pytest
from nbclient import NotebookClient
from playwright.sync_api import expect

from param_tutorial.site import single
from param_tutorial.site.browser import page_python
from param_tutorial.site.build import Site
from param_tutorial.site.live.running import ChapterError
from param_tutorial.site.pages import writing
from tests.support import lesson, missing
from tests.support.firefox import FIREFOX, firefox
from tests.support.lab import ROOT
from tests.support.server import Server
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
    '## Next\n\nA table, and a link to [the other one](2_robot.ipynb).\n\n'
    '| a | b |\n| --- | --- |\n| 1 | 2 |',
    "print('the end')\n1 / 0",
)
ROBOT = (
    '# 2 · A robot\n\n**Does it move?**',
    'import rclpy\n\nimport param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import LinePlot, RobotView\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    'ros = param_tutorial.start()\nrobot = ros.add(ClawbotNode)\nview = RobotView(robot)\nview',
    'Its controls:',
    "ParameterPanel(robot, names=['max_speed_rpm', 'enable_safety_mode', 'robot_name'])",
    'Another name:',
    "robot.set_parameters([rclpy.Parameter('robot_name', value='Rex')])\nview",
    'A picture:',
    "LinePlot({'a line': [(0, 0), (1, 2)]}, x='time in s', y='speed in m/s')",
    'A picture that is drawn anew:',
    "import ipywidgets\n\nscene = ipywidgets.HTML('<div class=\"motion-scene\" style=\"overflow-x: auto\">'\n"
    "                        '<svg viewBox=\"0 0 720 60\" style=\"min-width: 690px\">'\n"
    "                        '<text x=\"100\" y=\"30\">the first</text></svg></div>')\nscene",
    "scene.value = scene.value.replace('first', 'second')",
    'A text with a shape, and a sentence:',
    "print('/heater:\\n  ros__parameters:\\n    label: ' + 'a long name ' * 9)",
    "print('A sentence goes on' + ' and on' * 20)",
    '## Two sources\n\nThe later one wins.',
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
    NotebookClient(notebook, kernel_name='python3', store_widget_state=False, coalesce_streams=True,
                   resources={'metadata': {'path': str(path.parent)}}).execute()
    nbformat.write(notebook, path)


# In WebDriver's table of keys.
FIREFOX_ENTER, FIREFOX_DOWN = '\ue007', '\ue015'


@pytest.fixture(scope='module')
def made(tmp_path_factory):
    """Build a site, and yield it. In CI a missing Pyodide is a failure; elsewhere the tests are skipped."""
    if not page_python.PYODIDE.exists():
        missing.skip('there is no Pyodide in environment/node_modules: `make html` gets it')
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
    (notebooks / 'claims.md').write_text('# The claims\n\n| id | claim | verdict |\n| --- | --- | --- |\n'
                                        '| A001 | one | true: so it is |\n| A002 | two | false |\n')
    site = Site(notebooks, folder / 'html', folder / 'work', address='https://lessons.example/ros')
    site.build()
    return site


@pytest.fixture
def page(made, browser, request):
    """Return a chapter's page, from the disk; nothing may be requested elsewhere, or complained of."""
    with open_page(browser, (made.target / request.param).as_uri()) as page:
        yield page


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


def wait_for_the_node(page):
    """Wait until the page's node has done all that it was asked."""
    page.wait_for_function(
        "document.documentElement.dataset.node === 'awake' && !document.querySelector('[aria-busy]')", timeout=60_000)


@limits
def test_any_value_is_answered_by_the_node_in_the_page(page):
    # What is typed before there is a node waits for it; everything stands on the page meanwhile.
    type_into(page, 'power_w', '150')
    expect(page.locator('.live-notice')).to_contain_text('Waking the node')
    expect(page.get_by_role('log', name='Log of /heater')).to_contain_text('power_w is now 150', timeout=60_000)
    wait_for_the_node(page)
    expect(page.locator('.live-notice')).to_be_hidden()
    rows = page.get_by_role('log', name='Changes of all nodes').get_by_role('row')
    log = page.get_by_role('log', name='Log of /heater')
    expect(log).to_contain_text('[INFO] [heater]: power_w is now 150')
    expect(box(page, 'power_w')).to_have_value('150')
    type_into(page, 'power_w', '900')
    expect(box(page, 'power_w')).to_have_value('300')
    expect(message(page, 'power_w')).to_have_text('You asked for 900, and the node has stored 300.')
    for text in ('Nobody thought of this', '__proto__', 'Robin 7'):
        type_into(page, 'name', text)
        expect(log).to_contain_text(f'name is now {text}')
    expect(rows.filter(has_text='Robin 7')).to_have_count(1)  # it comes through another topic than the log
    count = rows.count()
    type_into(page, 'low_c', '25')
    expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')
    expect(box(page, 'low_c')).to_have_value('18')
    expect(row(page, 'low_c').get_by_role('slider')).to_have_value('18')
    type_into(page, 'low_c', '35')
    expect(message(page, 'low_c')).to_contain_text('Rejected: ')
    type_into(page, 'low_c', 'fast')
    expect(message(page, 'low_c')).to_have_text(
        "Rejected: 'fast' cannot be read: low_c takes an integer, e.g. 42")
    expect(rows).to_have_count(count)  # what was rejected is told to nobody
    # Any combination, in any order.
    type_into(page, 'high_c', '20')
    expect(log).to_contain_text('high_c is now 20')
    type_into(page, 'low_c', '21')
    expect(message(page, 'low_c')).to_have_text('Rejected: 21 is not below 20')
    page.get_by_role('button', name='Undo').click()
    expect(box(page, 'high_c')).to_have_value('22')
    slider = row(page, 'low_c').get_by_role('slider')
    slider.focus()
    page.keyboard.press('ArrowLeft')
    expect(box(page, 'low_c')).to_have_value('17')
    expect(slider).to_have_attribute('aria-valuetext', '17')
    box(page, 'on').focus()
    page.keyboard.press('Space')
    expect(box(page, 'on')).not_to_be_checked()
    type_into(page, 'levels', '[1, 2, 3]')
    expect(log).to_contain_text('levels is now')
    expect(box(page, 'serial')).to_be_disabled()
    # No row has moved away from under the hand.
    expect(row(page, 'low_c').locator('.param-back')).to_be_visible()
    assert check_page(page) == []


@limits
def test_settings_stand_in_the_address_and_a_reload_brings_them_back(page):
    for name, text in (('high_c', '34'), ('low_c', '30'), ('name', 'Rex & Co')):  # in no other order
        type_into(page, name, text)
    page.wait_for_function("location.search.includes('Rex')", timeout=60_000)
    page.goto('about:blank')
    page.go_back()
    for name, text in (('name', 'Rex & Co'), ('high_c', '34'), ('low_c', '30')):
        expect(box(page, name)).to_have_value(text, timeout=60_000)
    page.get_by_role('button', name='Reset').click()
    expect(box(page, 'low_c')).to_have_value('18')
    page.wait_for_function("!location.search.includes('low_c')")


@limits
def test_an_address_names_only_what_is_there_when_it_is_followed(page):
    cell_with(page, "ParameterPanel('/heater')").get_by_role('button', name='Run this cell').click()
    wait_for_the_node(page)
    own = cell_with(page, 'the end')
    editor = edit(own, "ParameterPanel('/heater')")
    editor.press('Shift+Enter')
    name = own.get_by_label('name', exact=True)
    name.fill('Rex')
    name.press('Enter')
    expect(box(page, 'name')).to_have_value('Rex', timeout=60_000)
    assert 'Rex' not in page.url
    type_into(page, 'power_w', '150')
    page.wait_for_function("location.search.includes('150')")
    page.reload()
    expect(box(page, 'power_w')).to_have_value('150', timeout=60_000)
    expect(page.locator('.lesson-no-link')).to_have_count(0)


def test_an_address_that_asks_for_what_is_not_there_is_ignored_with_a_sentence(made, browser):
    address = (made.target / '1_limits.html').as_uri()
    with open_page(browser, f'{address}?nowhere:power_w=150&cell/1/1:__proto__=%3Cb%3E') as page:
        note = page.locator('.lesson-no-link')
        expect(note).to_contain_text('asks for something that is not on this page. It was ignored.')
        expect(box(page, 'power_w')).to_have_value('100')


def cell_with(page, code):
    """Return the cell with some code, also when that is another one later."""
    found = page.locator('div.cell', has=page.get_by_text(code)).first
    return page.locator('.' + found.evaluate("each => [...each.classList].find(name => name.startsWith('tag_live-'))"))


def edit(cell, code):
    """Write code into a cell, and return the box in which it stands."""
    cell.get_by_role('button', name='Edit the code of this cell').click()
    editor = cell.get_by_role('textbox', name='The code of this cell')
    editor.fill(code)
    return editor


@limits
def test_a_cell_is_edited_and_run_and_kept(page):
    cell = cell_with(page, 'panel.settle()')
    cell.hover()
    editor = edit(cell, "panel['power_w'].value = 120\npanel.settle()\nprint(panel['power_w'].value + 1)")
    editor.press('Shift+Enter')
    expect(cell.locator('.cell_output')).to_have_text('121', timeout=60_000)
    wait_for_the_node(page)
    expect(box(page, 'power_w')).to_have_value('120')
    editor.fill('1 / 0')
    cell.get_by_role('button', name='Run this cell').click()
    expect(cell.locator('.cell_output')).to_contain_text('ZeroDivisionError')
    page.reload()
    expect(cell.get_by_role('textbox', name='The code of this cell')).to_have_value('1 / 0')
    assert not page.evaluate("document.documentElement.dataset.node === 'waking'")  # nothing runs without a click
    cell.get_by_role('button', name='Bring back the code of the lesson').click()
    expect(cell.get_by_text('panel.settle()')).to_be_visible()
    page.reload()
    expect(cell.get_by_text('panel.settle()')).to_be_visible()


@limits
def test_a_cell_that_never_ends_is_stopped(page):
    cell = cell_with(page, 'panel.settle()')
    editor = edit(cell, 'while True:\n    pass')
    editor.press('Shift+Enter')
    stop = page.get_by_role('button', name='Stop it')
    expect(stop).to_be_visible()
    assert check_page(page) == []
    stop.click()
    expect(stop).to_be_hidden()
    expect(editor).to_have_value('while True:\n    pass')
    type_into(page, 'low_c', '25')
    expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')


@limits
def test_the_readers_code_reaches_no_network(page):
    cell = cell_with(page, 'panel.settle()')
    editor = edit(cell, 'from js import fetch\ntry:\n    await fetch("https://example.org/")\n'
                        'except Exception as error:\n    print("no way out")')
    # What the policy forbids the browser reports; that is the proof, and no complaint.
    page.evaluate("document.addEventListener('securitypolicyviolation', event => event.preventDefault())")
    editor.press('Shift+Enter')
    expect(cell.locator('.cell_output')).to_have_text('no way out', timeout=60_000)


@limits
def test_the_panel_shows_the_state_in_which_the_cell_ran(page):
    expect(box(page, 'low_c')).to_have_value('18')
    expect(page.locator('.cell_output').get_by_text('19', exact=True)).to_be_visible()


@limits
def test_a_prediction_by_keyboard(page):
    form = page.locator('.lesson-prediction').first
    commit = form.get_by_role('button', name='Commit')
    expect(commit).to_be_disabled()
    form.get_by_role('radio').first.focus()
    page.keyboard.press('Space')
    page.keyboard.press('ArrowDown')
    page.keyboard.press('Tab')
    page.keyboard.press('Enter')
    expect(form.get_by_role('status')).to_contain_text('Right. 85 is off the step too')
    expect(form.get_by_role('radio').first).to_be_disabled()
    assert [each.get_attribute('data-mark') for each in form.locator('label').all()] == [None, 'right', None, None]
    expect(form.get_by_role('button', name='Answer again')).to_be_focused()
    expect(page.get_by_text("exercises.predict('6.1-1')")).to_have_count(0)


@limits
@pytest.mark.parametrize(('typed', 'said'), [(' 5,0 values', 'Right. -20, -15'), ('4', 'Not so. There is one more'),
                                             ('7', 'Not so. It accepts five')])
def test_a_prediction_that_is_typed(page, typed, said):
    form = page.locator('.lesson-prediction').nth(1)
    box = form.get_by_label('Your number')
    box.fill(typed)
    box.press('Enter')
    expect(form.get_by_role('status')).to_contain_text(said)


@limits
def test_a_word_in_place_of_a_number_is_asked_again(page):
    form = page.locator('.lesson-prediction').nth(1)
    box, marks = form.get_by_label('Your number'), page.locator('.lesson-mark')
    box.fill('many')
    box.press('Enter')
    expect(form.get_by_role('status')).to_contain_text('Please answer with a number')
    expect(box).to_be_enabled()
    expect(marks).to_have_count(0)
    box.fill('5')
    box.press('Enter')
    expect(form.get_by_role('status')).to_contain_text('Right. -20, -15')


def test_predictions_are_kept_in_the_browser_and_marked_beside_the_lessons(made, browser):
    with open_page(browser, (made.target / '1_limits.html').as_uri()) as page:
        marks = page.get_by_role('navigation', name='Lessons').locator('.lesson-mark')
        chosen, typed = (page.locator('.lesson-prediction').nth(number) for number in (0, 1))
        expect(marks).to_have_count(0)
        chosen.get_by_role('radio').nth(1).check()
        chosen.get_by_role('button', name='Commit').click()
        expect(marks).to_have_attribute('title', '1 of 2 questions answered')
        typed.get_by_label('Your number').fill('7 values')
        typed.get_by_label('Your number').press('Enter')
        expect(marks).to_have_text('✓ (2 of 2 questions answered)')
        said = chosen.get_by_role('status').inner_text()
        page.reload()
        expect(chosen.get_by_role('status')).to_have_text(said)
        expect(chosen.get_by_role('radio').nth(1)).to_be_checked()
        expect(chosen.get_by_role('radio').nth(1)).to_be_disabled()
        expect(typed.get_by_label('Your number')).to_have_value('7 values')
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
def test_an_exercise_is_solved_in_its_cell_and_remembered(page):
    exercise, check = (page.locator(f'.tag_live-{name}-7-3a') for name in ('exercise', 'check'))
    check.get_by_role('button', name='Run this cell').click()
    expect(check.locator('.param-check')).to_contain_text('Exercise 7.3a: not yet, 0 of 2 done', timeout=60_000)
    wait_for_the_node(page)
    check.get_by_role('link', name='“Two sources”').first.click()
    expect(page.get_by_role('heading', name='Two sources')).to_be_in_viewport()
    expect(page).to_have_url(re.compile('#Two-sources$'))
    expect(page.locator('.lesson-mark')).to_have_count(0)
    edit(exercise, SOLVED)
    exercise.get_by_role('button', name='Run this cell').click()
    check.get_by_role('button', name='Run this cell').click()
    expect(check.locator('.param-check')).to_contain_text('Exercise 7.3a: done, 2 of 2 done')
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 1 questions answered')
    expect(page.locator('.lesson-here').first).to_have_text('1 of 1 answered')
    page.reload()
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 1 questions answered')
    expect(exercise.get_by_role('textbox', name='The code of this cell')).to_have_value(SOLVED)


@limits
def test_an_output_below_a_prediction_is_folded_until_one_commits_or_looks(page):
    form = page.locator('.lesson-prediction').nth(1)
    shown, told = page.get_by_text('-20, -15, 0, 50 and 52', exact=True), page.get_by_text('Five of the eight')
    look = page.get_by_role('button', name='Commit to an answer, or look at that of question 6.1-2')
    expect(page.locator('.lesson-look')).to_have_count(1)  # below the other prediction no cell decides it
    expect(shown).to_be_hidden()
    expect(told).to_be_hidden()
    # Paper hides nothing.
    page.emulate_media(media='print')
    expect(shown).to_be_visible()
    page.emulate_media(media='screen')
    # What is too wide is scrolled by keyboard; the theme's script could not know, for what is hidden has no width.
    shown.evaluate('''each => {
        each.tabIndex = -1;
        each.classList.remove('lesson-sentences');
        each.style.width = '3em' }''')
    look.press('Enter')
    expect(shown).to_be_visible()
    expect(shown).to_have_attribute('tabindex', '0')
    expect(told).to_be_visible()
    expect(look).to_have_count(0)
    page.reload()
    expect(shown).to_be_hidden()
    form.get_by_label('Your number').fill('4')
    form.get_by_label('Your number').press('Enter')
    expect(shown).to_be_visible()
    expect(look).to_have_count(0)
    page.reload()
    expect(shown).to_be_visible()


def test_without_a_script_nothing_is_folded(made, browser):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((made.target / '1_limits.html').as_uri())
    expect(page.get_by_text('-20, -15, 0, 50 and 52', exact=True)).to_be_visible()
    expect(page.locator('.lesson-look')).to_have_count(0)
    # The theme has colors for a light page and for a dark one, and none for a page that is neither.
    expect(page.locator('html')).to_have_attribute('data-theme', 'light')
    context.close()


@pytest.mark.parametrize('fault', [
    "IDBFactory.prototype.open = () => { throw new DOMException('', 'SecurityError') }",
    "IDBObjectStore.prototype.put = () => { throw new DOMException('', 'QuotaExceededError') }"])
def test_a_page_lives_where_the_browser_keeps_nothing(made, browser, fault):
    with open_page(browser, (made.target / '1_limits.html').as_uri()) as page:
        page.add_init_script(fault)
        page.reload()
        # Until then the page is being laid out, and a click may miss.
        page.wait_for_function("document.documentElement.dataset.lesson === 'ready'")
        form = page.locator('.lesson-prediction').first
        form.get_by_role('radio').first.check()
        form.get_by_role('button', name='Commit').click()
        expect(form.get_by_role('status')).not_to_be_empty()
        expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 2 questions answered')


@robot
def test_the_robot_drives_as_its_node_does_and_stays_where_it_ended(page):
    word, says = page.locator('.robot-word').first, page.locator('.robot-says').first
    type_into(page, 'max_speed_rpm', '300')
    box(page, 'enable_safety_mode').uncheck()
    page.get_by_role('button', name='Drive').first.click()
    expect(word).to_have_text('SPEEDING UP', timeout=60_000)
    # v² = 2 a s = 2 · 0.5 m/s² · 4 m.
    expect(says).to_contain_text('has run into the wall at 2.00 m/s', timeout=60_000)
    expect(word).to_have_text('CRASHED')
    expect(page.get_by_role('img', name=re.compile('has run into the wall')).first).to_be_visible()
    box(page, 'enable_safety_mode').check()
    expect(page.locator('.robot-head').first).to_contain_text('safety on')
    expect(word).to_have_text('CRASHED')


@robot
def test_a_touch_runs_no_step_of_the_lesson_below_it(page):
    type_into(page, 'max_speed_rpm', '120')
    page.wait_for_function("location.search.includes('max_speed_rpm=120')", timeout=60_000)
    wait_for_the_node(page)
    expect(box(page, 'robot_name')).to_have_value('Clawbot')
    cell_with(page, "value='Rex'").get_by_role('button', name='Run this cell').click()
    expect(box(page, 'robot_name')).to_have_value('Rex')
    assert 'Rex' not in page.url  # the lesson does it again


@robot
def test_a_change_on_the_way_takes_effect_on_the_way(page):
    page.get_by_role('button', name='Drive').first.click()
    expect(page.locator('.robot-word').first).to_have_text('SPEEDING UP', timeout=60_000)
    box(page, 'enable_safety_mode').uncheck()
    expect(page.locator('.robot-head').first).to_contain_text('safety off')
    expect(page.locator('.robot-says').first).to_contain_text('has run into the wall', timeout=60_000)


@pytest.mark.parametrize('page', ['claims.html'], indirect=True)
def test_claims_are_filtered_by_verdict(page):
    choice = page.get_by_label('Show')
    choice.select_option('false')
    expect(page.get_by_role('cell', name='two')).to_be_visible()
    expect(page.get_by_role('cell', name='one')).to_be_hidden()
    expect(page.get_by_text('1 of 2 claims')).to_be_visible()
    assert check_page(page) == []
    choice.select_option('all claims')
    expect(page.get_by_role('cell', name='one')).to_be_visible()


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
    for whole in ('.cell_input', '.live-view', '.lesson-prediction'):
        assert page.locator(whole).first.evaluate('each => getComputedStyle(each).breakInside') == 'avoid'
    announced = page.get_by_text('Two predictions, one to choose').evaluate('each => getComputedStyle(each).breakAfter')
    assert announced == 'avoid'
    expect(page.get_by_role('button', name='Commit')).to_have_count(0)
    # Of a flexible box Chromium prints no more than would fit if no page came to an end.
    assert page.locator('.bd-article').evaluate('''each => {
        const kinds = new Set();
        for (; each; each = each.parentElement) kinds.add(getComputedStyle(each).display);
        return [...kinds] }''') == ['block']
    assert '@bottom-left { content: "1 · Limits"' in page.content()


@pytest.mark.parametrize('way', ['file', 'server'])
def test_every_page_from_the_disk_and_from_a_server(made, browser, way):
    with Server(made.target) as server:
        address = server.url if way == 'server' else made.target.as_uri()
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
    for hidden in ('Right.', 'Not so.', 'live-cells', '85 is off the step', 'It rounds both to the nearest'):
        assert hidden not in index


@pytest.mark.parametrize('scheme', ['light', 'dark'])
@pytest.mark.parametrize('name', ['index', '1_limits', '2_robot', 'search'])
def test_nothing_that_axe_finds(made, browser, scheme, name):
    with open_page(browser, (made.target / f'{name}.html').as_uri(), scheme=scheme, width=390) as page:
        expect(page.locator('html')).to_have_attribute('data-theme', scheme)
        assert check_page(page) == []


@pytest.fixture
def phone(made, browser):
    """Return the robot's page on a narrow screen."""
    with open_page(browser, (made.target / '2_robot.html').as_uri(), width=390) as page:
        yield page


def test_on_a_phone_a_text_keeps_its_shape_and_a_sentence_wraps(phone):
    shaped, sentence = (cell_with(phone, code) for code in ('ros__parameters', 'A sentence goes on'))
    for _ in ('as stored', 'as run'):
        expect(shaped.locator('.cell_output pre')).to_have_css('white-space', 'pre')
        expect(shaped.locator('.cell_output pre')).to_have_attribute('tabindex', '0')
        expect(sentence.locator('.cell_output pre')).to_have_css('white-space', 'pre-wrap')
        for cell in (shaped, sentence):
            cell.get_by_role('button', name='Run this cell').click()
        wait_for_the_node(phone)


def test_on_a_phone_a_picture_scrolls_and_stays_there_when_it_is_drawn_anew(phone):
    plot = phone.get_by_role('group', name='A picture as wide as its letters need').filter(has_text='time in s')
    plot.focus()
    phone.keyboard.press('ArrowRight')
    phone.wait_for_function('each => each.scrollLeft > 0', arg=plot.element_handle())
    scene = phone.locator('.motion-scene')
    scene.evaluate('each => { each.scrollLeft = 100 }')
    cell_with(phone, 'scene.value.replace').get_by_role('button', name='Run this cell').click()
    expect(scene).to_have_text('the second', timeout=60_000)
    assert scene.evaluate('each => each.scrollLeft') == 100


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


def test_building_again_changes_nothing(made):
    before = files(made.target)
    made.build()
    assert files(made.target) == before


def test_a_page_that_sphinx_warns_of_stops_the_build(made, tmp_path):
    (tmp_path / 'source').mkdir()
    (tmp_path / 'source' / 'index.md').write_text('# Start\n\n[nowhere](nowhere.ipynb)\n')
    writing.write_static(tmp_path / 'source', {})
    with pytest.raises(writing.BuildError, match='nowhere'):
        writing.write_pages(tmp_path / 'source', tmp_path / 'html', tmp_path / 'doctrees')


def test_a_chapter_that_fails_stops_the_build_and_the_old_site_stays(made, tmp_path):
    before = files(made.target)
    notebooks = tmp_path / 'notebooks'
    shutil.copytree(made.notebooks, notebooks)
    nbformat.write(nbformat.v4.new_notebook(cells=[
        nbformat.v4.new_markdown_cell('# 3 · Broken'),
        nbformat.v4.new_code_cell('undefined', execution_count=1)]), notebooks / '3_broken.ipynb')
    with pytest.raises(ChapterError, match=r"3_broken\.ipynb, cell \d \(undefined\): its page's node says something"):
        Site(notebooks, made.target, made.work).build()
    assert files(made.target) == before


def test_one_lesson_as_one_file(made, browser, tmp_path):
    site = Site(made.notebooks, made.target, made.work, ['1'])
    alone = tmp_path / 'lesson.html'
    shutil.move(single.build(site), alone)
    with open_page(browser, alone.as_uri()) as page:
        type_into(page, 'low_c', '25')
        expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22', timeout=60_000)
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


def test_a_node_answers_in_firefox(made, firefox_page):
    show_in_firefox(firefox_page, made.target / '1_limits.html')
    firefox_page.click('.param-row[data-name=on] input')
    firefox_page.wait_for("location.search.includes('on=false')")
    firefox_page.reload()
    firefox_page.wait_for("document.querySelector('.param-row[data-name=on] input').checked === false")


def test_firefox_keeps_a_prediction_and_marks_it_on_the_first_page(made, firefox_page):
    show_in_firefox(firefox_page, made.target / '1_limits.html')
    firefox_page.click('.lesson-prediction input[type=radio]')
    firefox_page.click('.lesson-prediction .param-predict-commit')
    firefox_page.reload()
    firefox_page.wait_for("document.querySelector('.lesson-prediction .param-predict-says').textContent.trim()")
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
