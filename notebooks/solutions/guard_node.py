import rclpy
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter


class Guard(Node):
    def __init__(self):
        super().__init__('guard')
        self.declare_parameter('limit_rpm', 60)
        self.getter = self.create_client(GetParameters, '/rover/get_parameters')
        self.setter = self.create_client(SetParameters, '/rover/set_parameters')
        self.create_timer(0.5, self.ask)

    def ask(self):
        if self.getter.service_is_ready() and self.setter.service_is_ready():
            future = self.getter.call_async(GetParameters.Request(names=['max_speed_rpm']))
            future.add_done_callback(self.on_speed)

    def on_speed(self, future):
        limit_rpm = self.get_parameter('limit_rpm').value
        if future.result().values[0].integer_value > limit_rpm:
            parameter = Parameter('max_speed_rpm', value=limit_rpm)
            request = SetParameters.Request(parameters=[parameter.to_parameter_msg()])
            self.setter.call_async(request).add_done_callback(self.on_result)

    def on_result(self, future):
        result = future.result().results[0]
        if not result.successful:
            self.get_logger().info(f'the rover says: {result.reason}')


def main():
    try:
        rclpy.init()
        rclpy.spin(Guard())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
