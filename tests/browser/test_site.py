"""The HTML lessons in Chromium and Firefox, without a network: what readers see, do and get back.

A site of two small chapters, made once for all tests; each page runs its own Python and its own nodes. CI holds the
pages of the course to the rules for every page when it has built them, see `tests/tools/site_rules.py`.
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
from tests.support.axe import violations
from tests.support.firefox import FIREFOX, firefox
from tests.support.lab import ROOT
from tests.support.server import Server
from tests.tools.site_rules import check_page, open_page

# Sphinx and its extensions tell each other, in each release, what the next one will bring.
pytestmark = [
    pytest.mark.thorough, pytest.mark.timeout(600),  # the site is made in the first one's time
    *(pytest.mark.filterwarnings(f'ignore::{kind}Warning') for kind in ('Deprecation', 'PendingDeprecation'))]

# A node with a rule over two parameters, a limit that a callback applies, and a table of changes; two predictions.
LIMITS = (
    '# 1 · Limits\n\n**What does a node say?**',
    '''import param_tutorial
from param_tutorial import ParameterPanel
from param_tutorial.views import EventView
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
        self.add_pre_set_parameters_callback(self.trim)
        self.add_on_set_parameters_callback(self.judge)

    def trim(self, parameters):
        return [Parameter('power_w', value=min(p.value, 300)) if p.name == 'power_w' else p for p in parameters]

    def judge(self, parameters):
        new = {p.name: p.value for p in parameters}
        low, high = (new.get(name, self.get_parameter(name).value) for name in ('low_c', 'high_c'))
        return SetParametersResult(successful=low < high, reason=f'{low} is not below {high}')


ros = param_tutorial.start()
heater = ros.add(Heater)''',
    'Its controls, from <span data-parameter="/heater low_c 0 50 1">18</span> degrees:',
    "panel = ParameterPanel('/heater')\npanel",
    'EventView()',
    'Two predictions, one to choose and one to type:',
    "from param_tutorial import exercises\n\nexercises.predict('6.1-1')",
    "exercises.predict('6.1-2')",
    "print('-20, -15, 0, 50 and 52')",
    'Five of the eight. What a hand does later does not show above:',
    "panel['low_c'].value = 19\npanel.settle()\npanel['low_c'].value",
    '## Next, a robot\n\nA table, and a link to [the other one](2_robot.ipynb).\n\n| a | b |\n| --- | --- |\n| 1 | 2 |',
    "print('the end')\n1 / 0",
)
ROBOT = (
    '# 2 · A robot\n\n**Does it move?**\n\nAfter this chapter you can\n\n- drive.\n\n*5 minutes. Before: nothing.*\n\n'
    'Run the cell:',
    'import rclpy\n\nimport param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import TrackView\nfrom param_tutorial.nodes.base_node import BaseNode\n'
    'from param_tutorial.nodes.driver_node import DriverNode\n\n'
    'ros = param_tutorial.start()\nbase = ros.add(BaseNode, ros_args=["-p", "wall_m:=4.0"])\n'
    'driver = ros.add(DriverNode)\nview = TrackView(base)\nview',
    'Its controls:',
    "ParameterPanel(driver, names=['max_speed_mps', 'stop_distance_m'])",
    'Another speed:',
    "driver.set_parameters([rclpy.Parameter('max_speed_mps', value=0.7)])\nview",
    'A picture that is drawn anew:',
    "import ipywidgets\n\nscene = ipywidgets.HTML('<div class=\"motion-scene\" style=\"overflow-x: auto\">'\n"
    "                        '<svg viewBox=\"0 0 720 60\" style=\"min-width: 690px\">'\n"
    "                        '<text x=\"100\" y=\"30\">the first</text></svg></div>')\nscene",
    "scene.value = scene.value.replace('first', 'second')",
    'A slider of somebody else:',
    "ipywidgets.IntSlider(5, description='gain')",
    'A text with a shape, and a sentence:',
    "print('/heater:\\n  ros__parameters:\\n    label: ' + 'a long name ' * 9)",
    "print('A sentence goes on' + ' and on' * 20)",
    '## Two sources\n\n' + 'The later one wins.\n\n' * 20,
    '## 7.3b · Put three sources in order',
    "sources = [\n    '-p max_speed_mps:=0.7',\n    '--params-file slow.yaml',\n    '--params-file fast.yaml',\n]",
    "from param_tutorial import exercises\n\nexercises.check('7.3b', sources)",
)
SOLVED = "sources = ['--params-file fast.yaml', '--params-file slow.yaml', '-p max_speed_mps:=0.7']"
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
            notebook.cells[at - 1].id, cell.id = 'exercise-7-3b', 'check-7-3b'
        if cell.source.startswith(('## Next', '## Two sources')):
            cell.metadata.tags = ['stage']
    if '1 / 0' in notebook.cells[-1].source:
        notebook.cells[-1].metadata.tags = ['raises-exception']
    NotebookClient(notebook, kernel_name='python3', store_widget_state=False, coalesce_streams=True,
                   resources={'metadata': {'path': str(path.parent)}}).execute()
    nbformat.write(notebook, path)


FIREFOX_ENTER = '\ue007'  # in WebDriver's table of keys


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
    site = Site(notebooks, folder / 'html', folder / 'work')
    site.build()
    return site


@pytest.fixture
def page(made, browser, request):
    """Return a chapter's page, from the disk; nothing may be requested elsewhere, or complained of."""
    name, *width = request.param
    with open_page(browser, (made.target / name).as_uri(), **dict(zip(['width'], width))) as page:
        yield page


