"""The cart of chapter 11 moves as its formula says, and keeps its rule at every request."""

import itertools

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from rclpy.exceptions import InvalidParameterValueException

from param_tutorial import ParameterClient
from param_tutorial.nodes.cart_node import AISLE_M, SIGHT_M, CartNode


@pytest.fixture
def cart(ros):
    return ros.add(CartNode)


@pytest.fixture
def client(cart):
    return ParameterClient(cart)


@pytest.mark.parametrize(('speed', 'acceleration'), [(1.0, 0.5), (2.0, 1.0), (0.1, 2.0), (1.6, 0.64)])
def test_the_curve_covers_the_aisle_and_ends_with_the_trip(cart, client, speed, acceleration):
    client.set_parameters_atomically({'max_speed_mps': speed, 'max_acceleration_mps2': acceleration}).raise_for_reason()
    curve = cart.velocity_over_time()
    assert curve[-1] == (cart.trip_sec, 0.0)
    pairs = list(itertools.pairwise(curve))
    assert sum((v0 + v1) / 2 * (t1 - t0) for (t0, v0), (t1, v1) in pairs) == pytest.approx(AISLE_M)
    assert (curve[1][1] - curve[0][1]) / curve[1][0] == pytest.approx(acceleration)
    assert max(velocity for _, velocity in curve) == speed


LIMITED = st.floats(0.1, 2.0)


@given(speed=LIMITED, acceleration=LIMITED)
def test_it_rejects_settings_with_which_it_could_not_stop_in_time(speed, acceleration):
    # It comes to rest after the time speed / acceleration, at half its speed on average.
    stopping_m = speed / acceleration * speed / 2
    assume(abs(stopping_m - SIGHT_M) > 1e-6)
    assert bool(CartNode.objection(speed, acceleration)) == (stopping_m > SIGHT_M)


def test_a_request_is_judged_as_a_whole_and_a_rejected_one_leaves_no_trace(cart, client):
    pair = {'max_speed_mps': 2.0, 'max_acceleration_mps2': 1.0}
    assert [result.kind for result in client.set_parameters(pair)] == ['rejected by the node', 'accepted']
    assert cart.trip_sec == 12 / 1.0 + 1.0 / 1.0
    assert client.set_parameters_atomically(pair).successful
    assert not client.set_parameter('max_acceleration_mps2', 0.9).successful
    assert cart.trip_sec == 8.0


def test_it_does_not_start_with_values_that_it_would_reject(ros):
    with pytest.raises(InvalidParameterValueException, match=r'it needs 4.00 m to stop'):
        ros.add(CartNode, ros_args=['-p', 'max_speed_mps:=2.0'])
    assert ros.add(CartNode, ros_args=['-p', 'max_speed_mps:=2.0', '-p', 'max_acceleration_mps2:=1.0']).trip_sec == 8.0
