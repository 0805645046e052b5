"""A simulated robot on a straight track, and every parameter of it means something.

It pulls away from the start, drives toward a wall, and with its safety mode on it stops in front of it. Run it
alone with ``ros2 run param_tutorial clawbot_node`` and change its parameters while it drives.

The motion is not computed step by step. ``plan`` cuts it into phases of constant acceleration, and each phase has a
closed form, so it does not matter when, how often or how late anybody looks. A position is that of the robot's
front, in meters from the start line; the robot's center is half its length behind. SI units throughout.
"""

import math
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter

ROBOT_LENGTH_M = 0.6
# Where the range sensor really sits, before the center. What the robot believes is sensor_offset_meters.
SENSOR_MOUNT_M = 0.15
# How far from the wall the safety mode wants to stop.
SAFETY_GAP_M = 0.2
# What the tires can do at most. The safety mode uses it when max_acceleration_mps2 would stop the robot too late.
EMERGENCY_BRAKE_MPS2 = 6.0
# Nearer than this counts as being there, in space and in time.
_TOLERANCE_M = 1e-6
_TOLERANCE_SEC = 1e-9


@dataclass(frozen=True)
class Settings:
    """What the motion depends on: the robot's parameters, in SI units."""

    max_speed_mps: float
    max_acceleration_mps2: float
    safety_on: bool = True
    sensor_offset_m: float = SENSOR_MOUNT_M
    may_start: bool = True
    """True if it is warm enough to pull away; a robot that is moving already goes on."""
    track_m: float = 4.0
    """From the start line to the wall."""

    @property
    def stop_m(self) -> float:
        """Where the safety mode stops the robot's front; beyond the wall if the offset is that wrong."""
        return self.track_m - SAFETY_GAP_M + (self.sensor_offset_m - SENSOR_MOUNT_M)


@dataclass(frozen=True)
class State:
    """The robot at one moment."""

    word: str
    """What it is doing: READY, SPEEDING UP, CRUISING, SLOWING DOWN, BRAKING, EMERGENCY BRAKING, WAITING, STOPPED
    or CRASHED."""
    position_m: float
    velocity_mps: float = 0.0
    acceleration_mps2: float = 0.0
    crash_speed_mps: float = 0.0
    """How fast it hit the wall, if it did."""


@dataclass(frozen=True)
class Phase:
    """A stretch of constant acceleration."""

    word: str
    duration_sec: float
    position_m: float
    velocity_mps: float
    acceleration_mps2: float

    def at(self, elapsed_sec: float) -> State:
        """Return the state so many seconds after the phase began."""
        velocity = self.velocity_mps + self.acceleration_mps2 * elapsed_sec
        position = self.position_m + (self.velocity_mps + velocity) / 2 * elapsed_sec
        return State(self.word, position, max(0.0, velocity), self.acceleration_mps2)


@dataclass(frozen=True)
class Motion:
    """All that the robot is going to do, as long as nobody changes anything."""

    phases: tuple[Phase, ...]
    end: State
    """The robot at rest, after the last phase."""

    @property
    def duration_sec(self) -> float:
        """How long it takes until the robot is at rest."""
        return sum(phase.duration_sec for phase in self.phases)

    def at(self, elapsed_sec: float) -> State:
        """Return the state so many seconds after the motion began."""
        for phase in self.phases:
            if elapsed_sec < phase.duration_sec - _TOLERANCE_SEC:
                return phase.at(elapsed_sec)
            elapsed_sec -= phase.duration_sec
        return self.end

    def velocity_over_time(self, until_sec: float = math.inf) -> list[tuple[float, float]]:
        """Return the corners of the velocity's curve, in s and m/s; between them it is straight."""
        corners, start_sec = [], 0.0
        for phase in self.phases:
            elapsed_sec = min(phase.duration_sec, until_sec - start_sec)
            if elapsed_sec <= 0:
                break
            corners += [(start_sec, phase.velocity_mps), (start_sec + elapsed_sec, phase.at(elapsed_sec).velocity_mps)]
            start_sec += elapsed_sec
        if self.end.word == 'CRASHED' and start_sec < until_sec:
            corners.append((start_sec, 0.0))
        return list(dict.fromkeys(corners))


