import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('max_speed_mps', 0.5, ParameterDescriptor(
            description='Speed at which the robot drives, in m/s.',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]))
        self.commands = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(0.1, self.drive)

    def drive(self):
        command = Twist()
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
