"""A pallet lift whose parameters follow the seven practices of chapter 8.

Run it alone with ``ros2 run param_tutorial pallet_lift_node``, or with the values of one of its two files:
``ros2 launch param_tutorial pallet_lift_launch.py robot:=physical``. Heights are in m above the floor.
"""

import math
from dataclasses import dataclass
from typing import Any

import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter

# Nobody should tune these, so they aren't parameters: a law of nature, and the motor that is built in.
GRAVITY_MPS2 = 9.81
MOTOR_POWER_W = 1000.0


@dataclass(frozen=True)
class LiftSettings:
    """What a ride depends on. The fields are the parameters of the groups ``lift`` and ``controller``."""

    speed_mps: float
    max_load_kg: float
    lowest_m: float
    highest_m: float
    kp: float
    tolerance_m: float

    def ride(self, start_m: float, target_m: float) -> list[tuple[float, float]]:
        """Return the height over time on the way to a target, in s and m.

        The platform moves at ``kp`` times the missing height, but never faster than ``speed_mps``. So its speed is
        constant at first and falls exponentially at the end. It stops within ``tolerance_m`` of the target.

        :param target_m: Clamped to lowest_m and highest_m.
        """
        target_m = min(max(target_m, self.lowest_m), self.highest_m)
        missing_m, sign = abs(target_m - start_m), math.copysign(1.0, target_m - start_m)
        corners = [(0.0, start_m)]
        if self.speed_mps == 0.0:
            return corners
        if missing_m > (slow_m := max(self.speed_mps / self.kp, self.tolerance_m)):
            corners.append(((missing_m - slow_m) / self.speed_mps, target_m - sign * slow_m))
            missing_m = slow_m
        if missing_m > self.tolerance_m:
            begin_sec, slow_sec = corners[-1][0], math.log(missing_m / self.tolerance_m) / self.kp
            for part in range(1, 13):
                elapsed_sec = slow_sec * part / 12
                corners.append((begin_sec + elapsed_sec,
                                target_m - sign * missing_m * math.exp(-self.kp * elapsed_sec)))
        return corners


def between(lowest: float, highest: float) -> list[FloatingPointRange]:
    """Return a new range, since no two declarations should share one."""
    return [FloatingPointRange(from_value=lowest, to_value=highest)]


class PalletLiftNode(Node):
    """A pallet lift: its platform carries a load from one height to another.

    :raises ValueError: the overrides do not fit together.
    """

    def __init__(self) -> None:
        super().__init__('pallet_lift_node')
        self.declare_parameter('serial_number', 'PL-0001', ParameterDescriptor(
            description='Stamped on the frame.', read_only=True))
        self.declare_parameters('lift', [
            ('speed_mps', 0.2, ParameterDescriptor(
                description='How fast the platform moves at most, in m/s.',
                additional_constraints='With max_load_kg it must not ask too much of the motor, 1000 W.',
                floating_point_range=between(0.0, 0.5))),
            ('max_load_kg', 300.0, ParameterDescriptor(
                description='What the platform may carry, in kg.',
                additional_constraints='The heavier, the slower: see speed_mps.',
                floating_point_range=between(0.0, 800.0))),
            ('lowest_m', 0.1, ParameterDescriptor(
                description='Where the platform stops at the bottom, in m above the floor.',
                additional_constraints='Below highest_m.', floating_point_range=between(0.0, 2.0))),
            ('highest_m', 1.6, ParameterDescriptor(
                description='Where the platform stops at the top, in m above the floor.',
                additional_constraints='Above lowest_m.', floating_point_range=between(0.0, 2.0))),
        ])
        self.declare_parameters('controller', [
            ('kp', 2.0, ParameterDescriptor(
                description='Speed in m/s for each m that is missing; less makes the end of a ride softer.',
                floating_point_range=between(0.2, 5.0))),
            ('tolerance_m', 0.01, ParameterDescriptor(
                description='How near to its target the platform stops, in m.',
                floating_point_range=between(0.001, 0.05))),
        ])
        # rclpy would call the callback for one declaration at a time, while the other values do not exist yet. So it is
        # registered after all of them, and judges all start values together, once.
        start = self.validate([])
        if not start.successful:
            raise ValueError(f'cannot start with these parameters: {start.reason}')
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)
        self.settings = self.read_settings()
        self.get_logger().info('PalletLiftNode has been started.')
        self.log_settings()

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Judge the proposed parameters together; change nothing. The ranges do the rest."""
        proposed = {parameter.name: parameter.value for parameter in parameters}

        def value(name: str) -> Any:
            return proposed[name] if name in proposed else self.get_parameter(name).value

        lowest_m, highest_m = value('lift.lowest_m'), value('lift.highest_m')
        if lowest_m >= highest_m:
            return SetParametersResult(successful=False, reason=f'the bottom, {lowest_m} m, is not below the top, '
                                                                f'{highest_m} m')
        load_kg, speed_mps = value('lift.max_load_kg'), value('lift.speed_mps')
        power_w = load_kg * GRAVITY_MPS2 * speed_mps
        if power_w > MOTOR_POWER_W:
            return SetParametersResult(successful=False, reason=f'{load_kg} kg at {speed_mps} m/s take '
                                                                f'{power_w:.0f} W, the motor has {MOTOR_POWER_W:.0f}')
        return SetParametersResult(successful=True)

    def react(self, _: list[Parameter]) -> None:
        """Act on parameters that have been stored."""
        settings = self.read_settings()
        if settings != self.settings:
            self.settings = settings
            self.log_settings()

    def read_settings(self) -> LiftSettings:
        """Read both groups as they are stored now."""
        # rclpy 7.1.6 annotates this as values, and returns Parameter objects.
        parameters: dict[str, Any] = {**self.get_parameters_by_prefix('lift'),
                                      **self.get_parameters_by_prefix('controller')}
        return LiftSettings(**{name: parameter.value for name, parameter in parameters.items()})

    def log_settings(self) -> None:
        """Log what the lift works with."""
        serial_number = self.get_parameter('serial_number').value
        self.get_logger().info(f'{serial_number} lifts up to {self.settings.max_load_kg:g} kg '
                               f'at {self.settings.speed_mps:g} m/s, from {self.settings.lowest_m:g} '
                               f'to {self.settings.highest_m:g} m')


def main(args: list[str] | None = None) -> None:
    """Spin a PalletLiftNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(PalletLiftNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
