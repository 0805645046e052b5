"""The PID controller and its simulated wheel, compared with formulas, and what the node does with its parameters."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.node import Node

from param_tools.files import parameter_files
from param_tutorial import ParameterClient
from param_tutorial.exercises.chapters import ch10_3
from param_tutorial.nodes.pid_controller_node import STRATEGIES, Gains, Motor, PidControllerNode, simulate
from tests.support.paths import CONFIG

CONTROLLERS = CONFIG / 'clawbot_controllers.yaml'
MOTOR = Motor()
# Without a lag the wheel is a plant of first order, whose answer to P control has a closed form.
PROMPT = replace(MOTOR, lag_sec=0.0, max_torque=math.inf)


def respond(gains, motor=MOTOR, reference=10.0, *, rate_hz=100, duration_sec=3.0):
    return simulate(gains, motor, reference, rate_hz=rate_hz, duration_sec=duration_sec)


# -- the simulation --------------------------------------------------------------------------------------


@given(st.floats(0.01, 0.3), st.floats(0.01, 0.1), st.floats(0.01, 0.1), st.floats(0.5, 20.0))
def test_p_control_of_a_first_order_plant_matches_the_formula(p, inertia, friction, reference):
    motor = replace(PROMPT, inertia=inertia, friction=friction)
    response = respond(Gains(p=p), motor, reference)
    kept = math.exp(-0.01 * friction / inertia)
    # speed[k + 1] = kept * speed[k] + (1 - kept) * p / friction * (reference - speed[k])
    factor = kept - (1 - kept) * p / friction
    final = reference * p / (p + friction)
    for index, speed in enumerate(response.speeds):
        assert speed == pytest.approx(final * (1 - factor ** index), abs=1e-6)


@pytest.mark.parametrize('lag_sec', [0.01, 0.1, 0.49999, 0.5, 0.50001])
def test_a_lagging_motor_speeds_up_as_the_formula_says(lag_sec):
    motor = replace(MOTOR, lag_sec=lag_sec, max_torque=0.4)
    slow_sec = motor.inertia / motor.friction  # 0.5 s: equal time constants are among the cases
    response = respond(Gains(p=2.0), motor, 1000.0, duration_sec=2.0)
    assert set(response.torques) == {0.4}, 'so far from the reference it never lets go'
    for at, speed in response.points:
        if lag_sec == slow_sec:
            missing = (1 + at / slow_sec) * math.exp(-at / slow_sec)
        else:
            missing = ((slow_sec * math.exp(-at / slow_sec) - lag_sec * math.exp(-at / lag_sec))
                       / (slow_sec - lag_sec))
        assert speed == pytest.approx(10.0 * (1 - missing), abs=1e-6)


def test_the_integral_removes_the_error_and_overshoots_and_d_reduces_that():
    pi, pid = respond(Gains(0.4, 0.4), duration_sec=10).figures, respond(Gains(0.4, 0.4, 0.03), duration_sec=10).figures
    assert pi.steady_state_error == pytest.approx(0.0, abs=1e-4)
    assert pid.steady_state_error == pytest.approx(0.0, abs=1e-3)
    assert pid.overshoot_percent < 5
    assert pi.overshoot_percent > 20


def test_a_clamp_winds_the_integral_up_and_each_strategy_prevents_it():
    gains = Gains(0.2, 0.4, 0.01, 0.6, -0.6)
    overshoot = {}
    for strategy in STRATEGIES:
        response = respond(replace(gains, antiwindup_strategy=strategy))
        assert min(response.torques) >= -0.6 and max(response.torques) == 0.6
        overshoot[strategy] = response.figures.overshoot_percent
    assert overshoot['none'] > 25
    assert max(overshoot['back_calculation'], overshoot['conditional_integration']) < 1


def test_a_motor_limit_that_the_controller_does_not_know_causes_windup_too():
    weak = replace(MOTOR, max_torque=0.6)
    unaware = respond(Gains(0.2, 0.4, antiwindup_strategy='conditional_integration'), weak)
    aware = respond(Gains(0.2, 0.4, 0.0, 0.6, -0.6, 'conditional_integration'), weak)
    assert unaware.figures.overshoot_percent > 20
    assert aware.figures.overshoot_percent < 1
    assert max(unaware.torques) == max(aware.torques) == 0.6


@pytest.mark.parametrize(('gains', 'seconds'), [
    (Gains(0.2, 0.4, 0.01), 0.15811388), (Gains(0.2, 0.4), 0.5), (Gains(0.2), math.inf), (Gains(0.0, 0.4), math.inf),
    (Gains(0.2, 0.4, tracking_time_constant=0.3), 0.3)])
def test_the_tracking_time_constant_is_chosen_as_in_control_toolbox(gains, seconds):
    assert gains.tracking_sec == pytest.approx(seconds)


# -- the figures -----------------------------------------------------------------------------------------


def test_the_figures_of_an_exponential_are_those_of_the_textbook():
    # Without a controller: 0.4 N m make 10 rad/s in the end, with a time constant of 0.5 s.
    response = respond(Gains(p=2.0, u_clamp_max=0.4), PROMPT, 1000.0, rate_hz=1000, duration_sec=10.0)
    figures = replace(response, reference=10.0).figures
    assert figures.rise_sec == pytest.approx(0.5 * math.log(9), abs=1e-3)
    assert figures.settling_sec == pytest.approx(0.5 * math.log(50), abs=1e-3)
    assert figures.overshoot_percent == 0.0
    assert figures.steady_state_error == pytest.approx(0.0, abs=1e-6)
    assert str(figures) == ('rise time 1.10 s, overshoot 0.0 %, settling time 1.96 s, '
                            'steady-state error 0.00 rad/s')


@pytest.mark.parametrize(('gains', 'end'), [(Gains(0.1, 1.2), '12.74'), (Gains(), '0.00')])
def test_a_wheel_that_swings_or_stands_still_has_no_figures(gains, end):
    figures = respond(gains).figures
    assert (figures.settling_sec, figures.rise_sec, figures.overshoot_percent) == (None, None, None)
    assert str(figures) == f'no steady speed, {end} rad/s at the end'


# -- the node --------------------------------------------------------------------------------------------

KP, KI, KD = (f'gains.wheel_joint.{name}' for name in 'pid')
MAX, MIN = 'gains.wheel_joint.u_clamp_max', 'gains.wheel_joint.u_clamp_min'


@pytest.fixture
def controller(ros):
    return ros.add(PidControllerNode)


@pytest.fixture
def client(controller):
    return ParameterClient(controller)


def test_what_it_rejects(controller, client):
    for name, value, kind in [
            (KP, 0.0, 'accepted'), (KP, 2.0, 'accepted'), (KP, -0.1, 'out of range'), (KP, math.nan, 'out of range'),
            (KP, math.inf, 'out of range'), (KP, 1, 'wrong type'), (KI, -0.1, 'out of range'),
            (KD, math.nan, 'out of range'), (MAX, 0.5, 'accepted'), (MAX, math.nan, 'rejected by the node'),
            (MIN, math.nan, 'rejected by the node'), (MAX, -math.inf, 'rejected by the node'),
            (MIN, math.inf, 'rejected by the node'),
            ('gains.wheel_joint.antiwindup_strategy', 'back_calculation', 'accepted'),
            ('gains.wheel_joint.antiwindup_strategy', 'legacy', 'rejected by the node'),
            ('gains.wheel_joint.tracking_time_constant', -1.0, 'out of range'),
            ('dof_names', ['other_joint'], 'read only'), ('command_interface', 'velocity', 'read only'),
            ('reference_and_state_interfaces', ['position'], 'read only'), ('update_rate', 50, 'read only'),
            ('simulation.inertia_kgm2', 0.0, 'out of range'), ('simulation.lag_sec', 0.0, 'accepted')]:
        before = controller.response()
        assert client.set_parameter(name, value).kind == kind, (name, value)
        if kind != 'accepted':
            assert controller.response() is before


def test_clamps_that_cross_are_rejected_with_both_named(client):
    client.set_parameters_atomically({MAX: 1.0, MIN: -1.0}).raise_for_reason()
    result = client.set_parameter(MIN, 1.0)
    assert result.reason == 'gains.wheel_joint.u_clamp_min = 1.0 must be less than u_clamp_max = 1.0'
    # One by one the way leads over a pair that crosses; together it does not.
    assert not client.set_parameters({MIN: 2.0, MAX: 3.0}).successful
    client.set_parameters_atomically({MAX: 1.0, MIN: -1.0}).raise_for_reason()
    assert client.set_parameters_atomically({MIN: 2.0, MAX: 3.0}).successful


def test_gains_are_used_once_they_are_stored_and_logged_once(controller, client, ros):
    ros.node_log.read(until='p = 0.1')
    client.set_parameters_atomically({KP: 0.3, KI: -1.0})
    client.set_parameters_atomically({KP: 0.4, KI: 0.4, KD: 0.03}).raise_for_reason()
    assert controller.response() == respond(Gains(0.4, 0.4, 0.03))
    client.set_parameters({KP: 0.4, 'use_sim_time': False})
    client.set_parameter(KP, 0.5)
    told = [line.partition(': ')[2] for line in ros.node_log.read(until='p = 0.5').splitlines()]
    assert [line.partition(':')[0] for line in told] == [
        'wheel_joint with p = 0.4, i = 0.4, d = 0.03', 'wheel_joint with p = 0.5, i = 0.4, d = 0.03']
    assert told[0].endswith(str(respond(Gains(0.4, 0.4, 0.03)).figures))


def test_the_wheel_itself_can_be_changed(controller, client):
    client.set_parameters({'simulation.inertia_kgm2': 0.05, 'simulation.reference_rad_per_sec': 5.0,
                           'simulation.duration_sec': 1.0}).raise_for_reason()
    assert controller.response() == respond(Gains(0.1), replace(MOTOR, inertia=0.05), 5.0, duration_sec=1.0)


@pytest.mark.parametrize(('joints', 'error'), [
    ('[]', InvalidParameterValueException), ('[a, a]', InvalidParameterValueException),
    ('wheel_joint', InvalidParameterTypeException)])
def test_it_does_not_start_without_a_list_of_different_joints(ros, tmp_path, joints, error):
    file = tmp_path / 'joints.yaml'
    file.write_text(f'/**: {{ros__parameters: {{dof_names: {joints}}}}}')
    with pytest.raises(error, match='dof_names'):
        ros.add(PidControllerNode, ros_args=['--params-file', str(file)])


@pytest.mark.parametrize(('override', 'word'), [
    (f'{KP}:=.nan', 'out of range'), (f'{KP}:=-1.0', 'out of range'), (f'{MAX}:=-.inf', 'must be less than'),
    ('gains.wheel_joint.antiwindup_strategy:=magic', 'must be one of')])
def test_what_it_would_reject_later_it_rejects_at_the_start(ros, override, word):
    with pytest.raises(InvalidParameterValueException, match=word):
        ros.add(PidControllerNode, ros_args=['-p', override])


def test_each_joint_has_its_own_gains(ros):
    robot = ros.add(PidControllerNode, ros_args=['-p', 'dof_names:=[left, right]', '-p', 'gains.right.p:=0.4'])
    assert robot.response() == robot.response('left') == respond(Gains(0.1))
    assert robot.response('right') == respond(Gains(0.4))


def test_every_parameter_outside_the_simulation_exists_in_the_real_controller(controller, client):
    names = {name for name in client.list_parameters() if not name.startswith('simulation.')}
    of_every_node = {'use_sim_time', 'start_type_description_service'}
    assert names - of_every_node <= {
        *ch10_3.OF_THE_CONTROLLER, *(f'gains.wheel_joint.{each}' for each in ch10_3.OF_A_JOINT)}
    assert set(ch10_3.REQUIRED) <= names


# -- the files -------------------------------------------------------------------------------------------


def start(ros, name, path):
    return ros.add(PidControllerNode, ros_args=['-r', f'__node:={name}', '--params-file', str(path)])


def test_the_installed_file_starts_the_manager_and_each_controller_that_it_lists(ros):
    manager = ros.add(Node, 'controller_manager', automatically_declare_parameters_from_overrides=True,
                      ros_args=['--params-file', str(CONTROLLERS)])
    parameters = ParameterClient(manager).get_parameters()
    assert parameters['update_rate'] == 100
    names = [name.removesuffix('.type') for name in parameters if name.endswith('.type')]
    assert names == ['wheel_controller', 'claw_controller']
    for name in names:
        controller = start(ros, name, CONTROLLERS)
        held = parameter_files.read(CONTROLLERS, f'/{name}')
        assert held.items() <= ParameterClient(controller).get_parameters().items(), 'and nothing is misspelt'
        assert f'gains.{controller.joints[0]}.p' in held
