"""The course's own parts in JupyterLab, as `make lab` starts it: open to everybody, in Chromium and in Firefox.

The stage beside the text, a prediction and the veil, and a widget whose kernel is new.
"""

import pytest
from playwright.sync_api import expect

from param_tutorial.exercises import EXERCISES
from tests.support import lesson
from tests.support.axe import violations_in_both_themes
from tests.support.firefox import firefox
from tests.support.lab import RESTART_KERNEL, CourseLab, LabPage, wait_for

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]

NAME, OTHER, SOLUTIONS = '01_robot.ipynb', '02_robot.ipynb', EXERCISES['1a'].solutions
CELLS = (
    '# 1 · A robot\nYou declare a parameter, and you declare another:',
    'import param_tutorial\nfrom param_tutorial import ParameterPanel, exercises\n'
    'from param_tutorial.nodes.base_node import BaseNode\n'
    'from param_tutorial.views import SideBySide, TrackView\n\n%load_ext param_tutorial\n'
    'ros = param_tutorial.start()\nbase = ros.add(BaseNode)\n'
    'SideBySide(TrackView(base), ParameterPanel(base))',
    '### A question\nTo declare is one thing, an atomic request another:',
    "exercises.predict('1-6')", "print('decided')", 'What it means:',
    '### What an exercise says\nA check:', "exercises.check('1a', {})",
    '### The words\n\n| word | meaning |\n| --- | --- |\n| to declare | create a parameter |\n'
    '| atomic | all or nothing |',
)
SIGHTS = (
    'A plot:', "from param_tutorial.views import LinePlot\n\n"
    "LinePlot({'speed': [(0, 0), (8, 1)]}, x='s', y='m/s')",
    'A long line:', "print('back from the wall ' * 9)")
# It waits until its notebook is out of sight.
UNSEEN = ("import time\nfrom pathlib import Path\n\n"
          "while not Path('unseen').exists():\n    time.sleep(0.05)", *CELLS[:2])
# How many words of an element stand in more than one line.
BROKEN = """({firstChild: text}) => [...text.data.matchAll(/[^\\s]+/g)].filter(({0: word, index}) => {
    const range = new Range();
    range.setStart(text, index);
    range.setEnd(text, index + word.length);
    return range.getClientRects().length > 1;
}).length"""
WORDS = 'The kernel is new. Click here to run this cell, after all cells above it.'
# What the style sheet writes before an output, or before a widget in it that JupyterLab marks with a broken link.
BEFORE = """output => [output, ...output.querySelectorAll('.jupyter-widgets-disconnected')]
    .map(each => getComputedStyle(each, '::before').content)"""
STALE = '.jp-OutputArea-output:has(> .jupyter-widgets-disconnected)'
PARTS = ('.beside-text', '.jp-NotebookPanel .side-by-side', '.param-predict', '.param-check',
         '.param-veiled :is(.jp-OutputArea, .jp-MarkdownOutput)', STALE)


@pytest.fixture(scope='module')
def started(tmp_path_factory):
    lab = CourseLab(tmp_path_factory.mktemp('parts') / 'lab', [])
    lesson.write(lab.course / 'notebooks' / NAME, (*CELLS, *SIGHTS))
    lesson.write(lab.course / 'notebooks' / OTHER, UNSEEN)
    (lab.course / 'notebooks' / SOLUTIONS).parent.mkdir()
    lesson.write(lab.course / 'notebooks' / SOLUTIONS, ('# Solutions',))
    with lab:
        yield lab


@pytest.fixture
def lab(started):
    """Return the server, on which nobody has run or predicted anything."""
    started.end_kernels()
    (started.copies / 'progress.json').unlink(missing_ok=True)
    return started


def faults(page):
    """Return what axe finds in the parts that are there, in both themes."""
    there = [[each] for each in PARTS if page.locator(each).count()]
    return violations_in_both_themes(page, {'include': there})


def test_axe_finds_nothing_and_a_view_whose_kernel_is_new_comes_back_by_a_click(lab, browser):
    lab_page = LabPage(lab, browser, NAME)
    page = lab_page.page
    lab_page.run_all()
    expect(page.locator('.beside-text .track-scene')).to_be_visible()
    expect(page.locator('.param-veiled')).to_have_count(2)
    assert faults(page) == []
    form = page.locator('form.param-predict')
    form.get_by_role('radio').first.check()
    form.get_by_role('button', name='Commit').click()
    lab_page.run_cell(4)
    expect(form).to_contain_text('Not so.')
    assert faults(page) == []
    page.evaluate(RESTART_KERNEL)
    expect(page.locator('.beside-text')).to_be_hidden()
    stale = page.locator(STALE).first
    panel = page.locator('.beside-text').get_by_label('wall_m', exact=True)
    expect(stale).to_be_visible()
    wait_for(lambda: f'"{WORDS}"' in stale.evaluate(BEFORE), 'the words on the new kernel')
    assert faults(page) == []
    stale.click()
    expect(panel).to_have_value('10.0')


