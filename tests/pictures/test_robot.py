"""The robot's picture: how it moves, what it says in words, and that names in it stay text. No node is needed."""

import itertools
import math
import re
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from param_tutorial.nodes.clawbot_node import Motion, Settings, State, plan
from param_tutorial.pictures import track
from param_tutorial.pictures.robot import Robot

FAST, SLOW = Settings(1.0, 0.5), Settings(0.2, 0.5)


def robot(motion, settings=FAST, **others):
    facts = {'name': 'Clawbot', 'serial_number': 'SN-1', 'wheel_m': 0.1, **others}
    return Robot(settings=settings, motion=motion, **facts)


def drawn(picture):
    """Parse a picture, without the keyframes before it."""
    return ElementTree.fromstring(picture.rpartition('</style>')[2])


def texts(picture):
    return [text for text in drawn(picture).itertext() if text.strip()]


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
        assert bezier(track._timing_function(phase), fraction) * way_m == pytest.approx(exact, abs=2e-5)


def test_an_animation_is_one_step_for_each_phase_and_the_end():
    motion = plan(0.0, 0.0, FAST)
    picture = track.moving(robot(motion))
    for kind in ('robot', 'wheel', 'brake'):
        steps = re.search(rf'@keyframes robot-NAME-{kind} \{{(.*?)\}}\}}', picture)[1]
        assert steps.count('cubic-bezier') == len(motion.phases) == 3
    assert [float(turn) for turn in re.findall(r'rotate\(([\d.]+)rad\)', re.search(
        r'@keyframes robot-NAME-wheel .*?\}\}', picture)[0])] == pytest.approx(
            [*(phase.position_m / 0.1 for phase in motion.phases), 38.0], abs=1e-3)


def test_few_parts_move_by_themselves():
    motion = plan(0.0, 0.0, FAST)
    picture = track.moving(robot(motion))
    # Robot, two wheels, way to stop, ray, numbers; how the antenna leans is told with each scene.
    assert picture.count(f'{motion.duration_sec:.4f}s linear both') == picture.count('animation:') == 6
    assert drawn(picture).find('.//g[@class="robot-antenna"]').get('style') == 'transform:rotate(var(--lean));'


@pytest.mark.slow
@given(st.floats(0.01, 2.0), st.integers(1, 300), st.floats(0.0, 0.9), st.floats(2.0, 20.0))
def test_its_ray_has_no_gap_up_to_the_wall(acceleration, speed_rpm, velocity, track_m):
    """At each moment, its own part reaches the point where the rest begins, and no gap opens."""
    settings = Settings(speed_rpm / 60 * 2 * math.pi * 0.1, acceleration, track_m=track_m)
    facts = robot(plan(0.5, velocity, settings), settings)
    steps = re.search(r'@keyframes robot-NAME-ray \{(.*?)\}\}', track.moving(facts))[1] + '}'
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


def test_the_numbers_are_those_of_the_motion_from_begin_to_end():
    numbers = drawn(track.moving(robot(plan(0.0, 0.0, FAST)))).find('.//*[@class="robot-strip"]').text
    lines = numbers.splitlines()
    assert lines[0] == 'speed 0.00 m/s, 4.00 m to the wall'
    assert lines[-1] == 'speed 0.00 m/s, 0.20 m to the wall'
    assert 'speed 1.00 m/s, 3.00 m to the wall' in lines


def test_what_stands_still_is_not_animated():
    assert 'animation' not in track.still(robot(Motion((), State('READY', 0.0))).at(0.0))
    assert 'animation' not in track.moving(robot(Motion((), State('WAITING', 0.0))))


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
    facts = robot(Motion((), State('STOPPED', 3.8)), settings, waiting_for='it is cold')
    moment = track.Moment(facts, state)
    assert moment.sentence == sentence
    assert moment.text.startswith(f'{state.word}. {sentence} Speed ')
    assert drawn(track.still(moment)).find('.//*[@role="img"]').get('aria-label') == moment.text


def test_braking_too_late_is_said():
    facts = robot(Motion((), State('CRASHED', 4.0, crash_speed_mps=0.5)))
    assert track.Moment(facts, State('BRAKING', 3.9, 1.0)).sentence == 'Clawbot is braking, too late.'


def test_a_state_without_words_is_a_mistake():
    with pytest.raises(AssertionError, match='no words for FLYING'):
        _ = robot(Motion((), State('FLYING', 0.0))).at(0.0).sentence


def test_a_crash_has_a_burst_and_safety_a_line_at_which_to_stop():
    safe = track.still(robot(Motion((), State('STOPPED', 3.8))).at(0.0))
    crashed = track.still(robot(Motion((), State('CRASHED', 4.0)), Settings(1.0, 0.5, safety_on=False)).at(0.0))
    assert ('robot-burst' in safe, 'robot-burst' in crashed) == (False, True)
    assert ('robot-beam' in safe, 'robot-beam' in crashed) == (True, False)
    assert ('stop' in texts(safe), 'stop' in texts(crashed)) == (True, False)
    assert ('safety on' in texts(safe), 'safety off' in texts(crashed)) == (True, True)


