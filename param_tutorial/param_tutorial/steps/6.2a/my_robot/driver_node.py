import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range

RULE = 'max_speed_mps ** 2 / 2 / braking_mps2 <= stop_distance_m'


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
        start = self.judge(self.get_parameters(['max_speed_mps', 'stop_distance_m', 'braking_mps2']))
        if not start.successful:
            raise ValueError(start.reason)
        self.add_on_set_parameters_callback(self.judge)
        self.add_post_set_parameters_callback(self.act)
        self.distance_m = None
        self.create_subscription(Range, 'distance', self.listen, 10)
        self.commands = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(1 / self.get_parameter('rate_hz').value, self.drive)

    def listen(self, measured):
        self.distance_m = measured.range

    def judge(self, parameters):
        """The robot can brake within the stop distance."""
        new = {parameter.name: parameter.value for parameter in parameters}
        speed_mps = new.get('max_speed_mps', self.get_parameter('max_speed_mps').value)
        stop_m = new.get('stop_distance_m', self.get_parameter('stop_distance_m').value)
        braking_mps2 = new.get('braking_mps2', self.get_parameter('braking_mps2').value)
        braking_m = speed_mps ** 2 / 2 / braking_mps2
        if braking_m > stop_m:
            return SetParametersResult(
                successful=False, reason=f'{speed_mps} m/s takes {braking_m:.2f} m to brake, not {stop_m} m')
        return SetParametersResult(successful=True)

    def act(self, parameters):
        for parameter in parameters:
            if parameter.name == 'max_speed_mps':
                self.get_logger().info(f'max_speed_mps is now {parameter.value}')

    def drive(self):
        command = Twist()
        stop_distance_m = self.get_parameter('stop_distance_m').value
        if self.distance_m is not None and self.distance_m > stop_distance_m:
            command.linear.x = self.get_parameter('max_speed_mps').value
        self.commands.publish(command)


def main():
    try:
        rclpy.init()
        rclpy.spin(Driver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
