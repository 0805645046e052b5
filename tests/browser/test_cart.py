"""The cart in the real JupyterLab: it moves by itself and rests, and stands beside the text while there is room."""

import pytest
from playwright.sync_api import expect

from tests.support.lab import wait_for

pytestmark = [pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A cart\nIn its aisle:',
    'import param_tutorial\nfrom param_tutorial import ParameterClient, ParameterPanel\n'
    'from param_tutorial.views import CartView, SideBySide\n'
    'from param_tutorial.nodes.cart_node import CartNode\n\n'
    'ros = param_tutorial.start()\ncart = ros.add(CartNode)\nclient = ParameterClient(cart)\n'
    'view = CartView(cart)',
    "panel = ParameterPanel(cart, names=['max_speed_mps'])\nSideBySide(view, panel)",
    '# Far away\n' + 'A line.\n\n' * 60,
    'SideBySide(view, panel)',
    "SideBySide(view, ParameterPanel(cart, names=['max_acceleration_mps2']))",
)
CART, SETTINGS, AGAIN, OTHER = 1, 2, 4, 5
# Of each picture of the cart: how many parts move, and when on the browser's clock the drive began, in ms.
PLACES = """() => [...document.querySelectorAll('.robot-picture')].map(each => {
    const moving = each.getAnimations({subtree: true}).filter(one => one.playState === 'running');
    return [moving.length, Math.min(...moving.map(one => one.startTime))];
})"""
# Where the cart's front is, in meters from the start line. The mover's own origin is the front; the scanner's beam
# reaches further than the cart. One script, since a new picture may come between two.
FRONT_M = """() => { const scene = document.querySelector('.robot-scene'), svg = scene.querySelector('svg'),
    mover = svg.querySelector('.robot-mover'), box = scene.getBoundingClientRect();
    const front = mover.getCTM().e / svg.getCTM().a * svg.getBoundingClientRect().width / 1000
        + svg.getBoundingClientRect().left;
    return (front - box.x) / box.width * (2 + 12 + 0.5) - 2; }"""
# In one go, for a change draws the scene anew, and Playwright's own way gives up when what it scrolls to is replaced.
INTO_VIEW = "each => each.scrollIntoView({block: 'center'})"
RUNNING = """() => document.getAnimations().filter(
    each => /^robot-/.test(each.animationName) && each.playState === 'running').length"""


# -- in cells ------------------------------------------------------------------------------------------------

@pytest.fixture
def in_cells(opened):
    """Return the server, and the page with a new cart, which is too narrow for what stands beside the text."""
    _, page = opened
    page.page.emulate_media(reduced_motion='no-preference')
    page.page.set_viewport_size({'width': 880, 'height': 900})
    page.run_all()
    expect(word(page)).to_have_text('READY')
    page.page.locator('.robot-scene').first.evaluate(INTO_VIEW)
    return opened


def word(page):
    return page.page.locator('.robot-word').first


def drive(page):
    page.page.get_by_role('button', name='Drive').first.click()


def count_changes(page):
    """Begin to count what changes in the view's part of the page."""
    page.page.evaluate('''() => {
        window.changes = 0;
        new MutationObserver(list => window.changes += list.length).observe(
            document.querySelector('.robot-view'), {subtree: true, childList: true, attributes: true,
            characterData: true}) }''')


def front_m(page):
    return page.page.evaluate(FRONT_M)


def test_it_moves_without_the_kernel_stops_and_then_nothing_is_sent(in_cells):
    lab, page = in_cells
    lab.ask_kernel("client.set_parameters({'max_speed_mps': 0.5, 'max_acceleration_mps2': 0.1})")
    drive(page)
    expect(word(page)).to_have_text('SPEEDING UP')
    count_changes(page)
    # The words for a screen reader may still be on their way; after the last change the browser moves it by itself.
    page.page.wait_for_function(f"""() => {{
        if (window.changes || window.begin === undefined) [window.begin, window.changes] = [({FRONT_M})(), 0];
        return ({FRONT_M})() > window.begin + 0.03;
    }}""")
    assert page.page.evaluate(RUNNING) > 0
    lab.ask_kernel("client.set_parameters({'max_acceleration_mps2': 2.0, 'max_speed_mps': 2.0})")
    expect(word(page)).to_have_text('STOPPED')
    assert front_m(page) == pytest.approx(12.0, abs=0.02)
    wait_for(lambda: page.page.evaluate(RUNNING) == 0, 'the picture to stand still')
    count_changes(page)
    page.page.wait_for_timeout(1000)
    assert page.page.evaluate('window.changes') == 0


