"""The robot in the real JupyterLab: it moves by itself, arrives where the node says, and then all is quiet."""

import pytest
from playwright.sync_api import expect

from tests.support.lab import wait_for

pytestmark = [pytest.mark.slow, pytest.mark.thorough, pytest.mark.timeout(600)]  # each wait may take lab.TIMEOUT_SEC

CELLS = (
    '# A robot\nOn the stage:',
    'import param_tutorial\nfrom param_tutorial import ParameterClient, ParameterPanel\n'
    'from param_tutorial.views import RobotView, SideBySide\n'
    'from param_tutorial.nodes.clawbot_node import ClawbotNode\n\n'
    'ros = param_tutorial.start()\nrobot = ros.add(ClawbotNode)\nclient = ParameterClient(robot)',
    'Its picture, and its controls:',
    'view = RobotView(robot)\nSideBySide(view, ParameterPanel(robot))',
    '# Far away\n' + 'A line.\n\n' * 60,
    'view',
)
# Of each picture of the robot: how many parts move, and when on the browser's clock the drive began, in ms.
PLACES = """() => [...document.querySelectorAll('.robot-picture')].map(each => {
    const moving = each.getAnimations({subtree: true}).filter(one => one.playState === 'running');
    return [moving.length, ...moving.filter(one => one.startTime !== null).map(one => one.startTime)];
})"""
# Where the robot's front is, in meters from the start line. The mover's own origin is the front; the sensor's beam
# reaches further than the robot. One script, since a new picture may come between two.
FRONT_M = """() => { const scene = document.querySelector('.robot-scene'), svg = scene.querySelector('svg'),
    mover = svg.querySelector('.robot-mover'), box = scene.getBoundingClientRect();
    const front = mover.getCTM().e / svg.getCTM().a * svg.getBoundingClientRect().width / 1000
        + svg.getBoundingClientRect().left;
    return (front - box.x) / box.width * (0.8 + 4.0 + 0.35) - 0.8; }"""
# In one go, for a change draws the scene anew, and Playwright's own way gives up when what it scrolls to is replaced.
INTO_VIEW = "each => each.scrollIntoView({block: 'center'})"
RUNNING = """() => document.getAnimations().filter(
    each => /^robot-/.test(each.animationName) && each.playState === 'running').length"""


@pytest.fixture
def open_robot(opened):
    """Return the server and the page, on which running the cells has made a new robot."""
    _, page = opened
    page.page.emulate_media(reduced_motion='no-preference')
    # Too narrow for what stands beside the text.
    page.page.set_viewport_size({'width': 900, 'height': 900})
    page.run_all()
    expect(word(page)).to_have_text('READY')
    page.page.locator('.robot-scene').first.evaluate(INTO_VIEW)
    return opened


def view(page):
    """Find the first of the two pictures."""
    return page.page.locator('.robot-view').first


def word(page):
    return view(page).locator('.robot-word')


def drive(page):
    view(page).get_by_role('button', name='Drive').click()


def count_changes(page):
    """Begin to count what changes in the view's part of the page."""
    page.page.evaluate('''() => {
        window.changes = 0;
        new MutationObserver(list => window.changes += list.length).observe(
            document.querySelector('.robot-view'), {subtree: true, childList: true, attributes: true,
            characterData: true}) }''')


def front_m(page):
    return page.page.evaluate(FRONT_M)


def test_it_moves_without_the_kernel_stops_and_then_nothing_is_sent(open_robot):
    lab, page = open_robot
    lab.ask_kernel("client.set_parameter('max_acceleration_mps2', 0.02)")
    drive(page)
    expect(word(page)).to_have_text('SPEEDING UP')
    count_changes(page)
    # The words for a screen reader may still be on their way; after the last change the browser moves it by itself.
    page.page.wait_for_function(f"""() => {{
        if (window.changes || window.begin === undefined) [window.begin, window.changes] = [({FRONT_M})(), 0];
        return ({FRONT_M})() > window.begin + 0.03;
    }}""")
    assert page.page.evaluate(RUNNING) > 0

    page.box('max_acceleration_mps2').fill('2.0')
    page.box('max_acceleration_mps2').press('Enter')
    expect(word(page)).to_have_text('STOPPED')
    assert front_m(page) == pytest.approx(3.8, abs=0.01)
    assert lab.ask_kernel('robot.state.word, robot.timer.is_canceled()') == "('STOPPED', True)"
    wait_for(lambda: page.page.evaluate(RUNNING) == 0, 'the picture to stand still')
    count_changes(page)
    page.page.wait_for_timeout(1000)
    assert page.page.evaluate('window.changes') == 0


