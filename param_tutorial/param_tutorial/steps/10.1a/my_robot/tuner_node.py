import rclpy
from rcl_interfaces.msg import ParameterEvent
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import qos_profile_parameter_events


class Tuner(Node):
    def __init__(self):
        super().__init__('tuner')
        self.declare_parameter('limit_mps', 0.3)
        self.driver = AsyncParameterClient(self, 'driver')
        self.question = None
        # Subscribe first, then ask: a change in between is heard.
        self.create_subscription(
            ParameterEvent, '/parameter_events', self.on_event, qos_profile_parameter_events)
        self.create_timer(0.5, self.ask)

    def ask(self):
        if self.question:
            self.question.cancel()
        self.question = self.driver.get_parameters(['max_speed_mps'], callback=self.on_speed)

    def on_speed(self, future):
        if future.cancelled():
            self.get_logger().warning('no answer from the driver')
            return
        self.slow_down(future.result().values[0].double_value)

    def on_event(self, event):
        if event.node == '/driver':
            for parameter in [*event.new_parameters, *event.changed_parameters]:
                if parameter.name == 'max_speed_mps':
                    self.slow_down(parameter_value_to_python(parameter.value))

    def slow_down(self, speed_mps):
        limit_mps = self.get_parameter('limit_mps').value
        if speed_mps > limit_mps:
            self.driver.set_parameters([Parameter('max_speed_mps', value=limit_mps)], callback=self.on_result)

    def on_result(self, future):
        result = future.result().results[0]
        if not result.successful:
            self.get_logger().warning(f'the driver says: {result.reason}')


def main():
    try:
        rclpy.init()
        rclpy.spin(Tuner())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
