import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Gripper(Node):
    def __init__(self):
        super().__init__('gripper')
        self.declare_parameter('force_n', 10.0, ParameterDescriptor(
            description='Force of the fingers, in N.'))
        self.declare_parameters('gains', [('kp', 1.0), ('kd', 0.2)])
        self.declare_parameter('base_frame', 'base', ParameterDescriptor(
            description='Frame in which the gripper moves.'))
        self.act([])
        self.add_post_set_parameters_callback(self.act)

    def act(self, parameters):
        self.force_n = self.get_parameter('force_n').value
        self.frame = self.get_parameter('base_frame').value


def main():
    try:
        rclpy.init()
        rclpy.spin(Gripper())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