limits = pytest.mark.parametrize('page', [['1_limits.html']], indirect=True, ids=[''])
robot = pytest.mark.parametrize('page', [['2_robot.html']], indirect=True, ids=[''])
robot_on_a_phone = pytest.mark.parametrize('page', [['2_robot.html', 390]], indirect=True, ids=[''])


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


def wait_for_the_node(page):
    """Wait until the page's node has done all that it was asked."""
    page.wait_for_function(
        "document.documentElement.dataset.node === 'awake' && !document.querySelector('[aria-busy]')", timeout=60_000)


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


def run(cell):
    cell.get_by_role('button', name='Run this cell').click()


@limits
def test_what_is_typed_or_slid_is_answered_by_the_node_in_the_page(page):
    expect(row(page, 'low_c').get_by_text('A limit.')).to_be_visible()
    # Typed before there is a node, it waits for one; everything stands on the page meanwhile.
    expect(box(page, 'low_c')).to_have_value('18')  # as the cell left it, and not as a later one did
    page.keyboard.press('PageDown')
    page.locator('h1').click()
    expect(page.locator('html')).to_have_attribute('data-node', 'asleep')  # who reads waits for no Python
    type_into(page, 'power_w', '150')
    step = page.locator('.live-view', has=box(page, 'power_w')).locator('.live-step')
    expect(step).to_contain_text(': Python and ROS are coming into this page')
    changes = page.get_by_role('log', name='Changes of all nodes').get_by_role('row')
    expect(changes.filter(has_text='150')).to_have_count(1, timeout=60_000)
    wait_for_the_node(page)
    expect(step).to_be_hidden()
    type_into(page, 'power_w', '900')
    expect(box(page, 'power_w')).to_have_value('300')
    expect(message(page, 'power_w')).to_have_text('You asked for 900, and the node has stored 300.')
    type_into(page, 'name', '__proto__')
    expect(changes.filter(has_text='__proto__')).to_have_count(1)
    type_into(page, 'low_c', '25')
    expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')
    slider = row(page, 'low_c').get_by_role('slider')
    expect(slider).to_have_value('18')
    slider.focus()
    page.keyboard.press('ArrowLeft')
    expect(box(page, 'low_c')).to_have_value('17')
    expect(changes.filter(has_text='17')).to_have_count(1)
    assert check_page(page) == []


