from dataclasses import dataclass

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range

RULE = 'max_speed_mps ** 2 / 2 / braking_mps2 <= stop_distance_m'


@dataclass(frozen=True)
class Limits:
    """What the robot drives by: values that were accepted together, and never change."""

    max_speed_mps: float
    stop_distance_m: float
    braking_mps2: float

    @property
    def braking_m(self):
        """The distance that it takes to brake."""
        return self.max_speed_mps ** 2 / 2 / self.braking_mps2


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('max_speed_mps', 0.5, ParameterDescriptor(
            description='Speed at which the robot drives, in m/s.', additional_constraints=RULE,
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))
        self.declare_parameter('stop_distance_m', 0.5, ParameterDescriptor(
            description='Distance to the wall at which the robot stops, in m.', additional_constraints=RULE,
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=5.0)]))
        self.declare_parameter('braking_mps2', 1.0, ParameterDescriptor(
            description='What the brakes can do at least, in m/s².', additional_constraints=RULE,
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=3.0, step=0.1)]))
        self.declare_parameter('rate_hz', 10, ParameterDescriptor(
            description='How often the driver sends a command, in Hz.', read_only=True,
            integer_range=[IntegerRange(from_value=5, to_value=50)]))
        start = self.judge([])
        if not start.successful:
            raise ValueError(start.reason)
        self.limits = self.limits_with([])
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.act)
        self.distance_m = None
        self.create_subscription(Range, 'distance', self.listen, 10)
        self.commands = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(1 / self.get_parameter('rate_hz').value, self.drive)

    def listen(self, measured):
        self.distance_m = measured.range

    def limits_with(self, parameters):
        """Return the limits with these parameters in place of those that are stored."""
        names = ['max_speed_mps', 'stop_distance_m', 'braking_mps2']
        values = {name: self.get_parameter(name).value for name in names}
        values.update((parameter.name, parameter.value) for parameter in parameters if parameter.name in names)
        return Limits(**values)

    def judge(self, parameters):
        """The robot can brake within the stop distance."""
        new = self.limits_with(parameters)
        if new.braking_m > new.stop_distance_m:
            return SetParametersResult(successful=False, reason=(
                f'{new.max_speed_mps} m/s takes {new.braking_m:.2f} m to brake, not {new.stop_distance_m} m'))
        return SetParametersResult(successful=True)

    def act(self, parameters):
        self.limits = self.limits_with([])
        for parameter in parameters:
            if parameter.name == 'max_speed_mps':
                self.get_logger().info(f'max_speed_mps is now {parameter.value}')

    def drive(self):
        command, limits = Twist(), self.limits
        if self.distance_m is not None and self.distance_m > limits.stop_distance_m:
            command.linear.x = limits.max_speed_mps
        self.commands.publish(command)


def main():
    try:
        rclpy.init()
        rclpy.spin(Driver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
