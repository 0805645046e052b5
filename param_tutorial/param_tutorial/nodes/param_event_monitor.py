"""A node that logs the parameter changes of all nodes: a listener on /parameter_events.

Run it by itself with ``ros2 run param_tutorial param_event_monitor`` beside any other nodes.
"""

import rclpy
from rcl_interfaces.msg import Parameter, ParameterEvent
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python
from rclpy.qos import qos_profile_parameter_events


class ParamEventMonitor(Node):
    """Logs each parameter that a node has declared, set or deleted since the monitor was started."""

    def __init__(self) -> None:
        super().__init__('param_event_monitor')
        # The profile with which nodes publish their events.
        self.create_subscription(ParameterEvent, '/parameter_events', self.report, qos_profile_parameter_events)
        self.get_logger().info('ParamEventMonitor has been started.')

    def report(self, event: ParameterEvent) -> None:
        """Log a line for each parameter in an event."""
        for parameter in event.new_parameters:
            self.get_logger().info(f'{event.node}: new {self.format_parameter(parameter)}')
        for parameter in event.changed_parameters:
            self.get_logger().info(f'{event.node}: changed {self.format_parameter(parameter)}')
        for parameter in event.deleted_parameters:
            self.get_logger().info(f'{event.node}: deleted {parameter.name}')

    @staticmethod
    def format_parameter(parameter: Parameter) -> str:
        """Return the name and the value of a parameter message as a string."""
        return f'{parameter.name} = {parameter_value_to_python(parameter.value)!r}'


def main(args: list[str] | None = None) -> None:
    """Spin a ParamEventMonitor until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(ParamEventMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is already shutting the context down; a second shutdown would collide with it.
        pass


if __name__ == '__main__':
    main()
