import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Kettle(Node):
    def __init__(self):
        super().__init__('kettle')
        self.declare_parameter('target_c', 80.0, ParameterDescriptor(
            floating_point_range=[FloatingPointRange(from_value=20.0, to_value=100.0)]))
        self.declare_parameter('model', 'K-1', ParameterDescriptor(read_only=True))
        target_c = self.get_parameter('target_c').value
        self.get_logger().info(f'heating to {target_c} degrees')


def main():
    try:
        rclpy.init()
        rclpy.spin(Kettle())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
