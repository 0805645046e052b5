"""ROS in the background of a Python process: executor, parameter services, graph, domain, log. No Jupyter."""
