"""The cart: its boxes lean as physics says, and it drives as the parameters say, also those that change on the way."""

import math
import re
from types import SimpleNamespace

import pytest
from rclpy.node import Node

from param_tutorial import ParameterClient
from param_tutorial.nodes.cart_node import AISLE_M, CartNode
from param_tutorial.nodes.clawbot_node import SAFETY_GAP_M, Settings, State, plan
from param_tutorial.views import CartView
from param_tutorial.views import cart as cart_module
from param_tutorial.views.drawing import driving
from param_tutorial.views.drawing.cart import Cart
from tests.views.conftest import shows


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


def test_boxes_lean_back_while_it_speeds_up_and_forward_while_it_brakes():
    steps = re.search(r'@keyframes robot-\w+-cargo \{(.*?)\}\}', driving.replay(cart(2.0, 1.0)))[1]
    angles = [float(each) for each in re.findall(r'rotate\((-?[\d.]+)rad\)', steps)]
    lean = math.atan(1.0 / 9.81)
    assert angles == pytest.approx([-lean, 0.0, lean, 0.0], abs=1e-4)
    assert steps.count('step-end') == 3
    # Of a picture that is told, the scenes say it.
    assert [cart(2.0, 1.0).at(second).scene.lean_rad for second in (0, 3, 7, 9)] == pytest.approx(angles, abs=1e-4)


# -- the view ------------------------------------------------------------------------------------------------

@pytest.fixture
def clock(monkeypatch):
    """Let time pass for the view only when a test says so: ``clock[0] += 3``."""
    now = [100.0]
    monkeypatch.setattr(cart_module, 'time', SimpleNamespace(monotonic=lambda: now[0]))
    return now


@pytest.fixture
def view(ros):
    ros.add(CartNode)
    return CartView('/cart_node')


def test_it_stands_then_drives_as_the_node_calculates_and_arrives(view, clock):
    shows(view, 'READY. cart_node stands at the beginning of the aisle. Speed 0.00 m/s, 0.0 s on its way, 1 m/s, 0.5')
    view.drive()
    assert view.text.startswith('SPEEDING UP. cart_node is speeding up with 0.50 m/s², up to 1.00 m/s.')
    clock[0] += 5
    view._follow()
    assert view.text.startswith('CRUISING') and 'Speed 1.00 m/s, 5.0 s on its way' in view.text
    clock[0] += 9.1
    view._follow()
    assert view.text.startswith('STOPPED. cart_node has reached the end of the aisle after 14.00 s.')
    assert '@keyframes' not in view._front.picture


def test_a_change_on_the_way_counts_from_there(view, clock):
    view.drive()
    clock[0] += 5  # 1 m in 2 s, and 3 m at 1 m/s: 8 m to go
    ParameterClient('/cart_node').set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0})
    view.settle()
    assert view.text.startswith('SPEEDING UP. cart_node is speeding up with 1.00 m/s², up to 2.00 m/s.')
    assert 'Speed 1.00 m/s, 5.0 s on its way' in view.text
    clock[0] += 60
    view._follow()
    # 1 s and 1.5 m up to 2 m/s, 2 s and 2 m to stop, and 4.5 m between: 5.25 s more.
    assert 'after 10.25 s' in view.text


def test_a_change_after_the_arrival_moves_nothing(view, clock):
    view.drive()
    clock[0] += 60
    ParameterClient('/cart_node').set_parameter('max_speed_mps', 0.5)
    view.settle()
    assert view.text.startswith('STOPPED')


@pytest.mark.slow
def test_it_shows_a_cart_that_is_being_built_and_says_what_is_missing(ros):
    class Unfinished(Node):
        def __init__(self):
            super().__init__('my_cart')
            self.declare_parameter('max_speed_mps', 1.0)
            self.declare_parameter('max_acceleration_mps2', -1.0)

    view = CartView('/my_cart')
    assert '/my_cart' in view.text
    ros.add(Node, 'my_cart')
    shows(view, '/my_cart cannot drive: max_speed_mps is not there.')
    ros.add(Unfinished)
    shows(view, '/my_cart cannot drive: max_acceleration_mps2 is -1.0.')
    view.drive()
    assert view._front.scene == []  # so its button is disabled
    ParameterClient('/my_cart').set_parameter('max_acceleration_mps2', 0.5)
    shows(view, 'READY')
    view.close()
    assert repr(view) == '<CartView: /my_cart, closed>'
