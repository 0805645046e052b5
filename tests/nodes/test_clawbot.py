"""The simulated Clawbot: its motion against the closed form, and what each of its parameters does."""

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from param_tutorial import ParameterClient, wait_until
from param_tutorial.nodes.clawbot_node import EMERGENCY_BRAKE_MPS2, SAFETY_GAP_M, ClawbotNode, Settings, plan

FOREVER = math.inf
ORDINARY = Settings(max_speed_mps=1.0, max_acceleration_mps2=0.5)

accelerations = st.floats(0.01, 2.0)
speeds = st.integers(0, 300).map(lambda rpm: rpm / 60 * 2 * math.pi * 0.1)


# -- the motion, without a node -------------------------------------------------------------------------


def test_a_whole_drive_follows_the_closed_form():
    motion = plan(0.0, 0.0, ORDINARY)
    assert [phase.word for phase in motion.phases] == ['SPEEDING UP', 'CRUISING', 'BRAKING']
    # To 1 m/s with 0.5 m/s²: 2 s and 1 m, the same again for braking, and at 1 m/s over what remains of 3.8 m.
    assert [phase.duration_sec for phase in motion.phases] == pytest.approx([2.0, 1.8, 2.0])
    assert motion.at(3.0).position_m == pytest.approx(2.0)
    assert motion.end.word == 'STOPPED'
    assert motion.end.position_m == pytest.approx(3.8)


@given(speeds, accelerations)
def test_its_braking_distance_is_v_squared_over_2a(speed, acceleration):
    motion = plan(0.0, 0.0, Settings(speed, acceleration))
    braking = [phase for phase in motion.phases if phase.word == 'BRAKING']
    for phase in braking:
        assert phase.velocity_mps <= speed
        assert motion.end.position_m - phase.position_m == pytest.approx(phase.velocity_mps ** 2 / (2 * acceleration))
    assert bool(braking) == (speed > 0)


@given(st.floats(0.0, 3.5), st.floats(0.0, 5.0), speeds, accelerations, st.booleans(), st.floats(-0.3, 0.5))
def test_every_motion_is_continuous(position, velocity, speed, acceleration, safety_on, offset):
    settings_ = Settings(speed, acceleration, safety_on, offset)
    motion = plan(position, velocity, settings_)
    assert motion.at(0.0).position_m == pytest.approx(position)
    for phase, following in zip(motion.phases, motion.phases[1:]):
        last = phase.at(phase.duration_sec)
        assert phase.duration_sec > 0
        assert last.position_m == pytest.approx(following.position_m)
        assert last.velocity_mps == pytest.approx(following.velocity_mps, abs=1e-6)
    if motion.phases:
        last = motion.phases[-1].at(motion.phases[-1].duration_sec)
        assert last.position_m == pytest.approx(motion.end.position_m, abs=1e-6)
        assert last.velocity_mps == pytest.approx(motion.end.crash_speed_mps, abs=1e-5)
    assert position - 1e-9 <= motion.end.position_m <= settings_.track_m + 1e-9
    assert motion.end.velocity_mps == 0


@given(speeds, accelerations, st.lists(st.tuples(st.floats(0.0, 3.0), speeds, accelerations), max_size=8))
@settings(max_examples=300)
def test_with_safety_on_and_the_right_offset_it_keeps_its_gap_whatever_changes(speed, acceleration, changes):
    position = velocity = 0.0
    for seconds, next_speed, next_acceleration in [*changes, (FOREVER, 0.0, 0.0)]:
        motion = plan(position, velocity, Settings(speed, acceleration))
        state = motion.at(seconds)
        position, velocity, speed, acceleration = state.position_m, state.velocity_mps, next_speed, next_acceleration
        assert position <= 4.0 - SAFETY_GAP_M + 1e-5
        assert state.word != 'CRASHED'


def test_with_safety_off_it_runs_into_the_wall_at_full_speed():
    motion = plan(0.0, 0.0, replace(ORDINARY, safety_on=False))
    assert motion.end.word == 'CRASHED'
    assert motion.end.position_m == 4.0
    assert motion.end.crash_speed_mps == pytest.approx(1.0)
    assert motion.duration_sec == pytest.approx(2.0 + 3.0)


