"""A node that asks another node for all its parameters once, and logs them.

Run it alone with ``ros2 run param_tutorial param_query_node`` beside a simple_param_node.
"""

import rclpy
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python
from rclpy.task import Future

TARGET = '/simple_param_node'
# How often to look for the target, and how long an answer may take.
PERIOD_SEC = 2.0


class ParamQueryNode(Node):
    """Asks TARGET for the names of its parameters, and then for their values."""

    def __init__(self) -> None:
        super().__init__('param_query_node')
        self.get_logger().info('ParamQueryNode has been started.')
        self.list_client = self.create_client(ListParameters, f'{TARGET}/list_parameters')
        self.get_client = self.create_client(GetParameters, f'{TARGET}/get_parameters')
        self.question: Future | None = None
        # Waiting for the target here would block the program that creates this node, forever if no target comes.
        self.timer = self.create_timer(PERIOD_SEC, self.ask)

    def ask(self) -> None:
        """Ask for the names; start again here if an answer takes longer than PERIOD_SEC seconds."""
        if not (self.list_client.service_is_ready() and self.get_client.service_is_ready()):
            self.get_logger().info(f'{TARGET} is not there yet, waiting...')
            return
        if self.question is not None:
            self.get_logger().warning(f'{TARGET} has not answered within {PERIOD_SEC:g} s, asking again')
            for client in (self.list_client, self.get_client):
                client.remove_pending_request(self.question)
        self.question = self.list_client.call_async(ListParameters.Request())
        self.question.add_done_callback(self.on_names)

    def on_names(self, future: Future) -> None:
        """Ask for the values of all the names."""
        names = list(future.result().result.names)
        self.get_logger().info(f'{TARGET} has {len(names)} parameters.')
        self.ask_values([names])

    def ask_values(self, groups: list[list[str]]) -> None:
        """Ask for the values of the first group of names, and for those of the others after it."""
        self.timer.reset()
        self.question = self.get_client.call_async(GetParameters.Request(names=groups[0]))
        self.question.add_done_callback(lambda future: self.report(groups, future))

    def report(self, groups: list[list[str]], future: Future) -> None:
        """Log names and values; the values carry no names, and come in the order of the request."""
        names, *others = groups
        values = future.result().values
        if not values and len(names) > 1:
            # One parameter that is not set empties the whole answer: ask for each separately.
            others = [[name] for name in names]
        elif not values:
            self.get_logger().info(f'  {names[0]} is not set')
        for name, value in zip(names, values):
            self.get_logger().info(f'  {name} = {parameter_value_to_python(value)!r}')
        if others:
            self.ask_values(others)
        else:
            self.timer.cancel()


def main(args: list[str] | None = None) -> None:
    """Spin a ParamQueryNode until Ctrl+C or a termination signal."""
    try:
        rclpy.init(args=args)
        rclpy.spin(ParamQueryNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        # rclpy's signal handler is shutting the context down; a second shutdown here would meet the first.
        pass


if __name__ == '__main__':
    main()
