"""The robot: how its picture moves and what it says; what its view sends to the browser, and that it lets go."""

import itertools
import math
import re
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tools.errors import NodeNotFoundError
from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.clawbot_node import ClawbotNode, Motion, Settings, State, plan
from param_tutorial.views import RobotView
from param_tutorial.views.drawing import driving
from param_tutorial.views.drawing.robot import Robot
from tests.support.widgets import press
from tests.views.conftest import shows

FAST, SLOW, UNSAFE = Settings(1.0, 0.5), Settings(0.2, 0.5), Settings(1.0, 0.5, safety_on=False)
READY, STOPPED = State('READY', 0.0), State('STOPPED', 3.8)


def drawing(motion, settings=FAST, **others):
    facts = {'name': 'Clawbot', 'serial_number': 'SN-1', 'wheel_m': 0.1, **others}
    return Robot(settings=settings, motion=motion, **facts)


def drawn(picture):
    """Parse a picture, without the keyframes before it."""
    return ElementTree.fromstring(picture.rpartition('</style>')[2])


def bezier(curve, time):
    """Return the progress of a CSS cubic-bezier whose x is time itself, as ours are."""
    x1, y1, x2, y2 = map(float, re.fullmatch(r'cubic-bezier\((.*)\)', curve)[1].split(','))
    assert (x1, x2) == pytest.approx((1 / 3, 2 / 3), abs=1e-5)
    return 3 * y1 * time * (1 - time) ** 2 + 3 * y2 * time ** 2 * (1 - time) + time ** 3


@given(st.floats(0.01, 2.0), st.integers(1, 300), st.floats(0.0, 2.0), st.booleans(), st.floats(0.0, 1.0))
def test_the_browser_moves_it_along_the_closed_form(acceleration, speed_rpm, velocity, safety_on, fraction):
    motion = plan(0.5, velocity, Settings(speed_rpm / 60 * 2 * math.pi * 0.1, acceleration, safety_on))
    for phase in motion.phases:
        way_m = phase.at(phase.duration_sec).position_m - phase.position_m
        exact = phase.at(fraction * phase.duration_sec).position_m - phase.position_m
        assert bezier(driving._timing_function(phase), fraction) * way_m == pytest.approx(exact, abs=2e-5)


def test_a_drive_is_a_step_for_each_phase_and_few_parts_move_by_themselves():
    motion = plan(0.0, 0.0, FAST)
    picture = driving.moving(drawing(motion))
    for kind in ('robot', 'wheel', 'brake'):
        steps = re.search(rf'@keyframes robot-NAME-{kind} \{{(.*?)\}}\}}', picture)[1]
        assert steps.count('cubic-bezier') == len(motion.phases) == 3
    # Robot, two wheels, way to stop, ray, numbers; how the antenna leans is told with each scene.
    assert picture.count(f'{motion.duration_sec:.4f}s linear both') == picture.count('animation:') == 6
    assert drawn(picture).find('.//g[@class="robot-antenna"]').get('style') == 'transform:rotate(var(--lean));'
    numbers = drawn(picture).find('.//*[@class="robot-strip"]').text.splitlines()
    assert (numbers[0], numbers[-1]) == ('speed 0.00 m/s, 4.00 m to the wall', 'speed 0.00 m/s, 0.20 m to the wall')
    assert 'speed 1.00 m/s, 3.00 m to the wall' in numbers
    assert 'animation' not in driving.moving(drawing(Motion((), State('WAITING', 0.0))))