def test_a_crash_is_the_worse_the_faster():
    def crash(speed_mps):
        state = State('CRASHED', 4.0, crash_speed_mps=speed_mps)
        return track.still(robot(Motion((), state), Settings(1.0, 0.5, safety_on=False)).at(0.0))

    gentle, hard = crash(0.3), crash(2.0)
    assert 'CRASH' in texts(gentle) and '0.30 m/s' in texts(gentle) and '2.00 m/s' in texts(hard)
    assert 0 < gentle.count('robot-debris') < hard.count('robot-debris')
    assert float(re.search(r'--crash:([\d.]+)', gentle)[1]) < float(re.search(r'--crash:([\d.]+)', hard)[1])


def test_the_bar_before_the_robot_is_the_way_in_which_it_would_stop():
    """At each speed; where the safety mode brakes, the bar ends at the stop line all the time."""
    motion = plan(0.0, 0.0, FAST)
    facts = robot(motion)
    for elapsed_sec in (0.0, 1.0, 3.0, 4.0, 5.0, 5.7):
        moment = facts.at(elapsed_sec)
        stretched = float(re.search(r'scaleX\(([\d.]+)\)', track.still(moment))[1])
        way_m = stretched * 100 / facts.units_per_m
        assert way_m == pytest.approx(moment.state.velocity_mps ** 2 / (2 * 0.5), abs=1e-3)
        if moment.state.word == 'BRAKING':
            assert moment.state.position_m + facts.stopping_m(moment.state) == pytest.approx(FAST.stop_m)


def test_cold_is_seen_and_read():
    warm, cold = (track.still(robot(Motion((), State('READY', 0.0)), temperature_c=degrees).at(0.0))
                  for degrees in (0, -12))
    assert ('0 °C' in texts(warm), 'robot-snow' in warm, 'robot-ice' in warm) == (True, False, False)
    assert ('❄ −12 °C' in texts(cold), 'robot-snow' in cold, 'robot-ice' in cold) == (True, True, True)


@pytest.mark.parametrize('radius_m', [0.05, 0.12])
def test_wheels_are_as_large_as_they_are(radius_m):
    picture = drawn(track.still(robot(Motion((), State('READY', 0.0)), wheel_m=radius_m).at(0.0)))
    tires = picture.findall('.//circle[@class="robot-tire"]')
    assert [(float(tire.get('r')), float(tire.get('cy'))) for tire in tires] == [(100 * radius_m, -100 * radius_m)] * 2


def test_a_robot_is_painted_by_its_name_and_patterns_tell_paints_apart():
    paints = {name: track.paint(name) for name in ('Clawbot', 'Second', 'Third')}
    assert paints['Clawbot'] != paints['Second']
    assert track.paint(' Clawbot ') == paints['Clawbot']
    for name, number in paints.items():
        assert f'robot-paint-{number}"' in track.still(robot(Motion((), State('READY', 0.0)), name=name).at(0.0))
    assert len({track.pattern(number, 0, 0, 40, 10) for number in range(8)}) == 8


def test_a_sensor_that_is_believed_elsewhere_is_drawn_there_too():
    right, wrong = (track.still(robot(Motion((), State('READY', 0.0)), Settings(1.0, 0.5, sensor_offset_m=offset))
                                .at(0.0)) for offset in (0.15, 0.4))
    assert ('sensor?' in texts(right), 'sensor?' in texts(wrong)) == (False, True)


def test_a_long_track_has_its_ruler_and_the_robot_its_place():
    long = track.still(robot(Motion((), State('READY', 0.0)), Settings(1.0, 0.5, track_m=14.0)).at(0.0))
    assert [text for text in texts(long) if re.fullmatch(r'\d+ m', text)] == [f'{m} m' for m in range(0, 15, 2)]


def test_a_film_tells_each_phase_when_it_begins():
    motion = plan(0.0, 0.0, FAST)
    facts = robot(motion)
    film = track.film(facts)
    times, states, full_texts, sentences, leans = zip(*film.scenes)
    assert states == ('SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED')
    assert times == pytest.approx((0.0, 2.0, 3.8, 5.8))
    assert leans == pytest.approx((-math.atan(.5 / 9.81), 0.0, math.atan(.5 / 9.81), 0.0), abs=1e-4)
    assert film.picture == track.moving(facts)
    assert film.end == track.still(facts.at(math.inf))
    assert all(sentence in text for sentence, text in zip(sentences, full_texts))


def test_a_replay_tells_its_words_by_itself_and_how_it_ends():
    facts = robot(plan(0.0, 0.0, FAST))
    picture = track.replay(facts)
    # Where nothing may move, it stands where it has stopped.
    assert f'class="robot-mover" style="transform:translateX({facts.x(3.8):.3f}px);animation:' in picture
    assert re.findall(r'step-end">([A-Z ]+)</span>', picture) == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']
    assert 'aria-label="STOPPED. Clawbot has stopped 0.20 m from the wall.' in picture
    assert picture == track.replay(robot(plan(0.0, 0.0, FAST)))
    assert '@keyframes' in track.STYLE and picture.startswith(track.STYLE)


def test_a_poster_is_a_file_of_its_own_and_comes_to_rest():
    poster = track.poster(robot(plan(0.0, 0.0, FAST)), times=3, pause_sec=2.0)
    svg = ElementTree.fromstring(poster)
    assert svg.tag == '{http://www.w3.org/2000/svg}svg'
    assert '7.8000s linear 3 both' in poster
    assert 'infinite' not in poster
    assert 'prefers-reduced-motion' in poster


def test_names_are_text():
    picture = track.still(robot(Motion((), State('READY', 0.0)), name='<b>"', serial_number='<i>').at(0.0))
    assert '<b>" (<i>)' in texts(picture)
