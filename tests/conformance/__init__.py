"""What rclpy does, in plain rclpy: asserted on its layer in C, and by tests/rcl_in_python on the one in Python."""
