"""rclpy in Python: that it does what the real one does, that it says what it is, and that it needs no threads."""
