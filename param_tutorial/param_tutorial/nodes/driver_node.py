"""A driver for the robot of base_node: it drives toward the wall, and brakes in front of it.

The driver and the base are two nodes. The base publishes the distance to the wall, and the driver answers with a speed,
again and again. Run it alone with ``ros2 run param_tutorial driver_node``.
"""

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range


class DriverNode(Node):
    """The driver; it stands still until it has heard of a distance."""

    def __init__(self) -> None:
        super().__init__('driver')
        self._declare('max_speed_mps', 0.5, 'How fast the robot drives, in m/s.', 0.0, 2.0)
        self._declare('stop_distance_m', 0.5, 'How far from the wall it starts to brake, in m.', 0.1, 5.0)
        # The timer is made once, so a later change could do nothing.
        self._declare('command_rate_hz', 10.0, 'How often it sends a command.', 2.0, 50.0, read_only=True)
        self.distance_m: float | None = None
        """How far the wall is, as the base has said last."""
        self.create_subscription(Range, 'distance', self.measure, 10)
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(1 / self._value('command_rate_hz'), self.drive)
        self.get_logger().info('DriverNode has been started.')

    def _declare(self, name: str, default: float, description: str, lowest: float, highest: float, *,
                 read_only: bool = False) -> None:
        self.declare_parameter(name, default, ParameterDescriptor(
            description=description, read_only=read_only,
            floating_point_range=[FloatingPointRange(from_value=lowest, to_value=highest)]))

    def _value(self, name: str) -> float:
        return float(self.get_parameter(name).value)

    def measure(self, measured: Range) -> None:
        """Remember how far the wall is."""
        self.distance_m = measured.range

    @property
    def speed_mps(self) -> float:
        """How fast the robot should drive now."""
        if self.distance_m is None or self.distance_m <= self._value('stop_distance_m'):
            return 0.0
        return self._value('max_speed_mps')

    def drive(self) -> None:
        """Send the command that the base is to obey."""
        command = Twist()
        command.linear.x = self.speed_mps
        self.publisher.publish(command)


def main(args: list[str] | None = None) -> None:
    """Spin a DriverNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(DriverNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
