from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('max_speed_mps', 0.5)