@limits
def test_a_cell_is_edited_and_run_and_kept(page):
    cell = cell_with(page, 'panel.settle()')
    cell.hover()
    editor = edit(cell, "panel['power_w'].value = 120\npanel.settle()\nprint(panel['power_w'].value + 1)")
    expect(cell.locator('.cm-line .s1')).to_have_text(["'power_w'", "'power_w'"])
    editor.press('Shift+Enter')
    expect(cell.locator('.cell_output')).to_have_text('121', timeout=60_000)
    # Tab indents, and after Escape it goes on.
    editor.press('Tab')
    expect(editor).to_be_focused()
    editor.press('Escape')
    editor.press('Tab')
    expect(cell.get_by_role('button', name='Run this cell')).to_be_focused()
    wait_for_the_node(page)
    expect(box(page, 'power_w')).to_have_value('120')
    editor.fill('')
    editor.press_sequentially('1 / 0')
    run(cell)
    expect(cell.locator('.cell_output')).to_contain_text('ZeroDivisionError')
    page.reload()
    expect(cell.get_by_role('textbox', name='The code of this cell')).to_have_text('1 / 0')
    assert not page.evaluate("document.documentElement.dataset.node === 'waking'")  # nothing runs without a click
    expect(cell).to_have_attribute('data-is-old', '')  # what stands below is not what this code puts out
    cell.get_by_role('button', name='Bring back the code of the lesson').click()
    expect(cell).not_to_have_attribute('data-is-old', '')
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
    expect(editor).to_have_text('while True: pass', use_inner_text=True)
    type_into(page, 'low_c', '25')
    expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22')


@limits
def test_what_a_callback_prints_later_is_seen_below_the_cell_that_ran_last(page):
    cell = cell_with(page, "print('the end')")
    editor = edit(cell, 'def endless():\n    timer.cancel()\n    while True: pass\n'
                        "heater.add_post_set_parameters_callback(lambda new: print('seen', new[0].value))\n"
                        "print('begun')")
    editor.press('Shift+Enter')
    printed = cell.locator('.cell_output')
    expect(printed).to_have_text('begun', timeout=60_000)
    wait_for_the_node(page)
    type_into(page, 'power_w', '150')
    type_into(page, 'power_w', '160')
    expect(printed).to_have_text('begun seen 150 seen 160', use_inner_text=True)
    log = page.get_by_role('list', name='What nodes and callbacks said')
    expect(log).to_have_text(re.compile(r'^\d\d:\d\d:\d\d seen 150\d\d:\d\d:\d\d seen 160$'))
    editor.fill("heater.get_logger().warn('hot')")
    editor.press('Shift+Enter')
    expect(log.get_by_role('listitem').last).to_contain_text('[WARN] [heater]: hot')
    editor.fill('timer = heater.create_timer(0.01, endless)')
    editor.press('Shift+Enter')
    expect(printed).to_contain_text('this callback did not return, so it was interrupted')


@limits
def test_a_page_answers_while_a_cell_prints_without_an_end(page):
    cell, form = cell_with(page, "print('the end')"), page.locator('.lesson-prediction').first
    edit(cell, "for number in range(200_000):\n    print('line', number)").press('Shift+Enter')
    text, whole = cell.locator('.cell_output pre'), cell.get_by_role('button', name='Show all')
    expect(whole).to_be_visible(timeout=60_000)
    assert len(text.text_content()) == 100_000
    form.get_by_role('radio').first.check()
    form.get_by_role('button', name='Commit').click()
    expect(form.get_by_role('status')).not_to_be_empty()
    whole.click()
    expect(text).to_contain_text('line 9999\n')
    assert text.bounding_box()['height'] < 500


# What would run a script, or leave the page by itself, if a cell could put it there.
PAYLOADS = [each.replace('GO', "location='https://example.org/'") for each in (
    '<img src="data:," onerror="GO">', '<svg onload="GO"/>', '<details open ontoggle="GO">8</details>',
    '<input autofocus onfocus="GO">', '<a href="javascript:void(GO)">a link</a>',
    '<iframe srcdoc="<script>top.GO</script>"></iframe>',
    '<meta http-equiv="refresh" content="0;url=https://example.org/">', '<base href="https://example.org/">',
    '<link rel="dns-prefetch" href="//example.org">', '<object data="https://example.org/"></object>',
    '<form action="https://example.org/"><button>go</button></form>')]


