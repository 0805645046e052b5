"""A robot with seven parameters: declared, described, validated, and acted upon when they change.

Run it alone with ``ros2 run param_tutorial simple_param_node``.
"""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter


class SimpleParamNode(Node):
    """The robot Clawbot, seen through its parameters."""

    def __init__(self) -> None:
        super().__init__('simple_param_node')
        self.get_logger().info('SimpleParamNode has been started.')

        self.declare_parameter(
            'robot_name', 'Clawbot',
            ParameterDescriptor(description='Name of the robot. Must not be empty.'))
        self.declare_parameter(
            'max_speed_rpm', 100,
            ParameterDescriptor(description='Maximum wheel speed in rpm. Must not be negative.'))
        self.declare_parameter(
            'enable_safety_mode', True,
            ParameterDescriptor(description='Stop in front of obstacles.'))
        self.declare_parameter(
            'sensor_offset_meters', 0.15,
            ParameterDescriptor(description='Distance of the sensor from the center of the robot in m.'))
        self.declare_parameter(
            'max_acceleration_mps2', 0.5,
            ParameterDescriptor(
                description='Maximum acceleration in m/s². Must be positive.',
                floating_point_range=[FloatingPointRange(from_value=0.01, to_value=2.0, step=0.0)]))
        self.declare_parameter(
            'min_operating_temperature_c', -5,
            ParameterDescriptor(
                description='Minimum operating temperature in degrees Celsius.',
                integer_range=[IntegerRange(from_value=-20, to_value=50, step=1)]))
        self.declare_parameter(
            'robot_serial_number', 'SN-CLAW-001',
            ParameterDescriptor(description='Serial number of the robot.', read_only=True))
        self.get_logger().info('Parameters declared successfully.')

        # rclpy calls an on-set callback for declarations too, so it is registered after them: a default
        # is ours and needs no check. A start-up override is therefore checked by its descriptor only.
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)
        self.log_parameters()

    def validate(self, parameters: list[Parameter]) -> SetParametersResult:
        """Return whether all the proposed parameters may be stored; change nothing."""
        for parameter in parameters:
            if parameter.name == 'max_speed_rpm' and parameter.value < 0:
                return SetParametersResult(
                    successful=False,
                    reason=f'max_speed_rpm must not be negative, got {parameter.value}')
            if parameter.name == 'robot_name' and not parameter.value.strip():
                return SetParametersResult(successful=False, reason='robot_name must not be empty')
        return SetParametersResult(successful=True)

    def react(self, parameters: list[Parameter]) -> None:
        """Act on parameters that have been stored."""
        for parameter in parameters:
            self.get_logger().info(f'{parameter.name} is now {parameter.value}')

    def log_parameters(self) -> None:
        """Log the value of every parameter that this node declared itself."""
        for name in ('robot_name', 'max_speed_rpm', 'enable_safety_mode', 'sensor_offset_meters',
                     'max_acceleration_mps2', 'min_operating_temperature_c', 'robot_serial_number'):
            self.get_logger().info(f'  {name}: {self.get_parameter(name).value}')


def main(args: list[str] | None = None) -> None:
    """Spin a SimpleParamNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(SimpleParamNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
