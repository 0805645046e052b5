"""In the real JupyterLab, what SideBySide shows stands beside the text that is about it, while there is room."""

import pytest
from playwright.sync_api import expect

from tests.support.axe import violations_in_both_themes
from tests.support.lab import ROOT, CourseLab, LabPage

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

LONG = '\n\n' + 'A line.\n\n' * 60
CELLS = (
    '# A robot, in a line as long as there is room for\nOn its track:',
    'import param_tutorial\nfrom param_tutorial import ParameterPanel\n'
    'from param_tutorial.views import SideBySide, TrackView\n'
    'from param_tutorial.nodes.base_node import BaseNode\nfrom param_tutorial.nodes.driver_node import DriverNode\n\n'
    'ros = param_tutorial.start()\nbase, driver = ros.add(BaseNode), ros.add(DriverNode)\nview = TrackView(base)',
    "panel = ParameterPanel(driver, names=['max_speed_mps'])\nSideBySide(view, panel)",
    '### Far away' + LONG,
    'SideBySide(view, panel)',
    '## Of the robot, too' + LONG,
    '## Something else' + LONG,
    '## Of another robot\nIt follows:',
    "SideBySide(view, ParameterPanel(driver, names=['stop_distance_m']))",
    '### The end' + LONG,
)
ROBOT, SETTINGS, AGAIN, TAGGED, OTHER = 1, 2, 4, 5, 8
# Of each cell of code that is in sight once, the lines that are cut, and those that take more than one.
CUT_AND_WRAPPED = """async () => {
    const found = {cut: [], wrapped: []};
    for (const cell of jupyterapp.shell.currentWidget.content.widgets.filter(each => each.model.type === 'code')) {
        cell.node.scrollIntoView();
        let scroller;
        do await new Promise(done => setTimeout(done, 50));
        while (!(scroller = cell.node.querySelector('.cm-scroller')));
        if (scroller.scrollWidth > scroller.clientWidth + 1) found.cut.push(cell.model.sharedModel.source);
        for (const line of cell.node.querySelectorAll('.cm-line')) {
            const rows = line.offsetHeight / parseFloat(getComputedStyle(line).lineHeight);
            if (rows > 1.5) found.wrapped.push(line.innerText);
        }
    }
    return found;
}"""


@pytest.fixture
def page(opened):
    """Return the page, wide, with the cells run, and the second that shows the robot and its speed in sight."""
    _, page = opened
    page.page.set_viewport_size({'width': 1280, 'height': 800})
    page.page.evaluate(
        f"jupyterapp.shell.currentWidget.content.widgets[{TAGGED}].model.setMetadata('tags', ['stage'])")
    page.run_all()
    page.run_cell(SETTINGS)
    page.run_cell(AGAIN)
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
    return page


def beside(page):
    return page.page.get_by_role('complementary', name='Beside the text')


def strip(page):
    return beside(page).get_by_role('button', name='/base and /driver')


def read(page, heading):
    """Scroll to a heading, with the pointer on the text."""
    page.page.mouse.move(300, 400)
    page.select_cell(0)
    page.page.get_by_role('heading', name=heading).evaluate('heading => heading.scrollIntoView()')


def test_it_is_drawn_once_and_stays_in_sight_also_when_an_earlier_cell_runs_again(page):
    expect(page.page.locator('.side-by-side:has([data-is-beside]) .robot-view:visible')).to_have_count(0)
    read(page, 'Far away')
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
    # What a reader uses stays, whatever text comes.
    page.page.get_by_role('heading', name='Something else').evaluate('heading => heading.scrollIntoView()')
    page.page.wait_for_timeout(500)
    expect(page.box('max_speed_mps')).to_be_focused()


def test_it_folds_beside_text_about_something_else_and_unfolds_at_a_click_or_where_there_is_one(page):
    read(page, 'Of the robot, too')
    expect(beside(page).locator('.track-scene')).to_be_visible()
    expect(page.page.locator('.jp-toolbar-overlap')).to_have_count(1)  # the toolbar of the active cell has no room
    read(page, 'Something else')
    expect(strip(page)).to_be_visible()
    expect(page.page.locator('.jp-toolbar-overlap')).to_have_count(0)
    expect(beside(page).locator('.track-scene')).to_have_count(0)
    assert page.page.locator('.jp-Notebook').bounding_box()['width'] > 1150
    # The line that was read is where it was.
    expect(page.page.get_by_role('heading', name='Something else')).to_be_in_viewport()
    assert violations_in_both_themes(page.page, '.beside-text') == []
    strip(page).focus()
    page.page.keyboard.press('Enter')
    expect(beside(page)).to_be_focused()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
    read(page, 'The end')
    expect(beside(page).get_by_label('stop_distance_m', exact=True)).to_be_visible()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_have_count(0)
    read(page, 'Something else')
    expect(strip(page)).to_be_visible()


def test_shift_enter_beside_the_text_runs_the_cell_of_the_notebook(page):
    page.select_cell(AGAIN)
    page.box('max_speed_mps').press('Shift+Enter')
    page.page.wait_for_function(f'jupyterapp.shell.currentWidget.content.activeCellIndex === {AGAIN + 1}')


def test_a_reader_puts_it_into_the_cell_and_back(page):
    page.run_cell(OTHER)
    expect(beside(page).get_by_label('stop_distance_m', exact=True)).to_be_visible()
    beside(page).get_by_role('button', name='Show in the cell').click()
    expect(strip(page)).to_be_focused()
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    page.select_cell(SETTINGS)
    page.page.get_by_role('button', name='Show at the right').first.click()
    expect(beside(page)).to_be_focused()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()


def test_it_is_beside_the_cell_that_has_just_run_whatever_comes_below(page):
    change = 'end => { jupyterapp.shell.currentWidget.content.widgets.at(-1).model.sharedModel.source = end; }'
    page.page.evaluate(change, '## The end')
    page.run_cell(OTHER)
    expect(beside(page).get_by_label('stop_distance_m', exact=True)).to_be_visible()
    page.page.evaluate(change, CELLS[-1])


@pytest.mark.parametrize(('chapter', 'breaks'), [('01_what_are_parameters.ipynb', False), ('03_declaring.ipynb', True)])
def test_no_line_of_code_is_cut_at_1280_px_and_a_reload_keeps_the_stage(tmp_path, browser, chapter, breaks):
    """In JupyterLab's own font of 13 px, beside what a cell shows side by side, and the robot of a package."""
    with CourseLab(tmp_path / 'lab', [ROOT / 'notebooks' / chapter]) as lab:
        page = LabPage(lab, browser, chapter, 'lab')
        page.page.set_viewport_size({'width': 1280, 'height': 800})
        expect(page.page.locator('.jp-DirListing')).to_be_hidden()
        page.run_cell(1)
        expect(beside(page).locator('.track-scene')).to_be_visible()
        found = page.page.evaluate(CUT_AND_WRAPPED)
        assert found['cut'] == [] and bool(found['wrapped']) == breaks
        page.command('filebrowser:toggle-main')
        expect(page.page.locator('.jp-DirListing')).to_be_visible()
        assert page.page.evaluate(CUT_AND_WRAPPED)['cut'] == []
        # JupyterLab puts most of the cells onto the page later.
        page.reload()
        expect(beside(page).locator('.track-scene')).to_be_visible()