@limits
def test_what_a_cell_puts_out_runs_no_script_and_leaves_no_page(page):
    address = page.url
    cell = cell_with(page, "print('the end')")
    edit(cell, 'import anywidget, ipywidgets\nfrom IPython.display import HTML, Markdown\n'
               f'for each in {PAYLOADS!r}:\n'
               '    display(HTML(each), Markdown(each), ipywidgets.HTML(each))\n    panel.children[-1].markup += each\n'
               "display(anywidget.AnyWidget(_esm='location=`https://example.org/`'))\nfrom js import fetch\n"
               "try:\n    await fetch('https://example.org/')\nexcept Exception:\n    print('no way out')"
         ).press('Shift+Enter')
    # What the policy forbids the browser reports; that is the proof, and no complaint.
    page.evaluate("document.addEventListener('securitypolicyviolation', event => event.preventDefault())")
    expect(cell.locator('.cell_output')).to_contain_text('no way out', timeout=60_000)
    for link in cell.locator('.cell_output a').all():
        link.click()
    wait_for_the_node(page)
    assert page.url == address
    assert page.evaluate("""[...document.querySelectorAll('.cell_output *')].filter(each =>
        each.matches('meta, iframe, base, link, object, script:not(.live-cells), form[action], [href^=javascript]')
        || [...each.attributes].some(({name}) => name.startsWith('on'))).map(each => each.outerHTML)""") == []


@limits
def test_a_cell_shows_what_jupyter_shows(page):
    cell = cell_with(page, "print('the end')")
    dot = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=='
    edit(cell, 'import base64, ipywidgets\nfrom IPython.display import Image, Latex, Markdown, SVG\n'
               """display(SVG('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="7"/>'),Markdown('**bold**'),"""
               f"Image(base64.b64decode('{dot}')), Latex('$x^2$'), ipywidgets.Dropdown())\n"
               "slider = ipywidgets.IntSlider(5)\nslider.observe(lambda _: setattr(slider, 'value', 7), 'value')\n"
               'display(slider)\nhelp(heater.undeclare_parameter)').press('Shift+Enter')
    out = cell.locator('.cell_output')
    expect(out).to_contain_text('Undeclare a previously declared parameter.', timeout=60_000)
    expect(out.locator('strong')).to_have_text('bold')
    assert out.locator('img').evaluate_all('all => all.map(each => [each.naturalWidth, each.naturalHeight])') == [
        [9, 7], [1, 1]]
    for words in ('$x^2$', 'JupyterLab shows a widget here (Dropdown)'):
        expect(out).to_contain_text(words)
    out.get_by_role('slider').fill('9')
    expect(out.get_by_role('slider')).to_have_value('7')
    expect(out.get_by_role('status')).to_have_text('7')


@robot
def test_a_slider_has_its_name_before_its_cell_runs(page):
    expect(page.get_by_role('slider', name='gain', exact=True)).to_be_visible()
    assert page.get_by_text('undefined').count() == 0


@limits
def test_a_number_in_the_text_is_dragged_and_the_node_answers_below(page):
    number, says = page.get_by_role('slider', name='low_c of /heater'), page.locator('.live-number-says')
    type_into(page, 'low_c', '7')
    expect(page.get_by_role('button', name='Undo')).to_be_enabled(timeout=60_000)  # the node has it
    number.scroll_into_view_if_needed()
    place = number.bounding_box()
    x, y = place['x'] + 4, place['y'] + 4
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 42, y)  # seven steps
    expect(number).to_have_text('25')
    page.mouse.up()
    expect(says).to_contain_text('rejected low_c = 25 (rejected by the node): 25 is not below 22', timeout=60_000)
    expect(number).to_have_text('7')  # what the panel has set
    for key, value in {'Home': 0, 'ArrowRight': 1}.items():
        number.press(key)
        expect(says).to_have_text(f'/heater accepted low_c = {value}', timeout=60_000)
    expect(number).to_have_attribute('aria-valuenow', '1')
    expect(box(page, 'low_c')).to_have_value('1')  # the panel right below has become the node's
    expect(cell_with(page, "panel['low_c'].value")).to_have_attribute('data-is-old', '')
    expect(cell_with(page, 'the end')).not_to_have_attribute('data-is-old', '')  # of another section