def test_views_stand_beside_the_text_of_the_notebook_that_has_made_them(lab, browser):
    lab_page = LabPage(lab, browser, NAME)
    page, beside = lab_page.page, lab_page.page.locator('.beside-text:visible')
    lab_page.command('docmanager:open', path=OTHER)
    page.wait_for_function(f"jupyterapp.shell.currentWidget.context?.path === '{OTHER}'")
    lab_page.wait_for_kernel()
    page.evaluate("() => { jupyterapp.commands.execute('notebook:run-all-cells'); }")  # it waits for what comes below
    lab_page.command('docmanager:open', path=NAME)
    expect(page.locator('.jp-NotebookPanel:visible').get_by_role('heading', name='1 · A robot')).to_be_visible()
    (lab.copies / 'unseen').touch()
    page.wait_for_function("[...jupyterapp.shell.widgets('main')].some(panel => "
                           f"panel.context.path === '{OTHER}' && panel.content.widgets.at(-1).model.executionCount)")
    lab_page.command('docmanager:open', path=OTHER)
    expect(beside.locator('.track-scene')).to_be_visible()
    lab_page.command('docmanager:open', path=NAME)
    expect(page.locator('.jp-NotebookPanel:visible').get_by_role('heading', name='1 · A robot')).to_be_visible()
    expect(beside).to_have_count(0)


def test_plots_and_words_beside_the_stage_are_whole(lab, browser):
    lab_page = LabPage(lab, browser, NAME)
    page = lab_page.page
    page.set_viewport_size({'width': 1000, 'height': 800})
    lab_page.run_all()
    expect(page.locator('.beside-text .track-scene')).to_be_visible()
    plot = page.get_by_role('img', name='m/s over s')
    assert plot.evaluate('plot => plot.parentElement.scrollWidth === plot.parentElement.clientWidth')
    assert plot.bounding_box()['width'] > 356  # where its letters have 11 px
    assert [each.evaluate(BROKEN) for each in page.locator('pre:has-text("back from the wall")').all()] == [0]


def test_what_a_check_says_to_look_at_is_a_click_away(lab, browser):
    page = LabPage(lab, browser, NAME)
    page.run_all()
    page.page.set_viewport_size({'width': 1280, 'height': 500})
    page.select_cell(0)
    page.page.locator('.jp-Cell').first.scroll_into_view_if_needed()
    words = page.page.get_by_role('heading', name='The words')
    expect(words).not_to_be_in_viewport()
    page.page.get_by_role('link', name='“The words”').click()
    expect(words).to_be_in_viewport()
    # What it tried has left no room, and hints and the solution are a key away.
    check = page.page.locator('.param-check')
    place = page.page.locator('.jp-OutputArea:has(.param-check) > *').first
    assert place.evaluate('place => [place.innerHTML, place.offsetHeight]') == ['', 0]
    for number, key in ((2, 'Enter'), (3, 'Space')):
        check.get_by_text(f'Hint {number} of 3', exact=True).press(key)
    check.get_by_text('A worked solution').click()
    assert faults(page.page) == []
    check.get_by_role('link', name='Open').click()
    page.page.wait_for_function(f"jupyterapp.shell.currentWidget.context?.path === '{SOLUTIONS}'")


def test_they_work_in_firefox(lab, tmp_path):
    with firefox(tmp_path) as page:
        page.resize(1280, 800)
        page.open(f'{lab.url}doc/tree/{NAME}?token={lab.token}&reset')
        page.wait_for("document.querySelector('.jp-Notebook .jp-Cell')")
        # Firefox without windows tells no page that it has the focus, and JupyterLab waits for that.
        page.evaluate("document.querySelector('.jp-NotebookPanel').dispatchEvent(new FocusEvent('focus'))")
        page.wait_for("jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'")
        page.evaluate("jupyterapp.commands.execute('notebook:run-all-cells').then(() => 0)")
        page.wait_for("document.querySelector('.beside-text .track-scene')?.checkVisibility()")
        page.wait_for("document.querySelectorAll('.param-veiled').length === 2")
        hidden = "document.querySelector('.param-veiled .jp-OutputArea-child')"
        assert not page.evaluate(f'{hidden}.checkVisibility()')
        page.click('form.param-predict input')
        page.click('form.param-predict .param-predict-commit')
        page.wait_for(f'{hidden.replace(".param-veiled ", ".jp-CodeCell:nth-of-type(5) ")}?.checkVisibility()')
        page.evaluate(RESTART_KERNEL)
        page.wait_for(f"document.querySelector('{STALE}')")
        page.click(STALE)
        page.wait_for("document.querySelector('.beside-text .robot-word')?.textContent === 'READY'")
        assert [each for each in page.complaints if 'param' in each] == []