@pytest.mark.slow
@given(st.floats(0.01, 2.0), st.integers(1, 300), st.floats(0.0, 0.9), st.floats(2.0, 20.0))
def test_its_ray_has_no_gap_up_to_the_wall(acceleration, speed_rpm, velocity, track_m):
    """At each moment, its own part reaches the point where the rest begins, and no gap opens."""
    settings = Settings(speed_rpm / 60 * 2 * math.pi * 0.1, acceleration, track_m=track_m)
    facts = drawing(plan(0.5, velocity, settings), settings)
    steps = re.search(r'@keyframes robot-NAME-ray \{(.*?)\}\}', driving.moving(facts))[1] + '}'
    jumps = [(float(percent) / 100 * facts.motion.duration_sec, float(x))
             for percent, x in re.findall(r'([\d.]+)% \{transform:translateX\(([\d.]+)px\)', steps)]
    assert steps.count('step-end') == len(jumps) - 1
    # Percentages have four digits.
    blur_sec = 1e-6 * facts.motion.duration_sec + 1e-5
    for (begin_sec, x), (end_sec, _) in itertools.pairwise(jumps):
        for moment_sec in (begin_sec, end_sec):
            eye_m = facts.motion.at(moment_sec).position_m + facts.ray_begin_m
            blur_units = (blur_sec * 2 * 3.2 + 1e-4) * facts.units_per_m
            assert facts.x(eye_m) - blur_units <= x <= facts.x(eye_m + facts.reach_m) + blur_units


@pytest.mark.parametrize(('state', 'settings', 'sentence'), [
    (State('READY', 0.0), FAST, 'Clawbot stands at the start.'),
    (State('SPEEDING UP', 1.0, 0.5, 0.5), FAST, 'Clawbot is speeding up with 0.50 m/s², up to 1.00 m/s.'),
    (State('CRUISING', 1.0, 1.0), FAST, 'Clawbot is driving at a steady speed.'),
    (State('SLOWING DOWN', 1.0, 1.0), SLOW, 'Clawbot is slowing down to 0.20 m/s.'),
    (State('BRAKING', 3.0, 1.0), FAST, 'Clawbot is braking, to stop 0.20 m from the wall.'),
    (State('EMERGENCY BRAKING', 3.5, 1.0), FAST, 'Clawbot is braking as hard as it can, to stop 0.20 m from the wall.'),
    (State('WAITING', 0.0), FAST, 'Clawbot is waiting: it is cold.'),
    (State('STOPPED', 3.8), FAST, 'Clawbot has stopped 0.20 m from the wall.'),
    (State('CRASHED', 4.0, crash_speed_mps=1.05), FAST, 'Clawbot has run into the wall at 1.05 m/s.'),
])
def test_each_state_has_its_sentence(state, settings, sentence):
    facts = drawing(Motion((), STOPPED), settings, waiting_for='it is cold')
    moment = driving.Moment(facts, state)
    assert moment.sentence == sentence
    assert moment.text.startswith(f'{state.word}. {sentence} Speed ')
    assert drawn(driving.still(moment)).find('.//*[@role="img"]').get('aria-label') == moment.text


@pytest.mark.parametrize(('state', 'settings', 'others', 'seen', 'unseen'), [
    (STOPPED, FAST, {}, ['robot-beam', '>stop<', '>safety on<'], ['robot-burst', 'robot-snow', 'sensor?']),
    (State('CRASHED', 4.0, crash_speed_mps=0.3), UNSAFE, {}, ['CRASH', '>0.30 m/s<', '--crash:0.20', '>safety off<'],
     ['robot-beam', '>stop<']),
    (State('CRASHED', 4.0, crash_speed_mps=2.0), UNSAFE, {}, ['CRASH', '>2.00 m/s<', '--crash:1.00'], []),
    (READY, FAST, {'temperature_c': 0}, ['>air 0 °C<'], ['robot-snow', 'robot-ice']),
    (READY, FAST, {'temperature_c': -12}, ['>❄ air −12 °C<', 'robot-snow', 'robot-ice'], []),
    (READY, FAST, {'wheel_m': 0.12}, ['class="robot-tire" cx="-46" cy="-12" r="12"'], []),
    (READY, Settings(1.0, 0.5, sensor_offset_m=0.4), {}, ['>sensor?<'], []),
    (READY, Settings(1.0, 0.5, track_m=14.0), {}, ['>12 m<', '>14 m<'], ['>13 m<']),
])
def test_what_a_node_is_set_to_is_seen(state, settings, others, seen, unseen):
    picture = driving.still(drawing(Motion((), state), settings, **others).at(0.0))
    assert [words for words in seen if words not in picture] == []
    assert [words for words in unseen if words in picture] == []


