import math

import rclpy
from rcl_interfaces.msg import ParameterEvent
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
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
        self.base = AsyncParameterClient(self, 'base')
        self.create_timer(1.0, self.protect, callback_group=MutuallyExclusiveCallbackGroup())

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

    async def protect(self):
        """Let the driver be no faster than the base can brake."""
        base = await self.values_of(self.base, ['max_acceleration_mps2'])
        driver = await self.values_of(self.driver, ['max_speed_mps', 'stop_distance_m'])
        if not base or not driver:
            self.get_logger().warning('no answer from the base or the driver')
            return
        safe_mps = math.sqrt(2 * base['max_acceleration_mps2'] * driver['stop_distance_m'])
        if driver['max_speed_mps'] > safe_mps:
            self.driver.set_parameters([Parameter('max_speed_mps', value=safe_mps)], callback=self.on_result)

    async def values_of(self, client, names):
        """Return the values by their names; nothing if there is no answer in time, or an empty one."""
        question = client.get_parameters(names)
        deadline = self.create_timer(0.5, question.cancel)
        answer = await question
        self.destroy_timer(deadline)
        values = answer.values if answer else []
        return {name: parameter_value_to_python(value) for name, value in zip(names, values)}

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