def test_the_browser_shows_it_where_the_closed_form_says_thirty_times_a_second(in_cells):
    """More often costs a browser without a graphics card more, and looks the same."""
    lab, page = in_cells
    drive(page)
    expect(word(page)).to_have_text('SPEEDING UP')
    page.page.evaluate("""() => document.getAnimations().filter(each => /^robot-/.test(each.animationName))
        .forEach(each => { each.pause(); each.currentTime = 3000 })""")
    assert front_m(page) == pytest.approx(float(lab.ask_kernel('view._motion.at(3).position_m')), abs=0.02)
    places = page.page.evaluate("""() => {
        const mover = document.querySelector('.robot-mover'), [film] = mover.getAnimations(), places = new Set();
        for (film.currentTime = 1000; film.currentTime < 2000; film.currentTime += 5)
            places.add(getComputedStyle(mover).transform);
        return [...places]; }""")
    assert len(places) == pytest.approx(30, abs=1)


def test_whoever_wants_no_motion_gets_it_in_a_few_jumps(in_cells):
    _, page = in_cells
    page.page.emulate_media(reduced_motion='reduce')
    drive(page)
    expect(word(page)).to_have_text('CRUISING')
    assert page.page.evaluate(RUNNING) == 0
    assert front_m(page) > 0.5
    expect(word(page)).to_have_text('STOPPED')
    assert front_m(page) == pytest.approx(12.0, abs=0.02)


def test_a_picture_out_of_sight_costs_nothing_and_is_in_time_when_it_is_seen_again(in_cells):
    lab, page = in_cells
    lab.ask_kernel("client.set_parameter('max_speed_mps', 0.1)")  # minutes on its way
    first, *_, last = page.page.locator('.robot-scene').all()
    drive(page)
    began = wait_for(lambda: only_moving(page, 0, -1), 'the first to move, and not the last')
    last.evaluate(INTO_VIEW)
    assert wait_for(lambda: only_moving(page, -1, 0), 'the last to move, and not the first')
    first.evaluate(INTO_VIEW)
    assert wait_for(lambda: only_moving(page, 0, -1), 'the first to move again') == pytest.approx(began, abs=1)


def only_moving(page, number, other):
    """Return when the drive of one picture began, if it moves and another does not."""
    places = page.page.evaluate(PLACES)
    return places[number][1] if places[number][0] and not places[other][0] else None


# -- beside the text -----------------------------------------------------------------------------------------

@pytest.fixture
def page(opened):
    """Return the page, wide, with the cells run up to the second that shows the cart and its speed."""
    _, page = opened
    page.page.set_viewport_size({'width': 1280, 'height': 800})
    page.run_all()
    page.run_cell(SETTINGS)
    page.run_cell(AGAIN)
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
    return page


def beside(page):
    return page.page.get_by_role('complementary', name='Beside the text')


def test_it_is_drawn_once_and_stays_in_sight_also_when_an_earlier_cell_runs_again(page):
    expect(page.page.locator('.side-by-side:has([data-is-beside]) .robot-view:visible')).to_have_count(0)
    page.page.get_by_role('heading', name='Far away').scroll_into_view_if_needed()
    expect(beside(page).locator('.robot-scene')).to_be_in_viewport(ratio=0.99)
    # And no text is below it.
    text = page.page.get_by_role('heading', name='Far away').bounding_box()
    assert text['x'] + text['width'] <= beside(page).bounding_box()['x']
    page.run_cell(CART)
    page.run_cell(SETTINGS)
    expect(beside(page).locator('.robot-view')).to_have_count(1)
    page.box('max_speed_mps').fill('0.5')
    page.box('max_speed_mps').press('Enter')
    expect(page.row('max_speed_mps')).to_contain_text('↺')


def test_what_the_last_cell_shows_takes_the_place_until_a_reader_chooses(page):
    page.run_cell(OTHER)
    expect(beside(page).get_by_label('max_acceleration_mps2', exact=True)).to_be_visible()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_have_count(0)
    beside(page).get_by_role('button', name='Put into the cell').click()
    expect(beside(page)).to_be_hidden()
    expect(page.page.locator('.jp-OutputArea-output .robot-view:visible').first).to_be_visible()
    page.select_cell(SETTINGS)
    page.page.get_by_role('button', name='Put beside the text').first.click()
    expect(beside(page)).to_be_focused()
    expect(beside(page).get_by_label('max_speed_mps', exact=True)).to_be_visible()
