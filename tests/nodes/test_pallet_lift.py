"""The pallet lift of chapter 8: how it moves, what it rejects, and the two files that it starts with."""


import hypothesis
import pytest
from hypothesis import strategies as st

from param_tools.cli.launch.reading import load_description
from param_tools.files import parameter_files
from param_tutorial import ParameterClient
from param_tutorial.nodes.pallet_lift_node import MOTOR_POWER_W, LiftSettings, PalletLiftNode
from tests.support.paths import CONFIG, ROS_PACKAGE

FILES = sorted(CONFIG.glob('pallet_lift_*.yaml'))

SETTINGS = st.builds(
    LiftSettings, speed_mps=st.floats(0.05, 0.5), max_load_kg=st.just(100.0), lowest_m=st.floats(0.0, 0.9),
    highest_m=st.floats(1.0, 2.0), kp=st.floats(0.2, 5.0), tolerance_m=st.floats(0.001, 0.05))


@hypothesis.settings(max_examples=25)
@hypothesis.given(SETTINGS, st.floats(0.0, 2.0), st.floats(0.0, 2.0))
def test_a_ride_is_what_small_steps_of_its_law_add_up_to(settings, start_m, target_m):
    corners = settings.ride(start_m, target_m)
    goal_m = min(max(target_m, settings.lowest_m), settings.highest_m)
    height_m, now_sec, step_sec = start_m, 0.0, 1e-3
    for at_sec, expected_m in corners:
        while now_sec < at_sec:
            # kp times what is missing, and never faster than speed_mps, with Heun's steps.
            wanted = settings.kp * (goal_m - height_m)
            first = min(max(wanted, -settings.speed_mps), settings.speed_mps)
            wanted = settings.kp * (goal_m - height_m - first * step_sec)
            second = min(max(wanted, -settings.speed_mps), settings.speed_mps)
            height_m += (first + second) / 2 * step_sec
            now_sec += step_sec
        assert height_m == pytest.approx(expected_m, abs=settings.speed_mps * step_sec + 1e-5)
    assert abs(goal_m - corners[-1][1]) <= max(settings.tolerance_m * (1 + 1e-9), 1e-12)


def test_without_speed_it_stays_where_it_is():
    assert LiftSettings(0.0, 100.0, 0.1, 1.6, 2.0, 0.01).ride(0.1, 1.6) == [(0.0, 0.1)]


@pytest.fixture
def client(ros):
    return ParameterClient(ros.add(PalletLiftNode))


@pytest.mark.parametrize(('asked', 'word'), [
    ({'lift.speed_mps': 0.4}, '1177 W, the motor has 1000'),
    ({'lift.max_load_kg': 600.0}, '600.0 kg at 0.2 m/s'),
    ({'lift.highest_m': 0.1}, 'not below the top'),
    ({'lift.lowest_m': 1.0, 'lift.highest_m': 0.9}, 'not below the top'),
    ({'controller.kp': 0.0}, 'out of range'),
])
def test_values_that_do_not_fit_together_are_rejected_and_change_nothing(ros, client, asked, word):
    node = ros.nodes[0]
    before = client.get_parameters(), node.settings
    result = client.set_parameters_atomically(asked)
    assert not result.successful and word in result[0].reason
    assert (client.get_parameters(), node.settings) == before


def test_values_that_fit_together_take_effect_at_once(ros, client):
    assert client.set_parameters_atomically({'lift.speed_mps': 0.4, 'lift.max_load_kg': 200.0}).successful
    assert (ros.nodes[0].settings.speed_mps, ros.nodes[0].settings.max_load_kg) == (0.4, 200.0)
    assert 'up to 200 kg at 0.4 m/s' in ros.node_log.read(until='0.4 m/s')


def test_the_callback_checks_start_values_too(ros):
    with pytest.raises(ValueError, match=rf'cannot start.*800\.0 kg .* has {MOTOR_POWER_W:.0f}'):
        ros.add(PalletLiftNode, ros_args=['-p', 'lift.max_load_kg:=800.0'])


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
@pytest.mark.parametrize('namespace', ['/', '/hall_3'])
def test_a_file_reaches_the_lift_in_any_namespace_and_sets_each_of_its_values(ros, path, namespace):
    node = ros.add(PalletLiftNode, ros_args=['-r', f'__ns:={namespace}', '--params-file', str(path)])
    present = ParameterClient(node).get_parameters()
    wanted = parameter_files.read(path, node.get_fully_qualified_name())
    assert len(wanted) >= 4
    assert {name: present.get(name) for name in wanted} == wanted


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
def test_a_file_holds_nothing_but_what_differs_from_the_defaults(client, path):
    defaults = client.get_parameters()
    assert [name for name, value in parameter_files.read(path, client.node).items() if value == defaults[name]] == []


def test_the_launch_file_offers_each_of_the_files():
    argument, _ = load_description(ROS_PACKAGE / 'launch' / 'pallet_lift_launch.py').entities
    assert sorted(f'pallet_lift_{choice}' for choice in argument.choices) == [path.stem for path in FILES]
