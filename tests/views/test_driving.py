"""The cart: its picture moves as physics says, and its view as the node does; views beside each other."""

import math
import re
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rclpy.node import Node

from param_tutorial import ParameterClient, ParameterPanel
from param_tutorial.nodes.base_node import BaseNode
from param_tutorial.nodes.cart_node import CartNode
from param_tutorial.nodes.clawbot_node import Settings, plan
from param_tutorial.views import CartView, SideBySide, TrackView
from param_tutorial.views import cart as cart_module
from param_tutorial.views.cart import cart_on_trip
from param_tutorial.views.drawing import driving
from tests.views.conftest import shows


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


def test_the_bar_before_the_cart_is_the_way_in_which_it_would_stop():
    """At each speed; where it brakes for the end of the aisle, the bar ends there all the time."""
    cart = cart_on_trip('/cart', 1.0, 0.5)
    for elapsed_sec in (0.0, 1.0, 3.0, 9.0, 11.0, 11.9):
        moment = cart.at(elapsed_sec)
        stretched = float(re.search(r'scaleX\(([\d.]+)\)', driving.still(moment))[1])
        way_m = stretched * 100 / cart.units_per_m
        assert way_m == pytest.approx(moment.state.velocity_mps ** 2 / (2 * 0.5), abs=1e-3)
        if moment.state.word == 'BRAKING':
            assert moment.state.position_m + cart.stopping_m(moment.state) == pytest.approx(cart.settings.stop_m)


# -- the view of the cart ------------------------------------------------------------------------------------

@pytest.fixture
def clock(monkeypatch):
    """Let time pass for the view only when a test says so: ``clock[0] += 3``."""
    now = [100.0]
    monkeypatch.setattr(cart_module, 'time', SimpleNamespace(monotonic=lambda: now[0]))
    return now


def test_a_change_on_the_way_counts_from_there_and_one_after_the_arrival_moves_nothing(ros, clock):
    ros.add(CartNode)
    view, client = CartView('/cart_node'), ParameterClient('/cart_node')
    shows(view, 'READY. cart_node stands at the beginning of the aisle. Speed 0.00 m/s, 0.0 s on its way, 1 m/s, 0.5')
    view.drive()
    clock[0] += 5  # 1 m in 2 s, and 3 m at 1 m/s: 8 m to go
    client.set_parameters_atomically({'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0})
    view.settle()
    assert view.text.startswith('SPEEDING UP. cart_node is speeding up with 1.00 m/s², up to 2.00 m/s.')
    assert 'Speed 1.00 m/s, 5.0 s on its way' in view.text
    clock[0] += 60
    view._follow()
    # 1 s and 1.5 m up to 2 m/s, 2 s and 2 m to stop, and 4.5 m between: 5.25 s more.
    assert view.text.startswith('STOPPED. cart_node has reached the end of the aisle after 10.25 s.')
    client.set_parameter('max_speed_mps', 0.5)
    view.settle()
    assert view.text.startswith('STOPPED') and '@keyframes' not in view._front.picture


def test_it_shows_a_cart_that_is_being_built_and_says_what_is_missing(ros):
    class Unfinished(Node):
        def __init__(self):
            super().__init__('my_cart')
            self.declare_parameter('max_speed_mps', 1.0)
            self.declare_parameter('max_acceleration_mps2', -1.0)

    view = CartView('/my_cart')
    ros.add(Node, 'my_cart')
    shows(view, '/my_cart cannot drive: max_speed_mps is not there.')
    ros.add(Unfinished)
    shows(view, '/my_cart cannot drive: max_acceleration_mps2 is -1.0.')
    view.drive()
    assert view._front.scene == []  # so its button is disabled
    ParameterClient('/my_cart').set_parameter('max_acceleration_mps2', 0.5)
    shows(view, 'READY')


# -- beside a panel -------------------------------------------------------------------------------------------

def test_closing_it_leaves_its_views_and_a_view_that_is_closed_leaves_it_before(ros):
    base = ros.add(BaseNode)
    view, panel = TrackView(base), ParameterPanel(base)
    first, second = SideBySide(view, panel), SideBySide(view, panel)
    assert repr(first) == '<SideBySide: TrackView of /base and ParameterPanel of /base>'
    first.close()
    first.close()
    assert first.comm is None and first._box.children == () and view.comm is not None
    assert second._box.children == (view, panel)
    open_then = []
    second._box.observe(lambda change: open_then.append(view.comm is not None), 'children')
    view.close()
    assert second._box.children == (panel,) and open_then == [True]
    second.close()
    assert len(panel._on_close) == 0
