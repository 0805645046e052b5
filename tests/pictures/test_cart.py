"""The cart's picture, without a node: it drives as the node calculates, and the boxes lean as physics says."""

import math
import re

import pytest

from param_tutorial.nodes.cart_node import AISLE_M
from param_tutorial.nodes.clawbot_node import SAFETY_GAP_M, Motion, Settings, State, plan
from param_tutorial.pictures import track
from param_tutorial.pictures.cart import Cart


def cart(speed, acceleration, **others):
    settings = Settings(speed, acceleration, track_m=AISLE_M + SAFETY_GAP_M)
    facts = {'name': 'cart_node', 'node': '/cart_node', 'sight_m': 2.0, 'motion': plan(0.0, 0.0, settings), **others}
    return Cart(settings=settings, **facts)


@pytest.mark.parametrize(('speed', 'acceleration', 'seconds'), [(1.0, 0.5, 14.0), (1.4, 0.98, 10.0), (2.0, 1.0, 8.0)])
def test_a_trip_takes_as_long_as_the_node_says(speed, acceleration, seconds):
    facts = cart(speed, acceleration)
    assert [phase.word for phase in facts.motion.phases] == ['SPEEDING UP', 'CRUISING', 'BRAKING']
    assert facts.motion.duration_sec == pytest.approx(seconds, abs=1e-9)
    assert facts.motion.end == State('STOPPED', pytest.approx(12.0))
    assert facts.at(math.inf).sentence == f'cart_node has reached the end of the aisle after {seconds:.2f} s.'
    assert facts.at(math.inf).numbers == f'speed 0.00 m/s, {seconds:.1f} s on its way'


def test_the_time_goes_on_after_a_change_on_the_way():
    late = cart(1.0, 0.5, before_sec=3.0)
    assert late.at(1.0).numbers == 'speed 0.50 m/s, 4.0 s on its way'
    assert late.at(math.inf).sentence.endswith('after 17.00 s.')


def test_boxes_lean_back_while_it_speeds_up_and_forward_while_it_brakes():
    steps = re.search(r'@keyframes robot-\w+-cargo \{(.*?)\}\}', track.replay(cart(2.0, 1.0)))[1]
    angles = [float(each) for each in re.findall(r'rotate\((-?[\d.]+)rad\)', steps)]
    lean = math.atan(1.0 / 9.81)
    assert angles == pytest.approx([-lean, 0.0, lean, 0.0], abs=1e-4)
    assert steps.count('step-end') == 3
    # Of a film, the scenes tell it.
    assert [scene.lean_rad for scene in track.film(cart(2.0, 1.0)).scenes] == pytest.approx(angles, abs=1e-4)


def test_each_state_has_its_sentence():
    facts = cart(1.0, 0.5, motion=Motion((), State('READY', 0.0)))
    for word in ('READY', 'SPEEDING UP', 'CRUISING', 'SLOWING DOWN', 'BRAKING', 'EMERGENCY BRAKING', 'WAITING',
                 'STOPPED'):
        assert track.Moment(facts, State(word, 1.0)).sentence.startswith('cart_node ')
    with pytest.raises(AssertionError, match='no words for FLYING'):
        _ = track.Moment(facts, State('FLYING', 0.0)).sentence
