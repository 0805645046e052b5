"""The simulated base of a robot: it drives as a node tells it, on a straight track toward a wall.

A base is what a robot has below its driver: motors, wheels and a sensor. This one takes its speed from the topic
``cmd_vel`` and publishes how far the wall is on ``distance``, so a node that drives it would drive a real one. Run it
alone with ``ros2 run param_tutorial base_node``.

It counts time by the ticks of its timer, not by a clock, so the same commands always lead to the same place.
"""

import math

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range

ROBOT_LENGTH_M = 0.4
TICK_SEC = 0.05
"""How much time passes in a tick of the timer."""


class BaseNode(Node):
    """The base, on a track that begins at 0 m and ends at a wall."""

    def __init__(self) -> None:
        super().__init__('base')
        self._declare('wall_m', 10.0, 'Where the wall is, in m from the start.', 1.0, 50.0)
        self._declare('max_acceleration_mps2', 1.0, 'What the motor can do, in m/s².', 0.01, 10.0)
        self._declare('command_timeout_sec', 0.5, 'Without a command for so long, the base stops.', 0.05, 60.0)
        self.reset()
        self.create_subscription(Twist, 'cmd_vel', self.take_command, 10)
        self.publisher = self.create_publisher(Range, 'distance', 10)
        self.create_timer(TICK_SEC, self.tick)
        self.get_logger().info('BaseNode has been started.')

    def _declare(self, name: str, default: float, description: str, lowest: float, highest: float) -> None:
        self.declare_parameter(name, default, ParameterDescriptor(
            description=description, floating_point_range=[FloatingPointRange(from_value=lowest, to_value=highest)]))

    def _value(self, name: str) -> float:
        return float(self.get_parameter(name).value)

    def reset(self) -> None:
        """Put the robot back to the start, at rest and whole, without a command."""
        self.position_m = 0.0
        """Where the front of the robot is, in m from the start."""
        self.speed_mps = 0.0
        """Negative if it drives backward."""
        self.commanded_mps = 0.0
        """The speed that it has been told and is still to reach or to keep."""
        self.has_crashed = False
        """True from when it hit the wall until it is put back."""
        self.crash_speed_mps = 0.0
        """How fast it hit the wall, if it did."""
        self._silence_sec = 0.0

    @property
    def distance_m(self) -> float:
        """How far the wall is from the front of the robot."""
        return self._value('wall_m') - self.position_m

    def take_command(self, command: Twist) -> None:
        """Remember the speed that a message asks for; only one that is a finite number."""
        if math.isfinite(command.linear.x):
            self.commanded_mps = command.linear.x
            self._silence_sec = 0.0
        else:
            self.get_logger().warning(f'A speed of {command.linear.x} m/s is no command.', once=True)

    def step(self, duration_sec: float) -> None:
        """Let time pass at once, as so many ticks of the timer would."""
        for _ in range(round(duration_sec / TICK_SEC)):
            self.tick()

    def tick(self) -> None:
        """Move for one tick, and publish the distance."""
        self._silence_sec += TICK_SEC
        if self._silence_sec > self._value('command_timeout_sec'):
            self.commanded_mps = 0.0
        if not self.has_crashed:
            self._move()
        self.publisher.publish(self._measure())

    def _move(self) -> None:
        before_mps = self.speed_mps
        most = self._value('max_acceleration_mps2') * TICK_SEC
        self.speed_mps += min(max(self.commanded_mps - before_mps, -most), most)
        self.position_m += (before_mps + self.speed_mps) / 2 * TICK_SEC
        if self.position_m < 0.0:  # behind the start is a stop of rubber
            self.position_m = self.speed_mps = 0.0
        if self.distance_m <= 0.0:
            self.get_logger().warning(f'Crashed: hit the wall at {self.speed_mps:.2f} m/s.')
            self.has_crashed, self.crash_speed_mps = True, self.speed_mps
            self.position_m, self.speed_mps = self._value('wall_m'), 0.0

    def _measure(self) -> Range:
        measured = Range(radiation_type=Range.INFRARED, field_of_view=0.1, min_range=0.0, max_range=50.0)
        measured.header.stamp = self.get_clock().now().to_msg()
        measured.header.frame_id = 'range_sensor'
        measured.range = max(0.0, self.distance_m)
        return measured


def main(args: list[str] | None = None) -> None:
    """Spin a BaseNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(BaseNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