@limits
def test_predictions_fold_what_answers_them_and_are_kept_and_marked(page, made):
    chosen, typed = (page.locator('.lesson-prediction').nth(number) for number in (0, 1))
    marks = page.get_by_role('navigation', name='Lessons').locator('.lesson-mark')
    answer, told = page.get_by_text('-20, -15, 0, 50 and 52', exact=True), page.get_by_text('Five of the eight')
    look = page.get_by_role('button', name='Commit to an answer, or look at that of question 6.1-2')
    expect(page.locator('.lesson-look')).to_have_count(1)  # below the other prediction no cell decides it
    expect(answer).to_be_hidden()
    expect(told).to_be_hidden()
    assert 'Hidden until you' in cell_with(page, 'panel.settle()').locator('.cell_output').evaluate(
        "each => getComputedStyle(each, '::before').content")
    page.emulate_media(media='print')  # paper hides nothing
    expect(answer).to_be_visible()
    page.emulate_media(media='screen')
    look.press('Enter')
    expect(answer).to_be_visible()
    expect(told).to_be_visible()
    expect(look).to_have_count(0)
    page.reload()
    expect(answer).to_be_hidden()
    # By keyboard.
    chosen.get_by_role('radio').first.focus()
    for key in ('Space', 'ArrowDown', 'ArrowUp', 'Tab', 'Enter'):
        page.keyboard.press(key)
    expect(chosen.get_by_role('status')).to_contain_text('Right. 85 is off the step too')
    expect(chosen.get_by_role('button', name='Answer again')).to_be_focused()
    expect(marks).to_have_attribute('title', '1 of 2 questions answered')
    number = typed.get_by_label('Your number')
    number.fill('many')
    number.press('Enter')
    expect(typed.get_by_role('status')).to_contain_text('Please answer with a number')
    number.fill('7 values')
    number.press('Enter')
    expect(typed.get_by_role('status')).to_contain_text('Not so. It accepts two')
    expect(answer).to_be_visible()
    expect(look).to_have_count(0)
    page.reload()
    expect(marks).to_have_text('✓ (2 of 2 questions answered)')
    expect(chosen.get_by_role('status')).to_contain_text('Right. 85 is off the step too')
    expect(chosen.get_by_role('radio').first).to_be_checked()
    expect(number).to_have_value('7 values')
    expect(answer).to_be_visible()
    chosen.get_by_role('button', name='Answer again').click()
    expect(chosen.get_by_role('status')).to_be_empty()
    page.goto((made.target / 'index.html').as_uri())
    expect(page.locator('.front-lessons .lesson-mark')).to_have_text('1/2 (1 of 2 questions answered)')
    expect(page.locator('.lesson-progress')).to_contain_text('You have answered one question.')
    page.get_by_role('button', name='Forget my answers').click()
    expect(page.locator('.lesson-mark')).to_have_count(0)


@robot
def test_an_exercise_is_solved_in_its_cell_and_remembered(page):
    exercise, check = (page.locator(f'.tag_live-{name}-7-3b') for name in ('exercise', 'check'))
    run(check)
    expect(check.locator('.param-check')).to_contain_text('Exercise 7.3b: not yet, 0 of 2 done', timeout=60_000)
    wait_for_the_node(page)
    check.get_by_role('link', name='“Two sources”').first.click()
    expect(page.get_by_role('heading', name='Two sources')).to_be_in_viewport()
    expect(page).to_have_url(re.compile('#Two-sources$'))
    expect(page.locator('.lesson-mark')).to_have_count(0)
    edit(exercise, SOLVED)
    run(exercise)
    run(check)
    expect(check.locator('.param-check')).to_contain_text('Exercise 7.3b: done, 2 of 2 done')
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 1 questions answered')
    expect(page.locator('.lesson-here').first).to_have_text('1 of 1 answered')
    page.reload()
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 1 questions answered')
    expect(exercise.get_by_role('textbox', name='The code of this cell')).to_have_text(SOLVED)


def test_without_a_script_nothing_is_folded(made, browser):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((made.target / '1_limits.html').as_uri())
    expect(page.get_by_text('-20, -15, 0, 50 and 52', exact=True)).to_be_visible()
    expect(page.locator('.lesson-look')).to_have_count(0)
    expect(page.locator('.bd-article noscript p')).to_be_visible()
    # The theme has colors for a light page and for a dark one, and none for a page that is neither.
    expect(page.locator('html')).to_have_attribute('data-theme', 'light')
    context.close()


