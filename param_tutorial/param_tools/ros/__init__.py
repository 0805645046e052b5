"""ROS in the background of a Python process: executor, parameter services, graph, domain, log. No Jupyter."""

from param_tools.ros import environment

# While rcl's library is loaded, it compares RMW_IMPLEMENTATION with what it was built for, and ends the process if they
# differ: this comes before any module of this room imports rclpy.
environment.drop_missing_middleware()
