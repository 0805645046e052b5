"""The cart's view: it drives as the parameters say, also those that change on the way, and lets go of its node."""

from types import SimpleNamespace

import pytest
from rclpy.node import Node

from param_tutorial import CartView, ParameterClient, wait_until
from param_tutorial.nodes.cart_node import CartNode
from param_tutorial.widgets import cart as cart_module


@pytest.fixture
def clock(monkeypatch):
    """Let time pass for the view only when a test says so: ``clock[0] += 3``."""
    now = [100.0]
    monkeypatch.setattr(cart_module, 'time', SimpleNamespace(monotonic=lambda: now[0]))
    return now


@pytest.fixture
def view(ros):
    ros.add(CartNode)
    view = CartView('/cart_node')
    yield view
    view.close()


def shows(view, text):
    wait_until(lambda: text in view.text, f'the view to say {text}; it says {view.text!r}')


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


def test_one_picture_for_the_drive_and_words_for_each_thing_that_it_begins_to_do(view, clock):
    pictures, words = [], []
    view._front.observe(lambda change: pictures.append(change.new), 'picture')
    view._front.observe(lambda change: words.append(change.new[1]), 'scene')
    view.drive()
    for _ in range(30):
        clock[0] += 0.5
        view._follow()
    assert words == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']
    assert ['@keyframes' in each for each in pictures] == [True, False]


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


def test_it_is_recorded_with_its_drive(view):
    view.drive()
    view.rest()
    assert view.snapshot()['look']['scene'][2].startswith('READY')
    film = view.film()
    assert [word for _, word, *_ in film['scenes']] == ['SPEEDING UP', 'CRUISING', 'BRAKING', 'STOPPED']
    assert 'robot-NAME' in film['picture']