def test_the_bar_before_the_robot_is_the_way_in_which_it_would_stop():
    """At each speed; where the safety mode brakes, the bar ends at the stop line all the time."""
    motion = plan(0.0, 0.0, FAST)
    facts = drawing(motion)
    for elapsed_sec in (0.0, 1.0, 3.0, 4.0, 5.0, 5.7):
        moment = facts.at(elapsed_sec)
        stretched = float(re.search(r'scaleX\(([\d.]+)\)', driving.still(moment))[1])
        way_m = stretched * 100 / facts.units_per_m
        assert way_m == pytest.approx(moment.state.velocity_mps ** 2 / (2 * 0.5), abs=1e-3)
        if moment.state.word == 'BRAKING':
            assert moment.state.position_m + facts.stopping_m(moment.state) == pytest.approx(FAST.stop_m)


def test_a_robot_is_painted_by_its_name_and_patterns_tell_paints_apart():
    paints = {name: driving.paint(name) for name in ('Clawbot', 'Second', 'Third')}
    assert paints['Clawbot'] != paints['Second']
    assert driving.paint(' Clawbot ') == paints['Clawbot']
    for name, number in paints.items():
        assert f'robot-paint-{number}"' in driving.still(drawing(Motion((), State('READY', 0.0)), name=name).at(0.0))
    assert len({driving.pattern(number, 0, 0, 40, 10) for number in range(8)}) == 8


def test_a_scene_tells_what_a_vehicle_does_from_a_moment_on():
    facts = drawing(plan(0.0, 0.0, FAST))
    times, states, full_texts, sentences, leans = zip(*(facts.at(second).scene for second in (0.0, 2.5, 4.0, 9.0)))
    assert states == ('SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED')
    assert times == pytest.approx((0.0, 2.5, 4.0, 5.8))
    assert leans == pytest.approx((-math.atan(.5 / 9.81), 0.0, math.atan(.5 / 9.81), 0.0), abs=1e-4)
    assert all(sentence in text for sentence, text in zip(sentences, full_texts))


def test_a_replay_tells_its_words_by_itself_and_how_it_ends():
    facts = drawing(plan(0.0, 0.0, FAST))
    picture = driving.replay(facts)
    # Where nothing may move, it stands where it has stopped.
    assert f'class="robot-mover" style="transform:translateX({facts.x(3.8):.3f}px);animation:' in picture
    assert re.findall(r'step-end">([A-Z ]+)</span>', picture) == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']
    assert 'aria-label="STOPPED. Clawbot has stopped 0.20 m from the wall.' in picture
    assert picture == driving.replay(drawing(plan(0.0, 0.0, FAST)))
    assert '@keyframes' in driving.STYLE and picture.startswith(driving.STYLE)


# -- the view ------------------------------------------------------------------------------------------------

@pytest.fixture
def robot(ros):
    return ros.add(ClawbotNode, real_time=False)


@pytest.fixture
def view(robot):
    return RobotView(robot)


@pytest.mark.slow
def test_a_picture_for_each_motion_words_for_each_thing_it_begins_to_do_and_nothing_while_it_stands(view, robot):
    pictures, scenes = [], []
    view._front.observe(lambda change: pictures.append(change.new), 'picture')
    view._front.observe(lambda change: scenes.append(change.new), 'scene')
    view.drive()
    shows(view, 'SPEEDING UP')
    for seconds, word in ((2.5, 'CRUISING'), (1.5, 'BRAKING'), (math.inf, 'STOPPED')):
        robot.react([])  # as when a parameter is set to what it is
        assert view._job.call_now(5.0)
        robot.step(seconds)
        shows(view, word)
    end_sec = pytest.approx(robot.motion[0].duration_sec, abs=1e-4)
    assert [(at_sec, word) for at_sec, word, *_ in scenes] == [
        (0.0, 'SPEEDING UP'), (2.5, 'CRUISING'), (4.0, 'BRAKING'), (end_sec, 'STOPPED')]
    assert ['@keyframes' in each for each in pictures] == [True, False]
    assert view.text == ('STOPPED. Clawbot has stopped 0.20 m from the wall. Speed 0.00 m/s, 0.20 m to the wall, '
                         'safety on.')
    robot.step(1000.0)
    robot.react([])
    wait_until(lambda: view._job.is_idle, 'the view to rest')
    assert len(scenes) == 4 and len(pictures) == 2