def plan(position_m: float, velocity_mps: float, settings: Settings) -> Motion:
    """Work out how the robot moves from here until it is at rest.

    It drives as fast as the settings allow: toward the place where the safety mode stops it, or into the wall.

    :param position_m: Where the robot's front is, from the start line.
    :param velocity_mps: How fast it is, never negative.
    """
    acceleration, top = settings.max_acceleration_mps2, settings.max_speed_mps
    phases: list[Phase] = []
    position, velocity = position_m, velocity_mps

    def change_speed(word: str, to_velocity: float, rate: float) -> None:
        nonlocal position, velocity
        if to_velocity == velocity:
            return
        duration = abs(to_velocity - velocity) / rate
        phases.append(Phase(word, duration, position, velocity, math.copysign(rate, to_velocity - velocity)))
        position += (velocity + to_velocity) / 2 * duration
        velocity = to_velocity

    def cruise(distance: float) -> None:
        nonlocal position
        if distance > 0:
            phases.append(Phase('CRUISING', distance / velocity, position, velocity, 0.0))
            position += distance

    def braking_distance() -> float:
        return velocity ** 2 / (2 * acceleration)

    goal = settings.stop_m if settings.safety_on else settings.track_m
    if settings.safety_on and braking_distance() > goal - position + _TOLERANCE_M:
        change_speed('EMERGENCY BRAKING', 0.0, EMERGENCY_BRAKE_MPS2)
    arrived = velocity == 0 and goal - position <= _TOLERANCE_M
    if not arrived and (velocity > 0 or (settings.may_start and top > 0)):
        if velocity > top:
            change_speed('SLOWING DOWN', top, acceleration)
        elif settings.safety_on:
            # Speeding up over one part of the way and braking over the rest gives this speed where they meet.
            highest = math.sqrt(acceleration * max(0.0, goal - position) + velocity ** 2 / 2)
            change_speed('SPEEDING UP', max(velocity, min(top, highest)), acceleration)
        else:
            change_speed('SPEEDING UP', top, acceleration)
        if velocity > 0:
            cruise(goal - position - (braking_distance() if settings.safety_on else 0.0))
            if settings.safety_on:
                change_speed('BRAKING', 0.0, acceleration)
        arrived = velocity > 0 or goal - position <= _TOLERANCE_M
    return _up_to_the_wall(phases, State('STOPPED' if arrived else 'WAITING', position), settings.track_m)


def _up_to_the_wall(phases: list[Phase], end: State, wall_m: float) -> Motion:
    """Cut the phases off where the robot's front reaches the wall, if it does."""
    for index, phase in enumerate(phases):
        distance = wall_m - phase.position_m
        squared = phase.velocity_mps ** 2 + 2 * phase.acceleration_mps2 * distance
        if squared <= 0:  # it comes to rest before
            continue
        speed = math.sqrt(squared)
        duration = 2 * distance / (phase.velocity_mps + speed)
        if duration <= phase.duration_sec:
            crash = State('CRASHED', wall_m, crash_speed_mps=speed)
            return Motion((*phases[:index], replace(phase, duration_sec=duration)), crash)
    return Motion(tuple(phases), end)


