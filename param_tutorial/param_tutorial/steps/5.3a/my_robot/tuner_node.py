from rclpy.node import Node
from rclpy.parameter_client import AsyncParameterClient


class Tuner(Node):
    def __init__(self):
        super().__init__('tuner')
        self.driver = AsyncParameterClient(self, 'driver')
        self.create_timer(0.5, self.ask)

    def ask(self):
        self.driver.get_parameters(['max_speed_mps'], callback=self.on_speed)

    def on_speed(self, future):
        speed_mps = future.result().values[0].double_value
        self.get_logger().info(f'max_speed_mps is {speed_mps}')
