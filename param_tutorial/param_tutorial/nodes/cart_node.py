"""A cart that carries boxes along an aisle of a warehouse: two numbers under one rule. The robot of chapter 11.

Run it alone with ``ros2 run param_tutorial cart_node``.
"""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.exceptions import InvalidParameterValueException
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter

AISLE_M = 12.0
"""How long the aisle is."""
SIGHT_M = 2.0
"""How far the cart's scanner sees: the way that it has for stopping when somebody steps into the aisle."""


class CartNode(Node):
    """The cart, and how long it takes from one end of the aisle to the other."""

    def __init__(self) -> None:
        super().__init__('cart_node')
        self.declare_parameter(
            'cart_id', 'CART-01', ParameterDescriptor(description='Painted on the side.', read_only=True))
        self.declare_parameter(
            'max_speed_mps', 1.0,
            ParameterDescriptor(description='Speed along the aisle in m/s.', floating_point_range=[
                FloatingPointRange(from_value=0.1, to_value=2.0)]))
        self.declare_parameter(
            'max_acceleration_mps2', 0.5,
            ParameterDescriptor(description='Acceleration in m/s², also for braking.', floating_point_range=[
                FloatingPointRange(from_value=0.1, to_value=2.0)]))
        # An on-set callback is not asked about start values of parameters that were declared before it.
        speed, acceleration = self.settings()
        if reason := self.objection(speed, acceleration):
            raise InvalidParameterValueException('max_speed_mps', speed, reason)
        self.react([])
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)
        self.get_logger().info('CartNode has been started.')

    def settings(self) -> tuple[float, float]:
        """Return the speed and the acceleration that are stored, in m/s and m/s²."""
        return self.get_parameter('max_speed_mps').value, self.get_parameter('max_acceleration_mps2').value

    @staticmethod
    def objection(speed: float, acceleration: float) -> str:
        """Return what is wrong with a speed and an acceleration, or nothing: the cart has to stop within its sight."""
        stopping_m = speed ** 2 / (2 * acceleration)
        # Decimal fractions are rarely exact, and a millionth of a millimeter hurts nobody.
        if stopping_m > SIGHT_M + 1e-9:
            return f'it needs {stopping_m:.2f} m to stop, and the scanner sees {SIGHT_M:g} m'
        return ''

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Return whether the proposed parameters may be stored, together with what is stored; change nothing."""
        proposed = {parameter.name: parameter.value for parameter in parameters}
        speed, acceleration = self.settings()
        reason = self.objection(
            proposed.get('max_speed_mps', speed), proposed.get('max_acceleration_mps2', acceleration))
        return SetParametersResult(successful=not reason, reason=reason)

    def react(self, _: list[Parameter]) -> None:
        """Work out, from what is stored, how long the cart takes for the aisle."""
        speed, acceleration = self.settings()
        self.trip_sec = AISLE_M / speed + speed / acceleration

    def velocity_over_time(self) -> list[tuple[float, float]]:
        """Return the corners of the velocity's curve along the aisle, in s and m/s."""
        speed, acceleration = self.settings()
        # Within the rule it reaches its speed on the first two meters, so the curve has a level part.
        return [(0.0, 0.0), (speed / acceleration, speed), (AISLE_M / speed, speed), (self.trip_sec, 0.0)]


def main(args: list[str] | None = None) -> None:
    """Spin a CartNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(CartNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