def test_the_browser_shows_it_where_the_closed_form_says_thirty_times_a_second(open_robot):
    """More often costs a browser without a graphics card more, and looks the same."""
    lab, page = open_robot
    # Its own clock stands still, so the kernel sends nothing more; the browser's is stopped after 3 s.
    lab.ask_kernel('[ros.add(ClawbotNode, real_time=False), view.drive()]')
    expect(word(page)).to_have_text('SPEEDING UP')
    page.page.evaluate("""() => document.getAnimations().filter(each => /^robot-/.test(each.animationName))
        .forEach(each => { each.pause(); each.currentTime = 3000 })""")
    assert front_m(page) == pytest.approx(float(lab.ask_kernel('view._robot.motion[0].at(3).position_m')), abs=0.01)
    strip = view(page).locator('.robot-strip').bounding_box()
    window = view(page).locator('.robot-window').bounding_box()
    line = round((window['y'] - strip['y']) / 20)
    assert 'speed 1.05 m/s' in view(page).locator('.robot-strip').inner_text().splitlines()[line]
    places = page.page.evaluate("""() => {
        const mover = document.querySelector('.robot-mover'), [film] = mover.getAnimations(), places = new Set();
        for (film.currentTime = 1000; film.currentTime < 2000; film.currentTime += 5)
            places.add(getComputedStyle(mover).transform);
        return [...places]; }""")
    assert len(places) == pytest.approx(30, abs=1)


def test_with_safety_off_it_crashes_in_words_and_shape(open_robot):
    _, page = open_robot
    page.box('enable_safety_mode').click()
    expect(view(page).locator('.robot-head')).to_contain_text('safety off')
    drive(page)
    expect(word(page)).to_have_text('CRASHED')
    expect(view(page).locator('.robot-burst')).to_be_visible()
    expect(view(page).get_by_role('img', name='CRASHED. Clawbot has run into the wall at 1.05 m/s.')).to_be_visible()
    expect(view(page).get_by_role('status').filter(has_text='has run into the wall')).to_be_visible()
    # The word may be there before the last picture.
    wait_for(lambda: front_m(page) == pytest.approx(4.0, abs=0.05), 'the robot to stand at the wall')


def test_whoever_wants_no_motion_gets_it_in_a_few_jumps(open_robot):
    _, page = open_robot
    page.page.emulate_media(reduced_motion='reduce')
    drive(page)
    expect(word(page)).to_have_text('CRUISING')
    assert page.page.evaluate(RUNNING) == 0
    assert front_m(page) > 0.5
    expect(word(page)).to_have_text('STOPPED')
    assert front_m(page) == pytest.approx(3.8, abs=0.01)


@pytest.mark.parametrize(('width', 'is_beside'), [(1280, True), (860, False)])
def test_the_picture_stays_in_sight_while_one_works_with_a_long_panel(open_robot, width, is_beside):
    _, page = open_robot
    page.page.set_viewport_size({'width': width, 'height': 800})
    if width == 1280:
        page.page.get_by_role('button', name='Put into the cell').click()
    picture, panel = view(page), page.page.locator('.param-panel')
    wait_for(lambda: (picture.bounding_box()['x'] + picture.bounding_box()['width']
                      <= panel.bounding_box()['x']) is is_beside, f'the panel to be beside the picture: {is_beside}')
    page.row('wheel_radius_meters').scroll_into_view_if_needed()
    expect(picture.locator('.robot-scene')).to_be_in_viewport(ratio=0.99)
    expect(page.row('wheel_radius_meters')).to_be_in_viewport(ratio=0.99)
    # And nothing lies on the row: a hand can reach its control.
    expect(picture.locator('.robot-snow')).to_be_hidden()
    page.box('ambient_temperature_c').fill('-10')
    page.box('ambient_temperature_c').press('Enter')
    expect(picture.locator('.robot-snow')).to_be_visible()


def test_a_picture_out_of_sight_costs_nothing_and_is_in_time_when_it_is_seen_again(open_robot):
    lab, page = open_robot
    lab.ask_kernel("client.set_parameter('max_speed_rpm', 2)")  # minutes on its way
    first, second = page.page.locator('.robot-scene').all()
    drive(page)
    began = wait_for(lambda: only_moving(page, 0), 'the first to move, and no other')

    second.evaluate(INTO_VIEW)
    assert wait_for(lambda: only_moving(page, 1), 'the second to move, and no other')
    first.evaluate(INTO_VIEW)
    assert wait_for(lambda: only_moving(page, 0), 'the first to move again') == pytest.approx(began, abs=1)


def only_moving(page, number):
    """Return when the drive of this picture began, if it moves and no other does."""
    places = page.page.evaluate(PLACES)
    moving, *began = places.pop(number)
    return min(began) if moving and len(began) == moving and not any(count for count, *_ in places) else None
