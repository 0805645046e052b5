import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Mixer(Node):
    def __init__(self):
        super().__init__('mixer')
        self.declare_parameter('serial_number', 'MX-0001', ParameterDescriptor(
            description='Stamped on the frame.', read_only=True))
        self.declare_parameter('drum.speed_rpm', 0.0, ParameterDescriptor(
            description='Speed of the drum in rpm; 0 stops it.',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=30.0)]))
        self.declare_parameter('drum.tilt_deg', 15.0, ParameterDescriptor(
            description='Angle between the axis of the drum and the ground, in degrees.',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=60.0)]))
        reason = self.objection({})
        if reason:
            raise ValueError(reason)
        self.add_on_set_parameters_callback(self.validate)
        self.add_post_set_parameters_callback(self.react)

    def objection(self, proposed):
        """Return the reason against the values that would be stored; empty if there is none."""
        speed_rpm = proposed.get('drum.speed_rpm', self.get_parameter('drum.speed_rpm').value)
        tilt_deg = proposed.get('drum.tilt_deg', self.get_parameter('drum.tilt_deg').value)
        return 'above 20 rpm the tilt is at most 30 degrees' if speed_rpm > 20.0 and tilt_deg > 30.0 else ''

    def validate(self, parameters):
        reason = self.objection({p.name: p.value for p in parameters})
        return SetParametersResult(successful=not reason, reason=reason)

    def react(self, parameters):
        for parameter in parameters:
            if parameter.name == 'drum.speed_rpm':
                self.get_logger().info(f'drum turns at {parameter.value} rpm')


def main():
    try:
        rclpy.init()
        rclpy.spin(Mixer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