@pytest.mark.parametrize(('offset', 'word', 'gap'), [
    (0.15, 'STOPPED', 0.2), (0.05, 'STOPPED', 0.3), (-0.3, 'STOPPED', 0.65), (0.34, 'STOPPED', 0.01),
    (0.40, 'CRASHED', 0.0), (0.50, 'CRASHED', 0.0),
])
def test_a_wrong_sensor_offset_stops_it_too_early_or_too_late(offset, word, gap):
    end = plan(0.0, 0.0, replace(ORDINARY, sensor_offset_m=offset)).end
    assert (end.word, 4.0 - end.position_m) == (word, pytest.approx(gap))


def test_safety_switched_on_late_brakes_as_hard_as_the_tires_can():
    motion = plan(3.7, 1.0, ORDINARY)
    first = motion.phases[0]
    assert first.word == 'EMERGENCY BRAKING'
    assert first.at(first.duration_sec).position_m == pytest.approx(3.7 + 1.0 / (2 * EMERGENCY_BRAKE_MPS2))
    assert motion.end.position_m == pytest.approx(3.8), 'and then creeps up to where it may'
    too_late = plan(3.95, 1.0, ORDINARY)
    assert too_late.end.word == 'CRASHED'
    assert too_late.end.crash_speed_mps == pytest.approx(math.sqrt(1.0 - 2 * EMERGENCY_BRAKE_MPS2 * 0.05))


def test_the_velocity_curve_has_a_corner_where_the_phase_changes():
    motion = plan(0.0, 0.0, ORDINARY)
    corners = motion.velocity_over_time()
    assert [velocity for _, velocity in corners] == pytest.approx([0.0, 1.0, 1.0, 0.0])
    assert [at for at, _ in corners] == pytest.approx([0.0, 2.0, 3.8, 5.8])
    assert motion.velocity_over_time(1.0)[-1] == pytest.approx((1.0, 0.5))


# -- the node, in time that the test lets pass ----------------------------------------------------------


@pytest.fixture
def robot(ros):
    return ros.add(ClawbotNode, real_time=False)


@pytest.fixture
def client(robot):
    return ParameterClient(robot)


def test_it_stands_still_until_it_is_told_to_drive(robot):
    assert robot.step(100.0).word == 'READY'
    robot.drive()
    assert robot.step(FOREVER).word == 'STOPPED'


def test_wheel_radius_and_rpm_give_the_speed(ros):
    robot = ros.add(ClawbotNode, real_time=False, ros_args=['-p', 'simulation.wheel_radius_meters:=0.05'])
    ParameterClient(robot).set_parameter('max_speed_rpm', 60)
    robot.drive()
    assert robot.step(3.0).velocity_mps == pytest.approx(2 * math.pi * 0.05)


def test_a_new_acceleration_takes_effect_at_once(robot, client):
    robot.drive()
    assert robot.step(1.0).velocity_mps == pytest.approx(0.5)
    client.set_parameter('max_acceleration_mps2', 0.1).raise_for_reason()
    assert robot.step(1.0).velocity_mps == pytest.approx(0.5 + 0.1)
    corners = robot.velocity_over_time()
    assert [at for at, _ in corners] == pytest.approx([0.0, 1.0, 1.0, 2.0])
    assert [velocity for _, velocity in corners] == pytest.approx([0.0, 0.5, 0.5, 0.6])


def test_a_lower_speed_slows_it_down_and_zero_makes_it_wait(robot, client):
    robot.drive()
    robot.step(2.0)
    client.set_parameter('max_speed_rpm', 50)
    assert robot.state.word == 'SLOWING DOWN'
    assert robot.step(1.5).velocity_mps == pytest.approx(50 / 60 * 2 * math.pi * 0.1)
    client.set_parameter('max_speed_rpm', 0)
    assert robot.step(FOREVER).word == 'WAITING'
    assert robot.waiting_for() == 'max_speed_rpm is 0'
    client.set_parameter('max_speed_rpm', 50)
    assert robot.step(FOREVER).word == 'STOPPED'


