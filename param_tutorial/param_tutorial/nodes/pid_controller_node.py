"""A PID controller that turns a simulated wheel, with the most important parameters of ros2_control's pid_controller.

Run it by itself with ``ros2 run param_tutorial pid_controller_node``, or under a controller's name and with its part
of a parameter file: ``--ros-args -r __node:=wheel_controller --params-file config/clawbot_controllers.yaml``.

``dof_names``, ``command_interface``, ``reference_and_state_interfaces`` and the names below ``gains.<joint>`` are
those of pid_controller in Jazzy, and the arithmetic is that of control_toolbox::Pid there
(https://control.ros.org/jazzy/doc/ros2_controllers/pid_controller/doc/userdoc.html). Unlike the real one, this node
has defaults that work without a file, ranges, and a rule for clamps that cross. The parameters below ``simulation``
replace what ros2_control gets from elsewhere: the reference from a topic, the joint from the hardware. SI units.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.exceptions import InvalidParameterValueException
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter

STRATEGIES = ('none', 'back_calculation', 'conditional_integration')
# The speed has settled when it stays this close to its final value, as a fraction of the reference.
SETTLING_BAND = 0.02
# A curve that enters the band only in this last part of the time may be passing through.
_TAIL = 0.1


@dataclass(frozen=True)
class Gains:
    """How a PID controller answers the error of one joint. ``gains.<joint>`` holds the same names."""

    p: float = 0.0
    """N m for each rad/s of error."""
    i: float = 0.0
    """N m for each rad/s of error that has lasted a second."""
    d: float = 0.0
    """N m for each rad/s by which the error grows in a second."""
    u_clamp_max: float = math.inf
    """The largest command, in N m."""
    u_clamp_min: float = -math.inf
    antiwindup_strategy: str = 'none'
    """One of STRATEGIES."""
    tracking_time_constant: float = 0.0
    """How fast back_calculation reduces the integral, in s; 0 for a value that suits the gains."""

    @property
    def tracking_sec(self) -> float:
        """The time constant in use, chosen as in control_toolbox; infinite if nothing is integrated."""
        if not self.i:
            return math.inf
        return self.tracking_time_constant or (math.sqrt(self.d / self.i) if self.d else self.p / self.i) or math.inf


@dataclass(frozen=True)
class Motor:
    """A wheel and its motor: ``inertia * acceleration = torque - friction * speed``."""

    inertia: float = 0.02
    """In kg m^2."""
    friction: float = 0.04
    """In N m s/rad."""
    lag_sec: float = 0.1
    """How far the torque lags behind the command: the time constant of a first-order lag."""
    max_torque: float = 2.0
    """The most it can do in either direction, in N m, whatever the command."""


@dataclass(frozen=True)
class Figures:
    """The usual figures of a step response. Speeds in rad/s."""

    final: float
    """The speed at the end."""
    steady_state_error: float
    """How much is missing from the reference at the end; negative if the wheel is too fast."""
    settling_sec: float | None
    """When it entered SETTLING_BAND for good; None if it has not settled, as are the next two then."""
    rise_sec: float | None
    """From a tenth of the final speed to nine tenths."""
    overshoot_percent: float | None
    """How far beyond its final speed it went."""

    def __str__(self) -> str:
        if self.settling_sec is None:
            return f'no steady speed, {self.final:.2f} rad/s at the end'
        # Adding 0 makes a plain zero of the -0.0 that rounding may leave.
        error = round(self.steady_state_error, 2) + 0
        return (f'rise time {self.rise_sec:.2f} s, overshoot {self.overshoot_percent:.1f} %, '
                f'settling time {self.settling_sec:.2f} s, steady-state error {error:.2f} rad/s')


@dataclass(frozen=True)
class StepResponse:
    """How a wheel at rest responds to a request for a speed."""

    reference: float
    """In rad/s."""
    period_sec: float
    speeds: tuple[float, ...]
    """In rad/s, one for each period, from the moment of the step."""
    torques: tuple[float, ...]
    """The command in the following period, in N m; one fewer than speeds."""

    @property
    def points(self) -> list[tuple[float, float]]:
        """The curve: time in s, and speed."""
        return [(index * self.period_sec, speed) for index, speed in enumerate(self.speeds)]

    @property
    def figures(self) -> Figures:
        """Rise time, overshoot and so on."""
        final = self.speeds[-1]
        error = self.reference - final
        band = SETTLING_BAND * self.reference
        outside = [index for index, speed in enumerate(self.speeds) if abs(speed - final) > band]
        entered = outside[-1] + 1 if outside else 0
        if entered >= (1 - _TAIL) * len(self.speeds) or final <= 0:
            return Figures(final, error, None, None, None)
        return Figures(final, error, entered * self.period_sec, self._passes(0.9 * final) - self._passes(0.1 * final),
                       100 * (max(self.speeds) / final - 1))

    def _passes(self, level: float) -> float:
        """Return when the curve, which is straight between its points, first reaches a level above 0."""
        index = next(index for index, speed in enumerate(self.speeds) if speed >= level)
        before, after = self.speeds[index - 1], self.speeds[index]
        return (index - (after - level) / (after - before)) * self.period_sec


def simulate(gains: Gains, motor: Motor, reference: float, *, rate_hz: int, duration_sec: float) -> StepResponse:
    """Return how a wheel at rest gets to a speed under the controller.

    The controller computes a command in each period, and the motor holds it until the next. Within a period the
    motion has a closed form, so the steps lose nothing: every machine gets the same numbers.

    :param reference: The speed, in rad/s, above 0.
    :param rate_hz: Periods in a second.
    """
    period = 1 / rate_hz
    # The torque's deviation from the command decays with the lag, the speed's with inertia / friction.
    kept_torque = math.exp(-period / motor.lag_sec) if motor.lag_sec else 0.0
    kept_speed = math.exp(-period * motor.friction / motor.inertia)
    # What a deviation of 1 N m adds to the speed meanwhile; the two time constants may be equal.
    apart = period * (motor.friction / motor.inertia - 1 / motor.lag_sec) if motor.lag_sec else -math.inf
    pushed = period / motor.inertia * kept_speed * (math.expm1(apart) / apart if apart else 1.0)

    tracking_sec = gains.tracking_sec
    speed = torque = integral = last_error = 0.0
    speeds, torques = [speed], []
    for _ in range(round(duration_sec * rate_hz)):
        error = reference - speed
        wanted = gains.p * error + integral + gains.d * (error - last_error) / period
        last_error = error
        command = min(max(wanted, gains.u_clamp_min), gains.u_clamp_max)
        # As in control_toolbox, the integral follows the command just given, not the next one.
        if gains.antiwindup_strategy == 'back_calculation':
            integral += period * (gains.i * error + (command - wanted) / tracking_sec)
        elif gains.antiwindup_strategy == 'none' or command == wanted or error * wanted <= 0:
            integral += period * gains.i * error
        command = min(max(command, -motor.max_torque), motor.max_torque)
        steady = command / motor.friction
        speed = steady + (speed - steady) * kept_speed + (torque - command) * pushed
        torque = command + (torque - command) * kept_torque
        speeds.append(speed)
        torques.append(command)
    return StepResponse(reference, period, tuple(speeds), tuple(torques))


def response_of(parameters: Mapping[str, Any], joint: str) -> StepResponse:
    """Return the step response of a joint of a node with these parameters.

    :param parameters: Names and values, as the node below declares them.
    :raises KeyError: a parameter is missing.
    """
    gains = Gains(**{name: parameters[f'gains.{joint}.{name}'] for name in Gains.__dataclass_fields__})
    motor = Motor(inertia=parameters['simulation.inertia_kgm2'], friction=parameters['simulation.friction_nms'],
                  lag_sec=parameters['simulation.lag_sec'], max_torque=parameters['simulation.max_torque_nm'])
    return simulate(gains, motor, parameters['simulation.reference_rad_per_sec'],
                    rate_hz=parameters['update_rate'], duration_sec=parameters['simulation.duration_sec'])


class PidControllerNode(Node):
    """A controller for one or more wheels. When its parameters change, the wheels start again from rest."""

    def __init__(self) -> None:
        """:raises InvalidParameterValueException: it starts with values that it would reject later."""
        super().__init__('pid_controller_node')
        # ros2_control declares these read-only too: a controller depends on them from its configuration on.
        self.declare_parameter('dof_names', ['wheel_joint'], _described('The joints it controls.', read_only=True))
        self.declare_parameter('command_interface', 'effort', _described(
            'What it commands to each joint.', read_only=True))
        self.declare_parameter('reference_and_state_interfaces', ['velocity'], _described(
            'What its reference is, and what it measures.', read_only=True))
        self.declare_parameter('update_rate', 100, ParameterDescriptor(
            description='How often it computes a command, in Hz.', read_only=True,
            integer_range=[IntegerRange(from_value=10, to_value=1000)]))
        self.joints = self._read_joints()
        for joint in self.joints:
            self._declare_gains(f'gains.{joint}')
        self._declare_simulation()

        # The callback does not see overrides: they are in place before it is registered.
        result = self.validate([])
        if not result.successful:
            raise InvalidParameterValueException('gains', 'gains', result.reason)
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.apply)
        self.get_logger().info('PidControllerNode has been started.')
        self.responses: dict[str, StepResponse] = {}
        self.apply([])

    def _read_joints(self) -> list[str]:
        # To rcl an empty list in a parameter file has no type, so it arrives as no value at all.
        joints = list(self.get_parameter_or('dof_names').value or [])
        if not joints or len(set(joints)) < len(joints):
            raise InvalidParameterValueException('dof_names', joints, 'it must name a joint, and none twice')
        return joints

    def _declare_gains(self, prefix: str) -> None:
        for name, value, top, text in (('p', 0.1, 2.0, 'Proportional gain, in N m s/rad.'),
                                       ('i', 0.0, 5.0, 'Integral gain, in N m/rad.'),
                                       ('d', 0.0, 0.1, 'Derivative gain, in N m s²/rad.')):
            self.declare_parameter(f'{prefix}.{name}', value, _described(text, 0.0, top))
        self.declare_parameter(f'{prefix}.u_clamp_max', math.inf, _described('Largest command, in N m.'))
        self.declare_parameter(f'{prefix}.u_clamp_min', -math.inf, _described('Smallest command, in N m.'))
        self.declare_parameter(f'{prefix}.antiwindup_strategy', 'none', _described(
            f'What keeps the integral from growing while the command is clamped: {", ".join(STRATEGIES)}.'))
        self.declare_parameter(f'{prefix}.tracking_time_constant', 0.0, _described(
            'How fast back_calculation reduces the integral, in s; 0 for a value that suits the gains.', 0.0, 10.0))

    def _declare_simulation(self) -> None:
        for name, value, bottom, top, text in (
                ('reference_rad_per_sec', 10.0, 0.1, 40.0, 'The requested speed, in rad/s.'),
                ('duration_sec', 3.0, 0.5, 10.0, 'How long it is watched, in s.'),
                ('inertia_kgm2', Motor.inertia, 0.005, 0.2, 'Moment of inertia of wheel and load, in kg m².'),
                ('friction_nms', Motor.friction, 0.005, 0.5, 'Friction, in N m s/rad.'),
                ('lag_sec', Motor.lag_sec, 0.0, 0.5, 'How far the torque lags behind the command, in s.'),
                ('max_torque_nm', Motor.max_torque, 0.1, 10.0, 'The most that the motor can do, in N m.')):
            self.declare_parameter(f'simulation.{name}', value, _described(text, bottom, top))

    def _values(self) -> dict[str, Any]:
        # rclpy 7.1.6 annotates this as values, and returns Parameter objects.
        parameters: dict[str, Any] = self.get_parameters_by_prefix('')
        return {name: parameter.value for name, parameter in parameters.items()}

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Accept or reject the proposed parameters as a whole; change nothing. The ranges do the rest."""
        values = self._values()
        values.update((parameter.name, parameter.value) for parameter in parameters)
        for joint in self.joints:
            prefix = f'gains.{joint}'
            low, high = values[f'{prefix}.u_clamp_min'], values[f'{prefix}.u_clamp_max']
            # Written this way, the rule rejects NaN too: every comparison with NaN is false.
            if not low < high:
                return SetParametersResult(successful=False, reason=(
                    f'{prefix}.u_clamp_min = {low} must be less than u_clamp_max = {high}'))
            strategy = values[f'{prefix}.antiwindup_strategy']
            if strategy not in STRATEGIES:
                return SetParametersResult(successful=False, reason=(
                    f'{prefix}.antiwindup_strategy must be one of {", ".join(STRATEGIES)}, not {strategy!r}'))
        return SetParametersResult(successful=True)

    def apply(self, _: list[Parameter]) -> None:
        """Use the stored parameters: start each wheel from rest, and log its figures."""
        values = self._values()
        for joint in self.joints:
            response = response_of(values, joint)
            if response != self.responses.get(joint):
                self.responses[joint] = response
                gains = ', '.join(f'{name} = {values[f"gains.{joint}.{name}"]:g}' for name in 'pid')
                self.get_logger().info(f'{joint} with {gains}: {response.figures}')

    def response(self, joint: str | None = None) -> StepResponse:
        """Return the step response of a joint under the gains that are in use.

        :param joint: By default the first one.
        """
        return self.responses[joint or self.joints[0]]


def _described(text: str, bottom: float | None = None, top: float | None = None, *,
               read_only: bool = False) -> ParameterDescriptor:
    limits = [] if bottom is None else [FloatingPointRange(from_value=bottom, to_value=top)]
    return ParameterDescriptor(description=text, read_only=read_only, floating_point_range=limits)


def main(args: list[str] | None = None) -> None:
    """Spin a PidControllerNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(PidControllerNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is already shutting the context down; a second shutdown would collide with it.
        pass


if __name__ == '__main__':
    main()
