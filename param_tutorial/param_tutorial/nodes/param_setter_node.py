"""A node that changes another node's parameters through a service, every few seconds.

Run it alone with ``ros2 run param_tutorial param_setter_node`` beside a running simple_param_node.
"""

import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future

TARGET = '/simple_param_node'
PERIOD_SEC = 5.0


class ParamSetterNode(Node):
    """Sets four parameters of TARGET every PERIOD_SEC seconds; on every third round one value is invalid."""

    def __init__(self) -> None:
        super().__init__('param_setter_node')
        self.get_logger().info('ParamSetterNode has been started.')
        self.client = self.create_client(SetParameters, f'{TARGET}/set_parameters')
        self.iteration = 0
        self.timer = self.create_timer(PERIOD_SEC, self.set_parameters_periodically)

    def set_parameters_periodically(self) -> None:
        """Send the next request, unless there is nobody to answer it."""
        # Waiting for the target in the constructor would keep this process from spinning any node, and the target
        # may be one of them. The timer fires again anyway, so look and try again next time.
        if not self.client.service_is_ready():
            self.get_logger().info(f'{TARGET} is not there yet, waiting...')
            return
        self.iteration += 1
        self.get_logger().info(f'Setting parameters (iteration {self.iteration})...')
        parameters = self.proposal(self.iteration)
        request = SetParameters.Request(parameters=[p.to_parameter_msg() for p in parameters])
        future = self.client.call_async(request)
        future.add_done_callback(lambda future: self.report(parameters, future))

    @staticmethod
    def proposal(iteration: int) -> list[Parameter]:
        """Return the parameters to ask for in this iteration; every third acceleration is negative."""
        acceleration = -0.1 if iteration % 3 == 0 else 0.5 + 0.1 * (iteration % 10)
        return [
            Parameter('robot_name', value=f'Clawbot_V{iteration}'),
            Parameter('enable_safety_mode', value=iteration % 2 == 0),
            Parameter('max_speed_rpm', value=100 + 10 * iteration),
            Parameter('max_acceleration_mps2', value=round(acceleration, 3)),
        ]

    def report(self, parameters: list[Parameter], future: Future) -> None:
        """Log the result for each parameter; results come in the order of the request."""
        for parameter, result in zip(parameters, future.result().results):
            if result.successful:
                self.get_logger().info(f'  {parameter.name} = {parameter.value}: accepted')
            else:
                self.get_logger().error(f'  {parameter.name} = {parameter.value}: rejected: {result.reason}')


def main(args: list[str] | None = None) -> None:
    """Spin a ParamSetterNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(ParamSetterNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
