"""A pytest plugin: ``-p tests.support.rcl_in_python`` has rclpy stand on its layer in Python."""

from param_tools.rcl_in_python.install import install

install(even_beside_the_real_one=True)