class ClawbotNode(Node):
    """The robot Clawbot on its track. It stands at the start until ``drive`` is called."""

    def __init__(self, *, real_time: bool = True):
        """
        :param real_time: Let time pass by itself; without it only ``step`` lets it pass, which tests and lessons
            need in order to be repeatable.
        """
        super().__init__('clawbot_node')
        self._real_time = real_time
        self._stepped_sec = 0.0
        self._listeners: list[Callable[[], object]] = []
        # The parameters' callbacks come in the executor's thread, drive() and step() perhaps in another.
        self._lock = threading.RLock()
        self._declare_robot()
        self._declare_world()

        self.settings = self._read_settings()
        self._motion = Motion((), State('READY', 0.0))
        self._motion_start_sec = self._drive_start_sec = self._now_sec()
        self._announced = self._motion.end.word
        self._driven: deque[tuple[float, float]] = deque(maxlen=1000)
        # It is armed for the moment when the next phase begins, so a robot that stands costs nothing.
        self.timer = self.create_timer(1.0, self._look, autostart=False)
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)
        self.get_logger().info('ClawbotNode has been started.')

    # -- parameters -------------------------------------------------------------------------------------

    def _declare_robot(self) -> None:
        self.declare_parameter(
            'robot_name', 'Clawbot', ParameterDescriptor(description='Name of the robot. Must not be empty.'))
        self.declare_parameter(
            'max_speed_rpm', 100,
            ParameterDescriptor(description='Maximum wheel speed in rpm.', integer_range=[
                IntegerRange(from_value=0, to_value=300, step=1)]))
        self.declare_parameter(
            'enable_safety_mode', True,
            ParameterDescriptor(description='Stop in front of the wall.'))
        self.declare_parameter(
            'sensor_offset_meters', SENSOR_MOUNT_M,
            ParameterDescriptor(
                description='How far the range sensor sits before the center of the robot, in m.',
                floating_point_range=[FloatingPointRange(from_value=-0.3, to_value=0.5)]))
        self.declare_parameter(
            'max_acceleration_mps2', 0.5,
            ParameterDescriptor(description='Maximum acceleration in m/s², also for braking.', floating_point_range=[
                FloatingPointRange(from_value=0.01, to_value=2.0)]))
        self.declare_parameter(
            'min_operating_temperature_c', -5,
            ParameterDescriptor(
                description='Minimum operating temperature in degrees Celsius. The robot does not start below.',
                integer_range=[IntegerRange(from_value=-20, to_value=50, step=1)]))
        self.declare_parameter(
            'robot_serial_number', 'SN-CLAW-001',
            ParameterDescriptor(description='Serial number of the robot.', read_only=True))

    def _declare_world(self) -> None:
        """Declare what is around the robot, for the simulation."""
        self.declare_parameter(
            'simulation.ambient_temperature_c', 15,
            ParameterDescriptor(description='How warm it is, in degrees Celsius.', integer_range=[
                IntegerRange(from_value=-40, to_value=60, step=1)]))
        self.declare_parameter(
            'simulation.track_length_meters', 4.0,
            ParameterDescriptor(
                description='From the start line to the wall, in m.', read_only=True,
                floating_point_range=[FloatingPointRange(from_value=2.0, to_value=20.0)]))
        self.declare_parameter(
            'simulation.wheel_radius_meters', 0.1,
            ParameterDescriptor(
                description='Radius of the wheels in m.', read_only=True,
                floating_point_range=[FloatingPointRange(from_value=0.05, to_value=0.12)]))

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Return whether all the proposed parameters may be stored; change nothing. The ranges do the rest."""
        for parameter in parameters:
            if parameter.name == 'robot_name' and not parameter.value.strip():
                return SetParametersResult(successful=False, reason='robot_name must not be empty')
        return SetParametersResult(successful=True)

    def react(self, _: list[Parameter]) -> None:
        """Act on parameters that have been stored: go on from here under the new settings."""
        with self._lock:
            settings = self._read_settings()
            if settings != self.settings:
                self.settings = settings
                state = self.state
                # Where a drive has ended, only the next one makes a difference.
                if state.word not in ('READY', 'STOPPED', 'CRASHED'):
                    self._go(state.position_m, state.velocity_mps)
            self._tell()

    def _read_settings(self) -> Settings:
        def value(name: str) -> Any:
            return self.get_parameter(name).value

        return Settings(
            max_speed_mps=value('max_speed_rpm') / 60 * 2 * math.pi * value('simulation.wheel_radius_meters'),
            max_acceleration_mps2=value('max_acceleration_mps2'),
            safety_on=value('enable_safety_mode'),
            sensor_offset_m=value('sensor_offset_meters'),
            may_start=value('simulation.ambient_temperature_c') >= value('min_operating_temperature_c'),
            track_m=value('simulation.track_length_meters'))

    # -- driving ----------------------------------------------------------------------------------------

    def drive(self) -> None:
        """Put the robot back to the start, and let it go."""
        with self._lock:
            self._drive_start_sec = self._now_sec()
            self._driven.clear()
            self._announced = ''
            self._motion = Motion((), State('READY', 0.0))
            self._go(0.0, 0.0)
            self._tell()

    def step(self, seconds: float) -> State:
        """Let time pass at once, and give the state in which the robot is then.

        :param seconds: How much; ``math.inf`` for as much as it takes until the robot is at rest.
        """
        with self._lock:
            rest_sec = max(0.0, self._motion.duration_sec - self._elapsed_sec)
            self._stepped_sec += min(seconds, rest_sec) if math.isinf(seconds) else seconds
            self._look()
            return self.state

    @property
    def motion(self) -> tuple[Motion, float]:
        """What the robot is doing, and for how many seconds it has been."""
        with self._lock:
            return self._motion, self._elapsed_sec

    @property
    def state(self) -> State:
        """The robot now."""
        motion, elapsed_sec = self.motion
        return motion.at(elapsed_sec)

    def velocity_over_time(self) -> list[tuple[float, float]]:
        """Return the corners of the velocity's curve since the drive began, in s and m/s."""
        with self._lock:
            return [*self._driven, *self._corners()]

    def on_motion(self, listener: Callable[[], object]) -> Callable[[], None]:
        """Call a listener whenever the robot begins to do something else, or one of its parameters has changed.

        :param listener: Called without arguments, in whichever thread brought the change about; must not block.
        :return: Call it to stop listening.
        """
        self._listeners.append(listener)

        def unregister() -> None:
            if listener in self._listeners:
                self._listeners.remove(listener)
        return unregister

    def _now_sec(self) -> float:
        return self._stepped_sec + (time.monotonic() if self._real_time else 0.0)

    @property
    def _elapsed_sec(self) -> float:
        return self._now_sec() - self._motion_start_sec

    def _corners(self) -> list[tuple[float, float]]:
        start_sec = self._motion_start_sec - self._drive_start_sec
        return [(start_sec + at_sec, velocity) for at_sec, velocity in
                self._motion.velocity_over_time(self._elapsed_sec)]

    def _go(self, position_m: float, velocity_mps: float) -> None:
        """Begin a new motion here and now."""
        self._driven.extend(self._corners())
        self._motion_start_sec = self._now_sec()
        self._motion = plan(position_m, velocity_mps, self.settings)
        self._look()

    def _look(self) -> None:
        """See what the robot is doing now, tell it, and come back when that ends."""
        with self._lock:
            self.timer.cancel()
            state = self.state
            if state.word != self._announced:
                self._announced = state.word
                self._log(state)
                self._tell()
            if not self._real_time:
                return
            ends_sec, elapsed_sec = 0.0, self._elapsed_sec
            for phase in self._motion.phases:
                ends_sec += phase.duration_sec
                if elapsed_sec < ends_sec:
                    # A microsecond later, so that rounding cannot let it come too early and find nothing new.
                    self.timer.timer_period_ns = math.ceil((ends_sec - elapsed_sec) * 1e9) + 1000
                    self.timer.reset()
                    return

    def _log(self, state: State) -> None:
        name, say = self.get_parameter('robot_name').value, self.get_logger()
        gap_m = self.settings.track_m - state.position_m
        if state.word == 'SPEEDING UP':
            say.info(f'{name} speeds up with {state.acceleration_mps2:g} m/s²')
        elif state.word == 'EMERGENCY BRAKING':
            say.warning(f'{name} brakes as hard as it can')
        elif state.word == 'STOPPED':
            say.info(f'{name} has stopped {gap_m:.2f} m from the wall')
        elif state.word == 'CRASHED':
            say.error(f'{name} has run into the wall at {state.crash_speed_mps:.2f} m/s')
        elif state.word == 'WAITING':
            say.warning(f'{name} is waiting: {self.waiting_for()}')

    def waiting_for(self) -> str:
        """Return what keeps a waiting robot from driving."""
        if not self.settings.may_start:
            return (f'{self.get_parameter("simulation.ambient_temperature_c").value} °C is below '
                    f'min_operating_temperature_c = {self.get_parameter("min_operating_temperature_c").value}')
        return 'max_speed_rpm is 0'

    def _tell(self) -> None:
        for listener in list(self._listeners):
            listener()


def main(args: list[str] | None = None) -> None:
    """Spin a ClawbotNode, which drives off at once, until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        node = ClawbotNode()
        node.drive()
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