@limits
def test_a_page_lives_where_the_browser_keeps_nothing(page):
    page.add_init_script("IDBFactory.prototype.open = () => { throw new DOMException('', 'SecurityError') }")
    page.reload()
    # Until then the page is being laid out, and a click may miss.
    page.wait_for_function("document.documentElement.dataset.lesson === 'ready'")
    form = page.locator('.lesson-prediction').first
    form.get_by_role('radio').first.check()
    form.get_by_role('button', name='Commit').click()
    expect(form.get_by_role('status')).not_to_be_empty()
    expect(page.locator('.lesson-mark')).to_have_attribute('title', '1 of 2 questions answered')


@robot
def test_the_robot_drives_and_a_change_on_the_way_takes_effect_on_the_way(page):
    margin = page.locator('.live-margin')
    word, says = margin.locator('.robot-word'), margin.locator('.robot-says')
    margin.get_by_role('button', name='Back to the start').click()
    expect(word).to_have_text('DRIVING', timeout=60_000)
    type_into(page, 'stop_distance_m', '1.5')
    type_into(page, 'max_speed_mps', '1.0')
    expect(margin.locator('.track-speed')).to_have_text('1.00 m/s', timeout=60_000)
    expect(says).to_contain_text('The robot stands', timeout=60_000)
    expect(word).to_have_text('STOPPED')
    # A touch runs no step of the lesson below it.
    expect(box(page, 'max_speed_mps')).to_have_value('1.0')
    run(cell_with(page, 'value=0.7'))
    expect(box(page, 'max_speed_mps')).to_have_value('0.7')


@robot
def test_robot_and_panel_stand_beside_the_text_that_is_about_them_and_fold_beside_other_text(page):
    margin = page.get_by_role('complementary', name='Beside the text')
    strip = margin.get_by_role('button', name='/base and /driver')
    view, panel = margin.locator('.robot-view'), margin.locator('.param-panel')

    def go_to(heading):
        page.get_by_role('heading', name=heading).evaluate('each => each.scrollIntoView()')

    expect(view.or_(panel)).to_have_count(2)
    assert page.locator('.bd-article :is(.robot-view, .param-panel):visible').count() == 0
    go_to('Two sources')
    expect(view).to_be_in_viewport()
    go_to('Put three sources in order')
    expect(view).to_have_count(0)
    strip.click()
    expect(panel).to_be_visible()
    box(page, 'max_speed_mps').focus()
    go_to('Two sources')
    go_to('Put three sources in order')
    expect(box(page, 'max_speed_mps')).to_be_focused()  # what a reader uses stays
    page.emulate_media(media='print')
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(page.locator('.bd-article .robot-view:visible')).to_have_count(2)
    page.emulate_media(media='screen')
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.get_by_role('button', name='Shown at the right').last.click()
    expect(view).to_be_in_viewport()
    assert violations(page, '.live-margin') == []


@robot_on_a_phone
def test_on_a_phone_a_sheet_at_the_foot_shows_what_is_out_of_sight(page):
    sheet = page.get_by_role('complementary', name='Beside the text')
    strip = sheet.get_by_role('button', name='/base and /driver')
    expect(strip).to_be_hidden()
    page.get_by_role('heading', name='Two sources').evaluate('each => each.scrollIntoView()')
    before = page.locator('.bd-article').bounding_box()['height']
    strip.click()
    expect(sheet.locator('.robot-view')).to_be_in_viewport()
    assert sheet.bounding_box()['height'] <= page.viewport_size['height'] / 3 + 1
    assert page.locator('.bd-article').bounding_box()['height'] == before
    strip.click()
    expect(sheet.locator('.robot-view')).to_have_count(0)
    expect(page.locator('.bd-article .robot-view')).to_have_count(2)


