import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Elevator(Node):
    def __init__(self):
        super().__init__('elevator')
        self.declare_parameter('floor', 0)
        self.declare_parameter('top_floor', 5)
        reason = self.objection({})
        if reason:
            raise ValueError(reason)
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)

    def objection(self, proposed):
        """Return the reason against the values that would be stored; empty if there is none."""
        floor = proposed.get('floor', self.get_parameter('floor').value)
        top_floor = proposed.get('top_floor', self.get_parameter('top_floor').value)
        return '' if 0 <= floor <= top_floor else f'there is no floor {floor}: the top floor is {top_floor}'

    def validate(self, parameters):
        reason = self.objection({p.name: p.value for p in parameters})
        return SetParametersResult(successful=not reason, reason=reason)

    def react(self, parameters):
        for parameter in parameters:
            if parameter.name == 'floor':
                self.get_logger().info(f'going to floor {parameter.value}')


def main():
    try:
        rclpy.init()
        rclpy.spin(Elevator())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