def test_a_second_drive_on_the_way_begins_the_picture_anew(view, robot):
    view.drive()
    shows(view, 'SPEEDING UP')
    take = view._front.take
    robot.step(1.0)
    view.drive()
    assert view._job.call_now(5.0)
    assert (view._front.take, view._front.scene[:2]) == (take + 1, [0.0, 'SPEEDING UP'])


def test_a_parameter_changed_on_the_way_is_sent_from_where_the_robot_is(view, robot):
    view.drive()
    robot.step(1.0)
    ParameterClient(robot).set_parameter('max_acceleration_mps2', 1.5)
    wait_until(lambda: '1.50 m/s²' in view.text, 'the new acceleration')
    assert 'Speed 0.50 m/s, 3.75 m to the wall' in view.text
    assert f'translateX({1000 * 1.05 / 5.15:.3f}px)' in view._front.picture


def test_name_safety_and_offset_are_seen_at_once_while_it_stands(view, robot):
    client = ParameterClient(robot)
    stop_line = '>stop</text>'
    assert stop_line in view._front.picture
    client.set_parameters({'robot_name': 'A <b>"claw"</b>', 'enable_safety_mode': False})
    wait_until(lambda: 'safety off' in view.text and 'A <b>' in view.text, 'the changes')
    assert stop_line not in view._front.picture
    assert '<b>' not in view._front.picture
    assert 'A &lt;b&gt;&quot;claw&quot;&lt;/b&gt;' in view._front.picture


def test_what_it_waits_for_is_kept_up_to_date(view, robot):
    client = ParameterClient(robot)
    client.set_parameters({'simulation.ambient_temperature_c': -10})
    view.drive()
    wait_until(lambda: '-10 °C is below' in view.text, 'the view to say how cold it is')
    client.set_parameters({'simulation.ambient_temperature_c': -20})  # still too cold, so the robot waits on
    wait_until(lambda: '-20 °C is below' in view.text, f'the view to follow; it says {view.text!r}')


@pytest.mark.slow
def test_it_follows_a_robot_that_is_replaced_and_survives_one_that_is_gone(ros, view, robot):
    again = ros.add(ClawbotNode, real_time=False, ros_args=['-p', 'robot_name:=Second'])
    wait_until(lambda: 'Second' in view.text, 'the view to follow')
    assert robot._listeners == []
    assert len(again._listeners) == 1
    ros.remove(again)
    shows(view, '/clawbot_node is not running')
    with pytest.raises(NodeNotFoundError):
        view.drive()
    press(view, 'drive')  # before the page knows that the robot is gone
    assert view._front.scene == []
    again = ros.add(ClawbotNode, real_time=False)
    shows(view, 'READY')
    view.close()
    view.close()
    assert again._listeners == [] and repr(view) == '<RobotView: /clawbot_node, closed>'


def test_it_may_be_made_before_its_robot(ros):
    view = RobotView('clawbot_node')
    assert view.text == '/clawbot_node is not running. It comes back here when it does.'
    ros.add(ClawbotNode, real_time=False)
    shows(view, 'READY. Clawbot stands at the start. Speed 0.00 m/s, 4.00 m to the wall, safety on.')
    assert view._front.scene[2:4] == [view.text, 'Clawbot stands at the start.']
    assert '<div class="robot-says" role="status">' in view._front.markup
    assert 'prefers-reduced-motion: reduce' in view._front._css