@robot_on_a_phone
def test_on_a_phone_texts_keep_their_shape_and_pictures_scroll(page):
    shaped, sentence = (cell_with(page, code) for code in ('ros__parameters', 'A sentence goes on'))
    for _ in ('as stored', 'as run'):
        expect(shaped.locator('.cell_output pre')).to_have_css('white-space', 'pre')
        expect(shaped.locator('.cell_output pre')).to_have_attribute('tabindex', '0')
        expect(sentence.locator('.cell_output pre')).to_have_css('white-space', 'pre-wrap')
        for cell in (shaped, sentence):
            run(cell)
        wait_for_the_node(page)
    page.get_by_role('navigation', name='This lesson').get_by_role('link', name='Previous').scroll_into_view_if_needed()
    scene = page.locator('.motion-scene')
    expect(scene).to_have_attribute('tabindex', '0')
    scene.evaluate('each => { each.scrollLeft = 100 }')
    run(cell_with(page, 'scene.value.replace'))
    expect(scene).to_have_text('the second', timeout=60_000)
    assert scene.evaluate('each => each.scrollLeft') == 100  # it stays there when it is drawn anew


@robot
def test_a_lesson_begins_with_what_can_be_touched(page):
    view, goals = page.locator('.live-margin .robot-view'), page.get_by_text('drive.', exact=True)
    assert view.bounding_box()['y'] < page.locator('.lesson-goals').bounding_box()['y'] < 900
    stage = page.get_by_text('ros = param_tutorial.start()')
    page.emulate_media(media='print')
    for folded in (goals, stage):
        expect(folded).to_be_visible()
    page.emulate_media(media='screen')
    for folded in (goals, stage):
        expect(folded).to_be_hidden()
    page.get_by_text('5 minutes: what you can do afterward').click()
    expect(goals).to_be_visible()
    expect(page.get_by_text('Run the cell:')).to_have_count(0)  # it is above now, and needs no run
    page.locator('summary', has_text='Set the stage: 13 lines').click()
    expect(stage).to_be_visible()


@pytest.mark.parametrize(('width', 'is_phone'), [(1280, False), (390, True)])
def test_all_code_has_buttons_which_cover_none_of_it(made, browser, width, is_phone):
    page = browser.new_page(viewport={'width': width, 'height': 800}, has_touch=is_phone, is_mobile=is_phone)
    page.goto((made.target / '1_limits.html').as_uri())
    for button in page.get_by_role('button', name='Run this cell').all()[:2]:
        expect(button).to_be_visible()
    assert page.evaluate("""[...document.querySelectorAll('.cell_input')].filter(each =>
        each.querySelector('.live-tools').getBoundingClientRect().top
        < each.querySelector('pre').getBoundingClientRect().bottom - 1).length""") == 0
    page.close()


@limits
def test_paper_is_white_and_all_code_is_on_it(page):
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    page.emulate_media(media='print')
    assert page.evaluate('''() => {
        const brightness = color => color.match(/[\\d.]+/g).slice(0, 3).reduce((sum, each) => sum + Number(each), 0);
        return [...document.querySelectorAll('.bd-article p, .bd-article h1, .cell_input span')].filter(each =>
          each.textContent.trim() && brightness(getComputedStyle(each).color) > 450).length }''') == 0
    expect(page.locator('.cell_input .highlight pre').first).to_have_css('white-space', 'pre-wrap')
    for whole in ('.cell_input', '.live-view', '.lesson-prediction'):
        expect(page.locator(whole).first).to_have_css('break-inside', 'avoid')
    # Of a flexible box Chromium prints no more than would fit if no page came to an end.
    assert page.locator('.bd-article').evaluate('''each => {
        const kinds = new Set();
        for (; each; each = each.parentElement) kinds.add(getComputedStyle(each).display);
        return [...kinds] }''') == ['block']


@limits
def test_the_list_of_lessons_is_at_this_lesson_and_marks_the_section_in_sight(page):
    page.set_viewport_size({'width': 1280, 'height': 200})
    lessons = page.get_by_role('navigation', name='Lessons')
    page.reload()
    expect(lessons.get_by_role('link', name='1 · Limits')).to_be_in_viewport()
    expect(lessons.locator('[aria-current=location]')).to_have_count(0)
    page.get_by_role('heading', name='Next').scroll_into_view_if_needed()
    page.mouse.wheel(0, 9999)
    expect(lessons.locator('[aria-current=location]')).to_have_text('Next, a robot')
    expect(lessons.get_by_role('link', name='Next')).to_be_in_viewport()