def test_safety_switched_off_during_a_drive_ends_in_the_wall_until_the_next_drive(robot, client, ros):
    robot.drive()
    robot.step(3.0)
    client.set_parameter('enable_safety_mode', False)
    assert robot.step(FOREVER).word == 'CRASHED'
    client.set_parameter('enable_safety_mode', True)
    assert robot.step(FOREVER).word == 'CRASHED'
    assert ros.node_log.read(until='into the wall').endswith('Clawbot has run into the wall at 1.05 m/s')
    robot.drive()
    assert robot.step(FOREVER).word == 'STOPPED'


def test_it_does_not_start_in_the_cold_but_keeps_driving_in_it(robot, client, ros):
    client.set_parameter('min_operating_temperature_c', 16)
    robot.drive()
    assert robot.step(5.0).word == 'WAITING'
    assert ros.node_log.read(until='waiting').endswith('15 °C is below min_operating_temperature_c = 16')
    client.set_parameter('simulation.ambient_temperature_c', 16)
    assert robot.step(1.0).word == 'SPEEDING UP'
    client.set_parameter('simulation.ambient_temperature_c', -40)
    assert robot.step(FOREVER).word == 'STOPPED'


def test_after_a_drive_a_change_counts_for_the_next_one(robot, client):
    robot.drive()
    robot.step(FOREVER)
    client.set_parameters({'sensor_offset_meters': 0.5, 'enable_safety_mode': False})
    assert robot.step(FOREVER).word == 'STOPPED'
    client.set_parameters({'sensor_offset_meters': 0.25, 'enable_safety_mode': True})
    robot.drive()
    assert robot.step(FOREVER).position_m == pytest.approx(4.0 - 0.1)


def test_what_it_rejects(robot, client):
    for name, value, kind in [
            ('robot_name', 'Alpha', 'accepted'), ('robot_name', ' ', 'rejected by the node'),
            ('max_speed_rpm', 0, 'accepted'), ('max_speed_rpm', -1, 'out of range'),
            ('max_speed_rpm', 301, 'out of range'), ('max_acceleration_mps2', 0.0, 'out of range'),
            ('max_acceleration_mps2', 1, 'wrong type'), ('sensor_offset_meters', float('nan'), 'out of range'),
            ('sensor_offset_meters', 0.6, 'out of range'), ('robot_serial_number', 'SN-2', 'read only'),
            ('simulation.track_length_meters', 5.0, 'read only')]:
        before = robot.settings
        assert client.set_parameter(name, value).kind == kind, (name, value)
        if kind != 'accepted':
            assert robot.settings == before


def test_a_rejected_atomic_set_changes_nothing_during_a_drive(robot, client):
    robot.drive()
    robot.step(1.0)
    client.set_parameters_atomically({'max_acceleration_mps2': 2.0, 'robot_name': ''})
    assert robot.step(0.5).velocity_mps == pytest.approx(0.75)


# -- the node, in real time -----------------------------------------------------------------------------


def test_in_real_time_it_arrives_by_itself_and_then_stops_its_timer(ros):
    robot = ros.add(ClawbotNode, ros_args=['-p', 'max_speed_rpm:=300', '-p', 'max_acceleration_mps2:=2.0',
                                           '-p', 'simulation.track_length_meters:=2.0'])
    assert robot.timer.is_canceled()
    robot.drive()
    assert not robot.timer.is_canceled()
    wait_until(lambda: robot.state.word == 'STOPPED', 'the robot to arrive', timeout_sec=60)
    wait_until(robot.timer.is_canceled, 'its timer to be switched off', timeout_sec=30)
    assert 'has stopped 0.20 m from the wall' in ros.node_log.read(until='has stopped', timeout_sec=30)


def test_a_waiting_robot_has_no_timer(ros):
    robot = ros.add(ClawbotNode, ros_args=['-p', 'max_speed_rpm:=0'])
    robot.drive()
    assert robot.state.word == 'WAITING'
    assert robot.timer.is_canceled()


def test_it_reports_each_new_phase_and_nothing_while_it_stands_still(ros):
    robot, told = ros.add(ClawbotNode, real_time=False), []
    stop = robot.on_motion(lambda: told.append(robot.state.word))
    robot.drive()
    robot.step(FOREVER)
    assert told[0] == 'SPEEDING UP'
    assert told[-1] == 'STOPPED'
    told.clear()
    robot.step(100.0)
    assert told == []
    stop()
    robot.drive()
    assert told == []