@pytest.mark.parametrize('way', ['file', 'server'])
def test_the_search_finds_words_but_no_answers(made, browser, way):
    with Server(made.target) as server:
        address = server.url if way == 'server' else made.target.as_uri()
        with open_page(browser, f'{address}/index.html') as page:
            page.keyboard.press('Control+k')
            page.keyboard.type('table')
            page.keyboard.press('Enter')
            page.locator('#search-results').get_by_role('link', name='1 · Limits').click()
            expect(page.get_by_role('heading', name='1 · Limits')).to_be_visible()
            page.goto(f'{address}/search.html?q=the+robots')  # both pages have it in a heading
            expect(page.locator('#search-results').get_by_role('link').first).to_have_text('2 · A robot')
    index = (made.target / 'searchindex.js').read_text()
    for word, is_there in {'tabl': True, 'settl': True, 'nearest': False, '52': False, 'solut': False}.items():
        assert (f'"{word}":' in index) is is_there, word


def test_what_is_beside_the_pages(made):
    html = (made.target / '1_limits.html').read_text()
    assert '<meta name="description" content="What does a node say?">' in html
    assert 'There is no such page' in (made.target / '404.html').read_text()
    assert 'href="2_robot.html"' in html and 'href="notebooks/1_limits.ipynb"' in html
    assert (made.target / 'notebooks/1_limits.ipynb').read_bytes() == (made.notebooks / '1_limits.ipynb').read_bytes()
    assert 'href="param-course.zip"' in html and '<code>make lab</code>' in html
    with zipfile.ZipFile(made.target / 'param-course.zip') as course:
        names = set(course.namelist())
        makefile = course.read('param-course/Makefile')
    assert makefile == (ROOT / 'Makefile').read_bytes()
    assert 'param-course/notebooks/01_what_are_parameters.ipynb' in names
    assert not any('/build/' in name or '/.venv/' in name for name in names)


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
        Site(notebooks, made.target, made.work, ['3']).build()
    assert files(made.target) == before


def test_one_lesson_as_one_file(made, browser, tmp_path):
    site = Site(made.notebooks, made.target, made.work, ['1'])
    alone = tmp_path / 'lesson.html'
    shutil.move(single.build(site), alone)
    with open_page(browser, alone.as_uri()) as page:
        type_into(page, 'low_c', '25')
        expect(message(page, 'low_c')).to_have_text('Rejected: 25 is not below 22', timeout=60_000)
        expect(page.locator('.lesson-about-page')).to_contain_text('This file is one lesson of the course')
        assert check_page(page) == []
        assert page.locator('a[href$=".ipynb"], a[href="2_robot.html"]').count() == 0
        loaded = page.evaluate("performance.getEntriesByType('resource').map(each => each.name)"
                               '.filter(name => !/^(data|blob):/.test(name))')
    assert loaded == []


def test_the_same_site_in_firefox(made, tmp_path):
    if FIREFOX is None:
        missing.skip('there is no Firefox on the PATH: apt-get install firefox-esr')
    with firefox(tmp_path) as page:
        def show(name):
            page.open((made.target / name).as_uri())
            page.wait_for("document.documentElement.dataset.lesson === 'ready'")

        show('2_robot.html')
        page.click('.live-margin .robot-drive')
        page.wait_for("document.querySelector('.live-margin .robot-word').textContent === 'DRIVING'")
        page.wait_for("document.querySelector('.live-margin .robot-says').textContent.includes('The robot stands')")
        show('1_limits.html')
        page.click('.lesson-prediction input[type=radio]')
        page.click('.lesson-prediction .param-predict-commit')
        page.reload()
        page.wait_for("document.querySelector('.lesson-prediction .param-predict-says').textContent.trim()")
        show('index.html')
        page.wait_for("document.querySelector('.front-lessons .lesson-mark')?.title.startsWith('1 of 2 ')")
        page.click('.search-button__button')
        page.press(*'table', FIREFOX_ENTER)
        page.wait_for("document.querySelector('#search-results a')?.textContent.includes('Limits')")
        assert page.complaints == []
